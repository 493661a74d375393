//! Plain operations, on every machine.

use crate::lanes::simd::{Kernel, Simd, private};
use crate::lanes::weigh::{self, Sums};
use crate::lanes::{F32s, U32s, gather, reduce};

/// Plain operations, for one lane outside of a kernel too.
#[derive(Clone, Copy, Debug)]
pub struct Baseline;
impl private::Sealed for Baseline {}
impl Simd for Baseline {
    const WIDE: bool = false;
    #[inline(always)]
    fn outlined<K: Kernel>(kernel: K) -> K::Output {
        run_baseline(kernel)
    }
    #[inline(always)]
    fn gather_inline(bytes: &[u8], offsets: &U32s) -> U32s {
        gather::scalar(bytes, offsets)
    }
    #[inline(always)]
    fn gather_pairs_inline(bytes: &[u8], offsets: &U32s) -> [U32s; 2] {
        gather::scalar_pairs(bytes, offsets)
    }
    #[inline(always)]
    fn gather_fours(bytes: &[u8], offsets: &U32s) -> [U32s; 4] {
        gather::scalar_fours(bytes, offsets)
    }
    #[inline(always)]
    fn weigh(first: &U32s, second: &U32s, weights: &U32s, sums: &mut Sums) {
        weigh::scalar(first, second, weights, sums);
    }
    #[inline(always)]
    fn weigh_pairs(bytes: &[u8], offsets: &U32s, apart: u32, weights: &U32s, sums: &mut Sums) {
        weigh::scalar_pairs(bytes, offsets, apart, weights, sums);
    }
    #[inline(always)]
    fn gather_f32(table: &[f32], indices: &U32s) -> F32s {
        gather::scalar_f32(table, indices)
    }
    #[inline(always)]
    fn largest(words: &U32s) -> u32 {
        reduce::scalar(words)
    }
    #[inline(always)]
    fn any(words: &U32s) -> bool {
        reduce::scalar_any(words)
    }
    #[inline(always)]
    fn nonzero(words: &U32s) -> u64 {
        reduce::scalar_nonzero(words)
    }
}

/// Not inlined: one copy per kernel, not per call.
#[inline(never)]
pub(super) fn run_baseline<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Baseline>()
}
