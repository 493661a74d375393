//! What the sides of the view volume do to points and lines (section 2.12), and indices far from zero.

use super::pictures::{Pictures, Pixel, drawn};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::line::Segment;
use crate::oracle::point::Dot;
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Points.
pub const POINTS: Check = Check {
    name: "point-clip",
    citation: "GL 2.1, 2.12: a point outside the view volume is discarded, one inside it is drawn whole",
    what: "every pixel of points of sizes 1 to 15 in and about a viewport that is smaller than the picture",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not; positions are exact in 1/256 pixels",
    run: points,
};

/// Lines.
pub const LINES: Check = Check {
    name: "line-clip",
    citation: "GL 2.1, 2.12 and 3.4.1: of a line the part in the view volume",
    what: "every pixel of lines that leave a viewport which is smaller than the picture; pixels next to its sides are left out",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not; ties of the diamond rule are left out",
    run: lines,
};

/// Indices.
pub const INDICES: Check = Check {
    name: "element-range",
    citation: "GL 2.1, 2.8: glDrawElements: element i of each array",
    what: "every pixel of points whose indices are dense or sparse, from 0 or from a thousand on, in three types",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "bytes of colours are copied",
    run: indices,
};

const PICTURE: Pixel = [83, 71];

/// Column and row, width and height.
const VIEWPORT: [usize; 4] = [17, 13, 47, 39];

/// Object coordinates are window coordinates.
fn viewport() {
    let [x, y, w, h] = VIEWPORT;
    glViewport(x, y, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    let [left, lower, right, upper] = [x, y, x + w, y + h].map(|n| n as f64);
    glOrtho(left, right, lower, upper, 0, -1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

/// How far a position is inside the viewport; negative outside.
fn inside([x, y]: [f64; 2]) -> f64 {
    let [left, lower, w, h] = VIEWPORT.map(|n| n as f64);
    (x - left).min(left + w - x).min(y - lower).min(lower + h - y)
}

/// A position at odd multiples of 1/256 pixel, up to `beyond` pixels outside the viewport.
fn random_position(rng: &mut Rng, beyond: i64) -> [f64; 2] {
    let [x, y, w, h] = VIEWPORT.map(|n| n as i64);
    let mut along = |from: i64, size: i64| {
        (rng.integer((from - beyond) * 128, (from + size + beyond) * 128 - 1) * 2 + 1) as f64
            / 256.0
    };
    [along(x, w), along(y, h)]
}

fn points(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("point-clip");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    let mut outside = 0;
    for _ in 0..harness.cases(48).max(8) {
        let dots: Vec<Dot> = (0..24)
            .map(|_| Dot { at: random_position(&mut rng, 12), size: rng.integer(1, 15) as f64 })
            .collect();
        outside += dots.iter().filter(|dot| inside(dot.at) < 0.0).count();
        let expect = |pixel: Pixel, variant: Variant| {
            let covers = |dot: &&Dot| {
                let is_kept = inside(dot.at) > 0.0 || variant.has(Mutation::ClippingIgnored);
                is_kept && dot.covers(pixel, variant)
            };
            Some([dots.iter().filter(covers).count() as f64, 0.0, 0.0, 0.0])
        };
        pictures.compare(&dots[0], expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            viewport();
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
            glColor4f(1, 0, 0, 0);
            for dot in &dots {
                glPointSize(dot.size as f32);
                glBegin(GL_POINTS);
                glVertex2f(dot.at[0] as f32, dot.at[1] as f32);
                glEnd();
            }
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 10);
    tally.reach("points outside", outside, 24);
    Ok(())
}

fn lines(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("line-clip");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(96).max(16) {
        let line =
            Segment { from: random_position(&mut rng, 40), to: random_position(&mut rng, 40) };
        let expect = |pixel: Pixel, variant: Variant| {
            let centre = pixel.map(|n| n as f64 + 0.5);
            let exits = || line.exits(pixel.map(|n| n as i64), variant).map(drawn);
            if inside(centre) > 2.0 || variant.has(Mutation::ClippingIgnored) {
                return exits();
            }
            // Where the line is cut, either of two pixels may end it.
            (inside(centre) < -2.0).then(|| drawn(false))
        };
        pictures.compare(&line, expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            viewport();
            glColor4f(1, 0, 0, 0);
            glBegin(GL_LINES);
            glVertex2f(line.from[0] as f32, line.from[1] as f32);
            glVertex2f(line.to[0] as f32, line.to[1] as f32);
            glEnd();
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(80, 0);
    Ok(())
}

/// How indices lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Indices {
    Dense { from: usize },
    Sparse,
}

fn indices(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("element-range");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    let pixels = PICTURE[0] * PICTURE[1];
    // A vertex for each pixel, each of its own colour.
    let positions: Vec<[f32; 2]> =
        super::pictures::all(PICTURE).map(|[x, y]| [x as f32 + 0.5, y as f32 + 0.5]).collect();
    for round in 0..harness.cases(24).max(12) {
        let colors: Vec<[u8; 4]> = (0..pixels).map(|_| [0; 4].map(|_: u8| rng.byte())).collect();
        let how = match round % 3 {
            0 => Indices::Dense { from: 0 },
            1 => Indices::Dense { from: rng.integer(100, 1000) as usize },
            _ => Indices::Sparse,
        };
        let ty = [GL_UNSIGNED_SHORT, GL_UNSIGNED_INT, GL_UNSIGNED_BYTE][round / 3 % 3];
        let end = if ty == GL_UNSIGNED_BYTE { 256 } else { pixels };
        let chosen: Vec<usize> = match how {
            Indices::Dense { from } => {
                let from = from.min(end / 2);
                (0..400).map(|_| rng.integer(from as i64, (from + 100) as i64) as usize).collect()
            }
            Indices::Sparse => (0..400).map(|_| rng.integer(0, end as i64 - 1) as usize).collect(),
        };
        let expect = |[x, y]: Pixel, variant: Variant| {
            let at = y * PICTURE[0] + x;
            let read = if variant.has(Mutation::IndexIgnored) { 0 } else { at };
            let is_drawn = chosen.contains(&at);
            let color = colors[read].map(|c| f64::from(c) / 255.0);
            Some(if is_drawn { color } else { [0.0; 4] })
        };
        pictures.compare(&(how, ty), expect, |session| {
            session.frame(GL_RGBA8, PICTURE, 0)?;
            super::pictures::window(PICTURE);
            glEnableClientState(GL_VERTEX_ARRAY);
            glEnableClientState(GL_COLOR_ARRAY);
            glVertexPointer(2, GL_FLOAT, 0, positions.as_flattened());
            glColorPointer(4, GL_UNSIGNED_BYTE, 0, colors.as_flattened());
            draw(&chosen, ty);
            session.read_bytes(PICTURE)
        })?;
    }
    pictures.finish(100, 1);
    Ok(())
}

fn draw(chosen: &[usize], ty: u32) {
    let count = chosen.len();
    match ty {
        GL_UNSIGNED_BYTE => {
            let indices: Vec<u8> = chosen.iter().map(|&index| index as u8).collect();
            glDrawElements(GL_POINTS, count, ty, &indices);
        }
        GL_UNSIGNED_SHORT => {
            let indices: Vec<u16> = chosen.iter().map(|&index| index as u16).collect();
            glDrawElements(GL_POINTS, count, ty, &indices);
        }
        _ => {
            let indices: Vec<u32> = chosen.iter().map(|&index| index as u32).collect();
            glDrawElements(GL_POINTS, count, ty, &indices);
        }
    }
}
