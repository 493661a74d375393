//! The outcomes as a table for people and as JSON for programs.

use crate::check::{Outcome, Verdict};
use comfy_table::{Attribute, Cell, CellAlignment, Color, ContentArrangement, Table, presets};

/// The outcomes as a table, and under it what failed and why.
pub fn table(outcomes: &[Outcome]) -> String {
    let mut table = Table::new();
    table
        .load_preset(presets::UTF8_BORDERS_ONLY)
        .set_content_arrangement(ContentArrangement::Dynamic)
        .set_header(["check", "citation", "cases", "largest error", "tolerance", "", "time"]);
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
fn quantity(value: f64, outcome: &Outcome) -> String {
    let unit = outcome.unit.label();
    if value == 0.0 {
        "0".to_owned()
    } else if (0.001..1000.0).contains(&value) {
        format!("{value:.3} {unit}")
    } else {
        format!("{value:.1e} {unit}")
    }
}

/// The outcomes as a JSON array. An infinite error is `null`.
///
/// # Errors
/// When the outcomes cannot be written as JSON, which numbers and text always can.
pub fn json(outcomes: &[Outcome]) -> serde_json::Result<String> {
    serde_json::to_string_pretty(outcomes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::Unit;

    fn outcome(verdict: Verdict) -> Outcome {
        Outcome {
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
        let value: serde_json::Value =
            serde_json::from_str(&json(&[outcome(Verdict::Broken("no context".to_owned()))])?)?;
        assert_eq!(value[0]["largest_error"], 0.25);
        assert_eq!(value[0]["unit"], "full-scale");
        assert_eq!(value[0]["verdict"]["broken"], "no context");
        Ok(())
    }
}
