//! `glGetVertexAttrib` and the pointers of vertex arrays: GL 2.1, sections 6.1.11 and 6.1.14. Other state of arrays is in
//! [`crate::query::state`].

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum, invalid_operation};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::context::Context;
use crate::interface::*;
use crate::objects::arrays::{ANY_TYPE, Array, Arrays, Source, generic};
use rasterizer::driver::VertexFormat;

/// The name of the buffer object that an array lies in, or 0.
pub(crate) fn buffer(array: &Array) -> GLuint {
    match &array.source {
        Source::Object { buffer, .. } => buffer.name(),
        Source::Client(_) | Source::Pointer(_) => 0,
    }
}

/// Where an array begins: an offset into its buffer, or an address.
fn address(array: &Array) -> usize {
    match &array.source {
        Source::Client(buffer) if buffer.bytes().is_empty() => 0,
        Source::Client(buffer) => buffer.bytes().as_ptr() as usize,
        Source::Pointer(pointer) => pointer.offset(),
        Source::Object { offset, .. } => *offset,
    }
}

/// Where a conventional array begins, by the name that `glGetPointerv` has for it.
pub(crate) fn pointer(context: &Context, pname: GLenum) -> Option<usize> {
    let location = match pname {
        GL_VERTEX_ARRAY_POINTER => ATTRIB_VERTEX,
        GL_NORMAL_ARRAY_POINTER => ATTRIB_NORMAL,
        GL_COLOR_ARRAY_POINTER => ATTRIB_COLOR,
        GL_SECONDARY_COLOR_ARRAY_POINTER => ATTRIB_SECONDARY_COLOR,
        GL_FOG_COORD_ARRAY_POINTER => ATTRIB_FOG_COORD,
        GL_INDEX_ARRAY_POINTER => ATTRIB_INDEX,
        GL_EDGE_FLAG_ARRAY_POINTER => ATTRIB_EDGE_FLAG,
        GL_TEXTURE_COORD_ARRAY_POINTER => ATTRIB_TEX_COORD + context.state.units.client_active,
        _ => return None,
    };
    Some(address(&context.state.arrays.by_location[usize::from(location)]))
}

pub(crate) fn get_vertex_attrib_pointerv(
    context: &mut Context,
    index: GLuint,
    pname: GLenum,
    pointer: &mut [*mut GLvoid],
) -> Result<()> {
    const POINTER: Table<()> =
        Table { section: "GL 2.1, section 6.1.14", rows: &[(GL_VERTEX_ATTRIB_ARRAY_POINTER, ())] };
    let location = usize::from(generic(index)?);
    POINTER.decode("pname", pname)?;
    put(pointer, &[address(&context.state.arrays.by_location[location]) as *mut GLvoid])
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Enabled,
    Size,
    Stride,
    Type,
    Normalized,
    Integer,
    Divisor,
    Buffer,
    Binding,
    RelativeOffset,
    Current,
}

const PROPERTY: Table<Property> = Table {
    section: "GL 2.1, section 6.1.14",
    rows: &[
        (GL_VERTEX_ATTRIB_ARRAY_ENABLED, Property::Enabled),
        (GL_VERTEX_ATTRIB_ARRAY_SIZE, Property::Size),
        (GL_VERTEX_ATTRIB_ARRAY_STRIDE, Property::Stride),
        (GL_VERTEX_ATTRIB_ARRAY_TYPE, Property::Type),
        (GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, Property::Normalized),
        (GL_VERTEX_ATTRIB_ARRAY_INTEGER, Property::Integer),
        (GL_VERTEX_ATTRIB_ARRAY_DIVISOR, Property::Divisor),
        (GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, Property::Buffer),
        (GL_VERTEX_ATTRIB_BINDING, Property::Binding),
        (GL_VERTEX_ATTRIB_RELATIVE_OFFSET, Property::RelativeOffset),
        (GL_CURRENT_VERTEX_ATTRIB, Property::Current),
    ],
};

/// What `glGetVertexAttrib` answers.
pub(crate) enum Answer {
    Number(f64),
    /// The current value. Integers are the bits of these floats.
    Current([f32; 4]),
}

impl Answer {
    /// As numbers, exact.
    pub fn numbers(self) -> Vec<f64> {
        match self {
            Self::Number(number) => vec![number],
            Self::Current(value) => value.map(f64::from).to_vec(),
        }
    }
}

pub(crate) fn property(context: &Context, index: GLuint, pname: GLenum) -> Result<Answer> {
    let location = usize::from(generic(index)?);
    let property = PROPERTY.decode("pname", pname)?;
    // Only where glVertex is, the first attribute is no attribute as others.
    let is_position = location == 0 && context.profile.is_compatibility();
    if property == Property::Current && is_position {
        return invalid_operation(
            "GL 2.1, section 6.1.14",
            "index = 0 has no current value: it is the position",
        );
    }
    Ok(match number(&context.state.arrays, location, property) {
        Some(number) => Answer::Number(number),
        None => Answer::Current(context.state.current[location]),
    })
}

/// What a property of an attribute's array is; `None` of the current value, which is no array's.
fn number(arrays: &Arrays, location: usize, property: Property) -> Option<f64> {
    let array = &arrays.by_location[location];
    Some(match property {
        Property::Enabled => u8::from(array.enabled).into(),
        Property::Size => array.given_size() as f64,
        Property::Stride => array.stride as f64,
        Property::Type => ANY_TYPE.encode(array.ty).into(),
        Property::Normalized => {
            let normalized = match array.format {
                VertexFormat::Normalized
                | VertexFormat::NormalizedBgra
                | VertexFormat::NormalizedSymmetric => true,
                VertexFormat::Plain | VertexFormat::Integer => false,
            };
            u8::from(normalized).into()
        }
        Property::Integer => u8::from(array.format == VertexFormat::Integer).into(),
        Property::Divisor => array.divisor.into(),
        Property::Buffer => buffer(array).into(),
        Property::Binding => arrays.attributes[location].binding.into(),
        Property::RelativeOffset => arrays.attributes[location].relative_offset as f64,
        Property::Current => return None,
    })
}

/// What `glGetVertexArrayIndexediv` answers of an attribute (`ARB_direct_state_access`, section 10.5).
pub(crate) fn array_property(arrays: &Arrays, index: GLuint, pname: GLenum) -> Result<f64> {
    const SECTION: &str = "ARB_direct_state_access, section 10.5";
    let location = usize::from(generic(index)?);
    let refuse = || {
        invalid_enum(
            SECTION,
            format!("pname = {} is none of an attribute's array", enum_name(pname)),
        )
    };
    match PROPERTY.get(pname) {
        None | Some(Property::Current | Property::Buffer | Property::Binding) => refuse(),
        Some(property) => number(arrays, location, property).map_or_else(refuse, Ok),
    }
}

pub(crate) fn get_vertex_attribfv(
    context: &mut Context,
    index: GLuint,
    pname: GLenum,
    params: &mut [GLfloat],
) -> Result<()> {
    let values = property(context, index, pname)?.numbers();
    put(params, &values.into_iter().map(|value| value as GLfloat).collect::<Vec<_>>())
}

pub(crate) fn get_vertex_attribiv(
    context: &mut Context,
    index: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let values = property(context, index, pname)?.numbers();
    put(params, &values.into_iter().map(|value| value.round() as GLint).collect::<Vec<_>>())
}
