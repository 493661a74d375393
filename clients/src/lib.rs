//! What the clients have in common: pictures of the rows that OpenGL reads, and files of them.

use image::RgbaImage;
use std::error::Error;

/// A picture of this width and height, of rows of RGBA bytes, the lowest first.
///
/// # Errors
/// When there are too few bytes.
pub fn picture([width, height]: [u32; 2], rows: Vec<u8>) -> Result<RgbaImage, Box<dyn Error>> {
    let picture = RgbaImage::from_raw(width, height, rows).ok_or("as many as needed")?;
    Ok(image::imageops::flip_vertical(&picture))
}

/// Saves a picture in the file that the first argument of the program names, else in this one.
///
/// # Errors
/// When it cannot be written.
pub fn save(picture: &RgbaImage, file: &str) -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).unwrap_or_else(|| file.into());
    picture.save(&path)?;
    println!("{path}");
    Ok(())
}
