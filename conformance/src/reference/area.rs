//! True area integration: the mean of the texture over a pixel, exactly.
//!
//! A projective map takes the pixel's square to a quadrilateral on the texture and straight lines
//! to straight lines. The quadrilateral is cut along the lines between texels; the pieces, taken
//! back to the picture, are polygons within the pixel, over each of which the texture is one
//! formula. With box reconstruction that is a constant, and the integral is the polygon's area.
//! With bilinear reconstruction it is a product of two linear functions of (s, t), which Gauss's
//! rule of degree 5 on triangles integrates exactly where the map is affine, and to far below a
//! rounding of `f32` where perspective bends it within one pixel.

use super::Reconstruction;
use super::map::Homography;
use crate::oracle::texture::Level;

type Point = [f64; 2];

/// The mean colour of a repeated image over the square `[x0, y0, x1, y1]` of the picture; `map`
/// takes the picture to texels of the image.
pub fn mean(level: &Level, map: &Homography, square: [f64; 4], of: Reconstruction) -> [f64; 4] {
    let [x0, y0, x1, y1] = square;
    // Cells lie between texel edges, or between texel centres.
    let offset = match of {
        Reconstruction::Box => 0.0,
        Reconstruction::Bilinear => 0.5,
    };
    let back = map.inverse();
    let corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
    let quad: Vec<Point> = corners.iter().map(|&p| map.apply(p).map(|c| c - offset)).collect();
    let (mut sum, mut area) = ([0.0; 4], 0.0);
    for (i, column) in slices(&quad, 0) {
        for (j, piece) in slices(&column, 1) {
            let polygon: Vec<Point> =
                piece.iter().map(|uv| back.apply(uv.map(|c| c + offset))).collect();
            let texels = Cell::new(level, i, j, of);
            for k in 1..polygon.len().saturating_sub(1) {
                let triangle = [polygon[0], polygon[k], polygon[k + 1]];
                area += texels.integrate(triangle, map, offset, &mut sum);
            }
        }
    }
    sum.map(|c| c / area)
}

/// A convex polygon cut at the whole numbers of an axis: their lower ones, and the pieces.
fn slices(polygon: &[Point], axis: usize) -> Vec<(i64, Vec<Point>)> {
    let low = polygon.iter().map(|p| p[axis]).fold(f64::INFINITY, f64::min).floor();
    let high = polygon.iter().map(|p| p[axis]).fold(f64::NEG_INFINITY, f64::max).ceil();
    let mut rest = polygon.to_vec();
    let mut pieces = Vec::new();
    let mut at = low;
    while at < high && rest.len() > 2 {
        let (below, above) = cut(&rest, axis, at + 1.0);
        if below.len() > 2 {
            pieces.push((at as i64, below));
        }
        rest = above;
        at += 1.0;
    }
    pieces
}

/// The parts of a convex polygon on either side of a line (Sutherland and Hodgman).
fn cut(polygon: &[Point], axis: usize, line: f64) -> (Vec<Point>, Vec<Point>) {
    let (mut below, mut above) = (Vec::with_capacity(8), Vec::with_capacity(8));
    for (k, &p) in polygon.iter().enumerate() {
        let q = polygon[(k + 1) % polygon.len()];
        let (a, b) = (p[axis] - line, q[axis] - line);
        if a <= 0.0 {
            below.push(p);
        }
        if a >= 0.0 {
            above.push(p);
        }
        if (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0) {
            let t = a / (a - b);
            let mut crossing = [0, 1].map(|c| p[c] + t * (q[c] - p[c]));
            crossing[axis] = line;
            below.push(crossing);
            above.push(crossing);
        }
    }
    (below, above)
}

/// The texels that a cell's formula has.
enum Cell {
    Constant([f64; 4]),
    /// Of the corners (0, 0), (1, 0), (0, 1), (1, 1) of the cell at this place.
    Bilinear(Point, [[f64; 4]; 4]),
}

/// Gauss points of a triangle and their weights: degree 5 (Radon 1948).
const GAUSS: [([f64; 3], f64); 7] = {
    const A: f64 = 0.470_142_064_105_115_1;
    const B: f64 = 0.101_286_507_323_456_34;
    const WA: f64 = 0.132_394_152_788_506_2;
    const WB: f64 = 0.125_939_180_544_827_14;
    [
        ([1.0 / 3.0; 3], 0.225),
        ([1.0 - 2.0 * A, A, A], WA),
        ([A, 1.0 - 2.0 * A, A], WA),
        ([A, A, 1.0 - 2.0 * A], WA),
        ([1.0 - 2.0 * B, B, B], WB),
        ([B, 1.0 - 2.0 * B, B], WB),
        ([B, B, 1.0 - 2.0 * B], WB),
    ]
};

impl Cell {
    fn new(level: &Level, i: i64, j: i64, of: Reconstruction) -> Self {
        let texel = |a: i64, b: i64| {
            let wrap = |n: i64, size: usize| n.rem_euclid(size as i64) as usize;
            level.texel(wrap(i + a, level.width), wrap(j + b, level.height))
        };
        match of {
            Reconstruction::Box => Self::Constant(texel(0, 0)),
            Reconstruction::Bilinear => Self::Bilinear(
                [i as f64, j as f64],
                [texel(0, 0), texel(1, 0), texel(0, 1), texel(1, 1)],
            ),
        }
    }

    /// Adds the integral over a triangle of the picture; gives the triangle's area.
    fn integrate(
        &self,
        [a, b, c]: [Point; 3],
        map: &Homography,
        offset: f64,
        sum: &mut [f64; 4],
    ) -> f64 {
        let area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])).abs();
        match self {
            Self::Constant(texel) => {
                for (sum, c) in sum.iter_mut().zip(texel) {
                    *sum += area * c;
                }
            }
            Self::Bilinear(cell, corners) => {
                for ([wa, wb, wc], weight) in GAUSS {
                    let p = [0, 1].map(|k| wa * a[k] + wb * b[k] + wc * c[k]);
                    let uv = map.apply(p);
                    let [alpha, beta] = [0, 1].map(|k| uv[k] - offset - cell[k]);
                    let weights = [
                        (1.0 - alpha) * (1.0 - beta),
                        alpha * (1.0 - beta),
                        (1.0 - alpha) * beta,
                        alpha * beta,
                    ];
                    for (k, sum) in sum.iter_mut().enumerate() {
                        let value: f64 =
                            weights.iter().zip(corners).map(|(w, texel)| w * texel[k]).sum();
                        *sum += area * weight * value;
                    }
                }
            }
        }
        area
    }
}

#[cfg(test)]
mod tests {
    use super::super::supersample;
    use super::*;

    fn level() -> Level {
        Level::from_fn(8, 8, |i, j| [(i * 37 + j * 91) as u8, (i * j * 5) as u8, 0, 255])
    }

    #[test]
    fn whole_texels_give_their_mean() {
        let double = Homography([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]]);
        let got = mean(&level(), &double, [1.0, 0.0, 2.0, 1.0], Reconstruction::Box);
        let four = [(2, 0), (3, 0), (2, 1), (3, 1)].map(|(i, j)| level().texel(i, j)[0]);
        assert!((got[0] - four.iter().sum::<f64>() / 4.0).abs() < 1e-14);
    }

    #[test]
    fn many_samples_come_to_the_same() {
        let quad = [[0.3, 0.1], [6.2, 1.0], [4.1, 3.7], [-1.0, 2.2]];
        let map = Homography::of_square([0.0, 0.0, 1.0, 1.0], quad);
        for of in [Reconstruction::Box, Reconstruction::Bilinear] {
            let exact = mean(&level(), &map, [0.0, 0.0, 1.0, 1.0], of);
            let sampled = supersample::mean(&level(), &map, [0.0, 0.0, 1.0, 1.0], 400, of);
            assert!((exact[0] - sampled[0]).abs() < 2e-4, "{of:?} {exact:?} {sampled:?}");
            assert!((exact[3] - 1.0).abs() < 1e-12);
        }
    }
}
