//! Coverage: sizes, slivers, angles, and corners with infinite or NaN coordinates.

use super::definition::{Sweep, decades};
use crate::plot::Line;
use crate::probe::{ProbeError, SIZE, Session};
use crate::rng::Rng;

const WHY: &str = "exact integers: a pixel is drawn once, or a rule is broken";

/// Triangles of all sizes.
pub const SIZE_OF_TRIANGLES: Sweep = Sweep {
    name: "triangle-size",
    what: "pixels of a mesh of 8×8 cells that are drawn twice, or left out inside of it",
    parameter: "pixels across a cell",
    unit: "draws",
    bound: 0.0,
    why: WHY,
    before: &[],
    run: sizes,
};

/// Slivers.
pub const SLIVERS: Sweep = Sweep {
    name: "slivers",
    what: "pixels of a square with a sliver along its diagonal that are not drawn once",
    parameter: "length of the sliver over its width",
    unit: "draws",
    bound: 0.0,
    why: WHY,
    before: &[],
    run: slivers,
};

/// Edges at every angle.
pub const ANGLES: Sweep = Sweep {
    name: "edge-angles",
    what: "pixels about an edge that two triangles share, at every angle, not drawn once",
    parameter: "degrees",
    unit: "draws",
    bound: 0.0,
    why: WHY,
    before: &[],
    run: angles,
};

/// Corners that are no numbers.
pub const NO_NUMBERS: Sweep = Sweep {
    name: "no-numbers",
    what: "pixels that a triangle with a corner at NaN, ±inf or ±f32::MAX draws, and pixels that \
           a triangle after it lacks; the former is defined to draw nothing unless it is finite",
    parameter: "number of the bad corner",
    unit: "draws",
    bound: 0.0,
    why: "a triangle with a corner that is not finite is dropped, others are not touched",
    before: &[],
    run: no_numbers,
};

type Point = [f64; 2];

/// How often each pixel is drawn by triangles whose corners are in pixels.
fn overdraw(session: &Session, corners: &[Point]) -> Result<Vec<f64>, ProbeError> {
    let ndc: Vec<[f32; 2]> =
        corners.iter().map(|p| p.map(|c| (2.0 * c / SIZE as f64 - 1.0) as f32)).collect();
    Ok(session.overdraw(&ndc)?.into_iter().map(|p| p[0]).collect())
}

/// The pixels for whose centres `inside` holds that are not drawn once, and those drawn twice: the
/// largest difference.
fn not_once(counts: &[f64], inside: impl Fn(Point) -> bool) -> f64 {
    let centre = |p: usize| [p % SIZE, p / SIZE].map(|c| c as f64 + 0.5);
    let error = |(p, &count): (usize, &f64)| {
        if inside(centre(p)) { (count - 1.0).abs() } else { (count - 1.0).max(0.0) }
    };
    counts.iter().enumerate().map(error).fold(0.0, f64::max)
}

fn sizes() -> Result<Vec<Line>, ProbeError> {
    let session = Session::open()?;
    let mut rng = Rng::named("triangle-size");
    let line = decades("largest miscount", -6..=6, |size| {
        let origin = [0; 2].map(|_: i32| f64::from(rng.real(20.0, 40.0)));
        let at = |i: usize, j: usize| [origin[0] + i as f64 * size, origin[1] + j as f64 * size];
        let mut corners = Vec::new();
        for (i, j) in (0..8).flat_map(|j| (0..8).map(move |i| (i, j))) {
            let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            corners.extend([a, b, c, c, d, a]);
        }
        let counts = overdraw(&session, &corners)?;
        let [low, high] = [at(0, 0), at(8, 8)];
        // Corners are rounded to f32, and snapped to 1/256 of a pixel.
        let margin = 1.0 / 128.0 + size * 1e-6;
        Ok(not_once(&counts, |p| (0..2).all(|c| p[c] > low[c] + margin && p[c] < high[c] - margin)))
    })?;
    Ok(vec![line])
}

fn slivers() -> Result<Vec<Line>, ProbeError> {
    let session = Session::open()?;
    let line = decades("largest miscount", 0..=9, |aspect| {
        let (low, high) = (5.3, 120.6);
        let (a, b, c, d) = ([low, low], [high, low], [high, high], [low, high]);
        let width = (high - low) / aspect;
        let p = [(high - width).max(low), high];
        let corners = [a, b, c, a, c, p, a, p, d];
        let counts = overdraw(&session, &corners)?;
        let inside = |p: Point| p.iter().all(|&c| c > low + 0.01 && c < high - 0.01);
        Ok(not_once(&counts, inside))
    })?;
    Ok(vec![line])
}

fn angles() -> Result<Vec<Line>, ProbeError> {
    let session = Session::open()?;
    let middle = [SIZE as f64 / 2.0 + 0.25, SIZE as f64 / 2.0 + 0.5];
    let mut points = Vec::new();
    for step in 1..=240 {
        let degrees = f64::from(step) * 1.5;
        let (sin, cos) = degrees.to_radians().sin_cos();
        let reach = 60.0;
        let at = |along: f64, beside: f64| {
            [
                middle[0] + reach * (along * cos - beside * sin),
                middle[1] + reach * (along * sin + beside * cos),
            ]
        };
        let (p, q, l, r) = (at(1.0, 0.0), at(-1.0, 0.0), at(0.0, 1.0), at(0.0, -1.0));
        let counts = overdraw(&session, &[p, l, q, q, r, p])?;
        // The square on its corner: |along| + |beside| < 1.
        let inside = |c: Point| {
            let (x, y) = ((c[0] - middle[0]) / reach, (c[1] - middle[1]) / reach);
            (x * cos + y * sin).abs() + (y * cos - x * sin).abs() < 0.999
        };
        points.push((degrees, not_once(&counts, inside)));
    }
    Ok(vec![Line { name: "largest miscount".to_owned(), points }])
}

fn no_numbers() -> Result<Vec<Line>, ProbeError> {
    let session = Session::open()?;
    let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    let mut points = Vec::new();
    for (number, (value, axis)) in (1..).zip(bad.iter().flat_map(|&v| [(v, 0), (v, 1)])) {
        let mut corner = [0.5f32, 0.5];
        corner[axis] = value;
        let nothing = session.overdraw(&[[-0.9, -0.9], [0.9, -0.9], corner])?;
        let drawn = nothing.iter().map(|p| p[0]).fold(0.0, f64::max);
        let good: [[f32; 2]; 3] = [[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]];
        let both = [[-0.9, -0.9], [0.9, -0.9], corner, good[0], good[1], good[2]];
        let after = session.overdraw(&both)?;
        let missing = after.iter().map(|p| (p[0] - 1.0).abs()).fold(0.0, f64::max);
        points.push((f64::from(number), drawn.max(missing)));
    }
    Ok(vec![Line { name: "pixels drawn or lacking".to_owned(), points }])
}
