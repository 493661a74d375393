//! The rows of one level that lanes scan: positions and weights as integers.
//!
//! Along the footprint a texel is [`WEIGHT_ONE`], 2^14 units, so that the weights of a row fit the halves of a word;
//! across it 2^16. A position is computed once, and advances from row to row by integer additions.

use super::fixed_point::{MAX_ROWS, to_fixed, to_large_fixed};
use super::footprint::RowScan;
use crate::lanes::math::{clamp, min};
use crate::lanes::{F32s, I32s, LANES, RowWalk, SecondTexel, Simd, U32s, WEIGHT_ONE, weights};
use crate::sample::level_view::LevelView;
use crate::sample::wrap::{Axis, mirrored_repeat, modulo};
use crate::sampler::Wrap;

/// Coordinates that do not repeat are clamped to this many texels beyond the edge.
const MARGIN: f32 = 64.0;

/// The maximum slope, in texels across per texel along. Only levels one texel wide would have more.
const MAX_SLOPE: f32 = 2.0;

/// The state of the scan; at first, before the first row.
pub struct Rows {
    /// `!0` where rows are crossed, 0 where columns are.
    pub along_t: U32s,
    /// The row, unwrapped.
    pub along: I32s,
    /// 2^16 times the position in the row: its integer part is the left texel.
    pub across: I32s,
    /// From row to row.
    step: I32s,
    /// From the row's lower end to the footprint's upper end, in units of 2^-14.
    remaining: I32s,
    /// The part of the first row below the footprint's lower end; 0 from the second row on.
    skipped: I32s,
    /// `b` of the lane.
    min_weight: I32s,
    /// How many rows each lane has.
    pub count: U32s,
    /// The sum of all weights.
    pub total: I32s,
    /// The most rows of a lane.
    pub max_count: u32,
    /// Which row is next.
    pub number: u32,
}

/// A coordinate in texels, and whether the image is mirrored there (a mask).
struct Coordinate {
    texels: F32s,
    mirrored: U32s,
}

#[inline(always)]
fn coordinate<S: Simd>(axis: &Axis, s: &F32s) -> Coordinate {
    let n = axis.size as f32;
    let mut out = Coordinate { texels: F32s::ZERO, mirrored: U32s::ZERO };
    match axis.wrap {
        Wrap::Repeat => out.texels = axis.texel_coordinate::<S>(s),
        Wrap::MirroredRepeat => {
            for lane in 0..LANES {
                let (repeated, odd) = mirrored_repeat::<S>(s[lane]);
                out.texels[lane] = repeated * n;
                out.mirrored[lane] = if odd { !0 } else { 0 };
            }
        }
        Wrap::ClampToEdge
        | Wrap::Clamp
        | Wrap::ClampToBorder
        | Wrap::MirrorClamp
        | Wrap::MirrorClampToEdge
        | Wrap::MirrorClampToBorder => {
            for lane in 0..LANES {
                let texels = s[lane] * axis.scale;
                let number = if texels.is_nan() { 0.0 } else { texels };
                out.texels[lane] = clamp(number, -MARGIN, n + MARGIN);
            }
        }
    }
    out
}

impl Rows {
    /// The rows of a level. Lanes outside the mask get the fewest rows.
    #[inline(always)]
    pub fn new<S: Simd>(view: &LevelView<'_>, at: [&F32s; 3], scan: &RowScan, mask: &U32s) -> Self {
        let axes = [view.axis(0), view.axis(1)];
        let (s, t) = (coordinate::<S>(&axes[0], at[0]), coordinate::<S>(&axes[1], at[1]));
        // Texels of this level per texel of the base level.
        let base = view.texture.scale;
        let level_scale = [axes[0].scale / base[0], axes[1].scale / base[1]];
        let aspect = [level_scale[1] / level_scale[0], level_scale[0] / level_scale[1]];
        let mut slope = scan.slope;
        if axes.iter().any(|axis| axis.wrap == Wrap::MirroredRepeat) {
            for lane in 0..LANES {
                let mirrored = s.mirrored[lane] ^ t.mirrored[lane];
                slope[lane] = if mirrored != 0 { -slope[lane] } else { slope[lane] };
            }
        }
        let mut rows = Self {
            along_t: scan.along_t,
            along: I32s::ZERO,
            across: I32s::ZERO,
            step: I32s::ZERO,
            remaining: I32s::ZERO,
            skipped: I32s::ZERO,
            min_weight: scan.min_weight,
            count: U32s::ZERO,
            total: I32s::ZERO,
            max_count: 0,
            number: 0,
        };
        for lane in 0..LANES {
            let along_t = scan.along_t[lane] != 0;
            let (u, v) = (s.texels[lane], t.texels[lane]);
            let (along, across) = if along_t { (v, u) } else { (u, v) };
            let (level_scale, aspect) =
                if along_t { (level_scale[1], aspect[1]) } else { (level_scale[0], aspect[0]) };
            let slope = clamp(slope[lane] * aspect, -MAX_SLOPE, MAX_SLOPE);
            let length =
                min((1.0 + scan.excess[lane] * level_scale * level_scale).sqrt(), MAX_ROWS);
            let length = if mask[lane] != 0 { length } else { 1.0 };

            let total = to_fixed(length, WEIGHT_ONE);
            let middle = to_large_fixed::<S>(along, WEIGHT_ONE);
            let low = middle - (total >> 1);
            let first = low >> 14;
            let skipped = low & (WEIGHT_ONE - 1);
            // From the middle to the first row's.
            let offset = ((first << 14) + WEIGHT_ONE / 2 - middle) as f32 / WEIGHT_ONE as f32;
            let shift = to_fixed(slope * offset, 1 << 16);
            // The centre of texel i is at i + 1/2; half a unit of the weight, to round it.
            let across = to_large_fixed::<S>(across, 1 << 16) + shift - (1 << 15) + 2;
            rows.along[lane] = first;
            rows.across[lane] = across;
            rows.step[lane] = to_fixed(slope, 1 << 16);
            rows.total[lane] = total;
            rows.skipped[lane] = skipped;
            rows.remaining[lane] = total + skipped;
            rows.count[lane] = ((total + skipped + WEIGHT_ONE - 1) >> 14) as u32;
        }
        rows.max_count = S::largest(&rows.count);
        rows
    }

    /// The weights of the left texel and (in the upper half) of the right one in the row that is
    /// next. 0 where the lane has no more rows.
    #[inline(always)]
    pub fn weights(&self) -> U32s {
        let mut out = U32s::ZERO;
        for lane in 0..LANES {
            let (across, remaining) = (self.across[lane], self.remaining[lane]);
            out[lane] = weights(across, remaining, self.skipped[lane], self.min_weight[lane]);
        }
        out
    }

    /// All rows at once, from these bytes on.
    #[inline(always)]
    pub fn walk<'a>(
        &'a self,
        start: &'a U32s,
        stride: &'a U32s,
        second: SecondTexel<'a>,
    ) -> RowWalk<'a> {
        RowWalk {
            start,
            stride,
            second_texel: second,
            position: &self.across,
            step: &self.step,
            remaining: &self.remaining,
            skipped: &self.skipped,
            min_weight: &self.min_weight,
            rows: self.max_count,
        }
    }

    /// On to the next row.
    #[inline(always)]
    pub fn advance(&mut self) {
        for lane in 0..LANES {
            self.along[lane] += 1;
            self.across[lane] += self.step[lane];
            self.remaining[lane] -= WEIGHT_ONE;
        }
        if self.number == 0 {
            self.skipped = I32s::ZERO;
        }
        self.number += 1;
    }

    /// Whether no row of any lane reaches beyond the texels of the level.
    #[inline(always)]
    pub fn are_inside<S: Simd>(&self, view: &LevelView<'_>) -> bool {
        let size = [view.level.width as i32, view.level.height as i32];
        let mut beyond = U32s::ZERO;
        let last = self.max_count as i32 - 1;
        for lane in 0..LANES {
            let along_t = self.along_t[lane] != 0;
            let (along, across) = if along_t { (size[1], size[0]) } else { (size[0], size[1]) };
            let first = self.along[lane];
            let (a, b) =
                (self.across[lane] >> 16, (self.across[lane] + last * self.step[lane]) >> 16);
            let (low, high) = if a < b { (a, b) } else { (b, a) };
            // Negative numbers are those with the topmost bit.
            let bits = first | (along - 1 - last - first) | low | (across - 2 - high);
            beyond[lane] = bits as u32 >> 31;
        }
        !S::any(&beyond)
    }

    /// Column and row of the left and of the right texel, wrapped, without the border's offset.
    #[inline(always)]
    pub fn texels(&self, view: &LevelView<'_>) -> [[U32s; 2]; 2] {
        let axes = [view.axis(0), view.axis(1)];
        let mut left = [I32s::ZERO; 2];
        let mut right = [I32s::ZERO; 2];
        for lane in 0..LANES {
            let along_t = self.along_t[lane] != 0;
            let (j, i) = (self.along[lane], self.across[lane] >> 16);
            left[0][lane] = if along_t { i } else { j };
            left[1][lane] = if along_t { j } else { i };
            right[0][lane] = if along_t { i + 1 } else { j };
            right[1][lane] = if along_t { j } else { i + 1 };
        }
        [
            [wrapped(&axes[0], &left[0]), wrapped(&axes[1], &left[1])],
            [wrapped(&axes[0], &right[0]), wrapped(&axes[1], &right[1])],
        ]
    }
}

/// The wrapped texel of any index within [`MARGIN`] of the image.
#[inline(always)]
fn wrapped(axis: &Axis, index: &I32s) -> U32s {
    let mut out = U32s::ZERO;
    let (size, last) = (axis.size as i32, axis.size as i32 - 1);
    match axis.wrap {
        Wrap::Repeat if axis.size.is_power_of_two() => {
            for lane in 0..LANES {
                out[lane] = (index[lane] & last) as u32;
            }
        }
        Wrap::Repeat => {
            for lane in 0..LANES {
                out[lane] = modulo(index[lane], size) as u32;
            }
        }
        Wrap::MirroredRepeat => {
            for lane in 0..LANES {
                let i = modulo(index[lane], 2 * size);
                out[lane] = if i < size { i } else { 2 * size - 1 - i } as u32;
            }
        }
        Wrap::ClampToEdge
        | Wrap::Clamp
        | Wrap::ClampToBorder
        | Wrap::MirrorClamp
        | Wrap::MirrorClampToEdge
        | Wrap::MirrorClampToBorder => {
            for lane in 0..LANES {
                let low = if index[lane] > 0 { index[lane] } else { 0 };
                out[lane] = if low < last { low } else { last } as u32;
            }
        }
    }
    out
}
