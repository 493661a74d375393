//! Formats of textures: what they keep of an image of floats, what a lookup takes, and how much memory a texel needs.

use super::super::stage::{Clock, Frame, Stage, one_thread};
use super::{Alternative, Alternatives, Choice, Cost, everywhere, pictured};
use crate::probe::ProbeError;
use gl_api::constants::*;
use gl_api::*;

/// Formats.
pub const FORMATS: Choice = Choice {
    name: "formats",
    what: "an image of floats in 16 formats, drawn 1:1 with a linear filter; error against the image; bytes a texel",
    cost: Cost::Memory,
    alternatives,
};

/// Internal format, name, bytes a texel.
const TABLE: [(u32, &str, f64); 16] = [
    (GL_RGBA32F, "RGBA32F", 16.0),
    (GL_RGBA16F, "RGBA16F", 8.0),
    (GL_RGBA16, "RGBA16", 8.0),
    (GL_RGB10_A2, "RGB10_A2", 4.0),
    (GL_R11F_G11F_B10F, "R11F_G11F_B10F", 4.0),
    (GL_RGB9_E5, "RGB9_E5", 4.0),
    (GL_RGBA8, "RGBA8", 4.0),
    (GL_RGB8, "RGB8", 3.0),
    (GL_RGB5_A1, "RGB5_A1", 2.0),
    (GL_RGBA4, "RGBA4", 2.0),
    (GL_RGB565, "RGB565", 2.0),
    (GL_R3_G3_B2, "R3_G3_B2", 1.0),
    (GL_COMPRESSED_RGBA_BPTC_UNORM, "BPTC", 1.0),
    (GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, "S3TC DXT5", 1.0),
    (GL_COMPRESSED_RGB_S3TC_DXT1_EXT, "S3TC DXT1", 0.5),
    (GL_LUMINANCE8, "LUMINANCE8 (grey)", 1.0),
];

/// Smooth colours, an edge, and fine detail, in [0, 1].
fn color([x, y]: [f64; 2]) -> [f64; 4] {
    let ring = ((x - 0.6).hypot(y - 0.4) * 40.0).cos();
    let edge = if x + 0.3 * y > 0.7 { 0.25 } else { 0.0 };
    let fine = 0.04 * (97.0 * x + 31.0 * y).sin();
    [
        0.1 + 0.6 * x + edge + fine,
        0.15 + 0.5 * y + 0.1 * ring,
        0.4 + 0.3 * (x * y) - edge + fine,
        1.0,
    ]
    .map(|c: f64| c.clamp(0.0, 1.0))
}

fn alternatives(side: usize) -> Result<Alternatives, ProbeError> {
    let device = one_thread()?;
    let at = |p: [usize; 2]| color(p.map(|c| (c as f64 + 0.5) / side as f64));
    let reference = pictured(side, at);
    let texels: Vec<f32> = reference.as_flattened().iter().map(|c| *c as f32).collect();
    let mut all = Vec::new();
    for (internal, name, bytes) in TABLE {
        let stage = Stage::new(&device, Clock::Processor, side, || {
            let target = GL_TEXTURE_2D;
            glBindTexture(target, 1);
            glTexImage2D(target, 0, internal, side, side, 0, GL_RGBA, GL_FLOAT, &texels);
            glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
            glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
            glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
            glEnable(target);
            Frame::new(|| {
                glBegin(GL_QUADS);
                for [s, t] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0f32]] {
                    glTexCoord2f(s, t);
                    glVertex2f(2.0 * s - 1.0, 2.0 * t - 1.0);
                }
                glEnd();
            })
        })?;
        all.push(Alternative { bytes: Some(bytes), ..Alternative::new(name, stage) });
    }
    Ok(Alternatives { side, reference, counts: everywhere, all })
}
