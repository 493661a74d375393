//! Tests and operations of single fragments: alpha test (section 4.1.4), stencil (4.1.5), logical
//! operation (4.1.10).

use super::compare::Compare;
use crate::mutation::{Mutation, Variant};

/// A stencil operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GL's names")]
pub enum StencilOp {
    Keep,
    Zero,
    Replace,
    Increment,
    Decrement,
    Invert,
    IncrementWrap,
    DecrementWrap,
}

impl StencilOp {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Keep,
        Self::Zero,
        Self::Replace,
        Self::Increment,
        Self::Decrement,
        Self::Invert,
        Self::IncrementWrap,
        Self::DecrementWrap,
    ];

    fn apply(self, stored: u8, reference: u8, variant: Variant) -> u8 {
        let wraps = variant.has(Mutation::StencilSaturationIgnored);
        match self {
            Self::Keep => stored,
            Self::Zero => 0,
            Self::Replace => reference,
            Self::Increment if wraps => stored.wrapping_add(1),
            Self::Increment => stored.saturating_add(1),
            Self::Decrement if wraps => stored.wrapping_sub(1),
            Self::Decrement => stored.saturating_sub(1),
            Self::Invert => !stored,
            Self::IncrementWrap => stored.wrapping_add(1),
            Self::DecrementWrap => stored.wrapping_sub(1),
        }
    }
}

/// The stencil state and a fragment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stencil {
    /// `(ref & mask) OP (stored & mask)`.
    pub compare: Compare,
    /// `glStencilFunc`.
    pub reference: u8,
    /// `glStencilFunc`.
    pub mask: u8,
    /// Where the stencil test fails, the depth test fails, both pass.
    pub operations: [StencilOp; 3],
    /// `glStencilMask`.
    pub write_mask: u8,
    /// The stored value.
    pub stored: u8,
    /// Whether the fragment passes the depth test.
    pub depth_passes: bool,
}

impl Stencil {
    /// The stored value after the fragment, and whether the fragment is drawn.
    pub fn apply(&self, variant: Variant) -> (u8, bool) {
        let mask = if variant.has(Mutation::StencilMaskIgnored) { 0xff } else { self.mask };
        let (r, s) = (f64::from(self.reference & mask), f64::from(self.stored & mask));
        let passes = self.compare.holds(r, s, variant);
        let [fail, depth_fail, pass] = self.operations;
        let swapped = variant.has(Mutation::StencilOpsSwapped);
        let operation = match (passes, self.depth_passes) {
            (false, _) => fail,
            (true, false) => {
                if swapped {
                    pass
                } else {
                    depth_fail
                }
            }
            (true, true) => {
                if swapped {
                    depth_fail
                } else {
                    pass
                }
            }
        };
        let value = operation.apply(self.stored, self.reference, variant);
        let kept = (value & self.write_mask) | (self.stored & !self.write_mask);
        (kept, passes && self.depth_passes)
    }
}

/// `glLogicOp`: the 16 functions of two bits, in the order of GL's enums (table 4.2).
pub fn logic(operation: usize, source: u8, destination: u8, variant: Variant) -> u8 {
    let (s, d) = if variant.has(Mutation::LogicOperandsSwapped) {
        (destination, source)
    } else {
        (source, destination)
    };
    match operation {
        0 => 0,
        1 => s & d,
        2 => s & !d,
        3 => s,
        4 => !s & d,
        5 => d,
        6 => s ^ d,
        7 => s | d,
        8 => !(s | d),
        9 => !(s ^ d),
        10 => !d,
        11 => s | !d,
        12 => !s,
        13 => !s | d,
        14 => !(s & d),
        _ => 0xff,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counting_stops_at_the_ends() {
        let stencil = Stencil {
            compare: Compare::Always,
            reference: 0,
            mask: 0xff,
            operations: [StencilOp::Keep, StencilOp::Keep, StencilOp::Increment],
            write_mask: 0xff,
            stored: 255,
            depth_passes: true,
        };
        assert_eq!(stencil.apply(Variant::CORRECT), (255, true));
        assert_eq!(
            Stencil { write_mask: 0x0f, operations: [StencilOp::Zero; 3], ..stencil }
                .apply(Variant::CORRECT),
            (0xf0, true)
        );
        assert_eq!(logic(6, 0b1100, 0b1010, Variant::CORRECT), 0b0110);
    }
}
