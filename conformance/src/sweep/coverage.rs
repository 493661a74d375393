//! Coverage: sizes, slivers, angles, subpixel edges with samples, large viewports, and corners with
//! infinite or NaN coordinates.

use super::definition::Sweep;
use super::drawn::{Canvas, clip_of, counted};
use super::series::{Compared, Series, octaves};
use crate::probe::{ProbeError, SIZE, Session};
use crate::rng::Rng;

const WHY: &str = "exact integers: a pixel is drawn once, or a rule is broken";

/// Triangles of all sizes.
pub const SIZE_OF_TRIANGLES: Sweep = Sweep {
    name: "triangle-size",
    what: "pixels inside of meshes of 8×8 cells that are not drawn once, and any drawn twice",
    parameter: "pixels across a cell",
    unit: "draws",
    bound: 0.0,
    why: WHY,
    breaks: "cells below 1/256 of a pixel, the step of corners, lose triangles that have no area \
             left; the mesh has no hole for that",
    kept: 0.0003,
    distinct: 0.9,
    before: &[],
    run: sizes,
};

/// Slivers.
pub const SLIVERS: Sweep = Sweep {
    name: "slivers",
    what: "pixels of a rectangle of 8191 × 3.6 pixels, with a sliver along its diagonal, that are \
           not drawn once",
    parameter: "length of the sliver over its width",
    unit: "draws",
    bound: 0.0,
    why: WHY,
    breaks: "a sliver that is thinner than 1/256 of a pixel, from 2^22 on, is a line and draws \
             nothing; its neighbours meet",
    kept: 0.5,
    distinct: 0.7,
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
    breaks: "nowhere: edge functions are integers; at multiples of 45° centres lie on edges, where the \
             upper left rule decides",
    kept: 0.3,
    distinct: 0.2,
    before: &[],
    run: angles,
};

/// Corners that are no numbers.
pub const NO_NUMBERS: Sweep = Sweep {
    name: "no-numbers",
    what: "pixels of a triangle one of whose corners has ±f32::MAX, ±inf or NaN as x, y, z or w, \
           against homogeneous edge functions, and pixels that a triangle after it lacks",
    parameter: "number of the case: value, then coordinate, then corner",
    unit: "draws",
    bound: 0.0,
    why: "a triangle with a corner that is not finite is dropped, others are not touched; of finite \
          corners every sign is that of exact arithmetic",
    breaks: "±inf and NaN: GL leaves the triangle undefined, here it draws nothing; ±f32::MAX draws \
             what the numbers say",
    kept: 0.8,
    distinct: 0.1,
    before: &[],
    run: no_numbers,
};

/// Shared edges between samples.
pub const SAMPLES: Sweep = Sweep {
    name: "msaa-shared-edges",
    what: "samples of four a pixel that two triangles about an edge draw not once, where the edge \
           passes this far from the samples of a column of pixels",
    parameter: "offset of the edge in pixels",
    unit: "draws",
    bound: 0.0,
    why: WHY,
    breaks: "offsets below 1/256 of a pixel are rounded away; the edge is the same for both \
             triangles, and each sample belongs to one",
    kept: 0.5,
    distinct: 0.2,
    before: &[],
    run: samples,
};

/// Corners of large viewports.
pub const VIEWPORT: Sweep = Sweep {
    name: "viewport-corners",
    what: "pixels of the last 4×4 of a target of this width that are not drawn once by two triangles over \
           all of it, and by a mesh about its corner",
    parameter: "width of the target",
    unit: "draws",
    bound: 0.0,
    why: WHY,
    breaks: "the largest viewport has 8,192 pixels; clip coordinates of f32 have 2^-24·4096 of a pixel \
             there, below the step of corners",
    kept: 0.9,
    distinct: 0.0,
    before: &[],
    run: viewport,
};

type Point = [f64; 2];

const PICTURE: Canvas = Canvas { size: [SIZE, SIZE], samples: 0 };

/// How often each pixel is drawn by triangles whose corners are in pixels.
fn overdraw(session: &Session, canvas: Canvas, corners: &[Point]) -> Result<Vec<f64>, ProbeError> {
    let clip: Vec<[f32; 4]> = corners.iter().map(|&p| clip_of(p, canvas.size)).collect();
    counted(session, canvas, &clip)
}

/// Compares pixels: those for whose centres `inside` holds are drawn once, none twice.
fn once(counts: &[f64], width: usize, inside: impl Fn(Point) -> bool) -> Compared {
    let mut compared = Compared::new();
    for (p, &count) in counts.iter().enumerate() {
        if inside([p % width, p / width].map(|c| c as f64 + 0.5)) {
            compared.add((count - 1.0).abs(), &[count, p as f64]);
        } else if count > 1.0 {
            compared.add(count - 1.0, &[count, p as f64]);
        } else {
            compared.leave_out();
        }
    }
    compared
}

fn sizes() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    let mut rng = Rng::named("triangle-size");
    let line = Series::measured("largest miscount", octaves(-9..=7, 1), |size| {
        // As many meshes as there is room for, each about the centre of a pixel.
        let (across, apart) = if size <= 1.0 { (8, 16) } else { (1, SIZE) };
        let mut corners = Vec::new();
        let mut boxes = Vec::new();
        for (i, j) in (0..across).flat_map(|j| (0..across).map(move |i| (i, j))) {
            let centre = [i, j].map(|n| (n * apart + apart / 2) as f64 + 0.5);
            let part = [0; 2].map(|_: i32| f64::from(rng.real(0.3, 0.7)));
            let origin = [0, 1].map(|c| centre[c] - part[c] * 8.0 * size);
            let at =
                |i: usize, j: usize| [origin[0] + i as f64 * size, origin[1] + j as f64 * size];
            for (i, j) in (0..8).flat_map(|j| (0..8).map(move |i| (i, j))) {
                let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
                corners.extend([a, b, c, c, d, a]);
            }
            boxes.push([at(0, 0), at(8, 8)]);
        }
        let counts = overdraw(&session, PICTURE, &corners)?;
        // Corners are rounded to 1/256 of a pixel, and before that to f32.
        let margin = 1.0 / 400.0;
        let mut compared = once(&counts, SIZE, |p| {
            boxes.iter().any(|[low, high]| {
                (0..2).all(|c| p[c] > low[c] + margin && p[c] < high[c] - margin)
            })
        });
        compared.add(0.0, &[counts.iter().sum(), corners[1][0]]);
        Ok(compared)
    })?;
    Ok(vec![line])
}

fn slivers() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    let canvas = Canvas { size: [8192, 4], samples: 0 };
    let line = Series::measured("largest miscount", octaves(8..=26, 1), |aspect| {
        let ([left, low], [right, high]) = ([0.3, 0.2], [8191.4, 3.8]);
        let (a, b, c, d) = ([left, low], [right, low], [right, high], [left, high]);
        // The sliver from the diagonal to a point on the upper edge, as far from the diagonal as it is wide.
        let width = (right - left) / aspect;
        let p = [(right - width * (right - left) / (high - low)).max(left), high];
        let counts = overdraw(&session, canvas, &[a, b, c, a, c, p, a, p, d])?;
        let sliver = overdraw(&session, canvas, &[a, c, p])?;
        let inside = |p: Point| {
            let margin = 0.01;
            p[0] > left + margin && p[0] < right - margin && p[1] > low && p[1] < high
        };
        let mut compared = once(&counts, canvas.size[0], inside);
        compared.add(0.0, &[sliver.iter().sum()]);
        Ok(compared)
    })?;
    Ok(vec![line])
}

fn angles() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    let middle = [SIZE as f64 / 2.0 + 0.25, SIZE as f64 / 2.0 + 0.5];
    let degrees = (1..=240).map(|step| f64::from(step) * 1.5);
    let line = Series::measured("largest miscount", degrees, |degrees| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let reach = 60.0;
        let at = |along: f64, beside: f64| {
            [
                middle[0] + reach * (along * cos - beside * sin),
                middle[1] + reach * (along * sin + beside * cos),
            ]
        };
        let (p, q, l, r) = (at(1.0, 0.0), at(-1.0, 0.0), at(0.0, 1.0), at(0.0, -1.0));
        let counts = overdraw(&session, PICTURE, &[p, l, q, q, r, p])?;
        // The square on its corner: |along| + |beside| < 1.
        Ok(once(&counts, SIZE, |c| {
            let (x, y) = ((c[0] - middle[0]) / reach, (c[1] - middle[1]) / reach);
            (x * cos + y * sin).abs() + (y * cos - x * sin).abs() < 0.999
        }))
    })?;
    Ok(vec![line])
}

/// Whether a point of normalized device coordinates belongs to a triangle: it is a sum of the corners
/// with weights that are not negative, and its depth is in range. `None` if it is near an edge.
fn belongs(corners: &[[f64; 4]; 3], p: Point) -> Option<bool> {
    let weights = |[x, y]: Point| {
        // Cramer's rule for Σ λ (x, y, w) = (x, y, 1).
        let row = |i: usize| [corners[i][0], corners[i][1], corners[i][3]];
        let det = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
            a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                + a[2] * (b[0] * c[1] - b[1] * c[0])
        };
        let whole = det(row(0), row(1), row(2));
        let p = [x, y, 1.0];
        [det(p, row(1), row(2)), det(row(0), p, row(2)), det(row(0), row(1), p)]
            .map(|part| part / whole)
    };
    let here = |p: Point| {
        let weights = weights(p);
        let sum = |c: usize| weights.iter().zip(corners).map(|(l, v)| l * v[c]).sum::<f64>();
        weights.iter().all(|&l| l >= 0.0) && sum(2).abs() <= sum(3)
    };
    let step = 2.0 / SIZE as f64 / 64.0;
    let about = [[-step, -step], [step, -step], [step, step], [-step, step]];
    let of = about.map(|[x, y]| here([p[0] + x, p[1] + y]));
    of.iter().all(|&inside| inside == of[0]).then_some(of[0])
}

fn no_numbers() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    let values = [f32::MAX, f32::MIN, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];
    let corner = |case: usize| [case % 3, case / 3 % 4, case / 12];
    let cases = (0..values.len() * 12).map(|case| case as f64);
    let good = [[-1.0, -1.0, 0.0, 1.0], [3.0, -1.0, 0.0, 1.0], [-1.0, 3.0, 0.0, 1.0f32]];
    let line = Series::measured("pixels drawn or lacking", cases, |case| {
        let [corner, coordinate, value] = corner(case as usize);
        let mut bad = [[-0.9, -0.8, 0.1, 1.0], [0.9, -0.9, -0.2, 1.5], [0.3, 0.8, 0.3, 2.0f32]];
        bad[corner][coordinate] = values[value];
        let counts = counted(&session, PICTURE, &bad)?;
        let after = counted(&session, PICTURE, &[bad, good].concat())?;
        let exact = bad.map(|v| v.map(f64::from));
        let finite = values[value].is_finite();
        let mut compared = Compared::new();
        for (p, (&count, &after)) in counts.iter().zip(&after).enumerate() {
            let centre = [p % SIZE, p / SIZE].map(|c| (2 * c + 1) as f64 / SIZE as f64 - 1.0);
            let expected = if finite { belongs(&exact, centre) } else { Some(false) };
            match expected {
                Some(inside) => {
                    let expected = if inside { 1.0 } else { 0.0 };
                    let error = (count - expected).abs().max((after - 1.0 - count).abs());
                    compared.add(error, &[count, after]);
                }
                None => compared.leave_out(),
            }
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}

fn samples() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    let canvas = Canvas { size: [32, 32], samples: 4 };
    let mut lines = Vec::new();
    for (name, lean) in [("upright", 0.0), ("leaning", 0.37)] {
        lines.push(Series::measured(name, octaves(-16..=0, 1), |offset| {
            let (low, high) = ([2.0, 2.0], [30.0, 30.0]);
            let middle = [16.375 + offset + lean, 16.375 + offset - lean];
            let (a, b, c, d) = (low, [high[0], low[1]], high, [low[0], high[1]]);
            let (p, q) = ([middle[0], low[1]], [middle[1], high[1]]);
            let corners = [a, p, q, q, d, a, p, b, c, c, q, p];
            let counts = overdraw(&session, canvas, &corners)?;
            let left = overdraw(&session, canvas, &corners[..6])?;
            let mut compared =
                once(&counts, canvas.size[0], |p| p.iter().all(|&c| c > 3.0 && c < 29.0));
            // What the left half draws: changes with the offset.
            compared.add(0.0, &[left.iter().sum()]);
            Ok(compared)
        })?);
    }
    Ok(lines)
}

fn viewport() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    let mut lines = Vec::new();
    for (name, wide) in [("width", true), ("height", false)] {
        lines.push(Series::measured(name, (1..=16).map(|n| f64::from(512 * n)), |side| {
            let side = side as usize;
            let size = if wide { [side, 4] } else { [4, side] };
            let canvas = Canvas { size, samples: 0 };
            let [w, h] = size.map(|c| c as f64);
            let whole = [[0.0, 0.0], [w, 0.0], [w, h], [w, h], [0.0, h], [0.0, 0.0]];
            let all = overdraw(&session, canvas, &whole)?;
            // Cells of a third of a pixel about the last corner.
            let mut corners = Vec::new();
            for (i, j) in (0..12).flat_map(|j| (0..12).map(move |i| (i, j))) {
                let at = |i: i32, j: i32| [w - f64::from(i) / 3.0, h - f64::from(j) / 3.0];
                let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
                corners.extend([a, b, c, c, d, a]);
            }
            let mesh = overdraw(&session, canvas, &corners)?;
            let mut compared = Compared::new();
            for (p, (&all, &mesh)) in all.iter().zip(&mesh).enumerate() {
                let [x, y] = [p % size[0], p / size[0]];
                let expected = if x + 4 >= size[0] && y + 4 >= size[1] { 1.0 } else { 0.0 };
                let error = (all - 1.0).abs().max((mesh - expected).abs());
                compared.add(error, &[all, mesh]);
            }
            Ok(compared)
        })?);
    }
    Ok(lines)
}
