//! The descriptions that a client passes to the driver: plain data without behaviour.

mod blend;
mod buffer;
mod counter;
mod depth_stencil;
mod index;
mod mask;
mod output;
mod pipeline;
mod primitive;
mod raster;
mod vertex;
mod viewport;

pub use blend::{Blend, BlendEquation, BlendFactor, ColorState};
pub use buffer::{Buffer, Version};
pub use counter::Counter;
pub use depth_stencil::{DepthState, DepthWrite, StencilFace, StencilOp, StencilState};
pub use index::{IndexType, Indices};
pub use mask::{MaskBlock, PixelMask};
pub use output::{LogicOp, OutputState, SrgbWrite};
pub use pipeline::{PipelineDesc, PipelineError, ShaderModule};
pub(crate) use primitive::PrimitiveClass;
pub use primitive::{Cull, Facing, FrontFace, Provoking, Topology};
pub use raster::{
    AlphaToCoverage, AlphaToOne, Antialiasing, LineState, LineStipple, MAX_LINE_WIDTH,
    MAX_POINT_SIZE, MultisampleState, PointSize, PointState, PolygonMode, PolygonOffset,
    PolygonState, PolygonSubject, RasterState, SampleCoverage, SampleRule, SampleShading,
    SpriteOrigin, Stipple, ViewSides,
};
pub use vertex::{VertexBinding, VertexFormat, VertexSource, VertexType};
pub(crate) use viewport::DepthTransform;
pub use viewport::{
    ClipControl, ClipDepth, ClipOrigin, DepthClip, MAX_VIEWPORTS, Rect, ScissoredViewport, Viewport,
};
