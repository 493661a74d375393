//! The HTML pages: formulas, error and run time, extremes.

use super::case_pictures;
use super::layout::short;
use super::page::{PageError, PageName, create, escaped, page, write, write_picture};
use super::tables::{kept, quantity};
use crate::chapters::CHAPTERS;
use crate::check::{Outcome, Reach, Verdict};
use crate::plot::{Caption, Line, log_log};
use crate::self_test::Trial;
use crate::sweep::{Series, SweepOutcome};
use crate::tradeoff::choices::ChoiceOutcome;
use crate::tradeoff::functions::FunctionRow;
use crate::tradeoff::{Measured, Picture, Row, lines, overall, scene_advice};
use std::fmt::Write;
use std::path::Path;

/// Writes `index.html`: a table a chapter, each row with its tolerance's reason and worst case, and
/// pictures of driver, formula and difference side by side.
///
/// # Errors
/// When a file cannot be written.
pub fn checks_page(
    folder: &Path,
    name: &PageName,
    outcomes: &[Outcome],
    comparisons: &[[Picture; 3]],
) -> Result<(), PageError> {
    let mut body = String::from(
        "<p>Each formula stands a second time in <code>f64</code>, written from the specification; \
         the driver is held against it through GL alone. The small pictures show, one case a pixel, \
         the comparison that holds a check's worst case: what the driver gave, what the formula \
         gives, and the error, in which black is none and white is the tolerance.</p>",
    );
    create(folder)?;
    for (title, checks) in CHAPTERS {
        let of: Vec<&Outcome> = outcomes
            .iter()
            .filter(|outcome| checks.iter().any(|check| check.name == outcome.name))
            .collect();
        if of.is_empty() {
            continue;
        }
        let _ = write!(
            body,
            "<h2>{}</h2><table><tr><th>check<th>what<th>cases<th>largest error<th>tolerance<th><th>time",
            escaped(title)
        );
        for outcome in of {
            let pictures = case_pictures::pictures(outcome);
            for picture in &pictures {
                write_picture(folder, picture)?;
            }
            body.push_str(&check_row(outcome, &pictures));
        }
        body.push_str("</table>");
    }
    if !comparisons.is_empty() {
        body.push_str("<h2>Pictures</h2><p>Driver, formula, and 64 times their difference.</p>");
    }
    for row in comparisons {
        body.push_str("<div>");
        for picture in row {
            write_picture(folder, picture)?;
            body.push_str(&figure(&picture.name));
        }
        body.push_str("</div>");
    }
    name.write(folder, &page("DetGL against the formulas", &body))
}

fn check_row(outcome: &Outcome, pictures: &[Picture]) -> String {
    let (class, word) = match outcome.verdict {
        Verdict::Pass => ("pass", "pass"),
        Verdict::Fail => ("fail", "FAIL"),
        Verdict::Broken(_) => ("fail", "BROKEN"),
    };
    let worst = match &outcome.verdict {
        Verdict::Broken(reason) => reason,
        Verdict::Pass | Verdict::Fail => &outcome.worst,
    };
    let of_reached = outcome.reached.iter().map(|Reach { what, cases, least }| {
        format!("<br><small>{}: {cases}, at least {least}</small>", escaped(what))
    });
    let reached: String = of_reached.collect();
    let reached = if reached.is_empty() {
        reached
    } else {
        format!("<details><summary><small>what cases reach</small></summary>{reached}</details>")
    };
    let thumbs: String = pictures.iter().map(|picture| thumb(&picture.name)).collect();
    format!(
        "<tr><td><b>{}</b><br><small>{}</small><td>{}<br><small>tolerance: {}</small><div>{thumbs}</div>\
         <details><summary><small>worst case</small></summary><small>{}</small></details>{reached}\
         <td class=n>{}<td class=n>{}<td class=n>{}<td class={class}>{word}<td class=n>{:.2} s",
        escaped(outcome.name),
        escaped(outcome.citation),
        escaped(outcome.what),
        escaped(outcome.why),
        escaped(worst),
        outcome.cases,
        quantity(outcome.largest_error, outcome),
        quantity(outcome.tolerance, outcome),
        outcome.seconds
    )
}

/// A picture in a row of a table, with its caption.
fn thumb(name: &str) -> String {
    let name = escaped(name);
    let of = name.rsplit('-').next().unwrap_or_default();
    format!(
        "<figure class=thumb><img src=\"{name}.png\" alt=\"{name}\"><figcaption>{of}</figcaption></figure>"
    )
}

fn figure(name: &str) -> String {
    let name = escaped(name);
    format!("<figure><img src=\"{name}.png\" alt=\"\"><figcaption>{name}</figcaption></figure>")
}

/// The work-precision plot of some rows.
///
/// # Errors
/// When it cannot be drawn.
fn work_precision(title: &str, rows: &[Row]) -> Result<String, PageError> {
    let caption = Caption { title, x: "nanoseconds a pixel", y: "RMS error" };
    Ok(log_log(caption, &lines(rows), None)?)
}

/// Writes `error-vs-time.html`, its plots and pictures.
///
/// # Errors
/// When a file cannot be written or a plot cannot be drawn.
pub fn tradeoff_page(
    folder: &Path,
    name: &PageName,
    measured: &Measured,
    choices: &[ChoiceOutcome],
    functions: &[FunctionRow],
) -> Result<(), PageError> {
    create(folder)?;
    let mut body = String::from(
        "<p>Each table's pictures are drawn in turns, 9 rounds, one thread; times are the processor's, the median of the \
         rounds and their quartiles. A star marks what no other row beats: better in error (by 2 %) or in cost (beyond the \
         quartiles), and as good in the other. The advice follows from the table: of these, up to 10 times the cheapest, the \
         least product of squared error and cost. That product is what supersampling leaves as it is, n² times the cost for \
         1/n of the error; errors below a step of a byte count as one.</p>",
    );
    if !measured.rows.is_empty() {
        let all = overall(&measured.rows);
        let plot = work_precision("Error against run time, all scenes", &all)?;
        write(folder, &name.with_ending(".svg"), &plot)?;
        let _ = write!(
            body,
            "<h2>Filters, all scenes</h2><p>Against the exact area integral of the bilinearly reconstructed texture. Bytes \
             alone cost an RMS error of 0.0011. Of supersampling, the time is that of all samples.</p>{plot}{}{}",
            rows_table(&all),
            sentence(&scene_advice(&all)),
        );
    }
    for choice in choices {
        body.push_str(&choice_section(folder, choice)?);
    }
    for rows in measured.rows.chunk_by(|a, b| a.scene == b.scene) {
        let scene = rows[0].scene;
        let _ = write!(
            body,
            "<h2>Filters, {}</h2>{}{}{}",
            escaped(scene),
            work_precision(scene, rows)?,
            rows_table(rows),
            sentence(&scene_advice(rows)),
        );
        let of = measured.pictures.iter().filter(|p| p.name.starts_with(&format!("{scene}-")));
        body.push_str(&strip(folder, of)?);
    }
    body.push_str("<h2>Built-in functions</h2>");
    let points = functions.iter().filter(|row| row.ulp > 0.0 && row.nanoseconds > 0.0).map(|row| {
        Line { name: row.function.to_owned(), points: vec![(row.nanoseconds, row.ulp)] }
    });
    let caption =
        Caption { title: "Built-in functions", x: "nanoseconds a call", y: "largest error, ULP" };
    let dots: Vec<Line> = points.take(24).collect();
    let _ = write!(body, "{}", log_log(caption, &dots, None)?);
    body.push_str("<table><tr><th>function<th>largest error, ULP<th>ns a call");
    for row in functions {
        let _ = write!(
            body,
            "<tr><td>{}<td class=n>{:.3}<td class=n>{:.2}",
            escaped(row.function),
            row.ulp,
            row.nanoseconds
        );
    }
    body.push_str("</table>");
    name.write(folder, &page("Error against run time", &body))
}

/// A sentence of advice.
fn sentence(advice: &str) -> String {
    let mut letters = escaped(advice).chars().collect::<Vec<_>>();
    if let Some(first) = letters.first_mut() {
        first.make_ascii_uppercase();
    }
    format!("<p><b>{}.</b></p>", letters.into_iter().collect::<String>())
}

/// Pictures beside each other, to be opened.
fn strip<'a>(
    folder: &Path,
    pictures: impl Iterator<Item = &'a Picture>,
) -> Result<String, PageError> {
    let mut text = String::from("<details><summary>pictures, and 4 times the difference</summary>");
    for picture in pictures {
        write_picture(folder, picture)?;
        text.push_str(&figure(&picture.name));
    }
    text.push_str("</details>");
    Ok(text)
}

/// The plot, table, advice and pictures of a choice.
fn choice_section(folder: &Path, choice: &ChoiceOutcome) -> Result<String, PageError> {
    let has_bytes = choice.rows.iter().any(|row| row.bytes.is_some());
    let points = choice.rows.iter().map(|row| Line {
        name: row.alternative.clone(),
        points: vec![(row.bytes.unwrap_or(row.quartiles[1]), row.rms)],
    });
    let x = if has_bytes { "bytes a texel" } else { "nanoseconds a pixel" };
    let plot = log_log(
        Caption { title: choice.choice, x, y: "RMS error" },
        &points.collect::<Vec<_>>(),
        None,
    )?;
    let mut text = format!(
        "<h2>{}</h2><p>{}.</p>{plot}<table><tr><th>alternative<th><th>RMS<th>max<th>median, ns a pixel<th>quartiles{}",
        escaped(choice.choice),
        escaped(choice.what),
        if has_bytes { "<th>bytes a texel" } else { "" },
    );
    for row in &choice.rows {
        let [low, median, high] = row.quartiles;
        let _ = write!(
            text,
            "<tr><td>{}<td>{}<td class=n>{:.4}<td class=n>{:.3}<td class=n>{median:.1}<td class=n>{low:.1}–{high:.1}",
            escaped(&row.alternative),
            star(row.is_on_front),
            row.rms,
            row.max,
        );
        if let Some(bytes) = row.bytes {
            let _ = write!(text, "<td class=n>{bytes}");
        }
    }
    let _ = write!(text, "</table>{}", sentence(&choice.advice));
    text.push_str(&strip(folder, choice.pictures.iter())?);
    Ok(text)
}

/// Marks what nothing else beats.
fn star(is_on_front: bool) -> &'static str {
    if is_on_front { "★" } else { "" }
}

fn rows_table(rows: &[Row]) -> String {
    let mut text = String::from(
        "<table><tr><th>mode<th><th>mean<th>RMS<th>max<th>ꟻLIP\
                                 <th>median, ns a pixel<th>quartiles",
    );
    for row in rows {
        let _ = write!(
            text,
            "<tr><td>{}<td>{}<td class=n>{:.4}<td class=n>{:.4}<td class=n>{:.3}<td class=n>{:.3}\
             <td class=n>{:.1}<td class=n>{:.1}–{:.1}",
            escaped(&row.mode),
            star(row.is_on_front),
            row.mean,
            row.rms,
            row.max,
            row.flip,
            row.quartiles[1],
            row.quartiles[0],
            row.quartiles[2],
        );
    }
    text.push_str("</table>");
    text
}

/// Writes `extremes.html` with a plot a sweep.
///
/// # Errors
/// When a file cannot be written or a plot cannot be drawn.
pub fn sweeps_page(
    folder: &Path,
    name: &PageName,
    swept: &[SweepOutcome],
) -> Result<(), PageError> {
    let mut body = String::from(
        "<p>Each goes from harmless values of a parameter to where arithmetic breaks. A sweep fails \
         when an error is above its bound, and when it would show nothing: when its filters keep too few \
         cases, when results do not change with the parameter, or when the bound is more than twice \
         the largest error. Errors of 0 and infinity have places beyond the breaks of an axis.</p>\
         <table><tr><th>sweep<th>largest error<th>at<th>bound<th>cases kept<th>",
    );
    for sweep in swept {
        let (class, word) = verdict(sweep);
        let _ = write!(
            body,
            "<tr><td><a href=\"#{0}\">{0}</a><td class=n>{1} {2}<td class=n>{3}<td class=n>{4}\
             <td class=n>{5}<td class={class}>{word}",
            sweep.name,
            short(sweep.largest),
            escaped(sweep.unit),
            short(sweep.at),
            short(sweep.bound),
            kept(sweep),
        );
    }
    body.push_str("</table>");
    for sweep in swept {
        body.push_str(&sweep_section(sweep)?);
    }
    name.write(folder, &page("Stiff and extreme cases", &body))
}

/// The class and the word of a verdict.
fn verdict(sweep: &SweepOutcome) -> (&'static str, &'static str) {
    if sweep.passes() { ("pass", "pass") } else { ("fail", "FAIL") }
}

fn sweep_section(sweep: &SweepOutcome) -> Result<String, PageError> {
    let (class, word) = verdict(sweep);
    let before = (!sweep.before.is_empty()).then(|| Line {
        name: "before the driver was changed".to_owned(),
        points: sweep.before.to_vec(),
    });
    let lines: Vec<Line> = sweep.lines.iter().map(Series::line).chain(before).collect();
    let caption =
        Caption { title: sweep.name, x: sweep.parameter, y: &format!("error, {}", sweep.unit) };
    let faults: String =
        sweep.faults.iter().map(|fault| format!("<br><b>{}</b>", escaped(fault))).collect();
    let plot = log_log(caption, &lines, (sweep.bound > 0.0).then_some(sweep.bound))?;
    Ok(format!(
        "<h2 id=\"{name}\">{name} <span class={class}>{word}</span></h2><p>{}.<br>Largest error {} {unit} at \
         {}; bound {}: {}.<br>{} cases kept.<br><b>Where it breaks:</b> {}.{faults}</p>{plot}",
        escaped(sweep.what),
        short(sweep.largest),
        short(sweep.at),
        short(sweep.bound),
        escaped(sweep.why),
        kept(sweep),
        escaped(sweep.breaks),
        name = sweep.name,
        unit = escaped(sweep.unit),
    ))
}

/// Writes `self-test.html`: each known mistake, and how far above its check's tolerance its error is.
///
/// # Errors
/// When the file cannot be written.
pub fn trials_page(folder: &Path, name: &PageName, trials: &[Trial]) -> Result<(), PageError> {
    let mut body = String::from(
        "<p>Each known mistake is built into its formula, one at a time; the check of that formula \
         must fail.</p><table><tr><th>check<th>mistake<th>error<th>tolerance<th>times<th>",
    );
    for trial in trials {
        let (class, word) = if trial.noticed { ("pass", "noticed") } else { ("fail", "MISSED") };
        let times = match trial.tolerance {
            0.0 => "—".to_owned(),
            tolerance => short(trial.error / tolerance),
        };
        let _ = write!(
            body,
            "<tr><td><b>{}</b><td>{}<td class=n>{}<td class=n>{}<td class=n>{times}<td class={class}>{word}",
            escaped(trial.check),
            escaped(trial.mistake),
            short(trial.error),
            short(trial.tolerance),
        );
    }
    body.push_str("</table>");
    name.write(folder, &page("Known mistakes", &body))
}
