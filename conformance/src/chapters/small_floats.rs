//! RGB9E5 and R11F_G11F_B10F where rounding decides: ties, denormals, overflow and NaN, uploaded and rendered.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::format::{packed_float, shared_exponent};
use crate::probe::{Dialect, ProbeError, TexelRow};
use crate::rng::Rng;
use gl_api::constants::*;

/// Shared exponents.
pub const SHARED: Check = Check {
    name: "rgb9e5-rounding",
    citation: "OpenGL ES 3.0, 3.8.3.2; EXT_texture_shared_exponent",
    what: "floats at the middle between two mantissas, below the least exponent, beyond the largest \
           number and NaN, uploaded",
    unit: Unit::Ulp,
    tolerance: 0.0,
    why: "the formula is floor(c / 2^(e - 24) + 1/2), in powers of two: exact",
    run: shared,
};

/// Unsigned floats that are uploaded.
pub const UPLOADED: Check = Check {
    name: "r11f-upload",
    citation: "OpenGL ES 3.0, 2.1.3 and 2.1.4",
    what: "floats at and beside the middle between two unsigned floats of 11 and 10 bits, denormals, \
           overflow, negative ones, infinities and NaN, uploaded",
    unit: Unit::Ulp,
    tolerance: 0.0,
    why: "the closest finite number; at the middle, which the specification leaves open, the even one",
    run: |harness, tally| packed(harness, tally, WritePath::Uploaded),
};

/// Unsigned floats that are rendered.
pub const RENDERED: Check = Check {
    name: "r11f-render",
    citation: "GL 3.3, 2.1.3, 2.1.4 and 4.2.1",
    what: "the same numbers as colours of fragments",
    unit: Unit::Ulp,
    tolerance: 0.0,
    why: "the closest finite number; at the middle, which the specification leaves open, the even one",
    run: |harness, tally| packed(harness, tally, WritePath::Rendered),
};

/// How numbers get into the image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum WritePath {
    Uploaded,
    Rendered,
}

const WIDTH: usize = 256;

fn shared(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("rgb9e5-rounding");
    for row in 0..harness.cases(32) {
        let cases: Vec<[f32; 4]> = (0..WIDTH).map(|_| shared_case(&mut rng)).collect();
        let halves = cases.as_flattened().iter().filter(|c| is_tie(**c, 9)).count();
        tally.reach(format!("row {row}, middles between mantissas"), halves, WIDTH / 8);
        let expect = |case: &[f32; 4], variant: Variant| {
            let [r, g, b, _] = shared_exponent(case.map(f64::from), variant);
            [r, g, b, 1.0]
        };
        harness.compare_with(Dialect::Es, tally, &"RGB9E5", &cases, expect, |session| {
            let texels: Vec<f32> = cases.iter().flat_map(|c| [c[0], c[1], c[2]]).collect();
            upload(GL_RGB9_E5, &texels);
            session.row()
        })?;
    }
    Ok(())
}

/// Whether the last bit of the mantissa that is set is this one.
fn is_tie(x: f32, bits: u32) -> bool {
    x.is_normal() && x.to_bits().trailing_zeros() == 23 - bits
}

fn shared_case(rng: &mut Rng) -> [f32; 4] {
    let exponent = rng.integer(-26, 17) as f32;
    let mut case = [0; 4].map(|_: i32| {
        let nine_bits = rng.integer(0, 511) as f32 + rng.pick(&[0.0, 0.5, 0.5, 0.499, 0.501]);
        nine_bits / 512.0 * exponent.exp2()
    });
    let special = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1.0, 1e9, 65408.0, 65407.9, 1e-40];
    if rng.integer(0, 7) == 0 {
        case[rng.integer(0, 2) as usize] = rng.pick(&special);
    }
    if rng.integer(0, 7) == 0 {
        // The largest mantissa rounds up, and the exponent with it.
        case[rng.integer(0, 2) as usize] = 511.75 / 512.0 * exponent.exp2();
    }
    case
}

fn packed(harness: &Harness, tally: &mut Tally, path: WritePath) -> Result<(), ProbeError> {
    let mut rng = Rng::named("r11f");
    let dialect = match path {
        WritePath::Uploaded => Dialect::Es,
        WritePath::Rendered => Dialect::Compatibility,
    };
    for row in 0..harness.cases(32) {
        let cases: Vec<[f32; 4]> = (0..WIDTH)
            .map(|_| {
                [packed_case(&mut rng, 6), packed_case(&mut rng, 6), packed_case(&mut rng, 5), 1.0]
            })
            .collect();
        let count = |f: &dyn Fn(&[f32; 4]) -> bool| cases.iter().filter(|case| f(case)).count();
        tally.reach(format!("row {row}, middles"), count(&|c| is_tie(c[0], 7)), WIDTH / 8);
        tally.reach(format!("row {row}, overflow"), count(&|c| c[0] > 65024.0), 4);
        let expect = |case: &[f32; 4], variant: Variant| {
            let c = |i: usize, mantissa| packed_float(case[i].into(), mantissa, variant);
            [c(0, 6), c(1, 6), c(2, 5), 1.0]
        };
        harness.compare_with(dialect, tally, &path, &cases, expect, |session| match path {
            WritePath::Uploaded => {
                let texels: Vec<f32> = cases.iter().flat_map(|c| [c[0], c[1], c[2]]).collect();
                upload(GL_R11F_G11F_B10F, &texels);
                session.row()
            }
            WritePath::Rendered => {
                let row = TexelRow { internal: GL_RGBA32F, is_depth: false, texels: &cases };
                session.texel_row(&row)?;
                session.copied_by_fragments(GL_R11F_G11F_B10F, WIDTH)
            }
        })?;
    }
    Ok(())
}

/// A number that has so many bits of mantissa, or lies between two.
fn packed_case(rng: &mut Rng, mantissa: i32) -> f32 {
    let steps = 1i64 << mantissa;
    let special =
        [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1.0, 1e9, 65024.0, 65535.9, 64768.0, 1e-40];
    if rng.integer(0, 7) == 0 {
        return rng.pick(&special);
    }
    let part = rng.pick(&[0.0, 0.5, 0.5, 0.499, 0.501, 0.25]);
    let fraction = (rng.integer(0, steps - 1) as f32 + part) / steps as f32;
    match rng.integer(-15, 16) {
        -15 => fraction * (-14f32).exp2(),
        exponent => (1.0 + fraction) * (exponent as f32).exp2(),
    }
}

fn upload(internal: u32, texels: &[f32]) {
    glBindTexture(GL_TEXTURE_2D, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, internal, WIDTH, 1, 0, GL_RGB, GL_FLOAT, texels);
}
