//! The operations of AVX2 and AVX-512.

use crate::lanes::row_walk::{self, RowWalk};
use crate::lanes::simd::{Kernel, Simd, private};
use crate::lanes::weigh::{self, Sums};
use crate::lanes::{F32s, U32s, gather, math, reduce};

/// Rounding by the instruction that AVX has for it; the same bits as [`math`]'s, whose zeros are
/// positive but for `round_even`'s.
macro_rules! rounding_instructions {
    () => {
        #[inline(always)]
        fn floor(x: f32) -> f32 {
            x.floor() + 0.0
        }
        #[inline(always)]
        fn floor_small(x: f32) -> (i32, f32) {
            let whole = x.floor() + 0.0;
            (math::low_bits(whole), whole)
        }
        #[inline(always)]
        fn floor_unsigned(x: f32) -> f32 {
            x.floor()
        }
        #[inline(always)]
        fn ceil(x: f32) -> f32 {
            x.ceil() + 0.0
        }
        #[inline(always)]
        fn trunc(x: f32) -> f32 {
            x.trunc() + 0.0
        }
        #[inline(always)]
        fn round_even(x: f32) -> f32 {
            x.round_ties_even()
        }
    };
}

#[derive(Clone, Copy)]
pub(in crate::lanes) struct Avx2;
impl private::Sealed for Avx2 {}
impl Simd for Avx2 {
    const WIDE: bool = true;
    #[inline(always)]
    fn outlined<K: Kernel>(kernel: K) -> K::Output {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { run_avx2(kernel) }
    }
    rounding_instructions!();
    #[inline(always)]
    fn select_from_sixteen(table: &[f32; 16], numbers: &U32s) -> F32s {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { gather::sixteen::avx2(table, numbers) }
    }
    #[inline(always)]
    fn gather_inline(bytes: &[u8], offsets: &U32s) -> U32s {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { gather::x86::avx2::<1>(bytes, offsets) }
    }
    #[inline(always)]
    fn gather_pairs_inline(bytes: &[u8], offsets: &U32s) -> [U32s; 2] {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { gather::x86::avx2_pairs(bytes, offsets) }
    }
    #[inline(always)]
    fn gather_quads(bytes: &[u8], offsets: &U32s, apart: u32, out: &mut [U32s; 4]) {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { gather::x86::avx2_quads(bytes, offsets, apart, out) }
    }
    #[inline(always)]
    fn gather_fours(bytes: &[u8], offsets: &U32s) -> [U32s; 4] {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { gather::x86::avx2_fours(bytes, offsets) }
    }
    #[inline(always)]
    fn weigh(first: &U32s, second: &U32s, weights: &U32s, sums: &mut Sums) {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { weigh::x86::avx2(first, second, weights, sums) }
    }
    #[inline(always)]
    fn weigh_pairs(bytes: &[u8], offsets: &U32s, apart: u32, weights: &U32s, sums: &mut Sums) {
        gather::check::<Self>(bytes.len(), offsets, 1, 8);
        // SAFETY: the offsets were checked; this type is reached only through `run_avx2`.
        unsafe { weigh::x86::avx2_pairs(bytes.as_ptr(), offsets, apart, weights, sums) }
    }
    #[inline(always)]
    fn weigh_rows(bytes: &[u8], walk: &RowWalk<'_>, sums: &mut Sums) {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { row_walk::avx2(bytes, walk, sums) }
    }
    #[inline(always)]
    fn gather_f32(table: &[f32], indices: &U32s) -> F32s {
        // SAFETY: this type is reached only through `run_avx2`.
        *unsafe { gather::x86::avx2::<4>(bytemuck::cast_slice(table), indices) }.as_f32()
    }
    #[inline(always)]
    fn largest(words: &U32s) -> u32 {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { reduce::avx2(words) }
    }
    #[inline(always)]
    fn any(words: &U32s) -> bool {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { reduce::avx2_any(words) }
    }
    #[inline(always)]
    fn nonzero(words: &U32s) -> u64 {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { reduce::avx2_nonzero(words) }
    }
}

#[derive(Clone, Copy)]
pub(in crate::lanes) struct Avx512;
impl private::Sealed for Avx512 {}
impl Simd for Avx512 {
    const WIDE: bool = true;
    const SELECTS_FROM_ROWS: bool = true;
    #[inline(always)]
    fn outlined<K: Kernel>(kernel: K) -> K::Output {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { run_avx512(kernel) }
    }
    rounding_instructions!();
    #[inline(always)]
    fn gather_inline(bytes: &[u8], offsets: &U32s) -> U32s {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { gather::x86::avx512::<1>(bytes, offsets) }
    }
    #[inline(always)]
    fn gather_pairs_inline(bytes: &[u8], offsets: &U32s) -> [U32s; 2] {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { gather::x86::avx512_pairs(bytes, offsets) }
    }
    #[inline(always)]
    fn select_from_rows(bytes: &[u8], apart: usize, rows: u32, numbers: &U32s) -> U32s {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { gather::rows::avx512(bytes, apart, rows, numbers) }
    }
    #[inline(always)]
    fn select_from_sixteen(table: &[f32; 16], numbers: &U32s) -> F32s {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { gather::sixteen::avx512(table, numbers) }
    }
    #[inline(always)]
    fn gather_fours(bytes: &[u8], offsets: &U32s) -> [U32s; 4] {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { gather::x86::avx512_fours(bytes, offsets) }
    }
    #[inline(always)]
    fn weigh(first: &U32s, second: &U32s, weights: &U32s, sums: &mut Sums) {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { weigh::x86::avx512(first, second, weights, sums) }
    }
    #[inline(always)]
    fn weigh_pairs(bytes: &[u8], offsets: &U32s, apart: u32, weights: &U32s, sums: &mut Sums) {
        gather::check::<Self>(bytes.len(), offsets, 1, 8);
        // SAFETY: the offsets were checked; this type is reached only through `run_avx512`.
        unsafe { weigh::x86::avx512_pairs(bytes.as_ptr(), offsets, apart, weights, sums) }
    }
    #[inline(always)]
    fn weigh_rows(bytes: &[u8], walk: &RowWalk<'_>, sums: &mut Sums) {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { row_walk::avx512(bytes, walk, sums) }
    }
    #[inline(always)]
    fn gather_f32(table: &[f32], indices: &U32s) -> F32s {
        // SAFETY: this type is reached only through `run_avx512`.
        *unsafe { gather::x86::avx512::<4>(bytemuck::cast_slice(table), indices) }.as_f32()
    }
    #[inline(always)]
    fn largest(words: &U32s) -> u32 {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { reduce::avx512(words) }
    }
    #[inline(always)]
    fn any(words: &U32s) -> bool {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { reduce::avx512_any(words) }
    }
    #[inline(always)]
    fn below(words: &U32s, bound: u32) -> bool {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { reduce::avx512_below(words, bound) }
    }
    #[inline(always)]
    fn nonzero(words: &U32s) -> u64 {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { reduce::avx512_nonzero(words) }
    }
}

// `fma` is left out on purpose: nothing here may contract a multiply and an add.
#[inline(never)]
#[target_feature(enable = "avx2,bmi1,bmi2,lzcnt,popcnt")]
pub(super) fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Avx2>()
}

#[inline(never)]
#[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl,avx2,bmi1,bmi2,lzcnt,popcnt")]
pub(super) fn run_avx512<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Avx512>()
}
