//! Texture coordinates, footprints and levels at their extremes.

use super::definition::Sweep;
use super::series::{Compared, Series, decades, octaves};
use super::shaded::of;
use crate::check::Unit;
use crate::mutation::Variant;
use crate::oracle::anisotropy;
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{Derivatives, Filter, Filters, LevelRange, LodState, Mipmap};
use crate::oracle::sample::{self, Sampler};
use crate::oracle::seamless;
use crate::oracle::texture::{Level, level_count, level_size};
use crate::oracle::wrap::Wrap;
use crate::probe::{Precision, ProbeError, Session, TexelRow, shader};
use crate::rng::Rng;
use gl_api::constants::*;

/// Coordinates far outside of [0, 1].
pub const REPEAT: Sweep = Sweep {
    name: "far-coordinates",
    what: "place that GL_REPEAT reads of 256 texels, of coordinates up to this size, either sign",
    parameter: "size of s",
    unit: "texels",
    bound: 1.0 / (1 << 16) as f64,
    why: "s - floor(s) is exact in f32 and so is the product with 256; the filter's weight is a float below 256",
    breaks: "from 2^16 on s itself has less than 8 bits below a texel of 256; the texel that is read is that \
             of the float that was given",
    kept: 0.4,
    distinct: 0.9,
    before: &[],
    run: repeat,
};

/// Projective coordinates.
pub const Q_THROUGH_ZERO: Sweep = Sweep {
    name: "q-through-zero",
    what: "place that texture2DProj reads of 256 texels, of (s·q, t·q, q) with q of either sign",
    parameter: "size of q",
    unit: "texels",
    bound: 0.000012,
    why: "one division: s/q to 2^-24, times 256 texels, whatever q that is no denormal",
    breaks: "q of 0 has no place (it reads some texel, and nothing else changes); of denormal q and s/q \
             above 1e38 no promise is made but that",
    kept: 0.9,
    distinct: 0.9,
    before: &[],
    run: q_through_zero,
};

/// Stretched footprints.
pub const ANISOTROPY: Sweep = Sweep {
    name: "anisotropy",
    what: "a footprint this many times as long as wide, of which 16 times count, against the formula",
    parameter: "σ₁/σ₂",
    unit: "of range",
    bound: 0.0001,
    why: "beyond 16 the width is σ₁/16, which no cancellation touches",
    breaks: "beyond 16 the footprint is treated as 16 times as long as wide, and blurs",
    kept: 0.5,
    distinct: 0.4,
    before: &[],
    run: stretched,
};

/// Levels of detail.
pub const LAMBDA: Sweep = Sweep {
    name: "lambda",
    what: "trilinear sample under explicit derivatives of this size, against the formula",
    parameter: "ρ in texels",
    unit: "of range",
    bound: 0.0000004,
    why: "λ and the weights of levels and texels are f32; the square of ρ leaves the range of f32 beyond 2^±63, where λ is clamped to a level anyway",
    breaks: "ρ whose square leaves f32, beyond 2^±63, is far outside of the levels there are: the base or \
             the last one is read",
    kept: 1.0,
    distinct: 0.05,
    before: &[],
    run: lambda,
};

/// Cube edges.
pub const CUBE_EDGE: Sweep = Sweep {
    name: "cube-edge",
    what: "seamless bilinear sample at this angle on either side of an edge",
    parameter: "radians from the edge",
    unit: "of range",
    bound: 0.0000012,
    why: "both faces have the same two texels at their common edge",
    breaks: "angles below 6e-8 are not told apart in f32; either face gives the same texels at the edge",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: cube_edge,
};

/// Denormals.
pub const DENORMALS: Sweep = Sweep {
    name: "denormals",
    what: "a float texel of this size, through sampler and shader",
    parameter: "size of the texel",
    unit: "ULP",
    bound: 0.0,
    why: "nothing is flushed to zero",
    breaks: "nowhere: nothing is flushed to zero, down to 2^-149",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: denormals,
};

fn sampler(filters: Filters, last: usize) -> Sampler {
    Sampler {
        at: Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] },
        filters,
        lod: LodState::default(),
        range: LevelRange { base: 0, last },
    }
}

const TRILINEAR: Filters =
    Filters { min: Filter::Linear, mipmap: Mipmap::Linear, mag: Filter::Linear };

/// A row whose texel `i` has the value `i`, so that a sample's value is its coordinate.
fn ruler(session: &Session) -> Result<(), ProbeError> {
    let texels: Vec<[f32; 4]> = (0..256).map(|i| [i as f32, 0.0, 0.0, 1.0]).collect();
    session.texel_row(&TexelRow { internal: GL_RGBA32F, is_depth: false, texels: &texels })?;
    session.parameters(&[
        (GL_TEXTURE_MIN_FILTER, GL_LINEAR),
        (GL_TEXTURE_MAG_FILTER, GL_LINEAR),
        (GL_TEXTURE_WRAP_S, GL_REPEAT),
    ])
}

/// Compares samples of the ruler with their expected coordinates, but at the seam of the repeated row.
fn misplaced(places: &[[f64; 4]], expected: impl Iterator<Item = f64>) -> Compared {
    let mut compared = Compared::new();
    for (place, u) in places.iter().zip(expected) {
        if (0.5..254.5).contains(&u) {
            compared.add((place[0] - u).abs(), &place[..1]);
        } else {
            compared.leave_out();
        }
    }
    compared
}

fn repeat() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    ruler(&session)?;
    let line = Series::measured("largest misplacement", octaves(0..=22, 1), |size| {
        let mut rng = Rng::named("far-coordinates");
        let cases: Vec<f32> = (0..4096).map(|_| rng.real(-size, size)).collect();
        let inputs: Vec<_> = cases.iter().map(|&s| of([s, 0.5, 0.0, 0.0])).collect();
        let body = "uniform sampler2D image;
            vec4 value(vec4 a, vec4 b) { return textureLod(image, a.xy, 0.0); }";
        let places = session.float_words(body, &inputs)?;
        Ok(misplaced(&places, cases.iter().map(|&s| f64::from(s).rem_euclid(1.0) * 256.0 - 0.5)))
    })?;
    Ok(vec![line])
}

fn q_through_zero() -> Result<Vec<Series>, ProbeError> {
    let mut lines = Vec::new();
    let session = Session::open()?;
    ruler(&session)?;
    for (name, sign) in [("q > 0", 1.0), ("q < 0", -1.0)] {
        lines.push(Series::measured(name, decades(-37..=37), |size| {
            let mut rng = Rng::named("q-through-zero");
            let cases: Vec<[f32; 2]> = (0..1024)
                .map(|_| {
                    let q = (sign * size) as f32 * rng.real(0.5, 1.0);
                    [rng.real(0.0, 1.0) * q, q]
                })
                .collect();
            let inputs: Vec<_> = cases.iter().map(|&[s, q]| of([s, 0.5 * q, 0.0, q])).collect();
            let body = "uniform sampler2D image;
                vec4 value(vec4 a, vec4 b) { return textureProjLod(image, a, 0.0); }";
            let places = session.float_words(body, &inputs)?;
            let u =
                |&[s, q]: &[f32; 2]| (f64::from(s) / f64::from(q)).rem_euclid(1.0) * 256.0 - 0.5;
            Ok(misplaced(&places, cases.iter().map(u)))
        })?);
    }
    Ok(lines)
}

/// A random mipmapped image.
fn image(rng: &mut Rng, size: [usize; 2]) -> Vec<Level> {
    (0..level_count(size))
        .map(|l| {
            let [w, h] = level_size(size, l);
            Level::from_fn(w, h, |_, _| [0; 4].map(|_: u8| rng.byte()))
        })
        .collect()
}

fn stretched() -> Result<Vec<Series>, ProbeError> {
    let size = [256, 256];
    let image = image(&mut Rng::named("anisotropy-sweep"), size);
    let sampler = sampler(TRILINEAR, image.len() - 1);
    let session = Session::open()?;
    session.texture_2d(&image, &sampler)?;
    session.anisotropy(16.0)?;
    let ratios = (0..=24).map(|step| 10f64.powf(f64::from(step) / 4.0));
    let line = Series::measured("largest error", ratios, |ratio| {
        let mut rng = Rng::named("anisotropy-sweep");
        // 3.3 texels wide at first; the length then stays within a few repeats.
        let long = (3.3 * ratio).min(1000.0);
        let cases: Vec<([f32; 2], Derivatives)> = (0..1024)
            .map(|_| {
                let st = [0; 2].map(|_: i32| rng.real(0.0, 1.0));
                let angle = f64::from(rng.real(0.0, 3.1));
                let (sin, cos) = angle.sin_cos();
                let texel = |v: [f64; 2]| v.map(|c| f64::from((c / 256.0) as f32));
                let dx = texel([long * cos, long * sin]);
                let dy = texel([-long / ratio * sin, long / ratio * cos]);
                (st, Derivatives { dx, dy })
            })
            .collect();
        let values = graded(&session, &cases)?;
        let mut compared = Compared::new();
        for ((st, d), value) in cases.iter().zip(values) {
            let footprint = anisotropy::footprint(d, size, 16.0, Variant::CORRECT);
            let st = st.map(f64::from);
            // Not where rounding may decide between a texel and the next. Round footprints have no
            // direction: their rows are those of a bilinear filter, whatever way they lie.
            let step = anisotropy::nearest_step(&image, &sampler, st, &footprint);
            if step > 1e-3 || ratio == 1.0 {
                let exact = anisotropy::sample(&image, &sampler, st, &footprint, Variant::CORRECT);
                compared.add(apart(value, exact), &value);
            } else {
                compared.leave_out();
            }
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}

/// Samples under explicit derivatives.
fn graded(
    session: &Session,
    cases: &[([f32; 2], Derivatives)],
) -> Result<Vec<[f64; 4]>, ProbeError> {
    let inputs: Vec<_> = cases
        .iter()
        .map(|([s, t], d)| {
            let [dx, dy] = [d.dx, d.dy].map(|v| v.map(|c| c as f32));
            [[*s, *t, 0.0, 0.0], [dx[0], dx[1], dy[0], dy[1]]]
        })
        .collect();
    session.float_words(GRAD, &inputs)
}

/// A lookup at `a.xy` with the derivatives `b.xy` and `b.zw`.
pub(super) const GRAD: &str = "uniform sampler2D image;
    vec4 value(vec4 a, vec4 b) { return textureGrad(image, a.xy, b.xy, b.zw); }";

/// The largest difference of two colours.
pub(super) fn apart(value: [f64; 4], exact: [f64; 4]) -> f64 {
    exact.iter().zip(value).map(|(e, v)| Unit::FullScale.error(*e, v)).fold(0.0, f64::max)
}

/// Compares colours.
fn compared(values: &[[f64; 4]], exact: impl Iterator<Item = [f64; 4]>) -> Compared {
    let mut compared = Compared::new();
    for (value, exact) in values.iter().zip(exact) {
        compared.add(apart(*value, exact), value);
    }
    compared
}

fn lambda() -> Result<Vec<Series>, ProbeError> {
    let size = [64, 64];
    let image = image(&mut Rng::named("lambda"), size);
    let sampler = sampler(TRILINEAR, image.len() - 1);
    let session = Session::open()?;
    session.texture_2d(&image, &sampler)?;
    let mut lines = Vec::new();
    let among: Vec<f64> = (-4..=32).map(|step| 2f64.powf(f64::from(step) / 4.0)).collect();
    let beyond: Vec<f64> = decades(-38..=38).collect();
    for (name, sizes) in [("among the levels", among), ("beyond them", beyond)] {
        lines.push(Series::measured(name, sizes, |rho| {
            let mut rng = Rng::named("lambda");
            let cases: Vec<([f32; 2], Derivatives)> = (0..256)
                .map(|_| {
                    let st = [0; 2].map(|_: i32| rng.real(0.0, 1.0));
                    let reach = rho / 64.0;
                    let mut part = || f64::from((f64::from(rng.real(-1.0, 1.0)) * reach) as f32);
                    (st, Derivatives { dx: [part(), part()], dy: [part(), part()] })
                })
                .collect();
            let values = graded(&session, &cases)?;
            let exact = cases.iter().map(|(st, d)| {
                sample::sample(&image, &sampler, st.map(f64::from), d, Variant::CORRECT)
            });
            Ok(compared(&values, exact))
        })?);
    }
    Ok(lines)
}

fn cube_edge() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("cube-edge");
    let faces: Vec<Level> =
        (0..6).map(|_| Level::from_fn(16, 16, |_, _| [0; 4].map(|_: u8| rng.byte()))).collect();
    let sampler = sampler(Filters::only(Filter::Linear), 0);
    let session = Session::open()?;
    session.seamless_cubes()?;
    session.texture_cube(&faces, &sampler)?;
    let angles = (1..=16).map(|step| 10f64.powf(-f64::from(step) / 2.0));
    let line = Series::measured("largest error", angles, |angle| {
        let mut rng = Rng::named("cube-edge");
        let cases: Vec<[f32; 3]> = (0..1024)
            .map(|_| {
                let side = rng.pick(&[-1.0, 1.0]);
                let mut r = [1.0, 1.0 + side * angle, f64::from(rng.real(-0.9, 0.9))]
                    .map(|c| (c * f64::from(rng.pick(&[-1.0f32, 1.0]))) as f32);
                r.rotate_left(rng.integer(0, 2) as usize);
                r
            })
            .collect();
        let inputs: Vec<_> = cases.iter().map(|&[x, y, z]| of([x, y, z, 0.0])).collect();
        let body = "uniform samplerCube image;
            vec4 value(vec4 a, vec4 b) { return textureLod(image, a.xyz, 0.0); }";
        let values = session.float_words(body, &inputs)?;
        let exact =
            cases.iter().map(|r| seamless::linear(&faces, r.map(f64::from), Variant::CORRECT));
        Ok(compared(&values, exact))
    })?;
    Ok(vec![line])
}

fn denormals() -> Result<Vec<Series>, ProbeError> {
    let texels: Vec<[f32; 4]> =
        (0..150).map(|k| [2f64.powi(-k) as f32, -(2f64.powi(-k)) as f32, 0.0, 0.0]).collect();
    let session = Session::open()?;
    session.texel_row(&TexelRow { internal: GL_RGBA32F, is_depth: false, texels: &texels })?;
    let count = texels.len() as f32;
    let inputs: Vec<_> = (0..texels.len())
        .map(|i| [[(i as f32 + 0.5) / count, 0.5, 0.0, 0.0], [0.0; 4], [0.0; 4]])
        .collect();
    let values = session.field(shader::TEXTURE_2D, 2, &inputs)?;
    // The same through a varying of a cell.
    let program = session.program(shader::INPUT, Precision::Exact { components: 2 })?;
    let cells: Vec<_> = texels.iter().map(|&texel| [texel, [0.0; 4], [0.0; 4]]).collect();
    let varyings = session.cells(&program, &cells)?;
    let line = |name: &str, values: &[[f64; 4]]| {
        let point = |(texel, value): (&[f32; 4], &[f64; 4])| {
            let of = |c: usize| Unit::Ulp.error(texel[c].into(), value[c]);
            let mut compared = Compared::new();
            compared.add(of(0).max(of(1)), &value[..2]);
            compared.at(texel[0].into())
        };
        Series { name: name.to_owned(), points: texels.iter().zip(values).map(point).collect() }
    };
    Ok(vec![line("a texel", &values), line("a varying", &varyings)])
}
