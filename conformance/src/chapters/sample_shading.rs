//! Programs that run once for each sample, and draws that have no colour at all.

use super::pictures::{Pictures, Pixel, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::samples::{SAMPLES, sample_position};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Sample shading.
pub const SHADING: Check = Check {
    name: "sample-shading",
    citation: "ARB_sample_shading: with a fraction of 1 each sample has data of its own, interpolated at its place",
    what: "the mean of the samples' x², y² and x y at every pixel, of a program that runs for each",
    unit: Unit::FullScale,
    tolerance: 3.5 / (1 << 24) as f64,
    why: "f32: coordinates below 1, and two sums on the way, are rounded by 2^-25, which their squares double: 3 · 2^-24, and square and mean by 2^-25 each: twice the root of the sum of squares",
    run: shading,
};

/// Depths without colours.
pub const DEPTH_ONLY: Check = Check {
    name: "depth-only",
    citation: "GL 2.1, 4.1.6 and 4.2.1: depths are written where no colour buffer is, or is drawn to",
    what: "the nearest depth of many slanted rectangles at every pixel, in framebuffers of depth only and with glDrawBuffer(GL_NONE)",
    unit: Unit::FullScale,
    tolerance: 2.75 / (1 << 24) as f64,
    why: "f32: the value at a block's first pixel, two products and two sums below 1, two slopes, and the depth itself, by 2^-25 each: twice the root of the sum of their squares",
    run: depth_only,
};

const PICTURE: Pixel = [75, 53];

fn shading(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("sample-shading");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(16).max(2) {
        // x and y from 0 to 1 over the picture, times this.
        let scale = f64::from(rng.dyadic(0.25, 1.0, 1.0 / 64.0));
        let expect = |pixel: Pixel, variant: Variant| {
            let mut mean = [0.0; 4];
            for sample in 0..SAMPLES {
                let at = sample_position(pixel, sample, variant);
                let [x, y] = [0, 1].map(|i| scale * at[i] / PICTURE[i] as f64);
                for (mean, value) in mean.iter_mut().zip([x * x, y * y, x * y]) {
                    *mean += value / SAMPLES as f64;
                }
            }
            Some(mean)
        };
        pictures.compare(&scale, expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, SAMPLES)?;
            glEnable(GL_SAMPLE_SHADING);
            glMinSampleShading(1.0);
            session.fragment_only(
                "void main() { gl_FragColor = gl_TexCoord[0].xyxz * gl_TexCoord[0].xyyz; }",
            )?;
            window(PICTURE);
            let [w, h] = PICTURE.map(|n| n as f64);
            glBegin(GL_QUADS);
            for [x, y] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
                glTexCoord2d(scale * x, scale * y);
                glVertex2d(x * w, y * h);
            }
            glEnd();
            session.read_resolved(GL_RGBA32F, PICTURE)
        })?;
    }
    pictures.finish(100, 95);
    Ok(())
}

/// A rectangle whose depth is linear in the window: two corners, and the depth at them and along x and y.
#[derive(Clone, Copy, Debug)]
struct Slanted {
    low: [f64; 2],
    high: [f64; 2],
    depth: f64,
    slope: [f64; 2],
}

impl Slanted {
    fn depth_at(&self, at: [f64; 2]) -> f64 {
        self.depth + (0..2).map(|i| self.slope[i] * (at[i] - self.low[i])).sum::<f64>()
    }

    fn covers(&self, at: [f64; 2]) -> bool {
        (0..2).all(|i| (self.low[i]..self.high[i]).contains(&at[i]))
    }
}

fn depth_only(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("depth-only");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(24).max(6) {
        let all: Vec<Slanted> = (0..12)
            .map(|_| {
                let [low, high] = [0, 1].map(|end| {
                    PICTURE.map(|n| rng.integer(0, n as i64 / 2) as f64 + (end * n / 2) as f64)
                });
                let depth = f64::from(rng.dyadic(0.25, 0.75, 1.0 / 256.0));
                let slope = [0; 2].map(|_: i32| f64::from(rng.dyadic(-0.125, 0.125, 1.0 / 4096.0)));
                Slanted { low, high, depth, slope: [0, 1].map(|i| slope[i] / (high[i] - low[i])) }
            })
            .collect();
        let has_color = round % 2 == 1;
        let expect = |[x, y]: Pixel, variant: Variant| {
            let at = [x as f64 + 0.5, y as f64 + 0.5];
            let mut nearest = 1.0;
            for slanted in all.iter().filter(|slanted| slanted.covers(at)) {
                let depth = slanted.depth_at(at);
                if depth < nearest || variant.has(Mutation::DepthWithoutTest) {
                    nearest = depth;
                }
            }
            Some([nearest, 0.0, 0.0, 0.0])
        };
        pictures.compare(&(&all[0], has_color), expect, |session| {
            session.deep_frame(GL_RGBA8, GL_DEPTH_COMPONENT32F, PICTURE, 0)?;
            if !has_color {
                let (point, buffer) = (GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER);
                glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, buffer, 0);
            }
            glDrawBuffer(GL_NONE);
            window(PICTURE);
            glEnable(GL_DEPTH_TEST);
            glBegin(GL_QUADS);
            for slanted in &all {
                let ([x0, y0], [x1, y1]) = (slanted.low, slanted.high);
                for at in [[x0, y0], [x1, y0], [x1, y1], [x0, y1]] {
                    glVertex3d(at[0], at[1], slanted.depth_at(at));
                }
            }
            glEnd();
            session.read_depths(PICTURE)
        })?;
    }
    pictures.finish(100, 90);
    Ok(())
}
