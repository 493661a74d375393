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
         <a href=\"left-out.html\">left out</a></nav>\n<h1>{title}</h1>\n{body}\n</html>\n"
    )
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
