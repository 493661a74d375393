//! A line as a rectangle: the coverage of pixels by a smooth line (GL 2.1, section 3.4.2), and which samples one holds
//! (section 3.4.4).

use super::area::{self, Areas};
use crate::desc::LineStipple;
use crate::primitive::rectangle;
use crate::sizes::SUBPIXEL;
use texunit::lanes::{Isa, Kernel, LANES, Simd, U32s, lane_x, lane_y};

/// The stipple of a line, and its phase at the start of the line in subpixels.
pub type Dashes = Option<(LineStipple, u32)>;

/// Whether the stipple draws the point `at` subpixels from the start of a line.
pub fn is_dash(dashes: Dashes, at: u32) -> bool {
    dashes.is_none_or(|(stipple, before)| {
        let fragment = before.wrapping_add(at) / SUBPIXEL as u32;
        stipple.pattern >> (fragment / u32::from(stipple.factor) % 16) & 1 == 1
    })
}

/// A line between two ends, so wide, in pixels.
#[derive(Clone, Copy, Debug)]
pub struct LineRectangle {
    ends: [[f64; 2]; 2],
    width: f64,
    /// From one end to the other.
    direction: [f64; 2],
    length: f64,
    /// Counter-clockwise.
    pub corners: [[f64; 2]; 4],
}

impl LineRectangle {
    /// The line from `a` to `b`.
    pub fn new(a: [f64; 2], b: [f64; 2], width: f64) -> Self {
        let direction = [b[0] - a[0], b[1] - a[1]];
        let length = (direction[0] * direction[0] + direction[1] * direction[1]).sqrt();
        let ends = [a, b];
        Self { ends, width, direction, length, corners: rectangle(ends, width, [0.0, length]) }
    }

    /// The distance of a point from the start, along the line.
    #[inline(always)]
    fn along(&self, point: [f64; 2]) -> f64 {
        let [a, _] = self.ends;
        ((point[0] - a[0]) * self.direction[0] + (point[1] - a[1]) * self.direction[1])
            / self.length
    }

    /// Adds the area that the line covers of each pixel of the block from `first` on: of the pieces one pixel long that
    /// its stipple draws.
    pub fn add(&self, isa: Isa, dashes: Dashes, first: [f64; 2], areas: &mut Areas) {
        if dashes.is_none() {
            area::add_polygon_areas(isa, &self.corners, first, areas);
            return;
        }
        let (x, y) = (first[0], first[1]);
        let at = [[x, y], [x + 8.0, y], [x, y + 8.0], [x + 8.0, y + 8.0]].map(|p| self.along(p));
        let low = at.into_iter().fold(self.length, f64::min).max(0.0).floor() as u32;
        let high = at.into_iter().fold(0.0, f64::max).min(self.length).ceil() as u32;
        let mut piece = low;
        while piece < high {
            let begin = piece;
            while piece < high && is_dash(dashes, piece * SUBPIXEL as u32) {
                piece += 1;
            }
            if begin < piece {
                let part = [f64::from(begin), f64::from(piece)];
                area::add_polygon_areas(isa, &rectangle(self.ends, self.width, part), first, areas);
            } else {
                piece += 1;
            }
        }
    }

    /// The lanes of the block from pixel `first` on whose centres the line holds, where its stipple draws it.
    pub fn centers(&self, isa: Isa, dashes: Dashes, first: [i32; 2]) -> u64 {
        let covered = isa.run(SamplesCovered { band: self, first: first.map(f64::from) });
        if dashes.is_none() {
            return covered;
        }
        let mut left = covered;
        let mut lanes = 0;
        while left != 0 {
            let lane = left.trailing_zeros() as usize;
            left &= left - 1;
            let at = self.along(center(first.map(f64::from), lane));
            lanes |= u64::from(is_dash(dashes, (at * f64::from(SUBPIXEL)) as u32)) << lane;
        }
        lanes
    }
}

/// The centre of a pixel of the block from `first` on.
#[inline(always)]
fn center(first: [f64; 2], lane: usize) -> [f64; 2] {
    [first[0] + lane_x(lane) as f64 + 0.5, first[1] + lane_y(lane) as f64 + 0.5]
}

/// The lanes whose centres a line holds. Of its sides those of its start and on its right do not belong to the next.
struct SamplesCovered<'a> {
    band: &'a LineRectangle,
    first: [f64; 2],
}

impl Kernel for SamplesCovered<'_> {
    type Output = u64;
    #[inline(always)]
    fn run<S: Simd>(self) -> u64 {
        let Self { band, first } = self;
        let ([a, _], direction, half) = (band.ends, band.direction, 0.5 * band.width);
        let mut covered = U32s::ZERO;
        for lane in 0..LANES {
            let point = center(first, lane);
            let p = [point[0] - a[0], point[1] - a[1]];
            let along = (p[0] * direction[0] + p[1] * direction[1]) / band.length;
            let across = (direction[0] * p[1] - direction[1] * p[0]) / band.length;
            let inside =
                (along >= 0.0) & (along < band.length) & (across >= -half) & (across < half);
            covered[lane] = u32::from(inside);
        }
        S::nonzero(&covered)
    }
}
