//! The accumulation buffer, and the scissor test.

use super::pictures::{Brush, Pictures, Pixel, color, cover, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// The scissor test.
pub const SCISSOR: Check = Check {
    name: "scissor",
    citation: "GL 2.1, 4.1.2: left <= x < left + width; also of clears",
    what: "every pixel after a clear and a draw under random boxes, empty and partly outside ones too",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not",
    run: scissor,
};

/// The accumulation buffer.
pub const ACCUM: Check = Check {
    name: "accumulation",
    citation: "GL 2.1, 4.2.4: GL_ACCUM, GL_LOAD, GL_RETURN, GL_MULT, GL_ADD",
    what: "every pixel of random sequences of operations on random colours",
    unit: Unit::Bytes,
    tolerance: 0.5 + 1.0 / (1 << 12) as f64,
    why: "8-bit colours: half a step; the accumulation buffer is of f32: up to eight roundings of values below 4 by 2^-23 each are 2^-12 of 255",
    run: accumulate,
};

const PICTURE: Pixel = [35, 27];

fn at([x, y]: Pixel) -> usize {
    y * PICTURE[0] + x
}

fn scissor(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("scissor");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(64) {
        let mut rect = || {
            let low = [rng.integer(-9, 30), rng.integer(-9, 24)];
            (low, [rng.integer(0, 34), rng.integer(0, 24)])
        };
        let rects = [rect(), rect()];
        let expect = |pixel: Pixel, variant: Variant| {
            let inside = rects.map(|(low, size)| {
                (0..2).all(|i| {
                    let end = low[i] + size[i] + i64::from(variant.has(Mutation::ScissorInclusive));
                    (low[i]..end).contains(&(pixel[i] as i64))
                })
            });
            let clear = inside[0] || variant.has(Mutation::ScissorIgnored);
            Some([f64::from(u8::from(clear)), f64::from(u8::from(inside[1])), 0.0, 0.0])
        };
        pictures.compare(&rects, expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            glEnable(GL_SCISSOR_TEST);
            let set = |([x, y], [w, h]): ([i64; 2], [i64; 2])| {
                glScissor(x as i32, y as i32, w as i32, h as i32);
            };
            set(rects[0]);
            glClearColor(1, 0, 0, 0);
            glClear(GL_COLOR_BUFFER_BIT);
            set(rects[1]);
            glColorMask(false, true, false, false);
            color([0.0, 1.0, 0.0, 0.0]);
            cover(PICTURE, 0.5);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 10);
    Ok(())
}

/// An operation on the accumulation buffer, and its value.
type Step = (u32, f32);

fn accumulate(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("accumulation");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(48) {
        // As many draws as operations that read colours; sums stay in [-1, 1].
        let mut steps: Vec<Step> = vec![(GL_LOAD, rng.real(0.2, 0.5))];
        for _ in 0..3 {
            let (operation, value) = match rng.integer(0, 2) {
                0 => (GL_ACCUM, rng.real(-0.2, 0.2)),
                1 => (GL_MULT, rng.real(-1.0, 1.0)),
                _ => (GL_ADD, rng.real(-0.1, 0.1)),
            };
            steps.push((operation, value));
        }
        steps.push((GL_RETURN, rng.real(-1.5, 1.5)));
        let draws: Vec<Vec<[f32; 4]>> = steps
            .iter()
            .map(|_| {
                let bytes = || [0; 4].map(|_: i32| f32::from(rng.byte()) / 255.0);
                std::iter::repeat_with(bytes).take(PICTURE[0] * PICTURE[1]).collect()
            })
            .collect();
        let expect = |pixel: Pixel, variant: Variant| {
            let mut sum = [0.0f64; 4];
            for ((operation, value), colors) in steps.iter().zip(&draws) {
                let value = f64::from(*value);
                let color = colors[at(pixel)].map(f64::from);
                sum = std::array::from_fn(|i| match *operation {
                    GL_LOAD => value * color[i],
                    GL_ACCUM if variant.has(Mutation::AccumLoads) => value * color[i],
                    GL_ACCUM => sum[i] + value * color[i],
                    GL_MULT => sum[i] * value,
                    GL_ADD => sum[i] + value,
                    _ if variant.has(Mutation::ReturnUnscaled) => sum[i].clamp(0.0, 1.0),
                    _ => (sum[i] * value).clamp(0.0, 1.0),
                });
            }
            Some(sum)
        };
        pictures.compare(&steps, expect, |session| {
            glViewport(0, 0, PICTURE[0], PICTURE[1]);
            window(PICTURE);
            for ((operation, value), colors) in steps.iter().zip(&draws) {
                Brush::Texture.paint(PICTURE, colors);
                glAccum(*operation, *value);
            }
            session.read_bytes(PICTURE)
        })?;
    }
    pictures.finish(100, 30);
    Ok(())
}
