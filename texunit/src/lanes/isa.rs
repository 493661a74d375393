//! Which instruction set a kernel is compiled for, and the one place that picks.

#[cfg(test)]
mod tests;

use super::walk::{self, Walk};
use super::weigh::{self, Sums};
use super::{F32s, LANES, U32s};
use super::{gather, math, reduce};
use thiserror::Error;

/// An instruction set that this processor has. Values exist only for instruction sets that were
/// detected, which is what makes [`Isa::run`] safe.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Isa(Level);

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
enum Level {
    Baseline,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Level {
    /// Every level of this architecture, from the plainest to the widest.
    const ALL: &'static [Self] = &[
        Self::Baseline,
        #[cfg(target_arch = "x86_64")]
        Self::Avx2,
        #[cfg(target_arch = "x86_64")]
        Self::Avx512,
    ];

    /// Whether this processor has every feature that the level's kernels are compiled with.
    fn is_there(self) -> bool {
        match self {
            Self::Baseline => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => {
                is_x86_feature_detected!("avx2")
                    && is_x86_feature_detected!("bmi1")
                    && is_x86_feature_detected!("bmi2")
                    && is_x86_feature_detected!("lzcnt")
                    && is_x86_feature_detected!("popcnt")
            }
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => {
                Self::Avx2.is_there()
                    && is_x86_feature_detected!("avx512f")
                    && is_x86_feature_detected!("avx512bw")
                    && is_x86_feature_detected!("avx512dq")
                    && is_x86_feature_detected!("avx512vl")
            }
        }
    }
}

/// `DETGL_ISA` asked for something this machine does not have.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("DETGL_ISA={asked}: this machine has {available}; unset it to take the best of them")]
pub struct IsaError {
    asked: String,
    available: String,
}

impl Isa {
    /// The plain target of the build: SSE2 on x86-64, NEON on AArch64.
    pub const BASELINE: Self = Self(Level::Baseline);

    /// Every instruction set of this processor, from the plainest to the widest.
    pub fn available() -> Vec<Self> {
        Level::ALL.iter().copied().filter(|level| level.is_there()).map(Self).collect()
    }

    /// The widest instruction set of this processor.
    pub fn best() -> Self {
        Self::available().into_iter().max().unwrap_or(Self::BASELINE)
    }

    /// The instruction set named by `DETGL_ISA`, else the widest.
    ///
    /// # Errors
    /// When the variable names an instruction set that does not exist or that this processor lacks.
    pub fn from_env() -> Result<Self, IsaError> {
        match std::env::var("DETGL_ISA") {
            Ok(name) => Self::by_name(&name),
            Err(_) => Ok(Self::best()),
        }
    }

    /// The instruction set called `baseline`, `avx2` or `avx512`.
    ///
    /// # Errors
    /// When the name is none of these or this processor lacks it.
    pub fn by_name(name: &str) -> Result<Self, IsaError> {
        let available = Self::available();
        available.iter().copied().find(|isa| isa.name() == name).ok_or_else(|| IsaError {
            asked: name.to_owned(),
            available: available.iter().map(|isa| isa.name()).collect::<Vec<_>>().join(", "),
        })
    }

    /// The name that `DETGL_ISA` takes.
    pub fn name(self) -> &'static str {
        match self.0 {
            Level::Baseline => "baseline",
            #[cfg(target_arch = "x86_64")]
            Level::Avx2 => "avx2",
            #[cfg(target_arch = "x86_64")]
            Level::Avx512 => "avx512",
        }
    }

    /// Runs `kernel` as compiled for this instruction set.
    #[inline]
    pub fn run<K: Kernel>(self, kernel: K) -> K::Output {
        match self.0 {
            Level::Baseline => run_baseline(kernel),
            // SAFETY: the value exists, so the processor was seen to have these features.
            #[cfg(target_arch = "x86_64")]
            Level::Avx2 => unsafe { run_avx2(kernel) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            Level::Avx512 => unsafe { run_avx512(kernel) },
        }
    }
}

impl Isa {
    /// As [`Self::run`], but gives the kernel back where it would be compiled for the baseline: for
    /// those that are large, and there already in another form.
    #[inline]
    pub(crate) fn run_above_baseline<K: Kernel>(self, kernel: K) -> Result<K::Output, K> {
        match self.0 {
            Level::Baseline => Err(kernel),
            // SAFETY: the value exists, so the processor was seen to have these features.
            #[cfg(target_arch = "x86_64")]
            Level::Avx2 => Ok(unsafe { run_avx2(kernel) }),
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            Level::Avx512 => Ok(unsafe { run_avx512(kernel) }),
        }
    }
}

/// One body of loops over lanes, compiled once per instruction set.
///
/// `run`, and every function it calls on the hot path, must be `#[inline(always)]`: only what is
/// inlined takes on the instruction set. What is not inlined is still right, only slower.
pub trait Kernel {
    /// What the kernel gives back.
    type Output;
    /// The body. `S` provides the few operations that LLVM does not find by itself.
    fn run<S: Simd>(self) -> Self::Output;
}

/// The operations that plain loops do not reach on every instruction set.
pub trait Simd: Copy + private::Sealed {
    /// Whether it is worth the size of a kernel to have a shorter way beside one that does as well.
    const WIDE: bool;

    /// Runs a kernel of the same instruction set as a function of its own: for what is large, and stands in
    /// many places.
    fn apart<K: Kernel>(kernel: K) -> K::Output;

    /// Reads the four bytes at each byte offset as a little-endian word.
    ///
    /// # Panics
    /// When an offset's four bytes are not all inside `bytes`.
    #[inline(always)]
    fn gather(bytes: &[u8], offsets: &U32s) -> U32s {
        Self::apart(gather::Words { bytes, offsets })
    }

    /// Reads the eight bytes at each byte offset as two little-endian words: two neighbouring
    /// texels for the price of one.
    ///
    /// # Panics
    /// When an offset's eight bytes are not all inside `bytes`.
    #[inline(always)]
    fn gather_pairs(bytes: &[u8], offsets: &U32s) -> [U32s; 2] {
        Self::apart(gather::Pairs { bytes, offsets })
    }

    /// [`Simd::gather`] without a call: a kilobyte in each place.
    fn gather_here(bytes: &[u8], offsets: &U32s) -> U32s;

    /// [`Simd::gather_pairs`] without a call: a kilobyte in each place.
    fn gather_pairs_here(bytes: &[u8], offsets: &U32s) -> [U32s; 2];

    /// Adds to the sum of each byte the bytes of two texels: `first` times the lower half of the
    /// weight, `second` times its upper half. Weights are up to 2^15 - 1.
    fn weigh(first: &U32s, second: &U32s, weights: &U32s, sums: &mut Sums);

    /// [`Simd::weigh`] of the texel of `apart` bytes (3 or 4) at each byte offset and the one right
    /// after. (Of three bytes the sum of the fourth means nothing.)
    ///
    /// # Panics
    /// When an offset's eight bytes are not all inside `bytes`.
    fn weigh_pairs(bytes: &[u8], offsets: &U32s, apart: u32, weights: &U32s, sums: &mut Sums);

    /// [`Simd::weigh`] of the texels that a walk over rows comes by. Reads beyond `bytes` are of the
    /// last ones.
    ///
    /// # Panics
    /// When `bytes` are fewer than one read (eight, where texels of 3 or 4 bytes are neighbours, else
    /// four), or more than 2^31 - 1.
    #[inline(always)]
    fn weigh_walk(bytes: &[u8], walk: &Walk<'_>, sums: &mut Sums) {
        walk::by_rows::<Self>(bytes, walk, sums);
    }

    /// Reads `table[index]` in each lane.
    ///
    /// # Panics
    /// When an index is not inside `table`.
    fn gather_f32(table: &[f32], indices: &U32s) -> F32s;

    /// The largest of the 64.
    fn largest(words: &U32s) -> u32;

    /// The smallest of the 64.
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

    /// Which lanes are not 0, bit by lane.
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

/// Rounding by the instruction that AVX has for it; the same bits as [`math`]'s, whose zeros are
/// positive but for `round_even`'s.
#[cfg(target_arch = "x86_64")]
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

mod private {
    /// Keeps [`super::Simd`] to the instruction sets of this module.
    pub trait Sealed {}
}

/// Plain operations, for one lane outside of a kernel too.
#[derive(Clone, Copy, Debug)]
pub struct Baseline;
impl private::Sealed for Baseline {}
impl Simd for Baseline {
    const WIDE: bool = false;
    #[inline(always)]
    fn apart<K: Kernel>(kernel: K) -> K::Output {
        run_baseline(kernel)
    }
    #[inline(always)]
    fn gather_here(bytes: &[u8], offsets: &U32s) -> U32s {
        gather::scalar(bytes, offsets)
    }
    #[inline(always)]
    fn gather_pairs_here(bytes: &[u8], offsets: &U32s) -> [U32s; 2] {
        gather::scalar_pairs(bytes, offsets)
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

#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy)]
pub(super) struct Avx2;
#[cfg(target_arch = "x86_64")]
impl private::Sealed for Avx2 {}
#[cfg(target_arch = "x86_64")]
impl Simd for Avx2 {
    const WIDE: bool = true;
    #[inline(always)]
    fn apart<K: Kernel>(kernel: K) -> K::Output {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { run_avx2(kernel) }
    }
    rounding_instructions!();
    #[inline(always)]
    fn gather_here(bytes: &[u8], offsets: &U32s) -> U32s {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { gather::x86::avx2::<1>(bytes, offsets) }
    }
    #[inline(always)]
    fn gather_pairs_here(bytes: &[u8], offsets: &U32s) -> [U32s; 2] {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { gather::x86::avx2_pairs(bytes, offsets) }
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

#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy)]
pub(super) struct Avx512;
#[cfg(target_arch = "x86_64")]
impl private::Sealed for Avx512 {}
#[cfg(target_arch = "x86_64")]
impl Simd for Avx512 {
    const WIDE: bool = true;
    #[inline(always)]
    fn apart<K: Kernel>(kernel: K) -> K::Output {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { run_avx512(kernel) }
    }
    rounding_instructions!();
    #[inline(always)]
    fn gather_here(bytes: &[u8], offsets: &U32s) -> U32s {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { gather::x86::avx512::<1>(bytes, offsets) }
    }
    #[inline(always)]
    fn gather_pairs_here(bytes: &[u8], offsets: &U32s) -> [U32s; 2] {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { gather::x86::avx512_pairs(bytes, offsets) }
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
    fn weigh_walk(bytes: &[u8], walk: &Walk<'_>, sums: &mut Sums) {
        // SAFETY: this type is reached only through `run_avx512`.
        unsafe { walk::avx512(bytes, walk, sums) }
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

/// Once for each kernel, not for each place that runs it.
#[inline(never)]
fn run_baseline<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Baseline>()
}

// `fma` is left out on purpose: nothing here may contract a multiply and an add.
#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx2,bmi1,bmi2,lzcnt,popcnt")]
fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Avx2>()
}

#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl,avx2,bmi1,bmi2,lzcnt,popcnt")]
fn run_avx512<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Avx512>()
}
