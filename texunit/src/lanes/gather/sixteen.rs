//! Numbers selected from sixteen.

use super::{F32s, LANES, U32s};
#[cfg(target_arch = "x86_64")]
use std::arch::x86_64::{
    __m256i, __m512i, _mm256_blendv_ps, _mm256_castsi256_ps, _mm256_load_si256, _mm256_loadu_ps,
    _mm256_permutevar8x32_ps, _mm256_slli_epi32, _mm256_store_ps, _mm512_load_si512,
    _mm512_loadu_ps, _mm512_permutexvar_ps, _mm512_store_ps,
};

/// [`super::Simd::select_from_sixteen`].
#[inline(always)]
pub fn scalar(table: &[f32; 16], numbers: &U32s) -> F32s {
    let mut out = F32s::ZERO;
    for lane in 0..LANES {
        out[lane] = table[numbers[lane] as usize % 16];
    }
    out
}

/// [`super::Simd::select_from_sixteen`].
///
/// # Safety
/// The processor must have AVX2.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub unsafe fn avx2(table: &[f32; 16], numbers: &U32s) -> F32s {
    let mut out = F32s::ZERO;
    // SAFETY: the table has twice eight numbers; batches are 64-byte aligned.
    unsafe {
        let low = _mm256_loadu_ps(table.as_ptr());
        let high = _mm256_loadu_ps(table.as_ptr().add(8));
        for first in (0..LANES).step_by(8) {
            let numbers = _mm256_load_si256(numbers.0.as_ptr().add(first).cast::<__m256i>());
            // The fourth bit, as the sign that the blend looks at.
            let is_high = _mm256_castsi256_ps(_mm256_slli_epi32::<28>(numbers));
            let low = _mm256_permutevar8x32_ps(low, numbers);
            let high = _mm256_permutevar8x32_ps(high, numbers);
            let selected = _mm256_blendv_ps(low, high, is_high);
            _mm256_store_ps(out.0.as_mut_ptr().add(first), selected);
        }
    }
    out
}

/// [`super::Simd::select_from_sixteen`].
///
/// # Safety
/// The processor must have AVX-512.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub unsafe fn avx512(table: &[f32; 16], numbers: &U32s) -> F32s {
    let mut out = F32s::ZERO;
    // SAFETY: the table has sixteen numbers; batches are 64-byte aligned.
    unsafe {
        let table = _mm512_loadu_ps(table.as_ptr());
        for first in (0..LANES).step_by(16) {
            let numbers = _mm512_load_si512(numbers.0.as_ptr().add(first).cast::<__m512i>());
            let selected = _mm512_permutexvar_ps(numbers, table);
            _mm512_store_ps(out.0.as_mut_ptr().add(first), selected);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::super::{Isa, Kernel, Simd};
    use super::*;

    struct Select<'a>(&'a [f32; 16], &'a U32s);
    impl Kernel for Select<'_> {
        type Output = F32s;
        #[inline(always)]
        fn run<S: Simd>(self) -> F32s {
            S::select_from_sixteen(self.0, self.1)
        }
    }

    #[test]
    fn every_instruction_set_selects_by_the_lowest_four_bits() {
        let table = std::array::from_fn(|at| at as f32 * 1.5 - 3.0);
        let numbers = U32s::from_fn(|lane| (lane as u32).wrapping_mul(0x9e37_79b9) ^ lane as u32);
        for isa in Isa::available() {
            let got = isa.run(Select(&table, &numbers));
            for lane in 0..LANES {
                let want = table[numbers[lane] as usize % 16];
                assert_eq!(got[lane], want, "{} lane {lane}", isa.name());
            }
        }
    }
}
