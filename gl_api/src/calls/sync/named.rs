//! Queries that are made with their target, and answers that go to buffers: `ARB_direct_state_access`, section 4.2.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_operation, invalid_value};
use crate::base::types::*;
use crate::calls::buffer::data::{named, writable};
use crate::calls::sync::queries::answer;
use crate::context::Context;
use crate::objects::queries::{Query, QueryTarget, TARGET};

const SECTION: &str = "ARB_direct_state_access, section 4.2";

pub(crate) fn create_queries(
    context: &mut Context,
    target: GLenum,
    n: GLsizei,
    ids: &mut [GLuint],
) -> Result<()> {
    let target = match target {
        GL_TIMESTAMP => QueryTarget::Timestamp,
        _ => TARGET.decode("target", target)?,
    };
    context.objects.queries.add_each(SECTION, n, ids, || Query::new(target))
}

/// Writes what a query answers to a buffer, as a number of so many bytes.
fn write<const BYTES: usize>(
    context: &mut Context,
    (id, pname): (GLuint, GLenum),
    (buffer, offset): (GLuint, GLintptr),
    encode: fn(u64) -> [u8; BYTES],
) -> Result<()> {
    let buffer = named(context, "buffer", buffer)?;
    let Ok(start) = usize::try_from(offset) else {
        return invalid_value(SECTION, format!("offset = {offset} must not be negative"));
    };
    let (object, _) = writable(context, &buffer)?;
    let length = object.len();
    let Some(end) = start.checked_add(BYTES).filter(|end| *end <= length) else {
        return invalid_operation(
            SECTION,
            format!("offset = {offset}: {BYTES} bytes reach past the buffer's {length}"),
        );
    };
    // All draws are carried out, so nothing has to be waited for (ARB_query_buffer_object).
    let pname = if pname == GL_QUERY_RESULT_NO_WAIT { GL_QUERY_RESULT } else { pname };
    let bytes = encode(answer(context, id, pname)?);
    let (object, recorder) = writable(context, &buffer)?;
    object.write(recorder, start..end, |to| to.copy_from_slice(&bytes))
}

pub(crate) fn get_query_buffer_objectiv(
    context: &mut Context,
    id: GLuint,
    buffer: GLuint,
    pname: GLenum,
    offset: GLintptr,
) -> Result<()> {
    write(context, (id, pname), (buffer, offset), |value| {
        GLint::try_from(value).unwrap_or(GLint::MAX).to_le_bytes()
    })
}

pub(crate) fn get_query_buffer_objectuiv(
    context: &mut Context,
    id: GLuint,
    buffer: GLuint,
    pname: GLenum,
    offset: GLintptr,
) -> Result<()> {
    write(context, (id, pname), (buffer, offset), |value| {
        GLuint::try_from(value).unwrap_or(GLuint::MAX).to_le_bytes()
    })
}

pub(crate) fn get_query_buffer_objecti64v(
    context: &mut Context,
    id: GLuint,
    buffer: GLuint,
    pname: GLenum,
    offset: GLintptr,
) -> Result<()> {
    write(context, (id, pname), (buffer, offset), |value| {
        GLint64::try_from(value).unwrap_or(GLint64::MAX).to_le_bytes()
    })
}

pub(crate) fn get_query_buffer_objectui64v(
    context: &mut Context,
    id: GLuint,
    buffer: GLuint,
    pname: GLenum,
    offset: GLintptr,
) -> Result<()> {
    write(context, (id, pname), (buffer, offset), u64::to_le_bytes)
}
