//! Depth buffers: the precision of stored depths, reversed and inverted ranges, polygon offset,
//! planes that coincide, shadows.

use super::definition::Sweep;
use super::series::{Compared, Series, octaves};
use crate::gl::*;
use crate::probe::{DepthBuffer, ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;

/// Near and far planes.
pub const PRECISION: Sweep = Sweep {
    name: "depth-precision",
    what: "window depth kept of planes between the near and the far plane, in 16 and 24 bits and \
           floats",
    parameter: "far over near",
    unit: "steps of the buffer",
    bound: 1.0,
    why: "half a step of rounding, and the f32 clip coordinates of the plane",
    breaks: "from 1e6 on (24 bits) planes beyond a thousand near distances share a step: they cannot \
             be told apart, but each is kept to its step",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: precision,
};

/// Reversed depth.
pub const REVERSED: Sweep = Sweep {
    name: "depth-reversed",
    what: "the relative error of depths near/z in a float buffer, near = 1 and far = 0 by \
           glClipControl(…, GL_ZERO_TO_ONE)",
    parameter: "z over near",
    unit: "of 2^-24",
    bound: 1.5,
    why: "a division and a rounding: floats are as precise near 0 as near 1",
    breaks: "nowhere to 1e30: this is what reversed depth is for; GL's own range of -1 to 1 would keep \
             nothing beyond 1e7",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: reversed,
};

/// Inverted depth ranges.
pub const RANGE: Sweep = Sweep {
    name: "depth-range-inverted",
    what: "window depth under glDepthRange(0.5 + d, 0.5 - d), against (f - n)/2·z + (n + f)/2",
    parameter: "d",
    unit: "of 2^-24",
    bound: 1.0,
    why: "the scale and the offset are f32 or better; the depth is stored in floats",
    breaks: "below 3e-8 the range is a single float: every depth is 0.5",
    kept: 1.0,
    distinct: 0.7,
    before: &[],
    run: range,
};

/// Polygon offset.
pub const OFFSET: Sweep = Sweep {
    name: "polygon-offset",
    what: "the depth that glPolygonOffset(1, 0) adds to a plane whose depth grows by this much a \
           pixel, as part of it",
    parameter: "depth over a pixel",
    unit: "of 2^-24/depth",
    bound: 1.7,
    why: "the slope is of f64 planes; two depths of floats about 0.5 are taken from each other",
    breaks: "slopes above 1/4 leave the range of depths within the four pixels that are looked at; \
             edge on, a slope is that of what is left of the triangle after snapping",
    kept: 0.2,
    distinct: 0.7,
    before: &[],
    run: offset,
};

/// Planes that coincide.
pub const COPLANAR: Sweep = Sweep {
    name: "coplanar",
    what: "the difference of depths that two triangles of different corners have in one plane, \
           whose depth grows by this much a pixel",
    parameter: "depth over a pixel",
    unit: "steps of 24 bits",
    bound: 1.0,
    why: "each is rounded to 24 bits, and f64 planes differ by less",
    breaks: "nowhere do coplanar triangles agree exactly unless they share corners: which one is in \
             front is decided by rounding, within these steps",
    kept: 0.9,
    distinct: 0.7,
    before: &[],
    run: coplanar,
};

/// Bias of shadows.
pub const SHADOW: Sweep = Sweep {
    name: "shadow-bias",
    what: "pixels of a lit plane whose depth grows by this much a texel of its shadow map, compared \
           with GL_LEQUAL under a bias of 1/1024: those in shadow wrongly (acne), against the share \
           that f64 has",
    parameter: "slope: depth over a texel",
    unit: "pixels of 1024",
    bound: 0.0,
    why: "the reference and the texel are compared as floats: f64 compares them alike",
    breaks: "acne begins where half the slope exceeds the bias, at 1/512, and covers half of the plane \
             in the end; a bias that prevents it moves shadows by bias/slope texels (peter-panning)",
    kept: 1.0,
    distinct: 0.4,
    before: &[],
    run: shadow,
};

fn precision() -> Result<Vec<Series>, ProbeError> {
    let mut lines = Vec::new();
    let buffers = [
        (DepthBuffer::Bits16, 65535.0),
        (DepthBuffer::Bits24, 16_777_215.0),
        // A float's step below 1 is 2^-24.
        (DepthBuffer::Float, 16_777_216.0),
    ];
    for (buffer, steps) in buffers {
        let session = Session::open()?;
        session.depth_buffer(buffer)?;
        let ratios = (1..=24).map(|step| 10f64.powf(f64::from(step) / 2.0));
        lines.push(Series::measured(buffer.name(), ratios, |ratio| {
            let (near, far) = (1e-3, 1e-3 * ratio);
            let mut compared = Compared::new();
            for k in 1..32 {
                // Places between the planes, evenly by their logarithm.
                let z = near * ratio.powf(f64::from(k) / 32.0);
                let clip_z = (far + near) / (far - near) * z - 2.0 * far * near / (far - near);
                let (clip_z, w) = (clip_z as f32, z as f32);
                let exact = f64::from(clip_z) / f64::from(w) * 0.5 + 0.5;
                let kept = session.kept_depth(clip_z, w)?;
                compared.add((kept - exact).abs() * steps, &[kept]);
            }
            Ok(compared)
        })?);
    }
    Ok(lines)
}

fn reversed() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    session.depth_buffer(DepthBuffer::Float)?;
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    let far = (0..=60).map(|step| 10f64.powf(f64::from(step) / 2.0));
    let line = Series::measured("largest error", far, |far| {
        let mut rng = Rng::named("depth-reversed");
        let mut compared = Compared::new();
        for _ in 0..16 {
            // The plane z = w/z of clip coordinates (…, near, z).
            let z = (far * f64::from(rng.real(1.0, 3.0))) as f32;
            let kept = session.kept_depth(1.0, z)?;
            let exact = 1.0 / f64::from(z);
            compared.add((kept - exact).abs() / (exact * 2f64.powi(-24)), &[kept]);
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}

fn range() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    session.depth_buffer(DepthBuffer::Float)?;
    let line = Series::measured("largest error", octaves(-28..=-1, 1), |d| {
        session.depth_range([0.5 + d, 0.5 - d]);
        let mut rng = Rng::named("depth-range");
        let mut compared = Compared::new();
        for _ in 0..16 {
            let z = rng.real(-1.0, 1.0);
            let kept = session.kept_depth(z, 1.0)?;
            let exact = 0.5 - d * f64::from(z);
            compared.add((kept - exact).abs() / 2f64.powi(-24), &[kept]);
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}

/// The depths of the 4×4 pixels after triangles, whose corners are (x, y, depth) in pixels and window depth.
fn depths(session: &Session, corners: &[[f64; 3]]) -> Result<Vec<f64>, ProbeError> {
    glClearDepth(1.0);
    glClear(GL_DEPTH_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    for [x, y, z] in corners {
        glVertex3d(x / 2.0 - 1.0, y / 2.0 - 1.0, 2.0 * z - 1.0);
    }
    glEnd();
    let mut depths = [0.0f32; 16];
    glReadPixels(0, 0, 4, 4, GL_DEPTH_COMPONENT, GL_FLOAT, &mut depths);
    session.check("reading depths")?;
    Ok(depths.into_iter().map(f64::from).collect())
}

fn offset() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    session.depth_buffer(DepthBuffer::Float)?;
    let line = Series::measured("largest error", octaves(-20..=-2, 1), |slope| {
        // No power of two: nothing is exact by chance.
        let slope = 0.83 * slope;
        let depth = |x: f64| 0.5 + slope * (x - 2.0);
        let corners = [[-4.0, -4.0], [12.0, -4.0], [-4.0, 12.0]].map(|[x, y]| [x, y, depth(x)]);
        let plain = depths(&session, &corners)?;
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(1.0, 0.0);
        let moved = depths(&session, &corners)?;
        glDisable(GL_POLYGON_OFFSET_FILL);
        let mut compared = Compared::new();
        for (pixel, (plain, moved)) in plain.iter().zip(&moved).enumerate() {
            let exact = depth((pixel % 4) as f64 + 0.5);
            if exact > 0.01 && exact + slope < 0.99 {
                let error = ((moved - plain) - slope).abs().max((plain - exact).abs());
                compared.add(error / 2f64.powi(-24), &[*plain, *moved]);
            } else {
                compared.leave_out();
            }
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}

fn coplanar() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    session.depth_buffer(DepthBuffer::Bits24)?;
    let line = Series::measured("largest difference", octaves(-24..=-4, 1), |slope| {
        let mut rng = Rng::named("coplanar");
        let depth = |x: f64, y: f64| 0.5 + slope * (x - 2.0) + 0.3 * slope * (y - 2.0);
        let mut compared = Compared::new();
        let mut first: Option<Vec<f64>> = None;
        for _ in 0..16 {
            // About a triangle that covers all, corners at multiples of 1/256 of a pixel.
            let corners = [[-3.0, -3.0], [11.0, -2.0], [-2.0, 11.0f64]].map(|[x, y]| {
                let mut near = |c: f64| c + f64::from(rng.dyadic(-0.5, 0.5, 1.0 / 256.0));
                let (x, y) = (near(x), near(y));
                [x, y, depth(x, y)]
            });
            let found = depths(&session, &corners)?;
            match &first {
                None => first = Some(found),
                Some(first) => {
                    for (a, b) in first.iter().zip(&found) {
                        compared.add((a - b).abs() * 16_777_215.0, &[*a, *b]);
                    }
                }
            }
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}

fn shadow() -> Result<Vec<Series>, ProbeError> {
    const TEXELS: usize = 64;
    const BIAS: f64 = 1.0 / 1024.0;
    let session = Session::open()?;
    let line = Series::measured(
        "pixels that differ",
        octaves(-14..=-7, 1)
            .chain([1.2, 1.5, 1.7, 1.9, 2.1, 2.4, 2.7, 3.1].map(|part| part / 1024.0)),
        |slope| {
            // The map holds the plane's depth at the centre of each texel, in 16 bits.
            let depth = |u: f64| 0.25 + slope * u;
            let row: Vec<u16> =
                (0..TEXELS).map(|i| (depth(i as f64 + 0.5) * 65535.0).round() as u16).collect();
            session.depth_texture(&crate::probe::DepthTexture {
                compare: crate::oracle::compare::Compare::LessEqual,
                filter: crate::oracle::lod::Filter::Nearest,
                row: &row,
            })?;
            let mut rng = Rng::named("shadow-bias");
            let inputs: Vec<_> = (0..1024)
                .map(|_| {
                    let u = f64::from(rng.real(0.0, TEXELS as f64));
                    let reference = (depth(u) - BIAS) as f32;
                    [[(u / TEXELS as f64) as f32, 0.5, reference, 0.0], [0.0; 4], [0.0; 4]]
                })
                .collect();
            let values = session.field(crate::probe::shader::SHADOW_2D, 1, &inputs)?;
            let (mut of_driver, mut of_formula) = (0.0, 0.0);
            let mut compared = Compared::new();
            for (input, value) in inputs.iter().zip(&values) {
                let i = ((f64::from(input[0][0]) * TEXELS as f64) as usize).min(TEXELS - 1);
                let lit = f64::from(input[0][2]) <= f64::from(row[i]) / 65535.0;
                of_formula += if lit { 0.0 } else { 1.0 };
                of_driver += 1.0 - value[0];
                compared.add(0.0, &value[..1]);
            }
            compared.add(f64::abs(of_driver - of_formula), &[of_driver]);
            Ok(compared)
        },
    )?;
    Ok(vec![line])
}
