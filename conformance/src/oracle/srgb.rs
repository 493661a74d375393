//! sRGB texture colour conversion (section 3.8.15).

use crate::mutation::{Mutation, Variant};

/// The linear value of an sRGB-encoded one, both in [0, 1]: `c/12.92` up to 0.04045, and
/// `((c + 0.055)/1.055)^2.4` above.
pub fn decode(c: f64, variant: Variant) -> f64 {
    if variant.has(Mutation::SrgbUndecoded) {
        c
    } else if variant.has(Mutation::SrgbGamma22) {
        c.powf(2.2)
    } else if c <= 0.04045 && !variant.has(Mutation::SrgbWithoutLinearPart) {
        c / 12.92
    } else {
        ((c + 0.055) / 1.055).powf(2.4)
    }
}

/// The inverse: `12.92·l` up to 0.0031308, and `1.055·l^(1/2.4) - 0.055` above
/// (ARB_framebuffer_sRGB, section 4.1.X).
pub fn encode(l: f64) -> f64 {
    if l <= 0.003_130_8 { 12.92 * l } else { 1.055 * l.powf(1.0 / 2.4) - 0.055 }
}

/// A texel: alpha is linear already.
pub fn decode_texel([r, g, b, a]: [f64; 4], variant: Variant) -> [f64; 4] {
    let alpha = if variant.has(Mutation::SrgbAlphaDecoded) { decode(a, variant) } else { a };
    [decode(r, variant), decode(g, variant), decode(b, variant), alpha]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        for (c, expected) in
            [(0.0, 0.0), (1.0, 1.0), (0.5, 0.214_041_140_482_232_6), (0.02, 0.02 / 12.92)]
        {
            assert!((decode(c, Variant::CORRECT) - expected).abs() < 1e-12, "{c}");
        }
    }

    #[test]
    fn the_two_parts_meet() {
        let step = decode(0.040_450_1, Variant::CORRECT) - decode(0.04045, Variant::CORRECT);
        assert!(step.abs() < 1e-7);
    }
}
