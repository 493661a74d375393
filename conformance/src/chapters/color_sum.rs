//! Sums and clamps of vertex colours, and fog by depth.

use super::pictures::{Pictures, Pixel, window};
use super::shading::one_texel;
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::combine::Fog;
use crate::oracle::painter::inside;
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// The sum of two colours.
pub const COLOR_SUM: Check = Check {
    name: "color-sum",
    citation: "GL 2.1, 3.9: c = c_pri + c_sec, clamped; GL_COLOR_SUM",
    what: "random primary and secondary colours, with a texture between them and without",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 23) as f64,
    why: "f32: a product and a sum up to 1, 2^-24 each",
    run: color_sum,
};

/// Clamped colours.
pub const CLAMPED: Check = Check {
    name: "vertex-color-clamp",
    citation: "GL 2.1, 2.14.6: colours are clamped to [0, 1] before they are interpolated",
    what: "every pixel of triangles whose corners have colours from -1 to 2",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 22) as f64,
    why: "f32: a plane over 61 pixels whose slope is rounded by 2^-30, and three roundings of 2^-25",
    run: clamped,
};

/// Fog by depth.
pub const FOG_DEPTH: Check = Check {
    name: "fog-depth",
    citation: "GL 2.1, 3.10: c = |z_e|, of the three modes",
    what: "every pixel of a floor in perspective in fog, from the eye into the distance",
    unit: Unit::FullScale,
    tolerance: 1.5 / (1 << 22) as f64,
    why: "f32: an eye depth to 2^-24 of itself, in an exponent of up to 5, and roundings of the mix",
    run: fog_depth,
};

const PICTURE: Pixel = [61, 43];

fn color_sum(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("color-sum");
    for round in 0..4usize {
        let texel = if round % 2 == 0 { [1.0; 4] } else { [0; 4].map(|_: i32| rng.real(0.0, 1.0)) };
        let sums = round < 3;
        let cases: Vec<[[f32; 4]; 2]> = (0..harness.cases(1024))
            .map(|_| [0; 2].map(|_: i32| [0; 4].map(|_: i32| rng.real(0.0, 1.0))))
            .collect();
        let expect = |[primary, secondary]: &[[f32; 4]; 2], variant: Variant| {
            let sum = |i: usize| {
                let [p, s, t] = [primary[i], secondary[i], texel[i]].map(f64::from);
                if !sums {
                    p * t
                } else if variant.has(Mutation::SumBeforeTexture) {
                    ((p + s) * t).clamp(0.0, 1.0)
                } else {
                    (p * t + s).clamp(0.0, 1.0)
                }
            };
            [sum(0), sum(1), sum(2), f64::from(primary[3]) * f64::from(texel[3])]
        };
        harness.compare(tally, &(texel, sums), &cases, expect, |session| {
            session.float_target()?;
            glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_TRUE);
            if round % 2 == 1 {
                one_texel(texel);
            }
            if sums {
                glEnable(GL_COLOR_SUM);
            }
            session.points(cases.len(), |k| {
                let [[r, g, b, a], [sr, sg, sb, _]] = cases[k];
                glColor4f(r, g, b, a);
                glSecondaryColor3f(sr, sg, sb);
                glVertex4f(0, 0, 0, 1);
            })
        })?;
    }
    Ok(())
}

/// The weights of three corners at a place.
fn weights([a, b, c]: [[f64; 2]; 3], [x, y]: [f64; 2]) -> [f64; 3] {
    let area = |p: [f64; 2], q: [f64; 2]| (p[0] - x) * (q[1] - y) - (q[0] - x) * (p[1] - y);
    let of = [area(b, c), area(c, a), area(a, b)];
    let total: f64 = of.iter().sum();
    of.map(|w| w / total)
}

fn clamped(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("vertex-color-clamp");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(32).max(4) {
        let mut place = |low: [i64; 2]| {
            [0, 1].map(|i| (low[i] * 256 + rng.integer(0, 15 * 256)) as f64 / 256.0)
        };
        // Far from one another.
        let corners = [place([0, 0]), place([46, 2]), place([20, 28])];
        let colors = [0; 3].map(|_: i32| [0; 4].map(|_: i32| rng.real(-1.0, 2.0)));
        let expect = |[x, y]: Pixel, variant: Variant| {
            let at = [x as f64 + 0.5, y as f64 + 0.5];
            if !inside(corners, at)? {
                return Some([0.0; 4]);
            }
            let weights = weights(corners, at);
            Some(std::array::from_fn(|i| {
                let of = |k: usize| {
                    let c = f64::from(colors[k][i]);
                    if variant.has(Mutation::ClampedLast) { c } else { c.clamp(0.0, 1.0) }
                };
                (0..3).map(|k| weights[k] * of(k)).sum::<f64>().clamp(0.0, 1.0)
            }))
        };
        pictures.compare(&(corners, colors), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            glBegin(GL_TRIANGLES);
            for ([r, g, b, a], [x, y]) in colors.into_iter().zip(corners) {
                glColor4f(r, g, b, a);
                glVertex2f(x as f32, y as f32);
            }
            glEnd();
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(98, 15);
    Ok(())
}

fn fog_depth(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("fog-depth");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(24).max(3) {
        let fog = match round % 3 {
            0 => Fog::Linear([
                f64::from(rng.dyadic(1.0, 4.0, 0.125)),
                f64::from(rng.dyadic(6.0, 18.0, 0.125)),
            ]),
            1 => Fog::Exp(f64::from(rng.dyadic(0.0625, 0.25, 0.015_625))),
            _ => Fog::Exp2(f64::from(rng.dyadic(0.0625, 0.25, 0.015_625))),
        };
        let (color, of_fog) = ([1.0, 0.25, 0.0, 0.5], [0.0, 0.5, 1.0, 1.0]);
        // Eye depths at the lower and the upper end of the picture; 1/z is linear between them.
        let (near, far) = (f64::from(rng.real(1.0, 2.0)), f64::from(rng.real(6.0, 20.0)));
        let expect = |[_, y]: Pixel, variant: Variant| {
            let t = (y as f64 + 0.5) / PICTURE[1] as f64;
            let z = if variant.has(Mutation::Affine) {
                near + t * (far - near)
            } else {
                1.0 / (1.0 / near + t * (1.0 / far - 1.0 / near))
            };
            Some(fog.apply(z, color, of_fog, variant))
        };
        pictures.compare(&(fog, near, far), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            session.fog(fog, of_fog.map(|c| c as f32))?;
            glFogi(GL_FOG_COORD_SRC, GL_FRAGMENT_DEPTH as i32);
            glMatrixMode(GL_PROJECTION);
            glLoadIdentity();
            glFrustum(-1, 1, -1, 1, 1, 100);
            glMatrixMode(GL_MODELVIEW);
            glColor4f(color[0], color[1], color[2], color[3]);
            glBegin(GL_QUADS);
            for ([x, y], z) in
                [([-1.0, -1.0], near), ([1.0, -1.0], near), ([1.0, 1.0], far), ([-1.0, 1.0], far)]
            {
                glVertex3d(x * z, y * z, -z);
            }
            glEnd();
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 100);
    Ok(())
}
