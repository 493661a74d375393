//! Weighted sums of texels of bytes, in integers: exact, so the same in any order.
//!
//! A texel has up to four bytes; two of them are weighed at a time, by the two halves of a word.
//! AVX does this for pairs of 16-bit numbers in one instruction, so sums lie as it leaves them: those
//! of the first and of the second byte of a lane side by side, then those of the third and fourth.

use super::{I32s, LANES, U32s};

/// Sums of four bytes in every lane.
#[derive(Clone, Copy, Debug)]
pub struct Sums([[[i32; 2]; LANES]; 2]);

impl Sums {
    /// Zero everywhere.
    pub const ZERO: Self = Self([[[0; 2]; LANES]; 2]);

    /// The sums of byte 0 to 3.
    #[inline(always)]
    pub fn of_byte(&self, byte: usize) -> I32s {
        let pairs = &self.0[byte / 2];
        let mut out = I32s::ZERO;
        if byte.is_multiple_of(2) {
            for lane in 0..LANES {
                out[lane] = pairs[lane][0];
            }
        } else {
            for lane in 0..LANES {
                out[lane] = pairs[lane][1];
            }
        }
        out
    }
}

#[inline(always)]
pub(super) fn scalar(first: &U32s, second: &U32s, weights: &U32s, sums: &mut Sums) {
    for (half, pairs) in sums.0.iter_mut().enumerate() {
        for lane in 0..LANES {
            let (low, high) = (weights[lane] & 0xFFFF, weights[lane] >> 16);
            let (a, b) = (first[lane] >> (16 * half), second[lane] >> (16 * half));
            pairs[lane][0] += ((a & 0xFF) * low + (b & 0xFF) * high) as i32;
            pairs[lane][1] += ((a >> 8 & 0xFF) * low + (b >> 8 & 0xFF) * high) as i32;
        }
    }
}

#[inline(always)]
pub(super) fn scalar_pairs(
    bytes: &[u8],
    offsets: &U32s,
    apart: u32,
    weights: &U32s,
    sums: &mut Sums,
) {
    let [first, mut second] = super::gather::scalar_pairs(bytes, offsets);
    if apart == 3 {
        for lane in 0..LANES {
            second[lane] = first[lane] >> 24 | second[lane] << 8;
        }
    }
    scalar(&first, &second, weights, sums);
}

/// Where the bytes of two texels go that begin `apart` bytes from one another: byte 0 of both and
/// byte 1 of both, or bytes 2 and 3, each in 16 bits (-1 gives zero).
#[cfg(target_arch = "x86_64")]
#[inline(always)]
const fn byte_shuffle(apart: i8, half: i8) -> [i8; 16] {
    let mut out = [-1; 16];
    let mut at = 0;
    while at < 4 {
        // Words: byte b of the first, of the second; byte b + 1 of the first, of the second.
        let from = 2 * half + at / 2 + if at % 2 == 1 { apart } else { 0 };
        out[2 * at as usize] = from;
        out[8 + 2 * at as usize] = 8 + from;
        at += 1;
    }
    out
}

#[cfg(target_arch = "x86_64")]
pub(super) mod x86 {
    use super::super::gather::x86::four_pairs;
    use super::{LANES, Sums, U32s, byte_shuffle};
    use std::arch::x86_64::*;

    const SHUFFLES: [[[i8; 16]; 2]; 2] =
        [[byte_shuffle(3, 0), byte_shuffle(3, 1)], [byte_shuffle(4, 0), byte_shuffle(4, 1)]];

    /// # Safety
    /// The processor must have AVX2, and `at` and the three lanes after it are lanes.
    #[inline(always)]
    unsafe fn avx2_add(texels: __m256i, weights: __m256i, apart: u32, sums: &mut Sums, at: usize) {
        for half in 0..2 {
            // SAFETY: guaranteed by the caller.
            unsafe {
                let bytes = _mm256_shuffle_epi8(texels, avx2_shuffles(apart)[half]);
                avx2_sum(sums, half, at, _mm256_madd_epi16(bytes, weights));
            }
        }
    }

    /// Where bytes go, for both halves.
    ///
    /// # Safety
    /// The processor must have AVX2.
    #[inline(always)]
    pub unsafe fn avx2_shuffles(apart: u32) -> [__m256i; 2] {
        let [first, second] = &SHUFFLES[usize::from(apart == 4)];
        // SAFETY: a table has 16 bytes.
        unsafe {
            [
                _mm256_broadcastsi128_si256(_mm_loadu_si128(first.as_ptr().cast())),
                _mm256_broadcastsi128_si256(_mm_loadu_si128(second.as_ptr().cast())),
            ]
        }
    }

    /// Adds to the sums of four lanes.
    ///
    /// # Safety
    /// The processor must have AVX2, and `at` and the three lanes after it are lanes.
    #[inline(always)]
    pub unsafe fn avx2_sum(sums: &mut Sums, half: usize, at: usize, products: __m256i) {
        // SAFETY: guaranteed by the caller.
        unsafe {
            let sum = sums.0[half].as_mut_ptr().add(at).cast::<__m256i>();
            _mm256_storeu_si256(sum, _mm256_add_epi32(_mm256_loadu_si256(sum), products));
        }
    }

    /// # Safety
    /// The processor must have AVX2.
    #[inline(always)]
    pub unsafe fn avx2(first: &U32s, second: &U32s, weights: &U32s, sums: &mut Sums) {
        for at in (0..LANES).step_by(4) {
            // SAFETY: a batch holds 4 words at `at`.
            unsafe {
                let load = |words: &U32s| {
                    _mm256_cvtepu32_epi64(_mm_load_si128(words.0.as_ptr().add(at).cast()))
                };
                let weights = load(weights);
                let twice = _mm256_or_si256(weights, _mm256_slli_epi64::<32>(weights));
                let texels = _mm256_or_si256(load(first), _mm256_slli_epi64::<32>(load(second)));
                avx2_add(texels, twice, 4, sums, at);
            }
        }
    }

    /// # Safety
    /// The processor must have AVX2, and the eight bytes at every offset can be read.
    #[inline(always)]
    pub unsafe fn avx2_pairs(
        base: *const u8,
        offsets: &U32s,
        apart: u32,
        weights: &U32s,
        sums: &mut Sums,
    ) {
        for first in (0..LANES).step_by(8) {
            // SAFETY: a batch holds 8 words at `first`; the caller guarantees the gathered bytes.
            unsafe {
                let even = _mm256_castps_si256(four_pairs(base, offsets, first));
                let odd = _mm256_castps_si256(four_pairs(base, offsets, first + 2));
                let halves = [
                    _mm256_permute2x128_si256::<0x20>(even, odd),
                    _mm256_permute2x128_si256::<0x31>(even, odd),
                ];
                for (half, texels) in halves.into_iter().enumerate() {
                    let at = first + 4 * half;
                    let weights = _mm_load_si128(weights.0.as_ptr().add(at).cast::<__m128i>());
                    let weights = _mm256_cvtepu32_epi64(weights);
                    let twice = _mm256_or_si256(weights, _mm256_slli_epi64::<32>(weights));
                    avx2_add(texels, twice, apart, sums, at);
                }
            }
        }
    }

    /// # Safety
    /// The processor must have AVX-512F and AVX-512BW.
    #[inline(always)]
    unsafe fn avx512_add(
        texels: __m512i,
        weights: __m512i,
        apart: u32,
        sums: &mut Sums,
        at: usize,
    ) {
        for half in 0..2 {
            // SAFETY: as for `avx2_add`, with eight lanes.
            unsafe {
                let bytes = _mm512_shuffle_epi8(texels, avx512_shuffles(apart)[half]);
                avx512_sum(sums, half, at, _mm512_madd_epi16(bytes, weights));
            }
        }
    }

    /// Where bytes go, for both halves.
    ///
    /// # Safety
    /// The processor must have AVX-512F.
    #[inline(always)]
    pub unsafe fn avx512_shuffles(apart: u32) -> [__m512i; 2] {
        let [first, second] = &SHUFFLES[usize::from(apart == 4)];
        // SAFETY: a table has 16 bytes.
        unsafe {
            [
                _mm512_broadcast_i32x4(_mm_loadu_si128(first.as_ptr().cast())),
                _mm512_broadcast_i32x4(_mm_loadu_si128(second.as_ptr().cast())),
            ]
        }
    }

    /// Adds to the sums of eight lanes.
    ///
    /// # Safety
    /// The processor must have AVX-512F, and `at` and the seven lanes after it are lanes.
    #[inline(always)]
    pub unsafe fn avx512_sum(sums: &mut Sums, half: usize, at: usize, products: __m512i) {
        // SAFETY: guaranteed by the caller.
        unsafe {
            let sum = sums.0[half].as_mut_ptr().add(at).cast::<__m512i>();
            _mm512_storeu_si512(sum, _mm512_add_epi32(_mm512_loadu_si512(sum), products));
        }
    }

    /// The words of eight lanes, each twice.
    ///
    /// # Safety
    /// The processor must have AVX-512F, and `at` and the seven lanes after it are lanes.
    #[inline(always)]
    unsafe fn avx512_twice(words: &U32s, at: usize) -> __m512i {
        // SAFETY: guaranteed by the caller.
        unsafe {
            let eight = _mm256_load_si256(words.0.as_ptr().add(at).cast::<__m256i>());
            let order = _mm512_set_epi32(7, 7, 6, 6, 5, 5, 4, 4, 3, 3, 2, 2, 1, 1, 0, 0);
            _mm512_permutexvar_epi32(order, _mm512_castsi256_si512(eight))
        }
    }

    /// # Safety
    /// The processor must have AVX-512F and AVX-512BW.
    #[inline(always)]
    pub unsafe fn avx512(first: &U32s, second: &U32s, weights: &U32s, sums: &mut Sums) {
        for at in (0..LANES).step_by(8) {
            // SAFETY: a batch holds 8 words at `at`.
            unsafe {
                let load = |words: &U32s| {
                    let eight = _mm256_load_si256(words.0.as_ptr().add(at).cast::<__m256i>());
                    _mm512_castsi256_si512(eight)
                };
                let order =
                    _mm512_set_epi32(23, 7, 22, 6, 21, 5, 20, 4, 19, 3, 18, 2, 17, 1, 16, 0);
                let texels = _mm512_permutex2var_epi32(load(first), order, load(second));
                avx512_add(texels, avx512_twice(weights, at), 4, sums, at);
            }
        }
    }

    /// # Safety
    /// The processor must have AVX-512F and AVX-512BW, and the eight bytes at every offset can be read.
    #[inline(always)]
    pub unsafe fn avx512_pairs(
        base: *const u8,
        offsets: &U32s,
        apart: u32,
        weights: &U32s,
        sums: &mut Sums,
    ) {
        for at in (0..LANES).step_by(8) {
            // SAFETY: a batch holds 8 words at `at`; the caller guarantees the gathered bytes.
            unsafe {
                let index = _mm256_load_si256(offsets.0.as_ptr().add(at).cast::<__m256i>());
                let texels = _mm512_i32gather_epi64::<1>(index, base.cast::<i64>());
                avx512_add(texels, avx512_twice(weights, at), apart, sums, at);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{Isa, Kernel, Simd};

    struct Weigh<'a>(&'a [u8], &'a U32s, &'a U32s, u32);
    impl Kernel for Weigh<'_> {
        type Output = [Sums; 2];
        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let Self(bytes, offsets, weights, apart) = self;
            let mut sums = [Sums::ZERO; 2];
            let mut second = U32s::ZERO;
            for lane in 0..LANES {
                second[lane] = offsets[lane] + apart;
            }
            for _ in 0..3 {
                let [pairs, single] = &mut sums;
                S::weigh_pairs(bytes, offsets, apart, weights, pairs);
                let (a, b) = (S::gather(bytes, offsets), S::gather(bytes, &second));
                S::weigh(&a, &b, weights, single);
            }
            sums
        }
    }

    #[test]
    fn every_instruction_set_weighs_the_bytes_of_two_texels() {
        let bytes: Vec<u8> = (0..1024u32).map(|i| (i * 37 + i / 7 + 255) as u8).collect();
        let offsets = U32s::from_fn(|lane| (lane as u32 * 131) % 1015);
        let weights = U32s::from_fn(|lane| {
            let upper = lane as u32 * 260;
            upper << 16 | (16_384 - upper)
        });
        for isa in Isa::available() {
            for apart in [3, 4] {
                for sums in isa.run(Weigh(&bytes, &offsets, &weights, apart)) {
                    for lane in 0..LANES {
                        for byte in 0..4 {
                            let at = offsets[lane] as usize + byte;
                            let of = |at: usize| u32::from(bytes[at]);
                            let (low, high) = (weights[lane] & 0xFFFF, weights[lane] >> 16);
                            let want = 3 * (of(at) * low + of(at + apart as usize) * high);
                            let got = sums.of_byte(byte)[lane];
                            // The fourth byte of three is the next texel's first.
                            if byte < apart as usize {
                                assert_eq!(got, want as i32, "{} {apart} {lane}", isa.name());
                            }
                        }
                    }
                }
            }
        }
    }
}
