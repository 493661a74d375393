//! The gallery: every program's picture, a page that shows them, and a table.

mod page;
mod table;

use crate::picture::{self, Picture};
use crate::programs;
use crate::window::{Program, Rendered, render};
use clap::Parser;
use gl_api::context::ContextDesc;
use indicatif::{ProgressBar, ProgressStyle};
use std::error::Error;
use std::fs;
use std::path::PathBuf;

/// Draws the pictures of the lectures
#[derive(Clone, Debug, Parser)]
pub struct Arguments {
    /// Draw only this program (repeat for more)
    #[arg(long, value_name = "NAME", value_parser = programs::ALL.map(|program| program.name))]
    only: Vec<String>,
    /// Side of a square picture, in pixels
    #[arg(long, default_value_t = 1024, value_parser = clap::value_parser!(u32).range(2..=4096))]
    size: u32,
    /// A PPM, PNG or JPEG file in place of the drawn pictures
    #[arg(long, value_name = "FILE")]
    image: Option<PathBuf>,
    /// Where the pictures and index.html go
    #[arg(long, value_name = "DIR", default_value = "gallery")]
    out: PathBuf,
}

/// A program and what it drew.
type Entry = (Program, Rendered);

/// Draws what is asked for, writes it, and prints the table.
///
/// # Errors
/// When a file cannot be read or written, or a context cannot be made.
pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let image = arguments.image.as_deref().map(crate::window::load).transpose()?;
    fs::create_dir_all(&arguments.out)?;
    let entries = draw(arguments, image.as_ref())?;
    for (program, rendered) in &entries {
        picture::save(&rendered.picture, &arguments.out.join(format!("{}.png", program.name)))?;
    }
    let index = arguments.out.join("index.html");
    fs::write(&index, page::page(&entries))?;
    println!("{}", table::table(&entries));
    for (program, rendered) in &entries {
        rendered.errors.iter().for_each(|error| eprintln!("{}: {error}", program.name));
    }
    println!("{}", index.display());
    Ok(())
}

fn draw(arguments: &Arguments, image: Option<&Picture>) -> Result<Vec<Entry>, Box<dyn Error>> {
    let asked = |program: &Program| {
        arguments.only.is_empty() || arguments.only.iter().any(|name| name == program.name)
    };
    let programs: Vec<Program> = programs::ALL.into_iter().filter(asked).collect();
    // On anything but a terminal the bar draws nothing.
    let bar = ProgressBar::new(programs.len() as u64);
    bar.set_style(ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}")?);
    let mut entries = Vec::with_capacity(programs.len());
    for program in programs {
        bar.set_message(program.name);
        bar.tick();
        let size = arguments.size as usize;
        let rendered = render(&program, size, image.cloned(), &ContextDesc::default())?;
        entries.push((program, rendered));
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(entries)
}
