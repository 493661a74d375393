//! Sine, cosine and tangent of degrees, with the same bits on every machine.
//!
//! Angles are reduced to [-45, 45] degrees exactly, so that multiples of 90 give exact results;
//! the series beyond that are good to 1 ULP of `f64` or so.

/// Sine and cosine of an angle in degrees. NaN where the angle is not finite.
pub(crate) fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    // `%` is exact.
    let reduced = degrees % 360.0;
    let quarter = (reduced / 90.0).round();
    let x = (reduced - quarter * 90.0) * (std::f64::consts::PI / 180.0);
    let (sin, cos) = (sin_series(x), cos_series(x));
    match (quarter as i32).rem_euclid(4) {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// Tangent of an angle in degrees.
pub(crate) fn tan_degrees(degrees: f64) -> f64 {
    let (sin, cos) = sin_cos_degrees(degrees);
    sin / cos
}

/// `x - x^3/3! + x^5/5! …`, for `|x| <= π/4`.
fn sin_series(x: f64) -> f64 {
    let square = x * x;
    // From the smallest term up: 1 - x²/(2·3) · (1 - x²/(4·5) · (…)).
    let mut sum = 1.0;
    for n in (1..=9).rev() {
        let n = f64::from(n);
        sum = 1.0 - square / (2.0 * n * (2.0 * n + 1.0)) * sum;
    }
    x * sum
}

/// `1 - x^2/2! + x^4/4! …`, for `|x| <= π/4`.
fn cos_series(x: f64) -> f64 {
    let square = x * x;
    let mut sum = 1.0;
    for n in (1..=9).rev() {
        let n = f64::from(n);
        sum = 1.0 - square / ((2.0 * n - 1.0) * 2.0 * n) * sum;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarters_are_exact() {
        for (degrees, sin, cos) in
            [(0.0, 0.0, 1.0), (90.0, 1.0, 0.0), (180.0, 0.0, -1.0), (-90.0, -1.0, 0.0)]
        {
            assert_eq!(sin_cos_degrees(degrees), (sin, cos), "{degrees}");
        }
        assert!(sin_cos_degrees(f64::INFINITY).0.is_nan());
    }

    #[test]
    fn agrees_with_the_platform() {
        for tenth in -8000..8000 {
            let degrees = f64::from(tenth) * 0.1;
            let (sin, cos) = sin_cos_degrees(degrees);
            let radians = degrees.to_radians();
            assert!((sin - radians.sin()).abs() < 4e-15, "{degrees}");
            assert!((cos - radians.cos()).abs() < 4e-15, "{degrees}");
        }
    }
}
