//! Textures as pictures show them: every pixel of whole squares, through the lookups that a picture takes (the fixed
//! function and a plain shader, into bytes), of sizes to 4096.

use super::pictures::{Pictures, Pixel};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{self, Derivatives, Filter, Filters, LevelRange, LodState, Mipmap};
use crate::oracle::sample::{self, Sampler};
use crate::oracle::texture::{Level, level_count, level_size};
use crate::oracle::wrap::Wrap;
use crate::probe::{ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;
use std::collections::BTreeSet;
use std::fmt::Debug;

/// One level, linear.
pub const LINEAR: Check = Check {
    name: "picture-linear",
    citation: "GL 2.1, 3.8.8: GL_LINEAR",
    what: "every pixel of turned squares with textures of 13 sizes from 1×1 to 4096×16, magnified and minified",
    unit: Unit::Bytes,
    tolerance: 0.56,
    why: WHY,
    run: |harness, tally| affine(harness, tally, &[Filters::only(Filter::Linear)]),
};

/// One level, nearest.
pub const NEAREST: Check = Check {
    name: "picture-nearest",
    citation: "GL 2.1, 3.8.8: GL_NEAREST",
    what: "every pixel of turned squares with textures of 13 sizes; places near the edge of a texel are left out",
    unit: Unit::Bytes,
    tolerance: 0.0,
    why: "bytes are copied",
    run: |harness, tally| affine(harness, tally, &[Filters::only(Filter::Nearest)]),
};

/// Two levels, linear.
pub const TRILINEAR: Check = Check {
    name: "picture-trilinear",
    citation: "GL 2.1, 3.8.8: GL_LINEAR_MIPMAP_LINEAR",
    what: "every pixel of turned squares, levels that have nothing in common, λ from -1 to the last level",
    unit: Unit::Bytes,
    tolerance: 0.51,
    why: WHY,
    run: |harness, tally| affine(harness, tally, &[mipmapped(Filter::Linear, Mipmap::Linear)]),
};

/// The other mipmap filters.
pub const MIPMAPS: Check = Check {
    name: "picture-mipmaps",
    citation: "GL 2.1, 3.8.8: GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR",
    what: "every pixel of turned squares, levels that have nothing in common; ties of texels and levels are left out",
    unit: Unit::Bytes,
    tolerance: 0.51,
    why: WHY,
    run: |harness, tally| {
        let filters = [
            mipmapped(Filter::Nearest, Mipmap::Nearest),
            mipmapped(Filter::Linear, Mipmap::Nearest),
            mipmapped(Filter::Nearest, Mipmap::Linear),
        ];
        affine(harness, tally, &filters)
    },
};

/// In perspective.
pub const PERSPECTIVE: Check = Check {
    name: "picture-perspective",
    citation: "GL 2.1, 3.8.8 and 3.5.1: λ and coordinates of a floor, of which each pixel has its own",
    what: "every pixel of floors with trilinear textures of 512, 1024 and 2048",
    unit: Unit::Bytes,
    tolerance: 0.502,
    why: "8-bit colours: half a step; and f32 coordinates of up to 2048 texels, 2^-13 of 255 in each of two weights; λ may be that of a difference or of a derivative",
    run: perspective,
};

const WHY: &str = "8-bit colours: half a step; and f32 coordinates of up to 4096 texels: 2^-13 of 255 in each of two weights";

pub(super) const PICTURE: Pixel = [99, 67];

/// Powers of two, odd sizes, rows.
const SIZES: [[usize; 2]; 13] = [
    [512, 512],
    [17, 33],
    [1024, 256],
    [64, 64],
    [2048, 512],
    [1, 1],
    [2048, 2048],
    [5, 3],
    [4096, 16],
    [1000, 30],
    [256, 256],
    [1, 128],
    [8, 4096],
];

pub(super) const fn mipmapped(min: Filter, mipmap: Mipmap) -> Filters {
    Filters { min, mipmap, mag: min }
}

/// Levels that have nothing in common.
pub(super) fn image(rng: &mut Rng, size: [usize; 2], filters: Filters) -> Vec<Level> {
    let count = if filters.mipmap == Mipmap::None { 1 } else { level_count(size) };
    (0..count)
        .map(|level| {
            let [w, h] = level_size(size, level);
            let seed = u64::from(rng.byte()) << 8 | level as u64;
            Level::from_fn(w, h, |i, j| {
                let mixed =
                    (seed << 40 ^ (j as u64) << 20 ^ i as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
                let [a, b, c, d, ..] =
                    (mixed ^ mixed >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9).to_be_bytes();
                [a, b, c, d]
            })
        })
        .collect()
}

/// s and t as affine functions of window coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Map {
    at: [f64; 2],
    pub dx: [f64; 2],
    pub dy: [f64; 2],
}

impl Map {
    /// Turned, with a scale of 2^λ texels a pixel.
    pub fn random(rng: &mut Rng, size: [usize; 2], lambda: f64) -> Self {
        let turn = f64::from(rng.real(0.0, 6.2));
        let (sin, cos) = turn.sin_cos();
        let scale = lambda.exp2();
        let texels = |x: f64, y: f64| [x * scale / size[0] as f64, y * scale / size[1] as f64];
        let narrow = f64::from(rng.real(0.5, 1.0));
        Self {
            at: [0; 2].map(|_: i32| f64::from(rng.real(0.0, 1.0))),
            dx: texels(cos, sin),
            dy: texels(-sin * narrow, cos * narrow),
        }
    }

    fn st(&self, x: f64, y: f64) -> [f64; 2] {
        [0, 1].map(|i| self.at[i] + self.dx[i] * x + self.dy[i] * y)
    }

    /// s and t of a pixel's centre, with coordinates from the middle of the picture.
    pub fn of(&self, [x, y]: Pixel) -> [f64; 2] {
        let [w, h] = PICTURE.map(|n| n as f64);
        self.st(x as f64 + 0.5 - w / 2.0, y as f64 + 0.5 - h / 2.0)
    }

    /// Moves the middle of the picture to this place of the texture.
    pub fn place(&mut self, at: [f64; 2]) {
        self.at = at;
    }

    /// s and t of a corner of pixels.
    pub fn at_corner(&self, [x, y]: Pixel) -> [f64; 2] {
        let [w, h] = PICTURE.map(|n| n as f64);
        self.st(x as f64 - w / 2.0, y as f64 - h / 2.0)
    }

    /// Draws a square with these coordinates, which fills the picture.
    pub fn draw(&self, given: Given) {
        let [w, h] = PICTURE.map(|n| n as f64 / 2.0);
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        given.draw(corners.map(|[x, y]| {
            let [s, t] = self.st(x * w, y * h);
            ([s, t, 0.0, 1.0], [x, y])
        }));
    }
}

/// Whether a nearest filter has two answers for a place on a level.
fn tie(level: &Level, st: [f64; 2]) -> bool {
    let size = [level.width, level.height];
    (0..2).any(|i| {
        let texels = st[i] * size[i] as f64;
        (texels - texels.round()).abs() < 1e-5 * size[i] as f64 + 1e-4
    })
}

fn affine(harness: &Harness, tally: &mut Tally, filters: &[Filters]) -> Result<(), ProbeError> {
    let mut rng = Rng::named("texture-pictures");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(52).max(SIZES.len()) {
        let size = SIZES[round % SIZES.len()];
        let filters = filters[round % filters.len()];
        let image = image(&mut rng, size, filters);
        let last = image.len() - 1;
        let most = if filters.mipmap == Mipmap::None { 1.0 } else { last as f64 + 0.5 };
        let lambda = f64::from(rng.real(-1.0, most));
        let map = Map::random(&mut rng, size, lambda);
        let sampler = Sampler {
            at: Addressing {
                wrap: [0; 2].map(|_: i32| {
                    rng.pick(&[Wrap::Repeat, Wrap::ClampToEdge, Wrap::MirroredRepeat])
                }),
                border: [0.0; 4],
            },
            filters,
            lod: LodState::default(),
            range: LevelRange { base: 0, last },
        };
        let derivatives = Derivatives { dx: map.dx, dy: map.dy };
        let tied = is_tied(&sampler, lambda);
        let expect = |pixel: Pixel, variant: Variant| {
            let st = map.of(pixel);
            let nearest =
                (filters.min == Filter::Nearest) && image.iter().any(|level| tie(level, st));
            if nearest || tied {
                return None;
            }
            let lambda = sample::lambda(&image, &sampler, &derivatives, variant);
            let large = size[0].max(size[1]) >= 512 && variant.has(Mutation::LambdaOffForLarge);
            let lambda = if large { lambda + 0.5 } else { lambda };
            Some(sample::at_lambda(&image, &sampler, st, lambda, variant))
        };
        let by = [Lookup::Fixed, Lookup::Shader][round / 2 % 2];
        pictures.compare(&(size, sampler.at.wrap, filters, lambda, by), expect, |session| {
            session.frame(GL_RGBA8, PICTURE, 0)?;
            session.texture_2d(&image, &sampler)?;
            by.prepare(session)?;
            map.draw([Given::Immediate, Given::Arrays(2), Given::Arrays(3)][round / 4 % 3]);
            session.read_bytes(PICTURE)
        })?;
    }
    let nearest = filters[0].min == Filter::Nearest;
    pictures.finish(if nearest { 60 } else { 90 }, 50);
    Ok(())
}

/// Whether a λ is on the tie of two levels or of two filters.
fn is_tied(sampler: &Sampler, lambda: f64) -> bool {
    let of = |lambda: f64| lod::levels(lambda, sampler.filters, sampler.range, Variant::CORRECT);
    match sampler.filters.mipmap {
        Mipmap::None => false,
        Mipmap::Nearest => of(lambda - 1e-4) != of(lambda + 1e-4),
        Mipmap::Linear => false,
    }
}

/// How the vertices of a square are given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Given {
    Immediate,
    /// Arrays of this many texture coordinates.
    Arrays(usize),
}

impl Given {
    /// Draws a square of these texture coordinates and positions.
    pub fn draw(self, corners: [([f64; 4], [f64; 2]); 4]) {
        match self {
            Self::Immediate => {
                glBegin(GL_QUADS);
                for ([s, t, r, q], [x, y]) in corners {
                    glTexCoord4d(s, t, r, q);
                    glVertex2d(x, y);
                }
                glEnd();
            }
            Self::Arrays(components) => {
                let coordinates = corners.map(|(coordinates, _)| coordinates.map(|c| c as f32));
                let positions = corners.map(|(_, position)| position.map(|c| c as f32));
                glEnableClientState(GL_VERTEX_ARRAY);
                glEnableClientState(GL_TEXTURE_COORD_ARRAY);
                glVertexPointer(2, GL_FLOAT, 0, positions.as_flattened());
                let numbers = coordinates.as_flattened();
                glTexCoordPointer(components as i32, GL_FLOAT, 16, numbers);
                glDrawArrays(GL_QUADS, 0, 4);
            }
        }
    }
}

/// How a texture gets into the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Lookup {
    Fixed,
    Shader,
}

impl Lookup {
    pub fn prepare(self, session: &Session) -> Result<(), ProbeError> {
        match self {
            Self::Fixed => {
                glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
                glEnable(GL_TEXTURE_2D);
                session.check("enabling a texture")
            }
            Self::Shader => session.show_textures(1),
        }
    }
}

fn perspective(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("picture-perspective");
    let filters = mipmapped(Filter::Linear, Mipmap::Linear);
    let mut levels_reached = BTreeSet::new();
    for round in 0..harness.cases(24).max(3) {
        let side = [512, 1024, 2048][round % 3];
        let image = image(&mut rng, [side; 2], filters);
        let sampler = repeating(&image, filters);
        // A floor: w is linear in y; s/w and t/w are linear in x and y.
        let (near, far) = (1.0, f64::from(rng.dyadic(4.0, 24.0, 0.25)));
        let scale = f64::from(rng.dyadic(0.0625, 0.5, 1.0 / 64.0));
        let [w, h] = PICTURE.map(|n| n as f64);
        let st = move |x: f64, y: f64| {
            let v = y / h;
            let z = 1.0 / (1.0 / near + v * (1.0 / far - 1.0 / near));
            [scale * z * (2.0 * x / w - 1.0), scale * z]
        };
        let by = [Lookup::Fixed, Lookup::Shader][round % 2];
        let scene = (side, far, scale, by);
        let reached =
            compare_varying(harness, tally, &scene, (&image, &sampler), &st, |session| {
                session.frame(GL_RGBA8, PICTURE, 0)?;
                session.texture_2d(&image, &sampler)?;
                by.prepare(session)?;
                glBegin(GL_QUADS);
                for ([x, y], z) in [
                    ([-1.0, -1.0], near),
                    ([1.0, -1.0], near),
                    ([1.0, 1.0], far),
                    ([-1.0, 1.0], far),
                ] {
                    let [s, t] = [scale * z * x, scale * z];
                    glTexCoord2d(s, t);
                    glVertex4d(x * z, y * z, 0.0, z);
                }
                glEnd();
                session.read_bytes(PICTURE)
            })?;
        levels_reached.extend(reached);
    }
    tally.reach("levels of detail", levels_reached.len(), 5);
    Ok(())
}

/// The state of a texture that repeats and has all its levels.
pub(super) fn repeating(image: &[Level], filters: Filters) -> Sampler {
    Sampler {
        at: Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] },
        filters,
        lod: LodState::default(),
        range: LevelRange { base: 0, last: image.len() - 1 },
    }
}

/// Compares every pixel of a picture whose texture coordinates are this function of window coordinates, each pixel with a
/// λ of its own; the levels of detail that pixels have.
pub(super) fn compare_varying(
    harness: &Harness,
    tally: &mut Tally,
    scene: &dyn Debug,
    (image, sampler): (&[Level], &Sampler),
    st: &dyn Fn(f64, f64) -> [f64; 2],
    observe: impl FnOnce(&Session) -> Result<Vec<[f64; 4]>, ProbeError>,
) -> Result<BTreeSet<i64>, ProbeError> {
    let centre = |x: usize, y: usize| (x as f64 + 0.5, y as f64 + 0.5);
    let pixels: Vec<Pixel> = super::pictures::all(PICTURE).collect();
    let between = |a: [f64; 2], b: [f64; 2]| [b[0] - a[0], b[1] - a[1]];
    // λ by differences in the quad of the pixel, and by differences over a hundredth of a pixel.
    let lambdas = |&[x, y]: &Pixel, variant: Variant| {
        let (cx, cy) = centre(x, y);
        let e = 0.01;
        let exact = Derivatives {
            dx: between(st(cx - e, cy), st(cx + e, cy)).map(|d| d / (2.0 * e)),
            dy: between(st(cx, cy - e), st(cx, cy + e)).map(|d| d / (2.0 * e)),
        };
        let (x0, y0) = centre(x & !1, y & !1);
        let quad = Derivatives {
            dx: between(st(x0, cy), st(x0 + 1.0, cy)),
            dy: between(st(cx, y0), st(cx, y0 + 1.0)),
        };
        let first = Derivatives {
            dx: between(st(x0, y0), st(x0 + 1.0, y0)),
            dy: between(st(x0, y0), st(x0, y0 + 1.0)),
        };
        [exact, quad, first].map(|d| sample::lambda(image, sampler, &d, variant))
    };
    let value = |pixel: &Pixel, lambda: f64, variant: Variant| {
        let (cx, cy) = centre(pixel[0], pixel[1]);
        sample::at_lambda(image, sampler, st(cx, cy), lambda, variant)
    };
    let expect = |pixel: &Pixel, variant: Variant| {
        let lambda = lambdas(pixel, variant)[0];
        let off = if variant.has(Mutation::LambdaOffForLarge) { 0.5 } else { 0.0 };
        value(pixel, lambda + off, variant)
    };
    let error = |pixel: &Pixel, expected: [f64; 4], found: [f64; 4]| {
        // Where λ may be any of several, any value between theirs holds; a mistake moves all of them.
        let others = lambdas(pixel, Variant::CORRECT).map(|l| value(pixel, l, Variant::CORRECT));
        let moved: [f64; 4] = std::array::from_fn(|i| expected[i] - others[0][i]);
        let off = |i: usize| {
            let all = others.map(|other| other[i] + moved[i]);
            let low = all.into_iter().fold(f64::INFINITY, f64::min);
            let high = all.into_iter().fold(f64::NEG_INFINITY, f64::max);
            255.0 * (low - found[i]).max(found[i] - high).max(0.0)
        };
        (0..4).map(off).fold(0.0, f64::max)
    };
    harness.compare_by(tally, scene, &pixels, expect, error, observe)?;
    Ok(pixels.iter().map(|p| lambdas(p, Variant::CORRECT)[0].floor() as i64).collect())
}
