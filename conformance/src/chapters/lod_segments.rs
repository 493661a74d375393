//! The level of detail of lines, points, pixel rectangles and bitmaps, which have formulas of their own.

use super::pictures::{Pictures, Pixel, all, point_between_ties, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::line::{Segment, along};
use crate::oracle::lod::{LodState, lambda};
use crate::probe::{ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;

/// Lines.
pub const LINES: Check = Check {
    name: "lod-lines",
    citation: "GL 2.1, 3.8.8, equation 3.21: ρ of lines",
    what: "λ at every pixel of lines of widths 1, 3 and 6 in all directions, with perspective and without",
    unit: Unit::Levels,
    tolerance: 2.0 / (1 << 20) as f64,
    why: "f32: window coordinates of up to 59 are off by 2^-19, of at least 8 pixels: 2^-22 of t, which a quotient of w of 4 makes 2^-20 of ρ; λ up to 8 is rounded by 2^-22, and so are logarithm and mix: twice the root of the sum of squares",
    run: lines,
};

/// Points.
pub const POINTS: Check = Check {
    name: "lod-points",
    citation: "GL 2.1, 3.8.8: for a point, ρ = 1",
    what: "λ of points of sizes 1 to 9 under biases of -1 to 5 of the unit, the texture and a shader",
    unit: Unit::Levels,
    tolerance: 0.0,
    why: "log2 of 1 is 0; biases and levels are whole numbers of 1/4",
    run: points,
};

/// Pixel rectangles and bitmaps.
pub const RECTANGLES: Check = Check {
    name: "lod-rectangles",
    citation: "GL 2.1, 3.8.8: for a pixel rectangle or a bitmap, ρ = 1",
    what: "λ of glDrawPixels, glCopyPixels and glBitmap under zooms 1 and 2 and biases of -1 to 5 of the unit, the texture and a shader",
    unit: Unit::Levels,
    tolerance: 0.0,
    why: "log2 of 1 is 0; biases and levels are whole numbers of 1/4",
    run: rectangles,
};

const PICTURE: Pixel = [59, 45];

/// The side of the base level, and the number of levels.
const SIDE: usize = 256;
const LEVELS: usize = 9;

/// A texture each of whose levels has its number everywhere, so that a trilinear lookup is λ.
fn numbered_levels(session: &Session) -> Result<(), ProbeError> {
    let target = GL_TEXTURE_2D;
    glBindTexture(target, 1);
    for level in 0..LEVELS {
        let side = SIDE >> level;
        let texels = vec![level as f32; side * side];
        glTexImage2D(target, level, GL_RGB32F, side, side, 0, GL_LUMINANCE, GL_FLOAT, &texels);
    }
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(target);
    session.check("making levels")
}

fn lines(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("lod-lines");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(96).max(12) {
        let line = loop {
            let [from, to] = [0; 2].map(|_: i32| point_between_ties(&mut rng, PICTURE));
            if (0..2).map(|i| (to[i] - from[i]).abs()).fold(0.0, f64::max) > 8.0 {
                break Segment { from, to };
            }
        };
        let width = [1.0, 3.0, 6.0][round % 3];
        let w = match round % 2 {
            0 => [1.0; 2],
            _ => [0; 2].map(|_: i32| f64::from(rng.dyadic(1.0, 4.0, 0.25))),
        };
        let length = (line.to[0] - line.from[0]).hypot(line.to[1] - line.from[1]);
        // About 2^λ texels a pixel, mostly along s, mostly along t, or both.
        let texels = f64::from(rng.real(1.0, 6.0)).exp2() * length / SIDE as f64;
        let turn = f64::from(rng.real(0.0, 6.2));
        let st = [[0.0; 2], [texels * turn.cos(), texels * turn.sin()]]
            .map(|at| at.map(|c| f64::from(c as f32)));
        let expect = |pixel: Pixel, variant: Variant| {
            if !line.covers(pixel.map(|c| c as i64), width, Variant::CORRECT)? {
                return Some([0.0; 4]);
            }
            // Values of a wide line are those of its column.
            let major = usize::from(!line.is_x_major());
            let t = match width > 1.0 {
                true => {
                    (pixel[major] as f64 + 0.5 - line.from[major])
                        / (line.to[major] - line.from[major])
                }
                false => line.parameter(pixel),
            };
            let rate = |i: usize| {
                let at = |t: f64| along(t, st.map(|end| end[i]), w, Variant::CORRECT);
                let e = 1e-5;
                (at(t + e) - at(t - e)) / (2.0 * e) * SIDE as f64
            };
            let mut rho = rate(0).hypot(rate(1)) / length;
            if variant.has(Mutation::LodOfSegmentAsPolygon) {
                let d = [0, 1].map(|i| (line.to[i] - line.from[i]).abs() / length);
                rho *= d[0].max(d[1]);
            }
            let lambda = lambda(rho, &LodState::default(), variant);
            Some([lambda.clamp(0.0, (LEVELS - 1) as f64), 0.0, 0.0, 1.0])
        };
        pictures.compare(&(line, width, w, st), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            numbered_levels(session)?;
            if round / 2 % 2 == 1 {
                session.show_textures(1)?;
            }
            glLineWidth(width as f32);
            glBegin(GL_LINES);
            for (k, [x, y]) in [line.from, line.to].into_iter().enumerate() {
                glTexCoord2d(st[k][0], st[k][1]);
                glVertex4d(x * w[k], y * w[k], 0.0, w[k]);
            }
            glEnd();
            first_component(session)
        })?;
    }
    pictures.finish(95, 1);
    Ok(())
}

/// Red, and 1 in alpha where something is drawn.
fn first_component(session: &Session) -> Result<Vec<[f64; 4]>, ProbeError> {
    let picture = session.read_floats(PICTURE)?;
    Ok(picture.into_iter().map(|[red, _, _, alpha]| [red, 0.0, 0.0, alpha]).collect())
}

/// Where a bias is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Bias {
    Unit,
    Texture,
    Shader,
}

impl Bias {
    /// Sets the bias, and what shows the texture.
    fn prepare(self, session: &Session, bias: f64) -> Result<(), ProbeError> {
        match self {
            Self::Unit => {
                glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, bias as f32);
                session.check("setting a bias")
            }
            Self::Texture => {
                glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, bias as f32);
                session.show_textures(1)
            }
            Self::Shader => session.fragment_only(&format!(
                "uniform sampler2D image;
                void main() {{ gl_FragColor = texture2D(image, gl_TexCoord[0].xy, {bias:?}); }}"
            )),
        }
    }
}

fn points(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("lod-points");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(48).max(18) {
        let by = [Bias::Unit, Bias::Texture, Bias::Shader][round % 3];
        let side = rng.integer(1, 9) as usize;
        let bias = f64::from(rng.dyadic(-1.0, 5.0, 0.25));
        // Two rows of squares, each with coordinates of its own.
        let corners: Vec<Pixel> = all([4, 2]).map(|[i, j]| [3 + 13 * i, 5 + 17 * j]).collect();
        let st: Vec<[f32; 2]> =
            corners.iter().map(|_| [0; 2].map(|_: i32| rng.real(-1.0, 2.0))).collect();
        let state = LodState { unit_bias: bias, ..LodState::default() };
        let expect = |pixel: Pixel, variant: Variant| {
            let is_in =
                |corner: &Pixel| (0..2).all(|i| (corner[i]..corner[i] + side).contains(&pixel[i]));
            if !corners.iter().any(is_in) {
                return Some([0.0; 4]);
            }
            let rho = if variant.has(Mutation::LodOfPointIsNone) { 0.0 } else { 1.0 };
            let lambda = lambda(rho, &state, variant);
            Some([lambda.clamp(0.0, (LEVELS - 1) as f64), 0.0, 0.0, 1.0])
        };
        pictures.compare(&(by, side, bias), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            numbered_levels(session)?;
            by.prepare(session, bias)?;
            glPointSize(side as f32);
            let middle = side as f32 / 2.0;
            glBegin(GL_POINTS);
            for (&[x, y], &[s, t]) in corners.iter().zip(&st) {
                glTexCoord2f(s, t);
                glVertex2f(x as f32 + middle, y as f32 + middle);
            }
            glEnd();
            first_component(session)
        })?;
    }
    pictures.finish(100, 1);
    Ok(())
}

/// What is drawn at the raster position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Rectangle {
    Pixels,
    Copy,
    Bitmap,
}

fn rectangles(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("lod-rectangles");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(72).max(18) {
        let by = [Bias::Unit, Bias::Texture, Bias::Shader][round % 3];
        let what = [Rectangle::Pixels, Rectangle::Copy, Rectangle::Bitmap][round / 3 % 3];
        let size = [rng.integer(1, 13) as usize, rng.integer(1, 11) as usize];
        let corner = [rng.integer(0, 30) as usize, rng.integer(0, 20) as usize];
        // Bitmaps are not zoomed.
        let zoom = if what == Rectangle::Bitmap { 1 } else { rng.integer(1, 2) as usize };
        let bias = f64::from(rng.dyadic(-1.0, 5.0, 0.25));
        let st = [0; 2].map(|_: i32| rng.real(-1.0, 2.0));
        let state = LodState { unit_bias: bias, ..LodState::default() };
        // GL_REPLACE by RGB keeps alpha, which the framebuffer that is copied has none of.
        let is_copied = what == Rectangle::Copy && by == Bias::Unit;
        let alpha = if is_copied { 0.0 } else { 1.0 };
        let expect = |pixel: Pixel, variant: Variant| {
            let is_in = |i: usize| (corner[i]..corner[i] + zoom * size[i]).contains(&pixel[i]);
            if !(is_in(0) && is_in(1)) {
                return Some([0.0; 4]);
            }
            let rho = if variant.has(Mutation::LodOfPointIsNone) { 0.0 } else { 1.0 };
            let lambda = lambda(rho, &state, variant);
            Some([lambda.clamp(0.0, (LEVELS - 1) as f64), 0.0, 0.0, alpha])
        };
        pictures.compare(&(by, what, size, bias), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            numbered_levels(session)?;
            by.prepare(session, bias)?;
            glTexCoord2f(st[0], st[1]);
            glWindowPos2i(corner[0] as i32, corner[1] as i32);
            glPixelZoom(zoom as f32, zoom as f32);
            let [w, h] = size;
            match what {
                Rectangle::Pixels => {
                    glDrawPixels(w, h, GL_RGBA, GL_FLOAT, &vec![1.0f32; 4 * w * h]);
                }
                Rectangle::Copy => glCopyPixels(0, 0, w, h, GL_COLOR),
                Rectangle::Bitmap => {
                    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
                    glBitmap(w, h, 0, 0, 0, 0, &vec![0xffu8; w.div_ceil(8) * h]);
                }
            }
            first_component(session)
        })?;
    }
    pictures.finish(100, 1);
    Ok(())
}
