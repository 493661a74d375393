//! Packing of fractions and half floats into integers (GLSL ES 3.00 section 8.4; ARB_shading_language_packing).

use super::Args;
use super::common::float_bits;
use crate::emit::Emit;
use rasterizer::ir::{Op, Value};

/// How a component is packed.
#[derive(Clone, Copy)]
enum Packing {
    /// `round(clamp(c, 0, 1) · (2^bits - 1))`.
    Unorm(u32),
    /// `round(clamp(c, -1, 1) · (2^(bits - 1) - 1))`.
    Snorm(u32),
    /// IEEE 754's binary16, rounded to nearest, ties to even.
    Half,
}

impl Packing {
    fn bits(self) -> u32 {
        match self {
            Self::Unorm(bits) | Self::Snorm(bits) => bits,
            Self::Half => 16,
        }
    }

    /// The largest integer.
    fn largest(self) -> f32 {
        match self {
            Self::Unorm(bits) => ((1 << bits) - 1) as f32,
            Self::Snorm(bits) => ((1 << (bits - 1)) - 1) as f32,
            Self::Half => 0.0,
        }
    }

    fn pack(self, emit: &mut Emit, x: Value) -> Value {
        let (least, one, largest) = match self {
            Self::Half => return pack_half(emit, x),
            Self::Unorm(_) => (emit.float(0.0), emit.float(1.0), emit.float(self.largest())),
            Self::Snorm(_) => (emit.float(-1.0), emit.float(1.0), emit.float(self.largest())),
        };
        let x = emit.op(Op::Max, &[x, least]);
        let x = emit.op(Op::Min, &[x, one]);
        let x = emit.op(Op::Mul, &[x, largest]);
        let x = emit.op(Op::RoundEven, &[x]);
        let x = emit.op(Op::FloatToInt, &[x]);
        let x = emit.op(Op::IntToUint, &[x]);
        let mask = emit.uint((1 << self.bits()) - 1);
        emit.op(Op::BitAnd, &[x, mask])
    }

    /// From the lowest bits of an integer, whose other bits are not zero.
    fn unpack(self, emit: &mut Emit, x: Value) -> Value {
        let largest = match self {
            Self::Half => return unpack_half(emit, x),
            Self::Unorm(_) | Self::Snorm(_) => emit.float(self.largest()),
        };
        let above = emit.uint(32 - self.bits());
        let x = emit.op(Op::ShiftLeft, &[x, above]);
        if let Self::Unorm(_) = self {
            let x = emit.op(Op::UShiftRight, &[x, above]);
            let x = emit.op(Op::UintToFloat, &[x]);
            return emit.op(Op::Div, &[x, largest]);
        }
        let x = emit.op(Op::UintToInt, &[x]);
        let x = emit.op(Op::IShiftRight, &[x, above]);
        let x = emit.op(Op::IntToFloat, &[x]);
        let x = emit.op(Op::Div, &[x, largest]);
        // The least integer is below -1.
        let least = emit.float(-1.0);
        emit.op(Op::Max, &[x, least])
    }
}

/// Of 16 bits: binary16 of a float.
fn pack_half(emit: &mut Emit, x: Value) -> Value {
    let bits = float_bits(emit, x);
    let sign = masked(emit, bits, 1 << 31);
    let magnitude = masked(emit, bits, !(1 << 31));
    // Normal numbers: the exponent's bias is 15, not 127; 13 bits of the mantissa are rounded away.
    let [thirteen, sixteen, one] = [13, 16, 1].map(|bits| emit.uint(bits));
    let odd = emit.op(Op::UShiftRight, &[magnitude, thirteen]);
    let odd = emit.op(Op::BitAnd, &[odd, one]);
    let rebias = emit.uint((15u32.wrapping_sub(127) << 23).wrapping_add(0xfff));
    let normal = emit.op(Op::UAdd, &[magnitude, rebias]);
    let normal = emit.op(Op::UAdd, &[normal, odd]);
    let normal = emit.op(Op::UShiftRight, &[normal, thirteen]);
    // Smaller than 2^-14: a sum with 0.5 has the units of subnormal numbers in its last bits.
    let half = emit.float(0.5);
    let small = emit.op(Op::BitsFloat, &[magnitude]);
    let small = emit.op(Op::Add, &[small, half]);
    let small = emit.op(Op::FloatBits, &[small]);
    let half_bits = emit.uint(0.5f32.to_bits());
    let small = emit.op(Op::USub, &[small, half_bits]);
    let [least_normal, beyond, infinity] =
        [113 << 23, 143 << 23, f32::INFINITY.to_bits()].map(|bits| emit.uint(bits));
    let is_small = emit.op(Op::ULess, &[magnitude, least_normal]);
    let finite = emit.op(Op::SelectU, &[is_small, small, normal]);
    // From 2^16 on: infinity, or NaN.
    let is_finite = emit.op(Op::ULess, &[magnitude, beyond]);
    let is_nan = emit.op(Op::ULess, &[infinity, magnitude]);
    let [nan_16, infinity_16] = [0x7e00, 0x7c00].map(|bits| emit.uint(bits));
    let special = emit.op(Op::SelectU, &[is_nan, nan_16, infinity_16]);
    let found = emit.op(Op::SelectU, &[is_finite, finite, special]);
    let sign = emit.op(Op::UShiftRight, &[sign, sixteen]);
    emit.op(Op::BitOr, &[found, sign])
}

/// The float of the binary16 in the lowest 16 bits.
fn unpack_half(emit: &mut Emit, x: Value) -> Value {
    let sign = masked(emit, x, 0x8000);
    let magnitude = masked(emit, x, 0x7fff);
    let [thirteen, sixteen] = [13, 16].map(|bits| emit.uint(bits));
    let shifted = emit.op(Op::ShiftLeft, &[magnitude, thirteen]);
    // A product with 2^112 changes the bias of normal and subnormal numbers.
    let scale = emit.float(f32::from_bits((127 + 112) << 23));
    let finite = emit.op(Op::BitsFloat, &[shifted]);
    let finite = emit.op(Op::Mul, &[finite, scale]);
    let finite = emit.op(Op::FloatBits, &[finite]);
    let exponent = emit.uint(0x7f80_0000);
    let special = emit.op(Op::BitOr, &[shifted, exponent]);
    let infinity = emit.uint(0x7c00);
    let is_finite = emit.op(Op::ULess, &[magnitude, infinity]);
    let found = emit.op(Op::SelectU, &[is_finite, finite, special]);
    let sign = emit.op(Op::ShiftLeft, &[sign, sixteen]);
    let found = emit.op(Op::BitOr, &[found, sign]);
    emit.op(Op::BitsFloat, &[found])
}

fn masked(emit: &mut Emit, x: Value, mask: u32) -> Value {
    let mask = emit.uint(mask);
    emit.op(Op::BitAnd, &[x, mask])
}

/// The first component is in the lowest bits.
fn pack(emit: &mut Emit, args: Args<'_>, packing: Packing) -> Vec<Value> {
    let mut all = emit.uint(0);
    for (at, &component) in args.values[0].iter().enumerate() {
        let packed = packing.pack(emit, component);
        let place = emit.uint(at as u32 * packing.bits());
        let packed = emit.op(Op::ShiftLeft, &[packed, place]);
        all = emit.op(Op::BitOr, &[all, packed]);
    }
    vec![all]
}

fn unpack(emit: &mut Emit, args: Args<'_>, packing: Packing) -> Vec<Value> {
    let x = args.values[0][0];
    let components = 0..32 / packing.bits();
    let component = |at: u32| {
        let place = emit.uint(at * packing.bits());
        let x = emit.op(Op::UShiftRight, &[x, place]);
        packing.unpack(emit, x)
    };
    components.map(component).collect()
}

macro_rules! functions {
    ($($pack:ident, $unpack:ident: $packing:expr;)*) => {
        $(
            #[doc = concat!("`", stringify!($pack), "`, without underscores.")]
            pub fn $pack(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
                pack(emit, args, $packing)
            }

            #[doc = concat!("`", stringify!($unpack), "`, without underscores.")]
            pub fn $unpack(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
                unpack(emit, args, $packing)
            }
        )*
    };
}

functions! {
    pack_unorm_2x16, unpack_unorm_2x16: Packing::Unorm(16);
    pack_snorm_2x16, unpack_snorm_2x16: Packing::Snorm(16);
    pack_unorm_4x8, unpack_unorm_4x8: Packing::Unorm(8);
    pack_snorm_4x8, unpack_snorm_4x8: Packing::Snorm(8);
    pack_half_2x16, unpack_half_2x16: Packing::Half;
}
