//! Polygons: stipple, depth offset, culling, modes, antialiasing, and user clip planes.

use super::pictures::{Pictures, Pixel, color, cover, drawn, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::{Mutation, Variant};
use crate::oracle::line::Segment;
use crate::oracle::matrix;
use crate::oracle::painter::inside;
use crate::oracle::polygon::{
    PolygonStipple, resolvable, shared_area, signed_area, slopes, steepness,
};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;
use gl_api::entry::*;

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

/// The constant part of depth offset.
pub const OFFSET_UNITS: Check = Check {
    name: "polygon-offset-units",
    citation: "GL 2.1, 3.5.5: o = r · units on a level polygon",
    what: "r in steps of the buffer, from 1 to 2, of 16 and 24 bits and of floats, units -40 to 40",
    unit: Unit::Codes,
    tolerance: 0.07,
    why: "half a step of the depth, over at least 8 units",
    run: offset_units,
};

/// The part of depth offset that follows the slope.
pub const OFFSET_SLOPE: Check = Check {
    name: "polygon-offset-slope",
    citation: "GL 2.1, 3.5.5, equations 3.11 to 3.13: o = m · factor, m from max(|∂z/∂x|, |∂z/∂y|) to the root of squares",
    what: "depths with factors -3 to 3 minus depths without, at every pixel of random slopes, as a multiple of m",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 16) as f64,
    why: "f32 depths up to 1: two roundings of 2^-25 over slopes of at least 2^-8",
    run: offset_slope,
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

fn place(rng: &mut Rng) -> [f64; 2] {
    PICTURE.map(|n| (rng.integer(0, n as i64 * 128 - 1) * 2 + 1) as f64 / 256.0)
}

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

const DEPTHS: [(u32, Option<u32>); 3] = [
    (GL_DEPTH_COMPONENT16, Some(16)),
    (GL_DEPTH_COMPONENT24, Some(24)),
    (GL_DEPTH_COMPONENT32F, None),
];

fn offset_units(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("polygon-offset-units");
    for (format, bits) in DEPTHS {
        // Depths, and units.
        let cases: Vec<[f32; 2]> = (0..harness.cases(256))
            .map(|_| {
                let units = rng.dyadic(8.0, 40.0, 0.5) * rng.pick(&[1.0, -1.0]);
                [rng.dyadic(0.25, 0.75, 1.0 / 1024.0), units]
            })
            .collect();
        // The least and the largest r that is allowed, as a multiple of a step.
        let expect = |&[z, _]: &[f32; 2], variant: Variant| {
            let z = f64::from(z);
            let of = if variant.has(Mutation::OffsetOfOne) { 1.0 } else { z };
            let r = resolvable(bits, of) / resolvable(bits, z);
            let r = if variant.has(Mutation::OffsetQuartered) { r / 4.0 } else { r };
            [r, 2.0 * r, 0.0, 0.0]
        };
        let error = |_: &[f32; 2], [least, largest, ..]: [f64; 4], found: [f64; 4]| {
            (least - found[1]).max(found[0] - largest).max(0.0)
        };
        harness.compare_by(tally, &enum_name(format), &cases, expect, error, |session| {
            session.deep_frame(GL_RGBA8, format, [8, 8], 0)?;
            window([8, 8]);
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_ALWAYS);
            glEnable(GL_POLYGON_OFFSET_FILL);
            let mut found = Vec::new();
            for &[z, units] in &cases {
                glPolygonOffset(0, units);
                cover([8, 8], f64::from(z));
                let moved = session.read_depth_codes([8, 8])?[27] - f64::from(z);
                let r = moved / f64::from(units) / resolvable(bits, f64::from(z));
                found.push([r, r, 0.0, 0.0]);
            }
            Ok(found)
        })?;
    }
    Ok(())
}

fn offset_slope(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("polygon-offset-slope");
    let mut steep = 0;
    for _ in 0..harness.cases(48).max(12) {
        let corners: [[f64; 3]; 3] = loop {
            let corners: [[f64; 3]; 3] = std::array::from_fn(|_| {
                let [x, y] = place(&mut rng);
                [x, y, f64::from(rng.real(0.3, 0.7))]
            });
            let [x, y] = slopes(corners);
            // Offsets of up to 3 m stay within the depth range.
            if (1.0 / 256.0..1.0 / 16.0).contains(&x.abs().max(y.abs())) {
                break corners;
            }
        };
        let flat = corners.map(|[x, y, _]| [x, y]);
        let pixels: Vec<Pixel> = super::pictures::all(PICTURE)
            .filter(|&[x, y]| inside(flat, [x as f64 + 0.5, y as f64 + 0.5]) == Some(true))
            .collect();
        steep += pixels.len();
        if pixels.is_empty() {
            continue;
        }
        let factor = rng.pick(&[-3.0, -1.5, 1.0, 2.0, 3.0f32]);
        let of = slopes(corners);
        let [least, _] = steepness(of, Variant::CORRECT);
        let expect = |_: &Pixel, variant: Variant| {
            let [low, high] = steepness(of, variant).map(|m| m / least);
            [low, high, 0.0, 0.0]
        };
        let error = |_: &Pixel, [low, high, ..]: [f64; 4], found: [f64; 4]| {
            // Anywhere from the one to the other.
            (low - found[1]).max(found[0] - high).max(0.0)
        };
        harness.compare_by(tally, &(corners, factor), &pixels, expect, error, |session| {
            session.deep_frame(GL_RGBA8, GL_DEPTH_COMPONENT32F, PICTURE, 0)?;
            window(PICTURE);
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_ALWAYS);
            let mut depths = Vec::new();
            for offset in [0.0, factor] {
                glEnable(GL_POLYGON_OFFSET_FILL);
                glPolygonOffset(offset, 0);
                glBegin(GL_TRIANGLES);
                for [x, y, z] in corners {
                    glVertex3f(x as f32, y as f32, z as f32);
                }
                glEnd();
                depths.push(session.read_depths(PICTURE)?);
            }
            let multiple = |&[x, y]: &Pixel| {
                let at = y * PICTURE[0] + x;
                let m = (depths[1][at][0] - depths[0][at][0]) / (f64::from(factor) * least);
                [m, m, 0.0, 0.0]
            };
            Ok(pixels.iter().map(multiple).collect())
        })?;
    }
    tally.reach("pixels of slopes", steep, 1000);
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
            let triangle = [place(&mut rng), place(&mut rng), place(&mut rng)];
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
        let mut triangle = [place(&mut rng), place(&mut rng), place(&mut rng)];
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
