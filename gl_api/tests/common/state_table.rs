//! The state that `glGet` reads, as the tables of GL 2.1, section 6.2 list it: the name, what it is
//! at first in a window of 16×8 pixels, and what becomes of it as integers.

use gl_api::*;

/// How a value becomes an integer (GL 2.1, section 6.1.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum As {
    /// Rounded.
    Number,
    /// 1.0 becomes the largest integer, -1.0 the least.
    Fraction,
}

use As::{Fraction, Number};

/// A row: name, conversion, initial value.
pub type Row = (GLenum, As, &'static [f64]);

const T: &[f64] = &[1.0];
const F: &[f64] = &[0.0];
const ONES: &[f64] = &[u32::MAX as f64];
const IDENTITY: &[f64] =
    &[1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

macro_rules! rows {
    ($($table:literal { $($name:ident $as:ident $value:expr;)* })*) => {
        &[$($(($name, $as, $value)),*),*]
    };
}

macro_rules! enums {
    ($($value:ident),*) => { &[$($value as f64),*] };
}

/// Every row of the tables that `glGet` answers, but what an implementation chooses.
pub const STATE: &[Row] = rows! {
    "6.5, current values" {
        GL_CURRENT_COLOR Fraction &[1.0; 4];
        GL_CURRENT_SECONDARY_COLOR Fraction &[0.0, 0.0, 0.0, 1.0];
        GL_CURRENT_INDEX Number T;
        GL_CURRENT_TEXTURE_COORDS Number &[0.0, 0.0, 0.0, 1.0];
        GL_CURRENT_NORMAL Fraction &[0.0, 0.0, 1.0];
        GL_CURRENT_FOG_COORD Number F;
        GL_CURRENT_RASTER_POSITION Number &[0.0, 0.0, 0.0, 1.0];
        GL_CURRENT_RASTER_DISTANCE Number F;
        GL_CURRENT_RASTER_COLOR Fraction &[1.0; 4];
        GL_CURRENT_RASTER_SECONDARY_COLOR Fraction &[0.0, 0.0, 0.0, 1.0];
        GL_CURRENT_RASTER_INDEX Number T;
        GL_CURRENT_RASTER_TEXTURE_COORDS Number &[0.0, 0.0, 0.0, 1.0];
        GL_CURRENT_RASTER_POSITION_VALID Number T;
        GL_EDGE_FLAG Number T;
    }
    "6.6 to 6.9, vertex arrays" {
        GL_CLIENT_ACTIVE_TEXTURE Number enums![GL_TEXTURE0];
        GL_VERTEX_ARRAY Number F;
        GL_VERTEX_ARRAY_SIZE Number &[4.0];
        GL_VERTEX_ARRAY_TYPE Number enums![GL_FLOAT];
        GL_VERTEX_ARRAY_STRIDE Number F;
        GL_NORMAL_ARRAY Number F;
        GL_NORMAL_ARRAY_TYPE Number enums![GL_FLOAT];
        GL_NORMAL_ARRAY_STRIDE Number F;
        GL_FOG_COORD_ARRAY Number F;
        GL_FOG_COORD_ARRAY_TYPE Number enums![GL_FLOAT];
        GL_FOG_COORD_ARRAY_STRIDE Number F;
        GL_COLOR_ARRAY Number F;
        GL_COLOR_ARRAY_SIZE Number &[4.0];
        GL_COLOR_ARRAY_TYPE Number enums![GL_FLOAT];
        GL_COLOR_ARRAY_STRIDE Number F;
        GL_SECONDARY_COLOR_ARRAY Number F;
        GL_SECONDARY_COLOR_ARRAY_SIZE Number &[3.0];
        GL_SECONDARY_COLOR_ARRAY_TYPE Number enums![GL_FLOAT];
        GL_SECONDARY_COLOR_ARRAY_STRIDE Number F;
        GL_INDEX_ARRAY Number F;
        GL_INDEX_ARRAY_TYPE Number enums![GL_FLOAT];
        GL_INDEX_ARRAY_STRIDE Number F;
        GL_TEXTURE_COORD_ARRAY Number F;
        GL_TEXTURE_COORD_ARRAY_SIZE Number &[4.0];
        GL_TEXTURE_COORD_ARRAY_TYPE Number enums![GL_FLOAT];
        GL_TEXTURE_COORD_ARRAY_STRIDE Number F;
        GL_EDGE_FLAG_ARRAY Number F;
        GL_EDGE_FLAG_ARRAY_STRIDE Number F;
        GL_ARRAY_BUFFER_BINDING Number F;
        GL_VERTEX_ARRAY_BUFFER_BINDING Number F;
        GL_NORMAL_ARRAY_BUFFER_BINDING Number F;
        GL_COLOR_ARRAY_BUFFER_BINDING Number F;
        GL_INDEX_ARRAY_BUFFER_BINDING Number F;
        GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING Number F;
        GL_EDGE_FLAG_ARRAY_BUFFER_BINDING Number F;
        GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING Number F;
        GL_FOG_COORD_ARRAY_BUFFER_BINDING Number F;
        GL_ELEMENT_ARRAY_BUFFER_BINDING Number F;
        GL_TRANSFORM_FEEDBACK_BUFFER_BINDING Number F;
        GL_UNIFORM_BUFFER_BINDING Number F;
        GL_VERTEX_ARRAY_BINDING Number F;
        GL_PRIMITIVE_RESTART Number F;
        GL_PRIMITIVE_RESTART_INDEX Number F;
    }
    "6.11, transformation" {
        GL_MODELVIEW_MATRIX Number IDENTITY;
        GL_PROJECTION_MATRIX Number IDENTITY;
        GL_TEXTURE_MATRIX Number IDENTITY;
        GL_TRANSPOSE_MODELVIEW_MATRIX Number IDENTITY;
        GL_TRANSPOSE_PROJECTION_MATRIX Number IDENTITY;
        GL_TRANSPOSE_TEXTURE_MATRIX Number IDENTITY;
        GL_VIEWPORT Number &[0.0, 0.0, 16.0, 8.0];
        GL_DEPTH_RANGE Fraction &[0.0, 1.0];
        GL_LAYER_PROVOKING_VERTEX Number enums![GL_PROVOKING_VERTEX];
        GL_VIEWPORT_INDEX_PROVOKING_VERTEX Number enums![GL_PROVOKING_VERTEX];
        GL_CLIP_ORIGIN Number enums![GL_LOWER_LEFT];
        GL_CLIP_DEPTH_MODE Number enums![GL_NEGATIVE_ONE_TO_ONE];
        GL_MODELVIEW_STACK_DEPTH Number T;
        GL_PROJECTION_STACK_DEPTH Number T;
        GL_TEXTURE_STACK_DEPTH Number T;
        GL_MATRIX_MODE Number enums![GL_MODELVIEW];
        GL_NORMALIZE Number F;
        GL_RESCALE_NORMAL Number F;
        GL_CLIP_PLANE0 Number F;
        GL_CLIP_PLANE1 Number F;
        GL_CLIP_PLANE2 Number F;
        GL_CLIP_PLANE3 Number F;
        GL_CLIP_PLANE4 Number F;
        GL_CLIP_PLANE5 Number F;
        GL_CLIP_DISTANCE6 Number F;
        GL_CLIP_DISTANCE7 Number F;
    }
    "6.12, colouring" {
        GL_FOG_COLOR Fraction &[0.0; 4];
        GL_FOG_INDEX Number F;
        GL_FOG_DENSITY Number T;
        GL_FOG_START Number F;
        GL_FOG_END Number T;
        GL_FOG_MODE Number enums![GL_EXP];
        GL_FOG Number F;
        GL_FOG_COORD_SRC Number enums![GL_FRAGMENT_DEPTH];
        GL_COLOR_SUM Number F;
        GL_SHADE_MODEL Number enums![GL_SMOOTH];
        GL_PROVOKING_VERTEX Number enums![GL_LAST_VERTEX_CONVENTION];
        GL_QUADS_FOLLOW_PROVOKING_VERTEX_CONVENTION Number T;
    }
    "6.13 and 6.14, lighting" {
        GL_LIGHTING Number F;
        GL_COLOR_MATERIAL Number F;
        GL_COLOR_MATERIAL_PARAMETER Number enums![GL_AMBIENT_AND_DIFFUSE];
        GL_COLOR_MATERIAL_FACE Number enums![GL_FRONT_AND_BACK];
        GL_LIGHT_MODEL_AMBIENT Fraction
            &[0.2_f32 as f64, 0.2_f32 as f64, 0.2_f32 as f64, 1.0];
        GL_LIGHT_MODEL_LOCAL_VIEWER Number F;
        GL_LIGHT_MODEL_TWO_SIDE Number F;
        GL_CLAMP_VERTEX_COLOR Number T;
        GL_LIGHT_MODEL_COLOR_CONTROL Number enums![GL_SINGLE_COLOR];
        GL_LIGHT0 Number F;
        GL_LIGHT1 Number F;
        GL_LIGHT2 Number F;
        GL_LIGHT3 Number F;
        GL_LIGHT4 Number F;
        GL_LIGHT5 Number F;
        GL_LIGHT6 Number F;
        GL_LIGHT7 Number F;
    }
    "6.15, rasterization" {
        GL_POINT_SIZE Number T;
        GL_POINT_SMOOTH Number F;
        GL_POINT_SPRITE Number F;
        GL_POINT_SIZE_MIN Number F;
        GL_POINT_FADE_THRESHOLD_SIZE Number T;
        GL_POINT_DISTANCE_ATTENUATION Number &[1.0, 0.0, 0.0];
        GL_POINT_SPRITE_COORD_ORIGIN Number enums![GL_UPPER_LEFT];
        GL_LINE_WIDTH Number T;
        GL_LINE_SMOOTH Number F;
        GL_LINE_STIPPLE_PATTERN Number &[65535.0];
        GL_LINE_STIPPLE_REPEAT Number T;
        GL_LINE_STIPPLE Number F;
        GL_CULL_FACE Number F;
        GL_CULL_FACE_MODE Number enums![GL_BACK];
        GL_FRONT_FACE Number enums![GL_CCW];
        GL_POLYGON_SMOOTH Number F;
        GL_POLYGON_MODE Number enums![GL_FILL, GL_FILL];
        GL_POLYGON_OFFSET_FACTOR Number F;
        GL_POLYGON_OFFSET_UNITS Number F;
        GL_POLYGON_OFFSET_CLAMP Number F;
        GL_POLYGON_OFFSET_POINT Number F;
        GL_POLYGON_OFFSET_LINE Number F;
        GL_POLYGON_OFFSET_FILL Number F;
        GL_POLYGON_STIPPLE Number F;
    }
    "6.16, multisampling" {
        GL_MULTISAMPLE Number T;
        GL_SAMPLE_ALPHA_TO_COVERAGE Number F;
        GL_SAMPLE_ALPHA_TO_ONE Number F;
        GL_SAMPLE_COVERAGE Number F;
        GL_SAMPLE_COVERAGE_VALUE Number T;
        GL_SAMPLE_COVERAGE_INVERT Number F;
        GL_SAMPLE_MASK Number F;
        GL_SAMPLE_SHADING Number F;
        GL_MIN_SAMPLE_SHADING_VALUE Number F;
    }
    "6.17 to 6.20, textures" {
        GL_TEXTURE_1D Number F;
        GL_TEXTURE_2D Number F;
        GL_TEXTURE_3D Number F;
        GL_TEXTURE_CUBE_MAP Number F;
        GL_TEXTURE_RECTANGLE Number F;
        GL_TEXTURE_BINDING_1D Number F;
        GL_TEXTURE_BINDING_2D Number F;
        GL_TEXTURE_BINDING_3D Number F;
        GL_TEXTURE_BINDING_CUBE_MAP Number F;
        GL_TEXTURE_BINDING_RECTANGLE Number F;
        GL_TEXTURE_BINDING_1D_ARRAY Number F;
        GL_TEXTURE_BINDING_2D_ARRAY Number F;
        GL_TEXTURE_BINDING_CUBE_MAP_ARRAY Number F;
        GL_TEXTURE_BINDING_2D_MULTISAMPLE Number F;
        GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY Number F;
        GL_SAMPLER_BINDING Number F;
        GL_ACTIVE_TEXTURE Number enums![GL_TEXTURE0];
        GL_TEXTURE_GEN_S Number F;
        GL_TEXTURE_GEN_T Number F;
        GL_TEXTURE_GEN_R Number F;
        GL_TEXTURE_GEN_Q Number F;
    }
    "6.21, pixel operations" {
        GL_SCISSOR_TEST Number F;
        GL_RASTERIZER_DISCARD Number F;
        GL_SCISSOR_BOX Number &[0.0, 0.0, 16.0, 8.0];
        GL_ALPHA_TEST Number F;
        GL_ALPHA_TEST_FUNC Number enums![GL_ALWAYS];
        GL_ALPHA_TEST_REF Fraction F;
        GL_STENCIL_TEST Number F;
        GL_STENCIL_FUNC Number enums![GL_ALWAYS];
        GL_STENCIL_VALUE_MASK Number ONES;
        GL_STENCIL_REF Number F;
        GL_STENCIL_FAIL Number enums![GL_KEEP];
        GL_STENCIL_PASS_DEPTH_FAIL Number enums![GL_KEEP];
        GL_STENCIL_PASS_DEPTH_PASS Number enums![GL_KEEP];
        GL_STENCIL_BACK_FUNC Number enums![GL_ALWAYS];
        GL_STENCIL_BACK_VALUE_MASK Number ONES;
        GL_STENCIL_BACK_REF Number F;
        GL_STENCIL_BACK_FAIL Number enums![GL_KEEP];
        GL_STENCIL_BACK_PASS_DEPTH_FAIL Number enums![GL_KEEP];
        GL_STENCIL_BACK_PASS_DEPTH_PASS Number enums![GL_KEEP];
        GL_STENCIL_TEST_TWO_SIDE_EXT Number F;
        GL_ACTIVE_STENCIL_FACE_EXT Number enums![GL_FRONT];
        GL_DEPTH_TEST Number F;
        GL_DEPTH_FUNC Number enums![GL_LESS];
        GL_BLEND Number F;
        GL_BLEND_SRC_RGB Number T;
        GL_BLEND_SRC_ALPHA Number T;
        GL_BLEND_DST_RGB Number F;
        GL_BLEND_DST_ALPHA Number F;
        GL_BLEND_SRC Number T;
        GL_BLEND_DST Number F;
        GL_BLEND_EQUATION_RGB Number enums![GL_FUNC_ADD];
        GL_BLEND_EQUATION_ALPHA Number enums![GL_FUNC_ADD];
        GL_BLEND_COLOR Fraction &[0.0; 4];
        GL_DITHER Number T;
        GL_INDEX_LOGIC_OP Number F;
        GL_COLOR_LOGIC_OP Number F;
        GL_LOGIC_OP_MODE Number enums![GL_COPY];
        GL_CLAMP_FRAGMENT_COLOR Number enums![GL_FIXED_ONLY];
        GL_CLAMP_READ_COLOR Number enums![GL_FIXED_ONLY];
        GL_RGBA_FLOAT_MODE_ARB Number F;
        GL_FRAMEBUFFER_SRGB Number F;
    }
    "6.22, framebuffer control" {
        GL_INDEX_WRITEMASK Number ONES;
        GL_COLOR_WRITEMASK Number &[1.0; 4];
        GL_DEPTH_WRITEMASK Number T;
        GL_STENCIL_WRITEMASK Number ONES;
        GL_STENCIL_BACK_WRITEMASK Number ONES;
        GL_COLOR_CLEAR_VALUE Fraction &[0.0; 4];
        GL_INDEX_CLEAR_VALUE Number F;
        GL_DEPTH_CLEAR_VALUE Fraction T;
        GL_STENCIL_CLEAR_VALUE Number F;
        GL_ACCUM_CLEAR_VALUE Fraction &[0.0; 4];
        GL_FRAMEBUFFER_BINDING Number F;
        GL_READ_FRAMEBUFFER_BINDING Number F;
        GL_RENDERBUFFER_BINDING Number F;
    }
    "6.23, pixels" {
        GL_UNPACK_SWAP_BYTES Number F;
        GL_UNPACK_LSB_FIRST Number F;
        GL_UNPACK_IMAGE_HEIGHT Number F;
        GL_UNPACK_SKIP_IMAGES Number F;
        GL_UNPACK_ROW_LENGTH Number F;
        GL_UNPACK_SKIP_ROWS Number F;
        GL_UNPACK_SKIP_PIXELS Number F;
        GL_UNPACK_ALIGNMENT Number &[4.0];
        GL_PACK_SWAP_BYTES Number F;
        GL_PACK_LSB_FIRST Number F;
        GL_PACK_IMAGE_HEIGHT Number F;
        GL_PACK_SKIP_IMAGES Number F;
        GL_PACK_ROW_LENGTH Number F;
        GL_PACK_SKIP_ROWS Number F;
        GL_PACK_SKIP_PIXELS Number F;
        GL_PACK_ALIGNMENT Number &[4.0];
        GL_PIXEL_PACK_BUFFER_BINDING Number F;
        GL_PIXEL_UNPACK_BUFFER_BINDING Number F;
        GL_MAP_COLOR Number F;
        GL_MAP_STENCIL Number F;
        GL_INDEX_SHIFT Number F;
        GL_INDEX_OFFSET Number F;
        GL_RED_SCALE Number T;
        GL_GREEN_SCALE Number T;
        GL_BLUE_SCALE Number T;
        GL_ALPHA_SCALE Number T;
        GL_DEPTH_SCALE Number T;
        GL_RED_BIAS Number F;
        GL_GREEN_BIAS Number F;
        GL_BLUE_BIAS Number F;
        GL_ALPHA_BIAS Number F;
        GL_DEPTH_BIAS Number F;
    }
    "6.30, pixels, continued" {
        GL_ZOOM_X Number T;
        GL_ZOOM_Y Number T;
        GL_PIXEL_MAP_I_TO_I_SIZE Number T;
        GL_PIXEL_MAP_S_TO_S_SIZE Number T;
        GL_PIXEL_MAP_I_TO_R_SIZE Number T;
        GL_PIXEL_MAP_I_TO_G_SIZE Number T;
        GL_PIXEL_MAP_I_TO_B_SIZE Number T;
        GL_PIXEL_MAP_I_TO_A_SIZE Number T;
        GL_PIXEL_MAP_R_TO_R_SIZE Number T;
        GL_PIXEL_MAP_G_TO_G_SIZE Number T;
        GL_PIXEL_MAP_B_TO_B_SIZE Number T;
        GL_PIXEL_MAP_A_TO_A_SIZE Number T;
    }
    "6.31, evaluators" {
        GL_MAP1_COLOR_4 Number F;
        GL_MAP1_INDEX Number F;
        GL_MAP1_NORMAL Number F;
        GL_MAP1_TEXTURE_COORD_1 Number F;
        GL_MAP1_TEXTURE_COORD_2 Number F;
        GL_MAP1_TEXTURE_COORD_3 Number F;
        GL_MAP1_TEXTURE_COORD_4 Number F;
        GL_MAP1_VERTEX_3 Number F;
        GL_MAP1_VERTEX_4 Number F;
        GL_MAP2_COLOR_4 Number F;
        GL_MAP2_INDEX Number F;
        GL_MAP2_NORMAL Number F;
        GL_MAP2_TEXTURE_COORD_1 Number F;
        GL_MAP2_TEXTURE_COORD_2 Number F;
        GL_MAP2_TEXTURE_COORD_3 Number F;
        GL_MAP2_TEXTURE_COORD_4 Number F;
        GL_MAP2_VERTEX_3 Number F;
        GL_MAP2_VERTEX_4 Number F;
        GL_MAP1_GRID_DOMAIN Number &[0.0, 1.0];
        GL_MAP2_GRID_DOMAIN Number &[0.0, 1.0, 0.0, 1.0];
        GL_MAP1_GRID_SEGMENTS Number T;
        GL_MAP2_GRID_SEGMENTS Number &[1.0, 1.0];
        GL_AUTO_NORMAL Number F;
    }
    "6.33 to 6.35, programs" {
        GL_CURRENT_PROGRAM Number F;
        GL_PROGRAM_PIPELINE_BINDING Number F;
        GL_VERTEX_PROGRAM_TWO_SIDE Number F;
        GL_VERTEX_PROGRAM_POINT_SIZE Number F;
        GL_VERTEX_PROGRAM_ARB Number F;
        GL_FRAGMENT_PROGRAM_ARB Number F;
        GL_PROGRAM_ERROR_POSITION_ARB Number &[-1.0];
        GL_CURRENT_MATRIX_ARB Number IDENTITY;
        GL_TRANSPOSE_CURRENT_MATRIX_ARB Number IDENTITY;
        GL_CURRENT_MATRIX_STACK_DEPTH_ARB Number T;
    }
    "6.36, hints" {
        GL_PERSPECTIVE_CORRECTION_HINT Number enums![GL_DONT_CARE];
        GL_POINT_SMOOTH_HINT Number enums![GL_DONT_CARE];
        GL_LINE_SMOOTH_HINT Number enums![GL_DONT_CARE];
        GL_POLYGON_SMOOTH_HINT Number enums![GL_DONT_CARE];
        GL_FOG_HINT Number enums![GL_DONT_CARE];
        GL_GENERATE_MIPMAP_HINT Number enums![GL_DONT_CARE];
        GL_TEXTURE_COMPRESSION_HINT Number enums![GL_DONT_CARE];
        GL_FRAGMENT_SHADER_DERIVATIVE_HINT Number enums![GL_DONT_CARE];
    }
    "6.41, miscellaneous" {
        GL_LIST_BASE Number F;
        GL_LIST_INDEX Number F;
        GL_LIST_MODE Number F;
        GL_ATTRIB_STACK_DEPTH Number F;
        GL_CLIENT_ATTRIB_STACK_DEPTH Number F;
        GL_NAME_STACK_DEPTH Number F;
        GL_RENDER_MODE Number enums![GL_RENDER];
        GL_SELECTION_BUFFER_SIZE Number F;
        GL_FEEDBACK_BUFFER_SIZE Number F;
        GL_FEEDBACK_BUFFER_TYPE Number enums![GL_2D];
        GL_DEBUG_GROUP_STACK_DEPTH Number T;
    }
};

/// What an implementation chooses (tables 6.37 to 6.40): at least this.
pub const LEAST: &[Row] = rows! {
    "6.37" {
        GL_MAX_LIGHTS Number &[8.0];
        GL_MAX_CLIP_PLANES Number &[6.0];
        GL_MAX_CULL_DISTANCES Number &[8.0];
        GL_MAX_COMBINED_CLIP_AND_CULL_DISTANCES Number &[8.0];
        GL_MAX_MODELVIEW_STACK_DEPTH Number &[32.0];
        GL_MAX_PROJECTION_STACK_DEPTH Number &[2.0];
        GL_MAX_TEXTURE_STACK_DEPTH Number &[2.0];
        GL_SUBPIXEL_BITS Number &[4.0];
        GL_MAX_3D_TEXTURE_SIZE Number &[16.0];
        GL_MAX_TEXTURE_SIZE Number &[64.0];
        GL_MAX_TEXTURE_LOD_BIAS Number &[2.0];
        GL_MAX_CUBE_MAP_TEXTURE_SIZE Number &[16.0];
        GL_MAX_PIXEL_MAP_TABLE Number &[32.0];
        GL_MAX_NAME_STACK_DEPTH Number &[64.0];
        GL_MAX_LIST_NESTING Number &[64.0];
        GL_MAX_EVAL_ORDER Number &[8.0];
        GL_MAX_VIEWPORT_DIMS Number &[16.0, 8.0];
        GL_MAX_VIEWPORTS Number &[16.0];
        GL_VIEWPORT_SUBPIXEL_BITS Number F;
        GL_VIEWPORT_BOUNDS_RANGE Number &[-16384.0, 16383.0];
    }
    "6.38" {
        GL_MAX_ATTRIB_STACK_DEPTH Number &[16.0];
        GL_MAX_CLIENT_ATTRIB_STACK_DEPTH Number &[16.0];
        GL_AUX_BUFFERS Number F;
        GL_RGBA_MODE Number T;
        GL_INDEX_MODE Number F;
        GL_DOUBLEBUFFER Number F;
        GL_STEREO Number F;
        GL_ALIASED_POINT_SIZE_RANGE Number &[1.0, 1.0];
        GL_SMOOTH_POINT_SIZE_RANGE Number &[1.0, 1.0];
        GL_SMOOTH_POINT_SIZE_GRANULARITY Number F;
        GL_ALIASED_LINE_WIDTH_RANGE Number &[1.0, 1.0];
        GL_SMOOTH_LINE_WIDTH_RANGE Number &[1.0, 1.0];
        GL_SMOOTH_LINE_WIDTH_GRANULARITY Number F;
        GL_MAX_ELEMENTS_INDICES Number F;
        GL_MAX_ELEMENTS_VERTICES Number F;
        GL_NUM_COMPRESSED_TEXTURE_FORMATS Number F;
        GL_POINT_SIZE_MAX Number T;
    }
    "6.39" {
        GL_MAX_TEXTURE_UNITS Number &[2.0];
        GL_MAX_VERTEX_ATTRIBS Number &[16.0];
        GL_MAX_VERTEX_UNIFORM_COMPONENTS Number &[1024.0];
        GL_MAX_VARYING_FLOATS Number &[64.0];
        GL_MAX_PROGRAM_TEXEL_OFFSET Number &[7.0];
        GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS Number &[16.0];
        GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS Number &[16.0];
        GL_MAX_TEXTURE_IMAGE_UNITS Number &[16.0];
        GL_MAX_TEXTURE_COORDS Number &[8.0];
        GL_MAX_FRAGMENT_UNIFORM_COMPONENTS Number &[1024.0];
        GL_MAX_DRAW_BUFFERS Number &[8.0];
        GL_MAX_PROGRAM_MATRICES_ARB Number &[8.0];
        GL_MAX_PROGRAM_MATRIX_STACK_DEPTH_ARB Number T;
        GL_MAX_COLOR_ATTACHMENTS Number &[8.0];
        GL_MAX_RENDERBUFFER_SIZE Number &[1024.0];
        GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS Number &[64.0];
        GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS Number &[4.0];
        GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_COMPONENTS Number &[4.0];
        GL_MAX_SAMPLES Number &[4.0];
        GL_MAX_COLOR_TEXTURE_SAMPLES Number T;
        GL_MAX_DEPTH_TEXTURE_SAMPLES Number T;
        GL_MAX_INTEGER_SAMPLES Number T;
        GL_MAX_SAMPLE_MASK_WORDS Number T;
    }
    "ARB_uniform_buffer_object" {
        GL_MAX_VERTEX_ATTRIB_BINDINGS Number &[16.0];
        GL_MAX_VERTEX_ATTRIB_RELATIVE_OFFSET Number &[2047.0];
        GL_MAX_UNIFORM_LOCATIONS Number &[1024.0];
        GL_MAX_VERTEX_UNIFORM_BLOCKS Number &[12.0];
        GL_MAX_FRAGMENT_UNIFORM_BLOCKS Number &[12.0];
        GL_MAX_GEOMETRY_UNIFORM_BLOCKS Number F;
        GL_MAX_COMBINED_UNIFORM_BLOCKS Number &[24.0];
        GL_MAX_UNIFORM_BUFFER_BINDINGS Number &[24.0];
        GL_MAX_UNIFORM_BLOCK_SIZE Number &[16384.0];
        GL_MAX_COMBINED_VERTEX_UNIFORM_COMPONENTS Number &[50176.0];
        GL_MAX_COMBINED_FRAGMENT_UNIFORM_COMPONENTS Number &[50176.0];
        GL_MAX_COMBINED_GEOMETRY_UNIFORM_COMPONENTS Number F;
        GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT Number T;
    }
    "ARB_ES2_compatibility" {
        GL_SHADER_COMPILER Number T;
        GL_NUM_SHADER_BINARY_FORMATS Number F;
        GL_MAX_VERTEX_UNIFORM_VECTORS Number &[128.0];
        GL_MAX_FRAGMENT_UNIFORM_VECTORS Number &[16.0];
        GL_MAX_VARYING_VECTORS Number &[8.0];
    }
    "6.40" {
        GL_RED_BITS Number &[8.0];
        GL_GREEN_BITS Number &[8.0];
        GL_BLUE_BITS Number &[8.0];
        GL_ALPHA_BITS Number &[8.0];
        GL_INDEX_BITS Number F;
        GL_DEPTH_BITS Number &[24.0];
        GL_STENCIL_BITS Number &[8.0];
        GL_ACCUM_RED_BITS Number &[16.0];
        GL_ACCUM_GREEN_BITS Number &[16.0];
        GL_ACCUM_BLUE_BITS Number &[16.0];
        GL_ACCUM_ALPHA_BITS Number &[16.0];
        GL_SAMPLE_BUFFERS Number F;
        GL_SAMPLES Number F;
        GL_MAJOR_VERSION Number &[3.0];
        GL_MINOR_VERSION Number &[1.0];
        GL_CONTEXT_FLAGS Number F;
        GL_NUM_EXTENSIONS Number T;
    }
};

/// What `glGetDoublev` answers; `None` where it refuses.
pub fn get(c: &mut Context, name: GLenum) -> Option<Vec<f64>> {
    let mut values = [f64::NAN; 256];
    c.get_doublev(name, &mut values);
    if c.get_error() != GL_NO_ERROR {
        return None;
    }
    let count = values.iter().position(|value| value.is_nan()).unwrap_or(values.len());
    Some(values[..count].to_vec())
}
