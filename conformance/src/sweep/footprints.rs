//! Footprints at their extremes: explicit and implicit derivatives, anisotropy, biases, clamps of λ.

use super::definition::Sweep;
use super::drawn::{painted, square};
use super::series::{Compared, Series, decades};
use super::texture::{GRAD, apart};
use crate::mutation::Variant;
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{Filter, Filters, LevelRange, LodState, Mipmap};
use crate::oracle::sample::{self, Sampler};
use crate::oracle::texture::{Level, level_count, level_size};
use crate::oracle::wrap::Wrap;
use crate::probe::{ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;

/// Explicit footprints.
pub const EXPLICIT: Sweep = Sweep {
    name: "huge-footprints",
    what: "texture2DGrad of an image of 64² under footprints of this size, against its last level; \
           1e39 stands for infinite ones, 1e40 for NaN, which may read any level",
    parameter: "size of the derivatives",
    unit: "of range",
    bound: 0.0000003,
    why: "every footprint of 64 texels or more is the last level's one texel, with any anisotropy: a mean of equal texels, rounded a few times",
    breaks: "squares of derivatives leave f32 from 1e19 on; λ is clamped to the last level then, as \
             for infinite ones; NaN gives a texel of some level, never NaN",
    kept: 1.0,
    distinct: 0.0,
    before: &[],
    run: explicit,
};

/// Implicit footprints.
pub const IMPLICIT: Sweep = Sweep {
    name: "huge-differences",
    what: "a texture over a square of 16 × 16 pixels whose coordinates grow by this much a pixel, \
           against its last level",
    parameter: "growth of s and t over a pixel",
    unit: "of range",
    bound: 0.0,
    why: "the footprints are round, and the last level has one texel",
    breaks: "coordinates beyond 3.4e38 are infinite and their differences NaN: not tried",
    kept: 1.0,
    distinct: 0.0,
    before: &[],
    run: implicit,
};

/// Large biases.
pub const BIAS: Sweep = Sweep {
    name: "lod-bias",
    what: "trilinear samples at λ = 2.3 with a GL_TEXTURE_LOD_BIAS of this size",
    parameter: "size of the bias",
    unit: "of range",
    bound: 0.0000003,
    why: "λ is f32, whose step at 2.3 is 2^-22, and weighs levels",
    breaks: "biases beyond ±GL_MAX_TEXTURE_LOD_BIAS (16) are clamped to it, which no image can tell: \
             it reads the base or the last level",
    kept: 1.0,
    distinct: 0.3,
    before: &[],
    run: bias,
};

/// Clamps that exclude each other.
pub const CLAMPS: Sweep = Sweep {
    name: "lod-clamps",
    what: "samples whose GL_TEXTURE_MIN_LOD is above GL_TEXTURE_MAX_LOD by this much, against those \
           at either",
    parameter: "minimum less maximum",
    unit: "of range",
    bound: 0.00000015,
    why: "as for biases",
    breaks: "GL leaves such clamps undefined: the λ here is always the one or the other",
    kept: 1.0,
    distinct: 0.0,
    before: &[],
    run: clamps,
};

const SIZE: [usize; 2] = [64, 64];

fn image() -> Vec<Level> {
    let mut rng = Rng::named("footprints");
    (0..level_count(SIZE))
        .map(|l| {
            let [w, h] = level_size(SIZE, l);
            Level::from_fn(w, h, |_, _| [0; 4].map(|_: u8| rng.byte()))
        })
        .collect()
}

fn trilinear(last: usize, lod: LodState) -> Sampler {
    let filters = Filters { min: Filter::Linear, mipmap: Mipmap::Linear, mag: Filter::Linear };
    Sampler {
        at: Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] },
        filters,
        lod,
        range: LevelRange { base: 0, last },
    }
}

fn explicit() -> Result<Vec<Series>, ProbeError> {
    let image = image();
    let last = image[image.len() - 1].texel(0, 0).map(|c| f64::from(c as f32));
    let mut lines = Vec::new();
    for (name, limit, [x, y]) in [
        ("isotropic", 1.0, [1.0, 1.0]),
        ("anisotropic, round", 16.0, [1.0, 1.0]),
        ("anisotropic, twice as long", 16.0, [2.0, 1.0]),
        ("anisotropic, one direction 100", 16.0, [1.0, 0.0]),
    ] {
        let session = Session::open()?;
        session.texture_2d(&image, &trilinear(image.len() - 1, LodState::default()))?;
        session.anisotropy(limit)?;
        lines.push(Series::measured(name, decades(4..=40), |size| {
            let size = match size {
                size if size > 1e39 => f32::NAN,
                size if size > 3e38 => f32::INFINITY,
                size => size as f32,
            };
            // A width of 100 is far past the last level too.
            let [dx, dy] = [size * x, if y == 0.0 { 100.0 } else { size * y }];
            let mut rng = Rng::named(name);
            let inputs: Vec<_> = (0..64)
                .map(|_| {
                    let st = [0; 2].map(|_: i32| rng.real(0.0, 1.0));
                    [[st[0], st[1], 0.0, 0.0], [dx, 0.0, 0.0, dy]]
                })
                .collect();
            let mut compared = Compared::new();
            for value in session.float_words(GRAD, &inputs)? {
                let in_range = value.iter().all(|c| (0.0..=1.0).contains(c));
                let error = match size.is_nan() {
                    true if in_range => 0.0,
                    true => 1.0,
                    false => apart(value, last),
                };
                compared.add(error, &value);
            }
            Ok(compared)
        })?);
    }
    Ok(lines)
}

fn implicit() -> Result<Vec<Series>, ProbeError> {
    let image = image();
    let last = image[image.len() - 1].texel(0, 0).map(|c| f64::from(c as f32));
    let mut lines = Vec::new();
    for (name, limit) in [("isotropic", 1.0), ("anisotropic", 16.0)] {
        let session = Session::open()?;
        session.texture_2d(&image, &trilinear(image.len() - 1, LodState::default()))?;
        session.anisotropy(limit)?;
        painted(
            &session,
            "uniform sampler2D image;
             void main() { color = texture(image, texture_coordinates.xy); }",
        )?;
        session.frame(GL_RGBA32F, [16, 16], 0)?;
        lines.push(Series::measured(name, decades(2..=37), |growth| {
            let far = (growth * 16.0) as f32;
            square([[0.0, 0.0], [far, 0.0], [far, far], [0.0, far]].map(|[s, t]| [s, t, 0.0, 1.0]));
            let mut compared = Compared::new();
            for value in session.read_floats([16, 16])? {
                compared.add(apart(value, last), &value);
            }
            Ok(compared)
        })?);
    }
    Ok(lines)
}

/// Samples at λ = 2.3 with this state, and their expected values at the λs that are given.
fn at_lambda(image: &[Level], lod: LodState, lambdas: &[f64]) -> Result<Compared, ProbeError> {
    let session = Session::open()?;
    let sampler = trilinear(image.len() - 1, lod);
    session.texture_2d(image, &sampler)?;
    let reach = (2.3f64.exp2() / 64.0) as f32;
    let mut rng = Rng::named("at-lambda");
    let inputs: Vec<_> = (0..64)
        .map(|_| {
            let st = [0; 2].map(|_: i32| rng.dyadic(0.0, 1.0, 2f64.powi(-20)));
            [[st[0], st[1], 0.0, 0.0], [reach, 0.0, 0.0, reach]]
        })
        .collect();
    let mut compared = Compared::new();
    for (input, value) in inputs.iter().zip(session.float_words(GRAD, &inputs)?) {
        let st = [input[0][0], input[0][1]].map(f64::from);
        let of = |&lambda: &f64| {
            apart(value, sample::at_lambda(image, &sampler, st, lambda, Variant::CORRECT))
        };
        compared.add(lambdas.iter().map(of).fold(f64::INFINITY, f64::min), &value);
    }
    Ok(compared)
}

fn bias() -> Result<Vec<Series>, ProbeError> {
    let image = image();
    let mut lines = Vec::new();
    for (name, sign) in [("positive", 1.0), ("negative", -1.0)] {
        let sizes = (-8..=24).map(|step| 10f64.powf(f64::from(step) / 4.0));
        lines.push(Series::measured(name, sizes, |size| {
            let object_bias = f64::from((sign * size) as f32);
            let lod = LodState { object_bias, ..LodState::default() };
            let lambda = f64::from((2.3f64.exp2()) as f32).log2() + object_bias.clamp(-16.0, 16.0);
            at_lambda(&image, lod, &[lambda])
        })?);
    }
    Ok(lines)
}

fn clamps() -> Result<Vec<Series>, ProbeError> {
    let image = image();
    let excess = (-8..=24).map(|step| 10f64.powf(f64::from(step) / 4.0));
    let line = Series::measured("largest error", excess, |excess| {
        let max_lod = 1.5;
        let min_lod = f64::from((max_lod + excess) as f32);
        let lod = LodState { min_lod, max_lod, ..LodState::default() };
        at_lambda(&image, lod, &[min_lod, max_lod])
    })?;
    Ok(vec![line])
}
