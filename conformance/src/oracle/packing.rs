//! Two floats in a word (GLSL ES 3.00, section 8.4).

use super::format::small_float;
use crate::mutation::{Mutation, Variant};

/// What a half of a word is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Packing {
    /// `packSnorm2x16`.
    Snorm,
    /// `packUnorm2x16`.
    Unorm,
    /// `packHalf2x16`.
    Half,
}

impl Packing {
    /// The end of the functions' names.
    pub fn name(self) -> &'static str {
        match self {
            Self::Snorm => "Snorm2x16",
            Self::Unorm => "Unorm2x16",
            Self::Half => "Half2x16",
        }
    }

    /// The exact number that a component is rounded from, in codes: `clamp(c, -1, 1) · 32767`,
    /// `clamp(c, 0, 1) · 65535`; for halves the code itself.
    pub fn code(self, c: f64, variant: Variant) -> f64 {
        let one_more = f64::from(u8::from(variant.has(Mutation::UnormOfPowerOfTwo)));
        match self {
            Self::Snorm if variant.has(Mutation::PackedUnclamped) => c * 32767.0,
            Self::Snorm => c.clamp(-1.0, 1.0) * (32767.0 + one_more),
            Self::Unorm => c.clamp(0.0, 1.0) * (65535.0 + one_more),
            Self::Half => half_code(c, variant).into(),
        }
    }

    /// The component of a code.
    pub fn component(self, code: u16, variant: Variant) -> f64 {
        let one_more = f64::from(u8::from(variant.has(Mutation::UnormOfPowerOfTwo)));
        match self {
            Self::Snorm => {
                let f = f64::from(code as i16) / (32767.0 + one_more);
                if variant.has(Mutation::UnpackedUnclamped) { f } else { f.clamp(-1.0, 1.0) }
            }
            Self::Unorm => f64::from(code) / (65535.0 + one_more),
            Self::Half => half(code, variant),
        }
    }

    /// Both components of a word, the first of which is in the lower half, or both halves of two components.
    pub fn halves<T: Copy>([low, high]: [T; 2], variant: Variant) -> [T; 2] {
        if variant.has(Mutation::HalvesSwapped) { [high, low] } else { [low, high] }
    }
}

/// The number of a half's bits (OpenGL ES 3.0, section 2.1.2).
pub fn half(code: u16, variant: Variant) -> f64 {
    let sign = if code >> 15 == 1 { -1.0 } else { 1.0 };
    let (exponent, mantissa) = (i32::from(code >> 10 & 31), f64::from(code & 1023));
    let magnitude = match (exponent, mantissa == 0.0) {
        (0, _) if variant.has(Mutation::FloatDenormalsFlushed) => 0.0,
        (0, _) => mantissa * 2f64.powi(-24),
        (31, true) => f64::INFINITY,
        (31, false) => f64::NAN,
        (e, _) => (1.0 + mantissa / 1024.0) * 2f64.powi(e - 15),
    };
    sign * magnitude
}

/// The bits of the nearest half, ties to even; one NaN.
fn half_code(x: f64, variant: Variant) -> u16 {
    let sign = u16::from(x.is_sign_negative()) << 15;
    let magnitude = small_float(x.abs(), 10, 5, variant);
    if magnitude.is_nan() {
        return 0x7e00;
    }
    // Codes without a sign are in the order of their numbers.
    let (mut code, mut above) = (0, 0x7c01);
    while above - code > 1 {
        let middle = code + (above - code) / 2;
        if half(middle, Variant::CORRECT) <= magnitude {
            code = middle;
        } else {
            above = middle;
        }
    }
    sign | code
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn codes_by_hand() {
        assert_eq!(Packing::Snorm.code(-2.0, TRUE), -32767.0);
        assert_eq!(Packing::Unorm.code(0.5, TRUE), 32767.5);
        for (x, code) in [(1.0, 0x3c00), (-2.0, 0xc000), (65520.0, 0x7c00), (2f64.powi(-24), 1)] {
            assert_eq!(Packing::Half.code(x, TRUE), f64::from(code), "{x}");
        }
    }

    #[test]
    fn components_by_hand() {
        assert_eq!(Packing::Snorm.component(0x8000, TRUE), -1.0);
        assert_eq!(Packing::Unorm.component(0xffff, TRUE), 1.0);
        assert_eq!(Packing::Half.component(0x3e00, TRUE), 1.5);
        assert_eq!(Packing::Half.component(0x8001, TRUE), -(2f64.powi(-24)));
    }
}
