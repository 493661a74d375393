//! The errors of the cases of a check.

use super::unit::Unit;
use serde::Serialize;

/// Expected and measured values of the comparison that contains the worst case; the report shows them as pictures.
#[derive(Clone, Debug, Default)]
pub struct ComparedCases {
    /// Expected and measured value of each case.
    pub values: Vec<[[f64; 4]; 2]>,
    /// Error of each case, in the check's unit.
    pub errors: Vec<f64>,
}

/// How many cases reach what a check is about: a mode, a branch, a pixel that is drawn.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Reach {
    /// What is reached.
    pub what: String,
    /// By how many cases.
    pub cases: usize,
    /// How many must reach it for the check to mean anything.
    pub least: usize,
}

/// Counts cases and keeps the one with the largest error.
#[derive(Clone, Debug)]
pub struct Tally {
    unit: Unit,
    cases: u64,
    largest: f64,
    worst: String,
    compared: ComparedCases,
    reached: Vec<Reach>,
    digest: u64,
}

/// What a digest is multiplied by (FNV-1a, 64 bits).
const PRIME: u64 = 0x0100_0000_01b3;

impl Tally {
    /// A tally without cases.
    pub fn new(unit: Unit) -> Self {
        Self {
            unit,
            cases: 0,
            largest: 0.0,
            worst: String::new(),
            compared: ComparedCases::default(),
            reached: Vec::new(),
            digest: 0xcbf2_9ce4_8422_2325,
        }
    }

    /// Says how many cases reach something, of which at least `least` must.
    pub fn reach(&mut self, what: impl Into<String>, cases: usize, least: usize) {
        self.reached.push(Reach { what: what.into(), cases, least });
    }

    /// What was reached, and by how many cases.
    pub(super) fn reached(&self) -> &[Reach] {
        &self.reached
    }

    /// The unit of errors.
    pub(super) fn unit(&self) -> Unit {
        self.unit
    }

    /// Adds measured values to the digest.
    pub(super) fn digest_values(&mut self, values: &[f64]) {
        for value in values {
            self.digest = (self.digest ^ value.to_bits()).wrapping_mul(PRIME).rotate_left(23);
        }
    }

    /// A digest of all errors and measured values, the same where their bits are the same.
    pub fn digest(&self) -> String {
        format!("{:016x}", self.digest)
    }

    /// Adds a case, with its error in the check's unit.
    pub fn add(&mut self, error: f64, case: impl FnOnce() -> String) {
        self.cases += 1;
        self.digest_values(&[error]);
        if error > self.largest {
            self.largest = error;
            self.worst = case();
        }
    }

    /// Keeps the comparison if it raised the largest error above `before`, or is the first.
    pub(super) fn keep(&mut self, compared: ComparedCases, before: f64) {
        if self.compared.errors.is_empty() || self.largest > before {
            self.compared = compared;
        }
    }

    /// The number of cases.
    pub fn cases(&self) -> u64 {
        self.cases
    }

    /// The largest error, in the check's unit.
    pub fn largest(&self) -> f64 {
        self.largest
    }

    /// A description of the case with the largest error, and the values that were compared with it.
    pub fn into_worst(self) -> (String, ComparedCases) {
        (self.worst, self.compared)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_case_is_kept() {
        let mut tally = Tally::new(Unit::Bytes);
        tally.add(0.0, || "equal".to_owned());
        assert_eq!((tally.cases(), tally.largest()), (1, 0.0));
        tally.add(2.0, || "two off".to_owned());
        tally.add(1.0, || "one off".to_owned());
        assert_eq!((tally.cases(), tally.largest()), (3, 2.0));
        assert_eq!(tally.into_worst().0, "two off");
    }

    #[test]
    fn a_digest_sees_every_value_and_their_order() {
        let of = |values: &[f64]| {
            let mut tally = Tally::new(Unit::Bytes);
            tally.digest_values(values);
            tally.digest()
        };
        assert_eq!(of(&[1.0, 2.0]), of(&[1.0, 2.0]));
        assert_ne!(of(&[1.0, 2.0]), of(&[2.0, 1.0]));
        assert_ne!(of(&[0.0]), of(&[-0.0]));
    }

    #[test]
    fn what_is_reached_is_kept() {
        let mut tally = Tally::new(Unit::Bytes);
        tally.reach("a mode", 3, 4);
        let Reach { what, cases, least } = &tally.reached()[0];
        assert_eq!((what.as_str(), *cases, *least), ("a mode", 3, 4));
    }
}
