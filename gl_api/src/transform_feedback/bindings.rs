//! The buffers that transform feedback fills: `glBindBufferRange`, `glBindBufferBase`.

use super::calls::not_while_active;
use super::{BufferRange, SECTION};
use crate::constants::*;
use crate::context::Context;
use crate::error::{Result, Table, invalid_value};
use crate::object::buffers::{self, BufferTarget};
use crate::types::*;

/// The only target with numbered bindings.
const TARGET: Table<BufferTarget> = Table {
    section: SECTION,
    rows: &[(GL_TRANSFORM_FEEDBACK_BUFFER, BufferTarget::TransformFeedback)],
};

/// A multiple of the 4 bytes that a component has.
fn multiple(what: &str, value: i64, least: i64) -> Result<usize> {
    match usize::try_from(value) {
        Ok(bytes) if value >= least && value % 4 == 0 => Ok(bytes),
        Ok(_) | Err(_) => invalid_value(
            SECTION,
            format!("{what} = {value} must be at least {least} and a multiple of 4"),
        ),
    }
}

fn bind(context: &mut Context, target: GLenum, index: GLuint, range: BufferRange) -> Result<()> {
    TARGET.decode("target", target)?;
    let count = context.transform_feedback.buffers.len();
    if index as usize >= count {
        return invalid_value(
            SECTION,
            format!(
                "index = {index} must be below GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS, {count}"
            ),
        );
    }
    not_while_active(context)?;
    buffers::bind_buffer(context, target, range.name)?;
    context.transform_feedback.buffers[index as usize] = range;
    Ok(())
}

pub(crate) fn bind_buffer_range(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    buffer: GLuint,
    offset: GLintptr,
    size: GLsizeiptr,
) -> Result<()> {
    // Without a buffer there is no range of it.
    let range = if buffer == 0 {
        BufferRange::default()
    } else {
        BufferRange {
            name: buffer,
            offset: multiple("offset", offset as i64, 0)?,
            size: Some(multiple("size", size as i64, 4)?),
        }
    };
    bind(context, target, index, range)
}

pub(crate) fn bind_buffer_offset_ext(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    buffer: GLuint,
    offset: GLintptr,
) -> Result<()> {
    let offset = multiple("offset", offset as i64, 0)?;
    bind(context, target, index, BufferRange { name: buffer, offset, size: None })
}

pub(crate) fn bind_buffer_base(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    buffer: GLuint,
) -> Result<()> {
    bind(context, target, index, BufferRange { name: buffer, offset: 0, size: None })
}

/// What of a numbered binding is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Name,
    Start,
    Size,
}

/// What `glGetIntegeri_v` reads of a numbered binding; `None` if `pname` is of something else.
///
/// # Errors
/// `GL_INVALID_VALUE` for an index that there is not.
pub(crate) fn indexed_value(
    context: &Context,
    pname: GLenum,
    index: GLuint,
) -> Option<Result<GLint>> {
    const PROPERTY: Table<Property> = Table {
        section: SECTION,
        rows: &[
            (GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, Property::Name),
            (GL_TRANSFORM_FEEDBACK_BUFFER_START, Property::Start),
            (GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, Property::Size),
        ],
    };
    let property = PROPERTY.get(pname)?;
    let buffers = &context.transform_feedback.buffers;
    let Some(range) = buffers.get(index as usize) else {
        return Some(invalid_value(
            SECTION,
            format!("index = {index} must be below {}", buffers.len()),
        ));
    };
    Some(Ok(match property {
        Property::Name => range.name as GLint,
        Property::Start => GLint::try_from(range.offset).unwrap_or(GLint::MAX),
        Property::Size => GLint::try_from(range.size.unwrap_or(0)).unwrap_or(GLint::MAX),
    }))
}
