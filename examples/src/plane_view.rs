//! A plane in perspective: which point of it a pixel shows, and how that changes from pixel to pixel.

use crate::matrix::{DMat4, dvec3};
use glam::{DMat3, DVec2, DVec4};

/// From a picture in pixels to the points (x, z) of the plane y = 0: a matrix of 3 × 3.
#[derive(Clone, Copy, Debug)]
pub struct PlaneView {
    to_plane: DMat3,
}

impl PlaneView {
    /// Of a picture of this size, through projection × view; (0, 0) is the picture's lower left corner.
    pub fn new(view: &DMat4, [width, height]: [f64; 2]) -> Self {
        let pixel =
            |of: DVec4| dvec3(width / 2.0 * (of.x + of.w), height / 2.0 * (of.y + of.w), of.w);
        let columns = [0, 2, 3].map(|column| pixel(view.col(column)));
        let [x, z, w] = columns;
        Self { to_plane: DMat3::from_cols(x, z, w).inverse() }
    }

    /// The point of a place of the picture; beyond the horizon it has no meaning.
    pub fn point(&self, at: DVec2) -> DVec2 {
        let point = self.to_plane * at.extend(1.0);
        point.truncate() / point.z
    }

    /// Whether the plane is seen at a place of the picture.
    pub fn is_below_horizon(&self, at: DVec2) -> bool {
        // The matrix gives 1/w, which is positive before the eye.
        (self.to_plane * at.extend(1.0)).z > 0.0
    }

    /// The derivatives of the point by x and by y: (N / D)' = (N' - point · D') / D.
    pub fn derivatives(&self, at: DVec2) -> [DVec2; 2] {
        let (here, below) = (self.point(at), (self.to_plane * at.extend(1.0)).z);
        let of = self.to_plane;
        [of.x_axis, of.y_axis].map(|by| (by.truncate() - here * by.z) / below)
    }
}

/// The lecture's ρ: the larger gradient of u and of v.
pub fn lecture_rho([x, y]: [DVec2; 2]) -> f64 {
    DVec2::new(x.x, y.x).length().max(DVec2::new(x.y, y.y).length())
}

/// OpenGL's ρ: the larger change of (u, v) along x and along y.
pub fn opengl_rho([x, y]: [DVec2; 2]) -> f64 {
    x.length().max(y.length())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::matrix::{perspective, rotate, translate};
    use glam::{DVec3, dvec2};

    fn view() -> PlaneView {
        let turned = rotate(30.0, DVec3::X) * rotate(25.0, DVec3::Y) * translate(0.0, -2.0, 0.0);
        PlaneView::new(&(perspective(50.0, 2.0, 0.1, 100.0) * turned), [64.0, 32.0])
    }

    #[test]
    fn a_point_is_projected_to_where_it_was_found() {
        let point = view().point(dvec2(20.0, 9.0));
        let turned = rotate(30.0, DVec3::X) * rotate(25.0, DVec3::Y) * translate(0.0, -2.0, 0.0);
        let clip = perspective(50.0, 2.0, 0.1, 100.0) * turned;
        let seen = clip.project_point3(dvec3(point.x, 0.0, point.y));
        let pixel = dvec2(32.0 * (seen.x + 1.0), 16.0 * (seen.y + 1.0));
        assert!((pixel - dvec2(20.0, 9.0)).length() < 1e-9, "{pixel}");
    }

    #[test]
    fn derivatives_are_limits_of_differences() {
        let (view, at, step) = (view(), dvec2(20.0, 9.0), 1e-5);
        for (along, exact) in [DVec2::X, DVec2::Y].into_iter().zip(view.derivatives(at)) {
            let difference = view.point(at + along * step) - view.point(at - along * step);
            assert!((difference / (2.0 * step) - exact).length() < 1e-5);
        }
    }

    #[test]
    fn the_sky_is_above_the_horizon() {
        assert!(view().is_below_horizon(dvec2(32.0, 1.0)));
        assert!(!view().is_below_horizon(dvec2(32.0, 400.0)));
    }

    #[test]
    fn both_measures_are_within_half_a_level_of_each_other() {
        let mut rows = 0;
        for a in -8..8 {
            for b in -8..8 {
                for c in 0..8 {
                    let jacobian = [dvec2(f64::from(a), f64::from(b)), dvec2(f64::from(c), 3.0)];
                    let ratio = lecture_rho(jacobian) / opengl_rho(jacobian);
                    assert!(ratio > 0.707 && ratio < 1.4143, "{jacobian:?}");
                    rows += u32::from(!(0.75..1.33).contains(&ratio));
                }
            }
        }
        assert!(rows > 0, "they never differ by much");
    }
}
