//! What a sweep measures: lines of points, each with its largest error and what it was taken from.

use crate::plot::Line;
use crate::probe::ProbeError;
use serde::Serialize;

/// The cases at one value of the parameter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Point {
    /// The parameter.
    pub parameter: f64,
    /// The largest error; infinite if a result was no number where one was expected.
    pub error: f64,
    /// Cases that were tried.
    pub tried: usize,
    /// Cases that were compared: no filter left them out.
    pub kept: usize,
    /// A hash of the driver's results.
    #[serde(skip)]
    pub results: u64,
}

/// A line of points.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Series {
    /// The name in the legend.
    pub name: String,
    /// The points in the order of the parameter.
    pub points: Vec<Point>,
}

impl Series {
    /// The line over these values of the parameter, in their order.
    ///
    /// # Errors
    /// When a value cannot be measured.
    pub fn measured(
        name: impl Into<String>,
        parameters: impl IntoIterator<Item = f64>,
        mut measure: impl FnMut(f64) -> Result<Compared, ProbeError>,
    ) -> Result<Self, ProbeError> {
        let point = |parameter| Ok(measure(parameter)?.at(parameter));
        let points: Result<_, ProbeError> = parameters.into_iter().map(point).collect();
        Ok(Self { name: name.into(), points: points? })
    }

    /// The line of a plot.
    pub fn line(&self) -> Line {
        let points = self.points.iter().map(|point| (point.parameter, point.error));
        Line { name: self.name.clone(), points: points.collect() }
    }
}

/// Gathers the cases of a point.
#[derive(Clone, Copy, Debug)]
pub struct Compared {
    error: f64,
    tried: usize,
    kept: usize,
    results: u64,
}

impl Compared {
    /// No case yet.
    pub fn new() -> Self {
        // The hash is FNV-1a of 64 bits.
        Self { error: 0.0, tried: 0, kept: 0, results: 0xcbf2_9ce4_8422_2325 }
    }

    /// A case, with its error and what the driver gave.
    pub fn add(&mut self, error: f64, results: &[f64]) {
        self.tried += 1;
        self.kept += 1;
        self.error = self.error.max(if error.is_nan() { f64::INFINITY } else { error });
        for byte in results.iter().flat_map(|value| value.to_bits().to_le_bytes()) {
            self.results = (self.results ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    }

    /// A case that a filter leaves out.
    pub fn leave_out(&mut self) {
        self.tried += 1;
    }

    /// The point at this value of the parameter.
    pub fn at(self, parameter: f64) -> Point {
        let Self { error, tried, kept, results } = self;
        Point { parameter, error, tried, kept, results }
    }
}

/// Powers of ten.
pub fn decades(exponents: std::ops::RangeInclusive<i32>) -> impl Iterator<Item = f64> {
    exponents.map(|exponent| 10f64.powi(exponent))
}

/// Powers of two, each `step`-th.
pub fn octaves(exponents: std::ops::RangeInclusive<i32>, step: usize) -> impl Iterator<Item = f64> {
    exponents.step_by(step).map(|exponent| 2f64.powi(exponent))
}
