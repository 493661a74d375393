//! Texels that meet colours or texels of another texture, over whole pictures: what draws of large shapes compute without
//! storing each lookup.

use super::pictures::{Pictures, Pixel};
use super::texture_pictures::{Given, Lookup, Map, PICTURE, image, mipmapped, repeating};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::lod::{Derivatives, Filter, Filters, Mipmap};
use crate::oracle::sample;
use crate::oracle::texture::Level;
use crate::oracle::wrap::Wrap;
use crate::probe::{ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;

/// Textures under `GL_MODULATE`.
pub const MODULATED: Check = Check {
    name: "picture-modulated",
    citation: "GL 2.1, 3.8.13, table 3.17: GL_MODULATE, C = C_f C_s and A = A_f A_s",
    what: "every pixel of two shapes of one draw, each of one colour or of a colour at each corner, over textures of 5 kinds",
    unit: Unit::Bytes,
    tolerance: 0.51,
    why: "8-bit colours: half a step; f32 coordinates of up to 512 texels: 2^-13 of 255 in each of two weights",
    run: modulated,
};

/// Two textures at one place.
pub const TWO_TEXTURES: Check = Check {
    name: "picture-two-textures",
    citation: "GL 2.1, 3.8.8 and 3.8.15: each unit has a texture and filters of its own",
    what: "every pixel of the mean of two textures of one size at the same coordinates, across their edges, under 3 wrap modes",
    unit: Unit::Bytes,
    tolerance: 0.51,
    why: "8-bit colours: half a step; f32 coordinates of up to 512 texels: 2^-13 of 255 in each of two weights",
    run: two_textures,
};

/// Filters and sizes in turn: linear on one level, on two, and nearest.
fn setting(round: usize) -> ([usize; 2], Filters) {
    let size = [[512, 512], [64, 64], [256, 128], [33, 17], [16, 16]][round % 5];
    let filters = [Filters::only(Filter::Linear), mipmapped(Filter::Linear, Mipmap::Linear)];
    (size, filters[round / 5 % 2])
}

/// The texel of a map's place.
fn texel(image: &[Level], sampler: &sample::Sampler, map: &Map, p: Pixel, v: Variant) -> [f64; 4] {
    let derivatives = Derivatives { dx: map.dx, dy: map.dy };
    sample::sample(image, sampler, map.of(p), &derivatives, v)
}

/// The λ of a round: within the levels.
fn lambda(rng: &mut Rng, image: &[Level]) -> f64 {
    f64::from(rng.real(-2.0, (image.len() as f64 - 1.5).clamp(0.5, 3.0)))
}

fn modulated(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("picture-modulated");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(60).max(20) {
        let (size, filters) = setting(round);
        let image = image(&mut rng, size, filters);
        let sampler = repeating(&image, filters);
        let lambda = lambda(&mut rng, &image);
        let map = Map::random(&mut rng, size, lambda);
        // The left and the right part of the picture, which meet at a whole column.
        let column = rng.integer(9, PICTURE[0] as i64 - 9) as usize;
        let is_flat = [0; 2].map(|_: i32| rng.byte() < 128);
        let mut color = || [0; 4].map(|_: i32| rng.dyadic(0.0, 1.0, 1.0 / 256.0));
        let colors = [[color(), color()], [color(), color()]];
        // From the lower to the upper edge.
        let color = |[x, y]: Pixel| -> [f64; 4] {
            let part = usize::from(x >= column);
            let [low, high] = colors[part].map(|color| color.map(f64::from));
            let t = if is_flat[part] { 0.0 } else { (y as f64 + 0.5) / PICTURE[1] as f64 };
            std::array::from_fn(|i| low[i] + t * (high[i] - low[i]))
        };
        let expect = |pixel: Pixel, variant: Variant| {
            let texel = texel(&image, &sampler, &map, pixel, variant);
            let color = color(pixel);
            Some(match variant.has(Mutation::ModulateReplaces) {
                true => texel,
                false => std::array::from_fn(|i| texel[i] * color[i]),
            })
        };
        let by = [Lookup::Fixed, Lookup::Shader][round / 2 % 2];
        pictures.compare(&(size, filters, map, column, colors, by), expect, |session| {
            session.frame(GL_RGBA8, PICTURE, 0)?;
            session.texture_2d(&image, &sampler)?;
            match by {
                Lookup::Fixed => {
                    by.prepare(session)?;
                    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
                }
                Lookup::Shader => session.fragment_only(
                    "uniform sampler2D image;
                    void main() { gl_FragColor = gl_Color * texture2D(image, gl_TexCoord[0].xy); }",
                )?,
            }
            let [width, height] = PICTURE;
            glMatrixMode(GL_PROJECTION);
            glOrtho(0, width as f64, 0, height as f64, -1, 1);
            glBegin(GL_QUADS);
            for (part, [left, right]) in [[0, column], [column, width]].into_iter().enumerate() {
                for ([x, y], row) in
                    [([left, 0], 0), ([right, 0], 0), ([right, height], 1), ([left, height], 1)]
                {
                    let row = if is_flat[part] { 0 } else { row };
                    let [r, g, b, a] = colors[part][row];
                    glColor4f(r, g, b, a);
                    let [s, t] = map.at_corner([x, y]);
                    glTexCoord2d(s, t);
                    glVertex2d(x as f64, y as f64);
                }
            }
            glEnd();
            session.read_bytes(PICTURE)
        })?;
    }
    pictures.finish(95, 80);
    Ok(())
}

fn two_textures(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("picture-two-textures");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(60).max(20) {
        let (size, filters) = setting(round);
        let images = [0; 2].map(|_: i32| image(&mut rng, size, filters));
        let mut sampler = repeating(&images[0], filters);
        let wrap = [Wrap::Repeat, Wrap::ClampToEdge, Wrap::MirroredRepeat][round % 3];
        sampler.at.wrap = [wrap; 2];
        let lambda = lambda(&mut rng, &images[0]);
        let map = Map::random(&mut rng, size, lambda);
        let expect = |pixel: Pixel, variant: Variant| {
            let second = usize::from(!variant.has(Mutation::SecondUnitIsFirst));
            let [a, b] = [0, second].map(|of| texel(&images[of], &sampler, &map, pixel, variant));
            Some(std::array::from_fn(|i| 0.5 * (a[i] + b[i])))
        };
        pictures.compare(&(size, filters, wrap, map), expect, |session| {
            session.frame(GL_RGBA8, PICTURE, 0)?;
            two_units(session, &images, &sampler)?;
            map.draw(Given::Immediate);
            session.read_bytes(PICTURE)
        })?;
    }
    pictures.finish(95, 80);
    Ok(())
}

/// Two textures of this state on the first two units, and a shader that mixes them.
fn two_units(
    session: &Session,
    images: &[Vec<Level>; 2],
    sampler: &sample::Sampler,
) -> Result<(), ProbeError> {
    session.texture_2d(&images[0], sampler)?;
    session.second_texture_2d(&images[1], sampler)?;
    session.fragment_only(
        "uniform sampler2D first, second;
        void main() {
            vec2 st = gl_TexCoord[0].xy;
            gl_FragColor = 0.5 * (texture2D(first, st) + texture2D(second, st));
        }",
    )?;
    session.sampler_units(&["first", "second"])
}
