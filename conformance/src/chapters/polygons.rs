//! Polygons: stipple, culling, modes, antialiasing, and user clip planes.

use super::pictures::{Pictures, Pixel, color, cover, drawn, point_between_ties, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::line::Segment;
use crate::oracle::matrix;
use crate::oracle::painter::inside;
use crate::oracle::polygon::{PolygonStipple, shared_area, signed_area};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Stippled polygons.
pub const STIPPLE: Check = Check {
    name: "polygon-stipple",
    citation: "GL 2.1, 3.5.2: bit (x mod 32, y mod 32)",
    what: "every pixel of rectangles under random stipples, whole and of one bit",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a fragment is drawn or not",
    run: stipple,
};

/// Facing and culling.
pub const CULL: Check = Check {
    name: "cull-face",
    citation: "GL 2.1, 3.5.1 and equation 2.6: the sign of the area; glFrontFace, glCullFace",
    what: "whether random triangles, fans and quads of either winding are drawn, for each state",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a polygon is drawn or not",
    run: cull,
};

/// Polygons as lines and points.
pub const MODE: Check = Check {
    name: "polygon-mode",
    citation: "GL 2.1, 3.5.4 and 2.6.2: edges and vertices with edge flags",
    what: "every pixel of random polygons in GL_LINE and GL_POINT mode with random edge flags",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not; ties of lines are left out",
    run: mode,
};

/// Antialiased polygons.
pub const SMOOTH: Check = Check {
    name: "polygon-smooth",
    citation: "GL 2.1, 3.5.3: coverage is the area of the polygon in the pixel",
    what: "alpha of every pixel of antialiased triangles and slivers",
    unit: Unit::FullScale,
    tolerance: 1.75 / (1 << 24) as f64,
    why: "an area up to 1 rounded to f32 and multiplied; corners are exact in 1/256 pixels",
    run: smooth,
};

/// User clip planes.
pub const CLIP: Check = Check {
    name: "clip-plane",
    citation: "GL 2.1, 2.12: p · M⁻¹ of the matrix of glClipPlane, p′ · eye ≥ 0",
    what: "every pixel of a square under one to six planes that were given under other matrices",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not; centres within 1/128 pixel of an edge are left out: cut corners are snapped to 1/256",
    run: clip,
};

const PICTURE: Pixel = [67, 53];

fn stipple(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("polygon-stipple");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(32) {
        let mut rows = [0u32; 32];
        if round % 4 == 1 {
            rows[rng.integer(0, 31) as usize] = 1 << rng.integer(0, 31);
        } else {
            rows =
                rows.map(|_| u32::from_le_bytes([rng.byte(), rng.byte(), rng.byte(), rng.byte()]));
        }
        let of = PolygonStipple(rows);
        let low = [rng.integer(0, 20) as usize, rng.integer(0, 20) as usize];
        let expect = |pixel: Pixel, variant: Variant| {
            let within = pixel[0] >= low[0] && pixel[1] >= low[1];
            Some(drawn(within && of.draws(pixel, variant)))
        };
        pictures.compare(&low, expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            let bytes: Vec<u8> = rows.iter().flat_map(|row| row.to_be_bytes()).collect();
            glPolygonStipple(&bytes);
            glEnable(GL_POLYGON_STIPPLE);
            glColor4f(1, 0, 0, 0);
            let [w, h] = PICTURE;
            glRecti(low[0] as i32, low[1] as i32, w as i32, h as i32);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 10);
    Ok(())
}

const FACES: [u32; 3] = [GL_FRONT, GL_BACK, GL_FRONT_AND_BACK];

fn cull(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("cull-face");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(96).max(36) {
        let counter_clockwise = round % 2 == 0;
        let face = FACES[round / 2 % 3];
        let triangle: [[f64; 2]; 3] = loop {
            let triangle = [
                point_between_ties(&mut rng, PICTURE),
                point_between_ties(&mut rng, PICTURE),
                point_between_ties(&mut rng, PICTURE),
            ];
            if signed_area(&triangle).abs() > 200.0 {
                break triangle;
            }
        };
        let expect = |[x, y]: Pixel, variant: Variant| {
            let ccw = counter_clockwise != variant.has(Mutation::FrontFaceSwapped);
            let front = (signed_area(&triangle) > 0.0) == ccw;
            let culled = match face {
                GL_FRONT => front,
                GL_BACK => !front,
                _ => !variant.has(Mutation::BothNotCulled),
            };
            let within = inside(triangle, [x as f64 + 0.5, y as f64 + 0.5])?;
            Some(drawn(within && !culled))
        };
        pictures.compare(&(counter_clockwise, face), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            glFrontFace(if counter_clockwise { GL_CCW } else { GL_CW });
            glCullFace(face);
            glEnable(GL_CULL_FACE);
            glColor4f(1, 0, 0, 0);
            glBegin([GL_TRIANGLES, GL_TRIANGLE_FAN, GL_POLYGON][round % 3]);
            for [x, y] in triangle {
                glVertex2f(x as f32, y as f32);
            }
            glEnd();
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(98, 1);
    Ok(())
}

fn mode(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("polygon-mode");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(96).max(8) {
        let lines = round % 2 == 0;
        // Convex: corners in order about the centre.
        let count = 3 + round % 4;
        let corners: Vec<[f64; 2]> = (0..count)
            .map(|k| {
                let turn = (k as f64 + 0.4 * f64::from(rng.real(-1.0, 1.0))) / count as f64;
                let (sin, cos) = (turn * std::f64::consts::TAU).sin_cos();
                [33.0 + 30.0 * cos, 26.0 + 24.0 * sin]
                    .map(|c| (c * 128.0).floor() / 128.0 + 1.0 / 256.0)
            })
            .collect();
        let flags: Vec<bool> = (0..count).map(|_| rng.integer(0, 2) > 0).collect();
        let expect = |[x, y]: Pixel, variant: Variant| {
            let mut times = 0.0;
            for (k, &from) in corners.iter().enumerate() {
                if !flags[k] && !variant.has(Mutation::EdgeFlagsIgnored) {
                    continue;
                }
                let covered = if lines {
                    let line = Segment { from, to: corners[(k + 1) % count] };
                    line.exits([x as i64, y as i64], variant)?
                } else {
                    from.map(|c| c.floor() as usize) == [x, y]
                };
                times += f64::from(u8::from(covered));
            }
            Some([times, 0.0, 0.0, 0.0])
        };
        pictures.compare(&(lines, &flags), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
            glPolygonMode(GL_FRONT_AND_BACK, if lines { GL_LINE } else { GL_POINT });
            glColor4f(1, 0, 0, 0);
            glBegin(GL_POLYGON);
            for (k, [x, y]) in corners.iter().enumerate() {
                glEdgeFlag(flags[k]);
                glVertex2f(*x as f32, *y as f32);
            }
            glEnd();
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(95, 0);
    Ok(())
}

fn smooth(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("polygon-smooth");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(96) {
        let mut triangle = [
            point_between_ties(&mut rng, PICTURE),
            point_between_ties(&mut rng, PICTURE),
            point_between_ties(&mut rng, PICTURE),
        ];
        if round % 3 == 1 {
            triangle[2] = triangle[0].map(|c| c + 0.5);
        }
        let expect = |pixel: Pixel, variant: Variant| {
            let area = if variant.has(Mutation::CoverageOfCentre) {
                let at = pixel.map(|c| c as f64 + 0.5);
                f64::from(u8::from(inside(triangle, at) == Some(true)))
            } else {
                shared_area(&triangle, pixel)
            };
            Some([0.0, 0.0, 0.0, 0.875 * area])
        };
        pictures.compare(&triangle, expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            glEnable(GL_POLYGON_SMOOTH);
            color([0.0, 0.0, 0.0, 0.875]);
            glBegin(GL_TRIANGLES);
            for [x, y] in triangle {
                glVertex2f(x as f32, y as f32);
            }
            glEnd();
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 4);
    Ok(())
}

fn clip(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("clip-plane");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(64).max(6) {
        let count = 1 + round % 6;
        // Planes through places near the middle of the picture, under a matrix that scales and moves.
        let planes: Vec<([f32; 16], [f64; 4])> = (0..count)
            .map(|_| {
                let mut m = [0.0f32; 16];
                let (sin, cos) = rng.real(-3.0, 3.0).sin_cos();
                let scale = rng.dyadic(0.5, 2.0, 0.25);
                (m[0], m[1], m[4], m[5]) = (scale * cos, scale * sin, -scale * sin, scale * cos);
                (m[10], m[15]) = (1.0, 1.0);
                (m[12], m[13]) = (rng.dyadic(0.0, 60.0, 1.0), rng.dyadic(0.0, 50.0, 1.0));
                let normal = [0; 2].map(|_: i32| f64::from(rng.real(-1.0, 1.0)));
                (m, [normal[0], normal[1], 0.0, f64::from(rng.real(4.0, 12.0))])
            })
            .collect();
        let expect = |[x, y]: Pixel, variant: Variant| {
            let at = [x as f64 + 0.5, y as f64 + 0.5, 0.5, 1.0];
            for (m, plane) in &planes {
                let eye = if variant.has(Mutation::ClipPlaneNotMoved) {
                    *plane
                } else {
                    matrix::apply_row(*plane, &matrix::inverse(&matrix::from_columns(m)))
                };
                let side: f64 = (0..4).map(|i| eye[i] * at[i]).sum();
                let distance = side / eye[0].hypot(eye[1]);
                if distance.abs() < 1.0 / 64.0 {
                    return None;
                }
                if (distance < 0.0) != variant.has(Mutation::ClipSideSwapped) {
                    return Some(drawn(false));
                }
            }
            Some(drawn(true))
        };
        pictures.compare(&count, expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            for (number, (m, plane)) in (0..).zip(&planes) {
                glLoadMatrixf(m);
                glClipPlane(GL_CLIP_PLANE0 + number, plane);
                glEnable(GL_CLIP_PLANE0 + number);
            }
            glLoadIdentity();
            glColor4f(1, 0, 0, 0);
            cover(PICTURE, 0.5);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(90, 10);
    Ok(())
}
