//! The table of what DetGL and others answer.

use super::driver::Driver;
use super::process::Answer;
use super::{Row, passed};
use crate::check::{Outcome, Verdict};
use std::fmt::Write;

/// A number of few digits.
fn short(value: f64) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else if (0.01..1e4).contains(&value.abs()) {
        let text = format!("{value:.3}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{value:.1e}")
    }
}

fn escaped(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

/// The first sentence or so of why there is no number.
fn reason(text: &str) -> String {
    let line = text.lines().next().unwrap_or_default();
    let end = line.char_indices().nth(90).map_or(line.len(), |(at, _)| at);
    escaped(&line[..end])
}

fn cell(answer: &Result<Answer, String>) -> String {
    match answer {
        Ok(Answer { largest_error, verdict, .. }) => {
            let error = largest_error.map_or_else(|| "∞".to_owned(), short);
            match verdict {
                Verdict::Pass => error,
                Verdict::Fail => format!("**{error}**"),
                Verdict::Broken(why) => format!("*{}*", reason(why)),
            }
        }
        Err(why) => format!("*{}*", reason(why)),
    }
}

/// A page in Markdown: each formula, and the largest error of each driver. What is above the tolerance is bold, what gives
/// no number says why.
pub fn page(rows: &[Row], drivers: &[Driver]) -> String {
    let mut out = String::from("| check | formula | DetGL |");
    for driver in drivers {
        let _ = write!(out, " {} |", driver.name);
    }
    out += " tolerance |\n|---|---|---|";
    out += &"---|".repeat(drivers.len());
    out += "---|\n";
    for Row { own, others } in rows {
        let Outcome { name, citation, unit, tolerance, largest_error, .. } = own;
        let own_error = short(*largest_error);
        let _ = write!(out, "| `{name}` | {} | {own_error} |", escaped(citation));
        for answer in others {
            let _ = write!(out, " {} |", cell(answer));
        }
        let _ = writeln!(out, " {} {} |", short(*tolerance), unit.label());
    }
    out
}

/// A line for each driver: what it calls itself, and how many checks it passes.
pub fn summary(rows: &[Row], drivers: &[Driver]) -> String {
    let mut out = String::new();
    for (at, driver) in drivers.iter().enumerate() {
        let (passes, asked) = passed(rows, at);
        let _ = writeln!(out, "{} ({}): {passes} of {asked} checks pass", driver.name, driver.says);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_too_large_is_bold() {
        let answer =
            |verdict| Ok(Answer { largest_error: Some(0.25), verdict, worst: String::new() });
        assert_eq!(cell(&answer(Verdict::Pass)), "0.25");
        assert_eq!(cell(&answer(Verdict::Fail)), "**0.25**");
        assert_eq!(cell(&answer(Verdict::Broken("a | b".to_owned()))), "*a \\| b*");
        assert_eq!(cell(&Err("it ends".to_owned())), "*it ends*");
        assert_eq!([0.0, 2.0, 1.5e-7].map(short), ["0", "2", "1.5e-7"]);
    }
}
