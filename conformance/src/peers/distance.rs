//! The distance of a driver's picture from the reference picture.

use super::reference::ReferencePicture;
use serde::Serialize;

/// A distance in steps of a byte, over R, G and B of the pixels that are compared.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Distance {
    /// Root of the mean square.
    pub rms: f64,
    /// The largest distance.
    pub max: u8,
    /// The fraction of pixels that differ.
    pub differing: f64,
}

impl Distance {
    /// The distance of RGBA bytes from the reference picture.
    pub fn between(truth: &ReferencePicture, picture: &[u8], side: usize) -> Self {
        let (mut sum, mut max, mut differing, mut count) = (0.0, 0, 0u32, 0u32);
        for y in (0..side).step_by(truth.every) {
            for x in (0..side).step_by(truth.every) {
                let k = y * side + x;
                let got = &picture[4 * k..4 * k + 3];
                let steps = |c: usize| truth.pixels[k][c].abs_diff(got[c]);
                let largest = steps(0).max(steps(1)).max(steps(2));
                sum += (0..3).map(|c| f64::from(steps(c)).powi(2)).sum::<f64>();
                max = max.max(largest);
                differing += u32::from(largest > 0);
                count += 1;
            }
        }
        let count = f64::from(count);
        Self { rms: (sum / (3.0 * count)).sqrt(), max, differing: f64::from(differing) / count }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_channel_of_one_pixel() {
        let truth = ReferencePicture { pixels: vec![[10, 20, 30, 255]; 4], every: 1 };
        let mut picture = [10, 20, 30, 255].repeat(4);
        picture[5] = 26;
        picture[7] = 0;
        let distance = Distance::between(&truth, &picture, 2);
        assert_eq!((distance.max, distance.differing), (6, 0.25));
        assert!((distance.rms - 3f64.sqrt()).abs() < 1e-12);
    }
}
