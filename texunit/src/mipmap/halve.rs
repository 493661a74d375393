//! The box filter of one level, row by row.

use crate::format::convert::{decode_field, encode_channel, signed};
use crate::format::small_float::decode_half;
use crate::format::{Encoding, Field, Format, shared_exponent};
use crate::image::Level;
use crate::lanes::{Kernel, Simd};

/// The texels that one smaller texel covers along an axis, counted from the first that is stored,
/// and their weights; those without weight may lie outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Cover {
    pub first: usize,
    pub weights: [u32; 3],
}

impl Cover {
    /// What each texel of a side of `half` covers of one of `size`, the border's on both ends. A
    /// side that is not halved stays.
    pub fn all(size: u32, half: u32, border: u32) -> Vec<Self> {
        let alone = |first: u32| Self { first: first as usize, weights: [1, 0, 0] };
        let below = (0..border).map(alone);
        let above = (0..border).map(|i| alone(border + size + i));
        let inner = (0..half).map(|i| {
            if half == size {
                return alone(border + i);
            }
            let weights = if size.is_multiple_of(2) { [1, 1, 0] } else { [half - i, half, i + 1] };
            Self { first: (border + 2 * i) as usize, weights }
        });
        below.chain(inner).chain(above).collect()
    }

    fn total(self) -> f64 {
        self.weights.iter().copied().map(f64::from).sum()
    }

    /// The covered texels and their weights.
    pub fn taps(self) -> impl Iterator<Item = (usize, f64)> {
        (self.first..).zip(self.weights.map(f64::from)).filter(|&(_, weight)| weight > 0.0)
    }

    /// Whether one texel is covered.
    fn is_alone(self) -> bool {
        self.weights == [1, 0, 0]
    }

    /// Whether two texels are covered alike.
    fn is_pair(self) -> bool {
        self.weights == [1, 1, 0]
    }
}

/// One level from the larger one.
pub(super) struct Halve<'a> {
    pub from: &'a Level,
    pub to: &'a mut Level,
    pub columns: Vec<Cover>,
    pub rows: Vec<Cover>,
    pub slices: Vec<Cover>,
}

impl Kernel for Halve<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { from, to, columns, rows, slices } = self;
        let format = from.format;
        let channels = format.channels();
        let (row_bytes, slice_bytes) = (from.row_bytes(), from.slice_bytes());
        let pairs = format.is_bytes() && columns.iter().all(|column| column.is_pair());
        let mut sums = vec![0.0; from.stored_size()[0] as usize * channels];
        let mut means = vec![0.0; columns.len() * channels];
        let to_row = to.row_bytes();
        let mut at = 0;
        for slice in slices {
            for &row in &rows {
                let out = &mut to.texels[at..at + to_row];
                at += to_row;
                let texels = |z: usize, y: usize| {
                    &from.texels[z * slice_bytes + y * row_bytes..][..row_bytes]
                };
                if pairs && slice.is_alone() && (row.is_pair() || row.is_alone()) {
                    let lower = texels(slice.first, row.first);
                    // A single row counts twice, which leaves its mean.
                    let second = if row.is_pair() { row.first + 1 } else { row.first };
                    let upper = texels(slice.first, second);
                    match channels {
                        1 => mean_of_pairs::<1, 2>(lower, upper, out),
                        2 => mean_of_pairs::<2, 4>(lower, upper, out),
                        3 => mean_of_pairs::<3, 6>(lower, upper, out),
                        _ => mean_of_pairs::<4, 8>(lower, upper, out),
                    }
                    continue;
                }
                sums.fill(0.0);
                for (z, inward) in slice.taps() {
                    for (y, down) in row.taps() {
                        accumulate(format, texels(z, y), inward * down, &mut sums);
                    }
                }
                let across = slice.total() * row.total();
                match channels {
                    1 => along_row::<1>(&columns, across, &sums, &mut means),
                    2 => along_row::<2>(&columns, across, &sums, &mut means),
                    3 => along_row::<3>(&columns, across, &sums, &mut means),
                    _ => along_row::<4>(&columns, across, &sums, &mut means),
                }
                store(format, &means, out);
            }
        }
    }
}

/// The means of 2×2 texels of byte channels, halves up: what the general path gives. `N` channels,
/// `PAIR` of two texels.
#[inline(always)]
fn mean_of_pairs<const N: usize, const PAIR: usize>(lower: &[u8], upper: &[u8], out: &mut [u8]) {
    let pairs = lower.as_chunks::<PAIR>().0.iter().zip(upper.as_chunks::<PAIR>().0);
    for (out, (lower, upper)) in out.as_chunks_mut::<N>().0.iter_mut().zip(pairs) {
        for c in 0..N {
            let below = u16::from(lower[c]) + u16::from(lower[N + c]);
            let above = u16::from(upper[c]) + u16::from(upper[N + c]);
            out[c] = ((below + above + 2) / 4) as u8;
        }
    }
}

/// Adds the weighted channels of a row: as integers where the format is normalized, in linear
/// light where it is sRGB, else as they are.
#[inline(always)]
fn accumulate(format: Format, texels: &[u8], weight: f64, sums: &mut [f64]) {
    let info = format.info();
    let [first, ..] = info.fields;
    let uniform = info.bytes * 8 == format.channels() * first.bits as usize;
    match (info.encoding, first.bits) {
        (Encoding::Unorm, 8) if uniform => {
            for (sum, &byte) in sums.iter_mut().zip(texels) {
                *sum += weight * f64::from(byte);
            }
        }
        (Encoding::Unorm, 16) if uniform => {
            for (sum, bytes) in sums.iter_mut().zip(texels.as_chunks::<2>().0) {
                *sum += weight * f64::from(u16::from_le_bytes(*bytes));
            }
        }
        (Encoding::Float, 16) => {
            for (sum, bytes) in sums.iter_mut().zip(texels.as_chunks::<2>().0) {
                *sum += weight * f64::from(decode_half(u32::from(u16::from_le_bytes(*bytes))));
            }
        }
        (Encoding::Float, 32) => {
            for (sum, bytes) in sums.iter_mut().zip(texels.as_chunks::<4>().0) {
                *sum += weight * f64::from(f32::from_le_bytes(*bytes));
            }
        }
        (_, _) => {
            let sums = sums.chunks_exact_mut(format.channels());
            for (sums, texel) in sums.zip(texels.chunks_exact(info.bytes)) {
                let words = words(texel);
                for (channel, sum) in sums.iter_mut().enumerate() {
                    *sum += weight * addend(format, channel, words);
                }
            }
        }
    }
}

/// The bytes of a texel as words.
#[inline(always)]
fn words(texel: &[u8]) -> [u32; 4] {
    let mut words = [0; 4];
    for (i, &byte) in texel.iter().enumerate().take(16) {
        words[i / 4] |= u32::from(byte) << (8 * (i % 4));
    }
    words
}

/// What is summed of a channel.
#[inline(always)]
fn addend(format: Format, channel: usize, words: [u32; 4]) -> f64 {
    match integer(format, channel) {
        Some((field, 0)) => f64::from(field.of(words[field.word])),
        Some((field, smallest)) => f64::from(signed(field, words[field.word]).max(smallest)),
        None => f64::from(decode_field(format, channel, words)),
    }
}

/// The field of a channel that is summed as an integer, and the least number it stands for.
#[inline(always)]
fn integer(format: Format, channel: usize) -> Option<(Field, i32)> {
    let info = format.info();
    let field = info.fields[channel];
    match info.encoding {
        Encoding::Srgb if format.is_srgb_channel(channel) => None,
        Encoding::Unorm | Encoding::Srgb => Some((field, 0)),
        Encoding::Snorm => Some((field, -((field.mask() >> 1) as i32))),
        Encoding::Float
        | Encoding::SharedExponent
        | Encoding::Uint
        | Encoding::Sint
        | Encoding::Block(_)
        | Encoding::SrgbBlock(_) => None,
    }
}

/// The means of what the columns cover. `across` is the weight of a whole column of `sums`.
#[inline(always)]
fn along_row<const N: usize>(columns: &[Cover], across: f64, sums: &[f64], means: &mut [f64]) {
    let sums = sums.as_chunks::<N>().0;
    for (column, mean) in columns.iter().zip(means.as_chunks_mut::<N>().0) {
        let mut sum = [0.0; N];
        for (texel, weight) in sums[column.first..].iter().zip(column.weights) {
            // A texel without weight may be inf.
            if weight > 0 {
                for c in 0..N {
                    sum[c] += f64::from(weight) * texel[c];
                }
            }
        }
        let total = across * column.total();
        for c in 0..N {
            mean[c] = sum[c] / total;
        }
    }
}

/// The means as texels.
///
/// A mean of integers is within 2^-53 of itself a quotient of integers below 2^46, so that adding
/// 1/2 and taking the integer part rounds halves up exactly.
#[inline(always)]
fn store(format: Format, means: &[f64], out: &mut [u8]) {
    if format.is_bytes() {
        for (byte, mean) in out.iter_mut().zip(means) {
            *byte = (mean + 0.5) as u8;
        }
        return;
    }
    let bytes = format.bytes();
    for (mean, out) in means.chunks_exact(format.channels()).zip(out.chunks_exact_mut(bytes)) {
        let mut words = [0_u32; 4];
        if format.info().encoding == Encoding::SharedExponent {
            words[0] = shared_exponent::encode(mean[0] as f32, mean[1] as f32, mean[2] as f32);
        }
        for (channel, &mean) in mean.iter().enumerate() {
            let field = format.info().fields[channel];
            words[field.word] |= match integer(format, channel) {
                Some((field, smallest)) => {
                    // Truncation is the floor of what is not negative.
                    let above = (mean - f64::from(smallest) + 0.5) as u32;
                    (above.wrapping_add(smallest as u32) & field.mask()) << field.shift
                }
                None => encode_channel(format, channel, mean as f32),
            };
        }
        for (i, byte) in out.iter_mut().enumerate() {
            *byte = (words[i / 4] >> (8 * (i % 4))) as u8;
        }
    }
}
