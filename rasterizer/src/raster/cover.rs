//! What a shape covers of the blocks of a tile, whatever its kind and rim.

use super::area;
use super::coverage::{self, Edge};
use crate::driver::{LineStipple, Rim};
use crate::plan::DrawPlan;
use crate::primitive::{Kind, LineRun, SUBPIXEL, Shape, rectangle};
use crate::vertex::Geometry;
use texunit::lanes::{F32s, Isa, LANES, lane_x, lane_y};

/// The outline of a shape.
#[derive(Clone, Copy, Debug)]
pub enum Cover {
    /// A triangle, by its edges relative to the tile.
    Triangle([Edge; 3]),
    /// An aliased line, so many rows high.
    Run(LineRun, i32),
    /// All of the shape's bounds.
    Box,
    /// A triangle with a smooth rim.
    SmoothTriangle([[f64; 2]; 3]),
    /// A smooth line between two ends, so wide.
    Band([[f64; 2]; 2], f64),
    /// A smooth point: centre and radius.
    Disc([f64; 2], f64),
    /// What of a smooth line holds a sample.
    BandSample([[f64; 2]; 2], f64),
    /// What of a smooth point does.
    DiscSample([f64; 2], f64),
}

/// What of a line is left, and how far it has come before this one, in subpixels.
type Dashes = Option<(LineStipple, u32)>;

/// Whether the stipple leaves what is `at` subpixels from a line's start.
fn is_dash(dashes: Dashes, at: u32) -> bool {
    dashes.is_none_or(|(stipple, before)| {
        let fragment = before.wrapping_add(at) / SUBPIXEL as u32;
        stipple.pattern >> (fragment / u32::from(stipple.factor) % 16) & 1 == 1
    })
}

impl Cover {
    /// The outline of `shape` for the tile whose first pixel is `tile`, seen from a sample that lies
    /// `place` subpixels from each pixel's centre.
    #[inline]
    pub fn new(
        plan: &DrawPlan,
        geometry: &Geometry,
        shape: &Shape,
        tile: [i32; 2],
        place: [i32; 2],
    ) -> Self {
        if plan.samples.is_each() {
            return Self::of_sample(plan, geometry, shape, tile, place);
        }
        let raster = &plan.raster;
        let corners = || shape.corners.map(|c| c.map(|v| f64::from(v) / f64::from(SUBPIXEL)));
        match shape.kind {
            Kind::Triangle => match raster.polygon.rim {
                Rim::Aliased => Self::Triangle(coverage::edges(&shape.corners, tile[0], tile[1])),
                Rim::Smooth => Self::SmoothTriangle(corners()),
            },
            Kind::Line { .. } => {
                let width = raster.line.drawn_width();
                match raster.line.rim {
                    Rim::Aliased => {
                        let [a, b, _] = shape.corners;
                        Self::Run(LineRun::new(a, b, width as i32), width as i32)
                    }
                    Rim::Smooth => {
                        let [a, b, _] = corners();
                        Self::Band([a, b], width.into())
                    }
                }
            }
            Kind::Point { size, .. } => match (raster.point.rim, &raster.point.sprite) {
                (Rim::Smooth, None) => {
                    let window = geometry.window(&plan.viewport, shape.vertices[0]);
                    Self::Disc(window, f64::from(size) * 0.5)
                }
                (Rim::Aliased, _) | (Rim::Smooth, Some(_)) => Self::Box,
            },
        }
    }

    /// The outline moved so that pixels' centres meet it where a sample meets `shape`.
    fn of_sample(
        plan: &DrawPlan,
        geometry: &Geometry,
        shape: &Shape,
        tile: [i32; 2],
        place: [i32; 2],
    ) -> Self {
        let moved = |c: [i32; 2]| [c[0] - place[0], c[1] - place[1]];
        let corners = shape.corners.map(moved);
        match shape.kind {
            Kind::Triangle => Self::Triangle(coverage::edges(&corners, tile[0], tile[1])),
            Kind::Line { .. } => {
                let [a, b, _] = corners.map(|c| c.map(|v| f64::from(v) / f64::from(SUBPIXEL)));
                Self::BandSample([a, b], plan.raster.line.drawn_width().into())
            }
            Kind::Point { .. } if plan.raster.point.sprite.is_some() => Self::Box,
            Kind::Point { size, .. } => {
                let window = geometry.window(&plan.viewport, shape.vertices[0]);
                let by = place.map(|v| f64::from(v) / f64::from(SUBPIXEL));
                let center = [window[0] - by[0], window[1] - by[1]];
                Self::DiscSample(center, f64::from(size) * 0.5)
            }
        }
    }

    /// The lanes that are covered of block column `bx`, row `by` of the tile; `parts` takes how much
    /// of each, where the rim is smooth.
    #[inline]
    pub fn block(
        &self,
        isa: Isa,
        plan: &DrawPlan,
        shape: &Shape,
        tile: [i32; 2],
        [bx, by]: [i32; 2],
        parts: &mut F32s,
    ) -> u64 {
        let first = [tile[0] + 8 * bx, tile[1] + 8 * by];
        let dashes = match shape.kind {
            Kind::Line { stipple, .. } => plan.raster.line.stipple.map(|state| (state, stipple)),
            Kind::Triangle | Kind::Point { .. } => None,
        };
        match self {
            Self::Triangle(edges) => coverage::block(isa, edges, bx, by).lanes(),
            Self::Run(run, width) => run_lanes(run, *width, dashes, first),
            Self::Box => !0,
            Self::SmoothTriangle(corners) => {
                smooth(shape, first, parts, |pixel| area::polygon(corners, pixel))
            }
            Self::Band(ends, width) => {
                smooth(shape, first, parts, |pixel| band(*ends, *width, dashes, pixel))
            }
            Self::Disc(center, radius) => {
                smooth(shape, first, parts, |pixel| area::disc(*center, *radius, pixel))
            }
            Self::BandSample(ends, width) => {
                centers(first, |center| on_band(*ends, *width, dashes, center))
            }
            Self::DiscSample(middle, radius) => centers(first, |center| {
                let (x, y) = (center[0] - middle[0], center[1] - middle[1]);
                x * x + y * y <= radius * radius
            }),
        }
    }
}

/// The lanes of the block from pixel `first` on that a run of columns covers.
fn run_lanes(run: &LineRun, width: i32, dashes: Dashes, first: [i32; 2]) -> u64 {
    let (major, minor) = (run.major, 1 - run.major);
    let low = run.first.max(first[major]);
    let high = run.last.min(first[major] + 7);
    let mut lanes = 0;
    for column in low..=high {
        if !is_dash(dashes, run.index(column) * SUBPIXEL as u32) {
            continue;
        }
        let row = run.row(column);
        for row in row.max(first[minor])..(row + width).min(first[minor] + 8) {
            let mut at = [0; 2];
            (at[major], at[minor]) = (column - first[major], row - first[minor]);
            lanes |= 1 << coverage::lane_at(at[0] as usize, at[1] as usize);
        }
    }
    lanes
}

/// The lanes of which any part is covered.
fn smooth(shape: &Shape, first: [i32; 2], parts: &mut F32s, area: impl Fn([f64; 2]) -> f64) -> u64 {
    let mut lanes = 0;
    for lane in 0..LANES {
        let pixel = [first[0] + lane_x(lane) as i32, first[1] + lane_y(lane) as i32];
        let inside = |axis: usize| {
            pixel[axis] >= i32::from(shape.bounds[0][axis])
                && pixel[axis] <= i32::from(shape.bounds[1][axis])
        };
        parts[lane] = 0.0;
        if inside(0) && inside(1) {
            parts[lane] = area(pixel.map(f64::from)) as f32;
            lanes |= u64::from(parts[lane] > 0.0) << lane;
        }
    }
    lanes
}

/// The lanes of the block from pixel `first` on whose centres are inside.
fn centers(first: [i32; 2], inside: impl Fn([f64; 2]) -> bool) -> u64 {
    (0..LANES).fold(0, |lanes, lane| {
        let pixel = [first[0] + lane_x(lane) as i32, first[1] + lane_y(lane) as i32];
        lanes | u64::from(inside(pixel.map(|v| f64::from(v) + 0.5))) << lane
    })
}

/// Whether a line of this width, where its stipple leaves it, holds a point. Of its sides those of
/// its start and on its right do not belong to the next.
fn on_band(ends: [[f64; 2]; 2], width: f64, dashes: Dashes, point: [f64; 2]) -> bool {
    let [a, b] = ends;
    let way = [b[0] - a[0], b[1] - a[1]];
    let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
    let p = [point[0] - a[0], point[1] - a[1]];
    let along = (p[0] * way[0] + p[1] * way[1]) / length;
    let across = (way[0] * p[1] - way[1] * p[0]) / length;
    (0.0..length).contains(&along)
        && (-0.5 * width..0.5 * width).contains(&across)
        && is_dash(dashes, (along * f64::from(SUBPIXEL)) as u32)
}

/// How much of a pixel a smooth line covers: with a stipple, of the pieces one pixel long that are
/// left of it (GL 2.1, section 3.4.2).
fn band(ends: [[f64; 2]; 2], width: f64, dashes: Dashes, pixel: [f64; 2]) -> f64 {
    let [a, b] = ends;
    let way = [b[0] - a[0], b[1] - a[1]];
    let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
    if dashes.is_none() {
        return area::polygon(&rectangle(ends, width, [0.0, length]), pixel);
    }
    // How far along the line the corners of the pixel lie.
    let along = |x: f64, y: f64| ((x - a[0]) * way[0] + (y - a[1]) * way[1]) / length;
    let (x, y) = (pixel[0], pixel[1]);
    let at = [along(x, y), along(x + 1.0, y), along(x, y + 1.0), along(x + 1.0, y + 1.0)];
    let low = at.into_iter().fold(length, f64::min).max(0.0).floor() as u32;
    let high = at.into_iter().fold(0.0, f64::max).min(length).ceil() as u32;
    let pieces = (low..high).filter(|piece| is_dash(dashes, piece * SUBPIXEL as u32));
    pieces
        .map(|piece| {
            let part = [f64::from(piece), f64::from(piece) + 1.0];
            area::polygon(&rectangle(ends, width, part), pixel)
        })
        .sum()
}
