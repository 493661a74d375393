//! Texel formats: how a colour is stored and read (sections 2.14.9, 3.8.1 and 6.1.4;
//! EXT_texture_sRGB, ARB_texture_float, EXT_packed_float, EXT_texture_shared_exponent,
//! EXT_texture_snorm, EXT_texture_integer).

use super::srgb;
use crate::mutation::{Mutation, Variant};

/// The components that a format holds (table 3.15).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GL's names")]
pub enum Base {
    Alpha,
    Luminance,
    LuminanceAlpha,
    Intensity,
    Red,
    Rg,
    Rgb,
    Rgba,
    Depth,
}

impl Base {
    /// Which of R, G, B, A each stored channel is made from (table 3.15); depth comes as R.
    pub fn sources(self) -> &'static [usize] {
        match self {
            Self::Alpha => &[3],
            Self::Luminance | Self::Intensity | Self::Red | Self::Depth => &[0],
            Self::LuminanceAlpha => &[0, 3],
            Self::Rg => &[0, 1],
            Self::Rgb => &[0, 1, 2],
            Self::Rgba => &[0, 1, 2, 3],
        }
    }

    /// Stored channels as a texture's R, G, B, A (table 3.20; depth in `GL_LUMINANCE` mode).
    pub fn sampled(self, c: [f64; 4], variant: Variant) -> [f64; 4] {
        match self {
            Self::Alpha => [0.0, 0.0, 0.0, c[0]],
            Self::Luminance | Self::Depth => [c[0], c[0], c[0], 1.0],
            Self::LuminanceAlpha if variant.has(Mutation::LuminanceAlphaAsRg) => {
                [c[0], c[1], 0.0, 1.0]
            }
            Self::LuminanceAlpha => [c[0], c[0], c[0], c[1]],
            Self::Intensity if variant.has(Mutation::IntensityAsLuminance) => {
                [c[0], c[0], c[0], 1.0]
            }
            Self::Intensity => [c[0]; 4],
            Self::Red => [c[0], 0.0, 0.0, 1.0],
            Self::Rg => [c[0], c[1], 0.0, 1.0],
            Self::Rgb => [c[0], c[1], c[2], 1.0],
            Self::Rgba => c,
        }
    }

    /// Stored channels as `glGetTexImage` gives R, G, B, A (table 6.1): luminance and intensity
    /// are R alone.
    pub fn queried(self, c: [f64; 4], variant: Variant) -> [f64; 4] {
        match self {
            Self::Luminance | Self::Intensity | Self::LuminanceAlpha
                if variant.has(Mutation::LuminanceReplicated) =>
            {
                self.sampled(c, variant)
            }
            Self::Luminance | Self::Intensity | Self::Depth => [c[0], 0.0, 0.0, 1.0],
            Self::LuminanceAlpha => [c[0], 0.0, 0.0, c[1]],
            Self::Alpha | Self::Red | Self::Rg | Self::Rgb | Self::Rgba => self.sampled(c, variant),
        }
    }
}

/// How channels are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// `round(c · (2^b - 1))` of `c` in [0, 1], with this many bits a channel.
    Unorm([u32; 4]),
    /// `round(c · (2^(b-1) - 1))` of `c` in [-1, 1].
    Snorm(u32),
    /// 8 bits that are sRGB-encoded; alpha is linear.
    Srgb,
    /// Signed floats with this many bits of mantissa and exponent: halves.
    Half,
    /// `f32`.
    Single,
    /// Unsigned floats of 6, 6, 5 bits of mantissa and 5 of exponent.
    PackedFloat,
    /// Mantissas of 9 bits and one exponent.
    SharedExponent,
    /// Integers: bits, and whether they are signed.
    Integer(u32, Sign),
}

/// Whether integers are signed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the words say it")]
pub enum Sign {
    Signed,
    Unsigned,
}

/// The channels of R, G, B, A after they are stored. Colours of sRGB formats are encoded before and after.
pub fn stored(base: Base, encoding: Encoding, rgba: [f64; 4], variant: Variant) -> [f64; 4] {
    let mut c = [0.0; 4];
    for (channel, &source) in c.iter_mut().zip(base.sources()) {
        *channel = rgba[source];
    }
    match encoding {
        Encoding::Unorm(bits) => std::array::from_fn(|i| {
            unorm(c[i], bits[i.min(3)].max(1), variant) * f64::from(u8::from(bits[i] > 0))
        }),
        Encoding::Srgb => c.map(|c| unorm(c, 8, variant)),
        Encoding::Snorm(bits) => c.map(|c| {
            let largest = ((1u64 << (bits - 1)) - 1) as f64;
            let scale =
                if variant.has(Mutation::SnormOfWholeRange) { largest + 1.0 } else { largest };
            (c.clamp(-1.0, 1.0) * scale).round().clamp(-largest, largest) / scale
        }),
        Encoding::Half => c.map(|c| small_float(c, 10, 5, variant)),
        Encoding::Single => c.map(|c| f64::from(c as f32)),
        Encoding::PackedFloat => {
            let bits = [6, 6, 5, 5];
            std::array::from_fn(|i| packed_float(c[i], bits[i], variant))
        }
        Encoding::SharedExponent => shared_exponent(c, variant),
        Encoding::Integer(bits, sign) => {
            let [low, high] = match sign {
                Sign::Unsigned => [0.0, 2f64.powi(bits as i32) - 1.0],
                Sign::Signed => [-2f64.powi(bits as i32 - 1), 2f64.powi(bits as i32 - 1) - 1.0],
            };
            let wraps = variant.has(Mutation::IntegersWrap);
            c.map(|c| {
                if wraps {
                    (c - low).rem_euclid(high - low + 1.0) + low
                } else {
                    c.clamp(low, high)
                }
            })
        }
    }
}

/// Stored channels as a sample reads them: sRGB colours become linear.
pub fn linear(base: Base, encoding: Encoding, c: [f64; 4], variant: Variant) -> [f64; 4] {
    match encoding {
        Encoding::Srgb => {
            let is_alpha = |i: usize| base.sources().get(i) == Some(&3);
            std::array::from_fn(|i| if is_alpha(i) { c[i] } else { srgb::decode(c[i], variant) })
        }
        Encoding::Unorm(_)
        | Encoding::Snorm(_)
        | Encoding::Half
        | Encoding::Single
        | Encoding::PackedFloat
        | Encoding::SharedExponent
        | Encoding::Integer(..) => c,
    }
}

fn unorm(c: f64, bits: u32, variant: Variant) -> f64 {
    let largest = ((1u64 << bits) - 1) as f64;
    let scaled = c.clamp(0.0, 1.0) * largest;
    let code = if variant.has(Mutation::UnormTruncates) { scaled.floor() } else { scaled.round() };
    if variant.has(Mutation::UnormOfPowerOfTwo) { code / (largest + 1.0) } else { code / largest }
}

/// The nearest float with so many bits of mantissa and exponent, ties to even, denormals too.
/// Larger values than the largest float become infinite.
pub fn small_float(x: f64, mantissa: i32, exponent: u32, variant: Variant) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return x;
    }
    let bias = (1 << (exponent - 1)) - 1;
    let e = (x.abs().log2().floor() as i32).max(1 - bias);
    let step = 2f64.powi(e - mantissa);
    if variant.has(Mutation::FloatDenormalsFlushed) && x.abs() < 2f64.powi(1 - bias) {
        return 0.0;
    }
    let steps = x / step;
    let rounded = step
        * if variant.has(Mutation::FloatTruncates) {
            steps.trunc()
        } else {
            steps.round_ties_even()
        };
    if rounded.abs() >= 2f64.powi(bias + 1) { f64::INFINITY.copysign(x) } else { rounded }
}

/// An unsigned float of 11 or 10 bits (GL 3.3, sections 2.1.3 and 2.1.4): the closest *finite* one of a finite number,
/// 0 of a negative one, infinity and NaN of themselves.
pub fn packed_float(x: f64, mantissa: i32, variant: Variant) -> f64 {
    let largest = (2.0 - 2f64.powi(-mantissa)) * 32768.0;
    if x.is_nan() {
        return if variant.has(Mutation::NanIsZero) { 0.0 } else { x };
    }
    if x < 0.0 && variant.has(Mutation::NegativeIsAbsolute) {
        return small_float(-x, mantissa, 5, variant).min(largest);
    }
    let rounded = small_float(x.max(0.0), mantissa, 5, variant);
    let overflows = x.is_finite() && !variant.has(Mutation::OverflowIsInfinite);
    if overflows { rounded.min(largest) } else { rounded }
}

/// EXT_texture_shared_exponent, section 3.8.x: N = 9, B = 15, the exponent is that of the largest
/// component, one more where its mantissa rounds up to 2^N.
pub fn shared_exponent([r, g, b, _]: [f64; 4], variant: Variant) -> [f64; 4] {
    const LARGEST: f64 = 511.0 / 512.0 * 65536.0;
    let c = [r, g, b].map(|c| if c.is_nan() { 0.0 } else { c.clamp(0.0, LARGEST) });
    let half = if variant.has(Mutation::SharedTruncates) { 0.0 } else { 0.5 };
    let max = if variant.has(Mutation::ExponentOfRed) { c[0] } else { c[0].max(c[1]).max(c[2]) };
    let preliminary = if max > 0.0 { (max.log2().floor()).max(-16.0) + 1.0 + 15.0 } else { 0.0 };
    let unit = |e: f64| (e - 15.0 - 9.0).exp2();
    let e = if (max / unit(preliminary) + half).floor() >= 512.0
        && !variant.has(Mutation::ExponentNotRaised)
    {
        preliminary + 1.0
    } else {
        preliminary
    };
    let [r, g, b] = c.map(|c| (c / unit(e) + half).floor().min(511.0) * unit(e));
    [r, g, b, 0.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn small_floats_by_hand() {
        let table = [
            (65504.0, 65504.0),
            (65520.0, f64::INFINITY),
            (1.0 + 2f64.powi(-11), 1.0),
            (1.0 + 3.0 * 2f64.powi(-11), 1.0 + 2f64.powi(-9)),
            (2f64.powi(-24), 2f64.powi(-24)),
            (2f64.powi(-26), 0.0),
        ];
        for (x, expected) in table {
            assert_eq!(small_float(x, 10, 5, TRUE), expected, "{x}");
        }
    }

    #[test]
    fn packed_floats_by_hand() {
        let table = [
            (1.0 + 2f64.powi(-7), 1.0),
            (1.0 + 3.0 * 2f64.powi(-7), 1.0 + 2f64.powi(-5)),
            (1e9, 65024.0),
            (f64::INFINITY, f64::INFINITY),
            (-3.0, 0.0),
            (f64::NEG_INFINITY, 0.0),
            (2f64.powi(-20), 2f64.powi(-20)),
            (2f64.powi(-21), 0.0),
        ];
        for (x, expected) in table {
            assert_eq!(packed_float(x, 6, TRUE), expected, "{x}");
        }
        assert!(packed_float(f64::NAN, 6, TRUE).is_nan());
        assert_eq!(packed_float(65535.0, 5, TRUE), 64512.0);
    }

    #[test]
    fn shared_exponents_by_hand() {
        assert_eq!(shared_exponent([1.0, 0.5, 0.25, 0.0], TRUE)[..3], [1.0, 0.5, 0.25]);
        // 511.6/512 does not fit 9 bits: the exponent grows.
        assert_eq!(shared_exponent([511.6 / 512.0, 0.0, 0.0, 0.0], TRUE)[0], 1.0);
        assert_eq!(shared_exponent([1e9, -1.0, 0.0, 0.0], TRUE)[..2], [65408.0, 0.0]);
    }

    #[test]
    fn normalized_by_hand() {
        let bits = Encoding::Unorm([3, 3, 2, 0]);
        assert_eq!(
            stored(Base::Rgb, bits, [0.5, 1.5, 0.4, 1.0], TRUE)[..3],
            [4.0 / 7.0, 1.0, 1.0 / 3.0]
        );
        assert_eq!(stored(Base::Red, Encoding::Snorm(8), [-2.0, 0.0, 0.0, 0.0], TRUE)[0], -1.0);
    }
}
