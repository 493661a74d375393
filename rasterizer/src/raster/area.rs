//! How much of a pixel a smooth primitive covers: exact areas in `f64` (GL 2.1, sections 3.3.1,
//! 3.4.2 and 3.5.1).

use std::f64::consts::PI;
use texunit::lanes::{Isa, Kernel, LANES, Simd, lane_x, lane_y};

type Point = [f64; 2];
/// A number of each pixel of a block.
pub type Areas = [f64; LANES];

/// A smaller part of a pixel is rounding error, and counts as not covered.
pub const MIN_AREA: f64 = 1.0 / (1u64 << 32) as f64;

fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// How a convex outline and a square overlap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overlap {
    /// They are apart.
    None,
    /// They may share a part.
    Part,
    /// The square is inside.
    All,
}

/// How a convex polygon, counter-clockwise, and the square of `side` from `at` on overlap. Only the sides of the
/// polygon are tested, so a square beyond a corner may be reported as `Part`.
pub fn overlap(corners: &[Point], at: Point, side: f64) -> Overlap {
    let mut overlap = Overlap::All;
    for (i, &a) in corners.iter().enumerate() {
        let b = corners[(i + 1) % corners.len()];
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        // The corners of the square that are farthest outside and farthest inside of this side.
        let corner = cross([dx, dy], [at[0] - a[0], at[1] - a[1]]);
        let out = corner + side * ((-dy).min(0.0) + dx.min(0.0));
        let inward = corner + side * ((-dy).max(0.0) + dx.max(0.0));
        // Larger than the rounding error by orders of magnitude: a millionth of a pixel.
        let margin = (dx.abs() + dy.abs()) * 1e-6;
        if inward < -margin {
            return Overlap::None;
        }
        if out <= margin || out.is_nan() {
            overlap = Overlap::Part;
        }
    }
    overlap
}

/// Adds the area that a convex polygon, counter-clockwise, shares with each pixel of the block whose lower left
/// corner is `first`.
pub fn add_polygon_areas(isa: Isa, corners: &[Point], first: Point, areas: &mut Areas) {
    isa.run(Polygon { corners, first, areas });
}

/// The area of a polygon below the line y = 1 and above y = 0 is `-∮ clamp(y, 0, 1) dx` (Green's theorem); between
/// x = 0 and x = 1, of what its sides have there.
struct Polygon<'a> {
    corners: &'a [Point],
    first: Point,
    areas: &'a mut Areas,
}

impl Kernel for Polygon<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { corners, first, areas } = self;
        for (i, &a) in corners.iter().enumerate() {
            let b = corners[(i + 1) % corners.len()];
            let slope = if a[0] == b[0] { 0.0 } else { (b[1] - a[1]) / (b[0] - a[0]) };
            for (lane, area) in areas.iter_mut().enumerate() {
                let left = first[0] + lane_x(lane) as f64;
                let low = first[1] + lane_y(lane) as f64;
                let (from, to) = (a[0] - left, b[0] - left);
                let (x0, x1) = (unit(from), unit(to));
                let (y0, y1) = (a[1] - low + (x0 - from) * slope, a[1] - low + (x1 - from) * slope);
                // The mean of clamp(y, 0, 1) between the two: its trapezoid within, 1 above.
                let (below, above) = if y0 < y1 { (y0, y1) } else { (y1, y0) };
                let (c0, c1) = (unit(below), unit(above));
                let over = at_least_1(above) - at_least_1(below);
                let mean = ((c1 - c0) * (c1 + c0) * 0.5 + over) / (above - below);
                let mean = if below < above { mean } else { c0 };
                *area += (x0 - x1) * mean;
            }
        }
    }
}

/// Held in 0 to 1.
#[inline(always)]
fn unit(v: f64) -> f64 {
    let v = if v > 0.0 { v } else { 0.0 };
    if v < 1.0 { v } else { 1.0 }
}

#[inline(always)]
fn at_least_1(v: f64) -> f64 {
    if v > 1.0 { v } else { 1.0 }
}

/// How a disc and the square of `side` from `at` on overlap.
pub fn disc_overlap(center: Point, radius: f64, at: Point, side: f64) -> Overlap {
    // From the centre to the nearest and to the farthest point of the square, along each axis.
    let [(near_x, far_x), (near_y, far_y)] = [0, 1].map(|axis| {
        let (low, high) = (at[axis] - center[axis], at[axis] + side - center[axis]);
        (low.max(-high).max(0.0), high.max(-low))
    });
    let (near, far) = (near_x * near_x + near_y * near_y, far_x * far_x + far_y * far_y);
    // Larger than the rounding error by orders of magnitude: a millionth of a pixel.
    let [less, more] = [radius - 1e-6, radius + 1e-6];
    if near > more * more {
        Overlap::None
    } else if less > 0.0 && far < less * less {
        Overlap::All
    } else {
        Overlap::Part
    }
}

/// The area that a disc shares with the pixel whose lower left corner is `pixel`.
///
/// Its outline runs along the sides of the pixel where they lie in the disc, and along the circle
/// between where one leaves the disc and the next enters it.
pub fn disc(center: Point, radius: f64, pixel: Point) -> f64 {
    let low = [pixel[0] - center[0], pixel[1] - center[1]];
    let high = [low[0] + 1.0, low[1] + 1.0];
    let corners = [low, [high[0], low[1]], high, [low[0], high[1]]];
    let mut doubled = 0.0;
    let mut segments = 0.0;
    let (mut first, mut exit): (Option<Point>, Option<Point>) = (None, None);
    let mut arc = |from: Point, to: Point| {
        if from != to {
            doubled += cross(from, to);
            segments += segment(from, to, radius);
        }
    };
    let mut sides = 0.0;
    for i in 0..4 {
        let (a, b) = (corners[i], corners[(i + 1) % 4]);
        let Some((enter, leave)) = chord(a, b, radius) else { continue };
        sides += cross(enter, leave);
        match exit {
            Some(from) => arc(from, enter),
            None => first = Some(enter),
        }
        exit = Some(leave);
    }
    let (Some(first), Some(exit)) = (first, exit) else {
        // The circle crosses no side: all of it lies inside the pixel, or none.
        let holds = low[0] < 0.0 && low[1] < 0.0 && high[0] > 0.0 && high[1] > 0.0;
        return if holds { PI * radius * radius } else { 0.0 };
    };
    arc(exit, first);
    ((doubled + sides) * 0.5 + segments).clamp(0.0, 1.0)
}

/// The part of the side from `a` to `b` (along one axis) that lies in a disc around the origin.
fn chord(a: Point, b: Point, radius: f64) -> Option<(Point, Point)> {
    let axis = usize::from(a[0] == b[0]);
    let across = a[1 - axis];
    let square = radius * radius - across * across;
    if square <= 0.0 {
        return None;
    }
    let half = square.sqrt();
    let point = |along: f64| if axis == 0 { [along, across] } else { [across, along] };
    let (low, high) = (a[axis].min(b[axis]).max(-half), a[axis].max(b[axis]).min(half));
    if low >= high {
        return None;
    }
    Some(if a[axis] < b[axis] { (point(low), point(high)) } else { (point(high), point(low)) })
}

/// The area between the circle, counter-clockwise from `from` to `to`, and the straight line.
fn segment(from: Point, to: Point, radius: f64) -> f64 {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let minor = minor_segment((dx * dx + dy * dy).sqrt(), radius);
    // The centre, which is the origin, lies to the left of the line where less than half the circle
    // does to the right.
    if cross(from, to) >= 0.0 { minor } else { PI * radius * radius - minor }
}

/// The smaller area that a chord cuts off: the triangle up to the middle of its arc, and what the
/// two halves cut off; a series once the arc is flat.
fn minor_segment(chord: f64, radius: f64) -> f64 {
    let half = (chord * 0.5).min(radius);
    let s = half / radius;
    if s < 0.125 {
        // r² (asin s - s √(1 - s²)); what is left out is below 1e-12 of it.
        let s2 = s * s;
        let series = [63.0 / 1664.0, 35.0 / 704.0, 5.0 / 72.0, 3.0 / 28.0, 0.2, 2.0 / 3.0];
        return radius * radius * s * s2 * series.iter().fold(0.0, |sum, c| sum * s2 + c);
    }
    let height = radius - (radius * radius - half * half).max(0.0).sqrt();
    half * height + 2.0 * minor_segment((half * half + height * height).sqrt(), radius)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_pixels_of_a_disc_sum_to_its_area() {
        for (center, radius) in [
            ([8.3, 7.9], 0.5),
            ([8.5, 8.5], 0.5),
            ([8.0, 8.0], 0.5),
            ([8.5, 8.5], 0.6),
            ([8.2, 8.9], 0.7),
            ([8.0, 8.0], 3.0),
            ([8.21, 8.77], 5.43),
            ([8.5, 8.0], 7.5),
        ] {
            let sum: f64 = (0..16)
                .flat_map(|y| (0..16).map(move |x| [f64::from(x), f64::from(y)]))
                .map(|pixel| disc(center, radius, pixel))
                .sum();
            let want = PI * radius * radius;
            assert!((sum - want).abs() < 1e-11 * want, "{center:?} {radius}: {sum} {want}");
        }
    }

    /// The area by strips: exact in y, the trapezoid rule in x.
    fn strips(height: impl Fn(f64) -> f64) -> f64 {
        let n = 20_000;
        (0..n).map(|i| height((f64::from(i) + 0.5) / f64::from(n))).sum::<f64>() / f64::from(n)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(60))]
        #[test]
        fn what_is_told_of_a_disc_is_so(
            center in prop::array::uniform2(-9.0..9.0f64), r in 0.5..20.0f64, side in 1.0..8.0f64,
        ) {
            let (side, at) = (side.floor(), [0.0, 0.0]);
            let pixels = (0..(side * side) as u32)
                .map(|i| [f64::from(i) % side, (f64::from(i) / side).floor()]);
            let mut parts = pixels.map(|pixel| disc(center, r, pixel));
            match disc_overlap(center, r, at, side) {
                Overlap::None => prop_assert!(parts.all(|part| part < MIN_AREA)),
                Overlap::All => prop_assert!(parts.all(|part| part as f32 == 1.0)),
                Overlap::Part => {}
            }
        }

        #[test]
        fn a_disc_covers_what_strips_say(cx in -3.0..4.0f64, cy in -3.0..4.0f64, r in 0.5..4.0f64) {
            let want = strips(|x| {
                let square = r * r - (x - cx) * (x - cx);
                if square <= 0.0 { return 0.0 }
                ((cy + square.sqrt()).min(1.0) - (cy - square.sqrt()).max(0.0)).max(0.0)
            });
            prop_assert!((disc([cx, cy], r, [0.0, 0.0]) - want).abs() < 1e-5);
        }

        /// Whatever its size and place: the sum over all pixels is the polygon's own area, and squares that
        /// are apart or inside are reported as such.
        #[test]
        fn the_pixels_of_a_rectangle_sum_to_its_area(
            (x, y) in (0.0..40.0f64, 0.0..40.0f64),
            (length, width, angle) in (0.01..24.0f64, 0.01..9.0f64, 0.0..7.0f64),
        ) {
            let (s, c) = angle.sin_cos();
            let corners = [[0.0, 0.0], [length, 0.0], [length, width], [0.0, width]]
                .map(|[u, v]| [x + u * c - v * s, y + u * s + v * c]);
            for isa in Isa::available() {
                let mut sum = 0.0;
                for block in 0..12 * 12 {
                    let first = [block % 12, block / 12].map(|at| f64::from(at) * 8.0 - 32.0);
                    let mut areas = [0.0; LANES];
                    add_polygon_areas(isa, &corners, first, &mut areas);
                    prop_assert!(areas.iter().all(|area| (-1e-12..1.0 + 1e-12).contains(area)));
                    match overlap(&corners, first, 8.0) {
                        Overlap::None => prop_assert!(areas.iter().all(|&area| area < MIN_AREA)),
                        Overlap::All => prop_assert!(areas.iter().all(|&area| area as f32 == 1.0)),
                        Overlap::Part => {}
                    }
                    sum += areas.iter().sum::<f64>();
                }
                prop_assert!((sum - length * width).abs() < 1e-9, "{sum} of {}", length * width);
            }
        }

        #[test]
        fn a_triangle_covers_what_strips_say(raw in prop::array::uniform6(-3.0..4.0f64)) {
            let mut c = [[raw[0], raw[1]], [raw[2], raw[3]], [raw[4], raw[5]]];
            let side = |a: Point, b: Point, p: Point| {
                cross([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]])
            };
            if side(c[0], c[1], c[2]) < 0.0 {
                c.swap(1, 2);
            }
            let want = strips(|x| {
                let (mut low, mut high) = (0.0_f64, 1.0_f64);
                for i in 0..3 {
                    // side(a, b, (x, y)) = k y + m >= 0
                    let (a, b) = (c[i], c[(i + 1) % 3]);
                    let m = side(a, b, [x, 0.0]);
                    let k = side(a, b, [x, 1.0]) - m;
                    if k > 0.0 {
                        low = low.max(-m / k);
                    } else if k < 0.0 {
                        high = high.min(-m / k);
                    } else if m < 0.0 {
                        return 0.0;
                    }
                }
                (high - low).max(0.0)
            });
            for isa in Isa::available() {
                let mut areas = [0.0; LANES];
                add_polygon_areas(isa, &c, [0.0, 0.0], &mut areas);
                prop_assert!((areas[0] - want).abs() < 2e-4);
            }
        }
    }
}
