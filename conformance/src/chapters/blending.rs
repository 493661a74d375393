//! Blending into every kind of colour buffer: separate, several, of floats, sRGB-encoded.

use super::pictures::{Brush, Pictures, Pixel, random_colors, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::blend::{self, Colors, Equation, Factor};
use crate::oracle::format::{Base, Encoding, stored};
use crate::oracle::srgb;
use crate::probe::{ProbeError, Session, equation_enum, factor_enum};
use crate::rng::Rng;
use gl_api::constants::*;

/// Equations and factors of colour and alpha.
pub const SEPARATE: Check = Check {
    name: "blend-separate",
    citation: "GL 2.1, 4.1.8: glBlendEquationSeparate, glBlendFuncSeparate",
    what: "every pixel of random colours of floats beyond [0, 1] under random pairs of equations and factors",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 20) as f64,
    why: "f32: colours up to 2 times weights up to 3, which are rounded, as are the products and the sum: 2^-22 each",
    run: |harness, tally| blended(harness, tally, GL_RGBA32F),
};

/// The usual ways.
pub const USUAL: Check = Check {
    name: "blend-usual",
    citation: "GL 2.1, 4.1.8: the pairs of factors that programs use",
    what: "every pixel of random bytes under nine pairs of factors, added",
    unit: Unit::Bytes,
    tolerance: 0.5 + 1.0 / (1 << 14) as f64,
    why: "8-bit colours: half a step; f32: two products and a sum up to 2 are rounded by 2^-24 each, which is 2^-14 of 255",
    run: |harness, tally| blended(harness, tally, GL_RGBA8),
};

/// Pairs of factors that programs use, for which there may be code of their own.
const USUAL_PAIRS: [[Factor; 2]; 9] = {
    use Factor::{DstColor, One, OneMinusSrcAlpha, OneMinusSrcColor, SrcAlpha, SrcColor, Zero};
    [
        [SrcAlpha, OneMinusSrcAlpha],
        [One, OneMinusSrcAlpha],
        [SrcAlpha, One],
        [One, One],
        [DstColor, Zero],
        [Zero, SrcColor],
        [One, OneMinusSrcColor],
        [DstColor, SrcColor],
        [Zero, OneMinusSrcAlpha],
    ]
};

/// Blending into halves.
pub const HALF: Check = Check {
    name: "blend-half-float",
    citation: "GL 3.0, 4.1.7: without clamps into floats; 2.1.2: halves",
    what: "every pixel of random colours beyond [0, 1] blended into GL_RGBA16F, then rounded to the nearest half",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 9) as f64 + 1.0 / (1 << 20) as f64,
    why: "results up to 8 are rounded to 11 bits: half a step is 2^-9; f32: products and sum are rounded by 2^-22 each",
    run: |harness, tally| blended(harness, tally, GL_RGBA16F),
};

/// Blending into several targets.
pub const TARGETS: Check = Check {
    name: "blend-targets",
    citation: "GL 3.0, 4.1.7: glEnablei(GL_BLEND, i), each buffer with its own colour",
    what: "every pixel of four buffers, of which a random set blends",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 23) as f64,
    why: "f32: colours up to 1, each product and the sum rounded by up to 2^-24",
    run: targets,
};

/// Writing sRGB-encoded colours.
pub const SRGB_WRITTEN: Check = Check {
    name: "srgb-write",
    citation: "GL 3.0, 4.1.8, equation 4.2: cs from cl where GL_FRAMEBUFFER_SRGB is enabled",
    what: "every pixel of random and of dark colours in GL_SRGB8_ALPHA8, with and without the conversion",
    unit: Unit::Bytes,
    tolerance: 0.5 + 1.0 / (1 << 12) as f64,
    why: "8-bit colours: half a step; f32: linear values are rounded by 2^-24, which the encoding makes up to 12.92 times as much: 2^-12 of 255",
    run: |harness, tally| encoded(harness, tally, Mixing::Written),
};

/// Blending sRGB-encoded colours.
pub const SRGB_BLENDED: Check = Check {
    name: "srgb-blend",
    citation: "GL 3.0, 4.1.7: the destination is linear for blending where GL_FRAMEBUFFER_SRGB is enabled",
    what: "every pixel of half-transparent colours over others in GL_SRGB8_ALPHA8",
    unit: Unit::Bytes,
    tolerance: 0.5 + 1.0 / (1 << 12) as f64,
    why: "8-bit colours: half a step; f32: linear values are rounded by 2^-24, which the encoding makes up to 12.92 times as much: 2^-12 of 255",
    run: |harness, tally| encoded(harness, tally, Mixing::Blended),
};

const PICTURE: Pixel = [37, 29];

fn at([x, y]: Pixel) -> usize {
    y * PICTURE[0] + x
}

fn blended(harness: &Harness, tally: &mut Tally, internal: u32) -> Result<(), ProbeError> {
    let mut rng = Rng::named("blend-separate");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    let bytes = internal == GL_RGBA8;
    let range = if bytes { [0.0, 1.0] } else { [-1.0, 2.0] };
    for round in 0..harness.cases(120).max(9) {
        let usual = bytes || round % 3 == 0;
        let equations = if usual {
            [Equation::Add; 2]
        } else {
            [rng.pick(&Equation::ALL), Equation::ALL[round % 5]]
        };
        let mut pair = |k: usize| [Factor::ALL[(k * 7 + round) % 15], rng.pick(&Factor::ALL[..14])];
        let mut factors = [pair(0), pair(1)];
        if usual {
            factors = [USUAL_PAIRS[round / if bytes { 1 } else { 3 } % 9]; 2];
        }
        let mut under = random_colors(&mut rng, PICTURE, range);
        if bytes {
            for color in &mut under {
                *color = color.map(|c| (c * 255.0).round() / 255.0);
            }
        }
        let over = random_colors(&mut rng, PICTURE, range);
        let constant = [0.25, 0.5, 0.75, 0.375];
        let expect = |pixel: Pixel, variant: Variant| {
            let under = under[at(pixel)].map(f64::from);
            let half = |c: [f64; 4]| stored(Base::Rgba, Encoding::Half, c, Variant::CORRECT);
            let colors = Colors {
                source: over[at(pixel)].map(f64::from),
                destination: if internal == GL_RGBA16F { half(under) } else { under },
                constant,
            };
            let mixed = blend::separate(equations, factors, &colors, variant);
            let clamp = bytes || variant.has(Mutation::FloatsClamped);
            Some(if clamp { mixed.map(|c| c.clamp(0.0, 1.0)) } else { mixed })
        };
        pictures.compare(&(equations, factors), expect, |session| {
            session.frame(internal, PICTURE, 0)?;
            window(PICTURE);
            glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
            Brush::Texture.paint(PICTURE, &under);
            glEnable(GL_BLEND);
            glBlendColor(0.25, 0.5, 0.75, 0.375);
            let [rgb, alpha] = equations.map(equation_enum);
            glBlendEquationSeparate(rgb, alpha);
            let [[sr, dr], [sa, da]] = factors.map(|pair| pair.map(factor_enum));
            glBlendFuncSeparate(sr, dr, sa, da);
            Brush::of(round).paint(PICTURE, &over);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, if bytes { 70 } else { 80 });
    Ok(())
}

/// Binds a framebuffer of four buffers of floats, all of which are drawn to.
fn four(session: &Session, internal: [u32; 4]) -> Result<(), ProbeError> {
    session.frame(internal[0], PICTURE, 0)?;
    for (attachment, format) in (0..).zip(internal).skip(1) {
        session.add_color(attachment, format, PICTURE)?;
    }
    glDrawBuffers(4, &[0, 1, 2, 3].map(|i| GL_COLOR_ATTACHMENT0 + i));
    session.begin_frame(PICTURE)
}

fn targets(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("blend-targets");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(32) {
        let set = if round == 0 { 0b0110 } else { rng.integer(1, 14) as u32 };
        let (under, over) = (
            random_colors(&mut rng, PICTURE, [0.0, 1.0]),
            random_colors(&mut rng, PICTURE, [0.0, 1.0]),
        );
        for target in 0..4usize {
            let expect = |pixel: Pixel, variant: Variant| {
                let enabled = if variant.has(Mutation::FirstTargetForAll) { 0 } else { target };
                let scale = 0.5f64.powi(target as i32);
                let source = over[at(pixel)].map(|c| f64::from(c) * scale);
                if set >> enabled & 1 == 0 {
                    return Some(source);
                }
                let destination = under[at(pixel)].map(f64::from);
                let colors = Colors { source, destination, constant: [0.0; 4] };
                let over = [Factor::SrcAlpha, Factor::OneMinusSrcAlpha];
                Some(blend::unclamped(Equation::Add, over, &colors, variant))
            };
            pictures.compare(&(set, target), expect, |session| {
                four(session, [GL_RGBA32F; 4])?;
                window(PICTURE);
                Brush::Texture.paint(PICTURE, &under);
                for index in 0..4 {
                    if set >> index & 1 == 1 {
                        glEnablei(GL_BLEND, index);
                    }
                }
                glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                session.show_textures(4)?;
                Brush::Texture.paint(PICTURE, &over);
                glUseProgram(0);
                glReadBuffer(GL_COLOR_ATTACHMENT0 + target as u32);
                session.read_floats(PICTURE)
            })?;
        }
    }
    pictures.finish(100, 90);
    Ok(())
}

/// What is done with encoded colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mixing {
    Written,
    Blended,
}

fn encoded(harness: &Harness, tally: &mut Tally, mixing: Mixing) -> Result<(), ProbeError> {
    let mut rng = Rng::named("srgb-write");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(32) {
        // Every fourth round about the end of the linear part.
        let most = if round % 4 == 1 { 0.008 } else { 1.0 };
        let converts = mixing == Mixing::Blended || round % 4 != 2;
        let under: Vec<[f32; 4]> = (0..PICTURE[0] * PICTURE[1])
            .map(|_| [0; 4].map(|_: i32| f32::from(rng.byte()) / 255.0))
            .collect();
        let over = random_colors(&mut rng, PICTURE, [0.0, most]);
        let expect = |pixel: Pixel, variant: Variant| {
            let source = over[at(pixel)].map(f64::from);
            let encode = |[r, g, b, a]: [f64; 4]| {
                let encode = |l: f64| {
                    if variant.has(Mutation::SrgbGamma22) {
                        l.powf(1.0 / 2.2)
                    } else {
                        srgb::encode(l)
                    }
                };
                [encode(r), encode(g), encode(b), a]
            };
            Some(match mixing {
                Mixing::Written if converts != variant.has(Mutation::SrgbUndecoded) => {
                    encode(source)
                }
                Mixing::Written => source,
                Mixing::Blended => {
                    // What is there was written as codes.
                    let code = under[at(pixel)].map(|c| (f64::from(c) * 255.0).round() / 255.0);
                    let destination = srgb::decode_texel(code, variant);
                    let colors = Colors { source, destination, constant: [0.0; 4] };
                    let over = [Factor::SrcAlpha, Factor::OneMinusSrcAlpha];
                    encode(blend::blend(Equation::Add, over, &colors, variant))
                }
            })
        };
        pictures.compare(&(mixing, converts), expect, |session| {
            session.frame(GL_SRGB8_ALPHA8, PICTURE, 0)?;
            window(PICTURE);
            glDisable(GL_DITHER);
            if mixing == Mixing::Blended {
                Brush::Texture.paint(PICTURE, &under);
                glEnable(GL_BLEND);
                glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
            }
            if converts {
                glEnable(GL_FRAMEBUFFER_SRGB);
            }
            Brush::of(round).paint(PICTURE, &over);
            session.read_bytes(PICTURE)
        })?;
    }
    pictures.finish(100, 80);
    Ok(())
}
