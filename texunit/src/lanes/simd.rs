//! The traits of kernels, and of the operations that an instruction set ([`super::isa`]) provides.

use super::row_walk::{self, RowWalk};
use super::weigh::Sums;
use super::{F32s, LANES, U32s};
use super::{Sources, gather, math};

/// One body of loops over lanes, compiled once per instruction set.
///
/// `run`, and every function it calls on the hot path, must be `#[inline(always)]`: only what is
/// inlined is compiled for the instruction set. What is not is correct, but slow.
pub trait Kernel {
    /// The kernel's result.
    type Output;
    /// The body. `S` provides the few operations that LLVM does not find by itself.
    fn run<S: Simd>(self) -> Self::Output;
}

/// The operations that plain loops do not reach on every instruction set.
pub trait Simd: Copy + private::Sealed {
    /// Whether kernels should have fast paths beside the general code. False on the baseline, for code size.
    const WIDE: bool;

    /// Whether [`Simd::select_from_rows`] is faster than a gather.
    const SELECTS_FROM_ROWS: bool = false;

    /// Calls a kernel of the same instruction set without inlining it: for large code that is used in many places.
    fn outlined<K: Kernel>(kernel: K) -> K::Output;

    /// Inlines a kernel if the instruction set is wide, else calls it.
    #[inline(always)]
    fn outlined_unless_wide<K: Kernel>(kernel: K) -> K::Output {
        if Self::WIDE { kernel.run::<Self>() } else { Self::outlined(kernel) }
    }

    /// Reads the four bytes at each byte offset as a little-endian word.
    ///
    /// # Panics
    /// When an offset's four bytes are not all inside `bytes`.
    #[inline(always)]
    fn gather(bytes: &[u8], offsets: &U32s) -> U32s {
        Self::outlined(gather::Words { bytes, offsets })
    }

    /// Reads the eight bytes at each byte offset as two little-endian words: two adjacent texels of four bytes.
    ///
    /// # Panics
    /// When an offset's eight bytes are not all inside `bytes`.
    #[inline(always)]
    fn gather_pairs(bytes: &[u8], offsets: &U32s) -> [U32s; 2] {
        Self::outlined(gather::Pairs { bytes, offsets })
    }

    /// Reads the sixteen bytes at each byte offset as four little-endian words.
    ///
    /// # Panics
    /// When an offset's sixteen bytes are not all inside `bytes`.
    fn gather_fours(bytes: &[u8], offsets: &U32s) -> [U32s; 4];

    /// [`Simd::gather`], inlined: a kilobyte of code per use.
    fn gather_inline(bytes: &[u8], offsets: &U32s) -> U32s;

    /// [`Simd::gather_pairs`], inlined: a kilobyte of code per use.
    fn gather_pairs_inline(bytes: &[u8], offsets: &U32s) -> [U32s; 2];

    /// Reads word number `numbers` of eight rows of eight words, which lie `apart` bytes apart; of the number, the lowest
    /// six bits are read. There are `rows` rows; those beyond are the last one.
    ///
    /// # Panics
    /// When not all rows are inside `bytes`, or there are none.
    #[inline(always)]
    fn select_from_rows(bytes: &[u8], apart: usize, rows: u32, numbers: &U32s) -> U32s {
        gather::rows::scalar(bytes, apart, rows, numbers)
    }

    /// Number `numbers` of a table; of it, the lowest four bits are read.
    #[inline(always)]
    fn select_from_sixteen(table: &[f32; 16], numbers: &U32s) -> F32s {
        gather::sixteen::scalar(table, numbers)
    }

    /// [`Simd::gather_pairs_inline`] at each byte offset, and `apart` bytes further: the 2×2 texels of a linear filter.
    ///
    /// # Panics
    /// When not all of these bytes are inside `bytes`.
    #[inline(always)]
    fn gather_quads(bytes: &[u8], offsets: &U32s, apart: u32, out: &mut [U32s; 4]) {
        let above = bytes.get(apart as usize..).unwrap_or(&[]);
        let [a, b] = Self::gather_pairs_inline(bytes, offsets);
        let [c, d] = Self::gather_pairs_inline(above, offsets);
        *out = [a, b, c, d];
    }

    /// Adds to the sum of each byte the bytes of two texels: `first` times the lower half of the
    /// weight, `second` times its upper half. Weights are up to 2^15 - 1.
    fn weigh(first: &U32s, second: &U32s, weights: &U32s, sums: &mut Sums);

    /// [`Simd::weigh`] of the texel of `apart` bytes (3 or 4) at each byte offset and the one right
    /// after. (Of three bytes the sum of the fourth means nothing.)
    ///
    /// # Panics
    /// When an offset's eight bytes are not all inside `bytes`.
    fn weigh_pairs(bytes: &[u8], offsets: &U32s, apart: u32, weights: &U32s, sums: &mut Sums);

    /// [`Simd::weigh`] of the texels of a row walk. Offsets beyond the end are clamped to the last read inside `bytes`.
    ///
    /// # Panics
    /// When `bytes` are fewer than one read (eight, where texels of 3 or 4 bytes are neighbours, else
    /// four), or more than 2^31 - 1.
    #[inline(always)]
    fn weigh_rows(bytes: &[u8], walk: &RowWalk<'_>, sums: &mut Sums) {
        row_walk::sum_rows::<Self>(bytes, walk, sums);
    }

    /// Reads the word at each byte offset of the slice of this number, which each lane has for itself.
    ///
    /// # Panics
    /// When an offset's four bytes are not all inside its slice.
    #[inline(always)]
    fn gather_from(sources: &Sources<'_>, numbers: &U32s, offsets: &U32s) -> U32s {
        Self::outlined(gather::WordsFrom { sources, numbers, offsets })
    }

    /// [`Simd::gather_quads`] of the slice of this number; number and `apart` are of each lane for itself.
    ///
    /// # Panics
    /// When not all of these bytes are inside its slice.
    #[inline(always)]
    fn gather_quads_from(
        sources: &Sources<'_>,
        numbers: &U32s,
        offsets: &U32s,
        apart: &U32s,
        out: &mut [U32s; 4],
    ) {
        Self::outlined(gather::QuadsFrom { sources, numbers, offsets, apart, out });
    }

    /// Reads `table[index]` in each lane.
    ///
    /// # Panics
    /// When an index is not inside `table`.
    fn gather_f32(table: &[f32], indices: &U32s) -> F32s;

    /// The largest lane.
    fn largest(words: &U32s) -> u32;

    /// The smallest lane.
    #[inline(always)]
    fn smallest(words: &U32s) -> u32 {
        let mut turned = U32s::ZERO;
        for lane in 0..LANES {
            turned[lane] = !words[lane];
        }
        !Self::largest(&turned)
    }

    /// Whether any lane is not 0.
    fn any(words: &U32s) -> bool;

    /// Whether every lane is below `bound`.
    #[inline(always)]
    fn below(words: &U32s, bound: u32) -> bool {
        Self::largest(words) < bound
    }

    /// One bit per lane: whether it is not 0.
    fn nonzero(words: &U32s) -> u64;

    /// Reads `table[word >> shift & 0xFF]` in each lane; `shift` is 0, 8, 16 or 24.
    #[inline(always)]
    fn lookup(table: &[f32; 256], words: &U32s, shift: u32) -> F32s {
        Self::gather_f32(table, &gather::bytes(words, shift))
    }

    /// [`math::floor`] of one lane.
    #[inline(always)]
    fn floor(x: f32) -> f32 {
        math::floor(x)
    }

    /// [`Simd::floor`] of one lane, whose zero has any sign.
    #[inline(always)]
    fn floor_unsigned(x: f32) -> f32 {
        math::floor(x)
    }

    /// [`math::floor_small`] of one lane that is known to be small; of others some integer.
    #[inline(always)]
    fn floor_small(x: f32) -> (i32, f32) {
        math::floor_small(x)
    }

    /// [`math::ceil`] of one lane.
    #[inline(always)]
    fn ceil(x: f32) -> f32 {
        math::ceil(x)
    }

    /// [`math::trunc`] of one lane.
    #[inline(always)]
    fn trunc(x: f32) -> f32 {
        math::trunc(x)
    }

    /// [`math::round_even`] of one lane.
    #[inline(always)]
    fn round_even(x: f32) -> f32 {
        math::round_even(x)
    }
}

pub(super) mod private {
    /// Keeps [`super::Simd`] to the instruction sets of [`super::super::isa`].
    pub trait Sealed {}
}
