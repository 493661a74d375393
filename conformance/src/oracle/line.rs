//! Lines (section 3.4): the diamond-exit rule, widths, stipples, antialiasing, and what is interpolated along them.

use super::polygon::shared_area;
use crate::mutation::{Mutation, Variant};

/// A segment in window coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the words say it")]
pub struct Segment {
    pub from: [f64; 2],
    pub to: [f64; 2],
}

/// How close to a tie a comparison may come.
const TIE: f64 = 1e-7;

impl Segment {
    fn along(&self) -> [f64; 2] {
        [self.to[0] - self.from[0], self.to[1] - self.from[1]]
    }

    /// Whether the slope is at most 1.
    pub fn is_x_major(&self) -> bool {
        let [x, y] = self.along().map(f64::abs);
        x >= y
    }

    /// The least distance |x| + |y| of the segment from a point. It is convex along the segment, and linear between
    /// the places where it has the point's column or row.
    fn diamond_distance(&self, centre: [f64; 2]) -> f64 {
        let d = self.along();
        let crossing = |i: usize| {
            if d[i] == 0.0 { 0.0 } else { ((centre[i] - self.from[i]) / d[i]).clamp(0.0, 1.0) }
        };
        let at =
            |t: f64| -> f64 { (0..2).map(|i| (self.from[i] + t * d[i] - centre[i]).abs()).sum() };
        [0.0, 1.0, crossing(0), crossing(1)].into_iter().map(at).fold(f64::INFINITY, f64::min)
    }

    /// Whether the segment exits the diamond of a pixel; `None` on a tie.
    pub fn exits(&self, [x, y]: [i64; 2], variant: Variant) -> Option<bool> {
        let centre = [x as f64 + 0.5, y as f64 + 0.5];
        let half = if variant.has(Mutation::DiamondIsPixel) { 1.0 } else { 0.5 };
        let end = (self.to[0] - centre[0]).abs() + (self.to[1] - centre[1]).abs();
        let near = self.diamond_distance(centre);
        if (end - half).abs() < TIE || (near - half).abs() < TIE {
            return None;
        }
        Some(near < half && (end > half || variant.has(Mutation::LastPixelDrawn)))
    }

    /// Whether the segment exits the diamond of a pixel, ties included: both ends are moved by (-ε, -ε²) (section 3.4.1).
    /// Coordinates are multiples of 1/256 below 256. In units of 2^-48 pixels ε is 2^20 and ε² is 1: small enough, as
    /// without it distances that differ do so by more than 2^-23 pixels, and large enough to be exact.
    pub fn exits_perturbed(&self, [x, y]: [i64; 2], variant: Variant) -> bool {
        const ONE: i128 = 1 << 48;
        let sign = if variant.has(Mutation::TiesMovedUp) { 1 } else { -1 };
        let moved = |[x, y]: [f64; 2]| {
            let exact = |c: f64| (c * 256.0) as i128 * (ONE / 256);
            [exact(x) + sign * (1 << 20), exact(y) + sign]
        };
        let (a, b) = (moved(self.from), moved(self.to));
        let centre = [x, y].map(|c| i128::from(c) * ONE + ONE / 2);
        let d = [b[0] - a[0], b[1] - a[1]];
        // |x| + |y| from the centre at the share n/m of the segment, times m; it is convex, and linear between these.
        let distance = |(n, m): (i128, i128)| -> (i128, i128) {
            ((0..2).map(|i| ((a[i] - centre[i]) * m + d[i] * n).abs()).sum(), m)
        };
        let crossing = |i: usize| {
            let (n, m) = ((centre[i] - a[i]) * d[i].signum(), d[i].abs());
            if m == 0 { (0, 1) } else { (n.clamp(0, m), m) }
        };
        let is_inside = |(sum, m): (i128, i128)| 2 * sum < ONE * m;
        let touches = [(0, 1), (1, 1), crossing(0), crossing(1)].map(distance).map(is_inside);
        touches.contains(&true) && !is_inside(distance((1, 1)))
    }

    /// Whether the aliased line of this width covers a pixel; `None` on a tie.
    pub fn covers(&self, pixel: [i64; 2], width: f64, variant: Variant) -> Option<bool> {
        let rounded = width.round().max(1.0);
        // Columns of pixels for lines along x, rows for lines along y.
        let minor = usize::from(self.is_x_major() != variant.has(Mutation::WidthAlongLine));
        let shift =
            if variant.has(Mutation::WidthNotCentred) { 0.0 } else { (rounded - 1.0) / 2.0 };
        let mut moved = *self;
        moved.from[minor] -= shift;
        moved.to[minor] -= shift;
        for k in 0..rounded as i64 {
            let mut at = pixel;
            at[minor] -= k;
            if moved.exits(at, variant)? {
                return Some(true);
            }
        }
        Some(false)
    }

    /// The pixels of the aliased line of width 1 in the order in which it is drawn; `None` if one is on a tie.
    pub fn fragments(&self, size: [usize; 2], variant: Variant) -> Option<Vec<[i64; 2]>> {
        let mut found = Vec::new();
        for y in 0..size[1] as i64 {
            for x in 0..size[0] as i64 {
                if self.exits([x, y], variant)? {
                    found.push([x, y]);
                }
            }
        }
        let d = self.along();
        let major = usize::from(!self.is_x_major());
        found.sort_by_key(|pixel| if d[major] > 0.0 { pixel[major] } else { -pixel[major] });
        Some(found)
    }

    /// How far along the segment the centre of a pixel lies, equation 3.6.
    pub fn parameter(&self, [x, y]: [usize; 2]) -> f64 {
        let d = self.along();
        let p = [x as f64 + 0.5 - self.from[0], y as f64 + 0.5 - self.from[1]];
        (p[0] * d[0] + p[1] * d[1]) / (d[0] * d[0] + d[1] * d[1])
    }

    /// The rectangle of the antialiased line.
    pub fn rectangle(&self, width: f64, variant: Variant) -> [[f64; 2]; 4] {
        let d = self.along();
        let length = d[0].hypot(d[1]);
        let (u, n) = (d.map(|c| c / length), [-d[1] / length, d[0] / length]);
        let half = width / if variant.has(Mutation::DiameterIsRadius) { 1.0 } else { 2.0 };
        let over = if variant.has(Mutation::LineEndsRound) { half } else { 0.0 };
        let corner = |end: [f64; 2], along: f64, aside: f64| {
            [0, 1].map(|i| end[i] + u[i] * along * over + n[i] * aside * half)
        };
        [
            corner(self.from, -1.0, -1.0),
            corner(self.to, 1.0, -1.0),
            corner(self.to, 1.0, 1.0),
            corner(self.from, -1.0, 1.0),
        ]
    }

    /// The part of a pixel that the antialiased line covers.
    pub fn area(&self, pixel: [usize; 2], width: f64, variant: Variant) -> f64 {
        shared_area(&self.rectangle(width, variant), pixel)
    }
}

/// `glLineStipple`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GL's names")]
pub struct LineStipple {
    pub factor: u32,
    pub pattern: u16,
}

impl LineStipple {
    /// Whether the fragment with this number is drawn.
    pub fn draws(&self, number: usize, variant: Variant) -> bool {
        let factor = if variant.has(Mutation::StippleFactorIgnored) { 1 } else { self.factor };
        let bit = number / factor as usize % 16;
        let bit = if variant.has(Mutation::StippleReversed) { 15 - bit } else { bit };
        self.pattern >> bit & 1 == 1
    }
}

/// A value along a segment, of clip w at its ends, with perspective.
pub fn along(t: f64, values: [f64; 2], w: [f64; 2], variant: Variant) -> f64 {
    if variant.has(Mutation::Affine) {
        return (1.0 - t) * values[0] + t * values[1];
    }
    let [a, b] = [(1.0 - t) / w[0], t / w[1]];
    (a * values[0] + b * values[1]) / (a + b)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn the_diamond_of_the_end_is_not_exited() {
        let line = Segment { from: [0.5, 0.5], to: [3.5, 0.6] };
        let x: Vec<i64> = (0..5).filter(|&x| line.exits([x, 0], TRUE) == Some(true)).collect();
        assert_eq!(x, [0, 1, 2]);
        assert_eq!(line.fragments([8, 2], TRUE), Some(vec![[0, 0], [1, 0], [2, 0]]));
        // It ends beyond the diamond of the last pixel, but within the pixel.
        let longer = Segment { to: [3.96, 0.7], ..line };
        assert_eq!(longer.exits([3, 0], TRUE), Some(true));
    }

    #[test]
    fn ties_go_down_and_to_the_left() {
        let of = |from: [f64; 2], to: [f64; 2]| {
            let line = Segment { from, to };
            let all = (0..4).flat_map(|y| (0..4).map(move |x| [x, y]));
            all.filter(|&pixel| line.exits_perturbed(pixel, TRUE)).collect::<Vec<_>>()
        };
        // Between two rows: the lower; between two columns: the left.
        assert_eq!(of([0.5, 2.0], [2.5, 2.0]), [[0, 1], [1, 1]]);
        assert_eq!(of([2.0, 0.5], [2.0, 2.5]), [[1, 0], [1, 1]]);
        // To the left by ε raises a line of positive slope by more than ε² lowers it.
        assert_eq!(of([0.0, 1.0], [2.0, 3.0]), [[0, 1], [1, 2]]);
    }

    #[test]
    fn a_width_of_three_is_one_to_each_side() {
        let line = Segment { from: [0.5, 4.5], to: [7.5, 4.6] };
        let y: Vec<i64> =
            (0..9).filter(|&y| line.covers([3, y], 3.0, TRUE) == Some(true)).collect();
        assert_eq!(y, [3, 4, 5]);
    }

    #[test]
    fn a_stipple_by_hand() {
        let stipple = LineStipple { factor: 2, pattern: 0b101 };
        let drawn: Vec<bool> = (0..7).map(|s| stipple.draws(s, TRUE)).collect();
        assert_eq!(drawn, [true, true, false, false, true, true, false]);
    }

    #[test]
    fn halfway_in_space_is_a_third_on_the_screen() {
        assert!((along(1.0 / 3.0, [0.0, 1.0], [2.0, 1.0], TRUE) - 0.5).abs() < 1e-12);
    }

    #[test]
    fn the_area_of_a_level_line() {
        let line = Segment { from: [0.5, 1.0], to: [2.5, 1.0] };
        let areas: Vec<f64> = (0..3).map(|x| line.area([x, 0], 1.0, TRUE)).collect();
        assert_eq!(areas, [0.25, 0.5, 0.25]);
    }
}
