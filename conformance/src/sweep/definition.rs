//! The definition of a sweep, and how one is run.

use super::judge::faults;
use super::series::{Point, Series};
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
    /// The largest error that passes; at most [`SLACK`](super::SLACK) times the largest that is measured.
    pub bound: f64,
    /// The reason for the bound.
    pub why: &'static str,
    /// Where arithmetic breaks, and what is promised there.
    pub breaks: &'static str,
    /// The share of cases that each point must keep.
    pub kept: f64,
    /// The share of a line's points at which the driver's results must differ from those of all
    /// points before.
    pub distinct: f64,
    /// Points (parameter, error) of the driver as it was before this sweep had it changed.
    pub before: &'static [(f64, f64)],
    /// Measures the lines.
    pub run: fn() -> Result<Vec<Series>, ProbeError>,
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
    /// Where arithmetic breaks, and what is promised there.
    pub breaks: &'static str,
    /// The largest error.
    pub largest: f64,
    /// The parameter with the largest error.
    pub at: f64,
    /// Cases that were tried.
    pub tried: usize,
    /// Cases that no filter left out.
    pub kept: usize,
    /// The measured lines.
    pub lines: Vec<Series>,
    /// What the errors were before this sweep had the driver changed; empty if it never was.
    pub before: &'static [(f64, f64)],
    /// What is wrong: errors above the bound, and a sweep that shows nothing.
    pub faults: Vec<String>,
    /// Run time in seconds.
    pub seconds: f64,
}

impl SweepOutcome {
    /// Whether nothing is wrong.
    pub fn passes(&self) -> bool {
        self.faults.is_empty()
    }
}

impl Sweep {
    /// Runs the sweep.
    pub fn run(&self) -> SweepOutcome {
        let start = Instant::now();
        let (lines, faults) = match (self.run)() {
            Ok(lines) => {
                let faults = faults(self, &lines);
                (lines, faults)
            }
            Err(error) => (Vec::new(), vec![format!("it could not be run: {error}")]),
        };
        let points = || lines.iter().flat_map(|line| &line.points);
        let worst = |worst: Option<Point>, point: &Point| match worst {
            Some(worst) if point.error <= worst.error => Some(worst),
            Some(_) | None => Some(*point),
        };
        let worst = points().fold(None, worst);
        SweepOutcome {
            name: self.name,
            what: self.what,
            parameter: self.parameter,
            unit: self.unit,
            bound: self.bound,
            why: self.why,
            breaks: self.breaks,
            largest: worst.map_or(f64::NAN, |point| point.error),
            at: worst.map_or(f64::NAN, |point| point.parameter),
            tried: points().map(|point| point.tried).sum(),
            kept: points().map(|point| point.kept).sum(),
            lines,
            before: self.before,
            faults,
            seconds: start.elapsed().as_secs_f64(),
        }
    }
}
