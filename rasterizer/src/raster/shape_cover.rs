//! The coverage of the blocks of a tile by a shape of any kind, aliased or smooth.

use super::area::{self, Areas, MIN_AREA, Overlap};
use super::block::BlockAt;
use super::edge_functions::{self, Edge};
use super::line_rectangle::{Dashes, LineRectangle, is_dash};
use crate::desc::Antialiasing;
use crate::kernels::PixelKernel;
use crate::plan::DrawPlan;
use crate::primitive::{LineFragments, Shape, ShapeKind};
use crate::sizes::{SUBPIXEL, TILE};
use crate::vertex::Geometry;
use texunit::lanes::{F32s, Isa, LANES, lane_x, lane_y};

/// The outline of a shape.
#[derive(Clone, Copy, Debug)]
pub enum Cover {
    /// A triangle, by its edges relative to the tile.
    Triangle([Edge; 3]),
    /// An aliased line, and its width in rows.
    AliasedLine(LineFragments, i32),
    /// All of the shape's bounds.
    Box,
    /// A triangle with a smooth edge.
    SmoothTriangle([[f64; 2]; 3]),
    /// A smooth line.
    LineRectangle(LineRectangle),
    /// A smooth point: centre and radius.
    Disc([f64; 2], f64),
    /// The samples within a line.
    LineSample(LineRectangle),
    /// The samples within a point.
    DiscSample([f64; 2], f64),
}

impl Cover {
    /// The outline of `shape` for the tile whose first pixel is `tile`, seen from a sample that lies
    /// `position` subpixels from each pixel's centre.
    #[inline]
    pub fn new(
        plan: &DrawPlan,
        geometry: &Geometry,
        shape: &Shape,
        tile: [i32; 2],
        position: [i32; 2],
    ) -> Self {
        let cover = match plan.samples.is_each() {
            true => Self::of_sample(plan, geometry, shape, tile, position),
            false => Self::of_centre(plan, geometry, shape, tile),
        };
        match &cover {
            Self::Triangle(_) => PixelKernel::EdgeTriangle.note(),
            Self::AliasedLine(..) => PixelKernel::AliasedLine.note(),
            Self::Box => PixelKernel::Box.note(),
            Self::SmoothTriangle(_) => PixelKernel::SmoothTriangle.note(),
            Self::LineRectangle(_) => PixelKernel::SmoothLine.note(),
            Self::Disc(..) => PixelKernel::Disc.note(),
            Self::LineSample(_) => PixelKernel::SampledLine.note(),
            Self::DiscSample(..) => PixelKernel::SampledDisc.note(),
        }
        cover
    }

    /// The outline seen from the pixels' centres.
    fn of_centre(plan: &DrawPlan, geometry: &Geometry, shape: &Shape, tile: [i32; 2]) -> Self {
        let raster = &plan.raster;
        let corners = || shape.corners.map(|c| c.map(|v| f64::from(v) / f64::from(SUBPIXEL)));
        match shape.kind {
            ShapeKind::Triangle => match raster.polygon.antialiasing {
                Antialiasing::Aliased => {
                    Self::Triangle(edge_functions::edges(&shape.corners, tile[0], tile[1]))
                }
                Antialiasing::Smooth => Self::SmoothTriangle(corners()),
            },
            ShapeKind::Line { .. } => {
                let width = raster.line.drawn_width();
                match raster.line.antialiasing {
                    Antialiasing::Aliased => {
                        let [a, b, _] = shape.corners;
                        Self::AliasedLine(LineFragments::new(a, b, width as i32), width as i32)
                    }
                    Antialiasing::Smooth => {
                        let [a, b, _] = corners();
                        Self::LineRectangle(LineRectangle::new(a, b, width.into()))
                    }
                }
            }
            ShapeKind::Point { size, .. } => {
                match (raster.point.antialiasing, &raster.point.sprite) {
                    (Antialiasing::Smooth, None) => {
                        let window = shape.centre(geometry, &plan.viewport);
                        Self::Disc(window, f64::from(size) * 0.5)
                    }
                    (Antialiasing::Aliased, _) | (Antialiasing::Smooth, Some(_)) => Self::Box,
                }
            }
        }
    }

    /// The outline moved so that pixels' centres meet it where a sample meets `shape`.
    fn of_sample(
        plan: &DrawPlan,
        geometry: &Geometry,
        shape: &Shape,
        tile: [i32; 2],
        position: [i32; 2],
    ) -> Self {
        let moved = |c: [i32; 2]| [c[0] - position[0], c[1] - position[1]];
        let corners = shape.corners.map(moved);
        match shape.kind {
            ShapeKind::Triangle => {
                Self::Triangle(edge_functions::edges(&corners, tile[0], tile[1]))
            }
            ShapeKind::Line { .. } => {
                let [a, b, _] = corners.map(|c| c.map(|v| f64::from(v) / f64::from(SUBPIXEL)));
                Self::LineSample(LineRectangle::new(a, b, plan.raster.line.drawn_width().into()))
            }
            ShapeKind::Point { .. } if plan.raster.point.sprite.is_some() => Self::Box,
            ShapeKind::Point { size, .. } => {
                let window = shape.centre(geometry, &plan.viewport);
                let by = position.map(|v| f64::from(v) / f64::from(SUBPIXEL));
                let center = [window[0] - by[0], window[1] - by[1]];
                Self::DiscSample(center, f64::from(size) * 0.5)
            }
        }
    }

    /// The blocks of the tile that it may cover, bit by block: a long line covers few of the blocks of its bounds.
    pub fn touched(&self, tile: [i32; 2]) -> u64 {
        let touched_by = |corners: &[[f64; 2]]| match area::overlap(
            corners,
            tile.map(f64::from),
            f64::from(TILE),
        ) {
            Overlap::None => 0,
            Overlap::Part | Overlap::All => !0,
        };
        match self {
            Self::AliasedLine(fragments, width) => line_blocks(fragments, *width, tile),
            Self::SmoothTriangle(corners) => touched_by(corners),
            Self::LineRectangle(band) | Self::LineSample(band) => touched_by(&band.corners),
            Self::Triangle(_) | Self::Box | Self::Disc(..) | Self::DiscSample(..) => !0,
        }
    }

    /// The lanes that are covered of a block; `coverage` receives the covered fraction of each if antialiased.
    #[inline]
    pub fn block(
        &self,
        isa: Isa,
        plan: &DrawPlan,
        shape: &Shape,
        at: BlockAt,
        coverage: &mut F32s,
    ) -> u64 {
        let (first, [bx, by]) = (at.first(), at.block);
        let origin = first.map(f64::from);
        let dashes = match shape.kind {
            ShapeKind::Line { stipple, .. } => {
                plan.raster.line.stipple.map(|state| (state, stipple))
            }
            ShapeKind::Triangle | ShapeKind::Point { .. } => None,
        };
        match self {
            Self::Triangle(edges) => edge_functions::block(isa, edges, bx, by).lanes(),
            Self::AliasedLine(fragments, width) => line_lanes(fragments, *width, dashes, first),
            Self::Box => !0,
            Self::SmoothTriangle(corners) => {
                let add = |areas: &mut Areas| area::add_polygon_areas(isa, corners, origin, areas);
                smooth(shape, at, area::overlap(corners, origin, 8.0), coverage, add)
            }
            Self::LineRectangle(band) => {
                let overlap = match area::overlap(&band.corners, origin, 8.0) {
                    Overlap::All if dashes.is_some() => Overlap::Part,
                    overlap => overlap,
                };
                smooth(shape, at, overlap, coverage, |areas| band.add(isa, dashes, origin, areas))
            }
            Self::Disc(center, radius) => {
                let overlap = |at, side| area::disc_overlap(*center, *radius, at, side);
                smooth(shape, at, overlap(origin, 8.0), coverage, |areas| {
                    for (lane, area) in areas.iter_mut().enumerate() {
                        let [x, y] = [lane_x(lane) as f64, lane_y(lane) as f64];
                        let pixel = [origin[0] + x, origin[1] + y];
                        *area = match overlap(pixel, 1.0) {
                            Overlap::None => 0.0,
                            Overlap::Part => area::disc(*center, *radius, pixel),
                            Overlap::All => 1.0,
                        };
                    }
                })
            }
            Self::LineSample(band) => match area::overlap(&band.corners, origin, 8.0) {
                Overlap::None => 0,
                Overlap::Part | Overlap::All => band.centers(isa, dashes, first),
            },
            Self::DiscSample(middle, radius) => centers(first, |center| {
                let (x, y) = (center[0] - middle[0], center[1] - middle[1]);
                x * x + y * y <= radius * radius
            }),
        }
    }
}

/// The blocks of a tile that an aliased line touches.
fn line_blocks(line: &LineFragments, width: i32, tile: [i32; 2]) -> u64 {
    let (major, minor) = (line.major, 1 - line.major);
    let last_row = TILE as i32 - 1;
    let mut blocks = 0;
    for along in 0..TILE as i32 / 8 {
        let first = tile[major] + 8 * along;
        let (low, high) = (line.first.max(first), line.last.min(first + 7));
        if low > high {
            continue;
        }
        // Rows only rise, or only fall, from column to column.
        let ends = [line.row(low), line.row(high)].map(|row| row - tile[minor]);
        let lowest = ends[0].min(ends[1]).max(0);
        let highest = (ends[0].max(ends[1]) + width - 1).min(last_row);
        for across in lowest / 8..(highest + 8) / 8 {
            let block = if major == 0 { [along, across] } else { [across, along] };
            blocks |= 1 << BlockAt { tile, block }.number();
        }
    }
    blocks
}

/// The lanes of the block from pixel `first` on that an aliased line covers.
fn line_lanes(line: &LineFragments, width: i32, dashes: Dashes, first: [i32; 2]) -> u64 {
    let (major, minor) = (line.major, 1 - line.major);
    let low = line.first.max(first[major]);
    let high = line.last.min(first[major] + 7);
    let mut lanes = 0;
    for column in low..=high {
        if !is_dash(dashes, line.index(column) * SUBPIXEL as u32) {
            continue;
        }
        let row = line.row(column);
        for row in row.max(first[minor])..(row + width).min(first[minor] + 8) {
            let mut at = [0; 2];
            (at[major], at[minor]) = (column - first[major], row - first[minor]);
            lanes |= 1 << edge_functions::lane_at(at[0] as usize, at[1] as usize);
        }
    }
    lanes
}

/// The lanes of a block of which any part is covered: `overlap` says how the outline and the
/// block lie, `add` what it covers of each pixel.
fn smooth(
    shape: &Shape,
    at: BlockAt,
    overlap: Overlap,
    coverage: &mut F32s,
    add: impl FnOnce(&mut Areas),
) -> u64 {
    let [low, high] = shape.bounds;
    let bounds = [low.map(i32::from), high.map(|last| i32::from(last) + 1)];
    let inside = edge_functions::inside_area(&bounds, at);
    match overlap {
        Overlap::None => 0,
        Overlap::All => {
            *coverage = F32s::splat(1.0);
            inside
        }
        Overlap::Part => {
            let mut areas = [0.0; LANES];
            add(&mut areas);
            let mut lanes = 0;
            for (lane, area) in areas.into_iter().enumerate() {
                coverage[lane] = area.min(1.0) as f32;
                lanes |= u64::from(area >= MIN_AREA) << lane;
            }
            lanes & inside
        }
    }
}

/// The lanes of the block from pixel `first` on whose centres are inside.
fn centers(first: [i32; 2], inside: impl Fn([f64; 2]) -> bool) -> u64 {
    (0..LANES).fold(0, |lanes, lane| {
        let pixel = [first[0] + lane_x(lane) as i32, first[1] + lane_y(lane) as i32];
        lanes | u64::from(inside(pixel.map(|v| f64::from(v) + 0.5))) << lane
    })
}
