//! N×N supersampling: the mean of the texture at the centres of a pixel's N² equal squares.

use super::Reconstruction;
use super::map::Homography;
use crate::mutation::Variant;
use crate::oracle::filter::{self, Addressing};
use crate::oracle::texture::Level;
use crate::oracle::wrap::Wrap;

/// The mean of `n`² samples of a repeated image over the square `[x0, y0, x1, y1]` of the
/// picture; `map` takes the picture to texels of the image.
pub fn mean(
    level: &Level,
    map: &Homography,
    [x0, y0, x1, y1]: [f64; 4],
    n: usize,
    of: Reconstruction,
) -> [f64; 4] {
    let at = Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] };
    let mut sum = [0.0; 4];
    for k in 0..n * n {
        let place =
            |i: usize, low: f64, high: f64| low + (high - low) * (i as f64 + 0.5) / n as f64;
        let [u, v] = map.apply([place(k % n, x0, x1), place(k / n, y0, y1)]);
        let st = [u / level.width as f64, v / level.height as f64];
        let sample = match of {
            Reconstruction::Box => filter::nearest(level, &at, st, Variant::CORRECT),
            Reconstruction::Bilinear => filter::linear(level, &at, st, Variant::CORRECT),
        };
        for (sum, c) in sum.iter_mut().zip(sample) {
            *sum += c / (n * n) as f64;
        }
    }
    sum
}
