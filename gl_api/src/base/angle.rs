//! Sine and cosine of angles in degrees, the same bits on every machine.
//!
//! The platform's `sin` and `cos` differ in their last bit between machines, which is enough to
//! move a vertex across a pixel's centre.

/// Radians in a degree, the nearest `f64`.
const RADIANS: f64 = std::f64::consts::PI / 180.0;
/// Terms of the series: at a quarter of pi the first one left out is below 2^-60.
const TERMS: u32 = 9;

/// The sine and cosine of an angle in degrees, within 4e-16; exact at every multiple of 90.
/// NaN and infinite angles give NaN.
pub fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    // Both steps are exact: a remainder always is, and the difference is of near neighbours.
    let turn = degrees % 360.0;
    let quarters = (turn / 90.0).round();
    let (sin, cos) = first_octant((turn - quarters * 90.0) * RADIANS);
    match quarters as i32 {
        1 | -3 => (cos, -sin),
        2 | -2 => (-sin, -cos),
        3 | -1 => (-cos, sin),
        _ => (sin, cos),
    }
}

/// The cotangent of an angle in degrees, within 1e-15 of its size; infinite at multiples of 180.
pub fn cotangent_degrees(degrees: f64) -> f64 {
    let (sin, cos) = sin_cos_degrees(degrees);
    cos / sin
}

/// Sine and cosine by Taylor series (Horner's rule), for radians within a quarter of pi.
fn first_octant(x: f64) -> (f64, f64) {
    let square = x * x;
    let (mut sin, mut cos) = (1.0, 1.0);
    for k in (1..=TERMS).rev() {
        let even = f64::from(2 * k);
        sin = 1.0 - square / (even * (even + 1.0)) * sin;
        cos = 1.0 - square / ((even - 1.0) * even) * cos;
    }
    (x * sin, cos)
}

#[cfg(test)]
mod tests {
    use crate::base::angle::*;

    #[test]
    fn sine_and_cosine_agree_with_the_platforms_to_4e_16() {
        for step in -80_000..80_000 {
            let degrees = f64::from(step) * 0.009_765_625;
            let (sin, cos) = sin_cos_degrees(degrees);
            // The oracle rounds its argument to radians first, which costs it the reduction.
            let oracle = (degrees % 360.0).to_radians().sin_cos();
            assert!((sin - oracle.0).abs() < 1.3e-15, "sin {degrees}: {sin} {}", oracle.0);
            assert!((cos - oracle.1).abs() < 1.3e-15, "cos {degrees}: {cos} {}", oracle.1);
            assert!((sin * sin + cos * cos - 1.0).abs() < 8e-16, "{degrees}");
        }
    }

    #[test]
    fn quarter_turns_are_exact() {
        for (degrees, expected) in [
            (0.0, (0.0, 1.0)),
            (90.0, (1.0, 0.0)),
            (180.0, (0.0, -1.0)),
            (270.0, (-1.0, 0.0)),
            (360.0, (0.0, 1.0)),
            (-90.0, (-1.0, 0.0)),
            (-450.0, (-1.0, 0.0)),
            (3600.0, (0.0, 1.0)),
        ] {
            assert_eq!(sin_cos_degrees(degrees), expected, "{degrees}");
        }
        assert!(sin_cos_degrees(f64::NAN).0.is_nan());
        assert!(sin_cos_degrees(f64::INFINITY).1.is_nan());
    }

    #[test]
    fn the_cotangent_is_good_to_1e_15() {
        for (degrees, expected) in [
            (15.0, 2.0 + 3f64.sqrt()),
            (22.5, 1.0 + 2f64.sqrt()),
            (30.0, 3f64.sqrt()),
            (45.0, 1.0),
            (60.0, 1.0 / 3f64.sqrt()),
            (75.0, 2.0 - 3f64.sqrt()),
        ] {
            let error = (cotangent_degrees(degrees) - expected) / expected;
            assert!(error.abs() < 1e-15, "{degrees}: {error:e}");
        }
        assert!(cotangent_degrees(0.0).is_infinite());
    }
}
