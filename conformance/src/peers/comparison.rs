//! Measures every scene with every driver.

use super::distance::Distance;
use super::driver::{self, Driver};
use super::error::PeersError;
use super::median::median;
use super::options::Options;
use super::process::Measurement;
use super::reference::render;
use super::scene::{Scene, Workload};
use serde::Serialize;

/// All results.
#[derive(Clone, Debug, Serialize)]
pub struct Comparison {
    /// Width and height in pixels.
    pub size: u16,
    /// Processes for each driver and scene.
    pub rounds: u16,
    /// DetGL first.
    pub drivers: Vec<Driver>,
    /// A row for each scene and driver, in the order of the scenes.
    pub rows: Vec<Row>,
    /// Scenes that another driver could not draw, and why.
    pub failures: Vec<String>,
}

/// The medians of a driver on a scene.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The scene.
    pub scene: &'static str,
    /// The description of the scene.
    pub what: &'static str,
    /// The work that takes most of its time.
    pub load: Workload,
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

/// Measures scenes with every driver; `progress` is called with each measurement.
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
        let mut tried: Vec<Result<Vec<Measurement>, PeersError>> =
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
        rounds: &[Measurement],
        ours: &[Measurement],
        error: Distance,
    ) -> Self {
        let of = |value: fn(&Measurement) -> f64| median(rounds.iter().map(value).collect());
        let ratio = |value: fn(&Measurement) -> f64| {
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
