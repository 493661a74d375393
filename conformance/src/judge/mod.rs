//! `conformance --driver …`: the checks through the C functions of other libraries, each in a process of its own, so that
//! the end of one is that of one check.
//!
//! What a check compares is asked of the library by [`gl`](crate::gl); oracle, cases and tolerance are the same.

mod driver;
mod page;
mod process;

pub use driver::{Driver, JudgeError};
pub use page::{page, summary};
pub use process::{Answer, Task};

use crate::check::{Check, Effort, Harness, Outcome, Subject, Verdict};
use crate::mutation::Variant;

/// Checks that ask something that only DetGL has, and what.
const OWN: [(&str, &str); 4] = [
    ("glu-mipmaps", "GLU is a library of its own"),
    ("glu-scale", "GLU is a library of its own"),
    ("matrix-look-at", "GLU is a library of its own"),
    ("matrix-frustum", "GLU is a library of its own"),
];

/// A check by DetGL and by others.
#[derive(Debug)]
pub struct Row {
    /// Of DetGL.
    pub own: Outcome,
    /// Of each of the others; why there is none.
    pub others: Vec<Result<Answer, String>>,
}

/// Runs a check everywhere.
pub fn judge(check: &Check, effort: Effort, drivers: &[Driver]) -> Row {
    let harness = Harness { subject: Subject::Driver, effort, variant: Variant::CORRECT };
    let others =
        drivers.iter().map(|driver| match OWN.iter().find(|(name, _)| *name == check.name) {
            Some((_, why)) => Err(format!("not asked: {why}")),
            None => driver.ask(check.name, effort),
        });
    Row { others: others.collect(), own: check.run(&harness) }
}

/// How many of the rows a driver passes, and how many it was asked.
pub fn passed(rows: &[Row], driver: usize) -> (usize, usize) {
    let answers = rows.iter().filter_map(|row| row.others.get(driver));
    let asked = answers
        .clone()
        .filter(|answer| !matches!(answer, Err(why) if why.starts_with("not asked")));
    let passes =
        answers.filter(|answer| matches!(answer, Ok(Answer { verdict: Verdict::Pass, .. })));
    (passes.count(), asked.count())
}
