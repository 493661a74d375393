//! Error and run time of every way to sample a texture on every scene, compared with the exact area
//! integral; and of the other [`choices`] that trade one for the other.
//!
//! Errors are those of R, G and B in [0, 1]. The driver writes bytes, whose rounding alone causes an
//! RMS error of 0.0011, which is the lower limit of every mode.

pub mod choices;
mod draw;
pub mod front;
pub mod functions;
mod mode;
mod scene;
mod stage;
mod texture;

pub use mode::Mode;
pub use scene::{Scene, scenes};

use crate::plot::Line;
use crate::probe::ProbeError;
use crate::reference::flip;
use draw::Drawer;
use front::Weighed;
use serde::Serialize;
use stage::{Stage, Times};
use std::time::Instant;

/// One mode on one scene.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The scene.
    pub scene: &'static str,
    /// The mode.
    pub mode: String,
    /// The line of the plot that this row is a point of.
    #[serde(skip)]
    pub family: &'static str,
    /// Mean error of a channel.
    pub mean: f64,
    /// Root of the mean square error.
    pub rms: f64,
    /// Largest error.
    pub max: f64,
    /// Mean ꟻLIP.
    pub flip: f64,
    /// Nanoseconds a pixel: the fastest round.
    pub nanoseconds: f64,
    /// The first quartile, the median and the third quartile of the rounds.
    pub quartiles: [f64; 3],
    /// Whether no other mode of the scene is better in error or time, and no worse in the other.
    pub is_on_front: bool,
}

/// A picture of the report's pages.
#[derive(Clone, Debug)]
pub struct Picture {
    /// File name without its ending.
    pub name: String,
    /// R, G, B, A in [0, 1], rows from the lowest.
    pub pixels: Vec<[f64; 4]>,
    /// Pixels across and up.
    pub side: usize,
}

/// All results.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Scene after scene, mode after mode.
    pub rows: Vec<Row>,
    /// For each scene the reference, then each mode and its difference.
    pub pictures: Vec<Picture>,
}

impl Row {
    /// How far the quartiles lie apart, as part of the median.
    pub fn spread(&self) -> f64 {
        let [low, median, high] = self.quartiles;
        (high - low) / median
    }
}

/// Draws these scenes in all modes at `side` × `side` pixels; `progress` is called with each scene.
///
/// # Errors
/// When a call sets the error flag.
pub fn measure<'a>(
    side: usize,
    scenes: impl IntoIterator<Item = &'a Scene>,
    mut progress: impl FnMut(&Scene),
) -> Result<Measured, ProbeError> {
    let mut measured = Measured { rows: Vec::new(), pictures: Vec::new() };
    let device = stage::one_thread()?;
    for scene in scenes {
        progress(scene);
        let start = Instant::now();
        let reference: Vec<[f64; 4]> = (0..side * side)
            .map(|p| {
                let pixel = [p % side, p / side];
                if scene.counts(pixel, side) { scene.reference(pixel, side) } else { [0.0; 4] }
            })
            .collect();
        let integral = (&reference[..], start.elapsed().as_secs_f64());
        measured.pictures.push(Picture {
            name: format!("{}-reference", scene.name),
            pixels: reference.clone(),
            side,
        });
        let mut drawers = Vec::with_capacity(Mode::ALL.len());
        for mode in Mode::ALL {
            drawers.push(Drawer::new(&device, scene, mode, side, integral)?);
        }
        let mut stages: Vec<&mut Stage> = drawers.iter_mut().filter_map(Drawer::stage).collect();
        let mut times = stage::interleaved(&mut stages)?.into_iter();
        for (mode, drawer) in Mode::ALL.into_iter().zip(&mut drawers) {
            let mut pixels = drawer.picture()?;
            let Some(times) = drawer.own_times().or_else(|| times.next()) else { continue };
            for (p, pixel) in pixels.iter_mut().enumerate() {
                if !scene.counts([p % side, p / side], side) {
                    *pixel = [0.0; 4];
                }
            }
            measured.rows.push(row(scene, mode, &reference, (&pixels[..], times), side));
            let name = format!("{}-{}", scene.name, mode.name());
            measured.pictures.extend(with_difference(name, &reference, pixels, side));
        }
        let first = measured.rows.len() - Mode::ALL.len();
        mark_front(&mut measured.rows[first..]);
    }
    Ok(measured)
}

/// A picture, and 4 times its difference from the reference.
fn with_difference(
    name: String,
    reference: &[[f64; 4]],
    pixels: Vec<[f64; 4]>,
    side: usize,
) -> [Picture; 2] {
    let difference = reference.iter().zip(&pixels).map(|(a, b)| {
        let d = |c: usize| (4.0 * (a[c] - b[c]).abs()).min(1.0);
        [d(0), d(1), d(2), 1.0]
    });
    let difference =
        Picture { name: format!("{name}-difference"), pixels: difference.collect(), side };
    [Picture { name, pixels, side }, difference]
}

fn row(
    scene: &Scene,
    mode: Mode,
    reference: &[[f64; 4]],
    (drawn, times): (&[[f64; 4]], Times),
    side: usize,
) -> Row {
    let to_nanoseconds = 1e9 / (side * side) as f64;
    let errors: Vec<f64> = reference
        .iter()
        .zip(drawn)
        .enumerate()
        .filter(|(p, _)| scene.counts([p % side, p / side], side))
        .flat_map(|(_, (a, b))| [0, 1, 2].map(|c: usize| (a[c] - b[c]).abs()))
        .collect();
    let count = errors.len() as f64;
    let picture = |pixels: &[[f64; 4]]| flip::Picture {
        width: side,
        pixels: pixels.iter().map(|p| [p[0], p[1], p[2]]).collect(),
    };
    Row {
        scene: scene.name,
        mode: mode.name(),
        family: mode.family(),
        mean: errors.iter().sum::<f64>() / count,
        rms: (errors.iter().map(|e| e * e).sum::<f64>() / count).sqrt(),
        max: errors.iter().copied().fold(0.0, f64::max),
        flip: flip::mean(&picture(reference), &picture(drawn)),
        nanoseconds: times.fastest * to_nanoseconds,
        quartiles: times.quartiles.map(|seconds| seconds * to_nanoseconds),
        is_on_front: false,
    }
}

/// All scenes together: mean of the time, root mean square of the errors, one row a mode.
pub fn overall(rows: &[Row]) -> Vec<Row> {
    let mut all: Vec<Row> = Vec::new();
    for mode in Mode::ALL {
        let of: Vec<&Row> = rows.iter().filter(|row| row.mode == mode.name()).collect();
        let count = of.len().max(1) as f64;
        let mean = |f: fn(&Row) -> f64| of.iter().map(|row| f(row)).sum::<f64>() / count;
        all.push(Row {
            scene: "all scenes",
            mode: mode.name(),
            family: mode.family(),
            mean: mean(|row| row.mean),
            rms: mean(|row| row.rms * row.rms).sqrt(),
            max: of.iter().map(|row| row.max).fold(0.0, f64::max),
            flip: mean(|row| row.flip),
            nanoseconds: mean(|row| row.nanoseconds),
            quartiles: [
                mean(|row| row.quartiles[0]),
                mean(|row| row.quartiles[1]),
                mean(|row| row.quartiles[2]),
            ],
            is_on_front: false,
        });
    }
    mark_front(&mut all);
    all
}

/// What the advice weighs of the modes of a scene.
fn weighed(rows: &[Row]) -> Vec<Weighed> {
    let of = |row: &Row| {
        let [low, cost, high] = row.quartiles;
        Weighed { name: row.mode.clone(), error: row.rms, cost, quartiles: [low, high] }
    };
    rows.iter().map(of).collect()
}

/// Marks the modes of a scene that no other one beats.
fn mark_front(rows: &mut [Row]) {
    let fronts = front::is_on_front(&weighed(rows));
    rows.iter_mut().zip(fronts).for_each(|(row, is_on_front)| row.is_on_front = is_on_front);
}

/// One sentence about the modes of a scene.
pub fn scene_advice(rows: &[Row]) -> String {
    front::advice(&weighed(rows), "time")
}

/// The work-precision lines of some rows: RMS error over nanoseconds a pixel, a line a family.
pub fn lines(rows: &[Row]) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for row in rows {
        let point = (row.nanoseconds, row.rms);
        match lines.iter_mut().find(|line| line.name == row.family) {
            Some(line) => line.points.push(point),
            None => lines.push(Line { name: row.family.to_owned(), points: vec![point] }),
        }
    }
    lines
}
