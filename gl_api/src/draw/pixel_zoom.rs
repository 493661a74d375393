//! Pixel zoom: which pixel of a rectangle each pixel of the framebuffer gets (GL 2.1, section 3.6.4), or each of its
//! samples (section 3.6.6).

use crate::context::Context;
use rasterizer::driver::Rect;

/// One axis of a rectangle: where it begins in the window, how much of it a pixel takes, how many
/// pixels there are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Axis {
    pub start: f64,
    pub zoom: f64,
    pub count: usize,
}

impl Axis {
    /// Which pixel of the rectangle has a point of this pixel of the window, which lies at `offset` in it. A point on a
    /// left or lower edge counts, one on a right or upper edge does not.
    fn source(self, pixel: i32, offset: f64) -> Option<usize> {
        let along = (f64::from(pixel) + offset - self.start) / self.zoom;
        // Of a mirrored rectangle, the left edge is where a pixel ends.
        let index = if self.zoom > 0.0 { along.floor() } else { along.ceil() - 1.0 };
        (index >= 0.0 && index < self.count as f64).then_some(index as usize)
    }

    /// The pixels of the window from `first` to before `end` that get any at `offset`, in order: the first of
    /// them and the pixel of the rectangle for each.
    fn taps(self, first: i32, end: i32, offset: f64) -> (i32, Vec<usize>) {
        let (a, b) = (self.start, self.start + self.zoom * self.count as f64);
        let low = (a.min(b).floor().max(f64::from(first)) as i32).min(end);
        let high = (a.max(b).ceil().min(f64::from(end)) as i32).max(low);
        let taps: Vec<(i32, usize)> =
            (low..high).filter_map(|pixel| Some((pixel, self.source(pixel, offset)?))).collect();
        let start = taps.first().map_or(low, |tap| tap.0);
        (start, taps.into_iter().map(|tap| tap.1).collect())
    }
}

/// Where the centre of a pixel lies in it.
pub(crate) const CENTRE: [f64; 2] = [0.5; 2];

/// A rectangle as the window shows it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Zoomed {
    /// The first column and row of the window.
    pub origin: [i32; 2],
    /// The column of the rectangle for each column of the window.
    pub columns: Vec<usize>,
    /// The row for each row.
    pub rows: Vec<usize>,
}

impl Zoomed {
    /// A rectangle of this size at the raster position, within an area of the window, as the points of its pixels show
    /// it that lie at `offset` in them; `None` where nothing of it is seen.
    pub fn new(context: &Context, size: [usize; 2], area: Rect, offset: [f64; 2]) -> Option<Self> {
        let position = &context.state.raster_position.window;
        let axis = |axis: usize| Axis {
            start: position[axis],
            zoom: context.state.pixel_zoom[axis].into(),
            count: size[axis],
        };
        let end = |start: i32, size: u32| start + size as i32;
        let (x, columns) = axis(0).taps(area.x, end(area.x, area.width), offset[0]);
        let (y, rows) = axis(1).taps(area.y, end(area.y, area.height), offset[1]);
        (!columns.is_empty() && !rows.is_empty()).then_some(Self { origin: [x, y], columns, rows })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_covers_what_its_zoomed_square_covers() {
        for (start, zoom, count) in [
            (3.0, 1.0, 5),
            (3.5, 1.0, 5),
            (3.25, 2.5, 3),
            (9.0, -1.0, 4),
            (9.0, -0.5, 8),
            (2.0, 0.5, 9),
        ] {
            let axis = Axis { start, zoom, count };
            let (first, taps) = axis.taps(0, 20, 0.5);
            for pixel in 0..20 {
                let centre = f64::from(pixel) + 0.5;
                let covers = |i: &usize| {
                    let (a, b) = (start + zoom * *i as f64, start + zoom * (*i + 1) as f64);
                    a.min(b) <= centre && centre < a.max(b)
                };
                let want = (0..count).find(covers);
                let got = usize::try_from(pixel - first).ok().and_then(|at| taps.get(at).copied());
                assert_eq!(got, want, "{axis:?} at {pixel}");
            }
        }
    }
}
