//! Gathers of AVX2 and AVX-512.
//!
//! Gather instructions are slower than the loads that they replace (`docs/performance.md`), so words are loaded one by one
//! and combined by shuffles.

use super::super::isa::x86::{Avx2, Avx512};
use super::{LANES, U32s, check};
use std::arch::x86_64::{
    __m128, __m128i, __m256, __m256i, __m512, __m512i, _mm_castpd_ps, _mm_cvtsi32_si128,
    _mm_insert_epi32, _mm_loadu_ps, _mm_setr_pd, _mm256_castps_pd, _mm256_castps128_ps256,
    _mm256_castsi128_si256, _mm256_insertf128_ps, _mm256_inserti128_si256, _mm256_shuffle_ps,
    _mm256_store_ps, _mm256_store_si256, _mm256_unpackhi_ps, _mm256_unpacklo_ps, _mm512_castpd_ps,
    _mm512_castpd256_pd512, _mm512_castsi256_si512, _mm512_insertf64x4, _mm512_inserti64x4,
    _mm512_shuffle_ps, _mm512_store_ps, _mm512_store_si512, _mm512_unpackhi_ps, _mm512_unpacklo_ps,
};

/// The word at every `index * SCALE`.
///
/// # Safety
/// The processor must have AVX2.
#[inline(always)]
pub unsafe fn avx2<const SCALE: usize>(bytes: &[u8], indices: &U32s) -> U32s {
    check::<Avx2>(bytes.len(), indices, SCALE as u64, 4);
    let mut out = U32s::ZERO;
    for first in (0..LANES).step_by(8) {
        // SAFETY: the indices were checked; the batch is 64-byte aligned and has 8 words from `first` on.
        unsafe {
            let words = eight_words::<SCALE>(bytes.as_ptr(), indices, first);
            _mm256_store_si256(out.0.as_mut_ptr().add(first).cast::<__m256i>(), words);
        }
    }
    out
}

/// The word at every `index * SCALE`.
///
/// # Safety
/// The processor must have AVX-512.
#[inline(always)]
pub unsafe fn avx512<const SCALE: usize>(bytes: &[u8], indices: &U32s) -> U32s {
    check::<Avx512>(bytes.len(), indices, SCALE as u64, 4);
    let mut out = U32s::ZERO;
    for first in (0..LANES).step_by(16) {
        // SAFETY: as for `avx2`, with 16 words.
        unsafe {
            let low = eight_words::<SCALE>(bytes.as_ptr(), indices, first);
            let high = eight_words::<SCALE>(bytes.as_ptr(), indices, first + 8);
            let words = _mm512_inserti64x4::<1>(_mm512_castsi256_si512(low), high);
            _mm512_store_si512(out.0.as_mut_ptr().add(first).cast::<__m512i>(), words);
        }
    }
    out
}

/// The pair at every offset.
///
/// # Safety
/// The processor must have AVX2.
#[inline(always)]
pub unsafe fn avx2_pairs(bytes: &[u8], offsets: &U32s) -> [U32s; 2] {
    check::<Avx2>(bytes.len(), offsets, 1, 8);
    let mut out = [U32s::ZERO; 2];
    for first in (0..LANES).step_by(8) {
        // SAFETY: the offsets were checked.
        unsafe { store_pairs(bytes.as_ptr(), offsets, first, out.each_mut()) };
    }
    out
}

/// The pair at every offset, and the one `apart` bytes further.
///
/// # Safety
/// The processor must have AVX2.
#[inline(always)]
pub unsafe fn avx2_quads(bytes: &[u8], offsets: &U32s, apart: u32, out: &mut [U32s; 4]) {
    // There are as many bytes for pairs above which `apart` more are left.
    let len = bytes.len().saturating_sub(apart as usize);
    check::<Avx2>(len, offsets, 1, 8);
    let [below, above] = [bytes.as_ptr(), bytes.as_ptr().wrapping_add(apart as usize)];
    for first in (0..LANES).step_by(8) {
        let [a, b, c, d] = out.each_mut();
        // SAFETY: the offsets were checked for both rows.
        unsafe {
            store_pairs(below, offsets, first, [a, b]);
            store_pairs(above, offsets, first, [c, d]);
        }
    }
}

/// The first and the second words of the pairs of eight lanes from `first` on.
///
/// # Safety
/// The processor must have AVX2, the eight bytes at the lanes' offsets can be read, and `first` is a multiple of 8 below [`LANES`].
#[inline(always)]
unsafe fn store_pairs(base: *const u8, offsets: &U32s, first: usize, out: [&mut U32s; 2]) {
    // SAFETY: the caller vouches for the bytes; batches are 64-byte aligned and have 8 words from `first` on.
    unsafe {
        // Pairs 0, 1, 4 and 5; 2, 3, 6 and 7: within each half of 128 bits, the even (odd) words of one, then of
        // the other, are eight in order.
        let a = four_pairs(base, offsets, first);
        let b = four_pairs(base, offsets, first + 2);
        let even = _mm256_shuffle_ps::<0b10_00_10_00>(a, b);
        let odd = _mm256_shuffle_ps::<0b11_01_11_01>(a, b);
        _mm256_store_ps(out[0].0.as_mut_ptr().add(first).cast::<f32>(), even);
        _mm256_store_ps(out[1].0.as_mut_ptr().add(first).cast::<f32>(), odd);
    }
}

/// The pair at every offset.
///
/// # Safety
/// The processor must have AVX-512.
#[inline(always)]
pub unsafe fn avx512_pairs(bytes: &[u8], offsets: &U32s) -> [U32s; 2] {
    check::<Avx512>(bytes.len(), offsets, 1, 8);
    let mut out = [U32s::ZERO; 2];
    for first in (0..LANES).step_by(16) {
        // SAFETY: as for `avx2_pairs`, with 16 words.
        unsafe {
            let a = eight_pairs(bytes.as_ptr(), offsets, first);
            let b = eight_pairs(bytes.as_ptr(), offsets, first + 2);
            let even = _mm512_shuffle_ps::<0b10_00_10_00>(a, b);
            let odd = _mm512_shuffle_ps::<0b11_01_11_01>(a, b);
            _mm512_store_ps(out[0].0.as_mut_ptr().add(first).cast::<f32>(), even);
            _mm512_store_ps(out[1].0.as_mut_ptr().add(first).cast::<f32>(), odd);
        }
    }
    out
}

/// The four words at every offset.
///
/// # Safety
/// The processor must have AVX2.
#[inline(always)]
pub unsafe fn avx2_fours(bytes: &[u8], offsets: &U32s) -> [U32s; 4] {
    check::<Avx2>(bytes.len(), offsets, 1, 16);
    let mut out = [U32s::ZERO; 4];
    for first in (0..LANES).step_by(8) {
        // SAFETY: the offsets were checked; batches are 64-byte aligned and have 8 words from `first` on.
        unsafe {
            let p = two_fours(bytes.as_ptr(), offsets, first);
            let q = two_fours(bytes.as_ptr(), offsets, first + 1);
            let r = two_fours(bytes.as_ptr(), offsets, first + 2);
            let s = two_fours(bytes.as_ptr(), offsets, first + 3);
            // Transposes a 4×4 matrix in each 128 bits.
            let (pq, rs) = (_mm256_unpacklo_ps(p, q), _mm256_unpacklo_ps(r, s));
            let first_word = _mm256_shuffle_ps::<0b01_00_01_00>(pq, rs);
            let second = _mm256_shuffle_ps::<0b11_10_11_10>(pq, rs);
            let (pq, rs) = (_mm256_unpackhi_ps(p, q), _mm256_unpackhi_ps(r, s));
            let third = _mm256_shuffle_ps::<0b01_00_01_00>(pq, rs);
            let fourth = _mm256_shuffle_ps::<0b11_10_11_10>(pq, rs);
            for (out, words) in out.iter_mut().zip([first_word, second, third, fourth]) {
                _mm256_store_ps(out.0.as_mut_ptr().add(first).cast::<f32>(), words);
            }
        }
    }
    out
}

/// The four words at every offset.
///
/// # Safety
/// The processor must have AVX-512.
#[inline(always)]
pub unsafe fn avx512_fours(bytes: &[u8], offsets: &U32s) -> [U32s; 4] {
    check::<Avx512>(bytes.len(), offsets, 1, 16);
    let mut out = [U32s::ZERO; 4];
    for first in (0..LANES).step_by(16) {
        // SAFETY: the offsets were checked; batches are 64-byte aligned and have 16 words from `first` on.
        unsafe {
            let p = four_fours(bytes.as_ptr(), offsets, first);
            let q = four_fours(bytes.as_ptr(), offsets, first + 1);
            let r = four_fours(bytes.as_ptr(), offsets, first + 2);
            let s = four_fours(bytes.as_ptr(), offsets, first + 3);
            // Transposes a 4×4 matrix in each 128 bits.
            let (pq, rs) = (_mm512_unpacklo_ps(p, q), _mm512_unpacklo_ps(r, s));
            let first_word = _mm512_shuffle_ps::<0b01_00_01_00>(pq, rs);
            let second = _mm512_shuffle_ps::<0b11_10_11_10>(pq, rs);
            let (pq, rs) = (_mm512_unpackhi_ps(p, q), _mm512_unpackhi_ps(r, s));
            let third = _mm512_shuffle_ps::<0b01_00_01_00>(pq, rs);
            let fourth = _mm512_shuffle_ps::<0b11_10_11_10>(pq, rs);
            for (out, words) in out.iter_mut().zip([first_word, second, third, fourth]) {
                _mm512_store_ps(out.0.as_mut_ptr().add(first).cast::<f32>(), words);
            }
        }
    }
    out
}

/// The address of a lane's bytes. The offset is loaded from memory: extracting it from a vector is slower.
#[inline(always)]
unsafe fn at<const SCALE: usize>(base: *const u8, indices: &U32s, lane: usize) -> *const u8 {
    // SAFETY: a reference is good for a read; the caller guarantees the bytes.
    unsafe { base.add(std::ptr::read_volatile(&raw const indices.0[lane]) as usize * SCALE) }
}

#[inline(always)]
unsafe fn word<const SCALE: usize>(base: *const u8, indices: &U32s, lane: usize) -> i32 {
    // SAFETY: the caller guarantees the bytes.
    unsafe { at::<SCALE>(base, indices, lane).cast::<i32>().read_unaligned() }
}

#[inline(always)]
unsafe fn four_words<const SCALE: usize>(base: *const u8, indices: &U32s, first: usize) -> __m128i {
    // SAFETY: the caller guarantees the bytes.
    unsafe {
        let words = _mm_cvtsi32_si128(word::<SCALE>(base, indices, first));
        let words = _mm_insert_epi32::<1>(words, word::<SCALE>(base, indices, first + 1));
        let words = _mm_insert_epi32::<2>(words, word::<SCALE>(base, indices, first + 2));
        _mm_insert_epi32::<3>(words, word::<SCALE>(base, indices, first + 3))
    }
}

/// # Safety
/// The processor must have AVX2, and the four bytes at `index * SCALE` of eight lanes from `first` on can be read.
#[inline(always)]
pub unsafe fn eight_words<const SCALE: usize>(
    base: *const u8,
    indices: &U32s,
    first: usize,
) -> __m256i {
    // SAFETY: the caller guarantees the bytes.
    unsafe {
        let low = _mm256_castsi128_si256(four_words::<SCALE>(base, indices, first));
        _mm256_inserti128_si256::<1>(low, four_words::<SCALE>(base, indices, first + 4))
    }
}

#[inline(always)]
unsafe fn two_pairs(base: *const u8, offsets: &U32s, first: usize) -> __m128 {
    // SAFETY: the caller guarantees the bytes.
    unsafe {
        let low = at::<1>(base, offsets, first).cast::<f64>().read_unaligned();
        let high = at::<1>(base, offsets, first + 1).cast::<f64>().read_unaligned();
        _mm_castpd_ps(_mm_setr_pd(low, high))
    }
}

/// The pairs of lanes `first`, the next, and the two that are four further.
///
/// # Safety
/// The processor must have AVX2, and the eight bytes at their offsets can be read.
#[inline(always)]
pub unsafe fn four_pairs(base: *const u8, offsets: &U32s, first: usize) -> __m256 {
    // SAFETY: the caller guarantees the bytes.
    unsafe {
        let low = _mm256_castps128_ps256(two_pairs(base, offsets, first));
        _mm256_insertf128_ps::<1>(low, two_pairs(base, offsets, first + 4))
    }
}

/// [`four_pairs`], and those of eight lanes further.
///
/// # Safety
/// The processor must have AVX-512F, and the eight bytes at their offsets can be read.
#[inline(always)]
pub unsafe fn eight_pairs(base: *const u8, offsets: &U32s, first: usize) -> __m512 {
    // SAFETY: the caller guarantees the bytes.
    unsafe {
        let low = _mm256_castps_pd(four_pairs(base, offsets, first));
        let high = _mm256_castps_pd(four_pairs(base, offsets, first + 8));
        _mm512_castpd_ps(_mm512_insertf64x4::<1>(_mm512_castpd256_pd512(low), high))
    }
}

#[inline(always)]
unsafe fn four(base: *const u8, offsets: &U32s, lane: usize) -> __m128 {
    // SAFETY: the caller guarantees the bytes.
    unsafe { _mm_loadu_ps(at::<1>(base, offsets, lane).cast::<f32>()) }
}

/// The four words of lane `first`, and of the one that is four further.
#[inline(always)]
unsafe fn two_fours(base: *const u8, offsets: &U32s, first: usize) -> __m256 {
    // SAFETY: the caller guarantees the bytes.
    unsafe {
        let low = _mm256_castps128_ps256(four(base, offsets, first));
        _mm256_insertf128_ps::<1>(low, four(base, offsets, first + 4))
    }
}

/// [`two_fours`], and those of eight lanes further.
#[inline(always)]
unsafe fn four_fours(base: *const u8, offsets: &U32s, first: usize) -> __m512 {
    // SAFETY: the caller guarantees the bytes.
    unsafe {
        let low = _mm256_castps_pd(two_fours(base, offsets, first));
        let high = _mm256_castps_pd(two_fours(base, offsets, first + 8));
        _mm512_castpd_ps(_mm512_insertf64x4::<1>(_mm512_castpd256_pd512(low), high))
    }
}
