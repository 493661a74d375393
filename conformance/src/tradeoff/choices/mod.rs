//! The other choices that trade error for run time or memory, each against a reference of its own.
//!
//! A choice is a table of alternatives that draw the same picture. All are timed in turns, one thread each, by the time of
//! the processor; what no other alternative beats is marked; the advice follows from the table ([`front`](super::front)).

mod edges;
mod environment;
mod formats;
mod interpolation;
mod level_of_detail;
mod machine;
mod mipmaps;
mod normal_maps;
mod procedure;
mod shadows;

use super::front::{Weighed, advice, is_on_front};
use super::stage::{Stage, interleaved};
use super::{Picture, with_difference};
use crate::probe::ProbeError;
use serde::Serialize;

/// A choice: its name, what is drawn, and what makes its alternatives for pictures of this side.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// The name in file names and tables.
    pub name: &'static str,
    /// What is drawn, and what the error is against.
    pub what: &'static str,
    /// What an alternative costs that the advice weighs.
    pub cost: Cost,
    alternatives: fn(usize) -> Result<Alternatives, ProbeError>,
}

/// What an alternative costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cost {
    /// Time.
    Time,
    /// Bytes of memory a texel; time is in the table.
    Memory,
}

impl Cost {
    /// In words.
    pub fn describe(self) -> &'static str {
        match self {
            Self::Time => "time",
            Self::Memory => "memory",
        }
    }
}

/// The alternatives of a choice, and the picture that they should draw.
struct Alternatives {
    side: usize,
    /// R, G, B, A in [0, 1], rows from the lowest; 0 where pixels do not count.
    reference: Vec<[f64; 4]>,
    /// Whether a pixel counts.
    counts: fn([usize; 2], usize) -> bool,
    all: Vec<Alternative>,
}

/// One of them.
struct Alternative {
    name: String,
    stage: Stage,
    /// The square of this many pixels of the stage is a pixel.
    samples: usize,
    /// Bytes of memory a texel.
    bytes: Option<f64>,
}

impl Alternative {
    fn new(name: impl Into<String>, stage: Stage) -> Self {
        Self { name: name.into(), stage, samples: 1, bytes: None }
    }
}

/// All choices.
pub const CHOICES: &[Choice] = &[
    mipmaps::EVEN,
    mipmaps::ODD,
    mipmaps::ANISOTROPY,
    formats::FORMATS,
    edges::EDGES,
    procedure::PROCEDURE,
    normal_maps::NORMAL_MAPS,
    shadows::SHADOWS,
    environment::ENVIRONMENT,
    level_of_detail::LEVEL_OF_DETAIL,
    interpolation::INTERPOLATION,
    machine::INSTRUCTION_SETS,
    machine::THREADS,
];

/// An alternative's error, time and memory.
#[derive(Clone, Debug, Serialize)]
pub struct ChoiceRow {
    /// The alternative.
    pub alternative: String,
    /// Root of the mean square error of R, G and B.
    pub rms: f64,
    /// Largest error.
    pub max: f64,
    /// First quartile, median, third quartile of the rounds, in nanoseconds a pixel.
    pub quartiles: [f64; 3],
    /// Bytes of memory a texel.
    pub bytes: Option<f64>,
    /// Whether no other alternative is better in error or cost, and no worse in the other.
    pub is_on_front: bool,
}

/// A choice that was measured.
#[derive(Clone, Debug, Serialize)]
pub struct ChoiceOutcome {
    /// The choice.
    pub choice: &'static str,
    /// What is drawn, and what the error is against.
    pub what: &'static str,
    /// The alternatives.
    pub rows: Vec<ChoiceRow>,
    /// One sentence.
    pub advice: String,
    /// The reference, then each alternative and its difference.
    #[serde(skip)]
    pub pictures: Vec<Picture>,
}

impl ChoiceOutcome {
    /// The largest distance of the quartiles of a row, as part of its median.
    pub fn spread(&self) -> f64 {
        let spreads = self.rows.iter().map(|row| {
            let [low, median, high] = row.quartiles;
            (high - low) / median
        });
        spreads.fold(0.0, f64::max)
    }
}

impl Choice {
    /// Draws all alternatives in pictures of `side` × `side` pixels, or as the choice needs.
    ///
    /// # Errors
    /// When there is no context, or a call sets the error flag.
    pub fn measure(&self, side: usize) -> Result<ChoiceOutcome, ProbeError> {
        let Alternatives { side, reference, counts, mut all } = (self.alternatives)(side)?;
        let mut stages: Vec<&mut Stage> = all.iter_mut().map(|of| &mut of.stage).collect();
        let times = interleaved(&mut stages)?;
        let is_counted: Vec<bool> =
            (0..side * side).map(|p| counts([p % side, p / side], side)).collect();
        let name = format!("{}-reference", self.name);
        let mut pictures = vec![Picture { name, pixels: reference.clone(), side }];
        let mut rows = Vec::with_capacity(all.len());
        for (alternative, times) in all.iter_mut().zip(times) {
            let mut pixels = alternative.stage.picture(alternative.samples)?;
            for (pixel, _) in pixels.iter_mut().zip(&is_counted).filter(|(_, counts)| !**counts) {
                *pixel = [0.0; 4];
            }
            let errors = reference.iter().zip(&pixels).zip(&is_counted);
            let errors: Vec<f64> = errors
                .filter(|(_, counts)| **counts)
                .flat_map(|((a, b), _)| [0, 1, 2].map(|c: usize| (a[c] - b[c]).abs()))
                .collect();
            let count = errors.len().max(1) as f64;
            rows.push(ChoiceRow {
                alternative: alternative.name.clone(),
                rms: (errors.iter().map(|e| e * e).sum::<f64>() / count).sqrt(),
                max: errors.iter().copied().fold(0.0, f64::max),
                quartiles: times.quartiles.map(|seconds| seconds * 1e9 / (side * side) as f64),
                bytes: alternative.bytes,
                is_on_front: false,
            });
            let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '-' };
            let name: String = alternative.name.chars().map(plain).collect();
            let name = format!("{}-{name}", self.name);
            pictures.extend(with_difference(name, &reference, pixels, side));
        }
        let weighed: Vec<Weighed> = rows.iter().map(|row| self.weighed(row)).collect();
        for (row, is_on_front) in rows.iter_mut().zip(is_on_front(&weighed)) {
            row.is_on_front = is_on_front;
        }
        let advice = advice(&weighed, self.cost.describe());
        Ok(ChoiceOutcome { choice: self.name, what: self.what, rows, advice, pictures })
    }

    fn weighed(&self, row: &ChoiceRow) -> Weighed {
        let [low, cost, high] = match (self.cost, row.bytes) {
            (Cost::Memory, Some(bytes)) => [bytes; 3],
            (Cost::Memory | Cost::Time, _) => row.quartiles,
        };
        Weighed { name: row.alternative.clone(), error: row.rms, cost, quartiles: [low, high] }
    }
}

/// All pixels count.
fn everywhere(_: [usize; 2], _: usize) -> bool {
    true
}

/// A picture of what a function of a pixel gives.
fn pictured(side: usize, of: impl Fn([usize; 2]) -> [f64; 4]) -> Vec<[f64; 4]> {
    (0..side * side).map(|p| of([p % side, p / side])).collect()
}

/// The scene of this name.
fn scene(name: &str, side: usize) -> Result<super::Scene, ProbeError> {
    let found = super::scenes(side).into_iter().find(|scene| scene.name == name);
    found.ok_or_else(|| ProbeError::Context(format!("there is no scene {name}")))
}
