//! The nearest and the linear filter of the fast path.

use super::channels::{channels_of_quad, channels_of_texel, depths_of_texel};
use super::offsets::word_offsets;
use super::quad::{Addresses, QuadLoad, TexelQuad, gather_words, load_quad};
use super::quad_position::quad_position;
use crate::image::Level;
use crate::lanes::math::index;
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s};
use crate::plan::{Alpha, TexelClass};
use crate::sample::compare::compare;
use crate::sample::interpolate::mean;
use crate::sample::level_view::LevelView;
use crate::sample::wrap::Axis;
use crate::sampler::{Compare, Filter};

/// The nearest texel; `false` where the fast path does not apply.
#[inline(always)]
pub fn nearest<S: Simd>(
    view: &LevelView<'_>,
    class: TexelClass,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
) -> bool {
    let Some(offsets) = texel_offsets::<S>(view, at) else { return false };
    let (texels, format) = (&view.level.texels, view.level.format);
    let mut second = U32s::ZERO;
    for word in 0..format.words() {
        let words = match word % 2 {
            0 if word + 1 < format.words() => {
                let pair = S::gather_pairs(texels, &word_offsets(&offsets, word));
                second = pair[1];
                pair[0]
            }
            0 => texels.gather::<S>(&word_offsets(&offsets, word)),
            _ => second,
        };
        channels_of_texel::<S>(class, format.channels(), word, &words, out);
    }
    true
}

/// Byte offsets of the nearest texels; `None` where the fast path does not apply.
#[inline(always)]
fn texel_offsets<S: Simd>(view: &LevelView<'_>, at: [&F32s; 3]) -> Option<U32s> {
    if view.texture.reaches_border(Filter::Nearest) {
        return None;
    }
    let texels = [nearest_along::<S>(view.axis(0), at[0]), nearest_along::<S>(view.axis(1), at[1])];
    Some(byte_offsets(view.level, &texels))
}

/// The nearest texels along an axis, where no border is reached.
#[inline(always)]
pub fn nearest_along<S: Simd>(axis: Axis, at: &F32s) -> U32s {
    let u = axis.texel_coordinate::<S>(at);
    let last = (axis.size - 1) as f32;
    let mut texels = U32s::ZERO;
    for lane in 0..LANES {
        // A coordinate may be rounded up to the size.
        texels[lane] = index(u[lane], last);
    }
    texels
}

/// Byte offsets of texels by column and row.
#[inline(always)]
fn byte_offsets(level: &Level, [x, y]: &[U32s; 2]) -> U32s {
    let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
    let origin = level.origin() as u32;
    let mut offsets = U32s::ZERO;
    for lane in 0..LANES {
        offsets[lane] =
            y[lane].wrapping_mul(row).wrapping_add(x[lane].wrapping_mul(bytes)) + origin;
    }
    offsets
}

/// The nearest texels of one word each; `None` where the fast path does not apply.
#[inline(always)]
pub fn texels<S: Simd>(view: &LevelView<'_>, at: [&F32s; 3]) -> Option<U32s> {
    let offsets = texel_offsets::<S>(view, at)?;
    Some(S::gather_inline(&view.level.texels, &offsets))
}

/// The share of 2×2 depths that pass a comparison; `false` where the fast path does not apply.
pub struct LinearCompared<'a> {
    pub view: &'a LevelView<'a>,
    pub class: TexelClass,
    pub at: [&'a F32s; 3],
    pub op: Compare,
    pub reference: &'a F32s,
    pub out: &'a mut F32s,
}

impl Kernel for LinearCompared<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<S: Simd>(self) -> bool {
        let Self { view, class, at, op, reference, out } = self;
        let mut found = TexelQuad::default();
        let is_one_word = view.level.format.words() == 1;
        if !is_one_word
            || load_quad::<S>(view, at, Addresses::Compute, &mut found) == QuadLoad::NotApplicable
        {
            return false;
        }
        let mut corners = [[F32s::ZERO; 4]; 4];
        for (corner, words) in corners.iter_mut().zip(&found.words) {
            depths_of_texel(class, words, &mut corner[0]);
            compare(op, reference, &mut corner[0]);
        }
        *out = mean(view.level.format, &corners, 0, found.weights.each_ref());
        true
    }
}

/// The weighted mean of 2×2 texels; `false` where the fast path does not apply.
#[inline(always)]
pub fn linear<S: Simd>(
    view: &LevelView<'_>,
    class: TexelClass,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
) -> bool {
    let (words, channels) = (view.level.format.words(), view.level.format.channels());
    if words == 1 {
        let mut found = TexelQuad::default();
        if load_quad::<S>(view, at, Addresses::Compute, &mut found) == QuadLoad::NotApplicable {
            return false;
        }
        let TexelQuad { words, weights, .. } = &found;
        let alpha = view.texture.alpha;
        channels_of_quad::<S>(
            class,
            (channels, alpha),
            0,
            words.each_ref(),
            weights.each_ref(),
            out,
        );
        return true;
    }
    let Some(position) = quad_position::<S>(view, at) else { return false };
    let corners = position.corners(view);
    let level = view.level;
    let weights = position.weights.each_ref();
    let mut word = 0;
    while word + 1 < words {
        let a = S::gather_pairs(&level.texels, &word_offsets(&corners[0], word));
        let b = S::gather_pairs(&level.texels, &word_offsets(&corners[1], word));
        let c = S::gather_pairs(&level.texels, &word_offsets(&corners[2], word));
        let d = S::gather_pairs(&level.texels, &word_offsets(&corners[3], word));
        for half in 0..2 {
            let corners = [&a[half], &b[half], &c[half], &d[half]];
            channels_of_quad::<S>(
                class,
                (channels, Alpha::Stored),
                word + half,
                corners,
                weights,
                out,
            );
        }
        word += 2;
    }
    if word < words {
        let words = gather_words::<S>(view, &corners, word);
        channels_of_quad::<S>(
            class,
            (channels, Alpha::Stored),
            word,
            words.each_ref(),
            weights,
            out,
        );
    }
    true
}
