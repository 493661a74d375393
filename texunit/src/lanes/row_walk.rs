//! Weighted sums over rows of texels of bytes, two adjacent texels per row.
//!
//! With AVX the state of 8 or 16 lanes stays in registers over all rows. All numbers are integers, so the order of
//! operations does not matter.

use super::weigh::Sums;
use super::{I32s, LANES, Simd, U32s};

/// The weight of a row that counts in full, in fixed point.
pub const WEIGHT_ONE: i32 = 1 << 14;

/// The position of the second texel of a row.
#[derive(Clone, Copy, Debug)]
pub enum SecondTexel<'a> {
    /// Adjacent to the first; texels have this many bytes, 1 to 4.
    Adjacent(u32),
    /// This many bytes after the first, per lane; texels have up to four.
    Stride(&'a U32s),
}

/// The rows of 64 lanes.
#[derive(Clone, Copy, Debug)]
pub struct RowWalk<'a> {
    /// Byte offset of the first row.
    pub start: &'a U32s,
    /// Byte stride between rows.
    pub stride: &'a U32s,
    /// The second texel.
    pub second_texel: SecondTexel<'a>,
    /// 2^16 times the position in the first row: its integer part is the first texel.
    pub position: &'a I32s,
    /// Change of the position from row to row.
    pub step: &'a I32s,
    /// The length of the rows, in units of [`WEIGHT_ONE`], including `skipped`.
    pub remaining: &'a I32s,
    /// The part of the first row that does not count, in units of [`WEIGHT_ONE`].
    pub skipped: &'a I32s,
    /// The minimum weight of each of the two texels, in units of [`WEIGHT_ONE`].
    pub min_weight: &'a I32s,
    /// Number of rows.
    pub rows: u32,
}

/// The weights of both texels of a row, the second in the upper half.
#[inline(always)]
pub fn weights(position: i32, remaining: i32, skipped: i32, min_weight: i32) -> u32 {
    let fraction = position >> 2 & (WEIGHT_ONE - 1);
    let second = min_weight + ((fraction * (WEIGHT_ONE - 2 * min_weight)) >> 14);
    let remaining = if remaining < WEIGHT_ONE { remaining } else { WEIGHT_ONE };
    let weight = (if remaining > 0 { remaining } else { 0 }) - skipped;
    let second = (second * weight) >> 14;
    ((second << 16) + (weight - second)) as u32
}

/// Adds the weighted texels of all rows to `sums`, one row at a time.
#[inline(always)]
pub(super) fn sum_rows<S: Simd>(bytes: &[u8], walk: &RowWalk<'_>, sums: &mut Sums) {
    let last = walk.last_offset(bytes);
    let (mut start, mut position, mut remaining) = (*walk.start, *walk.position, *walk.remaining);
    for row in 0..walk.rows {
        let mut weighed = U32s::ZERO;
        let mut first = U32s::ZERO;
        for lane in 0..LANES {
            let skipped = if row == 0 { walk.skipped[lane] } else { 0 };
            weighed[lane] =
                weights(position[lane], remaining[lane], skipped, walk.min_weight[lane]);
        }
        match walk.second_texel {
            SecondTexel::Adjacent(size) => {
                for lane in 0..LANES {
                    let number = (position[lane] >> 16) as u32;
                    first[lane] =
                        clamp_offset(start[lane].wrapping_add(number.wrapping_mul(size)), last);
                }
                if size > 2 {
                    S::weigh_pairs(bytes, &first, size, &weighed, sums);
                } else {
                    let texels = S::gather(bytes, &first);
                    let mut second = U32s::ZERO;
                    for lane in 0..LANES {
                        second[lane] = texels[lane] >> ((8 * size) & 31);
                    }
                    S::weigh(&texels, &second, &weighed, sums);
                }
            }
            SecondTexel::Stride(texel_stride) => {
                let mut second = U32s::ZERO;
                for lane in 0..LANES {
                    let number = (position[lane] >> 16) as u32;
                    let at = start[lane].wrapping_add(number.wrapping_mul(texel_stride[lane]));
                    first[lane] = clamp_offset(at, last);
                    second[lane] = clamp_offset(at.wrapping_add(texel_stride[lane]), last);
                }
                let (first, second) = (S::gather(bytes, &first), S::gather(bytes, &second));
                S::weigh(&first, &second, &weighed, sums);
            }
        }
        for lane in 0..LANES {
            start[lane] = start[lane].wrapping_add(walk.stride[lane]);
            position[lane] = position[lane].wrapping_add(walk.step[lane]);
            remaining[lane] = remaining[lane].wrapping_sub(WEIGHT_ONE);
        }
    }
}

#[inline(always)]
fn clamp_offset(offset: u32, last: u32) -> u32 {
    if offset < last { offset } else { last }
}

impl RowWalk<'_> {
    /// Whether both texels of a row are read at once.
    #[inline(always)]
    fn reads_pairs(&self) -> bool {
        matches!(self.second_texel, SecondTexel::Adjacent(3..))
    }

    /// The last offset from which all bytes of a read are there.
    #[inline(always)]
    fn last_offset(&self, bytes: &[u8]) -> u32 {
        let (len, read) = (bytes.len(), if self.reads_pairs() { 8 } else { 4 });
        assert!((read..=i32::MAX as usize).contains(&len), "a walk over {len} bytes");
        (len - read) as u32
    }
}

/// 8 lanes at a time, with sums in registers: of lanes 0, 1, 4 and 5, and of 2, 3, 6 and 7, as vectors of two halves
/// are unpacked.
///
/// # Safety
/// The processor must have AVX2.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn avx2(bytes: &[u8], walk: &RowWalk<'_>, sums: &mut Sums) {
    use super::gather::x86::{eight_words, four_pairs};
    use super::weigh::x86::{avx2_shuffles, avx2_sum};
    use std::arch::x86_64::*;
    let last = walk.last_offset(bytes);
    let base = bytes.as_ptr();
    let (size, texel_stride) = match walk.second_texel {
        SecondTexel::Adjacent(size) => (size, None),
        SecondTexel::Stride(texel_stride) => (4, Some(texel_stride)),
    };
    let pairs = walk.reads_pairs();
    // Offsets are stored to memory: the loads of texels read each as a scalar.
    let (mut firsts, mut seconds) = (U32s::ZERO, U32s::ZERO);
    for at in (0..LANES).step_by(8) {
        // SAFETY: batches hold 8 words at `at`; offsets are clamped to `last`, up to which all bytes of a read are
        // there, and are below 2^31.
        unsafe {
            let load = |words: *const i32| _mm256_load_si256(words.add(at).cast::<__m256i>());
            let signed = |words: &I32s| load(words.0.as_ptr());
            let unsigned = |words: &U32s| load(words.0.as_ptr().cast());
            let (one, zero) = (_mm256_set1_epi32(WEIGHT_ONE), _mm256_setzero_si256());
            let last = _mm256_set1_epi32(last as i32);
            let shuffles = avx2_shuffles(if pairs { size } else { 4 });
            let shift = _mm_cvtsi32_si128(8 * size as i32);
            let (mut start, stride) = (unsigned(walk.start), unsigned(walk.stride));
            let (mut position, step) = (signed(walk.position), signed(walk.step));
            let (mut remaining, mut skipped) = (signed(walk.remaining), signed(walk.skipped));
            let min_weight = signed(walk.min_weight);
            let weight_range = _mm256_sub_epi32(one, _mm256_slli_epi32::<1>(min_weight));
            let mut totals = [[zero; 2]; 2];
            for _ in 0..walk.rows {
                let number = _mm256_srai_epi32::<16>(position);
                let number = match texel_stride {
                    Some(texel_stride) => _mm256_mullo_epi32(number, unsigned(texel_stride)),
                    // Of 16 bits, as is the size.
                    None => _mm256_madd_epi16(number, _mm256_set1_epi32(size as i32)),
                };
                let offset = _mm256_add_epi32(start, number);
                let to = firsts.0.as_mut_ptr().cast::<__m256i>();
                _mm256_store_si256(to, _mm256_min_epu32(offset, last));
                // `weights`; all factors are below 2^15.
                let fraction = _mm256_srli_epi32::<2>(position);
                let fraction = _mm256_and_si256(fraction, _mm256_set1_epi32(WEIGHT_ONE - 1));
                let second = _mm256_srli_epi32::<14>(_mm256_madd_epi16(fraction, weight_range));
                let second = _mm256_add_epi32(min_weight, second);
                let whole = _mm256_max_epi32(_mm256_min_epi32(remaining, one), zero);
                let weight = _mm256_sub_epi32(whole, skipped);
                let second = _mm256_srli_epi32::<14>(_mm256_madd_epi16(second, weight));
                let weights = _mm256_or_si256(
                    _mm256_slli_epi32::<16>(second),
                    _mm256_sub_epi32(weight, second),
                );
                let texels = if pairs {
                    [
                        _mm256_castps_si256(four_pairs(base, &firsts, 0)),
                        _mm256_castps_si256(four_pairs(base, &firsts, 2)),
                    ]
                } else {
                    let a = eight_words::<1>(base, &firsts, 0);
                    let b = if let Some(texel_stride) = texel_stride {
                        let offset = _mm256_add_epi32(offset, unsigned(texel_stride));
                        let to = seconds.0.as_mut_ptr().cast::<__m256i>();
                        _mm256_store_si256(to, _mm256_min_epu32(offset, last));
                        eight_words::<1>(base, &seconds, 0)
                    } else {
                        _mm256_srl_epi32(a, shift)
                    };
                    [_mm256_unpacklo_epi32(a, b), _mm256_unpackhi_epi32(a, b)]
                };
                let weights_by_byte_pair = [
                    _mm256_unpacklo_epi32(weights, weights),
                    _mm256_unpackhi_epi32(weights, weights),
                ];
                for half in 0..2 {
                    for part in 0..2 {
                        let bytes = _mm256_shuffle_epi8(texels[part], shuffles[half]);
                        let products = _mm256_madd_epi16(bytes, weights_by_byte_pair[part]);
                        totals[half][part] = _mm256_add_epi32(totals[half][part], products);
                    }
                }
                start = _mm256_add_epi32(start, stride);
                position = _mm256_add_epi32(position, step);
                remaining = _mm256_sub_epi32(remaining, one);
                skipped = zero;
            }
            for (half, [even, odd]) in totals.into_iter().enumerate() {
                avx2_sum(sums, half, at, _mm256_permute2x128_si256::<0x20>(even, odd));
                avx2_sum(sums, half, at + 4, _mm256_permute2x128_si256::<0x31>(even, odd));
            }
        }
    }
}

/// 16 lanes at a time, with sums in registers.
///
/// # Safety
/// The processor must have AVX-512F and AVX-512BW.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn avx512(bytes: &[u8], walk: &RowWalk<'_>, sums: &mut Sums) {
    use super::weigh::x86::{avx512_shuffles, avx512_sum};
    use std::arch::x86_64::*;
    let last = walk.last_offset(bytes);
    let base = bytes.as_ptr();
    let (size, texel_stride) = match walk.second_texel {
        SecondTexel::Adjacent(size) => (size, None),
        SecondTexel::Stride(texel_stride) => (4, Some(texel_stride)),
    };
    let pairs = walk.reads_pairs();
    for at in (0..LANES).step_by(16) {
        // SAFETY: batches hold 16 words at `at`; offsets are clamped to `last`, up to which all bytes of a read are
        // there, and are below 2^31.
        unsafe {
            let load = |words: *const i32| _mm512_load_si512(words.add(at).cast::<__m512i>());
            let signed = |words: &I32s| load(words.0.as_ptr());
            let unsigned = |words: &U32s| load(words.0.as_ptr().cast());
            let (one, zero) = (_mm512_set1_epi32(WEIGHT_ONE), _mm512_setzero_si512());
            let last = _mm512_set1_epi32(last as i32);
            let low = _mm512_set_epi32(7, 7, 6, 6, 5, 5, 4, 4, 3, 3, 2, 2, 1, 1, 0, 0);
            let high = _mm512_set_epi32(15, 15, 14, 14, 13, 13, 12, 12, 11, 11, 10, 10, 9, 9, 8, 8);
            let mixed_low =
                _mm512_set_epi32(23, 7, 22, 6, 21, 5, 20, 4, 19, 3, 18, 2, 17, 1, 16, 0);
            let mixed_high =
                _mm512_set_epi32(31, 15, 30, 14, 29, 13, 28, 12, 27, 11, 26, 10, 25, 9, 24, 8);
            let shuffles = avx512_shuffles(if pairs { size } else { 4 });
            let across = match texel_stride {
                Some(texel_stride) => unsigned(texel_stride),
                None => _mm512_set1_epi32(size as i32),
            };
            let shift = _mm_cvtsi32_si128(8 * size as i32);
            let (mut start, stride) = (unsigned(walk.start), unsigned(walk.stride));
            let (mut position, step) = (signed(walk.position), signed(walk.step));
            let (mut remaining, mut skipped) = (signed(walk.remaining), signed(walk.skipped));
            let min_weight = signed(walk.min_weight);
            let weight_range = _mm512_sub_epi32(one, _mm512_slli_epi32::<1>(min_weight));
            let mut totals = [[zero; 2]; 2];
            for _ in 0..walk.rows {
                let number = _mm512_srai_epi32::<16>(position);
                let offset = _mm512_add_epi32(start, _mm512_mullo_epi32(number, across));
                let first = _mm512_min_epu32(offset, last);
                // `weights`; all factors are below 2^15.
                let fraction = _mm512_srli_epi32::<2>(position);
                let fraction = _mm512_and_si512(fraction, _mm512_set1_epi32(WEIGHT_ONE - 1));
                let second = _mm512_srli_epi32::<14>(_mm512_madd_epi16(fraction, weight_range));
                let second = _mm512_add_epi32(min_weight, second);
                let whole = _mm512_max_epi32(_mm512_min_epi32(remaining, one), zero);
                let weight = _mm512_sub_epi32(whole, skipped);
                let second = _mm512_srli_epi32::<14>(_mm512_madd_epi16(second, weight));
                let weights = _mm512_or_si512(
                    _mm512_slli_epi32::<16>(second),
                    _mm512_sub_epi32(weight, second),
                );
                let texels = if pairs {
                    let (a, b) =
                        (_mm512_castsi512_si256(first), _mm512_extracti64x4_epi64::<1>(first));
                    [
                        _mm512_i32gather_epi64::<1>(a, base.cast::<i64>()),
                        _mm512_i32gather_epi64::<1>(b, base.cast::<i64>()),
                    ]
                } else {
                    let a = _mm512_i32gather_epi32::<1>(first, base.cast::<i32>());
                    let b = if texel_stride.is_some() {
                        let offset = _mm512_min_epu32(_mm512_add_epi32(offset, across), last);
                        _mm512_i32gather_epi32::<1>(offset, base.cast::<i32>())
                    } else {
                        _mm512_srl_epi32(a, shift)
                    };
                    [
                        _mm512_permutex2var_epi32(a, mixed_low, b),
                        _mm512_permutex2var_epi32(a, mixed_high, b),
                    ]
                };
                let weights_by_byte_pair = [
                    _mm512_permutexvar_epi32(low, weights),
                    _mm512_permutexvar_epi32(high, weights),
                ];
                for half in 0..2 {
                    for part in 0..2 {
                        let bytes = _mm512_shuffle_epi8(texels[part], shuffles[half]);
                        let products = _mm512_madd_epi16(bytes, weights_by_byte_pair[part]);
                        totals[half][part] = _mm512_add_epi32(totals[half][part], products);
                    }
                }
                start = _mm512_add_epi32(start, stride);
                position = _mm512_add_epi32(position, step);
                remaining = _mm512_sub_epi32(remaining, one);
                skipped = zero;
            }
            for (half, [first, second]) in totals.into_iter().enumerate() {
                avx512_sum(sums, half, at, first);
                avx512_sum(sums, half, at + 8, second);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{Isa, Kernel};

    struct Along<'a>(&'a [u8], RowWalk<'a>);
    impl Kernel for Along<'_> {
        type Output = Vec<I32s>;
        #[inline(always)]
        fn run<S: Simd>(self) -> Vec<I32s> {
            let mut sums = Sums::ZERO;
            S::weigh_rows(self.0, &self.1, &mut sums);
            (0..3).map(|byte| sums.of_byte(byte)).collect()
        }
    }

    /// Separate allocations, so that Miri detects a read past the end.
    #[test]
    fn a_walk_leads_nowhere_but_over_its_bytes() {
        let start = U32s::from_fn(|lane| (lane as u32).wrapping_mul(0x1234_5679));
        let stride = U32s::from_fn(|lane| [0, 1, 1 << 31, u32::MAX][lane % 4]);
        let texel_stride = U32s::from_fn(|lane| [3, u32::MAX, 1 << 31, 5][lane % 4]);
        let position = I32s::from_fn(|lane| (lane as i32 - 32) << 24 | 0x1234);
        let (step, min_weight) = (I32s::splat(0x0123_4567), I32s::ZERO);
        let (remaining, skipped) = (I32s::splat(5 * WEIGHT_ONE / 2), I32s::splat(WEIGHT_ONE / 3));
        for second_texel in [
            SecondTexel::Adjacent(1),
            SecondTexel::Adjacent(3),
            SecondTexel::Adjacent(4),
            SecondTexel::Stride(&texel_stride),
        ] {
            for length in [8, 9, 67] {
                let bytes: Box<[u8]> = (0..length).map(|at| (at * 29) as u8).collect();
                let (start, stride, position, step) = (&start, &stride, &position, &step);
                let (remaining, skipped, min_weight, rows) = (&remaining, &skipped, &min_weight, 3);
                let walk = RowWalk {
                    start,
                    stride,
                    second_texel,
                    position,
                    step,
                    remaining,
                    skipped,
                    min_weight,
                    rows,
                };
                let want = Isa::BASELINE.run(Along(&bytes, walk));
                for isa in Isa::available() {
                    let got = isa.run(Along(&bytes, walk));
                    assert_eq!(got, want, "{} {length} {second_texel:?}", isa.name());
                }
            }
        }
    }
}
