//! A float in four bytes: the bits of its IEEE 754 form, most significant first.
//!
//! GLSL 1.20 has no access to the bits of a float, so the shader computes them by arithmetic that
//! is exact in `f32`: multiplication by powers of two, `floor`, and the subtraction of an integer
//! part. Every value comes back to the last bit: negative, denormal and infinite ones, -0, and NaN
//! (as one NaN). Digits are written as `digit/255` and rounded back to themselves by the
//! framebuffer.

/// The fragment shader's part: packs the component of `value()` that `component` selects.
pub const GLSL: &str = "
uniform vec4 component;
vec4 float_bytes(float x) {
    float sign = (x < 0.0 || (x == 0.0 && 1.0 / x < 0.0)) ? 128.0 : 0.0;
    float m = abs(x);
    float e = 127.0;
    if (!(m <= 3.4028234663852886e38)) {
        return m == m ? vec4(sign + 127.0, 128.0, 0.0, 0.0) : vec4(127.0, 192.0, 0.0, 0.0);
    }
    if (m < 1.1754943508222875e-38) {
        // A denormal is an integer times 2^-149.
        m = m * 1.2676506002282294e30 * 562949953421312.0;
        float high = floor(m / 65536.0);
        m -= high * 65536.0;
        float middle = floor(m / 256.0);
        return vec4(sign, high, middle, m - middle * 256.0);
    }
    if (m >= 18446744073709551616.0) { m *= 5.421010862427522e-20; e += 64.0; }
    if (m >= 4294967296.0) { m *= 2.3283064365386963e-10; e += 32.0; }
    if (m >= 65536.0) { m *= 1.52587890625e-5; e += 16.0; }
    if (m >= 256.0) { m *= 0.00390625; e += 8.0; }
    if (m >= 16.0) { m *= 0.0625; e += 4.0; }
    if (m >= 4.0) { m *= 0.25; e += 2.0; }
    if (m >= 2.0) { m *= 0.5; e += 1.0; }
    if (m < 1.0842021724855044e-19) { m *= 18446744073709551616.0; e -= 64.0; }
    if (m < 4.656612873077393e-10) { m *= 4294967296.0; e -= 32.0; }
    if (m < 3.0517578125e-5) { m *= 65536.0; e -= 16.0; }
    if (m < 0.0078125) { m *= 256.0; e -= 8.0; }
    if (m < 0.125) { m *= 16.0; e -= 4.0; }
    if (m < 0.5) { m *= 4.0; e -= 2.0; }
    if (m < 1.0) { m *= 2.0; e -= 1.0; }
    float half_e = floor(e * 0.5);
    float f = (m - 1.0) * 128.0;
    float high = floor(f);
    f = (f - high) * 256.0;
    float middle = floor(f);
    return vec4(sign + half_e, (e - 2.0 * half_e) * 128.0 + high, middle, (f - middle) * 256.0);
}
void main() {
    vec4 all = value();
    float x = all.x;
    if (component.y > 0.5) x = all.y;
    if (component.z > 0.5) x = all.z;
    if (component.w > 0.5) x = all.w;
    gl_FragColor = float_bytes(x) / 255.0;
}
";

/// The float that a pixel encodes.
pub fn unpack(bytes: [u8; 4]) -> f64 {
    f64::from(f32::from_be_bytes(bytes))
}

#[cfg(test)]
mod tests {
    use crate::probe::Session;

    #[test]
    fn floats_come_back_to_the_bit() -> Result<(), crate::probe::ProbeError> {
        let mut values = vec![0.0, -0.0, 1.0, -1.0, 1.5, f32::MAX, f32::MIN, f32::MIN_POSITIVE];
        values.extend([f32::INFINITY, f32::NEG_INFINITY, f32::from_bits(1)]);
        values.extend((0..4000u32).map(|i| f32::from_bits(i.wrapping_mul(0x9e37_79b1))));
        let session = Session::open()?;
        let inputs: Vec<_> = values.iter().map(|&x| [[x, 0.0, 0.0, 0.0]; 3]).collect();
        let back = session.field("vec4 value() { return a; }", 1, &inputs)?;
        for (x, got) in values.iter().zip(back) {
            let same = (got[0] as f32).to_bits() == x.to_bits();
            assert!(same || (x.is_nan() && got[0].is_nan()), "{x:e} came back as {:e}", got[0]);
        }
        Ok(())
    }
}
