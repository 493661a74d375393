//! What a client can ask for. A command buffer is printable: a trace is its `Debug`.

use super::buffer::{Buffer, VertexBinding};
use super::counter::Counter;
use super::image::PassDesc;
use super::pipeline::Pipeline;
use super::raster::RasterState;
use super::watch::Watch;
use std::ops::Range;
use std::sync::Arc;
use texunit::plan::SamplePlan;

/// Where window coordinates lie (GL 2.1, section 2.11.1). May reach outside the attachments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// Left edge in pixels.
    pub x: f32,
    /// Lower edge in pixels.
    pub y: f32,
    /// Width in pixels.
    pub width: f32,
    /// Height in pixels.
    pub height: f32,
    /// Window depth of the near plane, 0 to 1.
    pub near: f32,
    /// Window depth of the far plane, 0 to 1.
    pub far: f32,
    /// What becomes of what lies before the near plane or behind the far one.
    pub depth_clip: DepthClip,
}

/// What the near and the far plane do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DepthClip {
    /// They cut.
    #[default]
    Cut,
    /// Nothing; depths are held between those of both planes (`ARB_depth_clamp`).
    Clamp,
}

impl Viewport {
    /// The least and the largest depth of fragments, whatever planes, offsets and shaders gave.
    pub(crate) fn depths(&self) -> [f32; 2] {
        match self.depth_clip {
            DepthClip::Cut => [0.0, 1.0],
            DepthClip::Clamp if self.near < self.far => [self.near, self.far],
            DepthClip::Clamp => [self.far, self.near],
        }
    }

    /// Half its width and height.
    pub(crate) fn half(&self) -> [f64; 2] {
        [f64::from(self.width) * 0.5, f64::from(self.height) * 0.5]
    }

    /// The window position of clip coordinates (0, 0).
    pub(crate) fn center(&self) -> [f64; 2] {
        let half = self.half();
        [f64::from(self.x) + half[0], f64::from(self.y) + half[1]]
    }

    /// The pixels whose centres it holds: the first, and one past the last.
    pub(crate) fn pixels(&self) -> [[i32; 2]; 2] {
        let sides = [(self.x, self.width), (self.y, self.height)];
        let [x, y] = sides.map(|(start, size)| {
            let (start, size) = (f64::from(start), f64::from(size));
            [(start - 0.5).ceil() as i32, (start + size - 0.5).ceil() as i32]
        });
        [[x[0], y[0]], [x[1], y[1]]]
    }

    /// Window x and y of clip coordinates; meaningless unless `w > 0`.
    pub(crate) fn window(&self, clip: &[f64; 4]) -> [f64; 2] {
        let (half, center) = (self.half(), self.center());
        [clip[0] / clip[3] * half[0] + center[0], clip[1] / clip[3] * half[1] + center[1]]
    }
}

/// A rectangle of pixels; row 0 is the lowest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rect {
    /// Left.
    pub x: i32,
    /// Lowest row.
    pub y: i32,
    /// Width.
    pub width: u32,
    /// Height.
    pub height: u32,
}

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

/// The type of an index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum IndexType {
    /// 8 bits.
    U8,
    /// 16 bits.
    U16,
    /// 32 bits.
    U32,
}

impl IndexType {
    /// Bytes of an index.
    pub fn size(self) -> usize {
        match self {
            Self::U8 => 1,
            Self::U16 => 2,
            Self::U32 => 4,
        }
    }

    /// The index that these bytes are, the lowest first; 0 where there are none.
    pub fn index(bytes: &[u8]) -> u32 {
        bytes.iter().rev().fold(0, |index, &byte| index << 8 | u32::from(byte))
    }
}

/// The indices of a draw. What lies past the buffer's end reads as index 0.
#[derive(Clone, Debug)]
pub struct Indices {
    /// The bytes.
    pub buffer: Buffer,
    /// Byte of the first index.
    pub offset: usize,
    /// Their type.
    pub ty: IndexType,
    /// Added to every index.
    pub base_vertex: i32,
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
    /// The uniform words of both stages.
    SetUniforms(Arc<[u32]>),
    /// How primitives become fragments; the default until it is set.
    SetRaster(Arc<RasterState>),
    /// The viewport.
    SetViewport(Viewport),
    /// The scissor rectangle; `None` lets every pixel of the attachments through.
    SetScissor(Option<Rect>),
    /// Records what all of the pass does to a pixel; the draws and clears to come carry its label.
    Watch(Watch),
    /// What counts the samples of the draws to come.
    SetCounter(Option<Counter>),
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
