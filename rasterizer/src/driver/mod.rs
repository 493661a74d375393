//! The objects of the driver, as in Vulkan: a client makes images, buffers and pipelines, records
//! commands, and submits them to the queue.

mod bound;
mod buffer;
mod check;
mod chunk;
mod command;
mod counter;
mod device;
mod image;
mod mask;
mod output;
mod pass;
mod pipeline;
mod raster;
mod sight;
mod submit;
mod threads;
mod watch;

pub use crate::output::texel_words;
pub use crate::primitive::{Drawn, Primitive, Primitives, Reason, Reasons, Side, primitives};
pub use crate::raster::{possible_samples, sample_positions};
pub use crate::target::{MAX_SAMPLES, Part, Put};
pub use bound::same_textures;
pub use buffer::{Buffer, Version, VertexBinding, VertexFormat, VertexSource, VertexType};
pub use command::{
    ClearValue, Command, CommandBuffer, DepthClip, IndexType, Indices, Rect, Viewport,
};
pub use counter::Counter;
pub use device::{Device, DeviceDesc, DeviceError, Explain, SubmitError, SubmitReport};
pub use image::{Attachment, Image, LevelInfo, PassDesc, Rows};
pub use mask::{MaskBlock, PixelMask};
pub use output::{LogicOp, OutputState, SrgbWrite, StencilFace, StencilOp, StencilState};
pub(crate) use pipeline::Compiled;
pub use pipeline::{
    Blend, BlendEquation, BlendFactor, ColorState, Cull, DepthState, DepthWrite, FrontFace,
    Pipeline, PipelineDesc, PipelineError, Provoking, ShaderModule, Topology,
};
pub use raster::{
    AlphaToCoverage, AlphaToOne, LineState, LineStipple, MAX_LINE_WIDTH, MAX_POINT_SIZE,
    MultisampleState, PointSize, PointState, PolygonMode, PolygonOffset, PolygonState, RasterState,
    Rim, SampleCoverage, SampleRule, SpriteOrigin, Stipple,
};
pub use sight::Sight;
pub use watch::Watch;
