//! `glGetError`, `glGetString` and the conversions of `glGet`: GL 2.1, section 6.1.2.

use super::put;
use super::table::{Value, state_value};
use crate::constants::*;
use crate::context::Context;
use crate::env::unit_to_signed;
use crate::error::{Result, Table};
use crate::types::*;

/// The extensions that are implemented whole.
pub(crate) const EXTENSIONS: &str = "\
    GL_ARB_depth_buffer_float GL_ARB_depth_texture GL_ARB_draw_buffers GL_ARB_framebuffer_object \
    GL_ARB_framebuffer_sRGB GL_ARB_half_float_pixel GL_ARB_multitexture \
    GL_ARB_pixel_buffer_object GL_ARB_sampler_objects GL_ARB_seamless_cube_map GL_ARB_shadow \
    GL_ARB_texture_border_clamp GL_ARB_texture_compression GL_ARB_texture_compression_rgtc \
    GL_ARB_texture_cube_map GL_ARB_texture_env_add GL_ARB_texture_env_combine \
    GL_ARB_texture_env_crossbar GL_ARB_texture_env_dot3 GL_ARB_texture_float \
    GL_ARB_texture_mirrored_repeat GL_ARB_texture_non_power_of_two GL_ARB_texture_rectangle \
    GL_ARB_texture_rg GL_ARB_texture_swizzle GL_ARB_transpose_matrix GL_ATI_texture_mirror_once \
    GL_EXT_bgra GL_EXT_blend_color GL_EXT_blend_equation_separate GL_EXT_blend_func_separate \
    GL_EXT_blend_minmax GL_EXT_blend_subtract GL_EXT_draw_buffers2 GL_EXT_fog_coord \
    GL_EXT_framebuffer_blit GL_EXT_framebuffer_object GL_EXT_framebuffer_sRGB \
    GL_EXT_packed_depth_stencil GL_EXT_packed_float GL_EXT_packed_pixels GL_EXT_rescale_normal \
    GL_EXT_secondary_color GL_EXT_separate_specular_color GL_EXT_stencil_two_side \
    GL_EXT_stencil_wrap GL_EXT_texture3D GL_EXT_texture_compression_s3tc \
    GL_EXT_texture_filter_anisotropic GL_EXT_texture_lod_bias GL_EXT_texture_sRGB \
    GL_EXT_texture_shared_exponent GL_EXT_texture_swizzle GL_NV_texgen_reflection \
    GL_NV_texture_env_combine4 GL_SGIS_generate_mipmap GL_SGIS_texture_edge_clamp \
    GL_SGIS_texture_lod";

/// Between `glBegin` and `glEnd` this is refused like any other call, which sets the flag.
pub(crate) fn get_error(context: &mut Context) -> Result<GLenum> {
    Ok(context.debug.take_flag().map_or(GL_NO_ERROR, crate::error::ErrorCode::to_gl))
}

pub(crate) fn get_string(_: &mut Context, name: GLenum) -> Result<&'static str> {
    const STRING: Table<&str> = Table {
        section: "GL 2.1, section 6.1.11",
        rows: &[
            (GL_VENDOR, "DetGL"),
            (GL_RENDERER, "DetGL"),
            (GL_VERSION, concat!("2.1 DetGL ", env!("CARGO_PKG_VERSION"))),
            (GL_SHADING_LANGUAGE_VERSION, "1.30"),
            (GL_EXTENSIONS, EXTENSIONS),
        ],
    };
    STRING.decode("name", name)
}

pub(crate) fn get_booleanv(
    context: &mut Context,
    pname: GLenum,
    params: &mut [GLboolean],
) -> Result<()> {
    let values: Vec<GLboolean> = match state_value(context, pname)? {
        Value::Bools(values) => values.into_iter().map(u8::from).collect(),
        Value::Ints(values) => values.into_iter().map(|value| u8::from(value != 0)).collect(),
        Value::Floats(values) | Value::Unit(values) => {
            values.into_iter().map(|value| u8::from(value != 0.0)).collect()
        }
    };
    put(params, &values)
}

pub(crate) fn get_integerv(
    context: &mut Context,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    put_ints(params, state_value(context, pname)?)
}

pub(crate) fn get_floatv(
    context: &mut Context,
    pname: GLenum,
    params: &mut [GLfloat],
) -> Result<()> {
    put_floats(params, state_value(context, pname)?)
}

pub(crate) fn get_doublev(
    context: &mut Context,
    pname: GLenum,
    params: &mut [GLdouble],
) -> Result<()> {
    put_doubles(params, state_value(context, pname)?)
}

/// Answers in integers: floats are rounded, fractions scaled to the whole range.
pub(crate) fn put_ints(params: &mut [GLint], value: Value) -> Result<()> {
    let values: Vec<GLint> = match value {
        Value::Bools(values) => values.into_iter().map(GLint::from).collect(),
        Value::Ints(values) => values,
        Value::Floats(values) => values.into_iter().map(|value| value.round() as GLint).collect(),
        Value::Unit(values) => {
            values.into_iter().map(|value| unit_to_signed(value as f32)).collect()
        }
    };
    put(params, &values)
}

/// Answers in single precision.
pub(crate) fn put_floats(params: &mut [GLfloat], value: Value) -> Result<()> {
    put(params, &doubles(value).into_iter().map(|value| value as GLfloat).collect::<Vec<_>>())
}

/// Answers in double precision.
pub(crate) fn put_doubles(params: &mut [GLdouble], value: Value) -> Result<()> {
    put(params, &doubles(value))
}

fn doubles(value: Value) -> Vec<f64> {
    match value {
        Value::Bools(values) => values.into_iter().map(|on| f64::from(u8::from(on))).collect(),
        Value::Ints(values) => values.into_iter().map(f64::from).collect(),
        Value::Floats(values) | Value::Unit(values) => values,
    }
}
