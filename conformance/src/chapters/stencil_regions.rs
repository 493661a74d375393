//! Stencils of whole regions: triangles over many blocks of pixels that mark, and triangles that are drawn where marks are.

use super::pictures::{Pictures, Pixel, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::compare::Compare;
use crate::oracle::fragment::{Stencil, StencilOp};
use crate::oracle::painter::inside;
use crate::oracle::samples::{SAMPLES, sample_position};
use crate::probe::{ProbeError, compare_enum, operation_enum};
use crate::rng::Rng;
use gl_api::constants::*;

/// Marks and masks.
pub const REGIONS: Check = Check {
    name: "stencil-regions",
    citation: "GL 2.1, 4.1.5 and 4.1.6: marks by GL_REPLACE and GL_ZERO, drawing where they compare, of samples too",
    what: "every pixel of twelve random triangles over one another that mark, or are drawn where marks are, with and without a depth test, of one sample and of four",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "numbers of triangles in 64ths, whose means f32 has; samples on an edge are left out",
    run,
};

/// Some tiles of blocks.
const PICTURE: Pixel = [150, 140];

const STEPS: usize = 12;

/// A triangle and its tests.
#[derive(Debug)]
struct Step {
    corners: [[f32; 2]; 3],
    /// In 64ths, none as another's.
    depth: f64,
    tests_depth: bool,
    /// Of front and of back faces.
    faces: [Stencil; 2],
}

impl Step {
    fn is_front(&self) -> bool {
        let [a, b, c] = self.corners.map(|corner| corner.map(f64::from));
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0
    }
}

fn face(rng: &mut Rng) -> Stencil {
    let keep = [StencilOp::Keep; 3];
    // Few references, so that comparisons hold and fail.
    let of = Stencil {
        compare: rng.pick(&Compare::ALL),
        reference: rng.pick(&[0, 1, 2]),
        mask: 0xff,
        operations: keep,
        write_mask: 0xff,
        stored: 0,
        depth_passes: true,
    };
    match rng.integer(0, 4) {
        0 | 1 => {
            let pass = rng.pick(&[StencilOp::Replace, StencilOp::Replace, StencilOp::Zero]);
            let operations = [StencilOp::Keep, StencilOp::Keep, pass];
            Stencil { compare: Compare::Always, operations, ..of }
        }
        2 | 3 => of,
        _ => {
            let operations = [0; 3].map(|_: i32| rng.pick(&StencilOp::ALL));
            Stencil { operations, mask: rng.pick(&[1, 0xff]), ..of }
        }
    }
}

fn steps(rng: &mut Rng) -> Vec<Step> {
    let mut depths: Vec<f64> = (1..=STEPS).map(|at| at as f64 / 64.0).collect();
    (0..STEPS)
        .map(|_| {
            let mut corner = || [0; 2].map(|_: i32| rng.dyadic(-60.0, 210.0, 1.0 / 256.0));
            let corners = [corner(), corner(), corner()];
            let depth = depths.swap_remove(rng.integer(0, depths.len() as i64 - 1) as usize);
            let tests_depth = rng.integer(0, 2) == 0;
            Step { corners, depth, tests_depth, faces: [face(rng), face(rng)] }
        })
        .collect()
}

/// The number of the last triangle that is seen at a place, counted from 1, or 0; `None` on an edge.
fn seen(steps: &[Step], place: [f64; 2], variant: Variant) -> Option<usize> {
    let (mut last, mut value, mut depth) = (0, 1, 1.0);
    for (number, step) in (1..).zip(steps) {
        if !inside(step.corners.map(|corner| corner.map(f64::from)), place)? {
            continue;
        }
        let is_front = step.is_front() != variant.has(Mutation::FacesSwapped);
        let depth_passes = !step.tests_depth || step.depth < depth;
        let of = Stencil { stored: value, depth_passes, ..step.faces[usize::from(!is_front)] };
        let is_seen;
        (value, is_seen) = of.apply(variant);
        if is_seen {
            last = number;
            if step.tests_depth {
                depth = step.depth;
            }
        }
    }
    Some(last)
}

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("stencil-regions");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(16).max(8) {
        let samples = [0, SAMPLES][round % 2];
        let steps = steps(&mut rng);
        let expect = |pixel: Pixel, variant: Variant| {
            let number = |place| Some(seen(&steps, place, variant)? as f64 / 64.0);
            let red = if samples == 0 {
                number(pixel.map(|c| c as f64 + 0.5))?
            } else {
                let mut sum = 0.0;
                for sample in 0..SAMPLES {
                    sum += number(sample_position(pixel, sample, variant))?;
                }
                sum / SAMPLES as f64
            };
            Some([red, 0.0, 0.0, 0.0])
        };
        pictures.compare(&(samples, &steps), expect, |session| {
            session.deep_frame(GL_RGBA32F, GL_DEPTH24_STENCIL8, PICTURE, samples)?;
            window(PICTURE);
            glClearStencil(1);
            glClear(GL_STENCIL_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            glEnable(GL_STENCIL_TEST);
            for (number, step) in (1..).zip(&steps) {
                if step.tests_depth {
                    glEnable(GL_DEPTH_TEST);
                } else {
                    glDisable(GL_DEPTH_TEST);
                }
                for (face, of) in [GL_FRONT, GL_BACK].into_iter().zip(&step.faces) {
                    let [fail, depth_fail, pass] = of.operations.map(operation_enum);
                    let compare = compare_enum(of.compare);
                    glStencilFuncSeparate(face, compare, i32::from(of.reference), of.mask);
                    glStencilOpSeparate(face, fail, depth_fail, pass);
                }
                glColor4f(number as f32 / 64.0, 0, 0, 0);
                glBegin(GL_TRIANGLES);
                for [x, y] in step.corners {
                    glVertex3f(x, y, step.depth as f32);
                }
                glEnd();
            }
            if samples == 0 {
                session.read_floats(PICTURE)
            } else {
                session.read_resolved(GL_RGBA32F, PICTURE)
            }
        })?;
    }
    pictures.finish(95, 40);
    Ok(())
}
