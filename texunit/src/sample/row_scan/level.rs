//! The weighted mean of the rows of one level: in integers where texels are bytes, else in `f32`.
//!
//! As with the other filters there is a general path, and fast paths that read the same texels with the same weights and
//! give the same bits.

use super::footprint::RowScan;
use super::rows::Rows;
use crate::kernels::LookupKernel;
use crate::lanes::math::{floor_small, min};
use crate::lanes::{F32s, I32s, LANES, SecondTexel, Simd, Sums, U32s, WEIGHT_ONE};
use crate::plan::{TexelClass, TexelPath};
use crate::sample::fast::{channels_of_texel, word_offsets};
use crate::sample::fetch;
use crate::sample::level_view::LevelView;
use crate::sample::recorder::Recorder;
use crate::sample::wrap::Indices;
use crate::trace::SampleStep;

/// Samples one level in the lanes of a mask. Only the stored channels of `out` are
/// written.
#[inline(always)]
pub fn level<S: Simd>(
    view: &LevelView<'_>,
    at: [&F32s; 3],
    scan: &RowScan,
    mask: &U32s,
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let mut rows = Rows::new::<S>(view, at, scan, mask);
    match view.texture.texel_path {
        TexelPath::Words(TexelClass::Bytes) => {
            LookupKernel::RowsOfBytes.note();
            bytes::<S>(view, &mut rows, out);
        }
        TexelPath::Words(
            class @ (TexelClass::Srgb
            | TexelClass::Halves
            | TexelClass::Floats
            | TexelClass::Depth { .. }),
        ) => {
            LookupKernel::RowsOfWords.note();
            words::<S>(view, class, &mut rows, out);
        }
        TexelPath::Blocks(_) => {
            LookupKernel::RowsOfBlocks.note();
            blocks::<S>(view, &mut rows, out);
        }
        TexelPath::General | TexelPath::ComparedWords(_) | TexelPath::ScatteredWords(_) => {
            LookupKernel::RowsOfAny.note();
            general::<S>(view, &mut rows, mask, out, recorder)
        }
    }
}

/// Any texels.
#[inline(always)]
fn general<S: Simd>(
    view: &LevelView<'_>,
    rows: &mut Rows,
    mask: &U32s,
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let channels = view.texture.format.channels();
    let is_bytes = TexelClass::of(view.texture.format) == Some(TexelClass::Bytes);
    let mut means = Means::ZERO;
    let mut sums = [I32s::ZERO; 4];
    recorder.record(|lane| SampleStep::Rows {
        rows: rows.count[lane],
        length: rows.total[lane] as f32 / WEIGHT_ONE as f32,
    });
    while rows.number < rows.max_count {
        let weights = rows.weights();
        recorder.restrict_to(|lane| mask[lane] != 0 && rows.number < rows.count[lane]);
        recorder.record(|lane| SampleStep::Row {
            number: rows.number,
            weights: halves(weights[lane]).map(|weight| weight / rows.total[lane] as f32),
        });
        let [left, right] = rows.texels(view).map(|texel| indices(view, &texel));
        let slice = view.slice();
        let mut texels = [[F32s::ZERO; 4]; 2];
        let [first, second] = &mut texels;
        fetch::texels::<S>(view, [&left[0], &left[1], &slice], first, recorder);
        fetch::texels::<S>(view, [&right[0], &right[1], &slice], second, recorder);
        recorder.restrict_to(|lane| mask[lane] != 0);
        if is_bytes {
            for channel in 0..channels {
                for lane in 0..LANES {
                    let byte = |c: f32| floor_small(c * 255.0 + 0.5).0;
                    let (low, high) = (weights[lane] & 0xFFFF, weights[lane] >> 16);
                    let (a, b) = (byte(first[channel][lane]), byte(second[channel][lane]));
                    sums[channel][lane] += a * low as i32 + b * high as i32;
                }
            }
        } else {
            means.add(channels, &weights, [first, second]);
        }
        rows.advance();
    }
    if is_bytes {
        mean_of_bytes(rows, channels, &sums, out);
    } else {
        means.divide(rows, channels, out);
    }
}

/// The texel that the general fetch reads.
#[inline(always)]
fn indices(view: &LevelView<'_>, texel: &[U32s; 2]) -> [Indices; 2] {
    let border = view.level.border;
    let along = |index: &U32s, border: u32| {
        let mut out = Indices { index: U32s::ZERO, outside: U32s::ZERO };
        for lane in 0..LANES {
            out.index[lane] = index[lane] + border;
        }
        out
    };
    [along(&texel[0], border[0]), along(&texel[1], border[1])]
}

/// Both weights of a row, in units of 2^-14.
#[inline(always)]
fn halves(weights: u32) -> [f32; 2] {
    [(weights & 0xFFFF) as i32 as f32, (weights >> 16) as i32 as f32]
}

/// Weighted sums of `f32` channels.
struct Means([F32s; 4]);

impl Means {
    const ZERO: Self = Self([F32s::ZERO; 4]);

    /// Adds a row. Inf and NaN of a row without weight have no effect.
    #[inline(always)]
    fn add(&mut self, channels: usize, weights: &U32s, [first, second]: [&[F32s; 4]; 2]) {
        let (mut left, mut right) = (F32s::ZERO, F32s::ZERO);
        for lane in 0..LANES {
            [left[lane], right[lane]] = halves(weights[lane]);
        }
        let pairs = first.iter().zip(second);
        for (sum, (first, second)) in self.0.iter_mut().zip(pairs).take(channels) {
            for lane in 0..LANES {
                let (a, b) = (first[lane], second[lane]);
                let next = sum[lane] + (left[lane] * a + right[lane] * b);
                sum[lane] = if weights[lane] != 0 { next } else { sum[lane] };
            }
        }
    }

    #[inline(always)]
    fn divide(&self, rows: &Rows, channels: usize, out: &mut [F32s; 4]) {
        for (sum, out) in self.0.iter().zip(out).take(channels) {
            for lane in 0..LANES {
                out[lane] = sum[lane] / rows.total[lane] as f32;
            }
        }
    }
}

/// From sums of bytes to fractions of 255. The factor is a little more than the reciprocal, so that
/// nothing but ones gives exactly 1.
#[inline(always)]
fn mean_of_bytes(rows: &Rows, channels: usize, sums: &[I32s; 4], out: &mut [F32s; 4]) {
    let mut factor = F32s::ZERO;
    for lane in 0..LANES {
        factor[lane] = (1.0 + 2.0 * f32::EPSILON) / (255 * rows.total[lane]) as f32;
    }
    for (sum, out) in sums.iter().zip(out).take(channels) {
        for lane in 0..LANES {
            out[lane] = min(sum[lane] as f32 * factor[lane], 1.0);
        }
    }
}

/// Texels of bytes.
#[inline(always)]
fn bytes<S: Simd>(view: &LevelView<'_>, rows: &mut Rows, out: &mut [F32s; 4]) {
    let level = view.level;
    let texel_bytes = level.format.bytes() as u32;
    let mut sums = Sums::ZERO;
    match LineAddresses::new::<S>(view, rows) {
        Some(LineAddresses { start, stride, across }) => {
            let second =
                across.as_ref().map_or(SecondTexel::Adjacent(texel_bytes), SecondTexel::Stride);
            S::weigh_rows(&level.texels, &rows.walk(&start, &stride, second), &mut sums);
        }
        None => wrapped::<S>(view, rows, &mut sums),
    }
    let channels = level.format.channels();
    let mut planes = [I32s::ZERO; 4];
    for (byte, plane) in planes.iter_mut().enumerate().take(channels) {
        *plane = sums.of_byte(byte);
    }
    mean_of_bytes(rows, channels, &planes, out);
}

/// Texels of bytes, where some rows cross an edge of the level.
#[inline(always)]
fn wrapped<S: Simd>(view: &LevelView<'_>, rows: &mut Rows, sums: &mut Sums) {
    let level = view.level;
    let texel_bytes = level.format.bytes() as u32;
    while rows.number < rows.max_count {
        let weights = rows.weights();
        let [left, right] = offsets(view, rows);
        let mut not_adjacent = U32s::ZERO;
        for lane in 0..LANES {
            not_adjacent[lane] = right[lane].wrapping_sub(left[lane]) ^ texel_bytes;
        }
        // Most rows do not cross an edge.
        if texel_bytes > 2 && !S::any(&not_adjacent) {
            S::weigh_pairs(&level.texels, &left, texel_bytes, &weights, sums);
        } else {
            let left = S::gather(&level.texels, &left);
            let right = S::gather(&level.texels, &right);
            S::weigh(&left, &right, &weights, sums);
        }
        rows.advance();
    }
}

/// Byte offsets of the two texels of a row.
#[inline(always)]
fn offsets(view: &LevelView<'_>, rows: &Rows) -> [U32s; 2] {
    let level = view.level;
    let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
    let origin = level.origin() as u32;
    let mut out = [U32s::ZERO; 2];
    for (out, [x, y]) in out.iter_mut().zip(&rows.texels(view)) {
        for lane in 0..LANES {
            let line = y[lane].wrapping_mul(row) + origin;
            out[lane] = x[lane].wrapping_mul(bytes).wrapping_add(line);
        }
    }
    out
}

/// Texels of other fast classes.
#[inline(always)]
fn words<S: Simd>(view: &LevelView<'_>, class: TexelClass, rows: &mut Rows, out: &mut [F32s; 4]) {
    let level = view.level;
    let channels = level.format.channels();
    let mut means = Means::ZERO;
    while rows.number < rows.max_count {
        let weights = rows.weights();
        let offsets = offsets(view, rows);
        let mut texels = [[F32s::ZERO; 4]; 2];
        for (texel, offsets) in texels.iter_mut().zip(&offsets) {
            let mut word = 0;
            while word + 1 < level.format.words() {
                let two = S::gather_pairs(&level.texels, &word_offsets(offsets, word));
                channels_of_texel::<S>(class, channels, word, &two[0], texel);
                channels_of_texel::<S>(class, channels, word + 1, &two[1], texel);
                word += 2;
            }
            if word < level.format.words() {
                let one = S::gather(&level.texels, &word_offsets(offsets, word));
                channels_of_texel::<S>(class, channels, word, &one, texel);
            }
        }
        means.add(channels, &weights, [&texels[0], &texels[1]]);
        rows.advance();
    }
    means.divide(rows, channels, out);
}

/// Compressed texels.
#[inline(always)]
fn blocks<S: Simd>(view: &LevelView<'_>, rows: &mut Rows, out: &mut [F32s; 4]) {
    let channels = view.level.format.channels();
    let mut means = Means::ZERO;
    while rows.number < rows.max_count {
        let mut texels = [[F32s::ZERO; 4]; 2];
        for (texel, [x, y]) in texels.iter_mut().zip(&rows.texels(view)) {
            view.level.fetch_stored::<S>([x, y, &U32s::ZERO], texel);
        }
        means.add(channels, &rows.weights(), [&texels[0], &texels[1]]);
        rows.advance();
    }
    means.divide(rows, channels, out);
}

/// Byte offsets and strides of rows (or columns) that lie inside the level.
struct LineAddresses {
    /// Byte offset of the first row.
    start: U32s,
    /// Bytes from one to the next.
    stride: U32s,
    /// Bytes from texel to texel, unless all lanes have rows.
    across: Option<U32s>,
}

impl LineAddresses {
    /// `None` where some line crosses the edge.
    #[inline(always)]
    fn new<S: Simd>(view: &LevelView<'_>, rows: &Rows) -> Option<Self> {
        // The smallest levels are shorter than one read.
        if view.level.texels.len() < 8 || !rows.are_inside::<S>(view) {
            return None;
        }
        let level = view.level;
        let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
        let origin = level.origin() as u32;
        let (mut start, mut stride, mut across) = (U32s::ZERO, U32s::ZERO, U32s::ZERO);
        let mut columns = U32s::ZERO;
        for lane in 0..LANES {
            columns[lane] = !rows.along_t[lane];
            stride[lane] = if columns[lane] != 0 { bytes } else { row };
            across[lane] = if columns[lane] != 0 { row } else { bytes };
            start[lane] = (rows.along[lane] as u32).wrapping_mul(stride[lane]).wrapping_add(origin);
        }
        Some(Self { start, stride, across: S::any(&columns).then_some(across) })
    }
}
