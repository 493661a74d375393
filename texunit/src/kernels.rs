//! Which kernels ran: a log for tests that hold that checks reach every kernel. Builds without debug assertions have no
//! log: noting is no code there.

use std::sync::atomic::{AtomicU64, Ordering};

/// Kernels by number, below 64, that ran since the log was last taken.
#[derive(Debug, Default)]
pub struct KernelLog(AtomicU64);

impl KernelLog {
    /// An empty log.
    pub const fn new() -> Self {
        Self(AtomicU64::new(0))
    }

    /// Notes that a kernel ran.
    #[inline(always)]
    pub fn note(&self, number: u32) {
        if cfg!(debug_assertions) {
            let bit = 1 << number;
            // Most calls find it noted; what all threads only read is not moved between processors.
            if self.0.load(Ordering::Relaxed) & bit == 0 {
                self.0.fetch_or(bit, Ordering::Relaxed);
            }
        }
    }

    /// The kernels that ran since the last call, bit by number.
    pub fn take(&self) -> u64 {
        self.0.swap(0, Ordering::Relaxed)
    }
}

/// An enum of kernels with a log: `note`, `take`, and the words that describe each.
#[macro_export]
macro_rules! logged_kernels {
    ($(#[$meta:meta])* $name:ident { $($(#[$of:meta])* $variant:ident = $words:literal,)* }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum $name {
            $(#[doc = $words] $variant,)*
        }

        impl $name {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$variant,)*];

            /// What it is, in words.
            pub const fn describe(self) -> &'static str {
                match self {
                    $(Self::$variant => $words,)*
                }
            }

            /// Notes that it runs, in builds with debug assertions.
            #[inline(always)]
            pub fn note(self) {
                Self::log().note(self as u32);
            }

            /// Those that ran since the last call.
            pub fn take() -> Vec<Self> {
                let ran = Self::log().take();
                Self::ALL.iter().copied().filter(|kernel| ran >> *kernel as u32 & 1 == 1).collect()
            }

            #[inline(always)]
            fn log() -> &'static $crate::kernels::KernelLog {
                static LOG: $crate::kernels::KernelLog = $crate::kernels::KernelLog::new();
                const { assert!($name::ALL.len() <= 64) };
                &LOG
            }
        }
    };
}

logged_kernels! {
    /// A kernel of lookups.
    LookupKernel {
        DirectSquare = "nearest, known with the plan: a square of texels read as rows",
        DirectWords = "nearest, known with the plan: bytes, gathered",
        DirectChannels = "nearest, known with the plan: texels of another class",
        UniformNearest = "one level in all lanes: the nearest texel",
        UniformLinear = "one level in all lanes: linear",
        UniformCompared = "one level in all lanes: linear, of compared depths",
        UniformNearestCompared = "one level in all lanes: nearest, compared",
        UniformTwoLevels = "one pair of levels in all lanes",
        FusedNearest = "fused with what reads the texel: nearest",
        FusedLinear = "fused: linear on one level",
        FusedTwoLevels = "fused: linear on two levels",
        FusedOpaque = "fused: linear, of texels whose alpha is 1",
        FusedReused = "fused: at texels that a lookup before has found",
        FusedAcrossEdge = "fused: across the edge of a level",
        FusedStored = "not fused: lanes are stored, then read",
        ScatteredOneFace = "cubes whose lanes read one face",
        ScatteredNearest = "faces and layers by lane: nearest",
        ScatteredLinear = "faces and layers by lane: linear",
        ScatteredTwoLevels = "faces and layers by lane: two levels",
        GeneralOneLevel = "general: one level in all lanes",
        GeneralTwoLevels = "general: one pair of levels in all lanes",
        GeneralPerLane = "general: levels by lane",
        GeneralProbes = "general: several probes",
        GeneralRound = "general: round footprints among others",
        GeneralOffset = "general: moved by texels",
        GeneralTexelNearest = "general: the nearest texel of any format",
        GeneralTexelLinear = "general: linear, of any format",
        FastBytes = "filter on a level: bytes",
        FastSrgb = "filter on a level: sRGB",
        FastHalves = "filter on a level: halves",
        FastFloats = "filter on a level: floats",
        FastDepths = "filter on a level: depths of 24 bits",
        FastBlocks = "filter on a level: compressed blocks",
        RowsOfBytes = "row scan: bytes",
        RowsOfWords = "row scan: texels of another class",
        RowsOfBlocks = "row scan: compressed blocks",
        RowsOfAny = "row scan: any texels",
        Gather = "textureGather",
        LodQuery = "textureQueryLOD",
        TexelFetch = "texelFetch",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_log_is_empty_once_it_was_taken() {
        let log = KernelLog::new();
        log.note(3);
        log.note(41);
        let expected = if cfg!(debug_assertions) { 1 << 3 | 1 << 41 } else { 0 };
        assert_eq!((log.take(), log.take()), (expected, 0));
    }
}
