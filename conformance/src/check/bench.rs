//! The bench that checks run on: who is measured, how many cases, and the tally of errors.

use super::outcome::Unit;
use crate::drive::{DriveError, Session};
use crate::mutation::Variant;
use std::fmt::Debug;

/// Who is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// DetGL, through GL's functions.
    Driver,
    /// The true oracle itself: with a wrong variant on the other side it shows that a check can
    /// fail, without any driver.
    Oracle,
}

/// How many cases are tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// A few, for the tests.
    Quick,
    /// Enough for a report in seconds.
    Full,
    /// Sixteen times as many.
    Thorough,
}

/// How checks are run.
#[derive(Clone, Copy, Debug)]
pub struct Bench {
    /// Who is measured.
    pub subject: Subject,
    /// How many cases.
    pub effort: Effort,
    /// The oracle to measure against.
    pub variant: Variant,
}

impl Bench {
    /// The number of cases out of `full`.
    pub fn cases(&self, full: usize) -> usize {
        match self.effort {
            Effort::Quick => full.div_ceil(16),
            Effort::Full => full,
            Effort::Thorough => full * 16,
        }
    }

    /// Compares the subject with the oracle over `cases` and tallies the differences.
    ///
    /// `expect` is the oracle; `observe` asks the driver, in a fresh context, for the values of
    /// all cases in order. Components that a check does not look at are 0 in both.
    ///
    /// # Errors
    /// When the driver reports a GL error or rejects a shader.
    pub fn compare<C: Debug>(
        &self,
        tally: &mut Tally,
        scene: &dyn Debug,
        cases: &[C],
        expect: impl Fn(&C, Variant) -> [f64; 4],
        observe: impl FnOnce(&Session) -> Result<Vec<[f64; 4]>, DriveError>,
    ) -> Result<(), DriveError> {
        let unit = tally.unit;
        let error = |_: &C, expected: [f64; 4], measured: [f64; 4]| {
            let errors = expected.iter().zip(measured).map(|(&e, m)| unit.error(e, m));
            errors.fold(0.0, f64::max)
        };
        self.compare_by(tally, scene, cases, expect, error, observe)
    }

    /// As [`Bench::compare`], with an error of the check's own, in its unit.
    ///
    /// # Errors
    /// When the driver reports a GL error or rejects a shader.
    pub fn compare_by<C: Debug>(
        &self,
        tally: &mut Tally,
        scene: &dyn Debug,
        cases: &[C],
        expect: impl Fn(&C, Variant) -> [f64; 4],
        error: impl Fn(&C, [f64; 4], [f64; 4]) -> f64,
        observe: impl FnOnce(&Session) -> Result<Vec<[f64; 4]>, DriveError>,
    ) -> Result<(), DriveError> {
        let measured = match self.subject {
            Subject::Driver => observe(&Session::open()?)?,
            Subject::Oracle => cases.iter().map(|case| expect(case, Variant::TRUE)).collect(),
        };
        let before = tally.largest;
        let mut shown = Shown::default();
        for (case, measured) in cases.iter().zip(measured) {
            let expected = expect(case, self.variant);
            let error = error(case, expected, measured);
            tally.add(error, || {
                format!("{scene:?}, {case:?}: expected {expected:?}, measured {measured:?}")
            });
            shown.values.push([expected, measured]);
            shown.errors.push(error);
        }
        if tally.shown.errors.is_empty() || tally.largest > before {
            tally.shown = shown;
        }
        Ok(())
    }
}

/// What was compared together: the comparison with the worst case, to be shown.
#[derive(Clone, Debug, Default)]
pub struct Shown {
    /// Expected and measured, case by case.
    pub values: Vec<[[f64; 4]; 2]>,
    /// Of each case, in the check's unit.
    pub errors: Vec<f64>,
}

/// Counts cases and keeps the worst.
#[derive(Clone, Debug)]
pub struct Tally {
    unit: Unit,
    cases: u64,
    largest: f64,
    worst: String,
    shown: Shown,
}

impl Tally {
    /// Nothing yet.
    pub fn new(unit: Unit) -> Self {
        Self { unit, cases: 0, largest: 0.0, worst: String::new(), shown: Shown::default() }
    }

    /// Takes one case in, with its error in the check's unit.
    pub fn add(&mut self, error: f64, case: impl FnOnce() -> String) {
        self.cases += 1;
        if error > self.largest {
            self.largest = error;
            self.worst = case();
        }
    }

    /// How many cases were taken in.
    pub fn cases(&self) -> u64 {
        self.cases
    }

    /// The largest error, in the check's unit.
    pub fn largest(&self) -> f64 {
        self.largest
    }

    /// The case that had it, and what it was compared with.
    pub fn into_worst(self) -> (String, Shown) {
        (self.worst, self.shown)
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
}
