//! Shadow maps: their size, and how many comparisons a pixel averages.

use super::super::stage::{Clock, Frame, Stage, one_thread, square, use_program};
use super::{Alternative, Alternatives, Choice, Cost, everywhere, pictured};
use crate::oracle::polygon::shared_area;
use crate::probe::ProbeError;
use gl_api::constants::*;
use gl_api::*;

/// Shadow maps.
pub const SHADOWS: Choice = Choice {
    name: "shadows",
    what: "the hard shadow of a triangle on a plane, the map drawn anew each time; error against the area in the light",
    cost: Cost::Time,
    alternatives,
};

/// The occluder: x, y, and height above the plane.
const OCCLUDER: [[f64; 3]; 3] = [[-0.9, -0.55, 0.5], [0.3, -0.7, 0.3], [-0.2, 0.75, 0.6]];

/// The light's direction per unit of height.
const SLANT: [f64; 2] = [0.55, 0.2];

/// Where the ray of light through a point meets the plane.
fn on_plane([x, y, height]: [f64; 3]) -> [f64; 2] {
    [x + SLANT[0] * height, y + SLANT[1] * height]
}

/// The map is turned against the picture, and somewhat larger.
const TURN: [f64; 2] = [0.62, 0.29];

fn in_map([x, y]: [f64; 2]) -> [f64; 2] {
    let [c, s] = TURN;
    [c * x - s * y, s * x + c * y]
}

const HEAD: &str = "
    uniform sampler2DShadow map;
    float lit(vec2 offset) {
        vec2 p = gl_TexCoord[0].xy;
        vec2 at = 0.5 * vec2(0.62 * p.x - 0.29 * p.y, 0.29 * p.x + 0.62 * p.y) + 0.5;
        return shadow2D(map, vec3(at + offset / SIZE, 0.9)).r;
    }
";

/// So many comparisons along each side.
fn shader(size: usize, taps: usize) -> String {
    let first = -0.5 * (taps as f64 - 1.0);
    let sum: Vec<String> = (0..taps * taps)
        .map(|k| {
            let [x, y] = [k % taps, k / taps].map(|c| first + c as f64);
            format!("lit(vec2({x:?}, {y:?}))")
        })
        .collect();
    format!(
        "{}\n void main() {{ gl_FragColor = vec4(vec3(({}) / {:?}), 1.0); }}",
        HEAD.replace("SIZE", &format!("{:?}", size as f64)),
        sum.join(" + "),
        (taps * taps) as f64
    )
}

/// A framebuffer with a depth texture of this size.
fn map(size: usize, filter: u32) -> u32 {
    let target = GL_TEXTURE_2D;
    glBindTexture(target, 1);
    let (format, ty) = (GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
    glTexImage2D(target, 0, GL_DEPTH_COMPONENT24, size, size, 0, format, ty, NULL);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glTexParameteri(target, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    let mut framebuffer = 0u32;
    glGenFramebuffers(1, &mut framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, target, 1, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    framebuffer
}

fn alternatives(side: usize) -> Result<Alternatives, ProbeError> {
    let device = one_thread()?;
    let mut all = Vec::new();
    for size in [64, 256, 1024] {
        for (name, filter, taps) in [
            ("one comparison", GL_NEAREST, 1),
            ("linear, 2×2", GL_LINEAR, 1),
            ("3×3 linear", GL_LINEAR, 3),
        ] {
            let stage = Stage::new(&device, Clock::Processor, side, || {
                let framebuffer = map(size, filter);
                let program = use_program(None, &shader(size, taps));
                glEnable(GL_DEPTH_TEST);
                Frame::new(move || {
                    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
                    glViewport(0, 0, size, size);
                    glClear(GL_DEPTH_BUFFER_BIT);
                    glUseProgram(0);
                    glBegin(GL_TRIANGLES);
                    for corner in OCCLUDER {
                        let [x, y] = in_map(on_plane(corner));
                        glVertex2d(x, y);
                    }
                    glEnd();
                    glBindFramebuffer(GL_FRAMEBUFFER, 0);
                    glViewport(0, 0, side, side);
                    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
                    glUseProgram(program);
                    square();
                })
            })?;
            all.push(Alternative::new(format!("{size}², {name}"), stage));
        }
    }
    let corners = OCCLUDER.map(|corner| on_plane(corner).map(|c| (c + 1.0) * side as f64 / 2.0));
    let reference = pictured(side, |pixel| {
        let lit = 1.0 - shared_area(&corners, pixel);
        [lit, lit, lit, 1.0]
    });
    Ok(Alternatives { side, reference, counts: everywhere, all })
}
