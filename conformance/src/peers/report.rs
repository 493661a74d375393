//! The results of the comparison as tables and a plot.

use super::comparison::{Comparison, Row};
use crate::plot::{Caption, Line, PlotError, scatter};
use crate::report::page::{self, PageError};
use crate::report::{Layout, right};
use comfy_table::{Cell, Table, presets};
use std::path::Path;

/// Every scene with every driver.
fn measured(layout: Layout, comparison: &Comparison) -> Table {
    let mut table = layout.table([
        "scene",
        "driver",
        "frame, ms",
        "times DetGL's",
        "first, ms",
        "times DetGL's",
        "peak, MiB",
        "RMS error, /255",
        "max, /255",
        "pixels off",
    ]);
    for row in &comparison.rows {
        let ours = row.driver == "DetGL";
        let ratio = |ratio: f64| if ours { String::new() } else { format!("{ratio:.2}×") };
        table.add_row([
            Cell::new(if ours { row.scene } else { "" }),
            Cell::new(row.driver),
            right(format!("{:.2}", row.frame_ms)),
            right(ratio(row.frame_ratio)),
            right(format!("{:.1}", row.first_ms)),
            right(ratio(row.first_ratio)),
            right(format!("{:.0}", row.peak_mib)),
            right(format!("{:.4}", row.error.rms)),
            right(row.error.max.to_string()),
            right(format!("{:.3} %", row.error.differing * 100.0)),
        ]);
    }
    table
}

/// DetGL's speed relative to llvmpipe, scene by scene, and its goal; `None` without llvmpipe.
fn goals(layout: Layout, comparison: &Comparison) -> Option<Table> {
    let mut table = layout.table([
        "scene",
        "what",
        "llvmpipe's frame over DetGL's (2× is half of llvmpipe's time)",
        "goal of frames",
        "llvmpipe's first frame over DetGL's",
        "goal of first frames",
        "RMS error of DetGL, /255",
        "of llvmpipe, /255",
    ]);
    let of = |driver: &'static str| comparison.rows.iter().filter(move |row| row.driver == driver);
    let pairs: Vec<(&Row, &Row)> = of("DetGL")
        .filter_map(|ours| Some((ours, of("llvmpipe").find(|row| row.scene == ours.scene)?)))
        .collect();
    for (ours, theirs) in &pairs {
        let reached = |got: f64, goal: f64| {
            format!("{goal}×: {}", if got >= goal { "reached" } else { "not reached" })
        };
        let closer = ours.error.rms <= theirs.error.rms;
        table.add_row([
            Cell::new(ours.scene),
            Cell::new(ours.what),
            right(format!("{:.2}×", theirs.frame_ratio)),
            Cell::new(
                ours.load.goal().map_or("—".to_owned(), |goal| reached(theirs.frame_ratio, goal)),
            ),
            right(format!("{:.1}×", theirs.first_ratio)),
            Cell::new(reached(theirs.first_ratio, 5.0)),
            right(format!("{:.4}{}", ours.error.rms, if closer { "" } else { " (more)" })),
            right(format!("{:.4}", theirs.error.rms)),
        ]);
    }
    (!pairs.is_empty()).then_some(table)
}

/// Both tables, and the drivers' name strings.
pub fn table(layout: Layout, comparison: &Comparison) -> String {
    text(layout, comparison, presets::UTF8_BORDERS_ONLY)
}

/// Writes the same as Markdown, as JSON, and the plot, into files of this name.
///
/// # Errors
/// When a file cannot be written or the plot cannot be drawn.
pub fn write(folder: &Path, name: &str, comparison: &Comparison) -> Result<(), WriteError> {
    page::write(
        folder,
        &format!("{name}.md"),
        &text(Layout::Wide, comparison, presets::ASCII_MARKDOWN),
    )?;
    page::write(folder, &format!("{name}.json"), &crate::report::json(comparison)?)?;
    page::write(folder, &format!("{name}.svg"), &plot(comparison).map_err(PageError::from)?)?;
    Ok(())
}

/// Why a file of the comparison cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// A file, or the plot in it.
    #[error(transparent)]
    Page(#[from] PageError),
    /// The numbers.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

fn text(layout: Layout, comparison: &Comparison, preset: &str) -> String {
    let Comparison { size, rounds, drivers, .. } = comparison;
    let mut text = format!(
        "{size} × {size} pixels, medians of {rounds} rounds, {} processors. A frame ends with \
         glFinish; the first one counts from opening the library to the picture in memory, \
         shaders compiled, nothing from an earlier run. Errors are against the formulas in f64, in \
         steps of a byte.\n\n",
        std::thread::available_parallelism().map_or(1, usize::from)
    );
    for driver in drivers {
        text.push_str(&format!("- {}: {}, GL {}\n", driver.name, driver.renderer, driver.version));
    }
    if drivers.len() == 1 {
        text.push_str(
            "\nNo other GL driver was found on this machine: these are DetGL's figures.\n",
        );
    }
    for mut table in goals(layout, comparison).into_iter().chain([measured(layout, comparison)]) {
        table.load_preset(preset);
        text.push_str(&format!("\n{table}\n"));
    }
    for failure in &comparison.failures {
        text.push_str(&format!("\nNot drawn: {failure}\n"));
    }
    text
}

/// Error over frame time: a colour for each driver, a point for each scene.
///
/// # Errors
/// When it cannot be drawn.
fn plot(comparison: &Comparison) -> Result<String, PlotError> {
    // 0 has no logarithm: it becomes one step in one channel of one pixel.
    let least = (1.0 / (3.0 * f64::from(comparison.size).powi(2))).sqrt();
    let of = |driver: &'static str| comparison.rows.iter().filter(move |row| row.driver == driver);
    let lines: Vec<Line> = comparison
        .drivers
        .iter()
        .map(|driver| Line {
            name: driver.name.to_owned(),
            points: of(driver.name).map(|row| (row.frame_ms, row.error.rms.max(least))).collect(),
        })
        .collect();
    let names: Vec<&str> = of("DetGL").map(|row| row.scene).collect();
    let caption = Caption {
        title: "Error against time, a point a scene",
        x: "milliseconds a frame",
        y: "RMS error, steps of a byte",
    };
    scatter(caption, &lines, &names)
}
