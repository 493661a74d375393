//! What was emitted to the open pass, and by what it was decided: a draw emits only what differs from the draw before.

use crate::context::recorder::batching::LastDraw;
use crate::context::recorder::elements::bit;
use crate::context::recorder::fixed_function::StageKeys;
use crate::context::recorder::stages::Textures;
use crate::state::plain::PlainState;
use rasterizer::driver::{
    Counter, PipelineDesc, RasterState, Rect, ScissoredViewport, Topology, VertexBinding,
    VertexSource, Viewport,
};
use std::sync::Arc;

/// The state that was last emitted to the open pass. It holds until the pass ends, so a draw emits only what differs.
#[derive(Debug, Default)]
pub(crate) struct EmittedState {
    pub pipeline: Option<PipelineDesc>,
    /// The call of the last draw whose framebuffer was checked: it is drawn to in the open pass.
    pub pass_call: Option<u64>,
    /// The attributes that the pipeline reads, bit by location.
    pub attributes: u64,
    pub words: Option<Arc<[u32]>>,
    /// Of the vertex, the geometry and the fragment stage.
    pub textures: Option<[Textures; 3]>,
    pub raster: Option<Arc<RasterState>>,
    pub viewport: Option<Viewport>,
    pub scissor: Option<Option<Rect>>,
    /// Whether the pipeline's programs give the number of a viewport.
    pub chooses_viewports: bool,
    /// The viewports from number 1 on, of such pipelines.
    pub more_viewports: Option<Arc<[ScissoredViewport]>>,
    pub counter: Option<Counter>,
    pub first_primitive: u32,
    /// The draw before, if others may be added to it.
    pub last_draw: Option<LastDraw>,
    /// What it was decided by, if another draw may use that again.
    pub decisions: Option<DrawDecisions>,
}

impl EmittedState {
    /// The attributes that draws read, bit by location.
    pub(crate) fn attributes_read(&self) -> u64 {
        let edge_flag = self.raster.as_ref().and_then(|raster| raster.polygon.edge_flag);
        self.attributes | edge_flag.map_or(0, bit)
    }
}

/// What the shaders, the pipeline and the textures of the draw before were chosen by. A draw that differs in nothing
/// but values (uniform words, and where vertices are read from) uses them again: see `draw/draw_reuse.rs`.
#[derive(Debug)]
pub(crate) struct DrawDecisions {
    /// [`crate::context::state_changes::StateChanges::calls`] at its call.
    pub call: u64,
    /// The same when its textures were chosen last.
    pub textures_call: u64,
    /// The plain state at its call.
    pub plain: Box<PlainState>,
    pub topology: Topology,
    /// The attributes that were read from arrays, and how many components of them.
    pub arrays: Vec<(u8, u8)>,
    pub keys: StageKeys,
}

/// The attributes that are read from arrays: location, and how many components.
pub(crate) fn arrays(vertices: &[VertexBinding]) -> impl Iterator<Item = (u8, u8)> {
    vertices.iter().filter_map(|binding| match binding.source {
        VertexSource::Array { components, .. } => Some((binding.location, components)),
        VertexSource::Constant(_) => None,
    })
}
