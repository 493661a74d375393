//! Points (section 3.3): which pixels they cover, how large they are, and the coordinates of sprites.

use crate::mutation::{Mutation, Variant};

/// A point in window coordinates, and its size.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the words say it")]
pub struct Dot {
    pub at: [f64; 2],
    pub size: f64,
}

impl Dot {
    /// Whether the aliased point covers a pixel: a square of whole pixels about the pixel's centre or corner that is
    /// nearest.
    pub fn covers(&self, pixel: [usize; 2], variant: Variant) -> bool {
        let rounded = self.size.round().max(1.0);
        let odd = (rounded % 2.0 == 1.0) != variant.has(Mutation::PointParitySwapped);
        (0..2).all(|i| {
            let centre = if odd { self.at[i].floor() + 0.5 } else { (self.at[i] + 0.5).floor() };
            (pixel[i] as f64 + 0.5 - centre).abs() < rounded / 2.0
        })
    }

    /// Whether the sprite, a square of this size about the point, has the centre of a pixel; `None` close to its
    /// sides.
    pub fn sprite_covers(&self, pixel: [usize; 2]) -> Option<bool> {
        let far = (0..2)
            .map(|i| (pixel[i] as f64 + 0.5 - self.at[i]).abs() - self.size / 2.0)
            .fold(f64::NEG_INFINITY, f64::max);
        (far.abs() > 1.0 / 128.0).then_some(far < 0.0)
    }

    /// (s, t) of a sprite at a pixel, from the upper or the lower left.
    pub fn sprite(&self, pixel: [usize; 2], origin: Origin, variant: Variant) -> [f64; 2] {
        let [s, t] = [0, 1].map(|i| 0.5 + (pixel[i] as f64 + 0.5 - self.at[i]) / self.size);
        let upper = (origin == Origin::UpperLeft) != variant.has(Mutation::SpriteUpsideDown);
        [s, if upper { 1.0 - t } else { t }]
    }

    /// The part of a pixel that the antialiased point covers: the area that the pixel shares with a circle.
    pub fn area(&self, pixel: [usize; 2], variant: Variant) -> f64 {
        let radius = self.size / if variant.has(Mutation::DiameterIsRadius) { 1.0 } else { 2.0 };
        let [x, y] = [0, 1].map(|i| pixel[i] as f64 - self.at[i]);
        circle_area(radius, [x, x + 1.0], [y, y + 1.0])
    }
}

/// `GL_POINT_SPRITE_COORD_ORIGIN`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GL's names")]
pub enum Origin {
    UpperLeft,
    LowerLeft,
}

/// The area that a circle about the origin shares with a rectangle: the integral over x of the part of its chord
/// that lies between the rectangle's sides, piece by piece, where each end of the chord is either a side or the arc.
fn circle_area(r: f64, [x0, x1]: [f64; 2], [y0, y1]: [f64; 2]) -> f64 {
    let (x0, x1) = (x0.max(-r), x1.min(r));
    if x0 >= x1 {
        return 0.0;
    }
    let mut cuts = vec![x0, x1];
    for y in [y0, y1] {
        let x = (r * r - y * y).max(0.0).sqrt();
        cuts.extend([-x, x].into_iter().filter(|x| (x0..x1).contains(x)));
    }
    cuts.sort_by(f64::total_cmp);
    // The integral of sqrt(r² − x²).
    let arc = |x: f64| {
        let x = x.clamp(-r, r);
        0.5 * (x * (r * r - x * x).max(0.0).sqrt() + r * r * (x / r).asin())
    };
    cuts.windows(2)
        .map(|piece| {
            let (from, to) = (piece[0], piece[1]);
            let middle = f64::midpoint(from, to);
            let height = (r * r - middle * middle).max(0.0).sqrt();
            let end = |sign: f64| {
                let y = sign * height;
                if y <= y0 {
                    y0 * (to - from)
                } else if y >= y1 {
                    y1 * (to - from)
                } else {
                    sign * (arc(to) - arc(from))
                }
            };
            end(1.0) - end(-1.0)
        })
        .sum()
}

/// What a point of a derived size is drawn as where there are samples (equation 3.2): its width, which is at least the
/// threshold, and what its alpha is multiplied by.
pub fn faded(derived: f64, threshold: f64, variant: Variant) -> [f64; 2] {
    let part = (derived / threshold).min(1.0);
    let width = if variant.has(Mutation::FadedAsSmall) { derived } else { derived.max(threshold) };
    let factor = if variant.has(Mutation::FadeIgnored) {
        1.0
    } else if variant.has(Mutation::FadeNotSquared) {
        part
    } else {
        part * part
    };
    [width, factor]
}

/// `GL_POINT_DISTANCE_ATTENUATION`, and the limits of sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "GL's names")]
pub struct Attenuation {
    pub factors: [f64; 3],
    pub min: f64,
    pub max: f64,
}

impl Attenuation {
    /// The size of a point at a distance from the eye.
    pub fn size(&self, size: f64, distance: f64, variant: Variant) -> f64 {
        let [a, b, c] = self.factors;
        let sum = a + b * distance + c * distance * distance;
        let factor = if variant.has(Mutation::AttenuationWithoutRoot) {
            1.0 / sum
        } else {
            (1.0 / sum).sqrt()
        };
        if variant.has(Mutation::SizeUnclamped) {
            return size * factor;
        }
        (size * factor).clamp(self.min, self.max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn squares_by_hand() {
        let odd = Dot { at: [4.9, 4.1], size: 3.0 };
        assert!(odd.covers([3, 3], TRUE) && odd.covers([5, 5], TRUE) && !odd.covers([6, 4], TRUE));
        let even = Dot { at: [4.4, 4.6], size: 2.0 };
        assert!(even.covers([3, 4], TRUE) && even.covers([4, 5], TRUE));
        assert!(!even.covers([5, 4], TRUE) && !even.covers([3, 3], TRUE));
    }

    #[test]
    fn areas_of_circles_by_hand() {
        let unit = Dot { at: [0.0, 0.0], size: 2.0 };
        assert!((unit.area([0, 0], TRUE) - PI / 4.0).abs() < 1e-12);
        let large = Dot { at: [3.0, 3.0], size: 5.0 };
        let total: f64 = (0..36).map(|k| large.area([k % 6, k / 6], TRUE)).sum();
        assert!((total - 6.25 * PI).abs() < 1e-12);
        let inside = Dot { at: [0.5, 0.5], size: 0.5 };
        assert!((inside.area([0, 0], TRUE) - PI / 16.0).abs() < 1e-12);
    }

    #[test]
    fn half_of_the_threshold_fades_to_a_quarter() {
        assert_eq!(faded(3.0, 6.0, TRUE), [6.0, 0.25]);
        assert_eq!(faded(7.0, 6.0, TRUE), [7.0, 1.0]);
    }

    #[test]
    fn the_middle_of_a_sprite() {
        let dot = Dot { at: [8.5, 8.5], size: 4.0 };
        assert_eq!(dot.sprite([8, 8], Origin::LowerLeft, TRUE), [0.5, 0.5]);
        assert_eq!(dot.sprite([8, 9], Origin::UpperLeft, TRUE), [0.5, 0.25]);
    }

    #[test]
    fn a_point_at_twice_the_distance_is_half_as_large() {
        let by = Attenuation { factors: [0.0, 0.0, 1.0], min: 1.0, max: 64.0 };
        assert_eq!(by.size(16.0, 2.0, TRUE), 8.0);
        assert_eq!(by.size(16.0, 64.0, TRUE), 1.0);
    }
}
