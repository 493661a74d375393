//! Lines: the diamond-exit rule, widths, stipples, antialiasing, what is interpolated, and joints.

use super::pictures::{Pictures, Pixel, drawn, point_between_ties, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::line::{LineStipple, Segment, along};
use crate::probe::{ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;

/// Aliased lines of width 1.
pub const DIAMOND: Check = Check {
    name: "line-diamond",
    citation: "GL 2.1, 3.4.1: fragments whose diamonds the line exits",
    what: "every pixel of random lines, short and long, in all octants",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not; ends are exact in 1/256 pixels, ties are left out",
    run: |harness, tally| covered(harness, tally, &[1.0]),
};

/// Wide lines.
pub const WIDTH: Check = Check {
    name: "line-width",
    citation: "GL 2.1, 3.4.2: columns or rows of round(width) fragments",
    what: "every pixel of random lines of widths 0.4 to 10",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not; ends are exact in 1/256 pixels, ties are left out",
    run: |harness, tally| covered(harness, tally, &[0.4, 1.6, 3.0, 4.2, 6.0, 9.8]),
};

/// Stippled lines.
pub const STIPPLE: Check = Check {
    name: "line-stipple",
    citation: "GL 2.1, 3.4.2, equation 3.7: bit floor(s/r) mod 16, s goes on along strips",
    what: "every pixel of strips, loops and single lines under random patterns and factors",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a fragment is drawn or not",
    run: stippled,
};

/// Antialiased lines.
pub const SMOOTH: Check = Check {
    name: "line-smooth",
    citation: "GL 2.1, 3.4.2: the area that rectangle and pixel share",
    what: "alpha of every pixel of antialiased lines of widths 0.5 to 9",
    unit: Unit::FullScale,
    tolerance: 0.5 / (1 << 24) as f64,
    why: "an area up to 1 rounded to f32 and multiplied; ends are exact in 1/256 pixels",
    run: smooth,
};

/// Values along lines.
pub const VALUES: Check = Check {
    name: "line-interpolation",
    citation: "GL 2.1, 3.4.1, equations 3.4 and 3.6",
    what: "colour with perspective at every pixel of random lines",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 20) as f64,
    why: "f32: t up to 1 from window coordinates that are off by 2^-18 of at least 4 pixels, and a quotient",
    run: values,
};

/// Lines that share ends.
pub const JOINTS: Check = Check {
    name: "line-joints",
    citation: "GL 2.1, 2.6.1 and 3.4.1: strips and loops, segment by segment",
    what: "times that each pixel of GL_LINES, GL_LINE_STRIP and GL_LINE_LOOP is drawn, under additive blending",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "whole numbers; ties are left out",
    run: joints,
};

const PICTURE: Pixel = [59, 45];

/// A segment of at least a pixel; every other one is short.
fn segment(rng: &mut Rng, round: usize) -> Segment {
    loop {
        let from = point_between_ties(rng, PICTURE);
        let to = if round.is_multiple_of(2) {
            point_between_ties(rng, PICTURE)
        } else {
            from.map(|c| c + (rng.integer(-512, 512) * 2) as f64 / 256.0)
        };
        // What lies outside is clipped before it is widened.
        let seen = (0..2).all(|i| (0.0..PICTURE[i] as f64).contains(&to[i]));
        if seen && (0..2).any(|i| (to[i] - from[i]).abs() > 1.0) {
            return Segment { from, to };
        }
    }
}

fn vertex([x, y]: [f64; 2]) {
    glVertex2f(x as f32, y as f32);
}

fn draw(segment: &Segment) {
    glBegin(GL_LINES);
    vertex(segment.from);
    vertex(segment.to);
    glEnd();
}

fn covered(harness: &Harness, tally: &mut Tally, widths: &[f64]) -> Result<(), ProbeError> {
    let mut rng = Rng::named("line-width");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(192) {
        let (line, width) = (segment(&mut rng, round), widths[round % widths.len()]);
        let expect = |[x, y]: Pixel, variant: Variant| {
            line.covers([x as i64, y as i64], width, variant).map(drawn)
        };
        pictures.compare(&(line, width), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            glLineWidth(width as f32);
            glColor4f(1, 0, 0, 0);
            draw(&line);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(95, 0);
    Ok(())
}

/// The modes of lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Joined {
    Lines,
    Strip,
    Loop,
}

const MODES: [(Joined, u32); 3] =
    [(Joined::Lines, GL_LINES), (Joined::Strip, GL_LINE_STRIP), (Joined::Loop, GL_LINE_LOOP)];

/// The segments of vertices.
fn segments(mode: Joined, places: &[[f64; 2]], variant: Variant) -> Vec<Segment> {
    let count = match mode {
        Joined::Lines => places.len() / 2,
        Joined::Loop if !variant.has(Mutation::LoopNotClosed) => places.len(),
        Joined::Strip | Joined::Loop => places.len() - 1,
    };
    let step = if mode == Joined::Lines { 2 } else { 1 };
    let of =
        |k: usize| Segment { from: places[step * k], to: places[(step * k + 1) % places.len()] };
    (0..count).map(of).collect()
}

/// Places whose segments have no pixel on a tie.
fn untied(rng: &mut Rng, mode: Joined) -> Vec<[f64; 2]> {
    loop {
        let places: Vec<[f64; 2]> = (0..6).map(|_| point_between_ties(rng, PICTURE)).collect();
        let segments = segments(mode, &places, Variant::CORRECT);
        if segments.iter().all(|line| line.fragments(PICTURE, Variant::CORRECT).is_some()) {
            return places;
        }
    }
}

fn stippled(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("line-stipple");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(96) {
        let (mode, name) = MODES[round % 3];
        let places = untied(&mut rng, mode);
        let stipple = LineStipple {
            factor: rng.integer(1, 5) as u32,
            pattern: rng.integer(0, 0xffff) as u16,
        };
        let picture = |variant: Variant| {
            let mut times = vec![0.0; PICTURE[0] * PICTURE[1]];
            let mut number = 0;
            for line in segments(mode, &places, variant) {
                if mode == Joined::Lines || variant.has(Mutation::StippleRestarted) {
                    number = 0;
                }
                for [x, y] in line.fragments(PICTURE, variant)? {
                    if stipple.draws(number, variant) {
                        times[y as usize * PICTURE[0] + x as usize] += 1.0;
                    }
                    number += 1;
                }
            }
            Some(times)
        };
        let pictured = [Variant::CORRECT, harness.variant].map(|v| (v, picture(v)));
        let expect = |[x, y]: Pixel, variant: Variant| {
            let (_, times) = pictured.iter().find(|(v, _)| *v == variant)?;
            Some([times.as_ref()?[y * PICTURE[0] + x], 0.0, 0.0, 0.0])
        };
        pictures.compare(&(mode, stipple), expect, |session| {
            glEnable(GL_LINE_STIPPLE);
            glLineStipple(stipple.factor, stipple.pattern);
            counted(session, name, &places)
        })?;
    }
    pictures.finish(100, 1);
    Ok(())
}

/// How often each pixel is drawn by a primitive.
fn counted(session: &Session, mode: u32, places: &[[f64; 2]]) -> Result<Vec<[f64; 4]>, ProbeError> {
    session.frame(GL_RGBA32F, PICTURE, 0)?;
    window(PICTURE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glColor4f(1, 0, 0, 0);
    glBegin(mode);
    for at in places {
        vertex(*at);
    }
    glEnd();
    session.read_floats(PICTURE)
}

fn joints(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("line-joints");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(96) {
        let (mode, name) = MODES[round % 3];
        // Vertices on whole numbers are on corners of pixels, outside all diamonds.
        let places = untied(&mut rng, mode);
        let expect = |[x, y]: Pixel, variant: Variant| {
            let mut times = 0.0;
            for line in segments(mode, &places, variant) {
                times += f64::from(u8::from(line.exits([x as i64, y as i64], variant)?));
            }
            Some([times, 0.0, 0.0, 0.0])
        };
        pictures.compare(&mode, expect, |session| counted(session, name, &places))?;
    }
    pictures.finish(95, 1);
    Ok(())
}

fn smooth(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("line-smooth");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(96) {
        let (line, width) = (segment(&mut rng, round), rng.dyadic(0.5, 9.0, 1.0 / 8.0));
        let expect = |pixel: Pixel, variant: Variant| {
            Some([0.0, 0.0, 0.0, 0.5 * line.area(pixel, f64::from(width), variant)])
        };
        pictures.compare(&(line, width), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            glEnable(GL_LINE_SMOOTH);
            glLineWidth(width);
            glColor4f(0, 0, 0, 0.5);
            draw(&line);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 2);
    Ok(())
}

fn values(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("line-interpolation");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(96) {
        let line = segment(&mut rng, 2 * round);
        let colors = [0; 2].map(|_: i32| [0; 4].map(|_: i32| rng.real(0.0, 1.0)));
        let w = [0; 2].map(|_: i32| rng.dyadic(0.5, 4.0, 0.25));
        let expect = |[x, y]: Pixel, variant: Variant| {
            if !line.exits([x as i64, y as i64], Variant::CORRECT)? {
                return Some([0.0; 4]);
            }
            let t = line.parameter([x, y]);
            Some(std::array::from_fn(|i| {
                let ends = colors.map(|color| f64::from(color[i]));
                along(t, ends, w.map(f64::from), variant)
            }))
        };
        pictures.compare(&(line, w), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            glBegin(GL_LINES);
            for (k, [x, y]) in [line.from, line.to].into_iter().enumerate() {
                let [r, g, b, a] = colors[k];
                glColor4f(r, g, b, a);
                let w = f64::from(w[k]);
                glVertex4d(x * w, y * w, 0.0, w);
            }
            glEnd();
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(95, 0);
    Ok(())
}
