//! Text tables and JSON.

use crate::check::{Outcome, Verdict};
use crate::self_test::Trial;
use crate::sweep::SweepOutcome;
use crate::tradeoff::Row;
use crate::tradeoff::functions::FunctionRow;
use comfy_table::{Attribute, Cell, CellAlignment, Color, ContentArrangement, Table, presets};
use serde::Serialize;

/// The outcomes as a table, followed by the details of each failure.
pub fn table(outcomes: &[Outcome]) -> String {
    let mut table =
        headed(["check", "citation", "cases", "largest error", "tolerance", "", "time"]);
    for outcome in outcomes {
        let (word, color) = match outcome.verdict {
            Verdict::Pass => ("pass", Color::Green),
            Verdict::Fail => ("FAIL", Color::Red),
            Verdict::Broken(_) => ("BROKEN", Color::Red),
        };
        table.add_row([
            Cell::new(outcome.name).add_attribute(Attribute::Bold),
            Cell::new(outcome.citation),
            Cell::new(outcome.cases).set_alignment(CellAlignment::Right),
            Cell::new(quantity(outcome.largest_error, outcome)).set_alignment(CellAlignment::Right),
            Cell::new(quantity(outcome.tolerance, outcome)).set_alignment(CellAlignment::Right),
            Cell::new(word).fg(color),
            Cell::new(format!("{:.2} s", outcome.seconds)).set_alignment(CellAlignment::Right),
        ]);
    }
    let mut text = table.to_string();
    for outcome in outcomes {
        match &outcome.verdict {
            Verdict::Pass => {}
            Verdict::Fail => text.push_str(&format!(
                "\n\n{}: {}\n  tolerance: {}\n  worst: {}",
                outcome.name, outcome.what, outcome.why, outcome.worst
            )),
            Verdict::Broken(reason) => {
                text.push_str(&format!("\n\n{}: could not be measured: {reason}", outcome.name));
            }
        }
    }
    text
}

/// A number in the check's unit.
pub(super) fn quantity(value: f64, outcome: &Outcome) -> String {
    let unit = outcome.unit.label();
    if value == 0.0 {
        "0".to_owned()
    } else if (0.001..1000.0).contains(&value) {
        format!("{value:.3} {unit}")
    } else {
        format!("{value:.1e} {unit}")
    }
}

/// Results as JSON. An infinite error is `null`.
///
/// # Errors
/// When it cannot be written as JSON, which numbers and text always can.
pub fn json(found: &impl Serialize) -> serde_json::Result<String> {
    serde_json::to_string_pretty(found)
}

/// An empty table with these headings.
pub(crate) fn headed<const N: usize>(headings: [&str; N]) -> Table {
    let mut table = Table::new();
    table
        .load_preset(presets::UTF8_BORDERS_ONLY)
        .set_content_arrangement(ContentArrangement::Dynamic)
        .set_header(headings);
    table
}

/// A right-aligned cell.
pub(crate) fn right(text: String) -> Cell {
    Cell::new(text).set_alignment(CellAlignment::Right)
}

/// Each mistake and whether it was noticed.
pub fn trials_table(trials: &[Trial]) -> String {
    let mut table = headed(["mistake", "check", "error", "tolerance", ""]);
    for trial in trials {
        let (word, color) =
            if trial.noticed { ("noticed", Color::Green) } else { ("MISSED", Color::Red) };
        table.add_row([
            Cell::new(trial.mistake),
            Cell::new(trial.check),
            right(format!("{:.2e}", trial.error)),
            right(format!("{:.2e}", trial.tolerance)),
            Cell::new(word).fg(color),
        ]);
    }
    let noticed = trials.iter().filter(|trial| trial.noticed).count();
    format!("{table}\n{noticed} of {} mistakes were noticed", trials.len())
}

/// Error and time of each mode on each scene.
pub fn tradeoff_table(rows: &[Row]) -> String {
    let mut table = headed(["scene", "mode", "mean", "RMS", "max", "FLIP", "ns/pixel"]);
    for row in rows {
        table.add_row([
            Cell::new(row.scene),
            Cell::new(&row.mode),
            right(format!("{:.4}", row.mean)),
            right(format!("{:.4}", row.rms)),
            right(format!("{:.3}", row.max)),
            right(format!("{:.3}", row.flip)),
            right(format!("{:.1}", row.nanoseconds)),
        ]);
    }
    table.to_string()
}

/// Error and time of each function.
pub fn functions_table(rows: &[FunctionRow]) -> String {
    let mut table = headed(["function", "largest error, ULP", "ns/call"]);
    for row in rows {
        table.add_row([
            Cell::new(row.function),
            right(format!("{:.3}", row.ulp)),
            right(format!("{:.2}", row.nanoseconds)),
        ]);
    }
    table.to_string()
}

/// The largest error of each sweep.
pub fn sweeps_table(swept: &[SweepOutcome]) -> String {
    let mut table = headed(["sweep", "parameter", "largest error", "at", "bound", "", "time"]);
    for sweep in swept {
        let (word, color) =
            if sweep.passes() { ("pass", Color::Green) } else { ("FAIL", Color::Red) };
        table.add_row([
            Cell::new(sweep.name).add_attribute(Attribute::Bold),
            Cell::new(sweep.parameter),
            right(format!("{:.2e} {}", sweep.largest, sweep.unit)),
            right(format!("{:.1e}", sweep.at)),
            right(format!("{:.2e}", sweep.bound)),
            Cell::new(word).fg(color),
            right(format!("{:.2} s", sweep.seconds)),
        ]);
    }
    let mut text = table.to_string();
    for sweep in swept.iter().filter(|sweep| !sweep.passes()) {
        text.push_str(&format!("\n\n{}: {}\n  bound: {}", sweep.name, sweep.what, sweep.why));
        for fault in sweep.faults.iter().take(4) {
            text.push_str(&format!("\n  {fault}"));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::{ComparedCases, Unit};

    fn outcome(verdict: Verdict) -> Outcome {
        Outcome {
            reached: Vec::new(),
            name: "bilinear",
            citation: "GL 2.1, 3.8.8",
            what: "weights",
            cases: 3,
            largest_error: 0.25,
            unit: Unit::FullScale,
            tolerance: 1e-6,
            why: "f32",
            worst: "at [0.5, 0.5]".to_owned(),
            seconds: 0.5,
            verdict,
            compared: ComparedCases::default(),
        }
    }

    #[test]
    fn a_failure_names_its_worst_case() {
        let text = table(&[outcome(Verdict::Fail)]);
        for part in ["bilinear", "GL 2.1, 3.8.8", "0.250 of range", "FAIL", "worst: at [0.5, 0.5]"]
        {
            assert!(text.contains(part), "{part} in {text}");
        }
        assert!(!table(&[outcome(Verdict::Pass)]).contains("worst"));
    }

    #[test]
    fn json_has_every_field() -> serde_json::Result<()> {
        let broken = vec![outcome(Verdict::Broken("no context".to_owned()))];
        let value: serde_json::Value = serde_json::from_str(&json(&broken)?)?;
        assert_eq!(value[0]["largest_error"], 0.25);
        assert_eq!(value[0]["unit"], "full-scale");
        assert_eq!(value[0]["verdict"]["broken"], "no context");
        Ok(())
    }
}
