//! The fixed vertex stage: generated coordinates and lit colours.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::{
    glLoadIdentity, glLoadMatrixf, glMatrixMode, glNormal3f, glTexCoord4f, glVertex4f,
};
use crate::mutation::{Mutation, Variant};
use crate::oracle::matrix;
use crate::oracle::vertex::{self, Light, Surface, TexGen};
use crate::probe::{GlTexGen, ProbeError};
use crate::rng::Rng;
use gl_api::constants::*;

/// Texture coordinate generation.
pub const TEXGEN: Check = Check {
    name: "texgen",
    citation: "GL 2.1, 2.11.3, 2.11.4 and 2.11.2",
    what: "the five generation modes and the texture matrix under random model-view matrices",
    unit: Unit::FullScale,
    tolerance: 80.0 / (1 << 24) as f64,
    why: "f32: coordinates up to 32: half an ulp is 16 · 2^-24; products of four terms with an inverse matrix: four of them",
    run: texgen,
};

/// Lighting.
pub const LIGHTING: Check = Check {
    name: "lighting",
    citation: "GL 2.1, 2.14.1: the lighting equation",
    what: "random materials under 1 to 3 infinite, local and spot lights, local viewer or not",
    unit: Unit::FullScale,
    tolerance: 2.0 / (1 << 20) as f64,
    why: "f32: cosines to 2^-24, raised to powers up to 32: 2^-19 of a term; random signs halve it",
    run: lighting,
};

/// A vertex: object coordinates and normal.
pub(super) type Case = ([f32; 3], [f32; 3]);

/// A model-view matrix of a rotation, moderate scales and a translation away from the eye.
pub(super) fn model_view(rng: &mut Rng) -> [f32; 16] {
    let mut m = [0.0f32; 16];
    for column in 0..3 {
        for row in 0..3 {
            let diagonal = if row == column { 1.5 } else { 0.0 };
            m[4 * column + row] = diagonal + rng.real(-0.5, 0.5);
        }
        m[12 + column] = rng.real(-1.0, 1.0);
    }
    m[14] -= 6.0;
    m[15] = 1.0;
    m
}

pub(super) fn cases(rng: &mut Rng, count: usize) -> Vec<Case> {
    (0..count)
        .map(|_| {
            let mut vector = |reach: f64| [0; 3].map(|_: i32| rng.real(-reach, reach));
            let position = vector(2.0);
            let normal = loop {
                let n = vector(1.0);
                if n.iter().map(|c| c * c).sum::<f32>() > 0.2 {
                    break n;
                }
            };
            (position, normal)
        })
        .collect()
}

pub(super) fn draw((position, normal): Case) {
    let [x, y, z] = normal;
    glNormal3f(x, y, z);
    let [x, y, z] = position;
    glVertex4f(x, y, z, 1);
}

pub(super) fn eye(
    model_view: &[f32; 16],
    (position, normal): &Case,
    variant: Variant,
) -> vertex::Eye {
    let [x, y, z] = position.map(f64::from);
    let m = matrix::from_columns(model_view);
    vertex::eye(&m, [x, y, z, 1.0], normal.map(f64::from), variant)
}

fn texgen(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("texgen");
    let modes = [GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_REFLECTION_MAP, GL_NORMAL_MAP];
    for mode in modes {
        let planes = [0; 4].map(|_: i32| [0; 4].map(|_: i32| rng.real(-1.0, 1.0)));
        let exact = planes.map(|plane| plane.map(f64::from));
        let (given_under, m, texture) =
            (model_view(&mut rng), model_view(&mut rng), model_view(&mut rng));
        let (generated, coordinates, planes) = match mode {
            GL_OBJECT_LINEAR => (TexGen::ObjectLinear(exact), 4, Some((GL_OBJECT_PLANE, planes))),
            GL_EYE_LINEAR => {
                let under = matrix::from_columns(&given_under);
                (TexGen::EyeLinear(exact, under), 4, Some((GL_EYE_PLANE, planes)))
            }
            GL_SPHERE_MAP => (TexGen::SphereMap, 2, None),
            GL_REFLECTION_MAP => (TexGen::ReflectionMap, 3, None),
            _ => (TexGen::NormalMap, 3, None),
        };
        let cases = cases(&mut rng, harness.cases(1024));
        let given = [0.1, 0.2, 0.3, 1.0f32];
        let expect = |case: &Case, variant: Variant| {
            let vertex = eye(&m, case, variant);
            let c = generated.coordinates(&vertex, given.map(f64::from), variant);
            if variant.has(Mutation::TextureMatrixIgnored) {
                c
            } else {
                matrix::apply(&matrix::from_columns(&texture), c)
            }
        };
        let gl = GlTexGen { mode, coordinates, planes };
        harness.compare(tally, &enum_name(mode), &cases, expect, |session| {
            session.float_target()?;
            session.show_coordinates()?;
            glLoadMatrixf(&given_under);
            session.texgen(&gl)?;
            glMatrixMode(GL_TEXTURE);
            glLoadMatrixf(&texture);
            glMatrixMode(GL_MODELVIEW);
            glLoadMatrixf(&m);
            let [s, t, r, q] = given;
            let point = |k: usize| {
                glTexCoord4f(s, t, r, q);
                draw(cases[k]);
            };
            session.points(cases.len(), point)
        })?;
    }
    Ok(())
}

fn lighting(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("lighting");
    for round in 0..harness.cases(64).max(6) {
        let lights: Vec<Light> = (0..=round % 3).map(|_| light(&mut rng)).collect();
        let surface = surface(&mut rng);
        let m = model_view(&mut rng);
        let mut cases = cases(&mut rng, 128);
        // Without lights at grazing angles or at the edge of a spot, where the formula jumps.
        cases.retain(|case| {
            let v = eye(&m, case, Variant::CORRECT);
            lights.iter().all(|light| !on_edge(light, &v))
        });
        let expect = |case: &Case, variant: Variant| {
            vertex::light(&eye(&m, case, variant), &lights, &surface, variant)
        };
        harness.compare(tally, &(&lights, surface), &cases, expect, |session| {
            session.float_target()?;
            glLoadIdentity();
            session.lighting(&lights, &surface)?;
            glLoadMatrixf(&m);
            session.points(cases.len(), |k| draw(cases[k]))
        })?;
    }
    Ok(())
}

pub(super) fn on_edge(light: &Light, v: &vertex::Eye) -> bool {
    let to: [f64; 3] =
        std::array::from_fn(|c| light.position[c] - light.position[3] * v.position[c]);
    let length = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
    let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let facing = dot(v.normal, to) / length(to);
    let cosine = -dot(to, light.spot_direction) / (length(to) * length(light.spot_direction));
    let cutoff = light.spot_cutoff.to_radians().cos();
    facing.abs() < 1e-3 || (light.spot_cutoff < 180.0 && (cosine - cutoff).abs() < 1e-3)
}

/// Numbers that are exact in `f32`.
pub(super) fn numbers<const N: usize>(rng: &mut Rng, low: f64, high: f64) -> [f64; N] {
    std::array::from_fn(|_| f64::from(rng.dyadic(low, high, 1.0 / 256.0)))
}

pub(super) fn light(rng: &mut Rng) -> Light {
    let [x, y, z]: [f64; 3] = numbers(rng, -4.0, 4.0);
    let is_local = rng.integer(0, 2) > 0;
    let is_spot = is_local && rng.integer(0, 1) == 1;
    Light {
        ambient: numbers(rng, 0.0, 0.2),
        diffuse: numbers(rng, 0.0, 0.6),
        specular: numbers(rng, 0.0, 0.5),
        position: [x, y, z + 0.5, f64::from(u8::from(is_local))],
        spot_direction: [-x * 0.25, -y * 0.25, -4.0],
        spot_exponent: if is_spot { numbers::<1>(rng, 0.0, 8.0)[0] } else { 0.0 },
        spot_cutoff: if is_spot { numbers::<1>(rng, 20.0, 90.0)[0] } else { 180.0 },
        attenuation: [1.0, 0.125, 0.03125],
    }
}

pub(super) fn surface(rng: &mut Rng) -> Surface {
    Surface {
        ambient: numbers(rng, 0.0, 1.0),
        diffuse: numbers(rng, 0.0, 1.0),
        specular: numbers(rng, 0.0, 1.0),
        emission: numbers(rng, 0.0, 0.2),
        shininess: numbers::<1>(rng, 0.0, 32.0)[0],
        scene_ambient: numbers(rng, 0.0, 0.3),
        local_viewer: rng.integer(0, 1) == 1,
    }
}
