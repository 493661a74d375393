//! The objects of the driver, as in Vulkan: a client makes images, buffers and pipelines, records
//! commands, and submits them to the queue.

mod bound;
mod check;
mod chunk;
mod command;
mod device;
mod image;
mod pass;
mod report;
mod resources;
mod submit;
mod visibility;

pub use crate::attachment::{RowSpan, RowWriter, texel_words};
pub use crate::desc::{
    AlphaToCoverage, AlphaToOne, Antialiasing, Blend, BlendEquation, BlendFactor, Buffer,
    ClipControl, ClipDepth, ClipOrigin, ColorState, Counter, Cull, DepthClip, DepthState,
    DepthWrite, FrontFace, IndexType, Indices, LineState, LineStipple, LogicOp, MAX_LINE_WIDTH,
    MAX_POINT_SIZE, MAX_VIEWPORTS, MaskBlock, MultisampleState, OutputState, PipelineDesc,
    PipelineError, PixelMask, PointSize, PointState, PolygonMode, PolygonOffset, PolygonState,
    PolygonSubject, Provoking, RasterState, Rect, SampleCoverage, SampleRule, SampleShading,
    ScissoredViewport, ShaderModule, SpriteOrigin, SrgbWrite, StencilFace, StencilOp, StencilState,
    Stipple, Topology, Version, VertexBinding, VertexFormat, VertexSource, VertexType, ViewSides,
    Viewport,
};
pub use crate::plan::LeaveOut;
pub use crate::plan::{Pipeline, possible_samples, same_textures, sample_positions};
pub use crate::primitive::{InvisibleReason, InvisibleReasons, PrimitiveKind, ViewVolumeSide};
pub use crate::sizes::MAX_SAMPLES;
pub use crate::trace::Watch;
pub use crate::vertex::{Primitive, Primitives, primitives};
pub use command::{ClearValue, Command, CommandBuffer};
pub use device::Device;
pub use image::{
    Attachment, AttachmentSamples, Image, LevelInfo, MultisampleStorage, PassDesc, ViewDesc,
};
pub use report::{DeviceError, FrameSpending, SubmitError, SubmitReport};
pub use resources::{DeviceDesc, Explain};
pub use visibility::Visibility;
