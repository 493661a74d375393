//! The definition of a check, and how one is run.

use super::harness::Harness;
use super::outcome::{Outcome, Verdict};
use super::tally::{Reach, Tally};
use super::unit::Unit;
use crate::probe::ProbeError;
use std::time::Instant;

/// A check: the formula, the tolerance and its reason, and the function that compares.
#[derive(Clone, Copy, Debug)]
pub struct Check {
    /// The name, for `--only` and for the list of mutations.
    pub name: &'static str,
    /// The section that has the formula.
    pub citation: &'static str,
    /// A description of what is checked.
    pub what: &'static str,
    /// The unit of errors.
    pub unit: Unit,
    /// The largest error that passes.
    pub tolerance: f64,
    /// The reason for the tolerance.
    pub why: &'static str,
    /// Makes the cases and compares them.
    pub run: fn(&Harness, &mut Tally) -> Result<(), ProbeError>,
}

impl Check {
    /// Runs the check.
    pub fn run(&self, harness: &Harness) -> Outcome {
        let start = Instant::now();
        let mut tally = Tally::new(self.unit);
        let result = (self.run)(harness, &mut tally);
        let reached = tally.reached().to_vec();
        let verdict = match result {
            Err(error) => Verdict::Broken(error.to_string()),
            Ok(()) if tally.cases() == 0 => Verdict::Broken("no cases".to_owned()),
            Ok(()) if let Some(reach) = reached.iter().find(|reach| reach.cases < reach.least) => {
                let Reach { what, cases, least } = reach;
                Verdict::Broken(format!("{what}: {cases} cases, of which {least} are needed"))
            }
            Ok(()) if tally.largest() <= self.tolerance => Verdict::Pass,
            Ok(()) => Verdict::Fail,
        };
        let (cases, largest_error) = (tally.cases(), tally.largest());
        let digest = tally.digest();
        let (worst, compared) = tally.into_worst();
        Outcome {
            name: self.name,
            citation: self.citation,
            what: self.what,
            cases,
            reached,
            largest_error,
            unit: self.unit,
            tolerance: self.tolerance,
            why: self.why,
            worst,
            digest,
            seconds: start.elapsed().as_secs_f64(),
            verdict,
            compared,
        }
    }
}
