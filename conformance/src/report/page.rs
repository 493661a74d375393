//! The frame of the report's pages, and files beside them.

use crate::tradeoff::Picture;
use std::path::{Path, PathBuf};

/// Why a page or picture could not be written.
#[derive(Debug, thiserror::Error)]
pub enum PageError {
    /// A file.
    #[error("{path}: {source}")]
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A picture.
    #[error("{path}: {source}")]
    Picture {
        /// Which.
        path: PathBuf,
        /// Why.
        source: image::ImageError,
    },
    /// A plot.
    #[error(transparent)]
    Plot(#[from] crate::plot::PlotError),
}

/// Text with HTML's special characters escaped.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A whole page.
pub fn page(title: &str, body: &str) -> String {
    const STYLE: &str = "body{font:15px/1.4 sans-serif;max-width:1200px;margin:2em auto;padding:0 1em;color:#222}\
        table{border-collapse:collapse;margin:1em 0}td,th{padding:.2em .7em;text-align:left;\
        border-bottom:1px solid #ddd;vertical-align:top}td.n{text-align:right;white-space:nowrap}\
        .pass{color:#080}.fail{color:#c00;font-weight:bold}figure{display:inline-block;margin:.4em}\
        figcaption{font-size:12px;max-width:260px}\
        .thumb{margin:.3em .4em 0 0}.thumb img{width:96px;height:96px}.thumb figcaption{color:#666}img{image-rendering:pixelated}nav a{margin-right:1em}\
        small{color:#666}";
    let title = escaped(title);
    format!(
        "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>{title}</title>\
         <style>{STYLE}</style>\n<nav><a href=\"index.html\">formulas</a>\
         <a href=\"error-vs-time.html\">error against run time</a>\
         <a href=\"extremes.html\">extremes</a>\
         <a href=\"self-test.html\">self-test</a>\
         <a href=\"left-out.html\">left out</a></nav>\n<h1>{title}</h1>\n{body}\n</html>\n"
    )
}

/// The name of a page's file. With `--only` it has the text in it, so that the page of everything stays.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PageName(String);

impl PageName {
    /// The page about `subject`, of the entries that contain `only`.
    pub fn new(subject: &str, only: Option<&str>) -> Self {
        let Some(only) = only else { return Self(format!("{subject}.html")) };
        let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
        let only: String = only.chars().map(plain).collect();
        Self(format!("{subject}-only-{only}.html"))
    }

    /// The file's name.
    pub fn file(&self) -> &str {
        &self.0
    }

    /// The name with another ending.
    pub(super) fn with_ending(&self, ending: &str) -> String {
        self.0.replace(".html", ending)
    }

    /// Writes the page.
    ///
    /// # Errors
    /// When it cannot be written.
    pub(super) fn write(&self, folder: &Path, text: &str) -> Result<(), PageError> {
        write(folder, &self.0, text)
    }
}

/// Creates the report's folder if it does not exist.
///
/// # Errors
/// When it cannot be created.
pub fn create(folder: &Path) -> Result<(), PageError> {
    std::fs::create_dir_all(folder)
        .map_err(|source| PageError::File { path: folder.to_owned(), source })
}

/// Writes a file into the report's folder, which is created if it does not exist.
///
/// # Errors
/// When it cannot be written.
pub fn write(folder: &Path, name: &str, text: &str) -> Result<(), PageError> {
    let path = folder.join(name);
    std::fs::create_dir_all(folder)
        .and_then(|()| std::fs::write(&path, text))
        .map_err(|source| PageError::File { path, source })
}

/// Writes a picture as PNG into the report's folder, which must exist.
///
/// # Errors
/// When it cannot be written.
pub fn write_picture(folder: &Path, picture: &Picture) -> Result<(), PageError> {
    let side = picture.side as u32;
    let png = image::RgbImage::from_fn(side, side, |x, y| {
        // Files begin with the top row.
        let pixel = picture.pixels[((side - 1 - y) * side + x) as usize];
        image::Rgb([0, 1, 2].map(|c: usize| (pixel[c].clamp(0.0, 1.0) * 255.0).round() as u8))
    });
    let path = folder.join(format!("{}.png", picture.name));
    png.save(&path).map_err(|source| PageError::Picture { path, source })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_entry_has_a_page_of_its_own() {
        assert_eq!(PageName::new("index", None).file(), "index.html");
        assert_eq!(PageName::new("index", Some("GL 2.1/x")).file(), "index-only-gl-2-1-x.html");
        assert_eq!(PageName::new("index", None).with_ending(".svg"), "index.svg");
    }
}
