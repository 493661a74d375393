//! Calls that name their transform feedback object: `ARB_direct_state_access`, sections 13.2.2 and 22.4.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::buffer::indexed::captured_range;
use crate::context::Context;
use crate::objects::bound::Bound;
use crate::objects::buffers::BufferRange;
use crate::state::transform_feedback::TransformFeedback;

const SECTION: &str = "ARB_direct_state_access, section 13.2.2";
const QUERIES: &str = "ARB_direct_state_access, section 22.4";

pub(crate) fn create_transform_feedbacks(
    context: &mut Context,
    n: GLsizei,
    ids: &mut [GLuint],
) -> Result<()> {
    context.transform_feedback_objects.named.add_each(SECTION, n, ids, TransformFeedback::default)
}

/// The object of a name; 0 is the default one.
fn object(context: &mut Context, name: GLuint) -> Result<&mut TransformFeedback> {
    let objects = &mut context.transform_feedback_objects;
    if name == objects.bound {
        return Ok(&mut context.transform_feedback);
    }
    match objects.named.get_mut(name) {
        Some(object) => Ok(object),
        None if name == 0 => Ok(&mut objects.default),
        None => invalid_operation(
            SECTION,
            format!(
                "xfb = {name} is no transform feedback object: glCreateTransformFeedbacks makes some, and so does \
                 binding a name once"
            ),
        ),
    }
}

fn set_buffer(
    context: &mut Context,
    xfb: GLuint,
    (index, buffer): (GLuint, GLuint),
    range: [Option<i64>; 2],
) -> Result<()> {
    object(context, xfb)?;
    let buffers = &mut context.objects.shared.buffers;
    if buffer != 0 && buffers.get(buffer).is_none() {
        let rule = format!("buffer = {buffer} must be 0 or a buffer: glCreateBuffers makes some");
        return invalid_value(SECTION, rule);
    }
    let buffer = if buffer == 0 { Bound::default() } else { buffers.hold(buffer) };
    let (index, range) = captured_range(index, &buffer, range)?;
    let object = object(context, xfb)?;
    if object.has_begun() {
        let rule = format!("transform feedback {xfb} is active: call glEndTransformFeedback first");
        return invalid_operation(SECTION, rule);
    }
    object.buffers[index] = range;
    Ok(())
}

pub(crate) fn transform_feedback_buffer_base(
    context: &mut Context,
    xfb: GLuint,
    index: GLuint,
    buffer: GLuint,
) -> Result<()> {
    set_buffer(context, xfb, (index, buffer), [None, None])
}

pub(crate) fn transform_feedback_buffer_range(
    context: &mut Context,
    xfb: GLuint,
    index: GLuint,
    buffer: GLuint,
    offset: GLintptr,
    size: GLsizeiptr,
) -> Result<()> {
    set_buffer(context, xfb, (index, buffer), [Some(offset as i64), Some(size as i64)])
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Progress {
    Paused,
    /// Paused or not.
    Begun,
}

pub(crate) fn get_transform_feedbackiv(
    context: &mut Context,
    xfb: GLuint,
    pname: GLenum,
    param: &mut [GLint],
) -> Result<()> {
    const PARAMETER: Table<Progress> = Table {
        section: QUERIES,
        rows: &[
            (GL_TRANSFORM_FEEDBACK_PAUSED, Progress::Paused),
            (GL_TRANSFORM_FEEDBACK_ACTIVE, Progress::Begun),
        ],
    };
    let object = object(context, xfb)?;
    let is_so = match PARAMETER.decode("pname", pname)? {
        Progress::Paused => object.paused.is_some(),
        Progress::Begun => object.has_begun(),
    };
    put(param, &[is_so.into()])
}

/// The range that is bound to a number.
fn range(context: &mut Context, xfb: GLuint, index: GLuint) -> Result<&BufferRange> {
    let ranges = &object(context, xfb)?.buffers;
    match ranges.get(index as usize) {
        Some(range) => Ok(range),
        None => invalid_value(QUERIES, format!("index = {index} must be below {}", ranges.len())),
    }
}

pub(crate) fn get_transform_feedbacki_v(
    context: &mut Context,
    xfb: GLuint,
    pname: GLenum,
    index: GLuint,
    param: &mut [GLint],
) -> Result<()> {
    const PARAMETER: Table<()> =
        Table { section: QUERIES, rows: &[(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, ())] };
    object(context, xfb)?;
    PARAMETER.decode("pname", pname)?;
    put(param, &[range(context, xfb, index)?.buffer.name() as GLint])
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Bytes {
    Start,
    Size,
}

pub(crate) fn get_transform_feedbacki64_v(
    context: &mut Context,
    xfb: GLuint,
    pname: GLenum,
    index: GLuint,
    param: &mut [GLint64],
) -> Result<()> {
    const PARAMETER: Table<Bytes> = Table {
        section: QUERIES,
        rows: &[
            (GL_TRANSFORM_FEEDBACK_BUFFER_START, Bytes::Start),
            (GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, Bytes::Size),
        ],
    };
    object(context, xfb)?;
    let wanted = PARAMETER.decode("pname", pname)?;
    let range = range(context, xfb, index)?;
    let value = match wanted {
        Bytes::Start => range.offset,
        Bytes::Size => range.size.unwrap_or(0),
    };
    put(param, &[value as GLint64])
}
