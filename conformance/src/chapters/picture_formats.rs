//! Textures of every kind of texel, filtered over whole pictures into floats.

use super::pictures::{Pictures, Pixel};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::format::{Base, Encoding, linear, stored};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Linear filters of formats.
pub const FORMATS: Check = Check {
    name: "picture-formats",
    citation: "GL 2.1, 3.8.8, tables 3.15 and 3.20; the formats' extensions",
    what: "every pixel of squares with linear textures of 25 formats, magnified, into floats",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 18) as f64,
    why: "f32 coordinates of up to 32 texels off by 2^-20 in each of two weights, with their planes, of texels up to 1 apart",
    run,
};

const PICTURE: Pixel = [67, 45];

const SIZE: [usize; 2] = [32, 21];

const TEXELS: [(u32, Base, Encoding); 25] = {
    use Base::{Alpha, Intensity, Luminance, LuminanceAlpha, Red, Rg, Rgb, Rgba};
    use Encoding::{Half, PackedFloat, Single, Srgb, Unorm};
    [
        (GL_RGBA8, Rgba, Unorm([8; 4])),
        (GL_RGB8, Rgb, Unorm([8; 4])),
        (GL_RG8, Rg, Unorm([8; 4])),
        (GL_R8, Red, Unorm([8; 4])),
        (GL_LUMINANCE8, Luminance, Unorm([8; 4])),
        (GL_LUMINANCE8_ALPHA8, LuminanceAlpha, Unorm([8; 4])),
        (GL_INTENSITY8, Intensity, Unorm([8; 4])),
        (GL_ALPHA8, Alpha, Unorm([8; 4])),
        (GL_RGB5_A1, Rgba, Unorm([5, 5, 5, 1])),
        (GL_RGBA4, Rgba, Unorm([4; 4])),
        (GL_RGBA16, Rgba, Unorm([16; 4])),
        (GL_SRGB8_ALPHA8, Rgba, Srgb),
        (GL_SRGB8, Rgb, Srgb),
        (GL_RGBA16F, Rgba, Half),
        (GL_RG16F, Rg, Half),
        (GL_R16F, Red, Half),
        (GL_R11F_G11F_B10F, Rgb, PackedFloat),
        (GL_RGBA32F, Rgba, Single),
        (GL_RGB32F, Rgb, Single),
        (GL_RG32F, Rg, Single),
        (GL_R32F, Red, Single),
        (GL_RGB16F, Rgb, Half),
        (GL_RGB16, Rgb, Unorm([16; 4])),
        (GL_RG16, Rg, Unorm([16; 4])),
        (GL_RGB10_A2, Rgba, Unorm([10, 10, 10, 2])),
    ]
};

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("picture-formats");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(75).max(TEXELS.len()) {
        let (internal, base, encoding) = TEXELS[round % TEXELS.len()];
        // Numbers that the format has, so that rounding on the way in does not matter.
        let texels: Vec<[f64; 4]> = (0..SIZE[0] * SIZE[1])
            .map(|_| {
                let given = [0; 4].map(|_: i32| f64::from(rng.real(0.0, 1.0)));
                base.queried(stored(base, encoding, given, Variant::CORRECT), Variant::CORRECT)
            })
            .collect();
        let read = |[i, j]: [usize; 2], variant: Variant| {
            let codes = stored(base, encoding, texels[j * SIZE[0] + i], Variant::CORRECT);
            base.sampled(linear(base, encoding, codes, variant), variant)
        };
        let (s0, t0) = (f64::from(rng.real(0.05, 0.3)), f64::from(rng.real(0.05, 0.3)));
        let (ds, dt) = (f64::from(rng.real(0.3, 0.6)), f64::from(rng.real(0.3, 0.6)));
        let expect = |[x, y]: Pixel, variant: Variant| {
            let [w, h] = PICTURE.map(|n| n as f64);
            let u = (s0 + ds * (x as f64 + 0.5) / w) * SIZE[0] as f64 - 0.5;
            let v = (t0 + dt * (y as f64 + 0.5) / h) * SIZE[1] as f64 - 0.5;
            let half = if variant.has(Mutation::HalfTexelOff) { 0.5 } else { 0.0 };
            let (u, v) = (u + half, v + half);
            let ([i, j], [a, b]) = ([u, v].map(|c| c.floor() as usize), [u.fract(), v.fract()]);
            let corners =
                [[i, j], [i + 1, j], [i, j + 1], [i + 1, j + 1]].map(|at| read(at, variant));
            let weights = [(1.0 - a) * (1.0 - b), a * (1.0 - b), (1.0 - a) * b, a * b];
            Some(std::array::from_fn(|c| (0..4).map(|k| weights[k] * corners[k][c]).sum()))
        };
        pictures.compare(&(enum_name(internal), s0, t0), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            let (target, [w, h]) = (GL_TEXTURE_2D, SIZE);
            let numbers: Vec<f32> = texels.as_flattened().iter().map(|&c| c as f32).collect();
            glBindTexture(target, 1);
            glTexImage2D(target, 0, internal, w, h, 0, GL_RGBA, GL_FLOAT, &numbers);
            glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
            glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
            session.show_textures(1)?;
            glBegin(GL_QUADS);
            for [x, y] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
                glTexCoord2d(s0 + ds * x, t0 + dt * y);
                glVertex2d(2.0 * x - 1.0, 2.0 * y - 1.0);
            }
            glEnd();
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 90);
    Ok(())
}
