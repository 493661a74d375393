//! `conformance peers`: the same scenes through the same C functions, on DetGL's shared library and
//! on every other GL driver of the machine.
//!
//! A scene is a [`Recipe`](recipe::Recipe): data. [`play`] plays it on a driver, [`render`] draws it
//! with the formulas. Every measurement is a process of its own, so that first frames and memory
//! are a driver's alone; drivers take turns, several rounds of them, and what is compared are
//! medians.

pub mod child;
mod client;
mod driver;
mod error;
mod play;
mod recipe;
mod render;
mod report;
mod scene;

pub use report::{WriteError, table, write};

use child::Measured;
use client::ClientError;
use driver::Driver;
use error::Distance;
use render::render;
use scene::{Load, Scene, scenes};
use serde::Serialize;
use std::path::PathBuf;

/// What can be chosen.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    /// How often every driver draws every scene, in turns.
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub rounds: u16,
    /// Pixels across and up.
    #[arg(long, default_value_t = 1024, value_parser = clap::value_parser!(u16).range(16..=4096))]
    pub size: u16,
    /// DetGL's shared library; without it, the one that was built beside this program.
    #[arg(long, value_name = "PATH")]
    pub lib: Option<PathBuf>,
}

/// Why drivers cannot be compared.
#[derive(Debug, thiserror::Error)]
#[expect(missing_docs, reason = "the messages say it")]
pub enum PeersError {
    #[error(
        "there is no libdetgl.so in {0} or its deps/: build it with `cargo build --release -p \
         capi`, or name it with --lib"
    )]
    NoLibrary(PathBuf),
    #[error("there is no scene {0:?}")]
    NoScene(String),
    #[error(transparent)]
    Client(#[from] ClientError),
    #[error("a measuring process failed: {0}")]
    Child(String),
    #[error("a measuring process cannot be run: {0}")]
    Process(std::io::Error),
    #[error("a measuring process did not say what it measured: {0}")]
    Answer(#[from] serde_json::Error),
}

/// Everything that was found.
#[derive(Clone, Debug, Serialize)]
pub struct Comparison {
    /// Pixels across and up.
    pub size: u16,
    /// Processes for each driver and scene.
    pub rounds: u16,
    /// DetGL first.
    pub drivers: Vec<Driver>,
    /// Scene after scene, in each the drivers.
    pub rows: Vec<Row>,
    /// Scenes that another driver could not draw, and why.
    pub failures: Vec<String>,
}

/// A driver on a scene: medians over the rounds.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The scene.
    pub scene: &'static str,
    /// In words.
    pub what: &'static str,
    /// What its time goes to.
    pub load: Load,
    /// The driver.
    pub driver: &'static str,
    /// Milliseconds of a frame.
    pub frame_ms: f64,
    /// Median over the rounds of its frame's time over DetGL's of the same round.
    pub frame_ratio: f64,
    /// Processor milliseconds of a frame.
    pub processor_ms: f64,
    /// Milliseconds from opening the library to the first picture in memory.
    pub first_ms: f64,
    /// Its median ratio to DetGL's.
    pub first_ratio: f64,
    /// Peak memory of the process in MiB.
    pub peak_mib: f64,
    /// Distance from the formulas' picture.
    pub error: Distance,
}

/// Scenes whose name has `only` in it.
pub fn wanted(only: &str) -> Vec<&'static Scene> {
    scenes().filter(|scene| scene.name.contains(only)).collect()
}

/// All names.
pub fn names() -> Vec<&'static str> {
    scenes().map(|scene| scene.name).collect()
}

/// Measures scenes with every driver; `progress` hears of each measurement.
///
/// # Errors
/// When DetGL's library is not found, or a process fails.
pub fn compare(
    options: &Options,
    scenes: &[&'static Scene],
    mut progress: impl FnMut(&str),
) -> Result<Comparison, PeersError> {
    let drivers = driver::find(options)?;
    let size = usize::from(options.size);
    let (mut rows, mut failures) = (Vec::new(), Vec::new());
    for scene in scenes {
        progress(&format!("{}, formulas", scene.name));
        let truth = render(&(scene.recipe)(size), size);
        let mut tried: Vec<Result<Vec<Measured>, PeersError>> =
            drivers.iter().map(|_| Ok(Vec::new())).collect();
        for _ in 0..options.rounds {
            for (driver, measured) in drivers.iter().zip(&mut tried) {
                let Ok(rounds) = measured else { continue };
                progress(&format!("{}, {}", scene.name, driver.name));
                match driver.measure(scene, size) {
                    Ok(mut of_round) => {
                        // One round's picture is enough.
                        of_round.picture.truncate(if rounds.is_empty() { usize::MAX } else { 0 });
                        of_round.picture.shrink_to_fit();
                        rounds.push(of_round);
                    }
                    Err(error) => *measured = Err(error),
                }
            }
        }
        let mut ours = Vec::new();
        for (driver, measured) in drivers.iter().zip(tried) {
            match measured {
                Ok(rounds) => {
                    if ours.is_empty() {
                        ours.clone_from(&rounds);
                    }
                    let error = Distance::between(&truth, &rounds[0].picture, size);
                    rows.push(Row::new(scene, driver.name, &rounds, &ours, error));
                }
                // Without DetGL there is nothing to compare with.
                Err(error) if ours.is_empty() => return Err(error),
                Err(error) => failures.push(format!("{}, {}: {error}", scene.name, driver.name)),
            }
        }
    }
    Ok(Comparison { size: options.size, rounds: options.rounds, drivers, rows, failures })
}

impl Row {
    /// The medians of a driver's rounds, and of their ratios to DetGL's.
    fn new(
        scene: &Scene,
        driver: &'static str,
        rounds: &[Measured],
        ours: &[Measured],
        error: Distance,
    ) -> Self {
        let of = |value: fn(&Measured) -> f64| median(rounds.iter().map(value).collect());
        let ratio = |value: fn(&Measured) -> f64| {
            median(rounds.iter().zip(ours).map(|(a, b)| value(a) / value(b)).collect())
        };
        Self {
            scene: scene.name,
            what: scene.what,
            load: scene.load,
            driver,
            frame_ms: of(|m| m.frame_ms),
            frame_ratio: ratio(|m| m.frame_ms),
            processor_ms: of(|m| m.processor_ms),
            first_ms: of(|m| m.first_ms),
            first_ratio: ratio(|m| m.first_ms),
            peak_mib: of(|m| m.peak_kib as f64 / 1024.0),
            error,
        }
    }
}

/// The middle one; 0 of none.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
