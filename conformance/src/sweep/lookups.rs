//! Lookups with coordinates at their extremes: directions into cubes, many repeats, texture
//! matrices, texels that are infinite.

use super::definition::Sweep;
use super::drawn::float_texture;
use super::series::{Compared, Series, decades, octaves};
use super::shaded::{Inputs, of, shaded_in, three};
use super::texture::apart;
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::cube;
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{Filter, Filters, LevelRange, LodState};
use crate::oracle::sample::Sampler;
use crate::oracle::texture::Level;
use crate::oracle::wrap::Wrap;
use crate::probe::{ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;

/// Directions of all lengths.
pub const CUBE_DIRECTIONS: Sweep = Sweep {
    name: "cube-directions",
    what: "the texel that a direction of this length reads of a cube map of faces of 8×8",
    parameter: "length of the direction",
    unit: "of range",
    bound: 0.0,
    why: "a division by the major axis: the length takes no part",
    breaks: "below 1e-38 the coordinates of the direction are denormals and lose bits themselves; the \
             texel is that of the direction that is left",
    kept: 0.5,
    distinct: 0.05,
    before: &[],
    run: cube_directions,
};

/// Directions between faces.
pub const CUBE_TIES: Sweep = Sweep {
    name: "cube-ties",
    what: "the texel of directions that lie this far from the plane between two faces",
    parameter: "difference of the two largest coordinates, as part of them",
    unit: "of range",
    bound: 0.0,
    why: "faces are chosen by comparing floats, which is exact",
    breaks: "below 6e-8 the coordinates are equal: GL leaves the face open, here x goes before y and y \
             before z",
    kept: 0.9,
    distinct: 0.1,
    before: &[],
    run: cube_ties,
};

/// Many repeats.
pub const REPEATS: Sweep = Sweep {
    name: "many-repeats",
    what: "how far, in texels, the texel that GL_NEAREST reads lies from the place of s, in rows of \
           1, 2, 8191 and 8192 texels, repeated and mirrored",
    parameter: "size of s · width, in texels",
    unit: "texels",
    bound: 1.0 / (1 << 12) as f64,
    why: "s - floor(s) is exact, its product with the width is rounded: 8192·2^-24 of a texel",
    breaks: "from 2^24 texels on s has no bits for a texel: the one that is read is that of the \
             float that was given",
    kept: 1.0,
    distinct: 0.0,
    before: &[],
    run: repeats,
};

/// Large and nearly singular texture matrices.
pub const TEXTURE_MATRIX: Sweep = Sweep {
    name: "texture-matrix",
    what: "texture coordinates by a matrix that scales by k, and by one that scales by k along one \
           diagonal alone",
    parameter: "k",
    unit: "of the largest term's 2^-24",
    bound: 4.0,
    why: "four products and three sums, each rounded; terms that cancel leave the largest one's rounding",
    breaks: "where terms cancel, along the other diagonal, what is left is rounding from k = 1e7 on",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: texture_matrix,
};

/// Infinite texels.
pub const INFINITE_TEXEL: Sweep = Sweep {
    name: "infinite-texel",
    what: "GL_LINEAR beside a texel that is infinite or NaN, this far from the finite texel's \
           centre: 1 for what is neither the finite texel nor infinite (NaN)",
    parameter: "distance from the centre, in texels",
    unit: "wrong values",
    bound: 0.0,
    why: "a texel of weight 0 takes no part, whatever it is",
    breaks: "weights below 2^-24 are 0; any other weight of an infinite texel gives an infinite sample",
    kept: 1.0,
    distinct: 0.1,
    before: &[],
    run: infinite_texel,
};

const SIDE: usize = 8;

/// A cube whose texels are all different.
fn cube(session: &Session) -> Result<Vec<Level>, ProbeError> {
    let faces: Vec<Level> = (0..6u8)
        .map(|face| Level::from_fn(SIDE, SIDE, |i, j| [40 * face, i as u8 * 30, j as u8 * 30, 255]))
        .collect();
    let sampler = Sampler {
        at: Addressing { wrap: [Wrap::ClampToEdge; 2], border: [0.0; 4] },
        filters: Filters::only(Filter::Nearest),
        lod: LodState::default(),
        range: LevelRange { base: 0, last: 0 },
    };
    session.texture_cube(&faces, &sampler)?;
    Ok(faces)
}

const CUBE: &str = "uniform samplerCube image;
    vec4 value(vec4 a, vec4 b) { return texture(image, a.xyz); }";

/// The error of a direction's texel; `None` near the boundary of two texels.
fn cube_error(faces: &[Level], [a, _]: &Inputs, value: [f64; 4]) -> Option<f64> {
    let r = three(*a);
    if r.iter().all(|&c| c == 0.0) {
        return None;
    }
    let (face, st) = cube::select(r, Variant::CORRECT);
    let place = st.map(|c| c * SIDE as f64);
    let inner = |p: f64| (0.5..SIDE as f64 - 0.5).contains(&p);
    if place.iter().any(|&p| inner(p) && (p - p.round()).abs() < 1e-5) {
        return None;
    }
    let [i, j] = place.map(|p| (p.floor() as usize).min(SIDE - 1));
    let number = cube::Face::ALL.iter().position(|&one| one == face)?;
    // What is stored is the nearest float.
    Some(apart(value, faces[number].texel(i, j).map(|c| f64::from(c as f32))))
}

fn cube_directions() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    let faces = cube(&session)?;
    let sizes = decades(-44..=38).chain([3.4e38]);
    let mut rng = Rng::named("cube-directions");
    let case = |size: f64| {
        let mut part = || (f64::from(rng.real(-1.0, 1.0)) * size) as f32;
        of([part(), part(), part(), 0.0])
    };
    let line = shaded_in(&session, "largest error", sizes, CUBE, case, |inputs, value| {
        cube_error(&faces, inputs, value)
    })?;
    Ok(vec![line])
}

fn cube_ties() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    let faces = cube(&session)?;
    let distances = (1..=20).map(|step| 10f64.powf(-f64::from(step) / 2.0));
    let mut rng = Rng::named("cube-ties");
    let case = |distance: f64| {
        let sign = [0; 3].map(|_: i32| rng.pick(&[-1.0, 1.0]));
        let other = 1.0 + distance * f64::from(rng.pick(&[-1.0f32, 0.0, 1.0]));
        let mut r = [1.0, other, f64::from(rng.real(0.0, 0.9))];
        r.rotate_left(rng.integer(0, 2) as usize);
        let [x, y, z] = [0, 1, 2].map(|c| (r[c] * sign[c]) as f32);
        of([x, y, z, 0.0])
    };
    let line = shaded_in(&session, "largest error", distances, CUBE, case, |inputs, value| {
        cube_error(&faces, inputs, value)
    })?;
    Ok(vec![line])
}

fn repeats() -> Result<Vec<Series>, ProbeError> {
    let mut lines = Vec::new();
    for width in [1usize, 2, 8191, 8192] {
        for (mode, name) in [(GL_REPEAT, "repeated"), (GL_MIRRORED_REPEAT, "mirrored")] {
            let session = Session::open()?;
            let texels: Vec<[f32; 4]> = (0..width).map(|i| [i as f32, 0.0, 0.0, 1.0]).collect();
            float_texture(&session, GL_RGBA32F, [width, 1], &texels)?;
            session.parameters(&[(GL_TEXTURE_WRAP_S, mode)])?;
            let mut rng = Rng::named("many-repeats");
            let n = width as f64;
            let case = |size: f64| of([rng.real(-size / n, size / n), 0.5, 0.0, 0.0]);
            let body = "uniform sampler2D image;
                vec4 value(vec4 a, vec4 b) { return texture(image, a.xy); }";
            let name = format!("{width}, {name}");
            let sizes = octaves(0..=30, 1);
            lines.push(shaded_in(&session, &name, sizes, body, case, |[a, _], value| {
                let s = f64::from(a[0]);
                let place = match mode {
                    GL_REPEAT => s.rem_euclid(1.0) * n,
                    _ => (1.0 - (s.rem_euclid(2.0) - 1.0).abs()) * n,
                };
                // From the texel's nearer edge; over the seam too.
                let apart = |texel: f64| (texel - place).max(place - texel - 1.0).max(0.0);
                let over = [value[0] - n, value[0], value[0] + n].map(apart);
                Some(over.into_iter().fold(f64::INFINITY, f64::min))
            })?);
        }
    }
    Ok(lines)
}

fn texture_matrix() -> Result<Vec<Series>, ProbeError> {
    const COUNT: usize = 256;
    let mut lines = Vec::new();
    for (name, turn) in [("scale", 0.0f64), ("along a diagonal", 45.0)] {
        let session = Session::open()?;
        session.float_target()?;
        session.show_coordinates()?;
        lines.push(Series::measured(name, decades(-8..=8), |k| {
            let mut rng = Rng::named("texture-matrix");
            let (sin, cos) = turn.to_radians().sin_cos();
            // The rotation, the scale of its x axis by k, and the rotation back; then a translation.
            let cell = |i: usize, j: usize| {
                let r = [[cos, -sin], [sin, cos]];
                r[i][0] * k * r[j][0] + r[i][1] * r[j][1]
            };
            let mut matrix = [0.0f32; 16];
            for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                matrix[4 * j + i] = cell(i, j) as f32;
            }
            (matrix[10], matrix[15]) = (1.0, 1.0);
            (matrix[12], matrix[13]) = (0.25, -0.5);
            glMatrixMode(GL_TEXTURE);
            glLoadMatrixf(&matrix);
            let cases: Vec<[f32; 2]> =
                (0..COUNT).map(|_| [0; 2].map(|_: i32| rng.real(-1.0, 1.0))).collect();
            let values = session.points(COUNT, |number| {
                let [s, t] = cases[number];
                glTexCoord2f(s, t);
                glVertex2f(0, 0);
            })?;
            let mut compared = Compared::new();
            for (case, value) in cases.iter().zip(values) {
                let mut error: f64 = 0.0;
                for i in 0..2 {
                    let terms = [0, 1]
                        .map(|j: usize| f64::from(matrix[4 * j + i]) * f64::from(case[j]))
                        .into_iter()
                        .chain([f64::from(matrix[12 + i])]);
                    let exact: f64 = terms.clone().sum();
                    let largest = terms.map(f64::abs).fold(0.0, f64::max);
                    error = error.max((value[i] - exact).abs() / (largest * 2f64.powi(-24)));
                }
                compared.add(error, &value[..2]);
            }
            Ok(compared)
        })?);
    }
    Ok(lines)
}

fn infinite_texel() -> Result<Vec<Series>, ProbeError> {
    let mut lines = Vec::new();
    for (name, bad) in [("infinite", f32::INFINITY), ("NaN", f32::NAN)] {
        let session = Session::open()?;
        let texels: Vec<[f32; 4]> =
            (0..16).map(|i| [if i % 2 == 0 { 0.5 } else { bad }, 0.0, 0.0, 1.0]).collect();
        float_texture(&session, GL_RGBA32F, [16, 1], &texels)?;
        session.parameters(&[
            (GL_TEXTURE_MIN_FILTER, GL_LINEAR),
            (GL_TEXTURE_MAG_FILTER, GL_LINEAR),
            (GL_TEXTURE_WRAP_S, GL_REPEAT),
        ])?;
        let mut rng = Rng::named(name);
        let body = "uniform sampler2D image;
            vec4 value(vec4 a, vec4 b) { return textureLod(image, a.xy, 0.0); }";
        let case = |distance: f64| {
            let middle = 2.0 * rng.integer(1, 6) as f64 + 0.5;
            let side = f64::from(rng.pick(&[-1.0f32, 1.0]));
            of([((middle + side * distance) / 16.0) as f32, 0.5, 0.0, 0.0])
        };
        let distances = octaves(-30..=-1, 1);
        lines.push(shaded_in(&session, name, distances, body, case, |[a, _], value| {
            let at_centre = (f64::from(a[0]) * 16.0).fract() == 0.5;
            let finite = value[0] == 0.5;
            // NaN beside NaN is right, but not where it has no weight.
            let is_bad = if bad.is_nan() { value[0].is_nan() } else { value[0].is_infinite() };
            Some(if finite || (is_bad && !at_centre) { 0.0 } else { 1.0 })
        })?);
    }
    Ok(lines)
}
