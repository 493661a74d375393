//! The scan of round footprints: two rows of two texels each, which are those of a bilinear filter.
//!
//! The rows are those of [`super::rows`] for a length of one texel, without slope and without least weight; so are the
//! weights. Products of weights and bytes, and sums of four of them, are integers below 2^24, which `f32` holds exactly.

use super::fixed_point::to_large_fixed;
use super::footprint::LaneFootprint;
use crate::format::convert::byte_of;
use crate::lanes::math::{clamp, min};
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s, WEIGHT_ONE};
use crate::sample::fetch::split_threes;
use crate::sample::level_view::LevelView;
use crate::sample::wrap::{Axis, repeated};
use crate::sampler::Wrap;

/// Whether rows or columns are scanned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Across {
    Rows,
    Columns,
}

/// 2×2 texels in the order (0, 0), (1, 0), (0, 1), (1, 1), and their weights in units of 2^-14.
#[derive(Clone, Debug, Default)]
pub struct RoundQuad {
    words: [U32s; 4],
    weights: [F32s; 4],
}

/// From a weighted sum of bytes to a fraction, as in `level::mean_of_bytes` for rows of the length one.
const FACTOR: f32 = (1.0 + 2.0 * f32::EPSILON) / (255 * WEIGHT_ONE) as f32;

impl RoundQuad {
    /// The mean of a channel, 0 to 1.
    #[inline(always)]
    pub fn mean(&self, lane: usize, channel: usize) -> f32 {
        let Self { words, weights } = self;
        let part = |corner: usize| byte_of(words[corner][lane], channel) * weights[corner][lane];
        min(((part(0) + part(1)) + (part(2) + part(3))) * FACTOR, 1.0)
    }
}

/// The largest slope that moves no position: a quarter of its unit.
const NO_SLOPE: f32 = 1.0 / (1 << 18) as f32;
/// The largest `a²` that makes no row longer: the root of 1 more than it is an eighth of a weight's unit above 1.
const NO_EXCESS: f32 = 1.0 / (1 << 16) as f32;

/// Whether the rows of a footprint on a level are one texel long, without slope and without least weight: the numbers
/// that [`super::rows::Rows`] would compute round to these. No level has more texels than the base level, which bounds
/// the length; the first row is less than one from the middle, so that its shift is at most the slope.
#[inline(always)]
pub fn is_round(view: &LevelView<'_>, of: &LaneFootprint) -> bool {
    if of.excess > NO_EXCESS || of.min_weight != 0 {
        return false;
    }
    // The slope on the level, compared without a division.
    let base = view.texture.scale;
    let [s, t] = [0, 1].map(|axis| view.axis(axis).scale);
    let (more, less) = match of.along_t {
        true => (s * base[1], t * base[0]),
        false => (t * base[0], s * base[1]),
    };
    of.slope.abs() * more <= NO_SLOPE * less
}

/// Loads the texels about each point and computes their weights. `false` if a lane reads across an edge of the level, or
/// for texels and wrap modes that only the general scan supports.
#[inline(always)]
pub fn load_round<S: Simd>(
    view: &LevelView<'_>,
    at: [&F32s; 3],
    across: Across,
    out: &mut RoundQuad,
) -> bool {
    S::outlined(LoadRound { view, at, across, out })
}

struct LoadRound<'a> {
    view: &'a LevelView<'a>,
    at: [&'a F32s; 3],
    across: Across,
    out: &'a mut RoundQuad,
}

impl Kernel for LoadRound<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<S: Simd>(self) -> bool {
        let Self { view, at: [s, t, _], across, out } = self;
        let level = view.level;
        let (bytes, row) = (level.format.bytes(), level.row_bytes() as u32);
        if bytes < 3 {
            return false;
        }
        let lines = [(s, view.axis(0), bytes as u32), (t, view.axis(1), row)];
        let [along, across_line] = match across {
            Across::Rows => [lines[1], lines[0]],
            Across::Columns => lines,
        };
        let mut offsets = U32s::ZERO;
        let RoundQuad { words, weights: [first, right, upper, last] } = out;
        let weights = match across {
            Across::Rows => [first, right, upper, last],
            Across::Columns => [first, upper, right, last],
        };
        let origin = level.origin() as u32;
        let lines = [along, across_line];
        let is_inside = match (along.1.wrap, across_line.1.wrap) {
            (Wrap::Repeat, Wrap::Repeat) => {
                let sizes = lines.map(|(_, axis, _)| axis.size as f32);
                let texels = |line: usize, x| repeated::<S>(x, sizes[line]);
                positions::<S>(lines, texels, origin, &mut offsets, weights)
            }
            (Wrap::ClampToEdge, Wrap::ClampToEdge) => {
                let axes = lines.map(|(_, axis, _)| axis);
                let texels = |line: usize, x: f32| texels_within(&axes[line], x);
                positions::<S>(lines, texels, origin, &mut offsets, weights)
            }
            (_, _) => false,
        };
        if !is_inside {
            return false;
        }
        S::gather_quads(&level.texels, &offsets, row, words);
        if bytes == 3 {
            let [a, b, c, d] = words.each_mut();
            split_threes([a, b]);
            split_threes([c, d]);
        }
        true
    }
}

/// The coordinate in texels of a wrap mode that does not repeat. Beyond the edges only that it is there counts.
#[inline(always)]
fn texels_within(axis: &Axis, x: f32) -> f32 {
    let texels = x * axis.scale;
    let number = if texels.is_nan() { 0.0 } else { texels };
    clamp(number, -1.0, axis.size as f32 + 1.0)
}

/// Byte offsets of the first texels, and the weights: of both texels of the first row, then of the second. Each line is
/// a coordinate, its axis and the bytes from texel to texel, that along the scan first.
#[inline(always)]
fn positions<S: Simd>(
    [(along, along_axis, along_bytes), (across, across_axis, across_bytes)]: [(&F32s, Axis, u32);
        2],
    texels: impl Fn(usize, f32) -> f32,
    origin: u32,
    offsets: &mut U32s,
    [a, b, c, d]: [&mut F32s; 4],
) -> bool {
    let [mut last_row, mut last_texel] = [0; 2];
    for lane in 0..LANES {
        let low = to_large_fixed::<S>(texels(0, along[lane]), WEIGHT_ONE) - (WEIGHT_ONE >> 1);
        let position = to_large_fixed::<S>(texels(1, across[lane]), 1 << 16) - (1 << 15) + 2;
        // As unsigned numbers, negative ones are the largest.
        let (j, i) = ((low >> 14) as u32, (position >> 16) as u32);
        last_row = if j > last_row { j } else { last_row };
        last_texel = if i > last_texel { i } else { last_texel };
        offsets[lane] = j
            .wrapping_mul(along_bytes)
            .wrapping_add(i.wrapping_mul(across_bytes).wrapping_add(origin));
        let upper = low & (WEIGHT_ONE - 1);
        let lower = WEIGHT_ONE - upper;
        let fraction = position >> 2 & (WEIGHT_ONE - 1);
        let [second, fourth] = [(fraction * lower) >> 14, (fraction * upper) >> 14];
        a[lane] = (lower - second) as f32;
        b[lane] = second as f32;
        c[lane] = (upper - fourth) as f32;
        d[lane] = fourth as f32;
    }
    last_row < along_axis.size - 1 && last_texel < across_axis.size - 1
}
