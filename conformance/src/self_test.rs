//! Mutation test of the suite: each known mistake is built into its oracle, one at a time, and the
//! check of that formula must fail.

use crate::chapters::checks;
use crate::check::{Effort, Harness, Subject, Verdict};
use crate::mutation::{MutationRow, Variant};
use serde::Serialize;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The result for one mistake.
#[derive(Clone, Debug, Serialize)]
pub struct Trial {
    /// The name of the check that must fail.
    pub check: &'static str,
    /// A description of the mistake.
    pub mistake: &'static str,
    /// Whether the check failed, as it must.
    pub noticed: bool,
    /// The largest error, in the check's unit.
    pub error: f64,
    /// The largest error that passes.
    pub tolerance: f64,
}

/// [`run_with`] without a report of its progress.
pub fn run(subject: Subject, rows: &[&MutationRow]) -> Vec<Trial> {
    run_with(subject, rows, &|| ())
}

/// Runs the check of each of these mistakes against `subject`, on as many threads as there are processors. Each thread has
/// GL contexts of its own. `done` is called after each.
pub fn run_with(subject: Subject, rows: &[&MutationRow], done: &(dyn Fn() + Sync)) -> Vec<Trial> {
    let next = AtomicUsize::new(0);
    let some = || {
        let numbers = std::iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed));
        let rows = numbers.map_while(|number| Some((number, rows.get(number)?)));
        rows.map(|(number, row)| {
            let trial = trial(row, subject);
            done();
            (number, trial)
        })
        .collect::<Vec<_>>()
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut trials = std::thread::scope(|scope| {
        let others: Vec<_> = (1..threads).map(|_| scope.spawn(some)).collect();
        let mut trials = some();
        for other in others {
            trials.extend(other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        }
        trials
    });
    trials.sort_by_key(|(number, _)| *number);
    trials.into_iter().map(|(_, trial)| trial).collect()
}

fn trial(row: &MutationRow, subject: Subject) -> Trial {
    let variant = Variant::wrong(row.mutation);
    let harness = Harness { subject, effort: Effort::Quick, variant };
    let outcome = checks().find(|check| check.name == row.check).map(|check| check.run(&harness));
    Trial {
        check: row.check,
        mistake: row.what,
        noticed: outcome.as_ref().is_some_and(|outcome| outcome.verdict == Verdict::Fail),
        error: outcome.as_ref().map_or(0.0, |outcome| outcome.largest_error),
        tolerance: outcome.as_ref().map_or(0.0, |outcome| outcome.tolerance),
    }
}
