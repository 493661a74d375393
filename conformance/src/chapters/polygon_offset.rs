//! Depth offset of polygons: the constant part, and the part that follows the slope.

use super::pictures::{Pixel, cover, point_between_ties, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::painter::inside;
use crate::oracle::polygon::{resolvable, slopes, steepness};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// The constant part of depth offset.
pub const OFFSET_UNITS: Check = Check {
    name: "polygon-offset-units",
    citation: "GL 2.1, 3.5.5: o = r · units on a level polygon",
    what: "r in steps of the buffer, from 1 to 2, of 16 and 24 bits and of floats, units -40 to 40",
    unit: Unit::Codes,
    tolerance: 0.0625,
    why: "half a step of the depth, over at least 8 units: 1/16",
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

const PICTURE: Pixel = [67, 53];

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
                let [x, y] = point_between_ties(&mut rng, PICTURE);
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
