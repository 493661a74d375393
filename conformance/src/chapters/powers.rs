//! Powers whose exponents are constants of the shader, as those of gamma curves: they may be computed in another way than
//! those whose exponents vary.

use super::builtin::cut_to_18_bits;
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Powers of floats.
pub const OF_FLOATS: Check = Check {
    name: "pow-constant",
    citation: "GLSL 1.30, 8.2: pow(x, y) is x to the power of y",
    what: "pow(x, y) of 16 constant exponents, of all bytes' values, whole numbers, floats of all sizes, powers of two and of √½ and their neighbours",
    unit: Unit::Ulp,
    tolerance: TOLERANCE,
    why: WHY,
    run: floats,
};

/// Powers of texels.
pub const OF_TEXELS: Check = Check {
    name: "pow-texels",
    citation: "GLSL 1.30, 8.2: pow(x, y); GL 2.1, table 2.9: c/(2^8 - 1)",
    what: "pow(x, y) of 12 constant exponents, of components of nearest texels of bytes, from the first draw of a shader to the fourth",
    unit: Unit::Ulp,
    tolerance: TOLERANCE,
    why: WHY,
    run: texels,
};

const TOLERANCE: f64 = 0.75;
const WHY: &str = "GLSL 1.30 gives no bound. In f64, rounded once: 1/2 ULP; a polynomial that is fitted to the exponent, off by 2^-26 of the power, which is below 2: 1/4 ULP";

/// Exponents, four to a shader. The last four have no power of 0.
const EXPONENTS: [[f32; 4]; 4] = [
    [2.2, 2.4, 1.0 / 2.2, 1.0 / 2.4],
    [0.5, 2.0, 3.0, 0.45],
    [1.5, 5.0, 0.25, 8.0],
    [-1.0, -2.2, -0.5, 17.5],
];

/// `vec4 value()` of the powers of four numbers.
fn body(of: [&str; 4], exponents: [f32; 4], head: &str) -> String {
    let power = |i: usize| format!("pow({}, {:?})", of[i], exponents[i]);
    let powers = [0, 1, 2, 3].map(power).join(", ");
    format!("{head} vec4 value() {{ return vec4({powers}); }}")
}

fn power(x: f64, exponent: f32, variant: Variant) -> f64 {
    let value = x.powf(exponent.into());
    if variant.has(Mutation::BuiltinOf18Bits) { cut_to_18_bits(value) } else { value }
}

/// Numbers whose powers are asked for.
fn bases(rng: &mut Rng, count: usize) -> Vec<f32> {
    let bytes = (0..=255).map(|byte| byte as f32 / 255.0);
    let whole = (1..=100).map(|number| number as f32);
    // Where an exponent of two, or a part of a mantissa, begins.
    let edges = (-30..=12).flat_map(|exponent| {
        let scale = 2f32.powi(exponent);
        [scale, scale * std::f32::consts::FRAC_1_SQRT_2]
    });
    let edges = edges.flat_map(|edge| {
        [-2, -1, 0, 1, 2].map(|by| f32::from_bits(edge.to_bits().wrapping_add_signed(by)))
    });
    let mut all: Vec<f32> = bytes.chain(whole).chain(edges).collect();
    while all.len() < count {
        all.push(match rng.integer(0, 3) {
            0 => f32::from_bits(rng.integer(0x0080_0000, 0x7f7f_ffff) as u32),
            1 => rng.real(0.0, 1.0),
            _ => rng.real(-26.0, 9.0).exp2(),
        });
    }
    all
}

fn floats(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("pow-constant");
    for exponents in EXPONENTS {
        let has_power_of_zero = exponents.iter().all(|exponent| *exponent > 0.0);
        let cases: Vec<f32> = bases(&mut rng, harness.cases(1 << 15))
            .into_iter()
            .filter(|base| *base > 0.0 || has_power_of_zero)
            .collect();
        let expect = |case: &f32, variant: Variant| {
            exponents.map(|exponent| power(f64::from(*case), exponent, variant))
        };
        harness.compare(tally, &exponents, &cases, expect, |session| {
            let inputs: Vec<_> =
                cases.iter().map(|x| [[*x, 0.0, 0.0, 0.0], [0.0; 4], [0.0; 4]]).collect();
            session.field(&body(["a.x"; 4], exponents, ""), 4, &inputs)
        })?;
    }
    Ok(())
}

/// The texel of a column: all bytes in each component, in four orders.
fn texel(column: usize) -> [u8; 4] {
    [column, 255 - column, column * 37 + 11, column * 101 + 7].map(|byte| byte as u8)
}

fn texels(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    for exponents in &EXPONENTS[..3] {
        let cases: Vec<usize> = (0..256).collect();
        let expect = |case: &usize, variant: Variant| {
            let texel = texel(*case);
            std::array::from_fn(|i| {
                // What is sampled: an f32.
                let x = f32::from(texel[i]) / 255.0;
                power(x.into(), exponents[i], variant)
            })
        };
        harness.compare(tally, exponents, &cases, expect, |session| {
            let bytes: Vec<u8> = (0..256).flat_map(texel).collect();
            let target = GL_TEXTURE_2D;
            glActiveTexture(GL_TEXTURE0);
            glBindTexture(target, 1);
            glTexImage2D(target, 0, GL_RGBA8, 256, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &bytes);
            glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
            let inputs: Vec<_> = cases
                .iter()
                .map(|column| {
                    let s = (*column as f32 + 0.5) / 256.0;
                    [[s, 0.5, 0.0, 0.0], [0.0; 4], [0.0; 4]]
                })
                .collect();
            let read = ["r", "g", "b", "a"].map(|c| format!("texture2D(image, a.xy).{c}"));
            let head = "uniform sampler2D image;";
            session.field(&body(read.each_ref().map(String::as_str), *exponents, head), 4, &inputs)
        })?;
    }
    Ok(())
}
