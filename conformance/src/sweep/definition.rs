//! The definition of a sweep, and how one is run.

use crate::plot::Line;
use crate::probe::ProbeError;
use serde::Serialize;
use std::time::Instant;

/// A sweep.
#[derive(Clone, Copy, Debug)]
pub struct Sweep {
    /// The name, for `--only` and file names.
    pub name: &'static str,
    /// A description.
    pub what: &'static str,
    /// The parameter.
    pub parameter: &'static str,
    /// The unit of errors.
    pub unit: &'static str,
    /// The largest error that passes.
    pub bound: f64,
    /// The reason for the bound.
    pub why: &'static str,
    /// Points (parameter, error) of the driver as it was before this sweep had it changed.
    pub before: &'static [(f64, f64)],
    /// Measures the lines.
    pub run: fn() -> Result<Vec<Line>, ProbeError>,
}

/// The result of a sweep.
#[derive(Clone, Debug, Serialize)]
pub struct SweepOutcome {
    /// The sweep's name.
    pub name: &'static str,
    /// A description.
    pub what: &'static str,
    /// The parameter.
    pub parameter: &'static str,
    /// The unit of errors.
    pub unit: &'static str,
    /// The largest error that passes.
    pub bound: f64,
    /// The reason for the bound.
    pub why: &'static str,
    /// The largest error.
    pub largest: f64,
    /// The parameter with the largest error.
    pub at: f64,
    /// Name and points (parameter, error) of each line.
    pub lines: Vec<(String, Vec<(f64, f64)>)>,
    /// What the errors were before this sweep had the driver changed; empty if it never was.
    pub before: &'static [(f64, f64)],
    /// Why the sweep could not be run.
    pub broken: Option<String>,
    /// Run time in seconds.
    pub seconds: f64,
}

impl SweepOutcome {
    /// Whether every error is within the bound.
    pub fn passes(&self) -> bool {
        self.broken.is_none() && self.largest <= self.bound
    }
}

impl Sweep {
    /// Runs the sweep.
    pub fn run(&self) -> SweepOutcome {
        let start = Instant::now();
        let (lines, broken) = match (self.run)() {
            Ok(lines) => (lines, None),
            Err(error) => (Vec::new(), Some(error.to_string())),
        };
        let points = lines.iter().flat_map(|line| line.points.iter().copied());
        let worst = points.fold((f64::NAN, 0.0), |worst: (f64, f64), point| {
            if worst.0.is_nan() || point.1.is_nan() || point.1 > worst.1 { point } else { worst }
        });
        SweepOutcome {
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

/// A line over powers of ten of the parameter.
pub fn decades(
    name: &str,
    exponents: impl Iterator<Item = i32>,
    mut error: impl FnMut(f64) -> Result<f64, ProbeError>,
) -> Result<Line, ProbeError> {
    let mut points = Vec::new();
    for exponent in exponents {
        let parameter = 10f64.powi(exponent);
        points.push((parameter, error(parameter)?));
    }
    Ok(Line { name: name.to_owned(), points })
}
