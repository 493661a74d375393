//! From a height field to a normal map.

use super::image::{Picture, byte, packed_pixel_t};

/// The normals of a height field that repeats, as the lecture stores them:
/// `R = normal_x / 2 + 0.5`, and so for green (upward in the picture) and blue (toward the viewer).
///
/// `depth` is how many pixels high white is above black.
pub fn normal_map(heights: &Picture, depth: f64) -> Picture {
    let (width, height) = (heights.width, heights.height);
    let at = |x: usize, y: usize| {
        let p = heights.pixels[y % height * width + x % width];
        depth * (f64::from(p.r) + f64::from(p.g) + f64::from(p.b)) / 765.0
    };
    let mut pixels = Vec::with_capacity(width * height);
    for y in 0..height {
        for x in 0..width {
            // Central differences; rows count downward.
            let dx = (at(x + 1, y) - at(x + width - 1, y)) / 2.0;
            let dy = (at(x, y + height - 1) - at(x, y + 1)) / 2.0;
            let length = (dx * dx + dy * dy + 1.0).sqrt();
            let [r, g, b] = [-dx, -dy, 1.0].map(|n| byte(n / length / 2.0 + 0.5));
            pixels.push(packed_pixel_t { r, g, b });
        }
    }
    Picture { width, height, pixels }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slope_of_one_leans_by_45_degrees() {
        // 16 steps of 1/15 of white, 15 pixels deep: one pixel up for each pixel to the right.
        let ramp = Picture::paint(16, 1, |x, _| [(x * 16.0).floor() / 15.0; 3]);
        let normals = normal_map(&ramp, 15.0);
        let middle = normals.pixels[8];
        assert_eq!((middle.r, middle.g, middle.b), (37, 128, 218));
    }
}
