//! The anisotropic filter as pictures show it: every pixel of whole squares and floors, into bytes.

use super::pictures::{Pictures, Pixel, all};
use super::texture_pictures::{Lookup, Map, PICTURE, image, mipmapped, repeating};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::anisotropy::{self, footprint, nearest_step};
use crate::oracle::lod::{Derivatives, Filter, Filters, Mipmap};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// One footprint for all pixels.
pub const AFFINE: Check = Check {
    name: "picture-anisotropic",
    citation: "EXT_texture_filter_anisotropic (scheme: DetGL's, oracle/anisotropy.rs)",
    what: "every pixel of turned and stretched squares, round footprints among them, under limits 2 to 16, of six sizes",
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

const SIZES: [[usize; 2]; 6] = [[256, 256], [1024, 128], [64, 64], [512, 512], [33, 65], [16, 512]];

/// Nearer to a step of the filter than this, rounding decides between two texels.
const STEP: f64 = 2e-3;

/// Footprints that are flatter have a `σ₂` that is rounding error.
const FLATTEST: f64 = 24.0;

const FILTERS: Filters = mipmapped(Filter::Linear, Mipmap::Linear);

fn affine(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("picture-anisotropic");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(48).max(12) {
        let size = SIZES[round % SIZES.len()];
        let image = image(&mut rng, size, FILTERS);
        let sampler = repeating(&image, FILTERS);
        let limit = [2.0, 4.0, 8.0, 16.0f32][round / 2 % 4];
        let lambda = f64::from(rng.real(-1.0, 4.0));
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
            if correct.ratio > FLATTEST || is_open {
                return None;
            }
            Some(anisotropy::sample(&image, &sampler, st, &footprint, variant))
        };
        let by = [Lookup::Fixed, Lookup::Shader][round / 4 % 2];
        pictures.compare(&(size, map, limit, by), expect, |session| {
            session.frame(GL_RGBA8, PICTURE, 0)?;
            session.texture_2d(&image, &sampler)?;
            session.anisotropy(limit)?;
            by.prepare(session)?;
            map.draw();
            session.read_bytes(PICTURE)
        })?;
    }
    pictures.finish(60, 60);
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
