//! `index.html`: the pictures with their programs.

use super::entry::Entry;
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
img { display: block; max-width: 100%; height: auto; border-radius: 6px; }
h2 { margin-bottom: 0; }
.about { color: gray; margin-top: 0; }
pre { overflow-x: auto; padding: 1rem; font-size: 13px; line-height: 1.4;
      background: color-mix(in srgb, currentColor 7%, transparent); border-radius: 6px; }
summary { cursor: pointer; margin: .5rem 0; }
</style>
<h1>DetGL: the lecture gallery</h1>
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
    entries.iter().for_each(|entry| section(&mut page, entry));
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

fn section(page: &mut String, Entry { program, rendered, plans }: &Entry) {
    let (name, lecture) = (program.name, escape(program.lecture));
    let (width, height) = (rendered.picture.width, rendered.picture.height);
    let (time, checksum) = (rendered.time.as_millis(), rendered.picture.checksum());
    let title = name.replace('_', " ");
    let source = escape(program.source);
    // Of a square window.
    let size = 2 * width / program.halves[0];
    let messages = [rendered.notes.clone(), rendered.errors.join("\n")].concat();
    page.push_str(&format!(
        r#"<section id="{name}">
<h2>{title}</h2>
<p class="about">{lecture} · {width}×{height} · {time} ms of GL · {checksum:016x}</p>
<div class="beside">
<img src="{name}.png" width="{width}" height="{height}" alt="{title}">
<pre>{source}</pre>
</div>
<p class="about">Why a pixel has its colour:
<code>cargo run --release -- --only {name} --size {size} --explain X,Y</code></p>
"#,
    ));
    if !messages.is_empty() {
        details(page, "What it says", " open", &messages);
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
        assert_eq!(escape("if a<b && c>\"d\""), "if a&lt;b &amp;&amp; c&gt;&quot;d&quot;");
    }
}
