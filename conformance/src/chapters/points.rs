//! Points: which pixels they cover, how large they are, and sprites.

use super::pictures::{Pictures, Pixel, drawn, point_between_ties, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::point::{Attenuation, Dot, Origin};
use crate::probe::{ProbeError, Session, Stages};
use crate::rng::Rng;
use gl_api::constants::*;

/// Aliased points.
pub const SIZE: Check = Check {
    name: "point-size",
    citation: "GL 2.1, 3.3.1: squares about the nearest centre or corner of a pixel",
    what: "every pixel of points of sizes 0.3 to 17 at random places",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not; places are exact in 1/256 pixels, and not on a tie",
    run: size,
};

/// Antialiased points.
pub const SMOOTH: Check = Check {
    name: "point-smooth",
    citation: "GL 2.1, 3.3.1: the area that circle and pixel share",
    what: "alpha of every pixel of antialiased points of sizes 1 to 15",
    unit: Unit::FullScale,
    tolerance: 8.0 / (1 << 20) as f64,
    why: "f32 window coordinates up to 67: a centre that is off by 2^-18 along x and y moves an arc of a pixel by as much",
    run: smooth,
};

/// Distance attenuation.
pub const ATTENUATION: Check = Check {
    name: "point-attenuation",
    citation: "GL 2.1, 3.3: derived size = clamp(size · sqrt(1/(a + b·d + c·d²)))",
    what: "every pixel of sprites of attenuated size, clamped to GL_POINT_SIZE_MIN and _MAX",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not; centres within 1/128 of a side are left out",
    run: attenuation,
};

/// Coordinates of sprites.
pub const SPRITE: Check = Check {
    name: "point-sprite",
    citation: "GL 2.1, 3.3.1, equations 3.3: s = 1/2 + (x_f + 1/2 − x_w)/size",
    what: "generated texture coordinates at every pixel, from the upper and the lower left",
    unit: Unit::FullScale,
    tolerance: 2.0 / (1 << 20) as f64,
    why: "f32 window coordinates up to 67, off by 2^-18, over a size of at least 2",
    run: |harness, tally| sprite(harness, tally, Coordinates::Generated),
};

/// `gl_PointCoord` and `gl_PointSize`.
pub const POINT_COORD: Check = Check {
    name: "point-coord",
    citation: "GLSL 1.20, 7.1 and 7.2: gl_PointSize, gl_PointCoord",
    what: "gl_PointCoord at every pixel of points whose size the vertex shader writes",
    unit: Unit::FullScale,
    tolerance: 2.0 / (1 << 20) as f64,
    why: "f32 window coordinates up to 67, off by 2^-18, over a size of at least 2",
    run: |harness, tally| sprite(harness, tally, Coordinates::Shader),
};

/// An odd size, so that tiles and blocks end within the picture.
const PICTURE: Pixel = [61, 67];

fn draw(dots: &[Dot]) {
    for dot in dots {
        glPointSize(dot.size as f32);
        glBegin(GL_POINTS);
        glVertex2f(dot.at[0] as f32, dot.at[1] as f32);
        glEnd();
    }
}

fn size(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("point-size");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(48) {
        let dots: Vec<Dot> = (0..12)
            .map(|_| {
                // Not on the tie between two sizes.
                let size = rng.integer(1, 17) as f64 + f64::from(rng.real(-0.45, 0.45));
                Dot {
                    at: point_between_ties(&mut rng, PICTURE),
                    size: if size > 1.0 { size } else { size / 2.0 },
                }
            })
            .collect();
        let expect = |pixel: Pixel, variant: Variant| {
            let times = dots.iter().filter(|dot| dot.covers(pixel, variant)).count();
            Some([times as f64, 0.0, 0.0, 0.0])
        };
        pictures.compare(&dots[0], expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
            glColor4f(1, 0, 0, 0);
            draw(&dots);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 10);
    Ok(())
}

fn smooth(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("point-smooth");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(64) {
        // Sixteenths, which the rasterizer has exactly.
        let size = f64::from(rng.dyadic(1.0, 15.0, 1.0 / 16.0));
        let dot = Dot { at: point_between_ties(&mut rng, PICTURE), size };
        let expect =
            |pixel: Pixel, variant: Variant| Some([0.0, 0.0, 0.0, 0.75 * dot.area(pixel, variant)]);
        pictures.compare(&dot, expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            glEnable(GL_POINT_SMOOTH);
            glColor4f(0, 0, 0, 0.75);
            draw(&[dot]);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 1);
    Ok(())
}

fn attenuation(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("point-attenuation");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    let mut clamped = [0usize; 2];
    for _ in 0..harness.cases(64).max(24) {
        let factors = [rng.real(0.1, 1.0), rng.real(0.0, 0.5), rng.real(0.0, 0.2)];
        let by = Attenuation {
            factors: factors.map(f64::from),
            min: f64::from(rng.real(1.0, 4.0)),
            max: f64::from(rng.real(12.0, 24.0)),
        };
        let (given, distance) = (rng.real(2.0, 40.0), rng.real(0.5, 8.0));
        let derived = |variant| by.size(f64::from(given), f64::from(distance), variant);
        clamped[0] += usize::from(derived(Variant::CORRECT) == by.min);
        clamped[1] += usize::from(derived(Variant::CORRECT) == by.max);
        let at = point_between_ties(&mut rng, PICTURE);
        let expect = |pixel: Pixel, variant: Variant| {
            Dot { at, size: derived(variant) }.sprite_covers(pixel).map(drawn)
        };
        pictures.compare(&(by, given, distance), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            // The point lies in the direction (0.48, 0.6, −0.64) from the eye; the projection moves it to its place.
            let [x, y, z] = [0.48, 0.6, -0.64].map(|c| c * distance);
            glMatrixMode(GL_PROJECTION);
            glLoadIdentity();
            let [w, h] = PICTURE.map(|n| n as f64);
            glTranslated(2.0 * at[0] / w - 1.0, 2.0 * at[1] / h - 1.0, 0.0);
            glScalef(0, 0, 0);
            glMatrixMode(GL_MODELVIEW);
            glLoadIdentity();
            glEnable(GL_POINT_SPRITE);
            glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, &factors);
            glPointParameterf(GL_POINT_SIZE_MIN, by.min as f32);
            glPointParameterf(GL_POINT_SIZE_MAX, by.max as f32);
            glPointSize(given);
            glColor4f(1, 0, 0, 0);
            glBegin(GL_POINTS);
            glVertex3f(x, y, z);
            glEnd();
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(95, 0);
    tally.reach("sizes at the least", clamped[0], 1);
    tally.reach("sizes at the most", clamped[1], 1);
    Ok(())
}

/// Where coordinates come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Coordinates {
    /// `GL_COORD_REPLACE`.
    Generated,
    /// `gl_PointCoord`.
    Shader,
}

fn sprite(harness: &Harness, tally: &mut Tally, from: Coordinates) -> Result<(), ProbeError> {
    let mut rng = Rng::named("point-sprite");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(64) {
        let origin = [Origin::UpperLeft, Origin::LowerLeft][round % 2];
        let dot =
            Dot { at: point_between_ties(&mut rng, PICTURE), size: f64::from(rng.real(2.0, 40.0)) };
        let expect = |pixel: Pixel, variant: Variant| {
            let covered = dot.sprite_covers(pixel)?;
            let [s, t] = dot.sprite(pixel, origin, variant);
            Some(if covered { [s, t, 0.0, 1.0] } else { [0.0; 4] })
        };
        pictures.compare(&(dot, origin), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            let name = match origin {
                Origin::UpperLeft => GL_UPPER_LEFT,
                Origin::LowerLeft => GL_LOWER_LEFT,
            };
            glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, name as i32);
            glEnable(GL_POINT_SPRITE);
            prepare(session, from)?;
            match from {
                Coordinates::Generated => glPointSize(dot.size as f32),
                // The shader's size stands for this one.
                Coordinates::Shader => glPointSize(1),
            }
            glBegin(GL_POINTS);
            glTexCoord1f(dot.size as f32);
            glVertex2f(dot.at[0] as f32, dot.at[1] as f32);
            glEnd();
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(95, 1);
    Ok(())
}

fn prepare(session: &Session, from: Coordinates) -> Result<(), ProbeError> {
    match from {
        Coordinates::Generated => {
            glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, 1);
            session.show_coordinates()
        }
        Coordinates::Shader => {
            glEnable(GL_VERTEX_PROGRAM_POINT_SIZE);
            let vertex = "void main() {
                    gl_Position = ftransform(); gl_PointSize = gl_MultiTexCoord0.x; }";
            let fragment = "void main() { gl_FragColor = vec4(gl_PointCoord, 0.0, 1.0); }";
            session.stages(&Stages { vertex, geometry: "", fragment }).map(|_| ())
        }
    }
}
