//! Copies between framebuffers and to textures.

use super::pictures::{Brush, Pictures, Pixel, all, random_colors, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::blit::{Span, source};
use crate::oracle::format::Base;
use crate::oracle::painter::Rect;
use crate::probe::{ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;

/// Nearest copies.
pub const NEAREST: Check = Check {
    name: "blit-nearest",
    citation: "GL 3.0, 4.3.2: glBlitFramebuffer, GL_NEAREST; rectangles flip and scale; scissor",
    what: "every pixel of copies between random rectangles, flipped, enlarged and reduced, under a scissor box",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "floats are copied; places near the edge of a source pixel are left out",
    run: |harness, tally| blit(harness, tally, BlitMode::Nearest),
};

/// Linear copies.
pub const LINEAR: Check = Check {
    name: "blit-linear",
    citation: "GL 3.0, 4.3.2 and 3.8.8: glBlitFramebuffer, GL_LINEAR",
    what: "every pixel of copies between random rectangles, not within half a pixel of the source's outline",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 24) as f64,
    why: "f32: weighted sums up to 1 are rounded by 2^-25, on two axes",
    run: |harness, tally| blit(harness, tally, BlitMode::Linear),
};

/// Copies of depth and stencil.
pub const DEPTH_STENCIL: Check = Check {
    name: "blit-depth-stencil",
    citation: "GL 3.0, 4.3.2: depth and stencil are copied as they are, GL_NEAREST",
    what: "depth and stencil of every pixel after copies between random rectangles",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "words are copied; places near the edge of a source pixel are left out",
    run: |harness, tally| blit(harness, tally, BlitMode::DepthStencil),
};

/// Copies to textures.
pub const COPY_TEXTURE: Check = Check {
    name: "copy-texture",
    citation: "GL 2.1, 3.8.2: glCopyTexImage2D, glCopyTexSubImage2D; table 3.15",
    what: "every texel of textures of six base formats after copies of random rectangles into them",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "floats are copied",
    run: copy_texture,
};

const PICTURE: Pixel = [41, 33];

fn at([x, y]: Pixel) -> usize {
    y * PICTURE[0] + x
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum BlitMode {
    Nearest,
    Linear,
    DepthStencil,
}

/// A span of at least four pixels of an axis.
fn span(rng: &mut Rng, size: usize) -> Span {
    loop {
        let [a, b] = [0; 2].map(|_: i32| rng.integer(0, size as i64));
        if (a - b).abs() >= 4 {
            return Span { low: a, high: b };
        }
    }
}

/// Framebuffers of the source and of the destination, and the buffers that are copied.
fn bind_pair(
    session: &Session,
    draw: impl FnOnce() -> Result<(), ProbeError>,
) -> Result<(), ProbeError> {
    let frame = || session.deep_frame(GL_RGBA32F, GL_DEPTH24_STENCIL8, PICTURE, 0);
    frame()?;
    draw()?;
    let mut source = [0i32; 1];
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &mut source);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    frame()?;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source[0]);
    session.check("drawing what is copied")
}

fn blit(harness: &Harness, tally: &mut Tally, mode: BlitMode) -> Result<(), ProbeError> {
    let mut rng = Rng::named("blit");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(64).max(16) {
        let (from, to) = (PICTURE.map(|n| span(&mut rng, n)), PICTURE.map(|n| span(&mut rng, n)));
        let to = if round % 4 == 0 { from } else { to };
        let colors = random_colors(&mut rng, PICTURE, [0.0, 1.0]);
        let low = [rng.integer(0, 12) as usize, rng.integer(0, 9) as usize];
        let scissor = Rect { low, size: [25, 21] };
        // Depths of 16 bits, so that 24 bits and floats hold them; stencil values.
        let value = |pixel: Pixel| match mode {
            BlitMode::Nearest | BlitMode::Linear => colors[at(pixel)].map(f64::from),
            BlitMode::DepthStencil => [depth_of(pixel), stencil_of(pixel), 0.0, 0.0],
        };
        let empty = if mode == BlitMode::DepthStencil { [1.0, 0.0, 0.0, 0.0] } else { [0.0; 4] };
        let expect = |pixel: Pixel, variant: Variant| {
            let cut = scissor.has(pixel) || variant.has(Mutation::ScissorIgnored);
            if !(0..2).all(|i| to[i].has(pixel[i])) || !cut {
                return Some(empty);
            }
            let place = [0, 1].map(|i| source(from[i], to[i], pixel[i], variant));
            match mode {
                BlitMode::Nearest | BlitMode::DepthStencil => {
                    let near = place.iter().any(|c| (c - c.round()).abs() < 1e-4);
                    (!near).then(|| value(place.map(|c| c.floor() as usize)))
                }
                BlitMode::Linear => {
                    let inner = (0..2).all(|i| {
                        let (a, b) = (from[i].low.min(from[i].high), from[i].low.max(from[i].high));
                        (a as f64 + 0.5..=b as f64 - 0.5).contains(&place[i])
                    });
                    inner.then(|| bilinear(place, value))
                }
            }
        };
        pictures.compare(&(from, to, scissor), expect, |session| {
            bind_pair(session, || {
                window(PICTURE);
                Brush::Texture.paint(PICTURE, &colors);
                if mode == BlitMode::DepthStencil {
                    glDisable(GL_TEXTURE_2D);
                    draw_depths(session)?;
                }
                Ok(())
            })?;
            glClearStencil(0);
            glClearDepth(1);
            glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
            glEnable(GL_SCISSOR_TEST);
            let ([x, y], [w, h]) = (scissor.low, scissor.size);
            glScissor(x as i32, y as i32, w, h);
            let [[x0, x1], [y0, y1]] = from.map(|s| [s.low as i32, s.high as i32]);
            let [[u0, u1], [v0, v1]] = to.map(|s| [s.low as i32, s.high as i32]);
            let (mask, filter) = match mode {
                BlitMode::Nearest => (GL_COLOR_BUFFER_BIT, GL_NEAREST),
                BlitMode::Linear => (GL_COLOR_BUFFER_BIT, GL_LINEAR),
                BlitMode::DepthStencil => (GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST),
            };
            glBlitFramebuffer(x0, y0, x1, y1, u0, v0, u1, v1, mask, filter);
            let mut target = [0i32; 1];
            glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &mut target);
            glBindFramebuffer(GL_READ_FRAMEBUFFER, target[0]);
            if mode != BlitMode::DepthStencil {
                return session.read_floats(PICTURE);
            }
            let mut depths = session.read_depth_codes(PICTURE)?;
            // The same numbers as expected: codes of 24 bits.
            depths.iter_mut().for_each(|depth| *depth = (*depth * LARGEST).round() / LARGEST);
            let stencil = session.read_stencil(PICTURE)?;
            Ok(depths.into_iter().zip(stencil).map(|(d, s)| [d, s[0], 0.0, 0.0]).collect())
        })?;
    }
    pictures.finish(if mode == BlitMode::Linear { 60 } else { 75 }, 10);
    Ok(())
}

const LARGEST: f64 = 16_777_215.0;

fn depth_of([x, y]: Pixel) -> f64 {
    ((x * 401 + y * 16_411) * 8) as f64 / LARGEST
}

fn stencil_of([x, y]: Pixel) -> f64 {
    ((x * 7 + y * 13) % 256) as f64
}

/// Draws the depths and stencil values with glDrawPixels.
fn draw_depths(session: &Session) -> Result<(), ProbeError> {
    let depths: Vec<f32> = all(PICTURE).map(|pixel| depth_of(pixel) as f32).collect();
    let values: Vec<u8> = all(PICTURE).map(|pixel| stencil_of(pixel) as u8).collect();
    glWindowPos2i(0, 0);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    let [w, h] = PICTURE;
    glDrawPixels(w, h, GL_DEPTH_COMPONENT, GL_FLOAT, &depths);
    glDrawPixels(w, h, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &values);
    session.check("drawing depths and stencil values")
}

/// Between the four pixels about a place.
fn bilinear(place: [f64; 2], value: impl Fn(Pixel) -> [f64; 4]) -> [f64; 4] {
    let base = place.map(|c| (c - 0.5).floor());
    let weight = [0, 1].map(|i| place[i] - 0.5 - base[i]);
    let mut sum = [0.0; 4];
    for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        let part = |i: usize, d: usize| if d == 1 { weight[i] } else { 1.0 - weight[i] };
        let weight = part(0, dx) * part(1, dy);
        if weight > 0.0 {
            let texel = value([base[0] as usize + dx, base[1] as usize + dy]);
            sum = std::array::from_fn(|i| sum[i] + weight * texel[i]);
        }
    }
    sum
}

fn copy_texture(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("copy-texture");
    let formats = [
        (GL_RGBA32F, Base::Rgba),
        (GL_RGB32F, Base::Rgb),
        (GL_R32F, Base::Red),
        (GL_LUMINANCE32F_ARB, Base::Luminance),
        (GL_ALPHA32F_ARB, Base::Alpha),
        (GL_LUMINANCE_ALPHA32F_ARB, Base::LuminanceAlpha),
    ];
    let size = [19, 17];
    let mut pictures = Pictures::new(harness, tally, size);
    for round in 0..harness.cases(48).max(6) {
        let (internal, base) = formats[round % 6];
        let colors = random_colors(&mut rng, PICTURE, [0.0, 1.0]);
        let first = [rng.integer(0, 20) as usize, rng.integer(0, 14) as usize];
        // Then a part of it from elsewhere.
        let low = [rng.integer(0, 10) as usize, rng.integer(0, 8) as usize];
        let part = Rect { low, size: [rng.integer(1, 8) as usize, rng.integer(1, 8) as usize] };
        let second = [rng.integer(0, 30) as usize, rng.integer(0, 20) as usize];
        let expect = |pixel: Pixel, variant: Variant| {
            let swapped = variant.has(Mutation::RowsUpsideDown);
            let from = if part.has(pixel) {
                let y = pixel[1] - low[1];
                let y = if swapped { part.size[1] - 1 - y } else { y };
                [second[0] + pixel[0] - low[0], second[1] + y]
            } else {
                let y = if swapped { size[1] - 1 - pixel[1] } else { pixel[1] };
                [first[0] + pixel[0], first[1] + y]
            };
            let color = colors[at(from)].map(f64::from);
            let mut c = [0.0; 4];
            for (channel, &source) in c.iter_mut().zip(base.sources()) {
                *channel = color[source];
            }
            Some(base.queried(c, variant))
        };
        pictures.compare(&(enum_name(internal), part), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            Brush::Texture.paint(PICTURE, &colors);
            let target = GL_TEXTURE_2D;
            glBindTexture(target, 5);
            let [x, y] = first.map(|c| c as i32);
            glCopyTexImage2D(target, 0, internal, x, y, size[0], size[1], 0);
            let ([u, v], [w, h]) = (part.low.map(|c| c as i32), part.size);
            let [x, y] = second.map(|c| c as i32);
            glCopyTexSubImage2D(target, 0, u, v, x, y, w, h);
            session.check("copying to a texture")?;
            session.level_texels(target, 0, [size[0], size[1], 1])
        })?;
    }
    pictures.finish(100, 90);
    Ok(())
}
