//! Copies between rectangles (GL 3.0, section 4.3.2), and pixel rectangles with zoom (GL 2.1, section 3.6.5).

use crate::mutation::{Mutation, Variant};

/// From `low` to `high` on one axis; reversed where `high` is the smaller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the words say it")]
pub struct Span {
    pub low: i64,
    pub high: i64,
}

impl Span {
    /// Whether a pixel lies in it.
    pub fn has(&self, pixel: usize) -> bool {
        (self.low.min(self.high)..self.low.max(self.high)).contains(&(pixel as i64))
    }
}

/// The place in the source of the centre of a pixel of the destination.
pub fn source(from: Span, to: Span, pixel: usize, variant: Variant) -> f64 {
    let to = if variant.has(Mutation::FlipIgnored) && to.low > to.high {
        Span { low: to.high, high: to.low }
    } else {
        to
    };
    let centre = if variant.has(Mutation::InterpolatedAtCorner) { 0.01 } else { 0.5 };
    let t = (pixel as f64 + centre - to.low as f64) / (to.high - to.low) as f64;
    from.low as f64 + t * (from.high - from.low) as f64
}

/// Which column or row of a pixel rectangle a pixel shows; `None` near the edge of one.
pub fn zoomed(raster: f64, zoom: f64, pixel: usize, variant: Variant) -> Option<i64> {
    let zoom = if variant.has(Mutation::ZoomIsPositive) { zoom.abs() } else { zoom };
    let raster = if variant.has(Mutation::RasterFloored) { raster.floor() } else { raster };
    let n = (pixel as f64 + 0.5 - raster) / zoom;
    ((n - n.round()).abs() > 1e-4).then_some(n.floor() as i64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flip_and_a_scale_by_hand() {
        let (from, to) = (Span { low: 0, high: 4 }, Span { low: 10, high: 2 });
        assert_eq!(source(from, to, 9, Variant::CORRECT), 0.25);
        assert_eq!(source(from, to, 2, Variant::CORRECT), 3.75);
        assert!(to.has(2) && to.has(9) && !to.has(10));
    }

    #[test]
    fn a_zoom_of_minus_two() {
        let of = |pixel| zoomed(8.0, -2.0, pixel, Variant::CORRECT);
        assert_eq!([of(7), of(6), of(5), of(8)], [Some(0), Some(0), Some(1), Some(-1)]);
    }
}
