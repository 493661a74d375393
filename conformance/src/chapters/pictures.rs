//! Pictures that are compared pixel by pixel, and how many of their pixels say something.

use crate::check::{Harness, Tally};
use crate::gl::*;
use crate::mutation::Variant;
use crate::probe::{ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;
use std::fmt::Debug;

/// A pixel: column and row, from the lower left.
pub(super) type Pixel = [usize; 2];

/// The pixels of a picture, row by row from the lowest.
pub(super) fn all([width, height]: Pixel) -> impl Iterator<Item = Pixel> {
    (0..height).flat_map(move |y| (0..width).map(move |x| [x, y]))
}

/// A random point of a picture at odd multiples of 1/256 pixel, never on a tie of the rules for odd or even sizes.
pub(super) fn point_between_ties(rng: &mut Rng, size: Pixel) -> [f64; 2] {
    size.map(|n| (rng.integer(0, n as i64 * 128 - 1) * 2 + 1) as f64 / 256.0)
}

/// The scenes of a check, each compared at every pixel.
pub(super) struct Pictures<'a> {
    harness: &'a Harness,
    tally: &'a mut Tally,
    size: Pixel,
    pixels: usize,
    compared: usize,
    drawn: usize,
}

impl<'a> Pictures<'a> {
    /// No scenes yet, all of this size.
    pub fn new(harness: &'a Harness, tally: &'a mut Tally, size: Pixel) -> Self {
        Self { harness, tally, size, pixels: 0, compared: 0, drawn: 0 }
    }

    /// Compares each pixel of a scene; `expect` is `None` where the specification leaves a pixel open.
    ///
    /// # Errors
    /// When the driver reports a GL error or rejects a shader.
    pub fn compare(
        &mut self,
        scene: &dyn Debug,
        expect: impl Fn(Pixel, Variant) -> Option<[f64; 4]>,
        observe: impl FnOnce(&Session) -> Result<Vec<[f64; 4]>, ProbeError>,
    ) -> Result<(), ProbeError> {
        let size = self.size;
        let correct: Vec<Option<[f64; 4]>> =
            all(size).map(|pixel| expect(pixel, Variant::CORRECT)).collect();
        let kept: Vec<Pixel> =
            all(size).zip(&correct).filter(|(_, value)| value.is_some()).map(|(p, _)| p).collect();
        self.pixels += correct.len();
        self.compared += kept.len();
        self.drawn += correct.iter().flatten().filter(|value| **value != [0.0; 4]).count();
        // What a mistake leaves open is as far off as can be.
        let value = |pixel: &Pixel, variant: Variant| expect(*pixel, variant).unwrap_or([1e9; 4]);
        self.harness.compare(self.tally, scene, &kept, value, |session| {
            let picture = observe(session)?;
            if picture.len() != size[0] * size[1] {
                let cases = size[0] * size[1];
                return Err(ProbeError::Missing { cases, measured: picture.len() });
            }
            Ok(kept.iter().map(|[x, y]| picture[y * size[0] + x]).collect())
        })
    }

    /// Says how many pixels were compared and how many of them are not empty; least shares in percent.
    pub fn finish(self, compared: usize, drawn: usize) {
        self.tally.reach("pixels compared", self.compared, self.pixels * compared / 100);
        self.tally.reach("pixels drawn", self.drawn, (self.pixels * drawn / 100).max(1));
    }
}

/// Object coordinates are window coordinates, depths from 0 at the near plane to 1.
pub(super) fn window([width, height]: Pixel) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, width as f64, 0, height as f64, 0, -1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

/// A rectangle over the picture at this depth, in the current colour.
pub(super) fn cover([width, height]: Pixel, depth: f64) {
    glBegin(GL_QUADS);
    for [x, y] in [[0, 0], [width, 0], [width, height], [0, height]] {
        glVertex3f(x as f32, y as f32, depth as f32);
    }
    glEnd();
}

/// A colour as the driver takes it.
pub(super) fn color([r, g, b, a]: [f64; 4]) {
    glColor4f(r as f32, g as f32, b as f32, a as f32);
}

/// 1 in the first component where something is drawn.
pub(super) fn drawn(is: bool) -> [f64; 4] {
    [f64::from(u8::from(is)), 0.0, 0.0, 0.0]
}

/// How the colours of a picture are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Brush {
    /// One texture over all of it.
    Texture,
    /// A point a pixel.
    Points,
}

impl Brush {
    /// One of them each round.
    pub fn of(round: usize) -> Self {
        [Self::Texture, Self::Points][round % 2]
    }

    /// Draws the colours of a picture, row by row from the lowest; [`window`] must have been called.
    pub fn paint(self, size: Pixel, colors: &[[f32; 4]]) {
        match self {
            Self::Texture => {
                let (target, [w, h]) = (GL_TEXTURE_2D, size);
                let texels = colors.as_flattened();
                glBindTexture(target, 77);
                glTexImage2D(target, 0, GL_RGBA32F, w, h, 0, GL_RGBA, GL_FLOAT, texels);
                glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
                glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
                glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
                glEnable(target);
                glBegin(GL_QUADS);
                for [s, t] in [[0, 0], [1, 0], [1, 1], [0, 1]] {
                    glTexCoord2i(s, t);
                    glVertex2f((s * w as i32) as f32, (t * h as i32) as f32);
                }
                glEnd();
                glDisable(target);
            }
            Self::Points => {
                glBegin(GL_POINTS);
                for ([x, y], [r, g, b, a]) in all(size).zip(colors) {
                    glColor4f(*r, *g, *b, *a);
                    glVertex2f(x as f32 + 0.5, y as f32 + 0.5);
                }
                glEnd();
            }
        }
    }
}

/// Random colours of a picture.
pub(super) fn random_colors(
    rng: &mut Rng,
    [width, height]: Pixel,
    [low, high]: [f64; 2],
) -> Vec<[f32; 4]> {
    (0..width * height).map(|_| [0; 4].map(|_: i32| rng.real(low, high))).collect()
}
