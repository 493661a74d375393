//! A checkerboard as a procedure, and as a texture.

use super::super::draw::{corners, draw_corners};
use super::super::scene::Surface;
use super::super::stage::{Clock, Frame, Stage, one_thread, use_program};
use super::{Alternative, Alternatives, Choice, Cost, everywhere, pictured};
use crate::oracle::texture::Level;
use crate::probe::ProbeError;
use crate::reference::map::Homography;
use crate::reference::{Reconstruction, area};
use gl_api::constants::*;

/// A procedure or a texture.
pub const PROCEDURE: Choice = Choice {
    name: "procedure",
    what: "checks of 8 units on a floor at 70°, computed or looked up; error against the area integral of the checks",
    cost: Cost::Time,
    alternatives,
};

/// Texels of the pattern, of which a check has 8.
const SIDE: usize = 256;

/// A checkerboard by floor.
const POINT: &str = "
    void main() {
        vec2 check = floor(gl_TexCoord[0].xy * 32.0);
        gl_FragColor = vec4(vec3(mod(check.x + check.y, 2.0)), 1.0);
    }";

/// The integral of the pattern over the pixel's footprint, a box along s and t.
const FILTERED: &str = "
    vec2 integral(vec2 x) { return floor(0.5 * x) + 2.0 * max(0.5 * x - floor(0.5 * x) - 0.5, 0.0); }
    void main() {
        vec2 p = gl_TexCoord[0].xy * 32.0;
        vec2 w = max(fwidth(p), 0.0001);
        vec2 odd = (integral(p + 0.5 * w) - integral(p - 0.5 * w)) / w;
        gl_FragColor = vec4(vec3(odd.x * (1.0 - odd.y) + odd.y * (1.0 - odd.x)), 1.0);
    }";

const LOOKUP: &str = "
    uniform sampler2D image;
    void main() { gl_FragColor = texture2D(image, gl_TexCoord[0].xy); }";

fn alternatives(side: usize) -> Result<Alternatives, ProbeError> {
    let mut scene = super::scene("floor-70", side)?;
    scene.image = Level::from_fn(SIDE, SIDE, |i, j| {
        let c = if (i / 8 + j / 8) % 2 == 1 { 255 } else { 0 };
        [c, c, c, 255]
    });
    let device = one_thread()?;
    let ways: [(&str, &str, u32, u32); 5] = [
        ("procedure at the centre", POINT, GL_NEAREST, 1),
        ("procedure, integrated", FILTERED, GL_NEAREST, 1),
        ("texture, nearest", LOOKUP, GL_NEAREST, 1),
        ("texture, trilinear", LOOKUP, GL_LINEAR_MIPMAP_LINEAR, 1),
        ("texture, anisotropic 16", LOOKUP, GL_LINEAR_MIPMAP_LINEAR, 16),
    ];
    let mut all = Vec::new();
    for (name, shader, filter, anisotropy) in ways {
        let stage = Stage::new(&device, Clock::Processor, side, || {
            super::super::draw::set_texture(&scene, filter, anisotropy);
            use_program(None, shader);
            let corners = corners(&scene);
            Frame::new(move || draw_corners(&corners))
        })?;
        all.push(Alternative::new(name, stage));
    }
    let reference = pictured(side, |[x, y]| {
        let Surface::Plane(map) = scene.surface else { return [0.0; 4] };
        let step = 2.0 / side as f64;
        let to_ndc = Homography([[step, 0.0, -1.0], [0.0, step, -1.0], [0.0, 0.0, 1.0]]);
        let square = [x as f64, y as f64, x as f64 + 1.0, y as f64 + 1.0];
        area::mean(&scene.image, &map.after(&to_ndc), square, Reconstruction::Box)
    });
    Ok(Alternatives { side, reference, counts: everywhere, all })
}
