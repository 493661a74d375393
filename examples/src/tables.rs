//! Tables made of a texture before it is filtered: ripmaps and summed areas.

use crate::picture::Picture;
use crate::texture::set_filter;
use gl_api::constants::*;
use gl_api::types::{GLsizei, GLuint};
use gl_api::*;

/// The colours of a picture from the bottom row up.
pub fn texels(picture: &Picture) -> Vec<[f32; 3]> {
    let picture = picture.clone().flipped();
    picture.pixels.iter().map(|p| [p.r, p.g, p.b].map(|c| f32::from(c) / 255.)).collect()
}

/// A table of side × side floats a colour, on a unit.
pub fn load_table(unit: u32, side: GLsizei, table: &[[f32; 3]]) -> GLuint {
    let mut texture: GLuint = 0;
    glGenTextures(1, &mut texture);
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture);
    set_filter(GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F_ARB, side, side, 0, GL_RGB, GL_FLOAT, &table.concat());
    texture
}

/// All levels of a ripmap of 64 × 64 texels, in 128 × 128: one of w × h is at (128 − 2w, 128 − 2h).
pub fn ripmap(texels: &[[f32; 3]]) -> Vec<[f32; 3]> {
    let mut atlas = vec![[0_f32; 3]; 128 * 128];
    for at in 0..49 {
        let [across, up] = [1 << (at % 7), 1 << (at / 7)];
        let [width, height] = [64 / across, 64 / up];
        for texel in 0..width * height {
            let [x, y] = [texel % width, texel / width];
            let mean = &mut atlas[(128 - 2 * height + y) * 128 + 128 - 2 * width + x];
            for of in 0..across * up {
                let below = texels[(y * up + of / across) * 64 + x * across + of % across];
                for (sum, part) in mean.iter_mut().zip(below) {
                    *sum += part / (across * up) as f32;
                }
            }
        }
    }
    atlas
}

/// The summed-area table of 64 × 64 texels: 65 × 65 sums, the first row and column zeros.
pub fn sums(texels: &[[f32; 3]]) -> Vec<[f32; 3]> {
    let mut sums = vec![[0_f32; 3]; 65 * 65];
    for (at, texel) in texels.iter().enumerate() {
        let here = (at / 64 + 1) * 65 + at % 64 + 1;
        for (channel, value) in texel.iter().enumerate() {
            let before = sums[here - 1][channel] + sums[here - 65][channel];
            sums[here][channel] = before - sums[here - 66][channel] + value;
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_level_and_the_last_sum_are_the_mean() {
        let picture = Picture::paint(64, 64, |x, y| [x, y * y, x * y]);
        let texels = texels(&picture);
        let (last, all) = (ripmap(&texels)[126 * 128 + 126], sums(&texels)[64 * 65 + 64]);
        for channel in 0..3 {
            let mean = texels.iter().map(|texel| f64::from(texel[channel])).sum::<f64>() / 4096.;
            assert!((f64::from(last[channel]) - mean).abs() < 1e-5, "{last:?}");
            assert!((f64::from(all[channel]) / 4096. - mean).abs() < 1e-5, "{all:?}");
        }
    }

    #[test]
    fn a_level_that_is_halved_across_keeps_its_rows() {
        let rows = Picture::paint_centers(64, 64, |_, y| [y; 3]);
        let texels = texels(&rows);
        let atlas = ripmap(&texels);
        for y in 0..64 {
            // One texel wide, 64 high: at (126, 0).
            assert!((atlas[y * 128 + 126][0] - texels[y * 64][0]).abs() < 1e-5, "row {y}");
        }
    }
}
