//! The weighted mean of 2×2 texels of each lane's level.

use super::ScatteredLevel;
use super::edges::across_edge;
use super::lane_level::LaneLevel;
use crate::lanes::{F32s, I32s, Kernel, LANES, Simd, U32s};
use crate::plan::{TexelClass, Texture};
use crate::sample::compare::compare;
use crate::sample::fast::{add_offsets, channels_of_quad, channels_of_texel, word_offsets};
use crate::sample::fetch::split_threes;
use crate::sample::seamless;
use crate::sampler::{Seamless, Wrap};

pub struct Linear<'a> {
    pub lanes: &'a ScatteredLevel<'a>,
    pub out: &'a mut [F32s; 4],
}

/// The place of each lane's four texels.
struct Quads {
    /// Column and row of the lower left texel; -1 is beyond the edge.
    first: [I32s; 2],
    /// The weights of the right and of the upper texels.
    weights: [F32s; 2],
    /// Whether all four texels lie inside the face, in every lane.
    are_inside: bool,
}

impl Kernel for Linear<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { lanes, out } = self;
        let quads = lanes.quads::<S>();
        if quads.are_inside && lanes.texture.compare.is_none() {
            lanes.mean_inside::<S>(&quads, out);
        } else {
            S::outlined(MeanAcrossEdges { lanes, quads: &quads, out });
        }
    }
}

impl ScatteredLevel<'_> {
    #[inline(always)]
    fn quads<S: Simd>(&self) -> Quads {
        let Self { texture, level, at, .. } = self;
        let u = level.texel_coordinate::<S>(texture.wrap[0], 0, at[0]);
        let v = level.texel_coordinate::<S>(texture.wrap[1], 1, at[1]);
        let (mut i, mut j) = (I32s::ZERO, I32s::ZERO);
        let (mut alpha, mut beta) = (F32s::ZERO, F32s::ZERO);
        let mut across = U32s::ZERO;
        let [widths, heights] = &level.size;
        for lane in 0..LANES {
            let (x, y) = (u[lane] - 0.5, v[lane] - 0.5);
            let ((column, left), (row, below)) = (S::floor_small(x), S::floor_small(y));
            i[lane] = column;
            j[lane] = row;
            alpha[lane] = x - left;
            beta[lane] = y - below;
            // As an unsigned number, -1 is the largest.
            let is_inside =
                ((column as u32) < widths[lane] - 1) & ((row as u32) < heights[lane] - 1);
            across[lane] = if is_inside { 0 } else { !0 };
        }
        Quads { first: [i, j], weights: [alpha, beta], are_inside: !S::any(&across) }
    }

    #[inline(always)]
    fn mean_inside<S: Simd>(&self, quads: &Quads, out: &mut [F32s; 4]) {
        let Self { texture, class, sources, level, .. } = self;
        let [i, j] = &quads.first;
        let offsets = level.offsets(level.face, [i.as_u32(), j.as_u32()]);
        let (numbers, row) = (level.sources(level.face), level.row());
        let format = texture.format;
        let bytes = format.bytes() as u32;
        let weights = quads.weights.each_ref();
        // The first and second word of the left texel of the lower row, then of the upper row; the same of the right
        // ones. Texels of one word have both in `left`, as neighbours.
        let (mut left, mut right) = ([U32s::ZERO; 4], [U32s::ZERO; 4]);
        let count = format.words();
        for word in 0..count {
            let at = word_offsets(&offsets, word);
            if bytes < 3 {
                let above = add_offsets(&at, &row);
                let lower = S::gather_from(sources, &numbers, &at);
                let upper = S::gather_from(sources, &numbers, &above);
                for lane in 0..LANES {
                    left[0][lane] = lower[lane];
                    left[1][lane] = lower[lane] >> (8 * bytes);
                    left[2][lane] = upper[lane];
                    left[3][lane] = upper[lane] >> (8 * bytes);
                }
            } else if word % 2 == 0 {
                S::gather_quads_from(sources, &numbers, &at, &row, &mut left);
                let next = add_offsets(&at, &U32s::splat(bytes));
                if word + 1 < count {
                    S::gather_quads_from(sources, &numbers, &next, &row, &mut right);
                } else if count > 1 {
                    // Eight bytes from the last word on may be beyond the end.
                    right[0] = S::gather_from(sources, &numbers, &next);
                    right[2] = S::gather_from(sources, &numbers, &add_offsets(&next, &row));
                }
                if bytes == 3 {
                    let [a, b, c, d] = left.each_mut();
                    split_threes([a, b]);
                    split_threes([c, d]);
                }
            }
            let half = word % 2;
            let words = match count {
                1 => [&left[0], &left[1], &left[2], &left[3]],
                _ => [&left[half], &right[half], &left[2 + half], &right[2 + half]],
            };
            S::outlined(QuadMeans { texture, class: *class, word, words, weights, out: &mut *out });
        }
    }
}

/// The means of the channels of a word. Outlined: one copy for quads inside of faces and across edges.
struct QuadMeans<'a> {
    texture: &'a Texture,
    class: TexelClass,
    word: usize,
    words: [&'a U32s; 4],
    weights: [&'a F32s; 2],
    out: &'a mut [F32s; 4],
}

impl Kernel for QuadMeans<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { texture, class, word, words, weights, out } = self;
        let channels = (texture.format.channels(), texture.alpha);
        channels_of_quad::<S>(class, channels, word, words, weights, out);
    }
}

/// The mean where texels are taken one by one: some lie beyond an edge, or are compared.
struct MeanAcrossEdges<'a> {
    lanes: &'a ScatteredLevel<'a>,
    quads: &'a Quads,
    out: &'a mut [F32s; 4],
}

impl Kernel for MeanAcrossEdges<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { lanes, quads, out } = self;
        let ScatteredLevel { texture, class, sources, level, reference, .. } = lanes;
        let format = texture.format;
        let weights = quads.weights.each_ref();
        let (mut numbers, mut offsets) = ([U32s::ZERO; 4], [U32s::ZERO; 4]);
        let mut missing = [U32s::ZERO; 4];
        let mut is_whole = true;
        for corner in 0..4 {
            let [i, j] = &quads.first;
            let step = [corner & 1, corner >> 1];
            if texture.seamless == Seamless::On {
                let found = across_edge(level, i, j, step.map(|step| step as i32));
                is_whole &= !S::any(&found.missing);
                missing[corner] = found.missing;
                numbers[corner] = level.sources(&found.face);
                offsets[corner] = level.offsets(&found.face, [&found.x, &found.y]);
            } else {
                let x = wrapped(level, texture.wrap[0], 0, i, step[0]);
                let y = wrapped(level, texture.wrap[1], 1, j, step[1]);
                numbers[corner] = level.sources(level.face);
                offsets[corner] = level.offsets(level.face, [&x, &y]);
            }
        }
        if is_whole && texture.compare.is_none() {
            let mut words = [U32s::ZERO; 4];
            for word in 0..format.words() {
                for (corner, words) in words.iter_mut().enumerate() {
                    *words = S::gather_from(
                        sources,
                        &numbers[corner],
                        &word_offsets(&offsets[corner], word),
                    );
                }
                let (texture, class, words, out) = (*texture, *class, words.each_ref(), &mut *out);
                S::outlined(QuadMeans { texture, class, word, words, weights, out });
            }
            return;
        }
        let mut corners = [[F32s::ZERO; 4]; 4];
        for (corner, texels) in corners.iter_mut().enumerate() {
            for word in 0..format.words() {
                let words = S::gather_from(
                    sources,
                    &numbers[corner],
                    &word_offsets(&offsets[corner], word),
                );
                channels_of_texel::<S>(*class, format.channels(), word, &words, texels);
            }
            if let Some(op) = texture.compare {
                compare(op, reference, &mut texels[0]);
            }
        }
        seamless::mean_of_corners(format, &mut corners, &missing, weights, out);
    }
}

/// The lower (0) or upper (1) of two texels, whose lower is `i`: across the edge, where there is no other face.
#[inline(always)]
fn wrapped(level: &LaneLevel<'_>, wrap: Wrap, axis: usize, i: &I32s, step: usize) -> U32s {
    let repeats = wrap == Wrap::Repeat;
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        let last = level.size[axis][lane] as i32 - 1;
        let at = i[lane] + step as i32;
        let below = if repeats { last } else { 0 };
        let above = if repeats { 0 } else { last };
        let low = if at < 0 { below } else { at };
        out[lane] = if low > last { above } else { low } as u32;
    }
    out
}
