//! The textures of the error report.

use crate::oracle::texture::Level;
use crate::rng::Rng;

const SIZE: usize = 256;

/// Checks, stripes, rings and noise in coloured fields: sharp edges at every angle and scale.
pub fn signs() -> Level {
    let mut rng = Rng::named("signs");
    let noise: Vec<u8> = (0..SIZE * SIZE).map(|_| rng.byte()).collect();
    Level::from_fn(SIZE, SIZE, |i, j| {
        let field = i / 64 + 4 * (j / 64);
        let (x, y) = ((i % 64) as f64 - 31.5, (j % 64) as f64 - 31.5);
        let on = match field % 5 {
            0 => (i / 8 + j / 8) % 2 == 0,
            1 => (i / 4) % 2 == 0,
            2 => ((x.hypot(y) / 5.0) as usize).is_multiple_of(2),
            3 => noise[j * SIZE + i] > 128,
            _ => (i + 2 * j) / 12 % 2 == 0,
        };
        let tint = [(field * 97 % 200) as u8, (field * 41 % 180) as u8, (field * 59 % 160) as u8];
        if on { [230, 225, 210, 255] } else { [tint[0], tint[1], tint[2], 255] }
    })
}

/// `(1 + cos(π r² / N)) / 2`: every frequency up to half a cycle a texel, in every direction.
pub fn zone_plate() -> Level {
    Level::from_fn(SIZE, SIZE, |i, j| {
        let [x, y] = [i, j].map(|n| n as f64 + 0.5 - SIZE as f64 / 2.0);
        let phase = std::f64::consts::PI * (x * x + y * y) / SIZE as f64;
        let grey = (127.5 * (1.0 + phase.cos())).round() as u8;
        [grey, grey, grey, 255]
    })
}

/// A photograph of the moon (NASA, public domain).
pub fn photograph() -> Level {
    const FILE: &[u8] = include_bytes!("../../assets/moon.png");
    let picture = image::load_from_memory(FILE).map(|picture| picture.into_rgba8());
    // The file is a part of this program: without it there is a grey square.
    let picture =
        picture.unwrap_or_else(|_| image::RgbaImage::from_pixel(4, 4, image::Rgba([128; 4])));
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    // GL's first row is the lowest.
    Level::from_fn(width, height, |i, j| picture.get_pixel(i as u32, (height - 1 - j) as u32).0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_photograph_is_there() {
        assert_eq!((photograph().width, photograph().height), (512, 512));
    }
}
