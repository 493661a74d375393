//! Text tables and JSON.

use super::layout::{Layout, NARROW, right, short};
use crate::check::{Outcome, Verdict};
use crate::self_test::Trial;
use crate::sweep::SweepOutcome;
use crate::tradeoff::choices::ChoiceOutcome;
use crate::tradeoff::functions::FunctionRow;
use crate::tradeoff::{Row, scene_advice};
use comfy_table::{Attribute, Cell, Color};
use serde::Serialize;

/// The outcomes as a table, followed by the details of each failure.
pub fn table(layout: Layout, outcomes: &[Outcome]) -> String {
    let mut table =
        layout.table(["check", "citation", "cases", "largest error", "tolerance", "", "time"]);
    for outcome in outcomes {
        let (word, color) = match outcome.verdict {
            Verdict::Pass => ("pass", Color::Green),
            Verdict::Fail => ("FAIL", Color::Red),
            Verdict::Broken(_) => ("BROKEN", Color::Red),
        };
        table.add_row([
            Cell::new(outcome.name).add_attribute(Attribute::Bold),
            Cell::new(outcome.citation),
            right(outcome.cases.to_string()),
            right(quantity(outcome.largest_error, outcome)),
            right(quantity(outcome.tolerance, outcome)),
            Cell::new(word).fg(color),
            right(format!("{:.2} s", outcome.seconds)),
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
    if value == 0.0 { short(value) } else { format!("{} {unit}", short(value)) }
}

/// Results as JSON. An infinite error is `null`.
///
/// # Errors
/// When it cannot be written as JSON, which numbers and text always can.
pub fn json(found: &impl Serialize) -> serde_json::Result<String> {
    serde_json::to_string_pretty(found)
}

/// Each mistake and whether it was noticed.
pub fn trials_table(layout: Layout, trials: &[Trial]) -> String {
    let mut table = layout.table(["check", "mistake", "error", "tolerance", ""]);
    for trial in trials {
        let (word, color) =
            if trial.noticed { ("noticed", Color::Green) } else { ("MISSED", Color::Red) };
        table.add_row([
            Cell::new(trial.check),
            Cell::new(trial.mistake),
            right(short(trial.error)),
            right(short(trial.tolerance)),
            Cell::new(word).fg(color),
        ]);
    }
    table.to_string()
}

/// A star where nothing else is as good and as cheap.
fn star(is_on_front: bool) -> &'static str {
    if is_on_front { "*" } else { "" }
}

/// Error and time of each mode on each scene, and a sentence of advice for each.
pub fn tradeoff_table(layout: Layout, rows: &[Row]) -> String {
    let headings =
        ["scene", "mode", "", "mean", "RMS", "max", "FLIP", "median, ns/pixel", "quartiles"];
    let mut table = layout.table(headings);
    for row in rows {
        let [low, median, high] = row.quartiles;
        table.add_row([
            Cell::new(row.scene),
            Cell::new(&row.mode),
            Cell::new(star(row.is_on_front)),
            right(format!("{:.4}", row.mean)),
            right(format!("{:.4}", row.rms)),
            right(format!("{:.3}", row.max)),
            right(format!("{:.3}", row.flip)),
            right(format!("{median:.1}")),
            right(format!("{low:.1}–{high:.1}")),
        ]);
    }
    let mut text = table.to_string();
    text.push_str("\n* no other mode is better in error (by 2 %) or time (beyond quartiles) and as good in the other\n");
    for of in rows.chunk_by(|a, b| a.scene == b.scene) {
        text.push_str(&wrapped(&format!("{}: {}.", of[0].scene, scene_advice(of))));
    }
    text
}

/// Error, time and memory of the alternatives of each choice, and a sentence of advice for each.
pub fn choices_table(layout: Layout, choices: &[ChoiceOutcome]) -> String {
    let headings =
        ["choice", "alternative", "", "RMS", "max", "median, ns/pixel", "quartiles", "bytes/texel"];
    let mut table = layout.table(headings);
    for choice in choices {
        for row in &choice.rows {
            let [low, median, high] = row.quartiles;
            table.add_row([
                Cell::new(choice.choice),
                Cell::new(&row.alternative),
                Cell::new(star(row.is_on_front)),
                right(format!("{:.4}", row.rms)),
                right(format!("{:.3}", row.max)),
                right(format!("{median:.1}")),
                right(format!("{low:.1}–{high:.1}")),
                right(row.bytes.map_or_else(String::new, |bytes| format!("{bytes}"))),
            ]);
        }
    }
    let mut text = table.to_string();
    text.push_str("\n* no other is better in error (by 2 %) or cost (beyond quartiles) and as good in the other\n");
    for choice in choices {
        text.push_str(&wrapped(&format!("{}: {}.", choice.choice, choice.advice)));
    }
    text
}

/// A text in lines that a terminal shows whole.
fn wrapped(text: &str) -> String {
    let (mut out, mut column) = (String::new(), 0);
    for word in text.split(' ') {
        let length = word.chars().count() + 1;
        if column > 0 && column + length > usize::from(NARROW) {
            out.push_str("\n ");
            column = 1;
        }
        if column > 0 {
            out.push(' ');
        }
        out.push_str(word);
        column += length;
    }
    out.push('\n');
    out
}

/// Error and time of each function.
pub fn functions_table(layout: Layout, rows: &[FunctionRow]) -> String {
    let mut table = layout.table(["function", "largest error, ULP", "ns/call"]);
    for row in rows {
        table.add_row([
            Cell::new(row.function),
            right(format!("{:.3}", row.ulp)),
            right(format!("{:.2}", row.nanoseconds)),
        ]);
    }
    table.to_string()
}

/// The largest error of each sweep, and how many cases its filters kept.
pub fn sweeps_table(layout: Layout, swept: &[SweepOutcome]) -> String {
    let headings =
        ["sweep", "parameter", "largest error", "unit", "at", "bound", "kept", "", "time"];
    let mut table = layout.table(headings);
    for sweep in swept {
        let (word, color) =
            if sweep.passes() { ("pass", Color::Green) } else { ("FAIL", Color::Red) };
        table.add_row([
            Cell::new(sweep.name).add_attribute(Attribute::Bold),
            Cell::new(sweep.parameter),
            right(short(sweep.largest)),
            Cell::new(sweep.unit),
            right(short(sweep.at)),
            right(short(sweep.bound)),
            right(match layout {
                Layout::Narrow => share(sweep),
                Layout::Wide => kept(sweep),
            }),
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

/// The share of cases that were compared, in words.
pub(super) fn kept(sweep: &SweepOutcome) -> String {
    format!("{} of {}", share(sweep), sweep.tried)
}

fn share(sweep: &SweepOutcome) -> String {
    format!("{:.0} %", 100.0 * sweep.kept as f64 / sweep.tried.max(1) as f64)
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
            digest: String::new(),
            seconds: 0.5,
            verdict,
            compared: ComparedCases::default(),
        }
    }

    #[test]
    fn a_failure_names_its_worst_case() {
        let text = table(Layout::Narrow, &[outcome(Verdict::Fail)]);
        for part in ["bilinear", "GL 2.1, 3.8.8", "0.25 of range", "FAIL", "worst: at [0.5, 0.5]"] {
            assert!(text.contains(part), "{part} in {text}");
        }
        assert!(!table(Layout::Narrow, &[outcome(Verdict::Pass)]).contains("worst"));
    }

    #[test]
    fn texts_are_wrapped() {
        let text = wrapped(&"words ".repeat(60));
        assert!(text.lines().count() > 3);
        assert!(text.lines().all(|line| line.chars().count() <= NARROW.into()), "{text}");
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
