//! ꟻLIP, a measure of how different two pictures look when flipped between (Andersson, Nilsson,
//! Akenine-Möller, Oskarsson, Åström, Fairchild 2020: "FLIP: A Difference Evaluator for Alternating
//! Images"), for an observer at 67 pixels per degree.
//!
//! The crates that have it wrap C++; the measure itself is short. Colours are filtered as the eye's
//! contrast sensitivity does, compared in a perceptually uniform space, and the difference is raised
//! where edges and points differ.

/// Linear R, G, B of each pixel, rows one after the other.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Pixels in a row.
    pub width: usize,
    /// sRGB-encoded R, G, B in [0, 1].
    pub pixels: Vec<[f64; 3]>,
}

const PIXELS_PER_DEGREE: f64 = 67.0;

/// The mean error over all pixels, 0 to 1.
pub fn mean(reference: &Picture, test: &Picture) -> f64 {
    let errors = errors(reference, test);
    errors.iter().sum::<f64>() / errors.len() as f64
}

/// The error of each pixel, 0 to 1.
pub fn errors(reference: &Picture, test: &Picture) -> Vec<f64> {
    let (a, b) = (Opponent::new(reference), Opponent::new(test));
    let (color_a, color_b) = (a.perceived(), b.perceived());
    let (feature_a, feature_b) = (a.features(), b.features());
    let largest = {
        let [green, blue] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|rgb| hunt(lab(rgb)));
        hyab(green, blue).powf(0.7)
    };
    (0..reference.pixels.len())
        .map(|i| {
            let difference = hyab(color_a[i], color_b[i]).powf(0.7);
            // Up to 0.4 of the largest takes 0.95 of the scale.
            let knee = 0.4 * largest;
            let color = if difference < knee {
                0.95 / knee * difference
            } else {
                0.95 + (difference - knee) / (largest - knee) * 0.05
            };
            let [edge, point] = [0, 1].map(|k: usize| (feature_a[i][k] - feature_b[i][k]).abs());
            let feature = (edge.max(point) / 2f64.sqrt()).sqrt();
            color.clamp(0.0, 1.0).powf(1.0 - feature)
        })
        .collect()
}

/// A picture in the opponent space YCxCz.
struct Opponent {
    width: usize,
    pixels: Vec<[f64; 3]>,
}

/// White of D65.
const WHITE: [f64; 3] = [0.950_428_545, 1.0, 1.088_900_371];

fn xyz(rgb: [f64; 3]) -> [f64; 3] {
    const M: [[f64; 3]; 3] = [
        [0.412_391, 0.357_584, 0.180_481],
        [0.212_639, 0.715_169, 0.072_192],
        [0.019_331, 0.119_195, 0.950_532],
    ];
    M.map(|row| row[0] * rgb[0] + row[1] * rgb[1] + row[2] * rgb[2])
}

fn rgb(xyz: [f64; 3]) -> [f64; 3] {
    const M: [[f64; 3]; 3] = [
        [3.240_970, -1.537_383, -0.498_611],
        [-0.969_244, 1.875_968, 0.041_555],
        [0.055_630, -0.203_977, 1.056_972],
    ];
    M.map(|row| (row[0] * xyz[0] + row[1] * xyz[1] + row[2] * xyz[2]).clamp(0.0, 1.0))
}

/// CIE L*a*b* of linear R, G, B.
fn lab(color: [f64; 3]) -> [f64; 3] {
    let c = xyz(color);
    let f = |t: f64| {
        const D: f64 = 6.0 / 29.0;
        if t > D * D * D { t.cbrt() } else { t / (3.0 * D * D) + 4.0 / 29.0 }
    };
    let [x, y, z] = [0, 1, 2].map(|i: usize| f(c[i] / WHITE[i]));
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// Colours of dark pixels count less (Hunt).
fn hunt([l, a, b]: [f64; 3]) -> [f64; 3] {
    [l, 0.01 * l * a, 0.01 * l * b]
}

fn hyab(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] - b[0]).abs() + ((a[1] - b[1]).powi(2) + (a[2] - b[2]).powi(2)).sqrt()
}

impl Opponent {
    fn new(picture: &Picture) -> Self {
        let pixels = picture
            .pixels
            .iter()
            .map(|pixel| {
                let linear = pixel
                    .map(|c| crate::oracle::srgb::decode(c, crate::mutation::Variant::CORRECT));
                let c = xyz(linear);
                let [x, y, z] = [0, 1, 2].map(|i: usize| c[i] / WHITE[i]);
                [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
            })
            .collect();
        Self { width: picture.width, pixels }
    }

    /// What an eye sees of it, in Hunt-adjusted L*a*b*.
    fn perceived(&self) -> Vec<[f64; 3]> {
        // Amplitude and width of each channel's one or two Gaussians.
        let channels: [&[[f64; 2]]; 3] =
            [&[[1.0, 0.0047]], &[[1.0, 0.0053]], &[[34.1, 0.04], [13.5, 0.025]]];
        let filtered = [0, 1, 2].map(|channel: usize| {
            let plane: Vec<f64> = self.pixels.iter().map(|pixel| pixel[channel]).collect();
            let mut sum = vec![0.0; plane.len()];
            let mut total = 0.0;
            for &[a, b] in channels[channel] {
                // a·√(π/b)·exp(-π²d²/b), whose sum over the plane is a·√(b/π)·…: kept as it is.
                let radius = (3.0
                    * (0.04 / (2.0 * std::f64::consts::PI.powi(2))).sqrt()
                    * PIXELS_PER_DEGREE)
                    .ceil() as i64;
                let kernel: Vec<f64> = (-radius..=radius)
                    .map(|i| {
                        let d = i as f64 / PIXELS_PER_DEGREE;
                        (-(std::f64::consts::PI * d).powi(2) / b).exp()
                    })
                    .collect();
                let one: f64 = kernel.iter().sum();
                let weight = a * (std::f64::consts::PI / b).sqrt();
                total += weight * one * one;
                let rows = self.convolved(&plane, &kernel, &kernel);
                for (sum, value) in sum.iter_mut().zip(rows) {
                    *sum += weight * value;
                }
            }
            sum.into_iter().map(|value| value / total).collect::<Vec<f64>>()
        });
        (0..self.pixels.len())
            .map(|i| {
                let y = (filtered[0][i] + 16.0) / 116.0;
                let (x, z) = (filtered[1][i] / 500.0 + y, y - filtered[2][i] / 200.0);
                hunt(lab(rgb([x * WHITE[0], y * WHITE[1], z * WHITE[2]])))
            })
            .collect()
    }

    /// Strength of edges and of points at each pixel.
    fn features(&self) -> Vec<[f64; 2]> {
        let plane: Vec<f64> = self.pixels.iter().map(|pixel| (pixel[0] + 16.0) / 116.0).collect();
        let sd = 0.5 * 0.082 * PIXELS_PER_DEGREE;
        let radius = (3.0 * sd).ceil() as i64;
        let gauss: Vec<f64> =
            (-radius..=radius).map(|i| (-(i as f64).powi(2) / (2.0 * sd * sd)).exp()).collect();
        let weighted = |f: &dyn Fn(f64) -> f64| -> Vec<f64> {
            (-radius..=radius).zip(&gauss).map(|(i, g)| f(i as f64) * g).collect()
        };
        let total: f64 = gauss.iter().sum();
        let across: Vec<f64> = gauss.iter().map(|g| g / total).collect();
        // The positive weights of a derivative sum to 1, and the negative ones to -1.
        let normalized = |kernel: Vec<f64>| -> Vec<f64> {
            let sum = |positive: bool| -> f64 {
                kernel.iter().filter(|w| (**w > 0.0) == positive).map(|w| w.abs()).sum()
            };
            let (plus, minus) = (sum(true), sum(false));
            kernel.iter().map(|&w| if w > 0.0 { w / plus } else { w / minus }).collect()
        };
        let first = normalized(weighted(&|i| -i));
        let second = normalized(weighted(&|i| i * i / (sd * sd) - 1.0));
        let strength = |kernel: &[f64]| -> Vec<f64> {
            let x = self.convolved(&plane, kernel, &across);
            let y = self.convolved(&plane, &across, kernel);
            x.into_iter().zip(y).map(|(x, y)| x.hypot(y)).collect()
        };
        strength(&first).into_iter().zip(strength(&second)).map(|(e, p)| [e, p]).collect()
    }

    /// A separable filter; beyond the edge stands the edge's pixel.
    fn convolved(&self, plane: &[f64], horizontal: &[f64], vertical: &[f64]) -> Vec<f64> {
        let (w, h) = (self.width as i64, (plane.len() / self.width) as i64);
        let pass = |from: &[f64], kernel: &[f64], dx: i64, dy: i64| -> Vec<f64> {
            let radius = kernel.len() as i64 / 2;
            (0..w * h)
                .map(|p| {
                    let (x, y) = (p % w, p / w);
                    let tap = |k: i64| {
                        let (x, y) = ((x + k * dx).clamp(0, w - 1), (y + k * dy).clamp(0, h - 1));
                        from[(y * w + x) as usize]
                    };
                    kernel.iter().zip(-radius..).map(|(weight, k)| weight * tap(k)).sum()
                })
                .collect()
        };
        pass(&pass(plane, horizontal, 1, 0), vertical, 0, 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(color: [f64; 3]) -> Picture {
        Picture { width: 24, pixels: vec![color; 24 * 24] }
    }

    #[test]
    fn nothing_differs_from_itself_and_black_from_white_by_nearly_all() {
        assert_eq!(mean(&flat([0.3, 0.5, 0.1]), &flat([0.3, 0.5, 0.1])), 0.0);
        let most = mean(&flat([0.0; 3]), &flat([1.0; 3]));
        assert!((0.95..=1.0).contains(&most), "{most}");
        let little = mean(&flat([0.5; 3]), &flat([0.51; 3]));
        assert!((0.001..0.2).contains(&little), "{little}");
    }
}
