//! Tests of pictures: each is compared with the one that somebody has looked at.
//!
//! ```no_run
//! # let pixels = [0_u8; 64 * 64 * 4];
//! let picture = golden::Picture::rgba(64, 64, &pixels);
//! golden::check(&picture, "scene");
//! ```
//!
//! compares with `golden/scene.png` of the crate that is tested, exactly. `DETGL_BLESS=1 cargo test` writes that
//! picture: look at it. Where two differ, the old, the new and the difference × 16 are in `golden-failures/`, with a page
//! of all of them, `index.html`. [`Picture::digest`] is a number to compare in place of a picture.
//!
//! The Python module `detgl.golden` does the same; digests of the two are equal.

#[cfg(test)]
mod tests;

use image::{ColorType, DynamicImage, ImageError, ImageReader};
use sha2::{Digest, Sha256};
use std::fmt::{self, Write};
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// How much brighter the difference is in its picture, so that one step can be seen.
const AMPLIFIED: u8 = 16;

/// What is written of a failure.
const KINDS: [&str; 3] = ["old", "new", "difference"];

/// A picture of components of 8 bits, the rows from the top.
#[derive(Clone, PartialEq, Eq)]
pub struct Picture {
    width: u32,
    height: u32,
    format: Format,
    bytes: Vec<u8>,
}

/// The components of a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Rgb,
    Rgba,
}

impl Format {
    fn components(self) -> usize {
        match self {
            Self::Rgb => 3,
            Self::Rgba => 4,
        }
    }
}

impl Picture {
    /// Three components a pixel.
    ///
    /// # Panics
    /// If there are not as many bytes.
    pub fn rgb(width: u32, height: u32, bytes: &[u8]) -> Self {
        Self::new(width, height, Format::Rgb, bytes.to_vec())
    }

    /// Four components a pixel.
    ///
    /// # Panics
    /// If there are not as many bytes.
    pub fn rgba(width: u32, height: u32, bytes: &[u8]) -> Self {
        Self::new(width, height, Format::Rgba, bytes.to_vec())
    }

    fn new(width: u32, height: u32, format: Format, bytes: Vec<u8>) -> Self {
        let expected = width as usize * height as usize * format.components();
        assert_eq!(bytes.len(), expected, "bytes of {width}×{height} pixels of {format:?}");
        Self { width, height, format, bytes }
    }

    /// The same with the rows in the other order: `glReadPixels` begins with the lowest.
    #[must_use]
    pub fn flipped(&self) -> Self {
        let row = self.width as usize * self.format.components();
        let bytes = self.bytes.chunks(row.max(1)).rev().flatten().copied().collect();
        Self { bytes, ..*self }
    }

    /// The SHA-256 of size, format and bytes, as text.
    pub fn digest(&self) -> String {
        let components = self.format.components();
        let mut sha = Sha256::new();
        sha.update(format!("{}x{}x{components} B\n", self.height, self.width));
        sha.update(&self.bytes);
        sha.finalize().iter().fold(String::new(), |mut text, byte| {
            write!(text, "{byte:02x}").expect("a String takes everything");
            text
        })
    }

    fn read(path: &Path) -> Result<Self, ImageError> {
        let image = ImageReader::open(path)?.decode()?;
        let (width, height) = (image.width(), image.height());
        Ok(match image {
            DynamicImage::ImageRgb8(image) => {
                Self::new(width, height, Format::Rgb, image.into_raw())
            }
            other => Self::new(width, height, Format::Rgba, other.into_rgba8().into_raw()),
        })
    }

    fn write(&self, path: &Path) -> Result<(), ImageError> {
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        let color = match self.format {
            Format::Rgb => ColorType::Rgb8,
            Format::Rgba => ColorType::Rgba8,
        };
        image::save_buffer(path, &self.bytes, self.width, self.height, color)
    }

    fn pixels(&self) -> impl Iterator<Item = &[u8]> {
        self.bytes.chunks(self.format.components())
    }
}

impl fmt::Debug for Picture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}×{} {:?}", self.width, self.height, self.format)
    }
}

/// How two pictures of one size and format differ.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Difference {
    /// How many pixels.
    pub count: usize,
    /// The largest difference of a component.
    pub largest: u8,
    /// The first pixel that differs: column, and row from the top.
    pub first: (usize, usize),
    /// The difference × 16, in RGB; where alpha alone differs, that is grey.
    pub picture: Picture,
}

impl Difference {
    /// Of two pictures; `None` if they are equal.
    ///
    /// # Panics
    /// If size or format differ.
    pub fn between(old: &Picture, new: &Picture) -> Option<Self> {
        assert_eq!((old.width, old.height, old.format), (new.width, new.height, new.format));
        let (mut wrong, mut largest, mut bytes) = (Vec::new(), 0, Vec::new());
        for (at, (old, new)) in old.pixels().zip(new.pixels()).enumerate() {
            let mut apart = [0; 4];
            for ((apart, old), new) in apart.iter_mut().zip(old).zip(new) {
                *apart = old.abs_diff(*new);
            }
            let [color @ .., alpha] = apart;
            let seen = if color == [0; 3] { [alpha; 3] } else { color };
            bytes.extend(seen.map(|value| value.saturating_mul(AMPLIFIED)));
            if apart != [0; 4] {
                wrong.push(at);
            }
            largest = apart.into_iter().fold(largest, u8::max);
        }
        let first = *wrong.first()?;
        let width = old.width as usize;
        Some(Self {
            count: wrong.len(),
            largest,
            first: (first % width, first / width),
            picture: Picture::new(old.width, old.height, Format::Rgb, bytes),
        })
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { count, largest, first: (x, y), .. } = self;
        write!(f, "{count} pixels differ, by {largest} at most, first at ({x}, {y})")
    }
}

/// What is done with new pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// They are compared.
    Compare,
    /// They are written: `DETGL_BLESS` is set.
    Bless,
}

/// Where pictures are, and how they are compared.
#[derive(Clone, Debug)]
pub struct Golden {
    /// The pictures that were looked at.
    pub folder: PathBuf,
    /// What differs is written here.
    pub failures: PathBuf,
    /// How far a component may be away. DetGL's own pictures need nothing.
    pub tolerance: u8,
    /// Whether pictures are compared or written.
    pub task: Task,
}

impl Golden {
    /// Compares exactly; `DETGL_BLESS` writes.
    pub fn new(folder: impl Into<PathBuf>, failures: impl Into<PathBuf>) -> Self {
        let task = if env::var_os("DETGL_BLESS").is_some() { Task::Bless } else { Task::Compare };
        Self { folder: folder.into(), failures: failures.into(), tolerance: 0, task }
    }

    /// Compares a picture with that of a name.
    ///
    /// # Errors
    /// What differs, and where to see it.
    pub fn check(&self, picture: &Picture, name: &str) -> Result<(), String> {
        let path = self.folder.join(format!("{name}.png"));
        let old = Picture::read(&path).ok();
        if old.as_ref() == Some(picture) {
            return self.forget(name).map_err(|error| format!("{name}: {error}"));
        }
        if self.task == Task::Bless {
            return picture.write(&path).map_err(|error| format!("{}: {error}", path.display()));
        }
        self.compare(old.as_ref(), picture, name)
    }

    /// Compares a picture with another one, which is under no name.
    ///
    /// # Errors
    /// As of [`Golden::check`].
    pub fn compare(&self, old: Option<&Picture>, new: &Picture, name: &str) -> Result<(), String> {
        let is_comparable = |old: &Picture| {
            (old.width, old.height, old.format) == (new.width, new.height, new.format)
        };
        let (why, difference) = match old {
            None => ("there is no picture to compare with".to_owned(), None),
            Some(old) if !is_comparable(old) => {
                (format!("the old is {old:?}, the new {new:?}"), None)
            }
            Some(old) => match Difference::between(old, new) {
                Some(difference) if difference.largest > self.tolerance => {
                    (difference.to_string(), Some(difference.picture))
                }
                Some(_) | None => return Ok(()),
            },
        };
        let pictures = [old, Some(new), difference.as_ref()];
        let page = self.report(name, &why, pictures).map_err(|error| {
            format!("{name}: {why}. {} cannot be written: {error}", self.failures.display())
        })?;
        Err(format!(
            "{name}: {why}. See {}; if it is right, look at it and set DETGL_BLESS=1",
            page.display()
        ))
    }

    /// Takes an earlier run's failure from the page.
    fn forget(&self, name: &str) -> io::Result<()> {
        let text = self.failures.join(format!("{name}.txt"));
        if !text.exists() {
            return Ok(());
        }
        fs::remove_file(text)?;
        for kind in KINDS {
            match fs::remove_file(self.failures.join(format!("{name}-{kind}.png"))) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
                Ok(()) | Err(_) => {}
            }
        }
        write_page(&self.failures).map(drop)
    }

    /// Writes the pictures of a failure, and the page of all.
    fn report(
        &self,
        name: &str,
        why: &str,
        pictures: [Option<&Picture>; 3],
    ) -> Result<PathBuf, ImageError> {
        for (kind, picture) in KINDS.into_iter().zip(pictures) {
            let path = self.failures.join(format!("{name}-{kind}.png"));
            match picture {
                Some(picture) => picture.write(&path)?,
                None if path.exists() => fs::remove_file(&path)?,
                None => {}
            }
        }
        fs::write(self.failures.join(format!("{name}.txt")), why)?;
        Ok(write_page(&self.failures)?)
    }
}

/// A page of all failures in a folder.
fn write_page(folder: &Path) -> io::Result<PathBuf> {
    const STYLE: &str = "body{font:15px sans-serif;margin:2em}div{display:flex;gap:1em;flex-wrap:wrap}figure{margin:0}\
                         img{image-rendering:pixelated;min-width:256px;border:1px solid #999}";
    let mut names = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "txt") {
            names.push(path);
        }
    }
    names.sort();
    let mut rows = String::new();
    for path in &names {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let why = fs::read_to_string(path)?;
        write!(rows, "<h2>{name}</h2><p>{why}</p><div>").expect("a String takes everything");
        for kind in KINDS {
            let file = format!("{name}-{kind}.png");
            if folder.join(&file).exists() {
                write!(
                    rows,
                    "<figure><img src=\"{file}\"><figcaption>{kind}</figcaption></figure>"
                )
                .expect("a String takes everything");
            }
        }
        rows.push_str("</div>");
    }
    let count = names.len();
    let page = folder.join("index.html");
    fs::write(
        &page,
        format!(
            "<!doctype html><meta charset=\"utf-8\"><title>Pictures that differ</title><style>{STYLE}</style>\
             <h1>{count} pictures differ</h1>{rows}\n"
        ),
    )?;
    Ok(page)
}

/// Compares a picture with `golden/NAME.png` of the crate that is tested.
///
/// # Panics
/// If they differ: says how, and where to see it.
#[track_caller]
pub fn check(picture: &Picture, name: &str) {
    // Cargo sets it for tests.
    let folder = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let golden = Golden::new(folder.join("golden"), folder.join("golden-failures"));
    if let Err(said) = golden.check(picture, name) {
        panic!("{said}");
    }
}
