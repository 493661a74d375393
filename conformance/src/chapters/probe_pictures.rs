//! The anisotropic filter of probes, which images take that are not plane or have a border: every pixel of whole squares.

use super::pictures::{Pictures, Pixel};
use super::texture_pictures::{Given, Map, PICTURE, image, mipmapped, repeating};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::lod::{Filter, Filters, Mipmap};
use crate::oracle::probes::{Row, row};
use crate::oracle::sample::at_lambda;
use crate::oracle::wrap::Wrap;
use crate::probe::{ProbeError, Session, wrap_enum};
use crate::rng::Rng;
use gl_api::constants::*;

/// Probes in a row.
pub const PROBES: Check = Check {
    name: "picture-anisotropic-probes",
    citation: "EXT_texture_filter_anisotropic (scheme: DetGL's, oracle/probes.rs)",
    what: "every pixel of turned and stretched squares of random texels under limits 2 to 16: arrays, 3D images, plane ones with a border",
    unit: Unit::FullScale,
    tolerance: TOLERANCE,
    why: WHY,
    run: probes,
};

/// √2 · 2^-16.
const TOLERANCE: f64 = std::f64::consts::SQRT_2 / (1 << 16) as f64;
const WHY: &str = "f32: coordinates below 8 are rounded by 2^-22, times 64 texels, in each of two axes: the root of the sum of squares, of a difference of texels up to 1; what the roundings of steps and λ add, the mean of probes and levels takes";

const SIDE: usize = 64;
/// Slices of the image in three dimensions, each of which is the same.
const DEPTH: usize = 32;

const FILTERS: Filters = mipmapped(Filter::Linear, Mipmap::Linear);

/// r as a sum of s and t, of the image in three dimensions.
const SLANT: [f32; 2] = [0.375, -0.25];

/// Nearer to another number of probes than this, rounding decides between two.
const OPEN: f64 = 0.01;

/// Coordinates stay below this, in which f32 has steps of 2^-21.
const FARTHEST: f64 = 8.0;

/// Footprints that are flatter have a `σ₂` that is rounding error.
const FLATTEST: f64 = 12.0;

/// What is sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Image {
    Array,
    Solid,
    Bordered,
}

impl Image {
    fn target(self) -> u32 {
        match self {
            Self::Array => GL_TEXTURE_2D_ARRAY,
            Self::Solid => GL_TEXTURE_3D,
            Self::Bordered => GL_TEXTURE_2D,
        }
    }

    fn shader(self) -> String {
        let (sampler, at) = match self {
            Self::Array => ("sampler2DArray", "vec3(st, 0.0)".to_owned()),
            Self::Solid => {
                let [a, b] = SLANT;
                ("sampler3D", format!("vec3(st, {a:?} * st.x + {b:?} * st.y)"))
            }
            Self::Bordered => ("sampler2D", "st".to_owned()),
        };
        format!(
            "#version 130
            uniform {sampler} image;
            void main() {{ vec2 st = gl_TexCoord[0].xy; gl_FragColor = texture(image, {at}); }}"
        )
    }

    /// The derivatives of texels of a map's.
    fn texels(self, [s, t]: [f64; 2]) -> [f64; 3] {
        let r = SLANT[0] as f64 * s + SLANT[1] as f64 * t;
        let depth = if self == Self::Solid { DEPTH as f64 } else { 0.0 };
        [s * SIDE as f64, t * SIDE as f64, r * depth]
    }
}

/// A map whose footprints have one number of probes, however they are rounded.
fn map(rng: &mut Rng, of: Image, limit: usize) -> (Map, Row) {
    loop {
        let lambda = f64::from(rng.real(-0.5, 1.5));
        let mut map = Map::random(rng, [SIDE; 2], lambda);
        let stretch = f64::from(rng.real(1.0, 10.0));
        map.dx = map.dx.map(|d| d * stretch);
        let [dx, dy] = [map.dx, map.dy].map(|d| of.texels(d));
        let row = row(dx, dy, limit, Variant::CORRECT);
        let is_flat = row.count == limit && row.nearest > FLATTEST - limit as f64;
        map.place([0.5; 2]);
        let corners = [[0, 0], [PICTURE[0], 0], PICTURE, [0, PICTURE[1]]];
        let farthest = corners.iter().flat_map(|corner| map.at_corner(*corner)).map(f64::abs);
        let is_near = farthest.fold(0.0, f64::max) < FARTHEST - 1.0;
        if row.nearest > OPEN && !is_flat && is_near {
            return (map, row);
        }
    }
}

fn probes(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("picture-anisotropic-probes");
    let (mut counts, mut rounds) = (Vec::new(), 0);
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(36).max(9) {
        let of = [Image::Array, Image::Solid, Image::Bordered][round % 3];
        let limit = [2, 4, 8, 16][round / 3 % 4];
        let image = image(&mut rng, [SIDE; 2], FILTERS);
        let mut sampler = repeating(&image, FILTERS);
        if of == Image::Bordered {
            sampler.at.wrap = [Wrap::Repeat, Wrap::ClampToBorder];
            sampler.at.border = [0.25, 0.5, 1.0, 0.0];
        }
        let (map, row_of_map) = map(&mut rng, of, limit);
        counts.push(row_of_map.count);
        rounds += 1;
        let [dx, dy] = [map.dx, map.dy].map(|d| of.texels(d));
        let expect = |pixel: Pixel, variant: Variant| {
            let st = map.of(pixel);
            let Row { count, step, lambda, .. } = row(dx, dy, limit, variant);
            let mut sum = [0.0; 4];
            for probe in 0..count {
                let at = probe as f64 - (count - 1) as f64 / 2.0;
                let st = [0, 1].map(|i| st[i] + at * step[i] / SIDE as f64);
                let texel = at_lambda(&image, &sampler, st, lambda, variant);
                (0..4).for_each(|c| sum[c] += texel[c] / count as f64);
            }
            Some(sum)
        };
        pictures.compare(&(of, map, limit), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            upload(session, of, &image, &sampler)?;
            glTexParameterf(of.target(), GL_TEXTURE_MAX_ANISOTROPY_EXT, limit as f32);
            session.fragment_only(&of.shader())?;
            map.draw(Given::Immediate);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 60);
    let several = counts.iter().filter(|count| **count > 1).count();
    tally.reach("pictures of several probes", several, rounds / 2);
    Ok(())
}

fn upload(
    session: &Session,
    of: Image,
    image: &[crate::oracle::texture::Level],
    sampler: &crate::oracle::sample::Sampler,
) -> Result<(), ProbeError> {
    let target = of.target();
    let slices = |level: usize| match of {
        Image::Array => 1,
        Image::Solid => (DEPTH >> level).max(1),
        Image::Bordered => 0,
    };
    if of == Image::Bordered {
        return session.texture_2d(image, sampler);
    }
    glBindTexture(target, 1);
    for (number, level) in image.iter().enumerate() {
        let (w, h, depth) = (level.width, level.height, slices(number));
        let texels = level.texels.as_flattened().repeat(depth);
        let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
        glTexImage3D(target, number, GL_RGBA8, w, h, depth, 0, format, ty, &texels);
    }
    let [s, t] = sampler.at.wrap.map(wrap_enum);
    for (name, value) in [
        (GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR),
        (GL_TEXTURE_WRAP_S, s),
        (GL_TEXTURE_WRAP_T, t),
        (GL_TEXTURE_WRAP_R, GL_REPEAT),
    ] {
        glTexParameteri(target, name, value);
    }
    session.check("making an image")
}
