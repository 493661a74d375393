//! Texture coordinates, footprints and levels at their extremes.

use super::definition::{Sweep, decades};
use crate::check::Unit;
use crate::mutation::Variant;
use crate::oracle::anisotropy;
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{Derivatives, Filter, Filters, LevelRange, LodState, Mipmap};
use crate::oracle::sample::{self, Sampler};
use crate::oracle::seamless;
use crate::oracle::texture::{Level, level_count, level_size};
use crate::oracle::wrap::Wrap;
use crate::plot::Line;
use crate::probe::{Precision, ProbeError, Session, TexelRow, shader};
use crate::rng::Rng;
use gl_api::constants::*;

/// Coordinates far outside of [0, 1].
pub const REPEAT: Sweep = Sweep {
    name: "far-coordinates",
    what: "place that GL_REPEAT reads of 256 texels, of coordinates up to this size, either sign",
    parameter: "size of s",
    unit: "texels",
    bound: 1.0 / (1 << 14) as f64,
    why: "s - floor(s) is exact in f32 and so is the product with 256; the filter's weight 2^-16",
    before: &[],
    run: repeat,
};

/// Projective coordinates.
pub const Q_THROUGH_ZERO: Sweep = Sweep {
    name: "q-through-zero",
    what: "place that texture2DProj reads of 256 texels, of (s·q, t·q, q) with q of either sign",
    parameter: "size of q",
    unit: "texels",
    bound: 1.0 / (1 << 13) as f64,
    why: "one division: s/q to 2^-24, times 256 texels, whatever q that is no denormal",
    before: &[],
    run: q_through_zero,
};

/// Stretched footprints.
pub const ANISOTROPY: Sweep = Sweep {
    name: "anisotropy",
    what: "a footprint this many times as long as wide, of which 16 times count, against the formula",
    parameter: "σ₁/σ₂",
    unit: "of range",
    bound: 1.0 / (1 << 12) as f64,
    why: "beyond 16 the width is σ₁/16, which no cancellation touches",
    before: &[],
    run: stretched,
};

/// Levels of detail.
pub const LAMBDA: Sweep = Sweep {
    name: "lambda",
    what: "trilinear sample under explicit derivatives of this size, against the formula",
    parameter: "ρ in texels",
    unit: "of range",
    bound: 1.0 / (1 << 16) as f64,
    why: "the square of ρ leaves the range of f32 beyond 2^±63, where λ is clamped to a level anyway",
    before: &[],
    run: lambda,
};

/// Cube edges.
pub const CUBE_EDGE: Sweep = Sweep {
    name: "cube-edge",
    what: "seamless bilinear sample at this angle on either side of an edge",
    parameter: "radians from the edge",
    unit: "of range",
    bound: 1.0 / (1 << 17) as f64,
    why: "both faces have the same two texels at their common edge",
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

/// The largest distance in texels of a sample from its expected coordinate, without samples at the seam of the
/// repeated row.
fn misplaced(places: &[[f64; 4]], expected: impl Iterator<Item = f64>) -> f64 {
    places
        .iter()
        .zip(expected)
        .filter(|(_, u)| (0.5..254.5).contains(u))
        .map(|(place, u)| {
            let error = (place[0] - u).abs();
            if error.is_nan() { f64::INFINITY } else { error }
        })
        .fold(0.0, f64::max)
}

fn repeat() -> Result<Vec<Line>, ProbeError> {
    let mut rng = Rng::named("far-coordinates");
    let line = decades("largest misplacement", 0..=9, |size| {
        let cases: Vec<f32> = (0..4096).map(|_| rng.real(-size, size)).collect();
        let session = Session::open()?;
        ruler(&session)?;
        let inputs: Vec<_> =
            cases.iter().map(|&s| [[s, 0.5, 0.0, 0.0], [0.0; 4], [0.0; 4]]).collect();
        let body = "uniform sampler2D image; vec4 value() { return texture2D(image, a.xy); }";
        let places = session.field(body, 1, &inputs)?;
        Ok(misplaced(&places, cases.iter().map(|&s| f64::from(s).rem_euclid(1.0) * 256.0 - 0.5)))
    })?;
    Ok(vec![line])
}

fn q_through_zero() -> Result<Vec<Line>, ProbeError> {
    let mut rng = Rng::named("q-through-zero");
    let mut lines = Vec::new();
    for (name, sign) in [("q > 0", 1.0), ("q < 0", -1.0)] {
        lines.push(decades(name, -35..=35, |size| {
            let cases: Vec<[f32; 2]> = (0..1024)
                .map(|_| {
                    let q = (sign * size) as f32 * rng.real(0.5, 1.0);
                    [rng.real(0.0, 1.0) * q, q]
                })
                .collect();
            let session = Session::open()?;
            ruler(&session)?;
            let inputs: Vec<_> =
                cases.iter().map(|&[s, q]| [[s, 0.5 * q, 0.0, q], [0.0; 4], [0.0; 4]]).collect();
            let places = session.field(shader::TEXTURE_2D_PROJ, 1, &inputs)?;
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

fn stretched() -> Result<Vec<Line>, ProbeError> {
    let mut rng = Rng::named("anisotropy-sweep");
    let size = [256, 256];
    let image = image(&mut rng, size);
    let sampler = sampler(TRILINEAR, image.len() - 1);
    let line = decades("largest error", 0..=6, |ratio| {
        // 3.3 texels wide at first; the length then stays within a few repeats.
        let long = (3.3 * ratio).min(1000.0);
        let exactly = |(st, d): &([f32; 2], Derivatives)| {
            let footprint = anisotropy::footprint(d, size, 16.0, Variant::CORRECT);
            (st.map(f64::from), footprint)
        };
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
            .filter(|case| {
                // Not where rounding may decide between a texel and the next.
                let (st, footprint) = exactly(case);
                anisotropy::nearest_step(&image, &sampler, st, &footprint) > 1e-3
            })
            .collect();
        let session = Session::open()?;
        session.texture_2d(&image, &sampler)?;
        session.anisotropy(16.0)?;
        let values = graded(&session, &cases)?;
        let exact = cases.iter().map(|case| {
            let (st, footprint) = exactly(case);
            anisotropy::sample(&image, &sampler, st, &footprint, Variant::CORRECT)
        });
        Ok(largest(&values, exact))
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
            [[*s, *t, 0.0, 0.0], [dx[0], dx[1], dy[0], dy[1]], [0.0; 4]]
        })
        .collect();
    let body = "uniform sampler2D image;
                vec4 value() { return texture2DGradARB(image, a.xy, b.xy, b.zw); }";
    session.field(body, 4, &inputs)
}

fn largest(values: &[[f64; 4]], exact: impl Iterator<Item = [f64; 4]>) -> f64 {
    let errors = values
        .iter()
        .zip(exact)
        .flat_map(|(a, b)| [0, 1, 2, 3].map(|c: usize| Unit::FullScale.error(b[c], a[c])));
    errors.fold(0.0, f64::max)
}

fn lambda() -> Result<Vec<Line>, ProbeError> {
    let mut rng = Rng::named("lambda");
    let size = [64, 64];
    let image = image(&mut rng, size);
    let sampler = sampler(TRILINEAR, image.len() - 1);
    let line = decades("largest error", -36..=36, |rho| {
        let cases: Vec<([f32; 2], Derivatives)> = (0..256)
            .map(|_| {
                let st = [0; 2].map(|_: i32| rng.real(0.0, 1.0));
                let reach = rho / 64.0;
                let mut part = || f64::from((f64::from(rng.real(-1.0, 1.0)) * reach) as f32);
                (st, Derivatives { dx: [part(), part()], dy: [part(), part()] })
            })
            .collect();
        let session = Session::open()?;
        session.texture_2d(&image, &sampler)?;
        let values = graded(&session, &cases)?;
        let exact = cases.iter().map(|(st, d)| {
            sample::sample(&image, &sampler, st.map(f64::from), d, Variant::CORRECT)
        });
        Ok(largest(&values, exact))
    })?;
    Ok(vec![line])
}

fn cube_edge() -> Result<Vec<Line>, ProbeError> {
    let mut rng = Rng::named("cube-edge");
    let faces: Vec<Level> =
        (0..6).map(|_| Level::from_fn(16, 16, |_, _| [0; 4].map(|_: u8| rng.byte()))).collect();
    let sampler = sampler(Filters::only(Filter::Linear), 0);
    let line = decades("largest error", -7..=-1, |angle| {
        let cases: Vec<[f32; 3]> = (0..1024)
            .map(|_| {
                let side = rng.pick(&[-1.0, 1.0]);
                let mut r = [1.0, 1.0 + side * angle, f64::from(rng.real(-0.9, 0.9))]
                    .map(|c| (c * f64::from(rng.pick(&[-1.0f32, 1.0]))) as f32);
                r.rotate_left(rng.integer(0, 2) as usize);
                r
            })
            .collect();
        let session = Session::open()?;
        session.seamless_cubes()?;
        session.texture_cube(&faces, &sampler)?;
        let inputs: Vec<_> =
            cases.iter().map(|&[x, y, z]| [[x, y, z, 0.0], [0.0; 4], [0.0; 4]]).collect();
        let values = session.field(shader::TEXTURE_CUBE, 4, &inputs)?;
        let exact =
            cases.iter().map(|r| seamless::linear(&faces, r.map(f64::from), Variant::CORRECT));
        Ok(largest(&values, exact))
    })?;
    Ok(vec![line])
}

fn denormals() -> Result<Vec<Line>, ProbeError> {
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
        let error = |(texel, value): (&[f32; 4], &[f64; 4])| {
            let of = |c: usize| Unit::Ulp.error(texel[c].into(), value[c]);
            (f64::from(texel[0]), of(0).max(of(1)))
        };
        Line { name: name.to_owned(), points: texels.iter().zip(values).map(error).collect() }
    };
    Ok(vec![line("a texel", &values), line("a varying", &varyings)])
}
