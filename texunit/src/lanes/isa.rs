//! Which instruction set a kernel is compiled for, and the one place that picks.

mod baseline;
#[cfg(test)]
mod tests;
#[cfg(target_arch = "x86_64")]
pub(super) mod x86;

pub use baseline::Baseline;

use super::code::Target;
use super::simd::Kernel;
use baseline::run_baseline;
use thiserror::Error;
#[cfg(target_arch = "x86_64")]
use x86::{run_avx2, run_avx512};

/// An instruction set that this processor has, and how shaders run on it. Values exist only for instruction sets that
/// were detected, which is what makes [`Isa::run`] safe.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Isa {
    level: IsaLevel,
    shaders: ShaderExecution,
}

/// How the straight code of shaders runs. The bits are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
enum ShaderExecution {
    Interpreted,
    /// As machine code, where it can be made ([`super::code`]).
    Compiled,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
enum IsaLevel {
    Baseline,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl IsaLevel {
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
    pub const BASELINE: Self = Self::new(IsaLevel::Baseline);

    const fn new(level: IsaLevel) -> Self {
        let shaders = match level {
            IsaLevel::Baseline => ShaderExecution::Interpreted,
            #[cfg(target_arch = "x86_64")]
            IsaLevel::Avx2 | IsaLevel::Avx512 => ShaderExecution::Compiled,
        };
        Self { level, shaders }
    }

    /// The same instruction set without machine code for shaders.
    pub const fn interpreting(self) -> Self {
        Self { shaders: ShaderExecution::Interpreted, ..self }
    }

    /// [`Self::available`], and those of them that compile shaders again without that.
    pub fn executions() -> Vec<Self> {
        let available = Self::available();
        let compiling = available.iter().filter(|isa| isa.shaders == ShaderExecution::Compiled);
        let interpreting: Vec<_> = compiling.map(|isa| isa.interpreting()).collect();
        [available, interpreting].concat()
    }

    /// What machine code of shaders is made for; `None` where they are interpreted.
    pub(super) fn code_target(self) -> Option<Target> {
        match (self.shaders, self.level) {
            (ShaderExecution::Interpreted, _) | (_, IsaLevel::Baseline) => None,
            #[cfg(target_arch = "x86_64")]
            (ShaderExecution::Compiled, IsaLevel::Avx2) => Some(Target::Avx2),
            #[cfg(target_arch = "x86_64")]
            (ShaderExecution::Compiled, IsaLevel::Avx512) => Some(Target::Avx512),
        }
    }

    /// Every instruction set of this processor, from the plainest to the widest.
    pub fn available() -> Vec<Self> {
        IsaLevel::ALL.iter().copied().filter(|level| level.is_there()).map(Self::new).collect()
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

    /// The instruction set called `baseline`, `avx2` or `avx512`; with `-interpreter` after the name, without machine
    /// code for shaders.
    ///
    /// # Errors
    /// When the name is none of these or this processor lacks it.
    pub fn by_name(name: &str) -> Result<Self, IsaError> {
        let available = Self::executions();
        available.iter().copied().find(|isa| isa.name() == name).ok_or_else(|| IsaError {
            asked: name.to_owned(),
            available: available.iter().map(|isa| isa.name()).collect::<Vec<_>>().join(", "),
        })
    }

    /// The name that `DETGL_ISA` takes.
    pub fn name(self) -> &'static str {
        match (self.level, self.shaders) {
            (IsaLevel::Baseline, _) => "baseline",
            #[cfg(target_arch = "x86_64")]
            (IsaLevel::Avx2, ShaderExecution::Compiled) => "avx2",
            #[cfg(target_arch = "x86_64")]
            (IsaLevel::Avx2, ShaderExecution::Interpreted) => "avx2-interpreter",
            #[cfg(target_arch = "x86_64")]
            (IsaLevel::Avx512, ShaderExecution::Compiled) => "avx512",
            #[cfg(target_arch = "x86_64")]
            (IsaLevel::Avx512, ShaderExecution::Interpreted) => "avx512-interpreter",
        }
    }

    /// Whether kernels have fast paths on it, see [`Simd::WIDE`](super::Simd::WIDE).
    pub fn is_wide(self) -> bool {
        self.level != IsaLevel::Baseline
    }

    /// Runs `kernel` as compiled for this instruction set.
    #[inline]
    pub fn run<K: Kernel>(self, kernel: K) -> K::Output {
        match self.level {
            IsaLevel::Baseline => run_baseline(kernel),
            // SAFETY: the value exists, so the processor has these features.
            #[cfg(target_arch = "x86_64")]
            IsaLevel::Avx2 => unsafe { run_avx2(kernel) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            IsaLevel::Avx512 => unsafe { run_avx512(kernel) },
        }
    }
}

impl Isa {
    /// As [`Self::run`], but returns the kernel on the baseline: for large kernels that the baseline has in another
    /// form.
    #[inline]
    pub(crate) fn run_above_baseline<K: Kernel>(self, kernel: K) -> Result<K::Output, K> {
        match self.level {
            IsaLevel::Baseline => Err(kernel),
            // SAFETY: the value exists, so the processor has these features.
            #[cfg(target_arch = "x86_64")]
            IsaLevel::Avx2 => Ok(unsafe { run_avx2(kernel) }),
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            IsaLevel::Avx512 => Ok(unsafe { run_avx512(kernel) }),
        }
    }
}
