//! Which instruction set a kernel is compiled for, and the one place that picks.

#[cfg(test)]
mod tests;

#[cfg(target_arch = "x86_64")]
use super::math;
use super::simd::{Kernel, Simd, private};
#[cfg(target_arch = "x86_64")]
use super::walk::{self, Walk};
use super::weigh::{self, Sums};
use super::{F32s, U32s};
use super::{gather, reduce};
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

    /// Whether kernels have shorter ways on it, see [`Simd::WIDE`].
    pub fn is_wide(self) -> bool {
        self != Self::BASELINE
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
    fn gather_squares(bytes: &[u8], offsets: &U32s, apart: u32, out: &mut [U32s; 4]) {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { gather::x86::avx2_squares(bytes, offsets, apart, out) }
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
    fn weigh_walk(bytes: &[u8], walk: &Walk<'_>, sums: &mut Sums) {
        // SAFETY: this type is reached only through `run_avx2`.
        unsafe { walk::avx2(bytes, walk, sums) }
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
