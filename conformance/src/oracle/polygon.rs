//! Polygons (section 3.5): the area that they share with a pixel, stipple, depth offset, facing and modes.

use crate::mutation::{Mutation, Variant};

/// The area that a convex polygon, in either order, shares with a pixel: the polygon cut by the four sides.
pub fn shared_area(corners: &[[f64; 2]], pixel: [usize; 2]) -> f64 {
    let mut left = corners.to_vec();
    for axis in 0..2 {
        for (side, sign) in [(pixel[axis] as f64, 1.0), (pixel[axis] as f64 + 1.0, -1.0)] {
            left = cut(&left, |p| sign * (p[axis] - side));
        }
    }
    signed_area(&left).abs()
}

/// The part of a convex polygon where a linear function is not negative.
fn cut(corners: &[[f64; 2]], inside: impl Fn([f64; 2]) -> f64) -> Vec<[f64; 2]> {
    let mut kept = Vec::new();
    for (k, &a) in corners.iter().enumerate() {
        let b = corners[(k + 1) % corners.len()];
        let (da, db) = (inside(a), inside(b));
        if da >= 0.0 {
            kept.push(a);
        }
        if (da < 0.0) != (db < 0.0) {
            let t = da / (da - db);
            kept.push([0, 1].map(|i| a[i] + t * (b[i] - a[i])));
        }
    }
    kept
}

/// Whether a convex polygon, counter-clockwise, has a place; `None` within `margin` of its outline.
pub fn inside_convex(corners: &[[f64; 2]], [x, y]: [f64; 2], margin: f64) -> Option<bool> {
    let mut least = f64::INFINITY;
    for (k, a) in corners.iter().enumerate() {
        let b = corners[(k + 1) % corners.len()];
        let d = [b[0] - a[0], b[1] - a[1]];
        let side = d[0] * (y - a[1]) - d[1] * (x - a[0]);
        least = least.min(side / d[0].hypot(d[1]));
    }
    (least.abs() > margin).then_some(least > 0.0)
}

/// The signed area, equation 2.6 of section 2.14.1: positive if counter-clockwise.
pub fn signed_area(corners: &[[f64; 2]]) -> f64 {
    let next = |k: usize| corners[(k + 1) % corners.len()];
    let cross = |(k, a): (usize, &[f64; 2])| a[0] * next(k)[1] - next(k)[0] * a[1];
    corners.iter().enumerate().map(cross).sum::<f64>() / 2.0
}

/// `glPolygonStipple`: rows of 32 bits from the lowest, the most significant bit at the left.
#[derive(Clone, Copy, Debug)]
pub struct PolygonStipple(pub [u32; 32]);

impl PolygonStipple {
    /// Whether a fragment of window coordinates is drawn.
    pub fn draws(&self, [x, y]: [usize; 2], variant: Variant) -> bool {
        let row = if variant.has(Mutation::StippleRowsFromTop) { 31 - y % 32 } else { y % 32 };
        let bit = if variant.has(Mutation::StippleReversed) { x % 32 } else { 31 - x % 32 };
        self.0[row] >> bit & 1 == 1
    }
}

/// ∂z/∂x and ∂z/∂y of the plane through three window positions, equation 3.11.
pub fn slopes([a, b, c]: [[f64; 3]; 3]) -> [f64; 2] {
    let edge = |p: [f64; 3]| [0, 1, 2].map(|i| p[i] - a[i]);
    let (u, v) = (edge(b), edge(c));
    let area = u[0] * v[1] - u[1] * v[0];
    [(u[2] * v[1] - v[2] * u[1]) / area, (u[0] * v[2] - v[0] * u[2]) / area]
}

/// The least and the largest `m` that section 3.5.5 allows: the larger slope, and the root of the sum of squares.
pub fn steepness(slopes: [f64; 2], variant: Variant) -> [f64; 2] {
    let [x, y] = slopes.map(f64::abs);
    if variant.has(Mutation::SlopeOfX) { [x, x] } else { [x.max(y), x.hypot(y)] }
}

/// The least resolvable difference `r` of a buffer whose depths are fixed-point numbers of so many bits, or
/// floats whose largest in the polygon is `z`.
pub fn resolvable(bits: Option<u32>, z: f64) -> f64 {
    match bits {
        Some(bits) => 2f64.powi(-(bits as i32)),
        None => (z.log2().floor() - 23.0).exp2(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn areas_by_hand() {
        let triangle = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
        assert_eq!(signed_area(&triangle), 2.0);
        assert_eq!(shared_area(&triangle, [0, 0]), 1.0);
        assert_eq!(shared_area(&triangle, [1, 0]), 0.5);
        assert_eq!(shared_area(&triangle, [1, 1]), 0.0);
    }

    #[test]
    fn slopes_by_hand() {
        let plane = |x: f64, y: f64| [x, y, 0.25 * x - 0.5 * y + 3.0];
        assert_eq!(slopes([plane(0.0, 1.0), plane(4.0, 2.0), plane(1.0, 7.0)]), [0.25, -0.5]);
        assert_eq!(steepness([3.0, -4.0], Variant::CORRECT), [4.0, 5.0]);
        assert_eq!(resolvable(None, 0.75), 2f64.powi(-24));
    }

    #[test]
    fn the_left_pixel_has_the_highest_bit() {
        let mut rows = [0; 32];
        rows[1] = 1 << 31;
        let stipple = PolygonStipple(rows);
        assert!(stipple.draws([32, 33], Variant::CORRECT));
        assert!(!stipple.draws([31, 1], Variant::CORRECT));
    }
}
