//! Chunks of primitives that go to several viewports (ARB_viewport_array): each chunk is of one viewport, whose plan and
//! area are those of a draw of their own.

use super::{DrawState, TileBin, chunk_of, provoking};
use crate::desc::MAX_VIEWPORTS;
use crate::primitive::{EMPTY_BOUNDS, Setup, Shape, setup, stipple_lines};
use crate::raster::{Chunk, ShapeLists};
use crate::shader::OverBudget;
use crate::vertex::{Geometry, Primitives, VertexList};
use std::ops::Range;
use std::sync::Arc;

/// The shapes of a run of primitives in the order of these, and their vertices as the viewports place them.
struct Placed {
    shapes: Vec<Shape>,
    /// The viewport of each shape.
    viewports: Vec<u8>,
    /// By viewport.
    geometries: [Option<Arc<Geometry>>; MAX_VIEWPORTS],
}

impl DrawState<'_> {
    /// The chunks of the primitives of `range`.
    pub(super) fn chunks_by_viewport(
        &mut self,
        range: Range<u32>,
    ) -> Result<Vec<(Chunk, Vec<TileBin>)>, OverBudget> {
        let len = self.chunk_len();
        let starts = range.clone().step_by(len as usize);
        let place = |start: u32| self.place(start..range.end.min(start + len));
        let placed = self.thread_pool.map(starts, 1, place);
        let mut chunks = Vec::new();
        for placed in placed {
            let mut placed = placed?;
            if self.is_strip() {
                let line = &self.setup.raster.line;
                self.stipple = stipple_lines(line, &mut placed.shapes, self.stipple);
            }
            self.divide(placed, &mut chunks);
        }
        Ok(chunks)
    }

    /// Shades and sets up the primitives of `range`, at most a chunk.
    fn place(&self, range: Range<u32>) -> Result<Placed, OverBudget> {
        let mut geometry = self.geometries.take();
        let vertex_list = self.vertices(&range, &mut geometry, 0)?;
        let Some(program) = &self.geometry else {
            return Ok(self.place_vertices(geometry, (&self.primitives, range), &vertex_list));
        };
        let mut emitted = self.geometries.take();
        emitted.clear();
        let (drawn, list) =
            self.emit_vertices(program, (&geometry, &vertex_list), range, &mut emitted)?;
        self.geometries.give(geometry);
        Ok(self.place_vertices(emitted, (&drawn, 0..drawn.len), &list))
    }

    /// Sets up primitives whose vertices are as the first viewport places them.
    fn place_vertices(
        &self,
        geometry: Geometry,
        (primitives, range): (&Primitives, Range<u32>),
        vertex_list: &VertexList,
    ) -> Placed {
        let first = Arc::new(geometry);
        let mut placed = Placed {
            shapes: Vec::new(),
            viewports: Vec::new(),
            geometries: [const { None }; MAX_VIEWPORTS],
        };
        // What a geometry program emits for several instances is one list.
        let instances = if self.geometry.is_some() { 1 } else { self.instances.len() as u32 };
        for instance in 0..instances {
            let of_instance;
            let vertex_list = match instance {
                0 => vertex_list,
                number => {
                    of_instance = vertex_list.of_instance(number);
                    &of_instance
                }
            };
            let viewport_of = |primitive: u32| {
                let vertex = vertex_list.local(provoking(primitives.get(primitive)));
                let number = first.viewport(vertex).unwrap_or(0) as usize;
                if number <= self.more_setups.len() { number } else { 0 }
            };
            let mut start = range.start;
            while start < range.end {
                let number = viewport_of(start);
                let own = (start..range.end).take_while(|&i| viewport_of(i) == number);
                let end = start + own.count() as u32;
                let own = self.setup_of(number);
                let geometry = placed.geometries[number].get_or_insert_with(|| match number {
                    0 => first.clone(),
                    _ => Arc::new(first.in_viewport(&own.viewport)),
                });
                setup(own, geometry, (primitives, start..end), vertex_list, &mut placed.shapes);
                placed.viewports.resize(placed.shapes.len(), number as u8);
                start = end;
            }
        }
        placed
    }

    fn setup_of(&self, viewport: usize) -> &Setup<'_> {
        match viewport.checked_sub(1) {
            None => &self.setup,
            Some(behind) => &self.more_setups[behind],
        }
    }

    /// Divides shapes into chunks of one viewport each: one chunk for a viewport where no two of them share a pixel, or
    /// else one for each run of shapes, whose order is that of the primitives.
    fn divide(&self, placed: Placed, chunks: &mut Vec<(Chunk, Vec<TileBin>)>) {
        let Placed { shapes, viewports, geometries } = placed;
        let mut all: Vec<(u8, Shape)> =
            viewports.into_iter().zip(shapes).filter(|(_, shape)| shape.has_pixels()).collect();
        if are_apart(&all) {
            // Sorting is stable.
            all.sort_by_key(|&(viewport, _)| viewport);
        }
        for run in all.chunk_by(|a, b| a.0 == b.0) {
            let viewport = usize::from(run[0].0);
            let Some(geometry) = &geometries[viewport] else { continue };
            let mut lists: ShapeLists = self.lists.take();
            lists.shapes.clear();
            lists.shapes.extend(run.iter().map(|&(_, shape)| shape));
            let by = (self.layers, &self.setup.raster.line);
            chunks.push(chunk_of(self.draw + viewport, geometry.clone(), lists, by));
        }
    }
}

/// Whether no two viewports have shapes that may share a pixel.
fn are_apart(shapes: &[(u8, Shape)]) -> bool {
    let mut bounds = [EMPTY_BOUNDS; MAX_VIEWPORTS];
    for (viewport, shape) in shapes {
        let [low, high] = &mut bounds[usize::from(*viewport)];
        for axis in 0..2 {
            low[axis] = low[axis].min(shape.bounds[0][axis]);
            high[axis] = high[axis].max(shape.bounds[1][axis]);
        }
    }
    let meet = |a: &[[u16; 2]; 2], b: &[[u16; 2]; 2]| {
        (0..2).all(|axis| a[0][axis] <= b[1][axis] && b[0][axis] <= a[1][axis])
    };
    let pairs =
        bounds.iter().enumerate().flat_map(|(at, a)| bounds[at + 1..].iter().map(move |b| (a, b)));
    !pairs.into_iter().any(|(a, b)| meet(a, b))
}
