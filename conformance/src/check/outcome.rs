//! What a check found.

use super::bench::Shown;
use serde::Serialize;

/// What an error is measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Unit {
    /// Of the range of a colour, depth or datum: 1 is all of it.
    FullScale,
    /// Steps of an 8-bit colour: 1/255.
    Bytes,
    /// Texels of the level.
    Texels,
    /// Levels of detail: λ.
    Levels,
    /// Times that a pixel is drawn.
    Draws,
    /// Units in the last place of the expected value as an `f32`.
    Ulp,
    /// Integers as they are stored or returned.
    Codes,
}

impl Unit {
    /// How far a measured value is from an expected one. A NaN is infinitely wrong, but where a NaN
    /// is expected in ULP.
    pub fn error(self, expected: f64, measured: f64) -> f64 {
        let error = match self {
            Self::Bytes => 255.0 * (expected - measured).abs(),
            Self::Ulp => return ulps(expected, measured),
            Self::FullScale | Self::Texels | Self::Levels | Self::Draws | Self::Codes => {
                (expected - measured).abs()
            }
        };
        if error.is_nan() { f64::INFINITY } else { error }
    }

    /// As it stands behind a number.
    pub fn label(self) -> &'static str {
        match self {
            Self::FullScale => "of range",
            Self::Bytes => "/255",
            Self::Texels => "texels",
            Self::Levels => "levels",
            Self::Draws => "draws",
            Self::Ulp => "ULP",
            Self::Codes => "codes",
        }
    }
}

/// The distance in units in the last place of `expected`, as an `f32` has them; those of denormals
/// are all alike. What rounds to infinity is expected to be infinite.
fn ulps(expected: f64, measured: f64) -> f64 {
    if expected.is_nan() || measured.is_nan() {
        return if expected.is_nan() && measured.is_nan() { 0.0 } else { f64::INFINITY };
    }
    let rounded = f64::from(expected as f32);
    if rounded.is_infinite() || measured.is_infinite() {
        return if rounded == f64::from(measured as f32) { 0.0 } else { f64::INFINITY };
    }
    let exponent = if expected == 0.0 { -126.0 } else { expected.abs().log2().floor().max(-126.0) };
    (expected - measured).abs() / (exponent - 23.0).exp2()
}

/// How a check ended.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Every error is within the tolerance.
    Pass,
    /// Some error is not.
    Fail,
    /// It could not be measured; says why.
    Broken(String),
}

/// What a check found.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// The check's name.
    pub name: &'static str,
    /// Where the formula stands.
    pub citation: &'static str,
    /// What was checked.
    pub what: &'static str,
    /// How many cases were compared.
    pub cases: u64,
    /// The largest error.
    pub largest_error: f64,
    /// What errors are measured in.
    pub unit: Unit,
    /// The largest error that passes.
    pub tolerance: f64,
    /// Why the tolerance is what it is.
    pub why: &'static str,
    /// The case with the largest error, what was expected and what came; empty without an error.
    pub worst: String,
    /// How long it took.
    pub seconds: f64,
    /// How it ended.
    pub verdict: Verdict,
    /// The comparison with the worst case.
    #[serde(skip)]
    pub shown: Shown,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_in_the_last_place() {
        let table = [
            (1.0, 1.0 + 2f64.powi(-23), 1.0),
            (1.999, 1.999 + 2f64.powi(-24), 0.5),
            (0.0, 2f64.powi(-149), 1.0),
            (1e39, f64::INFINITY, 0.0),
            (f64::NAN, f64::NAN, 0.0),
            (f64::NAN, 1.0, f64::INFINITY),
            (f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY),
        ];
        for (expected, measured, error) in table {
            let got = Unit::Ulp.error(expected, measured);
            assert!((got - error).abs() < 1e-6 || got == error, "{expected} {measured}: {got}");
        }
    }
}
