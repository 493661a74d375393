//! The limits that `glGet` reports and that calls are checked against.

pub(crate) use glsl::limits::{
    MAX_GEOMETRY_OUTPUT_VERTICES, MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS, MAX_STAGE_COMPONENTS,
    MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS, MAX_TRANSFORM_FEEDBACK_SEPARATE_COMPONENTS,
    MAX_UNIFORM_BLOCK_SIZE, MAX_UNIFORM_BLOCKS, MAX_UNIFORM_COMPONENTS,
};

/// `GL_MAX_TEXTURE_SIZE`, `GL_MAX_CUBE_MAP_TEXTURE_SIZE` and `GL_MAX_RENDERBUFFER_SIZE`.
pub(crate) const MAX_TEXTURE_SIZE: u32 = 8192;
/// Levels of the largest texture: 8192 to 1.
pub(crate) const MAX_TEXTURE_LEVELS: usize = MAX_TEXTURE_SIZE.ilog2() as usize + 1;
/// `GL_MAX_3D_TEXTURE_SIZE`.
pub(crate) const MAX_3D_TEXTURE_SIZE: u32 = 512;
/// `GL_MAX_ARRAY_TEXTURE_LAYERS`.
pub(crate) const MAX_ARRAY_TEXTURE_LAYERS: u32 = 2048;
/// `GL_MAX_TEXTURE_BUFFER_SIZE`, in texels; of the largest ones they are as many bytes as can be
/// gathered from.
pub(crate) const MAX_TEXTURE_BUFFER_SIZE: u32 = 1 << 26;
/// `GL_TEXTURE_BUFFER_OFFSET_ALIGNMENT`: the size of the largest texel.
pub(crate) const TEXTURE_BUFFER_OFFSET_ALIGNMENT: usize = 16;
/// `GL_MAX_VIEWPORT_DIMS`, both.
pub(crate) const MAX_VIEWPORT_DIMS: u32 = 8192;
/// `GL_MAX_COLOR_ATTACHMENTS` and `GL_MAX_DRAW_BUFFERS`.
pub(crate) const MAX_COLOR_ATTACHMENTS: usize = glsl::limits::MAX_DRAW_BUFFERS as usize;
/// `GL_MAX_DUAL_SOURCE_DRAW_BUFFERS`.
pub(crate) const MAX_DUAL_SOURCE_DRAW_BUFFERS: usize =
    glsl::limits::MAX_DUAL_SOURCE_DRAW_BUFFERS as usize;
/// `GL_MAX_SAMPLES`.
pub(crate) const MAX_SAMPLES: u8 = rasterizer::driver::MAX_SAMPLES as u8;
/// `GL_MAX_TEXTURE_LOD_BIAS`.
pub(crate) const MAX_TEXTURE_LOD_BIAS: f32 = 16.0;
/// `GL_MAX_VERTEX_ATTRIB_BINDINGS`.
pub(crate) const MAX_VERTEX_ATTRIB_BINDINGS: usize = glsl::limits::MAX_VERTEX_ATTRIBS as usize;
/// `GL_MAX_VERTEX_ATTRIB_RELATIVE_OFFSET`.
pub(crate) const MAX_VERTEX_ATTRIB_RELATIVE_OFFSET: u32 = 2047;
/// `GL_MAX_UNIFORM_BUFFER_BINDINGS`.
pub(crate) const MAX_UNIFORM_BUFFER_BINDINGS: usize = glsl::limits::MAX_UNIFORM_BUFFER_BINDINGS;
/// `GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT`: what rows of blocks in one buffer are a multiple of.
pub(crate) const UNIFORM_BUFFER_OFFSET_ALIGNMENT: usize = 16;
/// `GL_MAX_VARYING_FLOATS`.
pub(crate) const MAX_VARYING_FLOATS: i32 = glsl::limits::MAX_VARYING_FLOATS as i32;
/// The largest buffer object, in bytes.
pub(crate) const MAX_BUFFER_SIZE: usize = 1 << 31;
/// `GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS`: the buffers that transform feedback fills at once.
pub(crate) const MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS: usize = 4;
/// `GL_MAX_TRANSFORM_FEEDBACK_BUFFERS`: the same of interleaved capture.
pub(crate) const MAX_TRANSFORM_FEEDBACK_BUFFERS: usize = MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS;
/// `GL_MAX_VERTEX_STREAMS`: several are of `ARB_gpu_shader5`.
pub(crate) const MAX_VERTEX_STREAMS: u32 = 1;

/// How many attribute locations there are, conventional ones included; see [`crate::interface`].
pub(crate) const LOCATIONS: usize = 32;
