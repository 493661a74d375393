//! The result of a check.

use super::tally::{ComparedCases, Reach};
use super::unit::Unit;
use serde::{Deserialize, Serialize};

/// Whether a check passed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Every error is within the tolerance.
    Pass,
    /// An error is larger than the tolerance.
    Fail,
    /// The check could not be run, for this reason.
    Broken(String),
}

/// The result of a check.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// The check's name.
    pub name: &'static str,
    /// The section that has the formula.
    pub citation: &'static str,
    /// A description of what was checked.
    pub what: &'static str,
    /// How many cases were compared.
    pub cases: u64,
    /// How many of them reach what the check is about.
    pub reached: Vec<Reach>,
    /// The largest error.
    pub largest_error: f64,
    /// The unit of errors.
    pub unit: Unit,
    /// The largest error that passes.
    pub tolerance: f64,
    /// The reason for the tolerance.
    pub why: &'static str,
    /// The case with the largest error, its expected and its measured value; empty if no case has an error.
    pub worst: String,
    /// A digest of everything that was measured: equal where two machines, or two builds, give the same bits.
    pub digest: String,
    /// Run time in seconds.
    pub seconds: f64,
    /// Whether it passed.
    pub verdict: Verdict,
    /// The values that were compared together with the worst case.
    #[serde(skip)]
    pub compared: ComparedCases,
}
