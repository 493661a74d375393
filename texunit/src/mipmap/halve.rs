//! The box filter of one level, row by row.

use crate::format::Format;
use crate::image::Level;
use crate::lanes::{F64s, Kernel, LANES, Simd};
use crate::pixel::{self, PixelLayout};

/// The texels that one smaller texel covers along an axis, counted from the first that is stored,
/// and their weights; those without weight may lie outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct AxisTaps {
    pub first: usize,
    pub weights: [u32; 3],
}

impl AxisTaps {
    /// What each texel of a side of `half` covers of one of `size`, the border's on both ends. A
    /// side that is not halved stays.
    pub fn all(size: u32, half: u32, border: u32) -> Vec<Self> {
        let single = |first: u32| Self { first: first as usize, weights: [1, 0, 0] };
        let below = (0..border).map(single);
        let above = (0..border).map(|i| single(border + size + i));
        let inner = (0..half).map(|i| {
            if half == size {
                return single(border + i);
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
    pub columns: Vec<AxisTaps>,
    pub rows: Vec<AxisTaps>,
    pub slices: Vec<AxisTaps>,
}

impl Kernel for Halve<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { from, to, columns, rows, slices } = self;
        let format = from.format;
        let channels = format.channels();
        let record = PixelLayout::of_means(format);
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
                        let weight = inward * down;
                        accumulate::<S>(format, &record, texels(z, y), weight, &mut sums);
                    }
                }
                let across = slice.total() * row.total();
                match channels {
                    1 => along_row::<1>(&columns, across, &sums, &mut means),
                    2 => along_row::<2>(&columns, across, &sums, &mut means),
                    3 => along_row::<3>(&columns, across, &sums, &mut means),
                    _ => along_row::<4>(&columns, across, &sums, &mut means),
                }
                store::<S>(format, &record, &means, out);
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
fn accumulate<S: Simd>(
    format: Format,
    record: &PixelLayout,
    texels: &[u8],
    weight: f64,
    sums: &mut [f64],
) {
    if format.is_bytes() {
        for (sum, &byte) in sums.iter_mut().zip(texels) {
            *sum += weight * f64::from(byte);
        }
        return;
    }
    let channels = format.channels();
    let mut numbers = [F64s::ZERO; 4];
    let runs = texels.chunks(LANES * format.bytes()).zip(sums.chunks_mut(LANES * channels));
    for (texels, sums) in runs {
        pixel::read_by::<S>(record, texels, &mut numbers);
        for (lane, sums) in sums.chunks_exact_mut(channels).enumerate() {
            for (sum, numbers) in sums.iter_mut().zip(&numbers) {
                *sum += weight * numbers[lane];
            }
        }
    }
}

/// The means of what the columns cover. `across` is the weight of a whole column of `sums`.
#[inline(always)]
fn along_row<const N: usize>(columns: &[AxisTaps], across: f64, sums: &[f64], means: &mut [f64]) {
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
fn store<S: Simd>(format: Format, record: &PixelLayout, means: &[f64], out: &mut [u8]) {
    if format.is_bytes() {
        for (byte, mean) in out.iter_mut().zip(means) {
            *byte = (mean + 0.5) as u8;
        }
        return;
    }
    let channels = format.channels();
    let mut numbers = [F64s::ZERO; 4];
    let runs = means.chunks(LANES * channels).zip(out.chunks_mut(LANES * format.bytes()));
    for (means, out) in runs {
        for (lane, means) in means.chunks_exact(channels).enumerate() {
            for ((numbers, &mean), &(_, code)) in numbers.iter_mut().zip(means).zip(record.fields())
            {
                numbers[lane] = if code.is_integer() { floor(mean + 0.5) } else { mean };
            }
        }
        pixel::write_by::<S>(record, numbers.each_ref(), out);
    }
}

/// The largest integer that is no larger, of what lies within -2^31 to 2^32.
#[inline(always)]
fn floor(x: f64) -> f64 {
    let whole = (x as i64) as f64;
    if whole > x { whole - 1.0 } else { whole }
}
