//! Lines whose pixels lie on ties, which the specification decides by moving both ends, and the values of wide ones.

use super::pictures::{Pictures, Pixel, drawn, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::line::Segment;
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Ties.
pub const TIES: Check = Check {
    name: "line-ties",
    citation: "GL 2.1, 3.4.1: ends are moved by (-ε, -ε²)",
    what: "every pixel of lines between corners, middles of sides and centres of pixels, in all directions",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not; the oracle is exact",
    run: ties,
};

/// Colours of wide lines.
pub const WIDE_VALUES: Check = Check {
    name: "line-wide-values",
    citation: "GL 2.1, 3.4.2: a column (x-major: slopes of -1 to 1) of fragments with the data of one; equation 3.6",
    what: "colour at every pixel of level, upright and diagonal lines of width 3 and 5 through centres of pixels",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 21) as f64,
    why: "f32: a slope of up to 1/3 a pixel times a column of up to 39, and its sum with the value at the first one, both below 16, are rounded by 2^-22 where they are below 8",
    run: wide_values,
};

const PICTURE: Pixel = [39, 35];

fn draw(line: &Segment, colors: [f32; 2]) {
    glBegin(GL_LINES);
    for ([x, y], red) in [line.from, line.to].into_iter().zip(colors) {
        glColor4f(red, 0, 0, 1);
        glVertex2f(x as f32, y as f32);
    }
    glEnd();
}

fn ties(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("line-ties");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(192).max(24) {
        let mut corner = |around: Option<[f64; 2]>| {
            let halves = PICTURE.map(|n| 2 * n as i64 - 2);
            let at = halves.map(|n| rng.integer(1, n) as f64 / 2.0);
            // Slopes of 0, 1/2, 1 and 2, of which many pixels are ties.
            let Some([x, y]) = around else { return at };
            let slope = [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, -1.0], [2.0, 1.0], [1.0, 2.0]];
            let [dx, dy] = slope[round % slope.len()];
            let length = rng.integer(2, 30) as f64 / 2.0 * rng.pick(&[-1.0, 1.0]);
            [x + dx * length, y + dy * length]
        };
        let from = corner(None);
        let to = if round % 4 == 3 { corner(None) } else { corner(Some(from)) };
        let is_seen = (0..2).all(|i| (0.5..PICTURE[i] as f64 - 0.5).contains(&to[i]));
        if !is_seen || from == to {
            continue;
        }
        let line = Segment { from, to };
        let expect = |[x, y]: Pixel, variant: Variant| {
            Some(drawn(line.exits_perturbed([x as i64, y as i64], variant)))
        };
        pictures.compare(&line, expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            draw(&line, [1.0, 1.0]);
            let picture = session.read_floats(PICTURE)?;
            Ok(picture.into_iter().map(|[red, ..]| [red, 0.0, 0.0, 0.0]).collect())
        })?;
    }
    pictures.finish(100, 0);
    Ok(())
}

fn wide_values(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    const DIRECTIONS: [[i64; 2]; 8] =
        [[1, 1], [1, -1], [-1, 1], [-1, -1], [1, 0], [0, 1], [-1, 0], [0, -1]];
    let mut rng = Rng::named("line-wide-values");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(64).max(16) {
        let [dx, dy] = DIRECTIONS[round % DIRECTIONS.len()];
        let half_width = rng.pick(&[1, 2]);
        let length = rng.integer(3, 10);
        let [x, y] = PICTURE.map(|n| rng.integer(13, n as i64 - 14));
        let end = [x + dx * length, y + dy * length];
        let centre = |at: [i64; 2]| at.map(|c| c as f64 + 0.5);
        let line = Segment { from: centre([x, y]), to: centre(end) };
        let colors = [0; 2].map(|_: i32| rng.dyadic(0.0, 1.0, 1.0 / 256.0));
        let major = usize::from(dx == 0);
        let expect = |pixel: Pixel, variant: Variant| {
            let at = pixel.map(|c| c as i64);
            let forward = [dx, dy][major];
            let step = (at[major] - [x, y][major]) * forward;
            let aside = at[1 - major] - ([x, y][1 - major] + step * [dx, dy][1 - major]);
            let last = if variant.has(Mutation::LastPixelDrawn) { length } else { length - 1 };
            if !(0..=last).contains(&step) || aside.abs() > half_width {
                return Some([0.0; 4]);
            }
            let t = match variant.has(Mutation::WideValuesAcross) {
                true => line.parameter(pixel),
                false => step as f64 / length as f64,
            };
            let [a, b] = colors.map(f64::from);
            Some([a + t * (b - a), 0.0, 0.0, 1.0])
        };
        pictures.compare(&(line, half_width), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            glLineWidth((2 * half_width + 1) as f32);
            draw(&line, colors);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 1);
    Ok(())
}
