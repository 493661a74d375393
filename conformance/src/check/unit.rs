//! The units of errors.

use serde::Serialize;

/// The unit of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Unit {
    /// Fractions of the range of a colour, depth or datum.
    FullScale,
    /// Steps of an 8-bit colour: 1/255.
    Bytes,
    /// Texels of the level.
    Texels,
    /// Levels of detail: λ.
    Levels,
    /// How often a pixel is drawn.
    Draws,
    /// Units in the last place of the expected value as an `f32`.
    Ulp,
    /// Integers as they are stored or returned.
    Codes,
}

impl Unit {
    /// The distance of a measured value from the expected one. The distance of a NaN is infinite; in ULP, that of an
    /// expected NaN is 0.
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

    /// The label after a number.
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

/// The distance in units in the last place of `expected` as an `f32`. If `expected` rounds to infinity, only infinity
/// has distance 0.
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
