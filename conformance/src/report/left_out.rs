//! The table and the page of what is left out.

use super::layout::{Layout, right};
use super::page::{PageError, PageName, escaped, page};
use crate::left_out::{PlanFound, Row, Timing};
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
        count => format!("{count} bytes DIFFER by {}", row.largest),
    }
}

/// The cost in another library, in words.
fn peer_cost(timing: &Result<Timing, String>) -> String {
    match timing {
        Ok(timing) => format!("{:.2} ±{:.2}", timing.ratio, timing.noise),
        Err(why) => why.clone(),
    }
}

/// A row a feature, and a closing line. `peers` are the names of the other libraries that were timed.
pub fn left_out_table(layout: Layout, rows: &[Row], peers: &[&str]) -> String {
    let columns = ["feature", "frame", "cost", "noise"].into_iter().chain(peers.iter().copied());
    let mut table = layout.table(columns.chain(["pictures", "plan"]));
    for row in rows {
        let cost = Cell::new(format!("{:.2}", row.timing.ratio));
        let color = if row.timing.ratio <= NOTICEABLE { Color::Green } else { Color::Yellow };
        let plan = Cell::new(judgement(row));
        let own = [
            Cell::new(row.name).add_attribute(Attribute::Bold),
            right(format!("{:.2} ms", row.timing.plain_ms)),
            cost.fg(color).set_alignment(comfy_table::CellAlignment::Right),
            right(format!("±{:.2}", row.timing.noise)),
        ];
        let peers = row.peers.iter().map(|timing| right(peer_cost(timing)));
        let plan = if row.passes() { plan } else { plan.fg(Color::Red) };
        table.add_row(own.into_iter().chain(peers).chain([Cell::new(pictures(row)), plan]));
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
        count(|row| row.timing.ratio <= NOTICEABLE),
    )
}

/// Writes `left-out.html`: the table with a bar a row, and a thin one for each other library.
///
/// # Errors
/// When the file cannot be written.
pub fn left_out_page(
    folder: &Path,
    name: &PageName,
    rows: &[Row],
    peers: &[&str],
) -> Result<(), PageError> {
    let mut body = format!(
        "<p>Each row draws a scene with and without something that has no effect on its picture. The cost is the \
         time with it over the time without it, frames taken in turns: 1.00 is free. The plan is what \
         <code>DETGL_EXPLAIN=1</code> prints of both.</p><p>{}</p>\
         <table><tr><th>feature<th>asked for, not needed<th>cost<th>{}<th>pictures<th>plan",
        escaped(&summary(rows)),
        escaped(&peers.join(", ")),
    );
    for row in rows {
        // 100 pixels are a cost of 1.
        let width = |ratio: f64| (ratio.clamp(0.0, 5.0) * 100.0).round();
        let color = if row.timing.ratio <= NOTICEABLE { "#6a6" } else { "#d93" };
        let mut bars = String::new();
        for (at, timing) in row.peers.iter().enumerate() {
            let (y, name) = (13 + 6 * at, peers.get(at).copied().unwrap_or_default());
            let of = timing.as_ref().map_or(0.0, |timing| width(timing.ratio));
            let _ = write!(
                bars,
                "<rect y=\"{y}\" width=\"{of}\" height=\"5\" fill=\"#99a\"><title>{} {}</title></rect>",
                escaped(name),
                escaped(&peer_cost(timing)),
            );
        }
        let (own, height) = (width(row.timing.ratio), 12 + 6 * row.peers.len());
        let class = if row.passes() { "pass" } else { "fail" };
        let _ = write!(
            body,
            "<tr><td><b>{}</b><td>{}<td class=\"n\">{:.2} ±{:.2}<td><svg width=\"520\" height=\"{height}\">\
             <rect width=\"{own}\" height=\"12\" fill=\"{color}\"/>{bars}\
             <line x1=\"100\" x2=\"100\" y2=\"{height}\" stroke=\"#222\"/></svg><td>{}<td class=\"{class}\">{}",
            escaped(row.name),
            escaped(row.what),
            row.timing.ratio,
            row.timing.noise,
            pictures(row),
            escaped(&judgement(row)),
        );
    }
    body.push_str("</table>");
    name.write(folder, &page("What is left out", &body))
}
