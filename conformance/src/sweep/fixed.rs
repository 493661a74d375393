//! The fixed function at its extremes: fog, normals under large scales, specular exponents.

use super::definition::Sweep;
use super::series::{Compared, Series, decades};
use crate::gl::*;
use crate::oracle::combine::Fog;
use crate::probe::{ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;

/// Fog between ends that meet.
pub const THIN_FOG: Sweep = Sweep {
    name: "thin-fog",
    what: "the factor of linear fog between 1000 and 1000·(1 + d), of fog coordinates between and on \
           either side",
    parameter: "d",
    unit: "of 2^-24",
    bound: 3.0,
    why: "(end - c)/(end - start): the difference is exact nearby, then a product with the \
          reciprocal, and the mixture of two colours",
    breaks: "from 6e-8 on the ends are the same float: clear in front of it, fog behind it, and all \
             fog on it",
    kept: 1.0,
    distinct: 0.5,
    before: &[(1e-7, 1.6e7), (1e-4, 1.2e4)],
    run: thin_fog,
};

/// Densities of all sizes.
pub const DENSE_FOG: Sweep = Sweep {
    name: "fog-density",
    what: "the factor of GL_EXP and GL_EXP2 fog of this density, of fog coordinates up to 3/density",
    parameter: "density",
    unit: "of 2^-24",
    bound: 3.0,
    why: "the exponent has a relative error of some 2^-24, and e^-x·x is below 1/e",
    breaks: "a density times log2(e) that leaves f32, beyond 2.3e38, is infinite: all fog but at 0",
    kept: 1.0,
    distinct: 0.5,
    before: &[],
    run: dense_fog,
};

/// Normals under large scales.
pub const NORMAL_SCALE: Sweep = Sweep {
    name: "normal-scale",
    what: "diffuse light with GL_NORMALIZE under a model-view matrix that scales by this much",
    parameter: "scale",
    unit: "of 2^-24",
    bound: 3.0,
    why: "the scaled normal is made a unit vector, whatever its length; a dot product with the light",
    breaks: "a scale beyond 3e38, or below 3e-39, has no inverse in f32: no promise but a colour in range",
    kept: 1.0,
    distinct: 0.1,
    before: &[],
    run: normal_scale,
};

/// Highlights of large exponents.
pub const SHININESS: Sweep = Sweep {
    name: "shininess",
    what: "the specular term of GL_SHININESS 128 at this angle from the highlight's middle",
    parameter: "angle in radians",
    unit: "of 2^-24",
    bound: 200.0,
    why: "N·H is rounded to a few 2^-24, which the exponent of 128 multiplies",
    breaks: "below 1e-4 the cosine is 1 in f32: the highlight is flat there",
    kept: 1.0,
    distinct: 0.3,
    before: &[],
    run: shininess,
};

const COUNT: usize = 256;

/// The share of the colour (white) that fog (black) leaves at each coordinate.
fn fogged(session: &Session, coordinates: &[f32]) -> Result<Vec<f64>, ProbeError> {
    glColor4f(1, 1, 1, 1);
    let values = session.points(coordinates.len(), |number| {
        glFogCoordf(coordinates[number]);
        glVertex4f(0, 0, 0, 1);
    })?;
    Ok(values.into_iter().map(|value| value[0]).collect())
}

fn thin_fog() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    session.float_target()?;
    let thickness = (-20..=4).map(|step| 10f64.powf(f64::from(step) / 2.0));
    let line = Series::measured("largest error", thickness, |thickness| {
        let mut rng = Rng::named("thin-fog");
        let start = 1000.0f32;
        let end = (1000.0 * (1.0 + thickness)) as f32;
        session.fog(Fog::Linear([start.into(), end.into()]), [0.0; 4])?;
        let coordinates: Vec<f32> = (0..COUNT)
            .map(|_| (1000.0 * (1.0 + thickness * f64::from(rng.real(-0.5, 1.5)))) as f32)
            .collect();
        let mut compared = Compared::new();
        for (&c, value) in coordinates.iter().zip(fogged(&session, &coordinates)?) {
            let [c, start, end] = [c, start, end].map(f64::from);
            let exact = match (end - c) / (end - start) {
                // All fog where it begins and ends.
                factor if factor.is_nan() => 0.0,
                factor => factor.clamp(0.0, 1.0),
            };
            compared.add((value - exact).abs() / 2f64.powi(-24), &[value]);
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}

fn dense_fog() -> Result<Vec<Series>, ProbeError> {
    let mut lines = Vec::new();
    for (name, fog) in [("GL_EXP", Fog::Exp as fn(f64) -> Fog), ("GL_EXP2", Fog::Exp2)] {
        let session = Session::open()?;
        session.float_target()?;
        lines.push(Series::measured(name, decades(-37..=37), |density| {
            let density = density as f32;
            session.fog(fog(density.into()), [0.0; 4])?;
            let mut rng = Rng::named(name);
            let coordinates: Vec<f32> = (0..COUNT)
                .map(|_| (f64::from(rng.real(0.0, 3.0)) / f64::from(density)) as f32)
                .collect();
            let mut compared = Compared::new();
            for (&c, value) in coordinates.iter().zip(fogged(&session, &coordinates)?) {
                let x = f64::from(c) * f64::from(density);
                let exact = match fog(1.0) {
                    Fog::Exp(_) => (-x).exp(),
                    Fog::Exp2(_) => (-x * x).exp(),
                    Fog::Linear(_) => f64::NAN,
                };
                compared.add((value - exact).abs() / 2f64.powi(-24), &[value]);
            }
            Ok(compared)
        })?);
    }
    Ok(lines)
}

/// Light from one direction, of which only one term is white.
fn lit(session: &Session, toward: [f32; 4], term: u32) -> Result<(), ProbeError> {
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    for name in [GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION] {
        let white = [if name == term { 1.0f32 } else { 0.0 }; 4];
        if name != GL_EMISSION {
            glLightfv(GL_LIGHT0, name, &white);
        }
        glMaterialfv(GL_FRONT_AND_BACK, name, &white);
    }
    glLightfv(GL_LIGHT0, GL_POSITION, &toward);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, &[0.0f32; 4]);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHTING);
    glEnable(GL_NORMALIZE);
    session.check("setting up light")
}

fn normal_scale() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    session.float_target()?;
    lit(&session, [0.0, 0.0, 1.0, 0.0], GL_DIFFUSE)?;
    let line = Series::measured("largest error", decades(-37..=37), |scale| {
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glScaled(scale, scale, scale);
        let mut rng = Rng::named("normal-scale");
        let normals: Vec<[f32; 3]> = (0..COUNT)
            .map(|_| [rng.real(-1.0, 1.0), rng.real(-1.0, 1.0), rng.real(0.1, 1.0)])
            .collect();
        let values = lit_normals(&session, &normals)?;
        let mut compared = Compared::new();
        for (normal, value) in normals.iter().zip(values) {
            let [x, y, z] = normal.map(f64::from);
            let exact = z / (x * x + y * y + z * z).sqrt();
            compared.add((value[0] - exact).abs() / 2f64.powi(-24), &value[..1]);
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}

/// The colours of vertices at the origin with these normals.
fn lit_normals(session: &Session, normals: &[[f32; 3]]) -> Result<Vec<[f64; 4]>, ProbeError> {
    session.points(normals.len(), |number| {
        let [x, y, z] = normals[number];
        glNormal3f(x, y, z);
        glVertex4f(0, 0, 0, 1);
    })
}

fn shininess() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    session.float_target()?;
    lit(&session, [0.0, 0.0, 1.0, 0.0], GL_SPECULAR)?;
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 128);
    let angles = (0..=32).map(|step| 10f64.powf(-f64::from(step) / 4.0));
    let line = Series::measured("largest error", angles, |angle| {
        // The viewer is at infinity along z, as the light: the half vector is z.
        let mut rng = Rng::named("shininess");
        let normals: Vec<[f32; 3]> = (0..COUNT)
            .map(|_| {
                let turn = f64::from(rng.real(0.0, 6.2));
                let (sin, cos) = (angle * f64::from(rng.real(0.5, 1.0))).sin_cos();
                [sin * turn.cos(), sin * turn.sin(), cos].map(|c| c as f32)
            })
            .collect();
        let values = lit_normals(&session, &normals)?;
        let mut compared = Compared::new();
        for (normal, value) in normals.iter().zip(values) {
            let [x, y, z] = normal.map(f64::from);
            let sine2 = (x * x + y * y) / (x * x + y * y + z * z);
            let exact = (64.0 * (-sine2).ln_1p()).exp();
            compared.add((value[0] - exact).abs() / 2f64.powi(-24), &value[..1]);
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}
