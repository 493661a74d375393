//! Chunks of what a geometry program emits.

use super::{CHUNK, DrawState, TileBin, chunk_of};
use crate::desc::PointSize;
use crate::ir::{Input, Output};
use crate::plan::Textures;
use crate::raster::{Chunk, ShapeLists};
use crate::shader::{OverBudget, Prepared, Program};
use crate::vertex::{
    Emitted, Geometry, GeometryStage, Primitives, VertexIds, VertexList, primitives,
};
use std::ops::Range;
use std::sync::Arc;
use texunit::lanes::LANES;

/// Vertices that the primitives of a chunk may emit, unless it has but one batch of them.
const VERTICES: u32 = 1 << 14;

/// The geometry program of a draw.
#[derive(Clone)]
pub struct GeometryProgram<'a> {
    pub program: &'a Program,
    /// Its values of this draw.
    pub prepared: Arc<Prepared>,
    pub textures: &'a Textures,
}

impl GeometryProgram<'_> {
    /// The most primitives that it makes of one.
    pub fn amplification(&self) -> usize {
        self.max_vertices() as usize
    }

    fn max_vertices(&self) -> u32 {
        self.program.geometry().map_or(0, |interface| interface.max_vertices).max(1)
    }

    /// Primitives of a chunk.
    pub fn chunk_len(&self) -> u32 {
        let batch = LANES as u32;
        (VERTICES / self.max_vertices() / batch * batch).clamp(batch, CHUNK)
    }

    /// Whether the point sizes of vertices are read.
    pub fn vertex_point_size(&self) -> PointSize {
        let reads =
            |input: &Input| matches!(input, Input::OfVertex { output: Output::PointSize, .. });
        match self.program.inputs().iter().any(reads) {
            true => PointSize::Vertex,
            false => PointSize::State,
        }
    }
}

impl DrawState<'_> {
    /// The chunks of what a geometry program makes of the primitives of `range`.
    pub(super) fn emitted_chunks(
        &self,
        program: &GeometryProgram<'_>,
        range: Range<u32>,
    ) -> Result<Vec<(Chunk, Vec<TileBin>)>, OverBudget> {
        let vertices = |range: &Range<u32>| {
            let mut geometry = self.geometries.take();
            let vertex_list = self.vertices(range, &mut geometry, 0)?;
            Ok((geometry, vertex_list))
        };
        let shared = match self.ids {
            VertexIds::Indexed(_) => Some(vertices(&range)?),
            VertexIds::Range(_) => None,
        };
        let chunk = |start: u32| {
            let own_range = start..range.end.min(start + self.chunk_len());
            let own = match shared {
                Some(_) => None,
                None => Some(vertices(&own_range)?),
            };
            let mut geometry = self.geometries.take();
            let mut lists = self.lists.take();
            geometry.clear();
            lists.shapes.clear();
            if let Some((input, vertex_list)) = shared.as_ref().or(own.as_ref()) {
                self.emit(program, (input, vertex_list), own_range, &mut geometry, &mut lists)?;
            }
            if let Some((input, _)) = own {
                self.geometries.give(input);
            }
            let line = &self.setup.raster.line;
            Ok(chunk_of(self.draw, Arc::new(geometry), lists, (self.layers, line)))
        };
        let starts = range.clone().step_by(self.chunk_len() as usize);
        let chunks = self.thread_pool.map(starts, 1, chunk).into_iter().collect();
        if let Some((input, _)) = shared {
            self.geometries.give(input);
        }
        chunks
    }

    /// Puts what a geometry program makes of a run of primitives, of every instance, behind others.
    pub(super) fn emit(
        &self,
        program: &GeometryProgram<'_>,
        (input, vertex_list): (&Geometry, &VertexList),
        range: Range<u32>,
        geometry: &mut Geometry,
        lists: &mut ShapeLists,
    ) -> Result<(), OverBudget> {
        let (drawn, vertex_list) =
            self.emit_vertices(program, (input, vertex_list), range, geometry)?;
        self.shapes(geometry, (&drawn, 0..drawn.len), &vertex_list, lists);
        Ok(())
    }

    /// Puts the vertices that a geometry program makes of a run of primitives, of every instance, behind others; the
    /// primitives that they make.
    pub(super) fn emit_vertices(
        &self,
        program: &GeometryProgram<'_>,
        (input, vertex_list): (&Geometry, &VertexList),
        range: Range<u32>,
        geometry: &mut Geometry,
    ) -> Result<(Primitives, VertexList), OverBudget> {
        let (compiled, desc) = (self.pipeline.compiled(), self.pipeline.desc());
        let stage = GeometryStage {
            isa: self.isa,
            budget: self.budget,
            operations: &self.operations,
            program: program.program,
            prepared: &program.prepared,
            textures: program.textures,
            vertex: &compiled.vertex,
            vertex_varyings: &compiled.vertex_slots,
            varyings: self.slots,
            primitive_id: self.primitive_id(),
            viewport: self.setup.viewport,
            point_size: self.setup.raster.point.source,
            provoking: desc.provoking,
            layers: self.layers(),
            viewports: self.viewports(),
        };
        let mut machine = self.machines.borrow();
        let mut emitted = Emitted { geometry, indices: Vec::new() };
        for instance in 0..self.instances.len() as u32 {
            let of_instance;
            let vertex_list = match instance {
                0 => vertex_list,
                number => {
                    of_instance = vertex_list.of_instance(number);
                    &of_instance
                }
            };
            let range = (&self.primitives, range.clone());
            stage.run(machine.get(), (input, vertex_list), range, &mut emitted)?;
        }
        let Emitted { indices, .. } = emitted;
        let drawn = primitives(desc.drawn(), desc.provoking, indices.len() as u32);
        Ok((drawn, VertexList::shaded(indices)))
    }
}
