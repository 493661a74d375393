//! Logical operations between a fragment's texel and the stored one (GL 2.1, section 4.1.10).

use crate::desc::LogicOp;
use texunit::lanes::{LANES, U32s};

/// `source OP stored` into `source`, bit by bit.
#[inline(always)]
pub fn apply(op: LogicOp, source: &mut U32s, stored: &U32s) {
    match op {
        LogicOp::Clear => each(source, stored, |_, _| 0),
        LogicOp::And => each(source, stored, |s, d| s & d),
        LogicOp::AndReverse => each(source, stored, |s, d| s & !d),
        LogicOp::Copy => {}
        LogicOp::AndInverted => each(source, stored, |s, d| !s & d),
        LogicOp::Noop => each(source, stored, |_, d| d),
        LogicOp::Xor => each(source, stored, |s, d| s ^ d),
        LogicOp::Or => each(source, stored, |s, d| s | d),
        LogicOp::Nor => each(source, stored, |s, d| !(s | d)),
        LogicOp::Equivalent => each(source, stored, |s, d| !(s ^ d)),
        LogicOp::Invert => each(source, stored, |_, d| !d),
        LogicOp::OrReverse => each(source, stored, |s, d| s | !d),
        LogicOp::CopyInverted => each(source, stored, |s, _| !s),
        LogicOp::OrInverted => each(source, stored, |s, d| !s | d),
        LogicOp::Nand => each(source, stored, |s, d| !(s & d)),
        LogicOp::Set => each(source, stored, |_, _| !0),
    }
}

#[inline(always)]
fn each(source: &mut U32s, stored: &U32s, f: impl Fn(u32, u32) -> u32) {
    for lane in 0..LANES {
        source[lane] = f(source[lane], stored[lane]);
    }
}
