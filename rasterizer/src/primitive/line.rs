//! Which pixels an aliased line covers: the diamond-exit rule of GL 2.1, section 3.4.1, in exact
//! integers.
//!
//! A fragment is produced for each pixel whose diamond (the points nearer to its centre than half a
//! pixel, in the sum of |dx| and |dy|) the line leaves. Ties are broken as the specification asks: as
//! if both ends were moved by `(-ε, -ε²)`. A line whose slope is at most 1 meets one diamond of each
//! column whose centre it crosses, and elsewhere only a diamond that one of its ends is in. So the
//! fragments are: a run of columns with one row each, with the start's pixel added if the start lies
//! in its diamond, and the end's taken away if the end does.

use crate::sizes::SUBPIXEL;
use std::ops::Range;

const HALF: i32 = SUBPIXEL / 2;

/// The fragments of a line: one or more rows in each of a run of columns (or, for a steep line, the
/// same with the axes exchanged).
#[derive(Clone, Copy, Debug)]
pub struct LineFragments {
    /// The axis along which it runs, 0 for x.
    pub major: usize,
    /// First column.
    pub first: i32,
    /// Last column; below `first` where there are no fragments.
    pub last: i32,
    /// Whether it runs towards smaller columns.
    backward: bool,
    /// A point on it, along the major and the minor axis, in subpixels.
    from: [i64; 2],
    /// The extent along the major (not negative) and the minor axis.
    along: [i64; 2],
}

/// The pixel whose diamond holds a point that is moved by `(-ε, -ε²)`.
fn diamond(p: [i32; 2]) -> Option<[i32; 2]> {
    let pixel = p.map(|v| (v - 1).div_euclid(SUBPIXEL));
    let away = [0, 1].map(|axis| p[axis] - (pixel[axis] * SUBPIXEL + HALF));
    let sum = away[0].abs() + away[1].abs();
    (sum < HALF || (sum == HALF && away[0] > 0)).then_some(pixel)
}

impl LineFragments {
    /// The run of a line from `a` to `b` (in subpixels), `width` pixels wide: wide lines are moved
    /// by half of what they have more than one row, towards the first (section 3.4.2).
    pub fn new(mut a: [i32; 2], mut b: [i32; 2], width: i32) -> Self {
        let direction = [b[0] - a[0], b[1] - a[1]];
        let major = usize::from(direction[1].abs() > direction[0].abs());
        let minor = 1 - major;
        for end in [&mut a, &mut b] {
            end[minor] -= (width - 1) * HALF;
        }
        let (low, high) = (a[major].min(b[major]), a[major].max(b[major]));
        let mut first = (low + HALF - 1).div_euclid(SUBPIXEL);
        let mut last = (high + HALF - 1).div_euclid(SUBPIXEL) - 1;
        if let Some(start) = diamond(a) {
            if start[major] < first {
                first = start[major];
            } else if start[major] > last {
                last = start[major];
            }
        }
        if let Some(end) = diamond(b) {
            if end[major] == last {
                last -= 1;
            } else if end[major] == first {
                first += 1;
            }
        }
        let backward = direction[major] < 0;
        let sign = if backward { -1 } else { 1 };
        Self {
            major,
            first,
            last,
            backward,
            from: [a[major].into(), a[minor].into()],
            along: [i64::from(sign * direction[major]), i64::from(sign * direction[minor])],
        }
    }

    /// How many columns.
    pub fn columns(&self) -> u32 {
        (self.last - self.first + 1).max(0) as u32
    }

    /// How many columns come before this one.
    pub fn index(&self, column: i32) -> u32 {
        if self.backward { (self.last - column) as u32 } else { (column - self.first) as u32 }
    }

    /// Of these columns, the first and the last whose row is one of these.
    pub fn columns_within(&self, columns: [i32; 2], rows: Range<i32>) -> Option<[i32; 2]> {
        let ends = columns.map(|column| self.row(column));
        // VertexPlanes only rise, or only fall, from column to column.
        let (come, gone): (&dyn Fn(i32) -> bool, &dyn Fn(i32) -> bool) = match ends[0] <= ends[1] {
            true => (&|row| row >= rows.start, &|row| row >= rows.end),
            false => (&|row| row < rows.end, &|row| row < rows.start),
        };
        let [first, end] = [come, gone].map(|is_so| self.first_column(columns, is_so));
        (first < end).then_some([first, end - 1])
    }

    /// Of these columns, the first of whose row something is true that is true of all that follow; one past the last
    /// if there is none.
    fn first_column(&self, [first, last]: [i32; 2], is_so: &dyn Fn(i32) -> bool) -> i32 {
        let (mut low, mut high) = (first, last + 1);
        while low < high {
            let middle = low + (high - low) / 2;
            if is_so(self.row(middle)) { high = middle } else { low = middle + 1 }
        }
        low
    }

    /// The first row of a column.
    #[inline]
    pub fn row(&self, column: i32) -> i32 {
        let center = i64::from(column) * i64::from(SUBPIXEL) + i64::from(HALF);
        let [major, minor] = self.along;
        let divisor = major.max(1) * i64::from(SUBPIXEL);
        let over = self.from[1] * major.max(1) + (center - self.from[0]) * minor;
        let row = over.div_euclid(divisor) as i32;
        // Between two rows: a line of positive slope moved to the left is higher there.
        let up = self.major == 0 && minor > 0;
        if over.rem_euclid(divisor) == 0 && !up { row - 1 } else { row }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    /// The diamond-exit rule by its definition, in rational arithmetic over a square of pixels:
    /// coordinates are integers in units of 1/(256 K), so that the perturbation is a real one.
    fn oracle(a: [i32; 2], b: [i32; 2], reach: i32) -> BTreeSet<(i32, i32)> {
        // ε² must stay above zero: ε = 2^-20, ε² = 2^-40 subpixels.
        const ONE: i128 = 1 << 40;
        let shift = |p: [i32; 2]| [i128::from(p[0]) * ONE - (1 << 20), i128::from(p[1]) * ONE - 1];
        let (a, b) = (shift(a), shift(b));
        let mut out = BTreeSet::new();
        for y in -reach..reach {
            for x in -reach..reach {
                let center = [x, y].map(|v| (i128::from(v) * 256 + 128) * ONE);
                let half = 128 * ONE;
                let inside =
                    |p: [i128; 2]| (p[0] - center[0]).abs() + (p[1] - center[1]).abs() < half;
                if inside(b) {
                    continue;
                }
                // The open diamond is four half planes ±x ±y < 1/2; cut the segment's [0, 1].
                // Parameters are fractions over positive denominators.
                let (mut low, mut high) = ((0_i128, 1_i128), (1_i128, 1_i128));
                let mut empty = false;
                for (sx, sy) in [(1, 1), (1, -1), (-1, 1), (-1, -1)] {
                    let f = |p: [i128; 2]| sx * (p[0] - center[0]) + sy * (p[1] - center[1]) - half;
                    let (fa, fb) = (f(a), f(b));
                    // f(t) = fa + t (fb - fa) < 0
                    let d = fb - fa;
                    if d == 0 {
                        empty |= fa >= 0;
                    } else if d > 0 {
                        // t < -fa / d
                        if -fa * high.1 < high.0 * d {
                            high = (-fa, d);
                        }
                    } else if fa * low.1 > low.0 * -d {
                        // t > fa / -d
                        low = (fa, -d);
                    }
                }
                let crosses = low.0 * high.1 < high.0 * low.1;
                if !empty && (crosses || inside(a)) {
                    out.insert((x, y));
                }
            }
        }
        out
    }

    fn pixels(a: [i32; 2], b: [i32; 2], width: i32) -> BTreeSet<(i32, i32)> {
        let run = LineFragments::new(a, b, width);
        let mut out = BTreeSet::new();
        for column in run.first..=run.last {
            for row in run.row(column)..run.row(column) + width {
                let added = out.insert(if run.major == 0 { (column, row) } else { (row, column) });
                assert!(added);
            }
        }
        out
    }

    fn coordinate() -> impl Strategy<Value = i32> {
        prop_oneof![
            -1200..1200i32,
            (-9..9i32).prop_map(|v| v * 128),
            (-18..18i32).prop_map(|v| v * 64)
        ]
    }

    proptest! {
        #[test]
        fn a_line_covers_the_diamonds_it_leaves(
            a in [coordinate(), coordinate()], b in [coordinate(), coordinate()],
        ) {
            prop_assert_eq!(pixels(a, b, 1), oracle(a, b, 7));
        }

        /// Whatever is drawn up to a point and on from there is drawn once.
        #[test]
        fn joined_lines_share_no_pixel_and_leave_no_gap(
            a in [coordinate(), coordinate()], direction in [-5..5i32, -5..5i32], n in 1..60i32, m in 1..60i32,
        ) {
            let at = |k: i32| [a[0] + direction[0] * k * 4, a[1] + direction[1] * k * 4];
            let (first, second) = (pixels(at(0), at(n), 1), pixels(at(n), at(n + m), 1));
            prop_assert!(first.is_disjoint(&second));
            let union: BTreeSet<_> = first.union(&second).copied().collect();
            prop_assert_eq!(union, pixels(at(0), at(n + m), 1));
        }
    }

    #[test]
    fn wide_lines_are_columns_around_the_line() {
        let wide = pixels([128, 640], [1152, 640], 3);
        let want: BTreeSet<_> = (0..4).flat_map(|x| (1..4).map(move |y| (x, y))).collect();
        assert_eq!(wide, want);
        // Two rows: the one below and the one above an integer.
        let two = pixels([128, 512], [1152, 512], 2);
        let want: BTreeSet<_> = (0..4).flat_map(|x| (1..3).map(move |y| (x, y))).collect();
        assert_eq!(two, want);
        assert!(pixels([100, 100], [100, 100], 5).is_empty());
    }
}
