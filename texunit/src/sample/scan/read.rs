//! The mean of a level's rows: in integers where texels are bytes, else in `f32`.
//!
//! As with the other filters there is a general way and a short one (`plain`), which read the same
//! texels with the same weights and give the same bits.

use super::Scan;
use super::rows::{ONE, Rows};
use crate::lanes::math::{floor_small, min};
use crate::lanes::{F32s, I32s, LANES, Simd, Sums, U32s};
use crate::plan::Way;
use crate::sample::fetch;
use crate::sample::filter::Place;
use crate::sample::plain::{Class, neighbours, of_texel};
use crate::sample::record::Recorder;
use crate::sample::wrap::Indices;
use crate::trace::SampleStep;

/// Samples one level in the lanes that ask for it (a mask). Only the stored channels of `out` are
/// written.
#[inline(always)]
pub fn level<S: Simd>(
    place: &Place<'_>,
    at: [&F32s; 3],
    scan: &Scan,
    asks: &U32s,
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let mut rows = Rows::new::<S>(place, at, scan, asks);
    match place.texture.way {
        Way::Plain(Class::Bytes) => bytes::<S>(place, &mut rows, out),
        Way::Plain(class @ (Class::Srgb | Class::Halves | Class::Floats)) => {
            words::<S>(place, class, &mut rows, out);
        }
        Way::Blocks(_) | Way::General => general::<S>(place, &mut rows, asks, out, recorder),
    }
}

/// Any texels.
#[inline(always)]
fn general<S: Simd>(
    place: &Place<'_>,
    rows: &mut Rows,
    asks: &U32s,
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let channels = place.texture.format.channels();
    let is_bytes = Class::of(place.texture.format) == Some(Class::Bytes);
    let mut means = Means::ZERO;
    let mut sums = [I32s::ZERO; 4];
    recorder.note(|lane| SampleStep::Rows {
        rows: rows.count[lane],
        length: rows.total[lane] as f32 / ONE as f32,
    });
    while rows.number < rows.most {
        let weights = rows.weights();
        recorder.only(|lane| asks[lane] != 0 && rows.number < rows.count[lane]);
        recorder.note(|lane| SampleStep::Row {
            number: rows.number,
            weights: halves(weights[lane]).map(|weight| weight / rows.total[lane] as f32),
        });
        let [left, right] = rows.texels(place).map(|texel| indices(place, &texel));
        let slice = place.slice();
        let mut texels = [[F32s::ZERO; 4]; 2];
        let [first, second] = &mut texels;
        fetch::texels::<S>(place, [&left[0], &left[1], &slice], first, recorder);
        fetch::texels::<S>(place, [&right[0], &right[1], &slice], second, recorder);
        recorder.only(|lane| asks[lane] != 0);
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

/// A texel as the general fetch takes it.
#[inline(always)]
fn indices(place: &Place<'_>, texel: &[U32s; 2]) -> [Indices; 2] {
    let border = place.level.border;
    let along = |axis: usize| {
        let mut out = Indices { index: U32s::ZERO, outside: U32s::ZERO };
        for lane in 0..LANES {
            out.index[lane] = texel[axis][lane] + border[axis];
        }
        out
    };
    [along(0), along(1)]
}

/// Both weights of a row, in units of 2^-14.
#[inline(always)]
fn halves(weights: u32) -> [f32; 2] {
    [(weights & 0xFFFF) as i32 as f32, (weights >> 16) as i32 as f32]
}

/// Sums of what is not bytes.
struct Means([F32s; 4]);

impl Means {
    const ZERO: Self = Self([F32s::ZERO; 4]);

    /// A row. One without weight is not there: its inf and NaN do not matter.
    #[inline(always)]
    fn add(&mut self, channels: usize, weights: &U32s, texels: [&[F32s; 4]; 2]) {
        for channel in 0..channels {
            let sum = &mut self.0[channel];
            for lane in 0..LANES {
                let [left, right] = halves(weights[lane]);
                let row = left * texels[0][channel][lane] + right * texels[1][channel][lane];
                let next = sum[lane] + row;
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

/// Bytes where they lie.
#[inline(always)]
fn bytes<S: Simd>(place: &Place<'_>, rows: &mut Rows, out: &mut [F32s; 4]) {
    let level = place.level;
    let apart = level.format.bytes() as u32;
    let mut sums = Sums::ZERO;
    let mut walk = Walk::new::<S>(place, rows);
    while rows.number < rows.most {
        let weights = rows.weights();
        match &walk {
            Walk::Pairs { .. } if apart > 2 => {
                let offsets = walk.left(rows, place);
                S::weigh_pairs(&level.texels, &offsets, apart, &weights, &mut sums);
            }
            Walk::Pairs { .. } => {
                let [left, right] = neighbours::<S>(level, &walk.left(rows, place));
                S::weigh(&left, &right, &weights, &mut sums);
            }
            Walk::Inside { .. } | Walk::Wrapped => {
                let [left, right] = walk.both(rows, place);
                let left = S::gather(&level.texels, &left);
                let right = S::gather(&level.texels, &right);
                S::weigh(&left, &right, &weights, &mut sums);
            }
        }
        rows.advance();
        walk.advance();
    }
    let channels = level.format.channels();
    let mut planes = [I32s::ZERO; 4];
    for (byte, plane) in planes.iter_mut().enumerate().take(channels) {
        *plane = sums.of_byte(byte);
    }
    mean_of_bytes(rows, channels, &planes, out);
}

/// Other channels in words.
#[inline(always)]
fn words<S: Simd>(place: &Place<'_>, class: Class, rows: &mut Rows, out: &mut [F32s; 4]) {
    let level = place.level;
    let channels = level.format.channels();
    let mut means = Means::ZERO;
    let mut walk = Walk::new::<S>(place, rows);
    while rows.number < rows.most {
        let weights = rows.weights();
        let offsets = walk.both(rows, place);
        let mut texels = [[F32s::ZERO; 4]; 2];
        for (texel, offsets) in texels.iter_mut().zip(&offsets) {
            for word in 0..level.format.words() {
                let mut at = *offsets;
                for lane in 0..LANES {
                    at[lane] = at[lane].wrapping_add(4 * word as u32);
                }
                of_texel::<S>(class, channels, word, &S::gather(&level.texels, &at), texel);
            }
        }
        means.add(channels, &weights, [&texels[0], &texels[1]]);
        rows.advance();
        walk.advance();
    }
    means.divide(rows, channels, out);
}

/// How byte offsets follow one another from row to row.
#[expect(clippy::large_enum_variant, reason = "lives on one call's stack, where a box costs more")]
enum Walk {
    /// Rows within the level, whose two texels lie side by side.
    Pairs {
        /// Where the row begins.
        line: U32s,
        /// From row to row.
        along: u32,
    },
    /// Within the level, along either axis.
    Inside {
        /// Where the row or column begins.
        line: U32s,
        /// To the next one.
        along: U32s,
        /// From texel to texel within it.
        across: U32s,
    },
    /// Anywhere.
    Wrapped,
}

impl Walk {
    #[inline(always)]
    fn new<S: Simd>(place: &Place<'_>, rows: &Rows) -> Self {
        if !rows.are_inside::<S>(place) {
            return Self::Wrapped;
        }
        let level = place.level;
        let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
        let origin = level.origin() as u32;
        let mut line = U32s::ZERO;
        let mut turned = U32s::ZERO;
        for lane in 0..LANES {
            turned[lane] = !rows.along_t[lane];
        }
        if !S::any(&turned) {
            for lane in 0..LANES {
                line[lane] = (rows.along[lane] as u32).wrapping_mul(row) + origin;
            }
            return Self::Pairs { line, along: row };
        }
        let (mut along, mut across) = (U32s::ZERO, U32s::ZERO);
        for lane in 0..LANES {
            along[lane] = if turned[lane] != 0 { bytes } else { row };
            across[lane] = if turned[lane] != 0 { row } else { bytes };
            line[lane] = (rows.along[lane] as u32).wrapping_mul(along[lane]) + origin;
        }
        Self::Inside { line, along, across }
    }

    /// The offsets of the left texels of rows.
    #[inline(always)]
    fn left(&self, rows: &Rows, place: &Place<'_>) -> U32s {
        let mut out = U32s::ZERO;
        match self {
            Self::Pairs { line, .. } => {
                let bytes = place.level.format.bytes() as u32;
                for lane in 0..LANES {
                    let column = (rows.across[lane] >> 16) as u32;
                    out[lane] = line[lane].wrapping_add(column.wrapping_mul(bytes));
                }
            }
            Self::Inside { line, across, .. } => {
                for lane in 0..LANES {
                    let number = (rows.across[lane] >> 16) as u32;
                    out[lane] = line[lane].wrapping_add(number.wrapping_mul(across[lane]));
                }
            }
            Self::Wrapped => {}
        }
        out
    }

    /// The offsets of both texels.
    #[inline(always)]
    fn both(&self, rows: &Rows, place: &Place<'_>) -> [U32s; 2] {
        let level = place.level;
        let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
        let mut out = [U32s::ZERO; 2];
        match self {
            Self::Pairs { .. } => {
                out[0] = self.left(rows, place);
                for lane in 0..LANES {
                    out[1][lane] = out[0][lane].wrapping_add(bytes);
                }
            }
            Self::Inside { across, .. } => {
                out[0] = self.left(rows, place);
                for lane in 0..LANES {
                    out[1][lane] = out[0][lane].wrapping_add(across[lane]);
                }
            }
            Self::Wrapped => {
                let origin = level.origin() as u32;
                for (out, [x, y]) in out.iter_mut().zip(&rows.texels(place)) {
                    for lane in 0..LANES {
                        let line = y[lane].wrapping_mul(row) + origin;
                        out[lane] = x[lane].wrapping_mul(bytes).wrapping_add(line);
                    }
                }
            }
        }
        out
    }

    /// On to the next row.
    #[inline(always)]
    fn advance(&mut self) {
        match self {
            Self::Pairs { line, along } => {
                for lane in 0..LANES {
                    line[lane] = line[lane].wrapping_add(*along);
                }
            }
            Self::Inside { line, along, .. } => {
                for lane in 0..LANES {
                    line[lane] = line[lane].wrapping_add(along[lane]);
                }
            }
            Self::Wrapped => {}
        }
    }
}
