//! What colour buffers keep: every renderable format, dithering, masks, several buffers.

use super::pictures::{Brush, Pictures, Pixel, random_colors, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::format::{Base, Encoding, linear, stored};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Colours in every renderable format.
pub const FORMATS: Check = Check {
    name: "render-formats",
    citation: "GL 2.1, 2.14.9 and 4.1.9; GL 3.0, 2.1.2, 2.1.3: conversion to the buffer's format",
    what: "every pixel of random colours within and beyond the range of 21 colour formats",
    unit: Unit::Codes,
    tolerance: 1.0 + 1.0 / (1 << 8) as f64,
    why: "in halves of the format's step: the nearest code, and f32 of the product with its largest, below 2^16, which is rounded by 2^-9",
    run: formats,
};

/// Dithering.
pub const DITHER: Check = Check {
    name: "dither",
    citation: "GL 2.1, 4.1.9: one of the two nearest codes, dependent on x, y and the colour alone",
    what: "every pixel of level and random colours in 8, 5 and 4 bits with GL_DITHER on, drawn twice",
    unit: Unit::Codes,
    tolerance: 1.0,
    why: "within one code of the exact colour",
    run: dither,
};

/// Masks of colours.
pub const COLOR_MASK: Check = Check {
    name: "color-mask",
    citation: "GL 3.0, 4.2.2: glColorMask, glColorMaski; drawing and clearing",
    what: "every pixel of three buffers after a draw and a clear under random masks of each",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "floats pass as they are",
    run: color_mask,
};

/// Several buffers.
pub const DRAW_BUFFERS: Check = Check {
    name: "draw-buffers",
    citation: "GL 2.1, 4.2.1: glDrawBuffers, gl_FragData[i] to the buffer i names; gl_FragColor to all",
    what: "every pixel of four buffers in random order, some of them GL_NONE",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "floats pass as they are",
    run: draw_buffers,
};

const PICTURE: Pixel = [35, 27];

fn at([x, y]: Pixel) -> usize {
    y * PICTURE[0] + x
}

/// Formats that hold a fragment's colours.
const RENDERED: [(u32, Base, Encoding); 21] = {
    use Base::{Alpha, Intensity, Luminance, LuminanceAlpha, Red, Rg, Rgb, Rgba};
    use Encoding::{Half, Single, Snorm, Unorm};
    [
        (GL_R8, Red, Unorm([8; 4])),
        (GL_R16, Red, Unorm([16; 4])),
        (GL_RG8, Rg, Unorm([8; 4])),
        (GL_RG16, Rg, Unorm([16; 4])),
        (GL_RGB565, Rgb, Unorm([5, 6, 5, 0])),
        (GL_RGB8, Rgb, Unorm([8; 4])),
        (GL_RGBA4, Rgba, Unorm([4; 4])),
        (GL_RGB5_A1, Rgba, Unorm([5, 5, 5, 1])),
        (GL_RGBA8, Rgba, Unorm([8; 4])),
        (GL_RGB10_A2, Rgba, Unorm([10, 10, 10, 2])),
        (GL_RGBA16, Rgba, Unorm([16; 4])),
        (GL_ALPHA8, Alpha, Unorm([8; 4])),
        (GL_LUMINANCE8, Luminance, Unorm([8; 4])),
        (GL_LUMINANCE8_ALPHA8, LuminanceAlpha, Unorm([8; 4])),
        (GL_INTENSITY8, Intensity, Unorm([8; 4])),
        (GL_RGBA8_SNORM, Rgba, Snorm(8)),
        (GL_RGBA16_SNORM, Rgba, Snorm(16)),
        (GL_R16F, Red, Half),
        (GL_RGBA16F, Rgba, Half),
        (GL_RG32F, Rg, Single),
        (GL_RGBA32F, Rgba, Single),
    ]
};

/// Half the distance between two numbers of a format, about `x`.
fn half_step(encoding: Encoding, channel: usize, x: f64) -> f64 {
    let float = |mantissa: i32| 2f64.powi((x.abs().log2().floor() as i32).max(-14) - mantissa - 1);
    match encoding {
        Encoding::Unorm(bits) => 0.5 / ((1u64 << bits[channel].max(1)) - 1) as f64,
        Encoding::Snorm(bits) => 0.5 / ((1u64 << (bits - 1)) - 1) as f64,
        Encoding::Half => float(10),
        Encoding::Single => float(23),
        Encoding::Srgb
        | Encoding::PackedFloat
        | Encoding::SharedExponent
        | Encoding::Integer(..) => f64::NAN,
    }
}

fn formats(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("render-formats");
    for round in 0..harness.cases(84).max(RENDERED.len()) {
        let (internal, base, encoding) = RENDERED[round % RENDERED.len()];
        let colors = random_colors(&mut rng, PICTURE, [-1.5, 1.5]);
        let pixels: Vec<Pixel> = super::pictures::all(PICTURE).collect();
        // The exact colour in the range of the format, as glReadPixels shows it; not yet rounded.
        let expect = |pixel: &Pixel, variant: Variant| {
            let given = colors[at(*pixel)].map(f64::from);
            let mut c = [0.0; 4];
            for (channel, &source) in c.iter_mut().zip(base.sources()) {
                *channel = match encoding {
                    Encoding::Unorm(_) if !variant.has(Mutation::RangeIgnored) => {
                        given[source].clamp(0.0, 1.0)
                    }
                    Encoding::Snorm(_) => given[source].clamp(-1.0, 1.0),
                    Encoding::Unorm(_)
                    | Encoding::Half
                    | Encoding::Single
                    | Encoding::Srgb
                    | Encoding::PackedFloat
                    | Encoding::SharedExponent
                    | Encoding::Integer(..) => given[source],
                };
            }
            if variant.has(Mutation::UnormTruncates) {
                let below = given.map(|c| c - 1.0 / 500.0);
                c = linear(base, encoding, stored(base, encoding, below, variant), variant);
            }
            base.queried(c, variant)
        };
        let error = |_: &Pixel, expected: [f64; 4], found: [f64; 4]| {
            let of = |i: usize| {
                // Components that are not stored come back as they are.
                let stored = base.sources().iter().position(|&source| source == i);
                let channel = stored.unwrap_or(0);
                let step =
                    if stored.is_some() { half_step(encoding, channel, expected[i]) } else { 1e-9 };
                (expected[i] - found[i]).abs() / step
            };
            (0..4).map(of).fold(0.0, f64::max)
        };
        let scene = enum_name(internal);
        harness.compare_by(tally, &scene, &pixels, expect, error, |session| {
            session.frame(internal, PICTURE, 0)?;
            window(PICTURE);
            glDisable(GL_DITHER);
            glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
            glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
            glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
            Brush::of(round / RENDERED.len()).paint(PICTURE, &colors);
            session.read_floats(PICTURE)
        })?;
    }
    Ok(())
}

fn dither(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("dither");
    for round in 0..harness.cases(48).max(6) {
        let (internal, bits) =
            [(GL_RGBA8, [8; 4]), (GL_RGB565, [5, 6, 5, 8]), (GL_RGBA4, [4; 4])][round % 3];
        let largest = bits.map(|bits: u32| f64::from((1u32 << bits) - 1));
        let mut colors = random_colors(&mut rng, PICTURE, [0.0, 1.0]);
        if round % 2 == 0 {
            let first = colors[0];
            colors.fill(first);
        }
        let pixels: Vec<Pixel> = super::pictures::all(PICTURE).collect();
        let expect = |pixel: &Pixel, variant: Variant| {
            let shift = if variant.has(Mutation::UnormTruncates) { 1.1 } else { 0.0 };
            let c = colors[at(*pixel)];
            let [r, g, b, _] = [0, 1, 2, 3].map(|i| f64::from(c[i]) * largest[i] + shift);
            [r, g, b, 0.0]
        };
        let scene = (enum_name(internal), round % 2 == 0);
        harness.compare(tally, &scene, &pixels, expect, |session| {
            session.frame(internal, PICTURE, 0)?;
            window(PICTURE);
            glEnable(GL_DITHER);
            let mut twice = Vec::new();
            for _ in 0..2 {
                Brush::of(round).paint(PICTURE, &colors);
                twice.push(session.read_floats(PICTURE)?);
            }
            // What differs between two draws does not depend on the colour and place alone.
            let value = |(a, b): (&[f64; 4], &[f64; 4])| {
                let codes = [0, 1, 2].map(|i| a[i] * largest[i]);
                let same = if a == b { 0.0 } else { 1e9 };
                [codes[0], codes[1], codes[2], same]
            };
            Ok(twice[0].iter().zip(&twice[1]).map(value).collect())
        })?;
    }
    Ok(())
}

/// Selects components by a mask of four bits.
fn masked(mask: u32, new: [f64; 4], old: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|i| if mask >> i & 1 == 1 { new[i] } else { old[i] })
}

fn set_mask(target: u32, mask: u32) {
    let [r, g, b, a] = [0, 1, 2, 3].map(|i| mask >> i & 1 == 1);
    glColorMaski(target, r, g, b, a);
}

fn color_mask(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("color-mask");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(48) {
        let masks: [[u32; 3]; 2] =
            std::array::from_fn(|_| std::array::from_fn(|_| rng.integer(0, 15) as u32));
        let clears = round % 2 == 1;
        let over = random_colors(&mut rng, PICTURE, [0.0, 1.0]);
        let (first, last) = ([0.125, 0.25, 0.5, 0.75], [0.875, 0.625, 0.375, 0.1875]);
        for target in 0..3usize {
            let expect = |pixel: Pixel, variant: Variant| {
                let source = if variant.has(Mutation::FirstTargetForAll) { 0 } else { target };
                let scale = 0.5f64.powi(target as i32);
                let color = over[at(pixel)].map(|c| f64::from(c) * scale);
                let drawn = masked(masks[0][source], color, first);
                let clear = clears && !variant.has(Mutation::MaskIgnoredByClear);
                Some(if clear {
                    masked(masks[1][source], last, drawn)
                } else if clears {
                    last
                } else {
                    drawn
                })
            };
            pictures.compare(&(masks, target), expect, |session| {
                session.frame(GL_RGBA32F, PICTURE, 0)?;
                for attachment in 1..3 {
                    session.add_color(attachment, GL_RGBA32F, PICTURE)?;
                }
                glDrawBuffers(3, &[0, 1, 2].map(|i| GL_COLOR_ATTACHMENT0 + i));
                window(PICTURE);
                glClearColor(first[0], first[1], first[2], first[3]);
                glClear(GL_COLOR_BUFFER_BIT);
                for index in 0..3 {
                    set_mask(index, masks[0][index as usize]);
                }
                session.show_textures(3)?;
                Brush::Texture.paint(PICTURE, &over);
                if clears {
                    for index in 0..3 {
                        set_mask(index, masks[1][index as usize]);
                    }
                    glClearColor(last[0], last[1], last[2], last[3]);
                    glClear(GL_COLOR_BUFFER_BIT);
                }
                glReadBuffer(GL_COLOR_ATTACHMENT0 + target as u32);
                session.read_floats(PICTURE)
            })?;
        }
    }
    pictures.finish(100, 90);
    Ok(())
}

fn draw_buffers(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("draw-buffers");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(48) {
        let over = random_colors(&mut rng, PICTURE, [0.0, 1.0]);
        // Which buffer each output goes to; 4 is none.
        let mut to = [0, 1, 2, 3usize];
        for i in (1..4).rev() {
            to.swap(i, rng.integer(0, i as i64) as usize);
        }
        to[rng.integer(0, 3) as usize] = 4;
        // Without a program the fragment's colour goes to all.
        let shader = round % 3 > 0;
        for buffer in 0..4usize {
            let expect = |pixel: Pixel, variant: Variant| {
                let output = if variant.has(Mutation::BuffersInOrder) {
                    Some(buffer)
                } else {
                    to.iter().position(|&b| b == buffer)
                };
                let scale =
                    output.map_or(0.0, |i| if shader { 0.5f64.powi(i as i32) } else { 1.0 });
                Some(over[at(pixel)].map(|c| f64::from(c) * scale))
            };
            pictures.compare(&(to, shader, buffer), expect, |session| {
                session.frame(GL_RGBA32F, PICTURE, 0)?;
                for attachment in 1..4 {
                    session.add_color(attachment, GL_RGBA32F, PICTURE)?;
                }
                let name =
                    |b: usize| if b == 4 { GL_NONE } else { GL_COLOR_ATTACHMENT0 + b as u32 };
                glDrawBuffers(4, &[0, 1, 2, 3].map(|i| GL_COLOR_ATTACHMENT0 + i));
                glClear(GL_COLOR_BUFFER_BIT);
                glDrawBuffers(4, &to.map(name));
                window(PICTURE);
                if shader {
                    session.show_textures(4)?;
                }
                Brush::Texture.paint(PICTURE, &over);
                glReadBuffer(GL_COLOR_ATTACHMENT0 + buffer as u32);
                session.read_floats(PICTURE)
            })?;
        }
    }
    pictures.finish(100, 50);
    Ok(())
}
