//! What stands in for a window: a context, the picture it shows, and the files it reads.

use crate::picture::{self, Picture, packed_pixel_t};
use clap::Parser;
use gl_api::constants::*;
use gl_api::context::{Context, ContextDesc};
use gl_api::entry::*;
use gl_api::explain::Explanation;
use gl_api::glsl::FixIts;
use gl_api::types::GLint;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// A lecture's program.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// Its file's name.
    pub name: &'static str,
    /// Which lecture, and which of its slides.
    pub lecture: &'static str,
    /// Its text.
    pub source: &'static str,
    /// Width and height of its window, in halves of the size asked for.
    pub halves: [usize; 2],
    /// Draws into the window; the context is current.
    pub draw: fn(&mut Window),
}

/// Where a program draws.
#[derive(Debug)]
pub struct Window {
    /// Pixels across.
    pub width: i32,
    /// Pixels down.
    pub height: i32,
    desc: ContextDesc,
    image: Option<Picture>,
    notes: String,
    current: Option<Current>,
    /// The pixel to explain: column and row from the upper left.
    watched: Option<[usize; 2]>,
}

/// What a program drew.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The picture.
    pub picture: Picture,
    /// Info logs, and other things the program has to say.
    pub notes: String,
    /// What GL complained about.
    pub errors: Vec<String>,
    /// From the new context to the picture in memory, without the pictures that the program paints
    /// by formula.
    pub time: Duration,
    /// What those took.
    pub painting: Duration,
}

impl Window {
    /// The file's pixels from the bottom row up, as texture coordinate (0, 0) is the lower left.
    /// The picture given on the command line stands in for every file; without one, a drawn one.
    pub fn ppmread(
        &mut self,
        name: &str,
        width: &mut GLint,
        height: &mut GLint,
    ) -> Vec<packed_pixel_t> {
        let picture = self.picture(name).flipped();
        (*width, *height) = (picture.width as GLint, picture.height as GLint);
        picture.pixels
    }

    /// The same picture with its top row first.
    pub fn picture(&self, name: &str) -> Picture {
        self.image.clone().unwrap_or_else(|| picture::stand_in(name))
    }

    /// Says something that belongs to the picture, such as an info log.
    pub fn note(&mut self, text: &str) {
        if !text.is_empty() {
            self.notes.push_str(text);
            self.notes.push('\n');
        }
    }

    /// Draws from here on into one of `columns` × `rows` equal panels, counted from the upper left;
    /// answers how many times as wide as high it is.
    pub fn panel(&self, columns: i32, rows: i32, at: i32) -> f64 {
        let (width, height) = (self.width / columns, self.height / rows);
        glViewport(at % columns * width, (rows - 1 - at / columns) * height, width, height);
        f64::from(width) / f64::from(height)
    }

    /// Continues in a new context, which applies the fix-its of shaders.
    ///
    /// # Panics
    /// When there is no memory for another context of the same size.
    pub fn switch_repairs_on(&mut self) {
        let desc = ContextDesc { fix_its: FixIts::Apply, ..self.desc.clone() };
        self.current = None;
        let mut context = Context::new(desc).expect("a context of this size was made before");
        watch(&mut context, self.watched);
        self.current = Some(context.make_current());
    }

    /// What the window shows.
    fn read(&self) -> Picture {
        let (width, height) = (self.width as usize, self.height as usize);
        let mut pixels = vec![packed_pixel_t::default(); width * height];
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, self.width, self.height, GL_RGB, GL_UNSIGNED_BYTE, &mut pixels);
        Picture { width, height, pixels }.flipped()
    }
}

/// Watches the pixel at a column and row from the upper left, which is inside.
fn watch(context: &mut Context, pixel: Option<[usize; 2]>) {
    let (_, height) = context.size();
    if let Some([x, y]) = pixel {
        let row = height.saturating_sub(1 + y as u32);
        context.watch_pixel(x as u32, row).expect("the pixel was checked");
    }
}

/// Runs a program in a context of its own. Of `desc`, the size is the program's: `size` is that of
/// a square window.
///
/// # Errors
/// When the context cannot be made.
pub fn render(
    program: &Program,
    size: usize,
    image: Option<Picture>,
    desc: &ContextDesc,
) -> Result<Rendered, Box<dyn Error>> {
    run_program(program, size, image, desc, None).map(|(rendered, _)| rendered)
}

/// [`render`], and how the pixel at a column and row from the upper left came to be. Of a program
/// that goes on in a second context, what happened in that one.
///
/// # Errors
/// When the context cannot be made, or has no such pixel.
pub fn explain(
    program: &Program,
    size: usize,
    image: Option<Picture>,
    desc: &ContextDesc,
    pixel: [usize; 2],
) -> Result<(Rendered, Explanation), Box<dyn Error>> {
    let sides = program.sides(size);
    if pixel[0] >= sides[0] || pixel[1] >= sides[1] {
        let ([x, y], [width, height]) = (pixel, sides);
        return Err(format!(
            "pixel {x},{y} is not in {}'s picture of {width}×{height}: columns count from 0 at the \
             left, rows from 0 at the top",
            program.name
        )
        .into());
    }
    let (rendered, explanation) = run_program(program, size, image, desc, Some(pixel))?;
    Ok((rendered, explanation.ok_or("the program ended without its context")?))
}

impl Program {
    /// Width and height of its picture, `size` being the side of a square one.
    pub fn sides(&self, size: usize) -> [usize; 2] {
        self.halves.map(|halves| (size * halves / 2).max(1))
    }
}

fn run_program(
    program: &Program,
    size: usize,
    image: Option<Picture>,
    desc: &ContextDesc,
    watched: Option<[usize; 2]>,
) -> Result<(Rendered, Option<Explanation>), Box<dyn Error>> {
    let (start, painted) = (Instant::now(), picture::painting());
    let [width, height] = program.sides(size);
    let desc = ContextDesc { width: width as u32, height: height as u32, ..desc.clone() };
    let mut context = Context::new(desc.clone())?;
    watch(&mut context, watched);
    let mut window = Window {
        width: width as i32,
        height: height as i32,
        current: Some(context.make_current()),
        desc,
        image,
        notes: String::new(),
        watched,
    };
    (program.draw)(&mut window);
    let picture = window.read();
    let errors = with_current(Context::messages).unwrap_or_default();
    let errors = errors.iter().map(ToString::to_string).collect();
    let painting = picture::painting() - painted;
    let time = start.elapsed() - painting;
    let explanation = with_current(Context::explain_pixel).flatten();
    Ok((Rendered { picture, notes: window.notes, errors, time, painting }, explanation))
}

#[derive(Debug, Parser)]
struct Arguments {
    /// A PPM, PNG or JPEG file in place of the drawn picture
    image: Option<PathBuf>,
    /// Side of a square window, in pixels
    #[arg(long, default_value_t = 1024, value_parser = clap::value_parser!(u32).range(1..=8192))]
    size: u32,
}

/// Runs one program from the command line: writes `NAME.png` and prints what there is to say.
pub fn main(program: &Program) -> ExitCode {
    let arguments = Arguments::parse();
    match run(program, &arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{}: {error}", program.name);
            ExitCode::FAILURE
        }
    }
}

fn run(program: &Program, arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let image = arguments.image.as_deref().map(load).transpose()?;
    let rendered = render(program, arguments.size as usize, image, &ContextDesc::default())?;
    let path = format!("{}.png", program.name);
    picture::save(&rendered.picture, Path::new(&path))?;
    print!("{}", rendered.notes);
    rendered.errors.iter().for_each(|error| eprintln!("{error}"));
    println!("{path}: {} ms", rendered.time.as_millis());
    Ok(())
}

/// Reads a picture file; the error names the file.
///
/// # Errors
/// When it cannot be read or is no picture.
pub fn load(path: &Path) -> Result<Picture, String> {
    picture::load(path).map_err(|error| format!("{}: {error}", path.display()))
}
