//! The unit of work: a batch of 64 lanes, and the same plain loops compiled per instruction set.
//!
//! A value is an array of 64 ([`F32s`], [`I32s`], [`U32s`]: 64-byte aligned); a kernel is an
//! ordinary loop over lanes, which LLVM vectorizes. A [`Kernel`] is one body, compiled for the
//! baseline, AVX2 and AVX-512 by [`Isa::run`]; everything it calls on the hot path is
//! `#[inline(always)]`, so that it takes on the instruction set of its caller.
//!
//! `docs/lanes.md` is the guide to changing a kernel. This module is one of the two places in DetGL where `unsafe` is
//! allowed (the other is the C ABI): it calls functions compiled for detected instruction sets, reads
//! unchecked, and sets the floating-point control word ([`FloatEnv`]).
//!
//! # Lane order: quad-planar
//!
//! The 64 lanes of an 8×8 pixel block are 16 quads of 2×2 pixels. Lane `e * 16 + q` is pixel `e`
//! of quad `q`: `e = 0` is (x, y), 1 is (x+1, y), 2 is (x, y+1), 3 is (x+1, y+1); quads run row by
//! row, 4 to a row. Neighbours for a derivative are then whole vectors apart, never shuffled:
//! `d/dx` of lanes 0..16 is lanes 16..32 minus lanes 0..16. [`lane_x`] and [`lane_y`] give a
//! lane's place in its block. Vertices fill lanes in plain order.
#![allow(unsafe_code)]

mod batch;
pub mod code;
mod float_env;
mod gather;
mod isa;
mod log2;
pub mod math;
mod prefetch;
mod reduce;
mod row_walk;
mod simd;
mod weigh;

pub use batch::{F32s, F64s, I32s, LANES, PerLane, QUADS, U32s, lane_x, lane_y};
pub use float_env::{FloatEnv, OutlinedFloatEnv};
pub use gather::Sources;
pub use isa::{Baseline, Isa, IsaError};
pub use log2::{log2, log2_of_root};
pub use prefetch::{prefetch, prefetch_at};
pub use row_walk::{RowWalk, SecondTexel, WEIGHT_ONE, weights};
pub use simd::{Kernel, Simd};
pub use weigh::Sums;
