//! Where λ comes from: the differences of a quad, or derivatives that a shader computes.

use super::super::draw::set_texture;
use super::super::stage::{Clock, Frame, Stage, one_thread, square, use_program};
use super::{Alternative, Alternatives, Choice, Cost, pictured};
use crate::probe::ProbeError;
use gl_api::constants::*;

/// Level of detail.
pub const LEVEL_OF_DETAIL: Choice = Choice {
    name: "level-of-detail",
    what: "a sphere in a fragment shader, its limb left out, trilinear or with one level; error against the area integral",
    cost: Cost::Time,
    alternatives,
};

/// The place on the sphere, and ∂(s, t)/∂x and ∂(s, t)/∂y by the chain rule, of a step of a pixel.
fn shader(step: f64, lookup: &str) -> String {
    format!(
        "#version 130
        uniform sampler2D image;
        const float PI = 3.14159265358979;
        const float STEP = {step:?};
        void main() {{
            vec2 p = gl_TexCoord[0].xy;
            float z = sqrt(max(0.0, 1.0 - dot(p, p)));
            float c = 1.0 - p.y * p.y;
            vec2 st = 2.0 / PI * vec2(atan(p.x, z), asin(clamp(p.y, -1.0, 1.0)));
            vec2 dx = 2.0 / PI * STEP * vec2(1.0 / z, 0.0);
            vec2 dy = 2.0 / PI * STEP * vec2(p.x * p.y / (z * c), inversesqrt(c));
            float rho = max(length(dx), length(dy)) * 256.0;
            gl_FragColor = {lookup};
        }}"
    )
}

const LOOKUPS: [(&str, &str); 6] = [
    ("no levels", "textureLod(image, st, 0.0)"),
    ("differences of the quad", "texture(image, st)"),
    ("dFdx and dFdy", "textureGrad(image, st, dFdx(st), dFdy(st))"),
    ("analytic derivatives", "textureGrad(image, st, dx, dy)"),
    ("analytic λ", "textureLod(image, st, log2(rho))"),
    ("analytic λ, nearest level", "textureLod(image, st, floor(log2(rho) + 0.5))"),
];

fn alternatives(side: usize) -> Result<Alternatives, ProbeError> {
    let scene = super::scene("sphere", side)?;
    let device = one_thread()?;
    let mut all = Vec::new();
    for (name, lookup) in LOOKUPS {
        let source = shader(2.0 / side as f64, lookup);
        let stage = Stage::new(&device, Clock::Processor, side, || {
            set_texture(&scene, GL_LINEAR_MIPMAP_LINEAR, 1);
            use_program(None, &source);
            Frame::new(square)
        })?;
        all.push(Alternative::new(name, stage));
    }
    let reference = pictured(side, |pixel| match on_sphere(pixel, side) {
        true => scene.reference(pixel, side),
        false => [0.0; 4],
    });
    Ok(Alternatives { side, reference, counts: on_sphere, all })
}

/// Whether a pixel is within the sphere's limb.
pub(super) fn on_sphere(pixel: [usize; 2], side: usize) -> bool {
    let far = pixel.map(|c| {
        let ends = [c, c + 1].map(|c| (2.0 * c as f64 / side as f64 - 1.0).abs());
        ends[0].max(ends[1])
    });
    far[0].hypot(far[1]) < 0.97
}
