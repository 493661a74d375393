//! Picture files, and the procedural pictures that replace those of the lectures.

use super::image::{Picture, packed_pixel_t};
use super::{demon, ground, night, sky, wall, window_glass};
use image::{ColorType, ImageError, ImageReader};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// Reads a PPM, PNG or JPEG file.
///
/// # Errors
/// When it cannot be read or is no picture.
pub fn load(path: &Path) -> Result<Picture, ImageError> {
    let rgb = ImageReader::open(path)?.with_guessed_format()?.decode()?.to_rgb8();
    let (width, height) = (rgb.width() as usize, rgb.height() as usize);
    let pixels = rgb.pixels().map(|p| packed_pixel_t { r: p[0], g: p[1], b: p[2] }).collect();
    Ok(Picture { width, height, pixels })
}

/// Writes a file in the format that its name ends in.
///
/// # Errors
/// When it cannot be written.
pub fn save(picture: &Picture, path: &Path) -> Result<(), ImageError> {
    let (width, height) = (picture.width as u32, picture.height as u32);
    let bytes = bytemuck::cast_slice(&picture.pixels);
    image::save_buffer(path, bytes, width, height, ColorType::Rgb8)
}

/// The procedural picture for a file name; grey for an unknown name. Each is computed once a process.
pub fn stand_in(name: &str) -> Picture {
    static DRAWN: Mutex<BTreeMap<String, Picture>> = Mutex::new(BTreeMap::new());
    let mut drawn = DRAWN.lock().unwrap_or_else(PoisonError::into_inner);
    drawn.entry(name.to_owned()).or_insert_with(|| draw(name)).clone()
}

fn draw(name: &str) -> Picture {
    match name {
        "demon_image.h" => demon::demon(),
        "reachup.ppm" => night::reach_up(),
        "slide.ppm" => window_glass::rose(),
        "bricks.ppm" => wall::bricks(),
        "bricks_height.ppm" => wall::brick_heights(),
        "flagstones.ppm" => wall::flagstones(),
        "planks.ppm" => wall::planks(),
        "grass.ppm" => ground::grass(),
        "rock.ppm" => ground::rock(),
        "clouds.ppm" => ground::clouds(),
        "sphere_map.ppm" => sky::sphere_map(),
        _ => match sky::FACES.iter().position(|face| *face == name) {
            Some(face) => sky::sky_face(face),
            None => Picture::paint(8, 8, |_, _| [0.5; 3]),
        },
    }
}
