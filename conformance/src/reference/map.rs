//! From a point of the picture to a point of the texture.

/// A projective map of the plane: `(S, T, Q) = H · (x, y, 1)`, `(s, t) = (S/Q, T/Q)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Homography(pub [[f64; 3]; 3]);

impl Homography {
    /// `(S, T, Q)` of a point.
    pub fn homogeneous(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        self.0.map(|row| row[0] * x + row[1] * y + row[2])
    }

    /// The image of a point.
    pub fn apply(&self, p: [f64; 2]) -> [f64; 2] {
        let [s, t, q] = self.homogeneous(p);
        [s / q, t / q]
    }

    /// First `inner`, then this.
    pub fn after(&self, inner: &Self) -> Self {
        let cell = |i: usize, j: usize| (0..3).map(|k| self.0[i][k] * inner.0[k][j]).sum();
        Self([0, 1, 2].map(|i| [0, 1, 2].map(|j| cell(i, j))))
    }

    /// The inverse up to a factor: the adjugate.
    pub fn inverse(&self) -> Self {
        let m = &self.0;
        let minor = |i: usize, j: usize| {
            let (r, c) = ([(i + 1) % 3, (i + 2) % 3], [(j + 1) % 3, (j + 2) % 3]);
            m[r[0]][c[0]] * m[r[1]][c[1]] - m[r[0]][c[1]] * m[r[1]][c[0]]
        };
        Self([0, 1, 2].map(|i| [0, 1, 2].map(|j| minor(j, i))))
    }

    /// The map of the square `x0..x1 × y0..y1` onto a quadrilateral, whose corners are given in
    /// the order (x0, y0), (x1, y0), (x1, y1), (x0, y1) (Heckbert 1989, section 2.2.3).
    pub fn of_square([x0, y0, x1, y1]: [f64; 4], quad: [[f64; 2]; 4]) -> Self {
        let [a, b, c, d] = quad;
        let sum = [0, 1].map(|i| a[i] - b[i] + c[i] - d[i]);
        let (e1, e2) = ([0, 1].map(|i| b[i] - c[i]), [0, 1].map(|i| d[i] - c[i]));
        let det = e1[0] * e2[1] - e2[0] * e1[1];
        let g = (sum[0] * e2[1] - e2[0] * sum[1]) / det;
        let h = (e1[0] * sum[1] - sum[0] * e1[1]) / det;
        let row = |i: usize| [b[i] - a[i] + g * b[i], d[i] - a[i] + h * d[i], a[i]];
        let of_unit = Self([row(0), row(1), [g, h, 1.0]]);
        let (w, h) = (x1 - x0, y1 - y0);
        of_unit.after(&Self([[1.0 / w, 0.0, -x0 / w], [0.0, 1.0 / h, -y0 / h], [0.0, 0.0, 1.0]]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: [f64; 2], b: [f64; 2]) {
        assert!((a[0] - b[0]).abs() + (a[1] - b[1]).abs() < 1e-12, "{a:?} {b:?}");
    }

    #[test]
    fn corners_go_to_corners_and_back() {
        let quad = [[0.0, 0.0], [4.0, 1.0], [3.0, 5.0], [-1.0, 2.0]];
        let map = Homography::of_square([2.0, 3.0, 4.0, 7.0], quad);
        let corners = [[2.0, 3.0], [4.0, 3.0], [4.0, 7.0], [2.0, 7.0]];
        for (corner, to) in corners.into_iter().zip(quad) {
            near(map.apply(corner), to);
            near(map.inverse().apply(to), corner);
        }
    }
}
