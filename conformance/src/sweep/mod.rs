//! Stiff and extreme cases: sweeps over a parameter to where arithmetic breaks, each with a stated
//! bound on the error.
//!
//! A sweep gives lines of (parameter, error). Where mathematics leaves a result undefined, DetGL
//! defines one, and the sweep says which.

mod blend;
mod coverage;
mod depth;
mod interpolation;
mod matrix;
mod texture;

use crate::drive::DriveError;
use crate::plot::Line;
use serde::Serialize;
use std::time::Instant;

/// A sweep.
#[derive(Clone, Copy, Debug)]
pub struct Sweep {
    /// For `--only` and file names.
    pub name: &'static str,
    /// What happens.
    pub what: &'static str,
    /// What is swept.
    pub parameter: &'static str,
    /// What errors are measured in.
    pub unit: &'static str,
    /// The largest error that passes.
    pub bound: f64,
    /// Why the bound is what it is.
    pub why: &'static str,
    /// Points (parameter, error) of the driver as it was before this sweep had it changed.
    pub before: &'static [(f64, f64)],
    /// Sweeps.
    pub run: fn() -> Result<Vec<Line>, DriveError>,
}

/// Every sweep.
pub const SWEEPS: &[Sweep] = &[
    interpolation::W_RATIO,
    interpolation::TILT,
    interpolation::NEAR_PLANE,
    interpolation::FAR_VERTICES,
    coverage::SIZE_OF_TRIANGLES,
    coverage::SLIVERS,
    coverage::ANGLES,
    coverage::NO_NUMBERS,
    texture::REPEAT,
    texture::Q_THROUGH_ZERO,
    texture::ANISOTROPY,
    texture::LAMBDA,
    texture::CUBE_EDGE,
    texture::DENORMALS,
    depth::PRECISION,
    blend::LAYERS,
    matrix::CONDITION,
];

/// A sweep that was run.
#[derive(Clone, Debug, Serialize)]
pub struct Swept {
    /// The sweep's name.
    pub name: &'static str,
    /// What happens.
    pub what: &'static str,
    /// What is swept.
    pub parameter: &'static str,
    /// What errors are measured in.
    pub unit: &'static str,
    /// The largest error that passes.
    pub bound: f64,
    /// Why the bound is what it is.
    pub why: &'static str,
    /// The largest error.
    pub largest: f64,
    /// The parameter that has it.
    pub at: f64,
    /// Name and points (parameter, error) of each line.
    pub lines: Vec<(String, Vec<(f64, f64)>)>,
    /// What the errors were before this sweep had the driver changed; empty if it never was.
    pub before: &'static [(f64, f64)],
    /// What kept it from being measured.
    pub broken: Option<String>,
    /// How long it took.
    pub seconds: f64,
}

impl Swept {
    /// Whether every error is within the bound.
    pub fn passes(&self) -> bool {
        self.broken.is_none() && self.largest <= self.bound
    }
}

impl Sweep {
    /// Runs it.
    pub fn run(&self) -> Swept {
        let start = Instant::now();
        let (lines, broken) = match (self.run)() {
            Ok(lines) => (lines, None),
            Err(error) => (Vec::new(), Some(error.to_string())),
        };
        let points = lines.iter().flat_map(|line| line.points.iter().copied());
        let worst = points.fold((f64::NAN, 0.0), |worst: (f64, f64), point| {
            if worst.0.is_nan() || point.1.is_nan() || point.1 > worst.1 { point } else { worst }
        });
        Swept {
            name: self.name,
            what: self.what,
            parameter: self.parameter,
            unit: self.unit,
            bound: self.bound,
            why: self.why,
            largest: worst.1,
            at: worst.0,
            lines: lines.into_iter().map(|line| (line.name, line.points)).collect(),
            before: self.before,
            broken,
            seconds: start.elapsed().as_secs_f64(),
        }
    }
}

/// A line of one parameter's powers of ten.
fn decades(
    name: &str,
    exponents: impl Iterator<Item = i32>,
    mut error: impl FnMut(f64) -> Result<f64, DriveError>,
) -> Result<Line, DriveError> {
    let mut points = Vec::new();
    for exponent in exponents {
        let parameter = 10f64.powi(exponent);
        points.push((parameter, error(parameter)?));
    }
    Ok(Line { name: name.to_owned(), points })
}
