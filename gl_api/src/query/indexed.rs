//! State with an index: of one draw buffer (`EXT_draw_buffers2`), of an indexed buffer (GL 3.1, section 2.15), or
//! a word of the sample mask (`ARB_texture_multisample`).

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum, invalid_value};
use crate::base::query_value::{
    QueryValue, flag, floats, put, put_bools, put_doubles, put_floats, put_ints, put_longs,
};
use crate::base::types::*;
use crate::calls::buffer::indexed::{Numbered, range};
use crate::calls::fragment::masks::{self, SECTION};
use crate::calls::raster::multisample::checked_word;
use crate::calls::transform::viewport_arrays::viewport_index;
use crate::calls::vertex::bindings::binding_point;
use crate::context::Context;
use crate::objects::arrays::VertexBufferBinding;
use crate::objects::target::TextureTarget;
use crate::state::blend::Formula;
use crate::state::draw_buffers::{BufferState, buffer_index};
use crate::state::texture_units::Unit;
use Read::{Flag, Flags, Number, Value};

/// Where an indexed value is, and its type.
enum Read {
    /// Of a draw buffer.
    Flag(fn(&BufferState) -> bool),
    Flags(fn(&BufferState) -> [bool; 4]),
    /// A part of a draw buffer's blend formula, by its own name.
    Formula,
    /// A number that is checked for its index here.
    Number(fn(&Context, GLuint) -> Result<GLint64>),
    /// Of a viewport, whose number is checked here.
    Value(fn(&Context, GLuint) -> Result<QueryValue>),
}

/// Of indexed buffers; OpenGL ES 3.0 has no other (section 6.1.1).
const ROWS_OF_BUFFERS: &[(GLenum, Read)] = &[
    (GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, Number(|c, i| name(c, Numbered::TransformFeedback, i))),
    (GL_TRANSFORM_FEEDBACK_BUFFER_START, Number(|c, i| start(c, Numbered::TransformFeedback, i))),
    (GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, Number(|c, i| size(c, Numbered::TransformFeedback, i))),
    (GL_UNIFORM_BUFFER_BINDING, Number(|c, i| name(c, Numbered::Uniform, i))),
    (GL_UNIFORM_BUFFER_START, Number(|c, i| start(c, Numbered::Uniform, i))),
    (GL_UNIFORM_BUFFER_SIZE, Number(|c, i| size(c, Numbered::Uniform, i))),
];

const ROWS_OF_OPENGL: &[(GLenum, Read)] = &[
    (GL_BLEND, Flag(|buffer| buffer.blend)),
    (GL_SCISSOR_TEST, Value(|context, index| flag(masks::is_on(context, GL_SCISSOR_TEST, index)?))),
    (
        GL_SCISSOR_BOX,
        Value(|context, index| {
            let area = context.state.fragment.scissor.get(viewport_index("index", index)?);
            Ok(QueryValue::Ints(vec![area.x, area.y, area.width as i32, area.height as i32]))
        }),
    ),
    (
        GL_VIEWPORT,
        Value(|context, index| {
            floats(&context.state.viewport.get(viewport_index("index", index)?).sides())
        }),
    ),
    (
        GL_DEPTH_RANGE,
        Value(|context, index| {
            let depth = context.state.viewport.get(viewport_index("index", index)?).depth;
            Ok(QueryValue::Floats(depth.to_vec()))
        }),
    ),
    (GL_COLOR_WRITEMASK, Flags(|buffer| buffer.mask)),
    (GL_BLEND_SRC, Read::Formula),
    (GL_BLEND_SRC_RGB, Read::Formula),
    (GL_BLEND_SRC_ALPHA, Read::Formula),
    (GL_BLEND_DST, Read::Formula),
    (GL_BLEND_DST_RGB, Read::Formula),
    (GL_BLEND_DST_ALPHA, Read::Formula),
    (GL_BLEND_EQUATION, Read::Formula),
    (GL_BLEND_EQUATION_ALPHA, Read::Formula),
    (
        GL_SAMPLE_MASK_VALUE,
        Number(|context, index| {
            checked_word("index", index)?;
            Ok((context.state.raster.multisample.mask as GLint).into())
        }),
    ),
    (GL_SAMPLER_BINDING, Number(|c, i| Ok(unit(c, i)?.sampler.name().into()))),
    (GL_TEXTURE_BINDING_1D, Number(|c, i| texture(c, i, TextureTarget::D1))),
    (GL_TEXTURE_BINDING_1D_ARRAY, Number(|c, i| texture(c, i, TextureTarget::D1Array))),
    (GL_TEXTURE_BINDING_2D, Number(|c, i| texture(c, i, TextureTarget::D2))),
    (GL_TEXTURE_BINDING_2D_ARRAY, Number(|c, i| texture(c, i, TextureTarget::D2Array))),
    (GL_TEXTURE_BINDING_2D_MULTISAMPLE, Number(|c, i| texture(c, i, TextureTarget::D2Multisample))),
    (
        GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY,
        Number(|c, i| texture(c, i, TextureTarget::D2MultisampleArray)),
    ),
    (GL_TEXTURE_BINDING_3D, Number(|c, i| texture(c, i, TextureTarget::D3))),
    (GL_TEXTURE_BINDING_BUFFER, Number(|c, i| texture(c, i, TextureTarget::Buffer))),
    (GL_TEXTURE_BINDING_CUBE_MAP, Number(|c, i| texture(c, i, TextureTarget::Cube))),
    (GL_TEXTURE_BINDING_CUBE_MAP_ARRAY, Number(|c, i| texture(c, i, TextureTarget::CubeArray))),
    (GL_TEXTURE_BINDING_RECTANGLE, Number(|c, i| texture(c, i, TextureTarget::Rect))),
    (GL_VERTEX_BINDING_OFFSET, Number(|c, i| Ok(vertex_buffer(c, i)?.offset as GLint64))),
    (GL_VERTEX_BINDING_STRIDE, Number(|c, i| Ok(vertex_buffer(c, i)?.stride as GLint64))),
    (GL_VERTEX_BINDING_DIVISOR, Number(|c, i| Ok(vertex_buffer(c, i)?.divisor.into()))),
    (GL_VERTEX_BINDING_BUFFER, Number(|c, i| Ok(vertex_buffer(c, i)?.buffer.name().into()))),
];

/// A texture unit (`ARB_direct_state_access`, section 22.5).
fn unit(context: &Context, index: GLuint) -> Result<&Unit> {
    let units = &context.state.units.units;
    match units.get(index as usize) {
        Some(unit) => Ok(unit),
        None => invalid_value(
            "ARB_direct_state_access, section 22.5",
            format!("index = {index} must be below {}, the number of texture units", units.len()),
        ),
    }
}

/// The texture that is bound to a target of a unit.
fn texture(context: &Context, index: GLuint, target: TextureTarget) -> Result<GLint64> {
    Ok(unit(context, index)?.bound[target as usize].name().into())
}

fn vertex_buffer(context: &Context, index: GLuint) -> Result<&VertexBufferBinding> {
    Ok(&context.state.arrays.bindings[usize::from(binding_point(index)?)])
}

fn name(context: &Context, numbered: Numbered, index: GLuint) -> Result<GLint64> {
    Ok(range(context, numbered, index)?.buffer.name().into())
}

fn start(context: &Context, numbered: Numbered, index: GLuint) -> Result<GLint64> {
    Ok(range(context, numbered, index)?.offset as GLint64)
}

fn size(context: &Context, numbered: Numbered, index: GLuint) -> Result<GLint64> {
    Ok(range(context, numbered, index)?.size.unwrap_or(0) as GLint64)
}

/// An indexed value before it is converted.
enum Indexed {
    Value(QueryValue),
    /// An offset or a size, which may need 64 bits.
    Number(GLint64),
}

impl Indexed {
    /// Numbers that do not fit are the largest that does.
    fn value(self) -> QueryValue {
        match self {
            Self::Value(value) => value,
            Self::Number(number) => QueryValue::Ints(vec![number.try_into().unwrap_or(i32::MAX)]),
        }
    }
}

fn indexed_state(context: &Context, target: GLenum, index: GLuint) -> Result<Indexed> {
    let buffer = || Ok(&context.state.fragment.buffers[buffer_index("index", index)?]);
    let more = if context.profile.is_es() { &[] } else { ROWS_OF_OPENGL };
    let row = ROWS_OF_BUFFERS.iter().chain(more).find(|row| row.0 == target);
    Ok(Indexed::Value(match row.map(|row| &row.1) {
        Some(Flag(read)) => QueryValue::Bools(vec![read(buffer()?)]),
        Some(Flags(read)) => QueryValue::Bools(read(buffer()?).to_vec()),
        Some(Read::Formula) => {
            let formula: &Formula = &buffer()?.formula;
            QueryValue::Word(formula.get(target).unwrap_or_default())
        }
        Some(Value(read)) => read(context, index)?,
        Some(Number(read)) => return read(context, index).map(Indexed::Number),
        None => {
            return invalid_enum(
                SECTION,
                format!(
                    "target = {} must be GL_BLEND, GL_BLEND_SRC_RGB or another part of a blend \
                     formula, GL_COLOR_WRITEMASK, GL_SAMPLE_MASK_VALUE, GL_VIEWPORT, GL_DEPTH_RANGE, \
                     GL_SCISSOR_BOX, GL_SCISSOR_TEST, a vertex buffer, an indexed buffer or what is bound to a texture unit",
                    enum_name(target)
                ),
            );
        }
    }))
}

pub(crate) fn is_enabledi(context: &mut Context, target: GLenum, index: GLuint) -> Result<bool> {
    masks::is_on(context, target, index)
}

pub(crate) fn get_floati_v(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    data: &mut [GLfloat],
) -> Result<()> {
    put_floats(data, indexed_state(context, target, index)?.value())
}

pub(crate) fn get_doublei_v(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    data: &mut [GLdouble],
) -> Result<()> {
    put_doubles(data, indexed_state(context, target, index)?.value())
}

pub(crate) fn get_booleani_v(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    data: &mut [GLboolean],
) -> Result<()> {
    put_bools(data, indexed_state(context, target, index)?.value())
}

pub(crate) fn get_integeri_v(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    data: &mut [GLint],
) -> Result<()> {
    put_ints(data, indexed_state(context, target, index)?.value())
}

pub(crate) fn get_integer64i_v(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    data: &mut [GLint64],
) -> Result<()> {
    match indexed_state(context, target, index)? {
        Indexed::Value(value) => put_longs(data, value),
        Indexed::Number(number) => put(data, &[number]),
    }
}
