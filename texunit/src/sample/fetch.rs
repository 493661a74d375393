//! Loads texels of a level as channels, with border colour and depth compare.

use super::compare;
use super::level_view::LevelView;
use super::recorder::Recorder;
use super::wrap::Indices;
use crate::format::convert;
use crate::image::Level;
use crate::lanes::{F32s, I32s, Kernel, LANES, Simd, U32s};
use crate::sampler::Compare;
use crate::trace::{SampleStep, TexelSource};

/// One texel in each lane. Only the stored channels of `out` are written.
#[inline(always)]
pub fn texels<S: Simd>(
    view: &LevelView<'_>,
    [x, y, z]: [&Indices; 3],
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    view.level.fetch_stored::<S>([&x.index, &y.index, &z.index], out);
    finish::<S>(view, [x, y, z], out, recorder);
}

/// The two texels of a row with one gather, where they are adjacent in every lane and fit a word each.
#[inline(always)]
pub fn row<S: Simd>(
    view: &LevelView<'_>,
    xs: &[Indices; 2],
    y: &Indices,
    z: &Indices,
    [left, right]: [&mut [F32s; 4]; 2],
    recorder: &mut impl Recorder,
) {
    let level = view.level;
    let bytes = level.format.bytes() as u32;
    let (row, slice) = (level.row_bytes() as u32, level.slice_bytes() as u32);
    let mut offsets = U32s::ZERO;
    for lane in 0..LANES {
        let line = z.index[lane].wrapping_mul(slice).wrapping_add(y.index[lane].wrapping_mul(row));
        offsets[lane] = xs[0].index[lane].wrapping_mul(bytes).wrapping_add(line);
    }
    let [first, second] = neighbours::<S>(level, &offsets);
    S::outlined_unless_wide(Decoded { level, words: [first], out: &mut *left });
    S::outlined_unless_wide(Decoded { level, words: [second], out: &mut *right });
    finish::<S>(view, [&xs[0], y, z], left, recorder);
    finish::<S>(view, [&xs[1], y, z], right, recorder);
}

/// Decodes texels of one word, of any format.
struct Decoded<'a> {
    level: &'a Level,
    words: [U32s; 1],
    out: &'a mut [F32s; 4],
}

impl Kernel for Decoded<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        convert::decode_lanes::<S>(self.level.format, &self.words, self.out);
    }
}

/// Whether texels `i` and `i + 1` both lie inside the row in every lane.
#[inline(always)]
pub fn side_by_side<S: Simd>(i: &I32s, size: u32) -> bool {
    // As an unsigned number, -1 is the largest.
    S::below(i.as_u32(), size - 1)
}

/// The texels at the offsets and the next ones, with one gather. Texels have up to four bytes.
#[inline(always)]
pub fn neighbours<S: Simd>(level: &Level, offsets: &U32s) -> [U32s; 2] {
    let bytes = level.format.bytes();
    if bytes == 4 {
        return level.texels.gather_pairs::<S>(offsets);
    }
    if bytes == 3 {
        let mut pair = S::gather_pairs(&level.texels, offsets);
        split_threes(pair.each_mut());
        return pair;
    }
    let low = S::gather(&level.texels, offsets);
    let mut high = U32s::ZERO;
    let shift = 8 * bytes as u32;
    for lane in 0..LANES {
        high[lane] = low[lane] >> shift;
    }
    [low, high]
}

/// Turns the words at bytes 0 and 4 into the words at bytes 0 and 3: two adjacent texels of three bytes.
#[inline(always)]
pub fn split_threes([low, high]: [&mut U32s; 2]) {
    for lane in 0..LANES {
        high[lane] = low[lane] >> 24 | high[lane] << 8;
    }
}

/// Replaces texels whose index is outside by the border colour, then compares.
#[inline(always)]
fn finish<S: Simd>(
    view: &LevelView<'_>,
    [x, y, z]: [&Indices; 3],
    texels: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let texture = view.texture;
    if texture.reaches_border(view.filter) {
        for (texels, border) in texels.iter_mut().zip(texture.border) {
            for lane in 0..LANES {
                let outside = x.outside[lane] | y.outside[lane] | z.outside[lane] != 0;
                texels[lane] = if outside { border } else { texels[lane] };
            }
        }
    }
    recorder.record(|lane| SampleStep::Texel {
        face: view.face as u32,
        at: [x.index[lane], y.index[lane], z.index[lane]],
        source: match x.outside[lane] | y.outside[lane] | z.outside[lane] {
            0 => TexelSource::Stored,
            _ => TexelSource::Border,
        },
        value: texels.each_ref().map(|channel| channel[lane]),
        compare: texture.compare.map(|op| {
            let (reference, mut passes) = (view.reference, texels[0]);
            S::outlined_unless_wide(Compared { op, reference, texels: &mut passes });
            (op, reference[lane], passes[lane])
        }),
    });
    if let Some(op) = texture.compare {
        S::outlined_unless_wide(Compared { op, reference: view.reference, texels: &mut texels[0] });
    }
}

/// Depth compare with any operator.
struct Compared<'a> {
    op: Compare,
    reference: &'a F32s,
    texels: &'a mut F32s,
}

impl Kernel for Compared<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        compare::compare(self.op, self.reference, self.texels);
    }
}
