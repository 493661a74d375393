//! Commands. A command buffer is printable: its trace is its `Debug`.

use super::image::PassDesc;
use crate::desc::{
    Counter, Indices, RasterState, Rect, ScissoredViewport, VertexBinding, Viewport,
};
use crate::plan::Pipeline;
use crate::trace::Watch;
use std::ops::Range;
use std::sync::Arc;
use texunit::plan::SamplePlan;

/// What a clear writes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ClearValue {
    /// To one colour attachment, through a mask of red, green, blue, alpha.
    Color {
        /// Which attachment.
        target: u8,
        /// RGBA, clamped and encoded as the attachment's format says.
        value: [f32; 4],
        /// Which components are written.
        mask: [bool; 4],
    },
    /// To one colour attachment, through a mask of red, green, blue, alpha: these words of a texel
    /// ([`super::texel_words`]).
    Texel {
        /// Which attachment.
        target: u8,
        /// The texel's bytes, the first lowest.
        words: [u32; 4],
        /// Which components are written.
        mask: [bool; 4],
    },
    /// To the depth attachment.
    Depth(f32),
    /// To the stencil of the depth attachment.
    Stencil {
        /// What is written.
        value: u8,
        /// Which bits are written.
        mask: u8,
    },
}

/// One step. State set by a command holds until the end of the pass.
#[derive(Clone, Debug)]
pub enum Command {
    /// Opens a pass over these attachments.
    BeginPass(PassDesc),
    /// Fills a rectangle of an attachment, in order with the draws.
    Clear {
        /// What is written where.
        value: ClearValue,
        /// Which pixels.
        area: Rect,
    },
    /// The shaders and fixed state of the draws to come.
    BindPipeline(Pipeline),
    /// The attributes of the draws to come. An attribute without a binding is (0, 0, 0, 1).
    BindVertices(Arc<[VertexBinding]>),
    /// The textures of the draws to come, by slot of the vertex and the fragment stage.
    BindTextures {
        /// For the vertex module's slots.
        vertex: Arc<[Option<Arc<SamplePlan>>]>,
        /// For the fragment module's slots.
        fragment: Arc<[Option<Arc<SamplePlan>>]>,
    },
    /// The textures of the draws to come, by slot of the geometry module; none until they are bound.
    BindGeometryTextures(Arc<[Option<Arc<SamplePlan>>]>),
    /// The uniform words of all stages.
    SetUniforms(Arc<[u32]>),
    /// How primitives become fragments; the default until it is set.
    SetRaster(Arc<RasterState>),
    /// The viewport.
    SetViewport(Viewport),
    /// The scissor rectangle; `None` lets every pixel of the attachments through.
    SetScissor(Option<Rect>),
    /// The viewports from number 1 on, for pipelines whose programs give the number of one
    /// ([`Pipeline::chooses_viewports`]); none in a new pass. Number 0 is that of [`Self::SetViewport`].
    SetMoreViewports(Arc<[ScissoredViewport]>),
    /// Records what all of the pass does to a pixel; the draws and clears to come carry its label.
    Watch(Watch),
    /// What counts the samples of the draws to come.
    SetCounter(Option<Counter>),
    /// The budget of each draw to come; that of the device until it is set ([`super::DeviceDesc::budget`]).
    SetBudget(u64),
    /// The number of the first primitive of each instance of the draws to come, for shaders that read the number; 0 in a
    /// new pass. A draw that is cut at restart indices goes on counting (EXT_gpu_shader4, section 2.15.3).
    SetFirstPrimitive(u32),
    /// Draws vertices `first .. first + count` for each instance.
    Draw {
        /// First vertex.
        first: u32,
        /// How many.
        count: u32,
        /// Which instances.
        instances: Range<u32>,
    },
    /// Draws by `count` indices for each instance.
    DrawIndexed {
        /// Where the indices are.
        indices: Indices,
        /// How many.
        count: u32,
        /// Which instances.
        instances: Range<u32>,
    },
    /// Closes the pass.
    EndPass,
}

/// Recorded commands.
#[derive(Clone, Debug, Default)]
pub struct CommandBuffer {
    /// In order.
    pub commands: Vec<Command>,
}

impl CommandBuffer {
    /// Nothing recorded.
    pub fn new() -> Self {
        Self::default()
    }

    /// Appends a command.
    pub fn push(&mut self, command: Command) {
        self.commands.push(command);
    }
}
