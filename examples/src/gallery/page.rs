//! `index.html`: the pictures with their programs.

use super::entry::{Entry, Explained};
use crate::lectures::{Item, PAGE, lectures};

const HEAD: &str = r#"<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>DetGL: the lecture gallery</title>
<style>
:root { color-scheme: light dark; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 100rem; margin: 2rem auto; padding: 0 1rem; }
nav { columns: 14rem; }
nav a { display: block; }
section { margin: 3rem 0; }
.beside { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(30rem, 100%), 1fr)); gap: 1rem; }
.beside pre { max-height: 36rem; overflow: auto; margin: 0; }
img { display: block; max-width: 100%; height: auto; border-radius: 6px; image-rendering: pixelated; }
.panels { margin: .5rem 0; padding-left: 1.5rem; color: gray; }
.code { position: relative; }
.code button { position: absolute; top: .5rem; right: .5rem; }
.turn { float: right; }
h2 { margin-bottom: 0; }
.about { color: gray; margin-top: 0; }
pre { overflow-x: auto; padding: 1rem; font-size: 13px; line-height: 1.4;
      background: color-mix(in srgb, currentColor 7%, transparent); border-radius: 6px; }
summary { cursor: pointer; margin: .5rem 0; }
</style>
<h1>DetGL: the lecture gallery</h1>
"#;

/// Copies the program beside a button.
const COPY: &str = r#"<script>
document.addEventListener("click", event => {
    if (!event.target.matches(".code button")) return;
    navigator.clipboard.writeText(event.target.nextElementSibling.textContent)
        .then(() => { event.target.textContent = "copied"; });
});
</script>
"#;

/// The page; pictures are in the same folder.
pub fn page(entries: &[Entry]) -> String {
    let mut page = String::from(HEAD);
    page.push_str("<nav>\n");
    for Entry { program, .. } in entries {
        let (name, title) = (program.name, program.name.replace('_', " "));
        page.push_str(&format!("<a href=\"#{name}\">{title}</a>\n"));
    }
    page.push_str("</nav>\n");
    by_lecture(&mut page, entries);
    for (at, entry) in entries.iter().enumerate() {
        let neighbour = |at: Option<usize>| at.and_then(|at| entries.get(at));
        let neighbours = [neighbour(at.checked_sub(1)), neighbour(Some(at + 1))];
        section(&mut page, entry, neighbours);
    }
    page.push_str(COPY);
    page.push_str("</html>\n");
    page
}

/// The second index: what the lectures contain, in their order, with links to the pictures that were drawn.
fn by_lecture(page: &mut String, entries: &[Entry]) {
    page.push_str("<h2>By lecture</h2>\n");
    for lecture in lectures(PAGE) {
        let (letter, title) = (lecture.letter, escape(&lecture.title));
        page.push_str(&format!(
            "<details><summary>{letter}: {title} ({} items)</summary>\n<ol>\n",
            lecture.items.len()
        ));
        lecture.items.iter().for_each(|item| entry_of_index(page, item, entries));
        page.push_str("</ol>\n</details>\n");
    }
}

fn entry_of_index(page: &mut String, item: &Item, entries: &[Entry]) {
    let (place, says) = (escape(&item.place), escape(&item.says));
    page.push_str(&format!("<li>{place}: {says}"));
    for shown in &item.pictures {
        let (name, panels) = (&shown.program, escape(&shown.panels.join(", ")));
        let title = name.replace('_', " ");
        if entries.iter().any(|entry| entry.program.name == name) {
            page.push_str(&format!(" · <a href=\"#{name}\">{title}</a> {panels}"));
        }
    }
    let checks = item.checks.iter().map(|check| format!(" · check {}", escape(check)));
    page.extend(checks);
    page.push_str("</li>\n");
}

/// What a program's source says that its picture shows: the comment at its head.
fn about(source: &str) -> String {
    let lines = source.lines().map_while(|line| line.strip_prefix("//!"));
    escape(lines.map(str::trim).collect::<Vec<_>>().join(" ").trim()).replace('`', "")
}

/// The captions of a picture's panels, in their order.
fn panels(captions: &[&str]) -> String {
    if captions.is_empty() {
        return String::new();
    }
    let items: String = captions.iter().map(|text| format!("<li>{}</li>", escape(text))).collect();
    format!("<ol class=\"panels\">{items}</ol>\n")
}

/// A link to another section.
fn turn(to: Option<&Entry>, word: &str) -> String {
    to.map_or_else(String::new, |entry| {
        format!("<a href=\"#{0}\" title=\"{0}\">{word}</a> ", entry.program.name)
    })
}

fn section(
    page: &mut String,
    Entry { program, rendered, plans, explained }: &Entry,
    [before, after]: [Option<&Entry>; 2],
) {
    let (name, lecture) = (program.name, escape(program.lecture));
    let (width, height) = (rendered.picture.width, rendered.picture.height);
    let (time, checksum) = (rendered.time.as_millis(), rendered.picture.checksum());
    let title = name.replace('_', " ");
    let (source, about) = (escape(program.source), about(program.source));
    let panels = panels(program.panels);
    let (previous, next) = (turn(before, "← previous"), turn(after, "next →"));
    // Of a square window.
    let size = 2 * width / program.halves[0];
    let messages = [rendered.notes.clone(), rendered.errors.join("\n")].concat();
    page.push_str(&format!(
        r##"<section id="{name}">
<p class="turn">{previous}{next}<a href="#">top</a></p>
<h2>{title}</h2>
<p>{about}</p>
<p class="about">{lecture} · {width}×{height} · {time} ms of GL · {checksum:016x}</p>
<div class="beside">
<figure style="margin:0"><a href="{name}.png"><img src="{name}.png" width="{width}" height="{height}" alt="{title}"></a>
{panels}</figure>
<div class="code"><button>copy</button><pre>{source}</pre></div>
</div>
<p class="about">Why a pixel has its colour:
<code>cargo run --release -- --only {name} --size {size} --explain X,Y</code></p>
"##,
    ));
    if !messages.is_empty() {
        details(page, "What it says", " open", &messages);
    }
    if let Some(Explained { size, pixel: [x, y], text }) = explained {
        let summary =
            format!("One pixel explained: column {x}, row {y} of the picture with --size {size}");
        details(page, &summary, "", text);
    }
    if !plans.is_empty() {
        details(page, "What the draws ran, and what they left out", "", &plans.join("\n"));
    }
    page.push_str("</section>\n");
}

/// A `details` element.
fn details(page: &mut String, summary: &str, state: &str, text: &str) {
    let text = escape(text);
    page.push_str(&format!(
        "<details{state}><summary>{summary}</summary><pre>{text}</pre></details>\n"
    ));
}

/// Text with HTML's special characters escaped.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn source_text_cannot_end_its_element() {
        assert_eq!(about("//! A `cube`\n//! of < 3.\n\nuse x;"), "A cube of &lt; 3.");
        assert_eq!(panels(&["near", "far"]).matches("<li>").count(), 2);
        assert_eq!(escape("if a<b && c>\"d\""), "if a&lt;b &amp;&amp; c&gt;&quot;d&quot;");
    }
}
