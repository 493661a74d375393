//! Exact area integration: the mean of a texture over a polygon.

use crate::picture::{Color, Picture};
use glam::{DVec2, dvec2};

/// A repeating texture with the integrals of its rows.
#[derive(Clone, Debug)]
pub struct AreaTexture {
    width: f64,
    rows: Vec<Row>,
    mean: Color,
}

/// At each texel's left edge: the integral of the row from 0, and the integral of that.
#[derive(Clone, Debug)]
struct Row {
    texels: Vec<Color>,
    once: Vec<Color>,
    twice: Vec<Color>,
}

/// Beyond so many rows the footprint has the mean of the whole texture.
const MOST_ROWS: f64 = 1024.0;

impl AreaTexture {
    /// Of a picture whose first row is at v = 0.
    pub fn new(picture: &Picture) -> Self {
        let rows: Vec<Row> = picture
            .pixels
            .chunks_exact(picture.width)
            .map(|pixels| {
                let texels: Vec<Color> =
                    pixels.iter().map(|p| [p.r, p.g, p.b].map(|c| f64::from(c) / 255.0)).collect();
                let (mut once, mut twice) = (vec![[0.0; 3]], vec![[0.0; 3]]);
                for (at, texel) in texels.iter().enumerate() {
                    let (f, g): (Color, Color) = (once[at], twice[at]);
                    once.push(std::array::from_fn(|c| f[c] + texel[c]));
                    twice.push(std::array::from_fn(|c| g[c] + f[c] + texel[c] / 2.0));
                }
                Row { texels, once, twice }
            })
            .collect();
        let size = (picture.width * picture.height) as f64;
        let totals = rows.iter().map(|row| row.once[picture.width]);
        let sum =
            totals.fold([0.0; 3], |sum: Color, total| std::array::from_fn(|c| sum[c] + total[c]));
        Self { width: picture.width as f64, rows, mean: sum.map(|c| c / size) }
    }

    /// The mean over a convex polygon in texels.
    pub fn mean(&self, polygon: &[DVec2]) -> Color {
        let (low, high) = polygon
            .iter()
            .fold((f64::MAX, f64::MIN), |(low, high), at| (low.min(at.y), high.max(at.y)));
        let area: f64 = edges(polygon)
            .map(|(from, to)| from.x * (to.y - from.y) + (to.x - from.x) * (to.y - from.y) / 2.0)
            .sum();
        if high - low > MOST_ROWS || area.abs() < 1e-9 {
            return self.mean;
        }
        let mut sum = [0.0; 3];
        let (mut band, mut half) = (Vec::new(), Vec::new());
        for row in low.floor() as i64..high.ceil() as i64 {
            let bottom = row as f64;
            clip(polygon, |at| at.y - bottom, &mut half);
            clip(&half, |at| bottom + 1.0 - at.y, &mut band);
            let of = &self.rows[row.rem_euclid(self.rows.len() as i64) as usize];
            for (from, to) in edges(&band) {
                let integral = self.edge(of, from, to);
                sum = std::array::from_fn(|c| sum[c] + integral[c]);
            }
        }
        sum.map(|c| c / area)
    }

    /// The integral of the row's integral along an edge, dv: by Green's theorem, those of all edges give that of
    /// the row over the polygon.
    fn edge(&self, row: &Row, from: DVec2, to: DVec2) -> Color {
        let (across, up) = (to.x - from.x, to.y - from.y);
        if across.abs() < 1e-6 {
            return self.once(row, (from.x + to.x) / 2.0).map(|f| f * up);
        }
        let (begin, end) = (self.twice(row, from.x), self.twice(row, to.x));
        std::array::from_fn(|c| (end[c] - begin[c]) / across * up)
    }

    /// The integral of a row from 0 to `u`.
    fn once(&self, row: &Row, u: f64) -> Color {
        let (periods, texel, part) = self.place(u);
        let total = row.once[row.texels.len()];
        std::array::from_fn(|c| {
            periods * total[c] + row.once[texel][c] + part * row.texels[texel][c]
        })
    }

    /// The integral of [`Self::once`] from 0 to `u`.
    fn twice(&self, row: &Row, u: f64) -> Color {
        let (periods, texel, part) = self.place(u);
        let (total, whole) = (row.once[row.texels.len()], row.twice[row.texels.len()]);
        let rest = texel as f64 + part;
        std::array::from_fn(|c| {
            let before =
                periods * (periods - 1.0) / 2.0 * self.width * total[c] + periods * whole[c];
            let here = row.twice[texel][c]
                + part * row.once[texel][c]
                + part * part / 2.0 * row.texels[texel][c];
            before + periods * total[c] * rest + here
        })
    }

    /// Whole periods, the texel, and the part of it.
    fn place(&self, u: f64) -> (f64, usize, f64) {
        let periods = (u / self.width).floor();
        let rest = u - periods * self.width;
        let texel = (rest as usize).min(self.width as usize - 1);
        (periods, texel, rest - texel as f64)
    }
}

/// The edges of a polygon.
fn edges(polygon: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> {
    polygon.iter().copied().zip(polygon.iter().copied().cycle().skip(1))
}

/// The part of a convex polygon where `inside` is not negative.
fn clip(polygon: &[DVec2], inside: impl Fn(DVec2) -> f64, kept: &mut Vec<DVec2>) {
    kept.clear();
    for (from, to) in edges(polygon) {
        let (a, b) = (inside(from), inside(to));
        if a >= 0.0 {
            kept.push(from);
        }
        if (a >= 0.0) != (b >= 0.0) {
            kept.push(from + (to - from) * (a / (a - b)));
        }
    }
}

/// The corners of a pixel, counterclockwise.
pub fn pixel_corners(x: f64, y: f64) -> [DVec2; 4] {
    [dvec2(x, y), dvec2(x + 1.0, y), dvec2(x + 1.0, y + 1.0), dvec2(x, y + 1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texture() -> AreaTexture {
        AreaTexture::new(&Picture::paint_centers(4, 4, |x, y| [x, y, (x * 3.0).fract()]))
    }

    #[test]
    fn a_texel_has_its_own_value_and_a_period_the_mean() {
        let texture = texture();
        let [r, g, _] = texture.mean(&pixel_corners(5.0, -3.0));
        // Texel (1, 1) of four.
        assert!((r - 96.0 / 255.0).abs() < 1e-9 && (g - 96.0 / 255.0).abs() < 1e-9, "{r} {g}");
        let period = [dvec2(-1.3, 0.4), dvec2(2.7, 0.4), dvec2(2.7, 4.4), dvec2(-1.3, 4.4)];
        let got = texture.mean(&period);
        assert!((0..3).all(|c| (got[c] - texture.mean[c]).abs() < 1e-9), "{got:?}");
    }

    #[test]
    fn a_slanted_polygon_has_the_mean_of_many_points() {
        let texture = texture();
        let corner = dvec2(-0.7, 1.2);
        let (along, across) = (dvec2(6.3, 1.1), dvec2(-1.4, 3.3));
        let got = texture.mean(&[corner, corner + along, corner + along + across, corner + across]);
        let mut sum = [0.0; 3];
        const POINTS: usize = 400;
        for at in 0..POINTS * POINTS {
            let part = |i: usize| (i as f64 + 0.5) / POINTS as f64;
            let point = corner + along * part(at % POINTS) + across * part(at / POINTS);
            let [i, j] = [point.x, point.y].map(|c| c.floor().rem_euclid(4.0) as usize);
            sum = std::array::from_fn(|c| sum[c] + texture.rows[j].texels[i][c]);
        }
        for c in 0..3 {
            let many = sum[c] / (POINTS * POINTS) as f64;
            assert!((got[c] - many).abs() < 1e-3, "{} {many}", got[c]);
        }
    }
}
