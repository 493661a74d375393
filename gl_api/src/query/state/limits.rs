//! Limits of the implementation and its version: GL 2.1, tables 6.34 to 6.37, and those of extensions.

use super::row::Read::*;
use super::row::{Row, doubles, rows, saturated};
use crate::base::assembly_limits::{MAX_PROGRAM_MATRICES, MAX_PROGRAM_MATRIX_STACK_DEPTH};
use crate::base::constants::*;
use crate::base::limits;
use crate::base::types::*;
use crate::context::Context;
use crate::glsl::limits::{MAX_CULL_DISTANCES, MAX_VIEWPORTS};
use crate::glsl::{GATHER_OFFSETS, MAX_UNIFORM_LOCATIONS, TEXEL_OFFSETS};
use crate::interface::*;
use crate::pixel::etc;
use crate::pixel::formats::{COMPRESSED_IN_ES, general_purpose_formats};
use crate::query::extensions::extensions_of;
use crate::state::matrix::{MAX_MODELVIEW_STACK_DEPTH, MAX_STACK_DEPTH};
use crate::state::multisample::MAX_SAMPLE_MASK_WORDS;
use rasterizer::driver::{MAX_LINE_WIDTH, MAX_POINT_SIZE};

/// Of one stage: its own uniforms and all of its blocks.
const COMBINED_UNIFORM_COMPONENTS: i32 = limits::MAX_UNIFORM_COMPONENTS
    + limits::MAX_UNIFORM_BLOCKS as i32 * (limits::MAX_UNIFORM_BLOCK_SIZE / 4) as i32;

/// The values of `GL_COMPRESSED_TEXTURE_FORMATS`; in OpenGL ES all formats of blocks are listed (3.0, section 3.8.6).
pub(crate) fn compressed_formats(context: &Context) -> Vec<GLenum> {
    if context.profile.is_es() {
        etc::names().chain(COMPRESSED_IN_ES.values()).collect()
    } else {
        general_purpose_formats()
    }
}

/// What a stage hands to the next one. GLSL ES has the limit in vectors, `gl_MaxVertexOutputVectors`, with the value of
/// `GL_MAX_VARYING_VECTORS`.
fn stage_components(context: &Context) -> i32 {
    let limit = if context.profile.is_es() {
        limits::MAX_VARYING_FLOATS
    } else {
        limits::MAX_STAGE_COMPONENTS.into()
    };
    saturated(limit)
}

pub(super) const ROWS: &[Row] = rows! {
    GL_MAJOR_VERSION: Integer(|c| saturated(c.profile.version().major));
    GL_MINOR_VERSION: Integer(|c| saturated(c.profile.version().minor));
    GL_NUM_EXTENSIONS: Integer(|c| saturated(extensions_of(c).len()));

    GL_MAX_LIGHTS: Integer(|_| saturated(MAX_LIGHTS));
    GL_MAX_CLIP_PLANES: Integer(|_| saturated(MAX_CLIP_PLANES));
    GL_MAX_CULL_DISTANCES: Integer(|_| saturated(MAX_CULL_DISTANCES));
    GL_MAX_COMBINED_CLIP_AND_CULL_DISTANCES: Integer(|_| saturated(MAX_CULL_DISTANCES));
    GL_MAX_MODELVIEW_STACK_DEPTH: Integer(|_| saturated(MAX_MODELVIEW_STACK_DEPTH));
    GL_MAX_PROJECTION_STACK_DEPTH: Integer(|_| saturated(MAX_STACK_DEPTH));
    GL_MAX_TEXTURE_STACK_DEPTH: Integer(|_| saturated(MAX_STACK_DEPTH));
    GL_MAX_VIEWPORT_DIMS: Integers(|_| vec![limits::MAX_VIEWPORT_DIMS as i32; 2]);
    GL_SUBPIXEL_BITS: Integer(|_| 8);
    GL_MAX_VIEWPORTS: Integer(|_| saturated(MAX_VIEWPORTS));
    GL_VIEWPORT_SUBPIXEL_BITS: Integer(|_| 8);
    GL_VIEWPORT_BOUNDS_RANGE: Floats(|_| {
        let limit = f64::from(2 * limits::MAX_VIEWPORT_DIMS);
        vec![-limit, limit]
    });
    GL_POINT_SIZE_RANGE: Floats(|_| doubles(&[1.0, MAX_POINT_SIZE]));
    GL_ALIASED_POINT_SIZE_RANGE: Floats(|_| doubles(&[1.0, MAX_POINT_SIZE]));
    GL_POINT_SIZE_GRANULARITY: Float(|_| 1.0 / 256.0);
    GL_LINE_WIDTH_RANGE: Floats(|_| doubles(&[1.0, MAX_LINE_WIDTH]));
    GL_ALIASED_LINE_WIDTH_RANGE: Floats(|_| doubles(&[1.0, MAX_LINE_WIDTH]));
    GL_LINE_WIDTH_GRANULARITY: Float(|_| 1.0 / 256.0);
    GL_MAX_ELEMENTS_VERTICES: Integer(|_| 1 << 20);
    GL_MAX_ELEMENTS_INDICES: Integer(|_| 1 << 20);
    // A double is exact.
    GL_MAX_ELEMENT_INDEX: Floats(|_| vec![u32::MAX.into()]);

    GL_MAX_TEXTURE_SIZE: Integer(|_| saturated(limits::MAX_TEXTURE_SIZE));
    GL_MAX_CUBE_MAP_TEXTURE_SIZE: Integer(|_| saturated(limits::MAX_TEXTURE_SIZE));
    GL_MAX_RECTANGLE_TEXTURE_SIZE: Integer(|_| saturated(limits::MAX_TEXTURE_SIZE));
    GL_MAX_RENDERBUFFER_SIZE: Integer(|_| saturated(limits::MAX_TEXTURE_SIZE));
    GL_MAX_3D_TEXTURE_SIZE: Integer(|_| saturated(limits::MAX_3D_TEXTURE_SIZE));
    GL_MAX_ARRAY_TEXTURE_LAYERS: Integer(|_| saturated(limits::MAX_ARRAY_TEXTURE_LAYERS));
    GL_MAX_TEXTURE_BUFFER_SIZE: Integer(|_| saturated(limits::MAX_TEXTURE_BUFFER_SIZE));
    GL_TEXTURE_BUFFER_OFFSET_ALIGNMENT:
        Integer(|_| saturated(limits::TEXTURE_BUFFER_OFFSET_ALIGNMENT));
    GL_MAX_TEXTURE_LOD_BIAS: Float(|_| limits::MAX_TEXTURE_LOD_BIAS);
    GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT: Float(|_| texunit::sampler::MAX_ANISOTROPY);
    GL_MAX_TEXTURE_UNITS: Integer(|_| saturated(MAX_TEXTURE_UNITS));
    GL_MAX_TEXTURE_COORDS: Integer(|_| saturated(MAX_TEXTURE_UNITS));
    GL_MAX_TEXTURE_IMAGE_UNITS: Integer(|_| saturated(MAX_TEXTURE_IMAGE_UNITS));
    GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS: Integer(|_| saturated(MAX_TEXTURE_IMAGE_UNITS));
    GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS: Integer(|_| saturated(MAX_COMBINED_TEXTURE_IMAGE_UNITS));
    GL_NUM_COMPRESSED_TEXTURE_FORMATS: Integer(|c| saturated(compressed_formats(c).len()));
    GL_COMPRESSED_TEXTURE_FORMATS:
        Integers(|c| compressed_formats(c).into_iter().map(|format| format as i32).collect());

    GL_MAX_COLOR_ATTACHMENTS: Integer(|_| saturated(limits::MAX_COLOR_ATTACHMENTS));
    GL_MAX_DRAW_BUFFERS: Integer(|_| saturated(limits::MAX_COLOR_ATTACHMENTS));
    GL_MAX_DUAL_SOURCE_DRAW_BUFFERS: Integer(|_| saturated(limits::MAX_DUAL_SOURCE_DRAW_BUFFERS));
    GL_MAX_SAMPLES: Integer(|_| saturated(limits::MAX_SAMPLES));
    GL_MAX_COLOR_TEXTURE_SAMPLES: Integer(|_| saturated(limits::MAX_SAMPLES));
    GL_MAX_DEPTH_TEXTURE_SAMPLES: Integer(|_| saturated(limits::MAX_SAMPLES));
    GL_MAX_INTEGER_SAMPLES: Integer(|_| saturated(limits::MAX_SAMPLES));
    GL_MAX_FRAMEBUFFER_WIDTH: Integer(|_| saturated(limits::MAX_VIEWPORT_DIMS));
    GL_MAX_FRAMEBUFFER_HEIGHT: Integer(|_| saturated(limits::MAX_VIEWPORT_DIMS));
    GL_MAX_FRAMEBUFFER_LAYERS: Integer(|_| saturated(limits::MAX_ARRAY_TEXTURE_LAYERS));
    GL_MAX_FRAMEBUFFER_SAMPLES: Integer(|_| saturated(limits::MAX_SAMPLES));
    GL_MAX_SAMPLE_MASK_WORDS: Integer(|_| saturated(MAX_SAMPLE_MASK_WORDS));

    GL_MAX_VERTEX_ATTRIBS: Integer(|_| saturated(MAX_VERTEX_ATTRIBS));
    GL_MAX_VERTEX_UNIFORM_COMPONENTS: Integer(|_| saturated(limits::MAX_UNIFORM_COMPONENTS));
    GL_MAX_FRAGMENT_UNIFORM_COMPONENTS: Integer(|_| saturated(limits::MAX_UNIFORM_COMPONENTS));
    GL_MAX_VERTEX_UNIFORM_VECTORS: Integer(|_| saturated(limits::MAX_UNIFORM_COMPONENTS / 4));
    GL_MAX_FRAGMENT_UNIFORM_VECTORS: Integer(|_| saturated(limits::MAX_UNIFORM_COMPONENTS / 4));
    GL_MAX_GEOMETRY_UNIFORM_COMPONENTS: Integer(|_| saturated(limits::MAX_UNIFORM_COMPONENTS));
    GL_MAX_GEOMETRY_TEXTURE_IMAGE_UNITS: Integer(|_| saturated(MAX_TEXTURE_IMAGE_UNITS));
    GL_MAX_GEOMETRY_INPUT_COMPONENTS: Integer(|_| saturated(limits::MAX_STAGE_COMPONENTS));
    GL_MAX_GEOMETRY_OUTPUT_COMPONENTS: Integer(|_| saturated(limits::MAX_STAGE_COMPONENTS));
    GL_MAX_GEOMETRY_OUTPUT_VERTICES: Integer(|_| saturated(limits::MAX_GEOMETRY_OUTPUT_VERTICES));
    GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS:
        Integer(|_| saturated(limits::MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS));
    GL_MAX_VERTEX_OUTPUT_COMPONENTS: Integer(stage_components);
    GL_MAX_FRAGMENT_INPUT_COMPONENTS: Integer(stage_components);
    GL_MAX_VARYING_FLOATS: Integer(|_| saturated(limits::MAX_VARYING_FLOATS));
    GL_MAX_VARYING_VECTORS: Integer(|_| saturated(limits::MAX_VARYING_FLOATS / 4));
    GL_SHADER_COMPILER: Flag(|_| true);
    GL_NUM_SHADER_BINARY_FORMATS: Integer(|_| 0);
    GL_SHADER_BINARY_FORMATS: Integers(|_| Vec::new());
    GL_MIN_PROGRAM_TEXEL_OFFSET: Integer(|_| saturated(*TEXEL_OFFSETS.start()));
    GL_MAX_PROGRAM_TEXEL_OFFSET: Integer(|_| saturated(*TEXEL_OFFSETS.end()));
    GL_MIN_PROGRAM_TEXTURE_GATHER_OFFSET_ARB: Integer(|_| saturated(*GATHER_OFFSETS.start()));
    GL_MAX_PROGRAM_TEXTURE_GATHER_OFFSET_ARB: Integer(|_| saturated(*GATHER_OFFSETS.end()));
    // Of a texture with four components the first is gathered.
    GL_MAX_PROGRAM_TEXTURE_GATHER_COMPONENTS_ARB: Integer(|_| 4);
    GL_MAX_PROGRAM_MATRICES_ARB: Integer(|_| saturated(MAX_PROGRAM_MATRICES));
    GL_MAX_PROGRAM_MATRIX_STACK_DEPTH_ARB: Integer(|_| saturated(MAX_PROGRAM_MATRIX_STACK_DEPTH));

    GL_MAX_TRANSFORM_FEEDBACK_BUFFERS: Integer(|_| saturated(limits::MAX_TRANSFORM_FEEDBACK_BUFFERS));
    GL_MAX_VERTEX_STREAMS: Integer(|_| saturated(limits::MAX_VERTEX_STREAMS));
    GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS:
        Integer(|_| saturated(limits::MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS));
    GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_COMPONENTS:
        Integer(|_| saturated(limits::MAX_TRANSFORM_FEEDBACK_SEPARATE_COMPONENTS));
    GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS:
        Integer(|_| saturated(limits::MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS));

    GL_MAX_VERTEX_ATTRIB_BINDINGS: Integer(|_| saturated(limits::MAX_VERTEX_ATTRIB_BINDINGS));
    GL_MAX_VERTEX_ATTRIB_RELATIVE_OFFSET:
        Integer(|_| saturated(limits::MAX_VERTEX_ATTRIB_RELATIVE_OFFSET));
    GL_MAX_UNIFORM_LOCATIONS: Integer(|_| saturated(MAX_UNIFORM_LOCATIONS));
    GL_MAX_VERTEX_UNIFORM_BLOCKS: Integer(|_| saturated(limits::MAX_UNIFORM_BLOCKS));
    GL_MAX_FRAGMENT_UNIFORM_BLOCKS: Integer(|_| saturated(limits::MAX_UNIFORM_BLOCKS));
    GL_MAX_GEOMETRY_UNIFORM_BLOCKS: Integer(|_| saturated(limits::MAX_UNIFORM_BLOCKS));
    GL_MAX_COMBINED_UNIFORM_BLOCKS: Integer(|_| saturated(3 * limits::MAX_UNIFORM_BLOCKS));
    GL_MAX_UNIFORM_BUFFER_BINDINGS: Integer(|_| saturated(limits::MAX_UNIFORM_BUFFER_BINDINGS));
    GL_MAX_UNIFORM_BLOCK_SIZE: Integer(|_| saturated(limits::MAX_UNIFORM_BLOCK_SIZE));
    GL_MAX_COMBINED_VERTEX_UNIFORM_COMPONENTS: Integer(|_| saturated(COMBINED_UNIFORM_COMPONENTS));
    GL_MAX_COMBINED_FRAGMENT_UNIFORM_COMPONENTS:
        Integer(|_| saturated(COMBINED_UNIFORM_COMPONENTS));
    GL_MAX_COMBINED_GEOMETRY_UNIFORM_COMPONENTS:
        Integer(|_| saturated(COMBINED_UNIFORM_COMPONENTS));
    GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT:
        Integer(|_| saturated(limits::UNIFORM_BUFFER_OFFSET_ALIGNMENT));
};
