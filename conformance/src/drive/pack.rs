//! A float in four bytes.
//!
//! A value in [0, 2) is written as the four digits of `128·value` in base 256. Multiplication by a
//! power of two, `floor` and the subtraction of an integer part are exact in `f32`, so that every
//! `f32` from 2^-8 up comes back to the last bit, and smaller ones to 2^-31. Digits are written as
//! `digit/255` and rounded back to themselves by the framebuffer.

/// The fragment shader's half: packs the component of `value()` that `component` selects.
pub const GLSL: &str = "
uniform vec4 component;
void main() {
    float x = 128.0 * clamp(dot(value(), component), 0.0, 1.5);
    vec4 digits;
    digits.x = floor(x);
    x = 256.0 * (x - digits.x);
    digits.y = floor(x);
    x = 256.0 * (x - digits.y);
    digits.z = floor(x);
    digits.w = floor(256.0 * (x - digits.z));
    gl_FragColor = digits / 255.0;
}
";

/// The value of a pixel.
pub fn unpack(digits: [u8; 4]) -> f64 {
    f64::from(u32::from_be_bytes(digits)) / f64::from(1u32 << 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The shader's arithmetic in Rust.
    fn pack(value: f32) -> [u8; 4] {
        let mut x = 128.0 * value;
        [0; 4].map(|_: u8| {
            let digit = x.floor();
            x = 256.0 * (x - digit);
            digit as u8
        })
    }

    #[test]
    fn floats_come_back_exactly() {
        let mut value = 1.5f32;
        while value > 1.0 / 256.0 {
            assert_eq!(unpack(pack(value)), f64::from(value));
            value *= 0.993;
        }
        assert!((unpack(pack(1e-4)) - f64::from(1e-4f32)).abs() < 1.0 / f64::from(1u32 << 31));
        assert_eq!(unpack(pack(0.0)), 0.0);
        assert_eq!(unpack(pack(1.0)), 1.0);
    }
}
