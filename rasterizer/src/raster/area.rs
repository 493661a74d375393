//! How much of a pixel a smooth primitive covers: exact areas in `f64` (GL 2.1, sections 3.3.1,
//! 3.4.2 and 3.5.1).

use std::f64::consts::PI;

type Point = [f64; 2];

fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// The area that a convex polygon of three or four corners, counter-clockwise, shares with the pixel
/// whose lower left corner is `pixel`.
pub fn polygon(corners: &[Point], pixel: Point) -> f64 {
    let corners = corners.iter().map(|c| [c[0] - pixel[0], c[1] - pixel[1]]);
    // A cut by four lines adds four corners at most.
    let mut from = Corners::default();
    corners.for_each(|corner| from.push(corner));
    for (axis, side) in [(0, 0.0), (0, 1.0), (1, 0.0), (1, 1.0)] {
        let inside = |p: &Point| if side == 0.0 { p[axis] } else { 1.0 - p[axis] };
        let mut to = Corners::default();
        for i in 0..from.len {
            let (a, b) = (from.at[i], from.at[(i + 1) % from.len]);
            let (da, db) = (inside(&a), inside(&b));
            if da >= 0.0 {
                to.push(a);
            }
            if (da >= 0.0) != (db >= 0.0) {
                let t = da / (da - db);
                let mut cut = [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
                cut[axis] = side;
                to.push(cut);
            }
        }
        from = to;
    }
    let doubled: f64 = (0..from.len).map(|i| cross(from.at[i], from.at[(i + 1) % from.len])).sum();
    (doubled * 0.5).clamp(0.0, 1.0)
}

/// A polygon of few corners.
#[derive(Clone, Copy, Default)]
struct Corners {
    at: [Point; 8],
    len: usize,
}

impl Corners {
    /// Adds a corner. A convex polygon has no more than fit; rounding could only repeat one.
    fn push(&mut self, corner: Point) {
        if let Some(place) = self.at.get_mut(self.len) {
            *place = corner;
            self.len += 1;
        }
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
        fn a_disc_covers_what_strips_say(cx in -3.0..4.0f64, cy in -3.0..4.0f64, r in 0.5..4.0f64) {
            let want = strips(|x| {
                let square = r * r - (x - cx) * (x - cx);
                if square <= 0.0 { return 0.0 }
                ((cy + square.sqrt()).min(1.0) - (cy - square.sqrt()).max(0.0)).max(0.0)
            });
            prop_assert!((disc([cx, cy], r, [0.0, 0.0]) - want).abs() < 1e-5);
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
            prop_assert!((polygon(&c, [0.0, 0.0]) - want).abs() < 2e-4);
        }
    }
}
