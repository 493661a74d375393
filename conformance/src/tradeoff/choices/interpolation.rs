//! Texture coordinates that are linear on the screen, that, of smaller and smaller pieces, and perspective.

use super::super::draw::{Corner, corner, set_texture};
use super::super::stage::{Clock, Frame, Stage, one_thread};
use super::{Alternative, Alternatives, Choice, Cost, everywhere, pictured};
use crate::probe::ProbeError;
use gl_api::constants::*;
use gl_api::*;

/// Interpolation.
pub const INTERPOLATION: Choice = Choice {
    name: "interpolation",
    what: "a floor at 70°, trilinear, of n×n pieces that are affine on the screen, and in perspective; error against the area \
           integral",
    cost: Cost::Time,
    alternatives,
};

fn alternatives(side: usize) -> Result<Alternatives, ProbeError> {
    let scene = super::scene("floor-70", side)?;
    let device = one_thread()?;
    let mut all = Vec::new();
    let ways = [
        ("affine", 1, false),
        ("affine, 2×2 pieces", 2, false),
        ("affine, 4×4 pieces", 4, false),
        ("affine, 16×16 pieces", 16, false),
        ("affine, 64×64 pieces", 64, false),
        ("perspective", 1, true),
    ];
    for (name, pieces, is_perspective) in ways {
        let place = |k: usize| 2.0 * k as f64 / pieces as f64 - 1.0;
        let vertex = |i: usize, j: usize| -> Corner {
            let ([x, y, w], st) = corner(&scene, [place(i), place(j)]);
            if is_perspective { ([x, y, w], st) } else { ([x / w, y / w, 1.0], st) }
        };
        let quads: Vec<Corner> = (0..pieces * pieces)
            .flat_map(|k| {
                let (i, j) = (k % pieces, k / pieces);
                [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]
            })
            .collect();
        let stage = Stage::new(&device, Clock::Processor, side, || {
            set_texture(&scene, GL_LINEAR_MIPMAP_LINEAR, 1);
            glEnable(GL_TEXTURE_2D);
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
            Frame::new(move || {
                glBegin(GL_QUADS);
                for ([x, y, w], [s, t]) in &quads {
                    glTexCoord2f(*s, *t);
                    glVertex4f(*x, *y, 0, *w);
                }
                glEnd();
            })
        })?;
        all.push(Alternative::new(name, stage));
    }
    let reference = pictured(side, |pixel| scene.reference(pixel, side));
    Ok(Alternatives { side, reference, counts: everywhere, all })
}
