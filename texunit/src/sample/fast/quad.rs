//! The 2×2 texels of one word each that a linear filter weighs.

use super::offsets::word_offsets;
use super::quad_position::{PairPosition, quad_position};
use crate::image::Level;
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s};
use crate::sample::fetch::{neighbours, split_threes};
use crate::sample::level_view::LevelView;
use crate::sample::wrap::repeated;
use crate::sampler::Wrap;

/// 2×2 texels of one word each, in the order (0, 0), (1, 0), (0, 1), (1, 1).
#[derive(Clone, Debug, Default)]
pub struct TexelQuad {
    pub words: [U32s; 4],
    /// The weights of the right and of the upper texels.
    pub weights: [F32s; 2],
    /// Byte offsets of the first texels. Valid after [`QuadLoad::Inside`].
    offsets: U32s,
}

/// Whether texel addresses of a lookup are computed or reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Addresses {
    /// Computed from the coordinates.
    Compute,
    /// Those of the lookup before in the same [`LookupScratch`](crate::sample::LookupScratch), which had the same points,
    /// offset and level of detail, and a plan that
    /// [shares addresses](crate::plan::SamplePlan::shares_addresses_with).
    Reuse,
}

/// Whether the fast path loaded the texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QuadLoad {
    /// The fast path does not apply: a lane reads the border or another face.
    NotApplicable,
    /// Loaded; some quads wrap around an edge of the level.
    AcrossEdge,
    /// Loaded; all quads lie inside the level, and the addresses can be reused.
    Inside,
}

/// Loads the 2×2 texels about each point, of one word each.
///
/// Outlined, and with the result in memory of the caller: as a local that several branches assign, LLVM would copy it
/// once or twice.
#[inline(always)]
pub fn load_quad<S: Simd>(
    view: &LevelView<'_>,
    at: [&F32s; 3],
    addresses: Addresses,
    out: &mut TexelQuad,
) -> QuadLoad {
    S::outlined(LoadQuad { view, at, addresses, out })
}

struct LoadQuad<'a> {
    view: &'a LevelView<'a>,
    at: [&'a F32s; 3],
    addresses: Addresses,
    out: &'a mut TexelQuad,
}

impl Kernel for LoadQuad<'_> {
    type Output = QuadLoad;

    #[inline(always)]
    fn run<S: Simd>(self) -> QuadLoad {
        let Self { view, at, addresses, out } = self;
        let level = view.level;
        let bytes = level.format.bytes();
        let is_inside = match addresses {
            Addresses::Reuse => true,
            Addresses::Compute => {
                bytes >= 3 && inside_offsets::<S>(view, at, &mut out.offsets, &mut out.weights)
            }
        };
        if is_inside {
            let row = level.row_bytes() as u32;
            level.texels.gather_quads::<S>(&out.offsets, row, &mut out.words);
            if bytes == 3 {
                let [a, b, c, d] = out.words.each_mut();
                split_threes([a, b]);
                split_threes([c, d]);
            }
            return QuadLoad::Inside;
        }
        let Some(position) = quad_position::<S>(view, at) else { return QuadLoad::NotApplicable };
        let corners = position.corners(view);
        out.weights = position.weights;
        out.words = if position.pairs[0] == PairPosition::Inside {
            let [a, b] = neighbours::<S>(level, &corners[0]);
            let [c, d] = neighbours::<S>(level, &corners[2]);
            [a, b, c, d]
        } else {
            gather_words::<S>(view, &corners, 0)
        };
        QuadLoad::AcrossEdge
    }
}

/// Byte offsets of the lower left texels, and the weights of the right and of the upper texels. `false` if a quad
/// crosses an edge of the level, or the wrap modes are not both `Repeat`, `ClampToEdge` or `Clamp`.
///
/// One loop: several loops would spill their intermediate values where an instruction set has few registers.
#[inline(always)]
fn inside_offsets<S: Simd>(
    view: &LevelView<'_>,
    [s, t, _]: [&F32s; 3],
    offsets: &mut U32s,
    weights: &mut [F32s; 2],
) -> bool {
    let axes @ [across, up] = [view.axis(0), view.axis(1)];
    match (across.wrap, up.wrap) {
        (Wrap::Repeat, Wrap::Repeat) => {
            let sizes = [across.size as f32, up.size as f32];
            let wrapped = |axis: usize, x| repeated::<S>(x, sizes[axis]);
            inside_offsets_by::<S>(view.level, [s, t], wrapped, offsets, weights)
        }
        (Wrap::ClampToEdge, Wrap::ClampToEdge) => {
            let wrapped = |axis: usize, x| axes[axis].clamped_to_edge(x);
            inside_offsets_by::<S>(view.level, [s, t], wrapped, offsets, weights)
        }
        // That of seamless cubes, too.
        (Wrap::Clamp, Wrap::Clamp) => {
            let wrapped = |axis: usize, x| axes[axis].clamped(x);
            inside_offsets_by::<S>(view.level, [s, t], wrapped, offsets, weights)
        }
        (_, _) => false,
    }
}

/// [`inside_offsets`] with the wrapped coordinate in texels, by axis.
#[inline(always)]
fn inside_offsets_by<S: Simd>(
    level: &Level,
    [s, t]: [&F32s; 2],
    wrapped: impl Fn(usize, f32) -> f32,
    offsets: &mut U32s,
    [alpha, beta]: &mut [F32s; 2],
) -> bool {
    let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
    let origin = level.origin() as u32;
    let [mut column, mut line] = [0; 2];
    for lane in 0..LANES {
        let (u, v) = (wrapped(0, s[lane]) - 0.5, wrapped(1, t[lane]) - 0.5);
        let ((i, left), (j, below)) = (S::floor_small(u), S::floor_small(v));
        alpha[lane] = u - left;
        beta[lane] = v - below;
        // As an unsigned number, -1 is the largest.
        let (i, j) = (i as u32, j as u32);
        column = if i > column { i } else { column };
        line = if j > line { j } else { line };
        offsets[lane] =
            j.wrapping_mul(row).wrapping_add(i.wrapping_mul(bytes).wrapping_add(origin));
    }
    column < level.width - 1 && line < level.height - 1
}

/// A word of each of four texels.
#[inline(always)]
pub fn gather_words<S: Simd>(view: &LevelView<'_>, corners: &[U32s; 4], word: usize) -> [U32s; 4] {
    let texels = &view.level.texels;
    [
        texels.gather::<S>(&word_offsets(&corners[0], word)),
        texels.gather::<S>(&word_offsets(&corners[1], word)),
        texels.gather::<S>(&word_offsets(&corners[2], word)),
        texels.gather::<S>(&word_offsets(&corners[3], word)),
    ]
}
