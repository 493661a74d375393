//! Gathers: the largest index of the batch is checked once, then 64 words are read unchecked.

use super::isa::Baseline;
use super::{F32s, LANES, Simd, U32s};

/// Panics unless `size` bytes at `index * scale` lie inside `len` bytes in every lane, and every
/// byte offset fits the signed 32 bits that the instructions take.
#[inline(always)]
pub(super) fn check<S: Simd>(len: usize, indices: &U32s, scale: u64, size: u64) {
    let reached = (len as u64).min(i32::MAX as u64);
    // The first index that is too large, if there is room for any.
    let bound = reached.checked_sub(size).map_or(0, |last| last / scale + 1);
    assert!(S::below(indices, bound as u32), "gather at {} of {len} bytes", S::largest(indices));
}

/// A byte of each word.
#[inline(always)]
pub(super) fn bytes(words: &U32s, shift: u32) -> U32s {
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        out[lane] = words[lane] >> (shift & 31) & 0xFF;
    }
    out
}

// The baseline's are functions by themselves: they take on no instruction set, and stand in many places.

#[inline(never)]
pub(super) fn scalar(bytes: &[u8], offsets: &U32s) -> U32s {
    check::<Baseline>(bytes.len(), offsets, 1, 4);
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        // SAFETY: `check` saw that these four bytes are inside `bytes`.
        out[lane] = u32::from_le(unsafe {
            bytes.as_ptr().add(offsets[lane] as usize).cast::<u32>().read_unaligned()
        });
    }
    out
}

#[inline(never)]
pub(super) fn scalar_pairs(bytes: &[u8], offsets: &U32s) -> [U32s; 2] {
    check::<Baseline>(bytes.len(), offsets, 1, 8);
    let mut out = [U32s::ZERO; 2];
    for lane in 0..LANES {
        // SAFETY: `check` saw that these eight bytes are inside `bytes`.
        let pair = u64::from_le(unsafe {
            bytes.as_ptr().add(offsets[lane] as usize).cast::<u64>().read_unaligned()
        });
        out[0][lane] = pair as u32;
        out[1][lane] = (pair >> 32) as u32;
    }
    out
}

#[inline(never)]
pub(super) fn scalar_f32(table: &[f32], indices: &U32s) -> F32s {
    check::<Baseline>(size_of_val(table), indices, 4, 4);
    let mut out = F32s::ZERO;
    for lane in 0..LANES {
        // SAFETY: `check` saw that this element is inside `table`.
        out[lane] = unsafe { *table.as_ptr().add(indices[lane] as usize) };
    }
    out
}

/// # Safety
/// AVX2 is there, and the four bytes at every `index * SCALE` can be read.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn avx2<const SCALE: i32>(base: *const u8, indices: &U32s) -> U32s {
    use std::arch::x86_64::{
        __m256i, _mm256_i32gather_epi32, _mm256_load_si256, _mm256_store_si256,
    };
    let mut out = U32s::ZERO;
    for chunk in 0..LANES / 8 {
        // SAFETY: both batches are 64-byte aligned and hold 8 words at each chunk; the caller
        // vouches for the gathered bytes.
        unsafe {
            let index = _mm256_load_si256(indices.0.as_ptr().add(chunk * 8).cast::<__m256i>());
            let words = _mm256_i32gather_epi32::<SCALE>(base.cast::<i32>(), index);
            _mm256_store_si256(out.0.as_mut_ptr().add(chunk * 8).cast::<__m256i>(), words);
        }
    }
    out
}

/// # Safety
/// AVX-512F is there, and the four bytes at every `index * SCALE` can be read.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn avx512<const SCALE: i32>(base: *const u8, indices: &U32s) -> U32s {
    use std::arch::x86_64::{
        __m512i, _mm512_i32gather_epi32, _mm512_load_si512, _mm512_store_si512,
    };
    let mut out = U32s::ZERO;
    for chunk in 0..LANES / 16 {
        // SAFETY: as for `avx2`, with 16 words a chunk.
        unsafe {
            let index = _mm512_load_si512(indices.0.as_ptr().add(chunk * 16).cast::<__m512i>());
            let words = _mm512_i32gather_epi32::<SCALE>(index, base.cast::<i32>());
            _mm512_store_si512(out.0.as_mut_ptr().add(chunk * 16).cast::<__m512i>(), words);
        }
    }
    out
}

/// # Safety
/// AVX2 is there, and the eight bytes at every offset can be read.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn avx2_pairs(base: *const u8, offsets: &U32s) -> [U32s; 2] {
    use std::arch::x86_64::{
        __m128i, __m256i, _mm_load_si128, _mm256_castpd_si256, _mm256_castps_pd,
        _mm256_castsi256_ps, _mm256_i32gather_epi64, _mm256_permute4x64_pd, _mm256_shuffle_ps,
        _mm256_store_si256,
    };
    let mut out = [U32s::ZERO; 2];
    for chunk in 0..LANES / 8 {
        // SAFETY: batches are 64-byte aligned and hold 8 words at each chunk; the caller vouches
        // for the gathered bytes.
        unsafe {
            let at = offsets.0.as_ptr().add(chunk * 8);
            let first = _mm_load_si128(at.cast::<__m128i>());
            let second = _mm_load_si128(at.add(4).cast::<__m128i>());
            let a = _mm256_castsi256_ps(_mm256_i32gather_epi64::<1>(base.cast::<i64>(), first));
            let b = _mm256_castsi256_ps(_mm256_i32gather_epi64::<1>(base.cast::<i64>(), second));
            // Within each half of 128 bits the even (odd) words of `a`, then of `b`.
            let low = _mm256_castps_pd(_mm256_shuffle_ps::<0b10_00_10_00>(a, b));
            let high = _mm256_castps_pd(_mm256_shuffle_ps::<0b11_01_11_01>(a, b));
            for (out, words) in out.iter_mut().zip([low, high]) {
                let words = _mm256_castpd_si256(_mm256_permute4x64_pd::<0b11_01_10_00>(words));
                _mm256_store_si256(out.0.as_mut_ptr().add(chunk * 8).cast::<__m256i>(), words);
            }
        }
    }
    out
}

/// # Safety
/// AVX-512F is there, and the eight bytes at every offset can be read.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn avx512_pairs(base: *const u8, offsets: &U32s) -> [U32s; 2] {
    use std::arch::x86_64::{
        __m256i, __m512i, _mm256_load_si256, _mm512_i32gather_epi64, _mm512_permutex2var_epi32,
        _mm512_set_epi32, _mm512_store_si512,
    };
    let mut out = [U32s::ZERO; 2];
    for chunk in 0..LANES / 16 {
        // SAFETY: as for `avx2_pairs`, with 16 words a chunk.
        unsafe {
            let at = offsets.0.as_ptr().add(chunk * 16);
            let first = _mm256_load_si256(at.cast::<__m256i>());
            let second = _mm256_load_si256(at.add(8).cast::<__m256i>());
            let a = _mm512_i32gather_epi64::<1>(first, base.cast::<i64>());
            let b = _mm512_i32gather_epi64::<1>(second, base.cast::<i64>());
            let even = _mm512_set_epi32(30, 28, 26, 24, 22, 20, 18, 16, 14, 12, 10, 8, 6, 4, 2, 0);
            let odd = _mm512_set_epi32(31, 29, 27, 25, 23, 21, 19, 17, 15, 13, 11, 9, 7, 5, 3, 1);
            for (out, pick) in out.iter_mut().zip([even, odd]) {
                let words = _mm512_permutex2var_epi32(a, pick, b);
                _mm512_store_si512(out.0.as_mut_ptr().add(chunk * 16).cast::<__m512i>(), words);
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{Isa, Kernel};

    struct Gather<'a>(&'a [u8], &'a U32s);
    impl Kernel for Gather<'_> {
        type Output = (U32s, [U32s; 2]);
        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            (S::gather(self.0, self.1), S::gather_pairs(self.0, self.1))
        }
    }

    #[test]
    fn every_instruction_set_gathers_the_same_unaligned_words() {
        let bytes: Vec<u8> = (0..1024u32).map(|i| (i * 37 + i / 7) as u8).collect();
        let offsets = U32s::from_fn(|lane| (lane as u32 * 131) % 1017);
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
        for isa in Isa::available() {
            let (single, [low, high]) = isa.run(Gather(&bytes, &offsets));
            for lane in 0..LANES {
                let at = offsets[lane] as usize;
                assert_eq!(single[lane], word(at), "{} lane {lane}", isa.name());
                assert_eq!(low[lane], word(at), "{} lane {lane}", isa.name());
                assert_eq!(high[lane], word(at + 4), "{} lane {lane}", isa.name());
            }
        }
    }

    #[test]
    fn a_gather_outside_its_slice_panics_on_every_instruction_set() {
        let bytes = [0; 64];
        for bad in [61, 64, u32::MAX, 1 << 31] {
            let mut offsets = U32s::ZERO;
            offsets[63] = bad;
            for isa in Isa::available() {
                let run = std::panic::catch_unwind(|| isa.run(Gather(&bytes, &offsets)));
                assert!(run.is_err(), "{} took offset {bad}", isa.name());
            }
        }
    }
}
