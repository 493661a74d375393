//! Formats of generic attributes and the buffers that they read, apart (`ARB_vertex_attrib_binding`).

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value, not_negative};
use crate::base::limits::{MAX_VERTEX_ATTRIB_BINDINGS, MAX_VERTEX_ATTRIB_RELATIVE_OFFSET};
use crate::base::types::*;
use crate::calls::vertex::array_objects::ChosenArrays;
use crate::calls::vertex::arrays::{INTEGER_TYPE, Rules};
use crate::context::Context;
use crate::objects::arrays::{ANY_TYPE, AttributeBinding, generic};
use crate::objects::buffers::BufferObject;
use rasterizer::driver::{VertexFormat, VertexType};

const SECTION: &str = "ARB_vertex_attrib_binding, section 2.8";

/// Of attributes of 64 bits.
const DOUBLE_TYPE: Table<VertexType> =
    Table { section: SECTION, rows: &[(GL_DOUBLE, VertexType::F64)] };

/// A binding point's number.
pub(crate) fn binding_point(index: GLuint) -> Result<u8> {
    match u8::try_from(index) {
        Ok(index) if usize::from(index) < MAX_VERTEX_ATTRIB_BINDINGS => Ok(index),
        _ => invalid_value(
            SECTION,
            format!(
                "bindingindex = {index} must be below GL_MAX_VERTEX_ATTRIB_BINDINGS, \
                 {MAX_VERTEX_ATTRIB_BINDINGS}"
            ),
        ),
    }
}

fn set_format(
    context: &mut Context,
    (chosen, index): (ChosenArrays, GLuint),
    rules: &Rules,
    (size, ty): (GLint, GLenum),
    relative_offset: GLuint,
) -> Result<()> {
    let location = usize::from(generic(index)?);
    let (components, ty, format) = rules.check(size, ty)?;
    if relative_offset > MAX_VERTEX_ATTRIB_RELATIVE_OFFSET {
        return invalid_value(
            SECTION,
            format!(
                "relativeoffset = {relative_offset} must be at most \
                 GL_MAX_VERTEX_ATTRIB_RELATIVE_OFFSET, {MAX_VERTEX_ATTRIB_RELATIVE_OFFSET}"
            ),
        );
    }
    chosen.require(context)?;
    let arrays = chosen.arrays_mut(context);
    let array = &mut arrays.by_location[location];
    (array.components, array.ty, array.format) = (components, ty, format);
    arrays.attributes[location].relative_offset = relative_offset as usize;
    let binding = usize::from(arrays.attributes[location].binding);
    // The client's memory stays where it is.
    if arrays.bindings[binding].buffer.name() != 0 {
        arrays.attribute_changed(location);
    }
    context.state_changes.values_only();
    Ok(())
}

pub(crate) fn vertex_attrib_format(
    context: &mut Context,
    index: GLuint,
    size: GLint,
    ty: GLenum,
    normalized: bool,
    relative_offset: GLuint,
) -> Result<()> {
    let chosen = ChosenArrays::Bound;
    set_plain_format(context, (chosen, index), (size, ty), normalized, relative_offset)
}

/// Sets the format of an attribute of floats, or of integers that become such.
pub(crate) fn set_plain_format(
    context: &mut Context,
    attribute: (ChosenArrays, GLuint),
    (size, ty): (GLint, GLenum),
    normalized: bool,
    relative_offset: GLuint,
) -> Result<()> {
    let format = if normalized { VertexFormat::Normalized } else { VertexFormat::Plain };
    let rules = Rules::new(1..=4, ANY_TYPE, format).or_bgra();
    set_format(context, attribute, &rules, (size, ty), relative_offset)
}

pub(crate) fn vertex_attrib_i_format(
    context: &mut Context,
    index: GLuint,
    size: GLint,
    ty: GLenum,
    relative_offset: GLuint,
) -> Result<()> {
    set_integer_format(context, (ChosenArrays::Bound, index), (size, ty), relative_offset)
}

/// Sets the format of an attribute of integers.
pub(crate) fn set_integer_format(
    context: &mut Context,
    attribute: (ChosenArrays, GLuint),
    (size, ty): (GLint, GLenum),
    relative_offset: GLuint,
) -> Result<()> {
    let rules = Rules::new(1..=4, INTEGER_TYPE, VertexFormat::Integer);
    set_format(context, attribute, &rules, (size, ty), relative_offset)
}

pub(crate) fn vertex_attrib_l_format(
    context: &mut Context,
    index: GLuint,
    size: GLint,
    ty: GLenum,
    relative_offset: GLuint,
) -> Result<()> {
    set_double_format(context, (ChosenArrays::Bound, index), (size, ty), relative_offset)
}

/// Sets the format of an attribute of doubles; shaders have no attributes of 64 bits and read them rounded.
pub(crate) fn set_double_format(
    context: &mut Context,
    attribute: (ChosenArrays, GLuint),
    (size, ty): (GLint, GLenum),
    relative_offset: GLuint,
) -> Result<()> {
    let rules = Rules::new(1..=4, DOUBLE_TYPE, VertexFormat::Plain);
    set_format(context, attribute, &rules, (size, ty), relative_offset)
}

pub(crate) fn vertex_attrib_binding(
    context: &mut Context,
    attribute: GLuint,
    binding: GLuint,
) -> Result<()> {
    set_binding(context, (ChosenArrays::Bound, attribute), binding)
}

/// Sets the binding point that an attribute reads.
pub(crate) fn set_binding(
    context: &mut Context,
    (chosen, attribute): (ChosenArrays, GLuint),
    binding: GLuint,
) -> Result<()> {
    let location = usize::from(generic(attribute)?);
    let binding = binding_point(binding)?;
    chosen.require(context)?;
    let arrays = chosen.arrays_mut(context);
    let attribute = &mut arrays.attributes[location];
    // The memory of the client has no binding point.
    if attribute.binding != binding {
        *attribute = AttributeBinding { binding, ..*attribute };
        arrays.attribute_changed(location);
        context.state_changes.values_only();
    }
    Ok(())
}

pub(crate) fn bind_vertex_buffer(
    context: &mut Context,
    binding: GLuint,
    buffer: GLuint,
    offset: GLintptr,
    stride: GLsizei,
) -> Result<()> {
    set_buffer(context, (ChosenArrays::Bound, binding), buffer, (offset, stride))
}

/// Attaches a buffer to a binding point.
pub(crate) fn set_buffer(
    context: &mut Context,
    (chosen, binding): (ChosenArrays, GLuint),
    buffer: GLuint,
    (offset, stride): (GLintptr, GLsizei),
) -> Result<()> {
    let binding = binding_point(binding)?;
    let offset = not_negative(SECTION, "offset", offset as i64)?;
    let stride = not_negative(SECTION, "stride", stride.into())?;
    chosen.require(context)?;
    let buffers = &mut context.objects.shared.buffers;
    if buffer != 0 && !buffers.is_reserved(buffer) {
        return invalid_operation(
            SECTION,
            format!("buffer = {buffer} is no name that glGenBuffers has given"),
        );
    }
    buffers.create(buffer, BufferObject::new);
    let buffer = buffers.hold(buffer);
    let arrays = chosen.arrays_mut(context);
    let bound = &mut arrays.bindings[usize::from(binding)];
    (bound.buffer, bound.offset, bound.stride) = (buffer, offset, stride);
    arrays.binding_changed(binding);
    context.state_changes.values_only();
    Ok(())
}

pub(crate) fn vertex_binding_divisor(
    context: &mut Context,
    binding: GLuint,
    divisor: GLuint,
) -> Result<()> {
    set_divisor(context, (ChosenArrays::Bound, binding), divisor)
}

/// Sets how many instances share an element of a binding point.
pub(crate) fn set_divisor(
    context: &mut Context,
    (chosen, binding): (ChosenArrays, GLuint),
    divisor: GLuint,
) -> Result<()> {
    let binding = binding_point(binding)?;
    chosen.require(context)?;
    let arrays = chosen.arrays_mut(context);
    arrays.bindings[usize::from(binding)].divisor = divisor;
    for location in 0..arrays.attributes.len() {
        if arrays.attributes[location].binding == binding {
            arrays.by_location[location].divisor = divisor;
        }
    }
    context.state_changes.values_only();
    Ok(())
}
