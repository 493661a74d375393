//! The anisotropic filter as pictures show it: every pixel of whole squares and floors, into bytes.

use super::pictures::{Pictures, Pixel, all};
use super::texture_pictures::{Given, Lookup, Map, PICTURE, image, mipmapped, repeating};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::anisotropy::{self, footprint, nearest_step};
use crate::oracle::lod::{Derivatives, Filter, Filters, Mipmap};
use crate::oracle::sample::Sampler;
use crate::oracle::texture::{Level, level_count, level_size};
use crate::oracle::wrap::Wrap;
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// One footprint for all pixels.
pub const AFFINE: Check = Check {
    name: "picture-anisotropic",
    citation: "EXT_texture_filter_anisotropic (scheme: DetGL's, oracle/anisotropy.rs)",
    what: "every pixel of turned and stretched squares, round footprints among them, under limits 2 to 16, of six sizes and three wrap modes",
    unit: Unit::Bytes,
    tolerance: 0.56,
    why: "8-bit colours: half a step; weights of 2^-14, places of rows of 2^-16 texels: 2^-13 of 255; f32 coordinates 2^-13",
    run: affine,
};

/// A footprint for each pixel.
pub const PERSPECTIVE: Check = Check {
    name: "picture-anisotropic-floor",
    citation: "EXT_texture_filter_anisotropic (scheme: DetGL's, oracle/anisotropy.rs)",
    what: "every pixel of floors, of which each has its own footprint, of sizes 256, 512 and 1024",
    unit: Unit::Bytes,
    tolerance: 0.56,
    why: "as of one footprint; the footprint may be that of a difference or of a derivative",
    run: perspective,
};

/// Other kinds of texels.
pub const OF_FORMATS: Check = Check {
    name: "picture-anisotropic-formats",
    citation: "EXT_texture_filter_anisotropic (scheme: DetGL's, oracle/anisotropy.rs); tables 3.15 and 3.16",
    what: "every pixel of stretched squares under a limit of 8, and of round footprints without one, of black and white texels in 7 formats",
    unit: Unit::Bytes,
    tolerance: 0.56,
    why: "as of bytes: every format has 0 and 1 exactly",
    run: formats,
};

/// Textures of layers.
pub const ARRAYS: Check = Check {
    name: "picture-anisotropic-arrays",
    citation: "EXT_texture_filter_anisotropic: N probes along the line of anisotropy, about the sample's place",
    what: "every pixel of array textures whose texels are linear in s and t: probes that lie evenly about a place give its value",
    unit: Unit::FullScale,
    tolerance: 5.0 / (1 << 24) as f64,
    why: "f32: the place by 2^-25, its two weights by 2^-17 of 1/256, and three roundings of the mean, by 2^-25 each: twice the root of the sum of their squares, and what of it 16 probes have in common",
    run: probes,
};

const SIZES: [[usize; 2]; 6] = [[256, 256], [1024, 128], [64, 64], [512, 512], [33, 65], [16, 512]];

/// Nearer to a step of the filter than this, rounding decides between two texels.
const STEP: f64 = 2e-3;

/// Footprints that are flatter have a `σ₂` that is rounding error.
const FLATTEST: f64 = 24.0;

const WRAPS: [Wrap; 3] = [Wrap::Repeat, Wrap::ClampToEdge, Wrap::MirroredRepeat];

const FILTERS: Filters = mipmapped(Filter::Linear, Mipmap::Linear);

/// Whether a place is so far beyond an edge that goes on that only the texels of the edge are read: where rows begin does not
/// matter there, and DetGL moves them.
fn is_far(sampler: &Sampler, size: [usize; 2], st: [f64; 2]) -> bool {
    (0..2).any(|i| {
        let n = size[i] as f64;
        sampler.at.wrap[i] == Wrap::ClampToEdge && !(-40.0..n + 40.0).contains(&(st[i] * n))
    })
}

fn affine(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("picture-anisotropic");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(48).max(12) {
        let size = SIZES[round % SIZES.len()];
        let filters = match round % 8 {
            4 => Filters::only(Filter::Linear),
            6 => mipmapped(Filter::Linear, Mipmap::Nearest),
            _ => FILTERS,
        };
        let image = image(&mut rng, size, filters);
        let mut sampler = repeating(&image, filters);
        sampler.at.wrap = match round % 4 {
            // The kernels of upright footprints have one wrap mode for both axes.
            2 => [WRAPS[round / 4 % 2]; 2],
            _ => [0, 1].map(|axis| WRAPS[(round / 2 + axis * (round / 6)) % 3]),
        };
        let limit = [2.0, 4.0, 8.0, 16.0f32][round / 2 % 4];
        let lambda = f64::from(rng.real(-1.0, 4.0));
        // Not on the tie of two levels.
        let is_nearest = filters.mipmap == Mipmap::Nearest;
        let lambda = if is_nearest { lambda.floor() + 0.25 } else { lambda };
        let mut map = Map::random(&mut rng, size, lambda);
        let stretch = [1.0, f64::from(rng.real(1.0, 20.0))][round % 2];
        map.dx = map.dx.map(|d| d * stretch);
        if round % 2 == 0 {
            // Round: as long as wide; every second one upright, which has kernels of its own.
            let [a, b] = [0, 1].map(|i| map.dx[i] * size[i] as f64);
            let [a, b] = if round % 4 == 0 { [a, b] } else { [lambda.exp2(), 0.0] };
            map.dx = [a / size[0] as f64, b / size[1] as f64];
            map.dy = [-b / size[0] as f64, a / size[1] as f64];
        }
        let d = Derivatives { dx: map.dx, dy: map.dy };
        let of = |variant| footprint(&d, size, f64::from(limit), variant);
        let expect = |pixel: Pixel, variant: Variant| {
            let (st, footprint) = (map.of(pixel), of(variant));
            let correct = of(Variant::CORRECT);
            // Of round ones rows and columns give the same.
            let is_open = stretch > 1.0 && nearest_step(&image, &sampler, st, &correct) < STEP;
            if correct.ratio > FLATTEST || is_open || is_far(&sampler, size, st) {
                return None;
            }
            Some(anisotropy::sample(&image, &sampler, st, &footprint, variant))
        };
        let by = [Lookup::Fixed, Lookup::Shader][round / 4 % 2];
        pictures.compare(&(size, sampler.at.wrap, map, limit, by), expect, |session| {
            session.frame(GL_RGBA8, PICTURE, 0)?;
            session.texture_2d(&image, &sampler)?;
            session.anisotropy(limit)?;
            by.prepare(session)?;
            map.draw([Given::Immediate, Given::Arrays(2)][round / 3 % 2]);
            session.read_bytes(PICTURE)
        })?;
    }
    pictures.finish(45, 45);
    Ok(())
}

/// Formats whose texels are read by other kernels than bytes are; blocks of DXT1 are made here.
const FORMATS: [u32; 7] = [
    GL_RGBA16F,
    GL_RGBA32F,
    GL_SRGB8_ALPHA8,
    GL_RGB565,
    GL_RGBA4,
    GL_RGB16F,
    GL_COMPRESSED_RGB_S3TC_DXT1_EXT,
];

/// Black and white texels, which every format has exactly.
fn black_and_white(rng: &mut Rng, side: usize) -> Vec<Level> {
    let sizes = (0..level_count([side; 2])).map(|level| level_size([side; 2], level));
    sizes
        .map(|[w, h]| {
            let bits: Vec<u8> = (0..w * h).map(|_| rng.byte()).collect();
            Level::from_fn(w, h, |i, j| {
                let c = if bits[j * w + i] < 128 { 0 } else { 255 };
                [c, c, c, 255]
            })
        })
        .collect()
}

/// The blocks of a black and white level: of two colours, white and black, a bit pair a texel.
fn dxt1(level: &Level) -> Vec<u8> {
    let (columns, rows) = (level.width.div_ceil(4), level.height.div_ceil(4));
    let blocks = (0..rows).flat_map(|y| (0..columns).map(move |x| [x, y]));
    blocks
        .flat_map(|[x, y]| {
            let mut codes = 0u32;
            for (number, [i, j]) in (0..16).map(|k| [k % 4, k / 4]).enumerate() {
                let (i, j) = (4 * x + i, 4 * y + j);
                let is_in = i < level.width && j < level.height;
                let black = is_in && level.texels[j * level.width + i][0] == 0;
                codes |= u32::from(black) << (2 * number);
            }
            let [a, b, c, d] = codes.to_le_bytes();
            [0xff, 0xff, 0, 0, a, b, c, d]
        })
        .collect()
}

fn formats(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("picture-anisotropic-formats");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(42).max(2 * FORMATS.len()) {
        let internal = FORMATS[round % FORMATS.len()];
        let side = [64, 128][round / 2 % 2];
        let image = black_and_white(&mut rng, side);
        let sampler = repeating(&image, FILTERS);
        // Without anisotropy only round footprints have one ρ by all formulas.
        let limit = [1.0, 8.0][round / FORMATS.len() % 2];
        let lambda = f64::from(rng.real(-1.0, 2.5));
        let mut map = Map::random(&mut rng, [side; 2], lambda);
        map.dy = [-map.dx[1], map.dx[0]];
        if limit > 1.0 {
            let stretch = f64::from(rng.real(1.5, 7.0));
            map.dx = map.dx.map(|d| d * stretch);
        }
        let d = Derivatives { dx: map.dx, dy: map.dy };
        let of = |variant| footprint(&d, [side; 2], limit, variant);
        let expect = |pixel: Pixel, variant: Variant| {
            let st = map.of(pixel);
            let is_open = nearest_step(&image, &sampler, st, &of(Variant::CORRECT)) < STEP;
            if limit > 1.0 && is_open {
                return None;
            }
            Some(anisotropy::sample(&image, &sampler, st, &of(variant), variant))
        };
        pictures.compare(&(enum_name(internal), side, map, limit), expect, |session| {
            session.frame(GL_RGBA8, PICTURE, 0)?;
            session.texture_2d(&image, &sampler)?;
            for (number, level) in image.iter().enumerate() {
                let (target, w, h) = (GL_TEXTURE_2D, level.width, level.height);
                if internal == GL_COMPRESSED_RGB_S3TC_DXT1_EXT {
                    let blocks = dxt1(level);
                    glCompressedTexImage2D(
                        target,
                        number,
                        internal,
                        w,
                        h,
                        0,
                        blocks.len(),
                        &blocks,
                    );
                } else {
                    let texels = level.texels.as_flattened();
                    let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
                    glTexImage2D(target, number, internal, w, h, 0, format, ty, texels);
                }
            }
            session.anisotropy(limit as f32)?;
            session.show_textures(1)?;
            map.draw(Given::Immediate);
            session.read_bytes(PICTURE)
        })?;
    }
    pictures.finish(60, 60);
    Ok(())
}

fn probes(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    const SIDE: usize = 256;
    let mut rng = Rng::named("picture-anisotropic-arrays");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(16).max(4) {
        let limit = [2.0, 4.0, 8.0, 16.0f32][round % 4];
        let lambda = f64::from(rng.real(-1.0, 0.0));
        let mut map = Map::random(&mut rng, [SIDE; 2], lambda);
        let stretch = f64::from(rng.real(1.0, 6.0));
        // The middle of the texture, so that no footprint meets its edge.
        let scale = 0.2 / (map.dx.iter().map(|d| d.abs()).fold(0.0, f64::max) * 50.0 * stretch);
        map.dx = map.dx.map(|d| d * stretch * scale.min(1.0));
        map.dy = map.dy.map(|d| d * scale.min(1.0));
        map.place([0.5; 2]);
        let expect = |pixel: Pixel, variant: Variant| {
            let half = if variant.has(Mutation::HalfTexelOff) { 0.5 / SIDE as f64 } else { 0.0 };
            let [s, t] = map.of(pixel);
            Some([s + half, t + half, 0.0, 1.0])
        };
        pictures.compare(&(map, limit), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            let target = GL_TEXTURE_2D_ARRAY;
            glBindTexture(target, 1);
            for level in 0..level_count([SIDE; 2]) {
                let side = SIDE >> level;
                let place = |i: usize| (i as f32 + 0.5) / side as f32;
                let texels: Vec<f32> = (0..side * side)
                    .flat_map(|k| [place(k % side), place(k / side), 0.0, 1.0])
                    .collect();
                let (format, ty) = (GL_RGBA, GL_FLOAT);
                glTexImage3D(target, level, GL_RGBA32F, side, side, 1, 0, format, ty, &texels);
            }
            glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
            glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
            glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
            glTexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, limit);
            session.fragment_only(
                "#version 130
                uniform sampler2DArray image;
                void main() { gl_FragColor = texture(image, vec3(gl_TexCoord[0].xy, 0.0)); }",
            )?;
            map.draw(Given::Immediate);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 100);
    Ok(())
}

/// A floor: s and t of window coordinates, exactly.
#[derive(Clone, Copy, Debug)]
struct Floor {
    far: f64,
    scale: f64,
}

impl Floor {
    /// z at a share of the picture's height.
    fn depth(&self, v: f64) -> f64 {
        1.0 / (1.0 + v * (1.0 / self.far - 1.0))
    }

    fn st(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [w, h] = PICTURE.map(|n| n as f64);
        let z = self.depth(y / h);
        [self.scale * z * (2.0 * x / w - 1.0), self.scale * z]
    }

    /// The difference of s and t over `by`, a pixel.
    fn step(&self, [x, y]: [f64; 2], by: [f64; 2]) -> [f64; 2] {
        let (a, b) = (self.st([x, y]), self.st([x + by[0], y + by[1]]));
        [b[0] - a[0], b[1] - a[1]]
    }

    /// Derivatives at a pixel's centre: exact ones, and differences within its quad.
    fn derivatives(&self, [x, y]: Pixel) -> [Derivatives; 3] {
        let centre = [x as f64 + 0.5, y as f64 + 0.5];
        let first = [(x & !1) as f64 + 0.5, (y & !1) as f64 + 0.5];
        let e = 0.01;
        let middle = |at: [f64; 2], by: [f64; 2]| {
            let from = [at[0] - by[0] / 2.0, at[1] - by[1] / 2.0];
            self.step(from, by).map(|d| d / e)
        };
        [
            Derivatives { dx: middle(centre, [e, 0.0]), dy: middle(centre, [0.0, e]) },
            Derivatives {
                dx: self.step([first[0], centre[1]], [1.0, 0.0]),
                dy: self.step([centre[0], first[1]], [0.0, 1.0]),
            },
            Derivatives { dx: self.step(first, [1.0, 0.0]), dy: self.step(first, [0.0, 1.0]) },
        ]
    }
}

fn perspective(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("picture-anisotropic-floor");
    let mut kept = 0;
    let mut tried = 0;
    for round in 0..harness.cases(16).max(4) {
        let side = [256, 512, 1024][round % 3];
        let image = image(&mut rng, [side; 2], FILTERS);
        let sampler = repeating(&image, FILTERS);
        let limit = [2.0, 4.0, 8.0, 16.0f32][round % 4];
        let floor = Floor {
            far: f64::from(rng.dyadic(4.0, 24.0, 0.25)),
            scale: f64::from(rng.dyadic(0.0625, 0.5, 1.0 / 64.0)),
        };
        let st = |[x, y]: Pixel| floor.st([x as f64 + 0.5, y as f64 + 0.5]);
        let of = |pixel: Pixel, variant: Variant| {
            floor.derivatives(pixel).map(|d| footprint(&d, [side; 2], f64::from(limit), variant))
        };
        let value = |pixel: Pixel, variant: Variant| {
            of(pixel, variant).map(|footprint| {
                anisotropy::sample(&image, &sampler, st(pixel), &footprint, variant)
            })
        };
        let is_open = |pixel: &Pixel| {
            let steps = of(*pixel, Variant::CORRECT);
            let alike = steps.iter().all(|f| f.along == steps[0].along);
            let near = |f| nearest_step(&image, &sampler, st(*pixel), f) < STEP;
            !alike || steps.iter().any(|f| f.ratio > FLATTEST || near(f))
        };
        let pixels: Vec<Pixel> = all(PICTURE).filter(|pixel| !is_open(pixel)).collect();
        kept += pixels.len();
        tried += PICTURE[0] * PICTURE[1];
        let expect = |pixel: &Pixel, variant: Variant| value(*pixel, variant)[0];
        let error = |pixel: &Pixel, expected: [f64; 4], found: [f64; 4]| {
            // The footprint may be any of several; a mistake moves all of them.
            let others = value(*pixel, Variant::CORRECT);
            let off = |i: usize| {
                let moved = expected[i] - others[0][i];
                let all = others.map(|other| other[i] + moved);
                let low = all.into_iter().fold(f64::INFINITY, f64::min);
                let high = all.into_iter().fold(f64::NEG_INFINITY, f64::max);
                255.0 * (low - found[i]).max(found[i] - high).max(0.0)
            };
            (0..4).map(off).fold(0.0, f64::max)
        };
        let by = [Lookup::Fixed, Lookup::Shader][round % 2];
        harness.compare_by(
            tally,
            &(side, floor, limit, by),
            &pixels,
            expect,
            error,
            |session| {
                session.frame(GL_RGBA8, PICTURE, 0)?;
                session.texture_2d(&image, &sampler)?;
                session.anisotropy(limit)?;
                by.prepare(session)?;
                glBegin(GL_QUADS);
                let far = floor.far;
                for ([x, y], z) in
                    [([-1.0, -1.0], 1.0), ([1.0, -1.0], 1.0), ([1.0, 1.0], far), ([-1.0, 1.0], far)]
                {
                    let [s, t] = [floor.scale * z * x, floor.scale * z];
                    glTexCoord2d(s, t);
                    glVertex4d(x * z, y * z, 0.0, z);
                }
                glEnd();
                let picture = session.read_bytes(PICTURE)?;
                Ok(pixels.iter().map(|[x, y]| picture[y * PICTURE[0] + x]).collect())
            },
        )?;
    }
    tally.reach("pixels compared", kept, tried / 3);
    Ok(())
}
