//! Chunks of a draw: runs of primitives whose vertices are shaded, whose shapes are set up and
//! sorted by tiles, in parallel; what comes out is in the order of the primitives.

use super::buffer::VertexBinding;
use super::pipeline::{Pipeline, Topology};
use crate::plan::Textures;
use crate::pool::Pool;
use crate::primitive::{Primitives, Setup, Shape, setup, stipple_lines};
use crate::raster::Chunk;
use crate::shader::{Machine, OverBudget, Prepared};
use crate::target::TILE;
use crate::vertex::{Geometry, Ids, Ordinals, Unique, VertexStage, ordinals, shade};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;
use texunit::lanes::Isa;

/// Primitives of a draw whose vertices, where indices share them, are shaded together.
pub const RUN: u32 = 1 << 15;
/// Primitives of a chunk.
const CHUNK: u32 = 1 << 12;

/// What is the same for all chunks of a draw.
pub struct DrawState<'a> {
    /// Its index in the pass.
    pub draw: usize,
    pub isa: Isa,
    pub budget: u64,
    pub machines: &'a Pool<Machine>,
    pub geometries: &'a Pool<Geometry>,
    pub pipeline: &'a Pipeline,
    pub ids: &'a Ids<'a>,
    pub primitives: Primitives,
    pub bindings: &'a [VertexBinding],
    /// The vertex program's textures.
    pub textures: &'a Textures,
    /// The vertex program's values of this draw.
    pub prepared: Arc<Prepared>,
    /// The varying slots that the fragment stage reads.
    pub slots: Vec<u16>,
    pub setup: Setup<'a>,
    /// How far the line stipple has come, in subpixels.
    pub stipple: u32,
    /// Which instance.
    pub instance: u32,
}

/// The shapes of one tile in a chunk's `binned`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TileRun {
    /// The tile, across and up.
    pub tile: [u32; 2],
    pub first: u32,
    pub end: u32,
}

/// The shaded vertices of a run of primitives.
struct Vertices {
    geometry: Arc<Geometry>,
    ordinals: Ordinals,
    wanted: Vec<u32>,
    unique: Unique,
}

impl DrawState<'_> {
    /// Shades, sets up and sorts the primitives of `range`, at most [`RUN`].
    ///
    /// # Errors
    /// When a batch of vertices runs over its budget.
    pub fn chunks(&mut self, range: Range<u32>) -> Result<Vec<(Chunk, Vec<TileRun>)>, OverBudget> {
        // Indices may share vertices all over the run; consecutive ones belong to their primitives,
        // but for the few that strips and fans share.
        let shared = match self.ids {
            Ids::Indexed(_) => Some(self.vertices(&range)?),
            Ids::Range(_) => None,
        };
        let starts: Vec<u32> = range.clone().step_by(CHUNK as usize).collect();
        let shapes_of = |start: u32| -> Result<(Arc<Geometry>, Vec<Shape>), OverBudget> {
            let part = start..range.end.min(start + CHUNK);
            let own;
            let vertices = match &shared {
                Some(vertices) => vertices,
                None => {
                    own = self.vertices(&part)?;
                    &own
                }
            };
            Ok((vertices.geometry.clone(), self.shapes(vertices, part)))
        };
        let is_strip = match self.pipeline.desc().topology {
            Topology::LineStrip | Topology::LineLoop => true,
            Topology::Points
            | Topology::Lines
            | Topology::Triangles
            | Topology::TriangleStrip
            | Topology::TriangleFan
            | Topology::Quads
            | Topology::QuadStrip
            | Topology::Polygon => false,
        };
        let draw = self.draw;
        let chunk = |(geometry, shapes): (Arc<Geometry>, Vec<Shape>)| {
            let (binned, runs) = sort_by_tile(&shapes);
            (Chunk { draw, geometry, shapes, binned }, runs)
        };
        if let &[start] = starts.as_slice() {
            let mut one = shapes_of(start)?;
            if is_strip {
                let line = &self.setup.raster.line;
                self.stipple = stipple_lines(line, &mut one.1, self.stipple);
            }
            return Ok(vec![chunk(one)]);
        }
        if !is_strip {
            return starts.into_par_iter().map(|start| shapes_of(start).map(chunk)).collect();
        }
        // A line's stipple begins where that of the line before ends.
        let mut all = starts.into_par_iter().map(shapes_of).collect::<Result<Vec<_>, _>>()?;
        for (_, shapes) in &mut all {
            self.stipple = stipple_lines(&self.setup.raster.line, shapes, self.stipple);
        }
        Ok(all.into_iter().map(chunk).collect())
    }

    /// Shades the vertices of a run of primitives.
    fn vertices(&self, range: &Range<u32>) -> Result<Vertices, OverBudget> {
        let ordinals = ordinals(self.pipeline.desc().topology, &self.primitives, range);
        let wanted: Vec<u32> = ordinals.iter().map(|ordinal| self.ids.get(ordinal)).collect();
        let unique = Unique::of(&wanted, self.ids);
        let stage = VertexStage {
            isa: self.isa,
            budget: self.budget,
            program: &self.pipeline.compiled().vertex,
            prepared: &self.prepared,
            machines: self.machines,
            geometries: self.geometries,
            textures: self.textures,
            bindings: self.bindings,
            viewport: self.setup.viewport,
            varyings: &self.slots,
            point: &self.setup.raster.point,
            edge_flag: self.setup.raster.polygon.edge_flag,
        };
        let ids = unique.ids.as_deref().unwrap_or(&wanted);
        let geometry = Arc::new(shade(&stage, ids, self.instance)?);
        Ok(Vertices { geometry, ordinals, wanted, unique })
    }

    /// The shapes of a run of primitives.
    fn shapes(&self, vertices: &Vertices, range: Range<u32>) -> Vec<Shape> {
        let Vertices { geometry, ordinals, wanted, unique } = vertices;
        let mut shapes = Vec::with_capacity(range.len());
        let primitives = range.map(|i| self.primitives.get(i));
        let local = |ordinal: u32| unique.local(ordinals, wanted, ordinal);
        setup(&self.setup, geometry, primitives, local, &mut shapes);
        shapes
    }
}

/// The shapes of each tile that they may touch, in order, tile after tile.
fn sort_by_tile(shapes: &[Shape]) -> (Vec<u32>, Vec<TileRun>) {
    let tiles_of = |shape: &Shape| {
        let [low, high] = shape.bounds.map(|pixel| pixel.map(|v| u32::from(v) / TILE));
        [low, high]
    };
    let Some(first) = shapes.first() else { return (Vec::new(), Vec::new()) };
    let [mut low, mut high] = tiles_of(first);
    for shape in shapes {
        let [first, last] = tiles_of(shape);
        for axis in 0..2 {
            low[axis] = low[axis].min(first[axis]);
            high[axis] = high[axis].max(last[axis]);
        }
    }
    let across = (high[0] - low[0] + 1) as usize;
    let up = (high[1] - low[1] + 1) as usize;
    let indices = |shape: &Shape| {
        let [first, last] = tiles_of(shape);
        let row = move |y: u32| (y - low[1]) as usize * across;
        (first[1]..=last[1])
            .flat_map(move |y| (first[0]..=last[0]).map(move |x| row(y) + (x - low[0]) as usize))
    };
    let mut ends = vec![0_u32; across * up];
    for shape in shapes {
        for tile in indices(shape) {
            ends[tile] += 1;
        }
    }
    let mut runs = Vec::new();
    let mut total = 0;
    for (index, end) in ends.iter_mut().enumerate() {
        let first = total;
        total += *end;
        if *end > 0 {
            let tile = [low[0] + (index % across) as u32, low[1] + (index / across) as u32];
            runs.push(TileRun { tile, first, end: total });
        }
        *end = first;
    }
    let mut binned = vec![0; total as usize];
    for (shape, index) in shapes.iter().zip(0..) {
        for tile in indices(shape) {
            let at = &mut ends[tile];
            binned[*at as usize] = index;
            *at += 1;
        }
    }
    (binned, runs)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::primitive::{Facing, Kind};

    #[test]
    fn every_tile_gets_the_shapes_that_touch_it_in_order() {
        let shape = |low: [u16; 2], high: [u16; 2]| Shape {
            corners: [[0; 2]; 3],
            bounds: [low, high],
            vertices: [0; 3],
            provoking: 0,
            kind: Kind::Triangle,
            facing: Facing::Front,
        };
        let shapes = [
            shape([70, 10], [90, 20]),
            shape([60, 60], [70, 70]),
            shape([200, 100], [201, 101]),
            shape([64, 0], [127, 63]),
        ];
        let (binned, runs) = sort_by_tile(&shapes);
        let by_tile: Vec<([u32; 2], &[u32])> = runs
            .iter()
            .map(|run| (run.tile, &binned[run.first as usize..run.end as usize]))
            .collect();
        let want: &[([u32; 2], &[u32])] =
            &[([0, 0], &[1]), ([1, 0], &[0, 1, 3]), ([0, 1], &[1]), ([1, 1], &[1]), ([3, 1], &[2])];
        assert_eq!(by_tile, want);
        assert_eq!(sort_by_tile(&[]), (vec![], vec![]));
    }
}
