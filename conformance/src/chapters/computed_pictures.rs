//! Textures at coordinates that a shader computes, so that λ comes from differences within quads of pixels.

use super::texture_pictures::{PICTURE, compare_varying, image, mipmapped, repeating};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::oracle::lod::{Filter, Mipmap};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;
use std::collections::BTreeSet;

/// Computed coordinates.
pub const COMPUTED: Check = Check {
    name: "picture-computed",
    citation: "GL 2.1, 3.8.8: λ of coordinates that a fragment shader computes; GLSL 1.20, 8.7",
    what: "every pixel of trilinear textures of 64, 256 and 512 at coordinates of degree two in x and y",
    unit: Unit::Bytes,
    tolerance: 0.51,
    why: "8-bit colours: half a step; f32 coordinates up to 4, whose differences are off by 2^-13 of a texel; λ may be that of a difference or of a derivative",
    run,
};

/// `s = a + b x + c x y`, and t alike of y and x; x and y from 0 to 1 over the picture.
#[derive(Clone, Copy, Debug)]
struct Computed([[f32; 3]; 2]);

impl Computed {
    fn random(rng: &mut Rng, side: usize, lambda: f64) -> Self {
        let scale = lambda.exp2() / side as f64;
        Self(std::array::from_fn(|i| {
            let sign = rng.pick(&[-1.0, 1.0]);
            let step = sign * scale * PICTURE[i] as f64;
            [
                rng.real(0.0, 1.0),
                (step * f64::from(rng.real(0.5, 1.0))) as f32,
                (step * f64::from(rng.real(0.2, 0.6))) as f32,
            ]
        }))
    }

    fn st(&self, x: f64, y: f64) -> [f64; 2] {
        let p = [x / PICTURE[0] as f64, y / PICTURE[1] as f64];
        [0, 1].map(|i| {
            let [a, b, c] = self.0[i].map(f64::from);
            a + b * p[i] + c * p[0] * p[1]
        })
    }

    fn shader(&self) -> String {
        let [[a, b, c], [d, e, f]] = self.0;
        format!(
            "uniform sampler2D image;
            void main() {{
                vec2 p = gl_TexCoord[0].xy;
                vec2 st = vec2({a:?}, {d:?}) + vec2({b:?}, {e:?}) * p + vec2({c:?}, {f:?}) * (p.x * p.y);
                gl_FragColor = texture2D(image, st);
            }}"
        )
    }
}

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("picture-computed");
    let filters = mipmapped(Filter::Linear, Mipmap::Linear);
    let mut levels_reached = BTreeSet::new();
    for round in 0..harness.cases(24).max(6) {
        let side = [64, 256, 512][round % 3];
        let image = image(&mut rng, [side; 2], filters);
        let sampler = repeating(&image, filters);
        let lambda = f64::from(rng.real(-1.0, 3.0));
        let computed = Computed::random(&mut rng, side, lambda);
        let st = |x: f64, y: f64| computed.st(x, y);
        let scene = (side, computed);
        let reached =
            compare_varying(harness, tally, &scene, (&image, &sampler), &st, |session| {
                session.frame(GL_RGBA8, PICTURE, 0)?;
                session.texture_2d(&image, &sampler)?;
                session.fragment_only(&computed.shader())?;
                glBegin(GL_QUADS);
                for [x, y] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
                    glTexCoord2d(x, y);
                    glVertex2d(2.0 * x - 1.0, 2.0 * y - 1.0);
                }
                glEnd();
                session.read_bytes(PICTURE)
            })?;
        levels_reached.extend(reached);
    }
    tally.reach("levels of detail", levels_reached.len(), 3);
    Ok(())
}
