//! The table and the page of what is left out.

use super::layout::{Layout, right};
use super::page::{PageError, PageName, escaped, page};
use crate::left_out::{PlanFound, Row};
use comfy_table::{Attribute, Cell, Color};
use std::fmt::Write;
use std::path::Path;

/// A cost above this is no noise.
const NOTICEABLE: f64 = 1.05;

/// How the plan of a row is judged, in words.
fn judgement(row: &Row) -> String {
    match (&row.plan, row.allowance) {
        (PlanFound::SameWork, _) => "left out by the plan".to_owned(),
        (PlanFound::More(line), Some(reason)) => format!("{reason}: {line}"),
        (PlanFound::More(line), None) => format!("NOT LEFT OUT: {line}"),
    }
}

/// The pictures of a row, in words.
fn pictures(row: &Row) -> String {
    match row.different {
        0 => "equal".to_owned(),
        count => {
            let word = if row.largest > row.tolerance { "DIFFER" } else { "differ" };
            format!("{count} bytes {word} by {}", row.largest)
        }
    }
}

/// A row a feature, and a closing line.
pub fn left_out_table(layout: Layout, rows: &[Row]) -> String {
    let mut table = layout.table(["feature", "frame", "cost", "noise", "pictures", "plan"]);
    for row in rows {
        let cost = Cell::new(format!("{:.2}", row.ratio));
        let color = if row.ratio <= NOTICEABLE { Color::Green } else { Color::Yellow };
        let plan = Cell::new(judgement(row));
        table.add_row([
            Cell::new(row.name).add_attribute(Attribute::Bold),
            right(format!("{:.2} ms", row.plain_ms)),
            cost.fg(color).set_alignment(comfy_table::CellAlignment::Right),
            right(format!("±{:.2}", row.noise)),
            Cell::new(pictures(row)),
            if row.passes() { plan } else { plan.fg(Color::Red) },
        ]);
    }
    format!("{table}\n{}", summary(rows))
}

/// The closing line.
fn summary(rows: &[Row]) -> String {
    let count = |test: fn(&Row) -> bool| rows.iter().filter(|row| test(row)).count();
    format!(
        "the plan leaves out {} of {}; {} cost at most {NOTICEABLE}; drawn by one thread",
        count(|row| row.plan == PlanFound::SameWork),
        rows.len(),
        count(|row| row.ratio <= NOTICEABLE),
    )
}

/// Writes `left-out.html`: the table with a bar a row.
///
/// # Errors
/// When the file cannot be written.
pub fn left_out_page(folder: &Path, name: &PageName, rows: &[Row]) -> Result<(), PageError> {
    let mut body = format!(
        "<p>Each row draws a scene with and without something that has no effect on its picture. The cost is the \
         time with it over the time without it, frames taken in turns: 1.00 is free. The plan is what \
         <code>DETGL_EXPLAIN=1</code> prints of both.</p><p>{}</p>\
         <table><tr><th>feature<th>asked for, not needed<th>cost<th><th>pictures<th>plan",
        escaped(&summary(rows))
    );
    for row in rows {
        // 100 pixels are a cost of 1.
        let width = (row.ratio.clamp(0.0, 5.0) * 100.0).round();
        let color = if row.ratio <= NOTICEABLE { "#6a6" } else { "#d93" };
        let class = if row.passes() { "pass" } else { "fail" };
        let _ = write!(
            body,
            "<tr><td><b>{}</b><td>{}<td class=\"n\">{:.2} ±{:.2}<td><svg width=\"520\" height=\"12\">\
             <rect width=\"{width}\" height=\"12\" fill=\"{color}\"/>\
             <line x1=\"100\" x2=\"100\" y2=\"12\" stroke=\"#222\"/></svg><td>{}<td class=\"{class}\">{}",
            escaped(row.name),
            escaped(row.what),
            row.ratio,
            row.noise,
            pictures(row),
            escaped(&judgement(row)),
        );
    }
    body.push_str("</table>");
    name.write(folder, &page("What is left out", &body))
}
