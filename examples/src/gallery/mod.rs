//! The gallery: every program's picture, a page that shows them, and a table.

mod entry;
mod page;
mod table;

use entry::{Entry, Explained};

use crate::arguments::{WRONG_ARGUMENT, folder, picture_file, side, takes_no_picture};
use crate::picture::{self, Picture};
use crate::programs;
use crate::window::{Program, explain, render};
use clap::Parser;
use gl_api::context::ContextDesc;
use indicatif::{ProgressBar, ProgressStyle};
use rasterizer::driver::{Device, DeviceDesc, DeviceError, Explain};
use std::error::Error;
use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

/// Draws the pictures of the lectures
#[derive(Clone, Debug, Parser)]
#[command(name = "gallery", after_help = EXAMPLES)]
pub struct Arguments {
    /// Draw only this program (repeat for more)
    #[arg(long, value_name = "NAME", value_parser = programs::ALL.map(|program| program.name))]
    only: Vec<String>,
    /// Side of a square picture, in pixels
    #[arg(long, default_value_t = 1024, value_parser = side::<4096>, allow_hyphen_values = true)]
    size: u32,
    /// A PPM, PNG or JPEG file in place of the drawn pictures
    #[arg(long, value_name = "FILE", value_parser = picture_file)]
    image: Option<Picture>,
    /// Where the pictures and index.html go
    #[arg(long, value_name = "DIR", default_value = "gallery", value_parser = folder)]
    out: PathBuf,
    /// Say how the pixel at column X, row Y (from the upper left) of each picture came to be,
    /// instead of writing pictures
    #[arg(long, value_name = "X,Y", value_parser = pixel, requires = "only")]
    explain: Option<[usize; 2]>,
    /// Print JSON in place of text
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "Examples:
  gallery                                       every picture, and gallery/index.html
  gallery --only textured_square --size 512     one picture, and gallery/only.html
  gallery --only decal_skin --image photo.jpg   with a picture of yours as the texture
  gallery --only demon_triangle --explain 100,60
                                                how the pixel in column 100 of row 60 came to be";

/// A column and a row.
fn pixel(text: &str) -> Result<[usize; 2], String> {
    let numbers = text.split_once(',');
    let number = |text: &str| text.trim().parse().ok();
    numbers
        .and_then(|(x, y)| Some([number(x)?, number(y)?]))
        .ok_or_else(|| "must be two whole numbers and a comma, such as 100,60".into())
}

/// Draws the selected programs, writes their pictures, and prints the table.
///
/// # Errors
/// When a file cannot be written, or a context cannot be made.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Box<dyn Error>> {
    let image = arguments.image.as_ref();
    if let Some(pixel) = arguments.explain {
        explain_pixels(arguments, image, pixel)?;
        return Ok(ExitCode::SUCCESS);
    }
    let entries = draw(arguments, image)?;
    let ignores = |entry: &&Entry| !entry.rendered.reads_pictures;
    let without: Vec<&str> = entries.iter().filter(ignores).map(|e| e.program.name).collect();
    if image.is_some() && !without.is_empty() {
        eprintln!("{}", takes_no_picture(&without));
        if without.len() == entries.len() {
            return Ok(ExitCode::from(WRONG_ARGUMENT));
        }
    }
    fs::create_dir_all(&arguments.out)?;
    for Entry { program, rendered, .. } in &entries {
        picture::save(&rendered.picture, &arguments.out.join(format!("{}.png", program.name)))?;
    }
    // The page of all pictures stays as it is when a few are drawn again.
    let page = if arguments.only.is_empty() { "index.html" } else { "only.html" };
    let index = arguments.out.join(page);
    fs::write(&index, page::page(&entries))?;
    if arguments.json {
        println!("{:#}", table::json(&entries));
    } else {
        println!("{}\n{}", table::table(&entries), index.display());
    }
    for Entry { program, rendered, .. } in &entries {
        rendered.errors.iter().for_each(|error| eprintln!("{}: {error}", program.name));
    }
    Ok(ExitCode::SUCCESS)
}

/// The selected programs.
fn selected(arguments: &Arguments) -> Vec<Program> {
    let is_selected = |program: &Program| {
        arguments.only.is_empty() || arguments.only.iter().any(|name| name == program.name)
    };
    programs::ALL.into_iter().filter(is_selected).collect()
}

/// Prints the explanation of a pixel of each picture.
fn explain_pixels(
    arguments: &Arguments,
    image: Option<&Picture>,
    pixel: [usize; 2],
) -> Result<(), Box<dyn Error>> {
    let mut explained = Vec::new();
    for program in selected(arguments) {
        let (size, desc) = (arguments.size as usize, ContextDesc::default());
        let (_, explanation) = explain(&program, size, image.cloned(), &desc, pixel)?;
        if arguments.json {
            explained.push(table::explanation(&program, pixel, &explanation));
        } else {
            print!("{}: {explanation}", program.name);
        }
    }
    if arguments.json {
        println!("{:#}", serde_json::Value::from(explained));
    }
    Ok(())
}

fn draw(arguments: &Arguments, image: Option<&Picture>) -> Result<Vec<Entry>, Box<dyn Error>> {
    let programs = selected(arguments);
    // On anything but a terminal the bar draws nothing.
    let bar = ProgressBar::new(programs.len() as u64);
    bar.set_style(ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}")?);
    let device = device()?;
    let desc = ContextDesc { device: Some(Arc::clone(&device)), ..ContextDesc::default() };
    let mut entries = Vec::with_capacity(programs.len());
    for program in programs {
        bar.set_message(program.name);
        bar.tick();
        let size = arguments.size as usize;
        let rendered = render(&program, size, image.cloned(), &desc)?;
        let plans = device.take_explanations();
        let explained = if arguments.json { None } else { explained(&program, image)? };
        entries.push(Entry { program, rendered, plans, explained });
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(entries)
}

/// The side of the pictures of which a pixel is explained: a quarter of the usual one, as they are drawn once more.
const EXPLAINED_SIZE: usize = 256;

/// What an explanation cites where a texture was looked up.
const LOOKUP: &str = "3.8.8";

/// One pixel of a program's picture: the first of a few that shows a texture, else the one of which most is to be said.
fn explained(
    program: &Program,
    image: Option<&Picture>,
) -> Result<Option<Explained>, Box<dyn Error>> {
    let (size, desc) = (EXPLAINED_SIZE, ContextDesc::default());
    let [width, height] = program.sides(size);
    let mut best: Option<Explained> = None;
    // Off the middle, where panels meet.
    for [x, y] in [[5, 7], [11, 9], [4, 12]] {
        let pixel = [width * x / 16, height * y / 16];
        let (_, explanation) = explain(program, size, image.cloned(), &desc, pixel)?;
        let text = explanation.to_string();
        if best.as_ref().is_none_or(|best| text.len() > best.text.len()) {
            best = Some(Explained { size, pixel, text });
        }
        if best.as_ref().is_some_and(|best| best.text.contains(LOOKUP)) {
            break;
        }
    }
    Ok(best)
}

/// A device that keeps the plans of its draws; if `DETGL_EXPLAIN` is set, it prints them.
fn device() -> Result<Arc<Device>, DeviceError> {
    let mut desc = DeviceDesc::from_env()?;
    if desc.explain == Explain::Off {
        desc.explain = Explain::Keep;
    }
    Device::new(desc).map(Arc::new)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_explained_pixel_shows_a_texture() {
        let program = programs::ALL.iter().find(|program| program.name == "textured_square");
        let explained = explained(program.expect("a program"), None).expect("a context");
        let text = explained.expect("an explanation").text;
        assert!(text.contains(LOOKUP), "{text}");
    }
}
