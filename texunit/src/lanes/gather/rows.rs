//! Words selected from eight rows of eight words: neighbours in an image, read row by row.

use super::{LANES, U32s};
#[cfg(target_arch = "x86_64")]
use std::arch::x86_64::{
    __m256i, __m512i, _mm256_loadu_si256, _mm512_castsi256_si512, _mm512_inserti64x4,
    _mm512_load_si512, _mm512_mask_blend_epi32, _mm512_permutex2var_epi32, _mm512_set1_epi32,
    _mm512_store_si512, _mm512_test_epi32_mask,
};

/// Rows, and words of a row.
const SIDE: usize = 8;

/// The bytes of a row.
const ROW_BYTES: usize = 4 * SIDE;

/// Where each row begins.
///
/// # Panics
/// When not all rows are inside `len` bytes, or there are none.
#[inline(always)]
fn row_offsets(len: usize, apart: usize, rows: u32) -> [usize; SIDE] {
    assert!(rows > 0 && len >= ROW_BYTES, "no row in {len} bytes");
    let last = (rows as usize).min(SIDE) - 1;
    assert!(apart <= (len - ROW_BYTES) / last.max(1) || last == 0, "row {last} of {len} bytes");
    let mut offsets = [0; SIDE];
    for (row, offset) in offsets.iter_mut().enumerate() {
        *offset = row.min(last) * apart;
    }
    offsets
}

/// [`super::Simd::select_from_rows`].
#[inline(never)]
pub fn scalar(bytes: &[u8], apart: usize, rows: u32, numbers: &U32s) -> U32s {
    let offsets = row_offsets(bytes.len(), apart, rows);
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        let (row, column) = (numbers[lane] as usize / SIDE % SIDE, numbers[lane] as usize % SIDE);
        let at = offsets[row] + 4 * column;
        // SAFETY: `row_offsets` saw that each row is inside `bytes`.
        out[lane] = u32::from_le(unsafe { bytes.as_ptr().add(at).cast::<u32>().read_unaligned() });
    }
    out
}

/// [`super::Simd::select_from_rows`].
///
/// # Safety
/// The processor must have AVX-512.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub unsafe fn avx512(bytes: &[u8], apart: usize, rows: u32, numbers: &U32s) -> U32s {
    let offsets = row_offsets(bytes.len(), apart, rows);
    let mut out = U32s::ZERO;
    // SAFETY: `row_offsets` saw that each row is inside `bytes`; batches are 64-byte aligned.
    unsafe {
        let row =
            |row: usize| _mm256_loadu_si256(bytes.as_ptr().add(offsets[row]).cast::<__m256i>());
        let two = |first: usize| {
            _mm512_inserti64x4::<1>(_mm512_castsi256_si512(row(first)), row(first + 1))
        };
        let (a, b, c, d) = (two(0), two(2), two(4), two(6));
        let upper = _mm512_set1_epi32(32);
        for first in (0..LANES).step_by(16) {
            let numbers = _mm512_load_si512(numbers.0.as_ptr().add(first).cast::<__m512i>());
            let low = _mm512_permutex2var_epi32(a, numbers, b);
            let high = _mm512_permutex2var_epi32(c, numbers, d);
            let is_high = _mm512_test_epi32_mask(numbers, upper);
            let words = _mm512_mask_blend_epi32(is_high, low, high);
            _mm512_store_si512(out.0.as_mut_ptr().add(first).cast::<__m512i>(), words);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::super::{Isa, Kernel, Simd};
    use super::*;

    struct Select<'a>(&'a [u8], usize, u32, &'a U32s);
    impl Kernel for Select<'_> {
        type Output = U32s;
        #[inline(always)]
        fn run<S: Simd>(self) -> U32s {
            let Self(bytes, apart, rows, numbers) = self;
            S::select_from_rows(bytes, apart, rows, numbers)
        }
    }

    #[test]
    fn every_instruction_set_selects_the_same_words_up_to_the_last_byte() {
        let numbers = U32s::from_fn(|lane| (lane as u32 * 29) ^ (lane as u32) << 9);
        for (apart, rows) in [(32, 8), (32, 1), (33, 3), (40, 20), (1, 5), (0, 8), (4096, 2)] {
            let last = (rows as usize).min(SIDE) - 1;
            // Exactly as many as are read, so that Miri detects a read past the end.
            let bytes: Box<[u8]> =
                (0..last * apart + ROW_BYTES).map(|at| (at * 7 + at / 251) as u8).collect();
            for isa in Isa::available() {
                let got = isa.run(Select(&bytes, apart, rows, &numbers));
                for lane in 0..LANES {
                    let number = numbers[lane] as usize % 64;
                    let at = (number / 8).min(last) * apart + number % 8 * 4;
                    let want = u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
                    assert_eq!(got[lane], want, "{} {apart} {rows} lane {lane}", isa.name());
                }
            }
        }
    }

    #[test]
    #[cfg_attr(target_family = "wasm", ignore = "a panic ends the program there")]
    fn rows_outside_the_slice_panic() {
        for isa in Isa::available() {
            for (length, apart, rows) in
                [(31, 0, 1), (32, 1, 2), (63, 32, 2), (32 + 7 * 40 - 1, 40, 9), (64, usize::MAX, 3)]
            {
                let bytes = vec![0; length].into_boxed_slice();
                let select = || isa.run(Select(&bytes, apart, rows, &U32s::ZERO));
                assert!(std::panic::catch_unwind(select).is_err(), "{length} {apart} {rows}");
            }
            let none = || isa.run(Select(&[0; 64], 0, 0, &U32s::ZERO));
            assert!(std::panic::catch_unwind(none).is_err());
        }
    }
}
