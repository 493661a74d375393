//! Reductions over lanes: the largest, which are not 0, whether any is not 0, whether all are below a bound. Written with
//! intrinsics: LLVM sometimes unrolls the plain loop into 64 scalar comparisons.

use super::{LANES, U32s};

// Those of the baseline are not inlined, as in `gather`.

#[inline(never)]
pub(super) fn scalar(words: &U32s) -> u32 {
    let mut largest = 0;
    for lane in 0..LANES {
        largest = if words[lane] > largest { words[lane] } else { largest };
    }
    largest
}

/// # Safety
/// The processor must have AVX2.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn avx2(words: &U32s) -> u32 {
    use std::arch::x86_64::{
        __m256i, _mm_cvtsi128_si32, _mm_max_epu32, _mm_shuffle_epi32, _mm256_castsi256_si128,
        _mm256_extracti128_si256, _mm256_load_si256, _mm256_max_epu32, _mm256_setzero_si256,
    };
    // SAFETY: a batch is 64-byte aligned and holds 8 words at each chunk; the caller vouches for
    // the instructions.
    unsafe {
        let mut most = _mm256_setzero_si256();
        for chunk in 0..LANES / 8 {
            let from = words.0.as_ptr().add(chunk * 8).cast::<__m256i>();
            most = _mm256_max_epu32(most, _mm256_load_si256(from));
        }
        let four = _mm_max_epu32(_mm256_castsi256_si128(most), _mm256_extracti128_si256::<1>(most));
        let two = _mm_max_epu32(four, _mm_shuffle_epi32::<0b01_00_11_10>(four));
        let one = _mm_max_epu32(two, _mm_shuffle_epi32::<0b10_11_00_01>(two));
        _mm_cvtsi128_si32(one) as u32
    }
}

/// # Safety
/// The processor must have AVX-512F.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn avx512(words: &U32s) -> u32 {
    use std::arch::x86_64::{_mm512_max_epu32, _mm512_reduce_max_epu32};
    // SAFETY: the caller guarantees the instruction set.
    unsafe {
        let [a, b, c, d] = avx512_vectors(words);
        _mm512_reduce_max_epu32(_mm512_max_epu32(_mm512_max_epu32(a, b), _mm512_max_epu32(c, d)))
    }
}

#[inline(never)]
pub(super) fn scalar_any(words: &U32s) -> bool {
    let mut any = 0;
    for lane in 0..LANES {
        any |= words[lane];
    }
    any != 0
}

/// # Safety
/// The processor must have AVX2.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn avx2_any(words: &U32s) -> bool {
    use std::arch::x86_64::{
        __m256i, _mm256_load_si256, _mm256_or_si256, _mm256_setzero_si256, _mm256_testz_si256,
    };
    // SAFETY: as for `avx2`.
    unsafe {
        let mut any = _mm256_setzero_si256();
        for chunk in 0..LANES / 8 {
            let from = words.0.as_ptr().add(chunk * 8).cast::<__m256i>();
            any = _mm256_or_si256(any, _mm256_load_si256(from));
        }
        _mm256_testz_si256(any, any) == 0
    }
}

/// The four vectors of a batch.
///
/// # Safety
/// The processor must have AVX-512F.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
unsafe fn avx512_vectors(words: &U32s) -> [std::arch::x86_64::__m512i; 4] {
    use std::arch::x86_64::{__m512i, _mm512_load_si512};
    let at = words.0.as_ptr();
    // SAFETY: a batch is 64-byte aligned and holds 16 words at each chunk; the caller vouches for
    // the instructions.
    unsafe {
        [
            _mm512_load_si512(at.cast::<__m512i>()),
            _mm512_load_si512(at.add(16).cast::<__m512i>()),
            _mm512_load_si512(at.add(32).cast::<__m512i>()),
            _mm512_load_si512(at.add(48).cast::<__m512i>()),
        ]
    }
}

/// # Safety
/// The processor must have AVX-512F.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn avx512_any(words: &U32s) -> bool {
    use std::arch::x86_64::{_mm512_or_si512, _mm512_test_epi32_mask};
    // SAFETY: the caller guarantees the instruction set.
    unsafe {
        let [a, b, c, d] = avx512_vectors(words);
        let any = _mm512_or_si512(_mm512_or_si512(a, b), _mm512_or_si512(c, d));
        _mm512_test_epi32_mask(any, any) != 0
    }
}

/// # Safety
/// The processor must have AVX-512F.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn avx512_below(words: &U32s, bound: u32) -> bool {
    use std::arch::x86_64::{_mm512_cmplt_epu32_mask, _mm512_max_epu32, _mm512_set1_epi32};
    // SAFETY: the caller guarantees the instruction set.
    unsafe {
        let [a, b, c, d] = avx512_vectors(words);
        let largest = _mm512_max_epu32(_mm512_max_epu32(a, b), _mm512_max_epu32(c, d));
        _mm512_cmplt_epu32_mask(largest, _mm512_set1_epi32(bound as i32)) == u16::MAX
    }
}

#[inline(never)]
pub(super) fn scalar_nonzero(words: &U32s) -> u64 {
    let mut bytes = [0_u8; LANES];
    for lane in 0..LANES {
        bytes[lane] = u8::from(words[lane] != 0);
    }
    let mut bits = 0;
    for (index, eight) in bytes.as_chunks::<8>().0.iter().enumerate() {
        // Moves bit 0 of byte `i` to bit `56 + i`.
        let gathered = u64::from_le_bytes(*eight).wrapping_mul(0x0102_0408_1020_4080) >> 56;
        bits |= gathered << (8 * index);
    }
    bits
}

/// # Safety
/// The processor must have AVX2.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn avx2_nonzero(words: &U32s) -> u64 {
    use std::arch::x86_64::{
        __m256i, _mm256_castsi256_ps, _mm256_cmpeq_epi32, _mm256_load_si256, _mm256_movemask_ps,
        _mm256_setzero_si256,
    };
    let mut zero = 0;
    for chunk in 0..LANES / 8 {
        // SAFETY: as for `avx2`.
        let bits = unsafe {
            let from = words.0.as_ptr().add(chunk * 8).cast::<__m256i>();
            let is_zero = _mm256_cmpeq_epi32(_mm256_load_si256(from), _mm256_setzero_si256());
            _mm256_movemask_ps(_mm256_castsi256_ps(is_zero))
        };
        zero |= (bits as u64) << (chunk * 8);
    }
    !zero
}

/// # Safety
/// The processor must have AVX-512F.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn avx512_nonzero(words: &U32s) -> u64 {
    use std::arch::x86_64::{__m512i, _mm512_load_si512, _mm512_test_epi32_mask};
    let mut bits = 0;
    for chunk in 0..LANES / 16 {
        // SAFETY: as for `avx512`.
        let set = unsafe {
            let from = _mm512_load_si512(words.0.as_ptr().add(chunk * 16).cast::<__m512i>());
            _mm512_test_epi32_mask(from, from)
        };
        bits |= u64::from(set) << (chunk * 16);
    }
    bits
}
