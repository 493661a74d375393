//! `glBindBufferRange` and `glBindBufferBase`: GL 3.0, section 2.15; `ARB_uniform_buffer_object`, section 2.15.3.2.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_value};
use crate::base::limits::{
    MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS, UNIFORM_BUFFER_OFFSET_ALIGNMENT,
};
use crate::base::types::*;
use crate::calls::transform_feedback::not_while_begun;
use crate::context::Context;
use crate::objects::bound::Bound;
use crate::objects::buffers::{BufferRange, BufferTarget};

const SECTION: &str = "GL 3.1, section 2.9.1";

/// A target with numbered bindings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Numbered {
    TransformFeedback,
    Uniform,
}

impl Numbered {
    const TARGET: Table<Self> = Table {
        section: SECTION,
        rows: &[
            (GL_TRANSFORM_FEEDBACK_BUFFER, Self::TransformFeedback),
            (GL_UNIFORM_BUFFER, Self::Uniform),
        ],
    };

    fn ranges(self, context: &Context) -> &[BufferRange] {
        match self {
            Self::TransformFeedback => &context.transform_feedback.buffers,
            Self::Uniform => &context.uniform_buffers.buffers,
        }
    }

    fn ranges_mut(self, context: &mut Context) -> &mut [BufferRange] {
        match self {
            Self::TransformFeedback => &mut context.transform_feedback.buffers,
            Self::Uniform => &mut context.uniform_buffers.buffers,
        }
    }

    /// The binding of the whole buffer, which is set too.
    fn buffer_target(self) -> BufferTarget {
        match self {
            Self::TransformFeedback => BufferTarget::TransformFeedback,
            Self::Uniform => BufferTarget::Uniform,
        }
    }

    /// What says how many numbers there are.
    fn limit(self) -> &'static str {
        match self {
            Self::TransformFeedback => "GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS",
            Self::Uniform => "GL_MAX_UNIFORM_BUFFER_BINDINGS",
        }
    }

    /// What offsets and sizes are multiples of.
    fn alignments(self) -> [usize; 2] {
        match self {
            Self::TransformFeedback => [4, 4],
            Self::Uniform => [UNIFORM_BUFFER_OFFSET_ALIGNMENT, 1],
        }
    }
}

/// A number of bytes that is large enough, and a multiple.
fn multiple(what: &str, value: i64, least: i64, of: usize) -> Result<usize> {
    match usize::try_from(value) {
        Ok(bytes) if value >= least && bytes % of == 0 => Ok(bytes),
        Ok(_) | Err(_) => invalid_value(
            SECTION,
            format!("{what} = {value} must be at least {least} and a multiple of {of}"),
        ),
    }
}

/// A checked `glBindBufferRange`, or a call like it.
struct BindRequest {
    numbered: Numbered,
    index: usize,
    buffer: GLuint,
    offset: usize,
    size: Option<usize>,
}

impl BindRequest {
    fn new(
        (numbered, count): (Numbered, usize),
        index: GLuint,
        buffer: GLuint,
        [offset, size]: [Option<i64>; 2],
    ) -> Result<Self> {
        let [of_offset, of_size] = numbered.alignments();
        // Without a buffer there is no range of it.
        let given = |value: Option<i64>| value.filter(|_| buffer != 0);
        let offset = given(offset).map(|offset| multiple("offset", offset, 0, of_offset));
        let offset = offset.transpose()?.unwrap_or(0);
        let size = given(size).map(|size| multiple("size", size, of_size as i64, of_size));
        let (size, index) = (size.transpose()?, index as usize);
        if index >= count {
            let limit = numbered.limit();
            let rule = format!("index = {index} must be below {limit}, {count}");
            return invalid_value(SECTION, rule);
        }
        Ok(Self { numbered, index, buffer, offset, size })
    }

    fn apply(self, context: &mut Context) {
        let Self { numbered, index, buffer, offset, size } = self;
        crate::calls::buffer::data::bind(context, numbered.buffer_target(), buffer);
        let buffer = context.objects.shared.buffers.hold(buffer);
        numbered.ranges_mut(context)[index] = BufferRange { buffer, offset, size };
    }
}

fn bind(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    buffer: GLuint,
    range: [Option<i64>; 2],
) -> Result<()> {
    let numbered = Numbered::TARGET.decode("target", target)?;
    let count = numbered.ranges(context).len();
    let request = BindRequest::new((numbered, count), index, buffer, range)?;
    if numbered == Numbered::TransformFeedback {
        not_while_begun(context)?;
    }
    request.apply(context);
    match numbered {
        Numbered::Uniform => context.state_changes.values_only(),
        Numbered::TransformFeedback => {}
    }
    Ok(())
}

/// Checks a range of a buffer for a transform feedback object; the binding point's number, and the range.
pub(crate) fn captured_range(
    index: GLuint,
    buffer: &Bound,
    range: [Option<i64>; 2],
) -> Result<(usize, BufferRange)> {
    let points = (Numbered::TransformFeedback, MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS);
    let BindRequest { index, offset, size, .. } =
        BindRequest::new(points, index, buffer.name(), range)?;
    Ok((index, BufferRange { buffer: buffer.clone(), offset, size }))
}

pub(crate) fn bind_buffer_range(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    buffer: GLuint,
    offset: GLintptr,
    size: GLsizeiptr,
) -> Result<()> {
    bind(context, target, index, buffer, [Some(offset as i64), Some(size as i64)])
}

pub(crate) fn bind_buffer_offset_ext(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    buffer: GLuint,
    offset: GLintptr,
) -> Result<()> {
    const TARGET: Table<()> = Table {
        section: "EXT_transform_feedback, section 2.Y",
        rows: &[(GL_TRANSFORM_FEEDBACK_BUFFER, ())],
    };
    TARGET.decode("target", target)?;
    bind(context, target, index, buffer, [Some(offset as i64), None])
}

pub(crate) fn bind_buffer_base(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    buffer: GLuint,
) -> Result<()> {
    bind(context, target, index, buffer, [None, None])
}

/// The range that is bound to a number.
///
/// # Errors
/// `GL_INVALID_VALUE` for an index that there is not.
pub(crate) fn range(context: &Context, numbered: Numbered, index: GLuint) -> Result<&BufferRange> {
    let ranges = numbered.ranges(context);
    match ranges.get(index as usize) {
        Some(range) => Ok(range),
        None => invalid_value(SECTION, format!("index = {index} must be below {}", ranges.len())),
    }
}
