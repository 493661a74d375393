//! How much a draw may run.
//!
//! Vertices that lie in memory are as many as the client has written, so that a draw of them may run long for each, and
//! cover its target often. Instances, and vertices of no array, are a number in a call: 2^31 of them would run for hours.
//! What a draw may run is decided by what it asks for, before it begins; what it has run is a sum over its vertices,
//! pixels and loops. Both depend on the draw alone, so that the same primitives are left out on every machine.

use crate::desc::{
    Antialiasing, PolygonMode, PrimitiveClass, RasterState, VertexBinding, VertexSource,
};
use crate::driver::chunk::DrawState;
use crate::driver::resources::DeviceDesc;
use crate::plan::DrawPlan;
use crate::raster::{Chunk, DrawBudget};
use crate::shader::OverBudget;
use crate::vertex::VertexIds;
use std::ops::Range;
use std::sync::atomic::Ordering;
use texunit::lanes::LANES;

/// Vertices that take no time.
const FEW_VERTICES: u64 = 1 << 16;
/// Vertices that an element of an array, or an index, is reason enough for.
const VERTICES_OF_ELEMENT: u64 = 16;
/// Vertices that a draw may ask for beyond, of programs of at most [`SHORT_PROGRAM`].
const ALLOWED_VERTICES: u64 = 1 << 28;
/// Operations of a batch of vertices of a program that is not weighed.
const SHORT_PROGRAM: u64 = 1 << 10;
/// The vertices that a run of primitives takes as long as.
const RUN_VERTICES: u64 = 64;
/// The operations of a draw that asks for no more than what is allowed: so many times the budget, and at least so many.
const ALLOWED_BUDGETS: u64 = 64;
const ALLOWED_OPERATIONS: u64 = 1 << 26;
/// The operations for each vertex that memory holds, beside [`ALLOWED_BUDGETS`].
const OPERATIONS_OF_HELD_VERTEX: u64 = 512;
/// How often a draw that memory holds may cover all of its target, beside them.
const COVERINGS: u64 = 64;
/// The same in a frame that has spent its budget.
const COVERINGS_OF_SPENT_FRAME: u64 = 4;
/// The batches of vertices that the budget of a draw beyond is divided among.
const BATCHES: u64 = 1 << 10;

/// Operations of a vertex beside its program: fetch, viewport transform.
const VERTEX: u64 = 20;
/// Operations of a primitive: clipping, culling, binning.
const PRIMITIVE: u64 = 8;
/// The same of a polygon that is drawn as lines or points, whether these are seen or not.
const OUTLINED_POLYGON: u64 = 256;
/// Operations of a batch of fragments beside its program, at each sample.
const FRAGMENTS: u64 = 8;
/// Operations of a batch that is shaded at one of its samples, beside its program: its planes are moved there, and few of
/// its lanes are covered where shapes are small.
const FRAGMENTS_OF_SAMPLE: u64 = 256;
/// Operations of a shape at each sample, beside those of its batches: where shapes lie on each other, each has a batch for
/// itself, however few lanes it covers.
const SHAPE: u64 = 192;
/// Operations of a batch of fragments of a line, which covers few of its lanes.
const FRAGMENTS_OF_LINE: u64 = 64;
/// Operations of a batch of fragments whose part of each pixel is computed (smooth points, lines, polygons).
const FRAGMENTS_OF_SMOOTH: u64 = 256;

/// What a draw asks for, by what holds it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// Memory holds it, and so many vertices.
    Held { vertices: u64 },
    /// A number alone, no larger than scenes have.
    Allowed,
    /// A number alone that no scene has: the draw is taken for one that does not end. Those of a frame share a budget.
    Endless,
}

impl Extent {
    /// That of a draw of so many vertices of each instance.
    pub fn of(vertices: u32, state: &DrawState<'_>) -> Self {
        let instances = state.instances.len() as u64;
        let runs = instances.div_ceil(state.instances_per_chunk().into())
            * u64::from(state.primitives.len.div_ceil(state.run_len()));
        let asked = u64::from(vertices) * instances;
        let asked = asked.max(runs.saturating_mul(RUN_VERTICES));
        if asked <= FEW_VERTICES {
            return Self::Held { vertices: asked };
        }
        let elements = |binding: &VertexBinding| match &binding.source {
            VertexSource::Array { buffer, stride, divisor, .. } => {
                let elements = buffer.bytes().len().checked_div(*stride).unwrap_or(0) as u64;
                (*divisor > 0, elements)
            }
            VertexSource::Constant(_) => (false, 0),
        };
        let most = |of_instances: bool| {
            let all = state.bindings.iter().map(elements).filter(|(own, _)| *own == of_instances);
            all.map(|(_, elements)| elements).max().unwrap_or(0)
        };
        let held = match state.ids {
            VertexIds::Indexed(indices) => {
                (indices.buffer.bytes().len() / indices.ty.size()) as u64
            }
            VertexIds::Range(_) => most(false),
        };
        let held = held.min(vertices.into()) + most(true).min(instances);
        let weight = state.batch_cost().div_ceil(SHORT_PROGRAM).max(1);
        if asked <= held * VERTICES_OF_ELEMENT {
            Self::Held { vertices: asked }
        } else if asked.saturating_mul(weight) <= ALLOWED_VERTICES {
            Self::Allowed
        } else {
            Self::Endless
        }
    }

    /// In a frame that has spent its budget, each number alone is one that no scene has.
    pub fn in_spent_frame(self) -> Self {
        match self {
            Self::Held { .. } => self,
            Self::Allowed | Self::Endless => Self::Endless,
        }
    }

    /// What a batch of its vertices may run, of the budget of a frame that has spent some.
    pub fn batch_budget(self, budget: u64, spent: u64) -> u64 {
        match self {
            Self::Held { .. } | Self::Allowed => DeviceDesc::batch_budget_after(budget, spent),
            Self::Endless => budget.saturating_sub(spent) / BATCHES,
        }
    }

    /// What its fragments may run in loops.
    pub fn fragment_budget(self, budget: u64) -> DrawBudget {
        match self {
            Self::Held { .. } | Self::Allowed => DrawBudget::new(budget),
            Self::Endless => DrawBudget::without_free(budget),
        }
    }
}

/// What a draw has left.
pub struct Account {
    left: u64,
    spent: u64,
    /// Vertices of each instance.
    vertices: u64,
    /// What programs cost a batch of vertices, with each loop run once, unless loops are counted.
    vertex_batch: u64,
    fragment_batch: u64,
    primitive: u64,
    shape: u64,
}

impl Account {
    /// Of a draw that begins, in a frame that has left so much of its budget.
    pub fn new(
        extent: Extent,
        left: u64,
        vertices: u32,
        state: &DrawState<'_>,
        plan: &DrawPlan,
    ) -> Self {
        let fragment_batch = fragment_batch(state, plan);
        let allowed = || left.saturating_mul(ALLOWED_BUDGETS);
        let operations = match extent {
            Extent::Held { vertices } => {
                let coverings = if left > 0 { COVERINGS } else { COVERINGS_OF_SPENT_FRAME };
                let covering = state.batches_of_target().saturating_mul(fragment_batch);
                let held = vertices.saturating_mul(OPERATIONS_OF_HELD_VERTEX);
                let held = held.saturating_add(covering.saturating_mul(coverings));
                held.saturating_add(allowed()).max(ALLOWED_OPERATIONS)
            }
            Extent::Allowed => allowed().max(ALLOWED_OPERATIONS),
            Extent::Endless => left,
        };
        let is_filled = draws_only_filled(state);
        Self {
            left: operations,
            spent: 0,
            vertices: vertices.into(),
            vertex_batch: state.batch_cost(),
            fragment_batch,
            primitive: if is_filled { PRIMITIVE } else { OUTLINED_POLYGON },
            shape: plan.samples.count as u64 * SHAPE,
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
        let (mut emitted, mut fragments) = (0, 0_u64);
        for chunk in chunks {
            emitted += if state.geometry.is_some() { chunk.geometry.len() as u64 } else { 0 };
            let of_shapes = (chunk.lists.shapes.len() as u64).saturating_mul(self.shape);
            let of_batches = chunk.batches.saturating_mul(self.fragment_batch);
            fragments = fragments.saturating_add(of_shapes).saturating_add(of_batches);
        }
        let (run, all) = (primitives.len() as u64, u64::from(state.primitives.len.max(1)));
        let instances = state.instances.len() as u64;
        let vertices = (run * self.vertices).div_ceil(all).saturating_mul(instances);
        let batches = vertices.div_ceil(LANES as u64).saturating_mul(self.vertex_batch);
        let operations = (vertices.saturating_add(RUN_VERTICES).saturating_add(emitted) * VERTEX)
            .saturating_add(run.saturating_mul(instances).saturating_mul(self.primitive))
            .saturating_add(batches)
            .saturating_add(state.operations.swap(0, Ordering::Relaxed))
            .saturating_add(fragments);
        self.spend(operations)
    }

    /// What it has been charged.
    pub fn spent(&self) -> u64 {
        self.spent
    }

    /// Charges operations.
    ///
    /// # Errors
    /// When the draw has spent all.
    pub fn spend(&mut self, operations: u64) -> Result<(), OverBudget> {
        self.left = self.left.checked_sub(operations).ok_or(OverBudget)?;
        self.spent += operations;
        Ok(())
    }
}

/// What a draw draws polygons as, if it draws any.
fn draws_only_filled(state: &DrawState<'_>) -> bool {
    state.setup.raster.polygon.mode == [PolygonMode::Fill; 2]
}

/// Operations of a batch of fragments, of the kind of shapes of a draw that takes the longest.
fn fragment_batch(state: &DrawState<'_>, plan: &DrawPlan) -> u64 {
    let program = plan.pipeline.compiled().fragment.cost(&plan.textures);
    let samples = plan.samples.count as u64;
    let RasterState { polygon, line, point, .. } = &*plan.raster;
    // Where there are several samples, each is covered or not.
    let coverage = |of| match of {
        Antialiasing::Smooth if samples == 1 => FRAGMENTS_OF_SMOOTH,
        Antialiasing::Smooth | Antialiasing::Aliased => 0,
    };
    let of_line = FRAGMENTS_OF_LINE + coverage(line.antialiasing);
    let beside = match state.pipeline.desc().drawn().class() {
        PrimitiveClass::Points => coverage(point.antialiasing),
        PrimitiveClass::Lines => of_line,
        PrimitiveClass::Polygons => {
            let of_mode = |mode| match mode {
                PolygonMode::Fill => coverage(polygon.antialiasing),
                PolygonMode::Line => of_line,
                PolygonMode::Point => coverage(point.antialiasing),
            };
            polygon.mode.map(of_mode).into_iter().max().unwrap_or(0)
        }
    };
    beside
        + match plan.samples.is_shaded_each() {
            true => samples * (FRAGMENTS_OF_SAMPLE + program),
            false => samples * FRAGMENTS + program,
        }
}
