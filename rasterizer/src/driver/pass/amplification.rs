//! How much a draw may make of little memory.
//!
//! Vertices that lie in memory are as many as the client has written, so that a draw of them may be as large as it likes.
//! Instances, and vertices that no array holds, are a number in a call: 2^31 of them would run for hours. What is
//! shaded for these is charged to the draw, in additions of 64 lanes as loops of shaders are ([`crate::raster`]'s
//! budget). The charge depends on the draw alone, so that what is left out is the same on every machine.

use crate::desc::{Topology, VertexBinding, VertexSource};
use crate::driver::chunk::DrawState;
use crate::plan::DrawPlan;
use crate::raster::Chunk;
use crate::shader::OverBudget;
use crate::vertex::VertexIds;
use std::ops::Range;
use std::sync::atomic::Ordering;
use texunit::lanes::LANES;

/// What a draw may spend on vertices that no memory holds, in budgets of loops, where arrays of instances are about as long as there are instances: most of such draws are scenes.
const INSTANCED_VERTEX_BUDGETS: u64 = 16;
/// What it may spend on their pixels.
const PIXEL_BUDGETS: u64 = 16;
/// Instances that may share an element of an array for these to be in memory.
const INSTANCES_OF_ELEMENT: usize = 16;
/// Fetch, viewport transform, clipping, culling and binning, by vertex of a primitive.
const VERTEX: u64 = 8;
/// A run of primitives, even an empty one.
const RUN: u64 = 512;
/// A batch of fragments beside its program.
const FRAGMENTS: u64 = 8;
/// How often loops of a fragment program are taken to run. Each batch may run longer.
const LOOP: u64 = 64;

/// What a draw has left for vertices that no memory holds.
pub struct Amplification {
    /// Whether the first instance lies in memory.
    is_first_free: bool,
    first_instance: u32,
    /// Vertices of a primitive.
    corners: u64,
    vertices: u64,
    pixels: u64,
    /// What a vertex program without loops costs a batch, with the geometry program.
    vertex_batch: u64,
    fragment_batch: u64,
}

impl Amplification {
    /// Of a draw that begins.
    pub fn new(budget: u64, state: &DrawState<'_>, plan: &DrawPlan) -> Self {
        let compiled = state.pipeline.compiled();
        let is_array = |binding: &VertexBinding| match &binding.source {
            VertexSource::Array { stride, divisor: 0, .. } => *stride > 0,
            VertexSource::Array { .. } | VertexSource::Constant(_) => false,
        };
        let is_first_free = match state.ids {
            VertexIds::Indexed(_) => true,
            VertexIds::Range(_) => state.bindings.iter().any(is_array),
        };
        let least = state.instances.len() / INSTANCES_OF_ELEMENT;
        let holds_instances = |binding: &VertexBinding| match &binding.source {
            VertexSource::Array { buffer, stride, divisor: 1.., .. } => {
                buffer.bytes().len().checked_div(*stride).is_some_and(|elements| elements >= least)
            }
            VertexSource::Array { .. } | VertexSource::Constant(_) => false,
        };
        let vertex_budgets = match state.bindings.iter().any(holds_instances) {
            true => INSTANCED_VERTEX_BUDGETS,
            false => 1,
        };
        let fragment = compiled.fragment.cost(&plan.textures);
        let geometry = state.geometry.as_ref().map_or(0, |own| own.program.cost(own.textures));
        Self {
            is_first_free,
            first_instance: state.instances.start,
            corners: if state.pipeline.desc().drawn() == Topology::Points { 1 } else { 3 },
            vertices: budget.saturating_mul(vertex_budgets),
            pixels: budget.saturating_mul(PIXEL_BUDGETS),
            vertex_batch: compiled.vertex.cost(state.textures) + geometry,
            fragment_batch: FRAGMENTS
                + if compiled.fragment.has_loops() { LOOP * fragment } else { fragment },
        }
    }

    /// Charges a run of primitives of the instances of `state`.
    ///
    /// # Errors
    /// When the draw has spent all.
    pub fn charge<'a>(
        &mut self,
        state: &DrawState<'_>,
        primitives: Range<u32>,
        chunks: impl Iterator<Item = &'a Chunk>,
    ) -> Result<(), OverBudget> {
        let instances = state.instances.len() as u64;
        let is_free = self.is_first_free && state.instances.contains(&self.first_instance);
        let charged = instances - u64::from(is_free);
        let looped = state.operations.swap(0, Ordering::Relaxed);
        if charged == 0 {
            return Ok(());
        }
        let (mut emitted, mut pixels) = (0, 0_u64);
        for chunk in chunks {
            emitted += if state.geometry.is_some() { chunk.geometry.len() as u64 } else { 0 };
            for shape in &chunk.lists.shapes {
                pixels = pixels.saturating_add(shape.pixels().div_ceil(LANES as u64));
            }
        }
        let asked = primitives.len() as u64 * instances * self.corners;
        let vertices = RUN
            + asked.max(emitted) * VERTEX
            + looped.max(asked.div_ceil(LANES as u64) * self.vertex_batch);
        let share =
            |all: u64| (u128::from(all) * u128::from(charged) / u128::from(instances)) as u64;
        let left = self.vertices.checked_sub(share(vertices));
        self.vertices = left.ok_or(OverBudget)?;
        let left = self.pixels.checked_sub(share(pixels.saturating_mul(self.fragment_batch)));
        self.pixels = left.ok_or(OverBudget)?;
        Ok(())
    }
}
