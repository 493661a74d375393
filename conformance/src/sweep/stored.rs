//! What is stored: sRGB, small floats and shared exponents at ties and ends, mip chains.

use super::definition::Sweep;
use super::drawn::{float_texture, square};
use super::series::{Compared, Series, octaves};
use crate::check::Unit;
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::format::{packed_float, shared_exponent, small_float};
use crate::oracle::srgb;
use crate::probe::{ProbeError, Session, TexelRow};
use crate::rng::Rng;
use gl_api::constants::*;

/// sRGB encoding.
pub const SRGB: Sweep = Sweep {
    name: "srgb-encode",
    what: "codes that a linear colour of this size is stored as with GL_FRAMEBUFFER_SRGB, less the \
           exact encoding times 255",
    parameter: "linear value",
    unit: "codes",
    bound: 0.505,
    why: "half a code of rounding, and the encoding's own error in f32",
    breaks: "at 0.0031308 the linear part meets the power, which differ there by 1e-8; below 1.5e-4 \
             everything is code 0",
    kept: 1.0,
    distinct: 0.1,
    before: &[],
    run: encode,
};

/// Half floats.
pub const HALF: Sweep = Sweep {
    name: "half-ties",
    what: "texels of GL_RGBA16F of numbers at and beside ties, of this size",
    parameter: "size",
    unit: "ULP of f32",
    bound: 0.0,
    why: "rounding to the nearest, ties to even, is exact",
    breaks: "below 2^-14 denormals keep steps of 2^-24; from 65520 on the texel is infinite",
    kept: 1.0,
    distinct: 0.7,
    before: &[],
    run: half,
};

/// Floats of 11 and 10 bits.
pub const PACKED: Sweep = Sweep {
    name: "r11f-ties",
    what: "texels of GL_R11F_G11F_B10F of numbers at and beside ties, of this size",
    parameter: "size",
    unit: "ULP of f32",
    bound: 0.0,
    why: "rounding to the nearest, ties to even, is exact",
    breaks: "below 2^-14 denormals keep steps of 2^-20 (2^-19 in blue); beyond 65024 (64512) the \
             largest float is kept, infinity stays infinite, negative numbers are 0",
    kept: 1.0,
    distinct: 0.5,
    before: &[],
    run: packed,
};

/// Shared exponents.
pub const SHARED: Sweep = Sweep {
    name: "rgb9e5-ties",
    what: "texels of GL_RGB9_E5 whose largest component is at or beside a tie, of this size",
    parameter: "size of the largest component",
    unit: "ULP of f32",
    bound: 0.0,
    why: "the algorithm of EXT_texture_shared_exponent, which is exact",
    breaks: "components below 2^-9 of the largest lose all bits; from 65408 on all is held at that; \
             below 2^-24 all is 0",
    kept: 1.0,
    distinct: 0.5,
    before: &[],
    run: shared,
};

/// Energy of mip chains.
pub const ENERGY: Sweep = Sweep {
    name: "mip-energy",
    what: "the one texel of the last level of a row of n texels, from glGenerateMipmap, against the mean \
           of all texels",
    parameter: "n",
    unit: "of 2^-24",
    bound: 2.0,
    why: "each level rounds a weighted mean of two or three texels; 13 levels",
    breaks: "sizes that are not even have levels whose texels overlap three: each is weighted by the \
             length that it is covered on, so that nothing is lost at n = 8191 either",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: energy,
};

fn encode() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    session.frame(GL_SRGB8_ALPHA8, [4, 4], 0)?;
    glEnable(GL_FRAMEBUFFER_SRGB);
    let about = (-8..=8).map(|step| 0.003_130_8 * (1.0 + f64::from(step) * 1e-3));
    let sizes = (0..=40).map(|step| 10f64.powf(f64::from(step) / 10.0 - 4.0));
    let mut lines = Vec::new();
    for (name, values) in
        [("all sizes", sizes.collect::<Vec<f64>>()), ("about 0.0031308", about.collect())]
    {
        lines.push(Series::measured(name, values, |size| {
            let mut compared = Compared::new();
            for part in 0..8 {
                let linear = (size * (1.0 + f64::from(part) / 16.0)).min(1.0) as f32;
                glColor4f(linear, linear, linear, 1);
                square([[0.0; 4]; 4]);
                let mut bytes = [0u8; 4];
                glReadPixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut bytes);
                session.check("encoding sRGB")?;
                let exact = srgb::encode(f64::from(linear)) * 255.0;
                compared.add((f64::from(bytes[0]) - exact).abs(), &[f64::from(bytes[0])]);
            }
            Ok(compared)
        })?);
    }
    Ok(lines)
}

/// Numbers about a size: at multiples of a sixteenth of a step of `mantissa` bits, and their neighbours.
fn about(rng: &mut Rng, size: f64, mantissa: i32) -> Vec<f32> {
    let step = size * 2f64.powi(-mantissa);
    let multiple = |k: i64| (size + step * k as f64 / 16.0) as f32;
    let tie = |n: i64| multiple(16 * n + 8);
    let mut values = Vec::new();
    for _ in 0..32 {
        let n = rng.integer(0, (1 << mantissa) - 1);
        values.extend([
            tie(n),
            tie(n).next_up(),
            tie(n).next_down(),
            multiple(rng.integer(0, 4096)),
        ]);
    }
    values
}

/// The errors of stored texels of one format.
fn ties(
    name: &'static str,
    internal: u32,
    mantissa: i32,
    exponents: std::ops::RangeInclusive<i32>,
    components: usize,
    exact: impl Fn([f64; 4]) -> [f64; 4],
) -> Result<Series, ProbeError> {
    Series::measured(name, octaves(exponents, 1), |size| {
        let mut rng = Rng::named(name);
        let values = about(&mut rng, size, mantissa);
        let texels: Vec<[f32; 4]> =
            values.iter().map(|&v| [v, v * 0.75, v * rng.real(0.0, 1.0), 1.0]).collect();
        let row = TexelRow { internal, is_depth: false, texels: &texels };
        let session = Session::open()?;
        session.texel_row(&row)?;
        let mut compared = Compared::new();
        for (texel, stored) in texels.iter().zip(session.query_texel_row(&row)?) {
            let exact = exact(texel.map(f64::from));
            let errors = (0..components).map(|c| Unit::Ulp.error(exact[c], stored[c]));
            compared.add(errors.fold(0.0, f64::max), &stored[..components]);
        }
        Ok(compared)
    })
}

const TRUE: Variant = Variant::CORRECT;

fn half() -> Result<Vec<Series>, ProbeError> {
    let exact = |v: [f64; 4]| v.map(|c| small_float(c, 10, 5, TRUE));
    Ok(vec![ties("largest error", GL_RGBA16F, 10, -27..=17, 4, exact)?])
}

fn packed() -> Result<Vec<Series>, ProbeError> {
    let exact = |[r, g, b, _]: [f64; 4]| {
        [packed_float(r, 6, TRUE), packed_float(g, 6, TRUE), packed_float(b, 5, TRUE), 1.0]
    };
    Ok(vec![ties("largest error", GL_R11F_G11F_B10F, 6, -23..=17, 3, exact)?])
}

fn shared() -> Result<Vec<Series>, ProbeError> {
    let exact = |v: [f64; 4]| shared_exponent(v, TRUE);
    Ok(vec![ties("largest error", GL_RGB9_E5, 8, -27..=17, 3, exact)?])
}

fn energy() -> Result<Vec<Series>, ProbeError> {
    let sizes = [
        2, 3, 5, 7, 15, 17, 31, 63, 100, 127, 255, 300, 511, 1023, 1025, 2047, 4095, 5000, 8191,
        8192,
    ];
    let line = Series::measured("largest error", sizes.map(f64::from), |n| {
        let n = n as usize;
        let session = Session::open()?;
        let mut rng = Rng::named("mip-energy");
        let texels: Vec<[f32; 4]> =
            (0..n).map(|_| [0; 4].map(|_: i32| rng.real(0.0, 1.0))).collect();
        float_texture(&session, GL_RGBA32F, [n, 1], &texels)?;
        glGenerateMipmap(GL_TEXTURE_2D);
        let last = session.level_texels(GL_TEXTURE_2D, n.ilog2() as usize, [1, 1, 1])?;
        let mut compared = Compared::new();
        for c in 0..4 {
            let mean = texels.iter().map(|t| f64::from(t[c])).sum::<f64>() / n as f64;
            let value = last.first().map_or(f64::NAN, |t| t[c]);
            compared.add((value - mean).abs() / 2f64.powi(-24), &[value]);
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}
