//! How checks are run: what is measured, with how many cases, and against which oracle.

use super::tally::{ComparedCases, Tally};
use crate::mutation::Variant;
use crate::probe::{Dialect, ProbeError, Session};
use std::fmt::Debug;

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// DetGL, through GL's functions.
    Driver,
    /// The correct oracle. Compared with an oracle that has a mistake, it shows without a driver that
    /// a check can fail.
    Oracle,
}

/// How many cases are tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// A sixteenth, for tests.
    Quick,
    /// As many as each check asks for.
    Full,
    /// Sixteen times as many.
    Thorough,
}

/// How checks are run.
#[derive(Clone, Copy, Debug)]
pub struct Harness {
    /// What is measured.
    pub subject: Subject,
    /// How many cases.
    pub effort: Effort,
    /// The oracle to measure against.
    pub variant: Variant,
}

impl Harness {
    /// The number of cases for a check that asks for `full`.
    pub fn cases(&self, full: usize) -> usize {
        match self.effort {
            Effort::Quick => full.div_ceil(16),
            Effort::Full => full,
            Effort::Thorough => full * 16,
        }
    }

    /// Compares the subject with the oracle over `cases` and tallies the differences.
    ///
    /// `expect` computes a case with the oracle; `observe` computes all cases in order with the driver, in a new
    /// context. Components that a check does not compare are 0 in both.
    ///
    /// # Errors
    /// When the driver reports a GL error or rejects a shader.
    pub fn compare<C: Debug>(
        &self,
        tally: &mut Tally,
        scene: &dyn Debug,
        cases: &[C],
        expect: impl Fn(&C, Variant) -> [f64; 4],
        observe: impl FnOnce(&Session) -> Result<Vec<[f64; 4]>, ProbeError>,
    ) -> Result<(), ProbeError> {
        self.compare_with(Dialect::Compatibility, tally, scene, cases, expect, observe)
    }

    /// As [`Harness::compare`], with the check's own error function, in its unit.
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
        observe: impl FnOnce(&Session) -> Result<Vec<[f64; 4]>, ProbeError>,
    ) -> Result<(), ProbeError> {
        self.compare_in(Dialect::Compatibility, tally, scene, cases, expect, error, observe)
    }

    /// As [`Harness::compare`], in a context of OpenGL 3.3 core or OpenGL ES 3.0.
    ///
    /// # Errors
    /// When the driver reports a GL error or rejects a shader.
    pub fn compare_with<C: Debug>(
        &self,
        dialect: Dialect,
        tally: &mut Tally,
        scene: &dyn Debug,
        cases: &[C],
        expect: impl Fn(&C, Variant) -> [f64; 4],
        observe: impl FnOnce(&Session) -> Result<Vec<[f64; 4]>, ProbeError>,
    ) -> Result<(), ProbeError> {
        let unit = tally.unit();
        let error = |_: &C, expected: [f64; 4], measured: [f64; 4]| {
            let errors = expected.iter().zip(measured).map(|(&e, m)| unit.error(e, m));
            errors.fold(0.0, f64::max)
        };
        self.compare_in(dialect, tally, scene, cases, expect, error, observe)
    }

    #[expect(clippy::too_many_arguments, reason = "the others pass on what they get")]
    fn compare_in<C: Debug>(
        &self,
        dialect: Dialect,
        tally: &mut Tally,
        scene: &dyn Debug,
        cases: &[C],
        expect: impl Fn(&C, Variant) -> [f64; 4],
        error: impl Fn(&C, [f64; 4], [f64; 4]) -> f64,
        observe: impl FnOnce(&Session) -> Result<Vec<[f64; 4]>, ProbeError>,
    ) -> Result<(), ProbeError> {
        let measured = match self.subject {
            Subject::Driver => observe(&Session::open_in(dialect)?)?,
            Subject::Oracle => cases.iter().map(|case| expect(case, Variant::CORRECT)).collect(),
        };
        if measured.len() != cases.len() {
            return Err(ProbeError::Missing { cases: cases.len(), measured: measured.len() });
        }
        tally.digest_values(measured.as_flattened());
        let before = tally.largest();
        let mut compared = ComparedCases::default();
        for (case, measured) in cases.iter().zip(measured) {
            let expected = expect(case, self.variant);
            let error = error(case, expected, measured);
            tally.add(error, || {
                format!("{scene:?}, {case:?}: expected {expected:?}, measured {measured:?}")
            });
            compared.values.push([expected, measured]);
            compared.errors.push(error);
        }
        tally.keep(compared, before);
        Ok(())
    }
}
