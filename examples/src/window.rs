//! Replaces a window: a context, the picture that it draws, and the files that programs read.

use crate::arguments::{WRONG_ARGUMENT, parsed, picture_file, side, takes_no_picture};
use crate::caption::{self, Area, Caption};
use crate::picture::{self, Picture, packed_pixel_t};
use clap::Parser;
use gl_api::constants::*;
use gl_api::context::{Context, ContextDesc};
use gl_api::explain::Explanation;
use gl_api::glsl::{FixIts, Strictness};
use gl_api::types::GLint;
use gl_api::*;
use std::cell::Cell;
use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// A program of a lecture.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// The name of its file.
    pub name: &'static str,
    /// The lecture and its slides.
    pub lecture: &'static str,
    /// The source text.
    pub source: &'static str,
    /// Width and height of its window, in halves of the requested size.
    pub halves: [usize; 2],
    /// Captions of its panels, in the order in which it begins them; none of them has a caption if this is empty.
    pub panels: &'static [&'static str],
    /// Draws into the window; the context is current.
    pub draw: fn(&mut Window),
}

/// The window of a program.
#[derive(Debug)]
pub struct Window {
    /// Pixels across.
    pub width: i32,
    /// Pixels down.
    pub height: i32,
    /// The side of a square window.
    pub(crate) size: i32,
    desc: ContextDesc,
    image: Option<Picture>,
    /// Whether the program has asked for a picture.
    reads_pictures: Cell<bool>,
    notes: String,
    current: Option<Current>,
    /// The pixel to explain: column and row from the upper left.
    watched: Option<[usize; 2]>,
    /// The panels that were begun.
    panels: Vec<Area>,
    captions: Vec<Caption>,
}

/// The result of a program.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The picture.
    pub picture: Picture,
    /// Info logs and other messages of the program.
    pub notes: String,
    /// Errors of GL.
    pub errors: Vec<String>,
    /// How many panels it has.
    pub panels: usize,
    /// Whether it reads a picture file, in whose place another can be given.
    pub reads_pictures: bool,
    /// Time from the new context to the picture in memory, without the time of procedural pictures.
    pub time: Duration,
    /// Time of procedural pictures.
    pub painting: Duration,
}

impl Window {
    /// The file's pixels from the bottom row up, as texture coordinate (0, 0) is the lower left.
    /// The picture of the command line replaces every file; without one, a procedural picture does.
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
        self.reads_pictures.set(true);
        self.image.clone().unwrap_or_else(|| picture::stand_in(name))
    }

    /// Records a message about the picture, such as an info log.
    pub fn note(&mut self, text: &str) {
        if !text.is_empty() {
            self.notes.push_str(text);
            self.notes.push('\n');
        }
    }

    /// Sets the viewport to one of `columns` × `rows` equal panels, counted from the upper left.
    /// Returns its width divided by its height.
    pub fn panel(&mut self, columns: i32, rows: i32, at: i32) -> f64 {
        let (width, height) = (self.width / columns, self.height / rows);
        let (x, y) = (at % columns * width, (rows - 1 - at / columns) * height);
        glViewport(x, y, width, height);
        if !self.panels.contains(&[x, y, width, height]) {
            self.panels.push([x, y, width, height]);
        }
        f64::from(width) / f64::from(height)
    }

    /// Writes a caption when the picture is complete, its lower left corner at a place of the window: (0, 0)
    /// is its lower left, (1, 1) its upper right.
    pub fn caption(&mut self, x: f64, y: f64, text: impl Into<String>) {
        let place = |at: f64, size: i32| (at * f64::from(size)) as i32;
        let (x, y) = (place(x, self.width), place(y, self.height));
        let area = [x, y, self.width - x, self.height - y];
        self.captions.push(Caption { area, text: text.into() });
    }

    /// Draws the captions of panels and those that were asked for.
    fn draw_captions(&mut self, panels: &[&str], size: usize) {
        let of_panel = |(&area, text): (&Area, &&str)| Caption { area, text: (*text).to_owned() };
        let mut captions: Vec<Caption> = self.panels.iter().zip(panels).map(of_panel).collect();
        captions.append(&mut self.captions);
        if !captions.is_empty() {
            caption::draw(&captions, (size / 256).max(1) as i32);
        }
    }

    /// Continues in a new context, which applies the fix-its of shaders.
    ///
    /// # Panics
    /// When there is not enough memory for another context of the same size.
    pub fn apply_fix_its(&mut self) {
        self.restart(ContextDesc { fix_its: FixIts::Apply, ..self.desc.clone() });
    }

    /// Continues in a new context, which refuses shaders that are not as their version says.
    ///
    /// # Panics
    /// When there is not enough memory for another context of the same size.
    pub fn check_strictly(&mut self) {
        self.restart(ContextDesc { strictness: Strictness::Strict, ..self.desc.clone() });
    }

    fn restart(&mut self, desc: ContextDesc) {
        self.current = None;
        let mut context = Context::new(desc).expect("a context of this size was made before");
        watch(&mut context, self.watched);
        self.current = Some(context.make_current());
    }

    /// The picture in the window.
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

/// Runs a program in a new context. The program decides the size in `desc`; `size` is that of a square
/// window.
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

/// [`render`], with an explanation of the pixel at a column and row from the upper left. If the program
/// makes a second context, the explanation is of that one.
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
        size: size as i32,
        current: Some(context.make_current()),
        desc,
        image,
        reads_pictures: Cell::new(false),
        notes: String::new(),
        watched,
        panels: Vec::new(),
        captions: Vec::new(),
    };
    (program.draw)(&mut window);
    window.draw_captions(program.panels, size);
    let picture = window.read();
    let errors = with_current(Context::messages).unwrap_or_default();
    let errors = errors.iter().map(ToString::to_string).collect();
    let painting = picture::painting() - painted;
    let time = start.elapsed() - painting;
    let explanation = with_current(Context::explain_pixel).flatten();
    let (notes, panels) = (window.notes, window.panels.len());
    let reads_pictures = window.reads_pictures.get();
    let rendered = Rendered { picture, notes, errors, panels, reads_pictures, time, painting };
    Ok((rendered, explanation))
}

#[derive(Debug, Parser)]
struct Arguments {
    /// A PPM, PNG or JPEG file in place of the drawn picture
    #[arg(value_parser = picture_file)]
    image: Option<Picture>,
    /// Side of a square window, in pixels
    #[arg(long, default_value_t = 1024, value_parser = side::<8192>, allow_hyphen_values = true)]
    size: u32,
}

/// Runs one program from the command line: writes `NAME.png` and prints messages and errors.
pub fn main(program: &Program) -> ExitCode {
    let arguments: Arguments = match parsed() {
        Ok(arguments) => arguments,
        Err(status) => return status,
    };
    match run(program, &arguments) {
        Ok(status) => status,
        Err(error) => {
            eprintln!("{}: {error}", program.name);
            ExitCode::FAILURE
        }
    }
}

fn run(program: &Program, arguments: &Arguments) -> Result<ExitCode, Box<dyn Error>> {
    let image = arguments.image.clone();
    let rendered = render(program, arguments.size as usize, image, &ContextDesc::default())?;
    if arguments.image.is_some() && !rendered.reads_pictures {
        eprintln!("{}", takes_no_picture(&[program.name]));
        return Ok(ExitCode::from(WRONG_ARGUMENT));
    }
    let path = format!("{}.png", program.name);
    picture::save(&rendered.picture, Path::new(&path))?;
    print!("{}", rendered.notes);
    rendered.errors.iter().for_each(|error| eprintln!("{error}"));
    println!("{path}: {} ms", rendered.time.as_millis());
    Ok(ExitCode::SUCCESS)
}
