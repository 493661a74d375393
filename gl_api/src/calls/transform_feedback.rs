//! `glBeginTransformFeedback` and `glEndTransformFeedback`.

use crate::base::error::{Result, invalid_operation};
use crate::base::limits::MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS;
use crate::base::types::*;
use crate::context::Context;
use crate::glsl::BufferMode;
use crate::state::transform_feedback::{Active, CapturedPrimitive, SECTION};

pub(crate) fn begin_transform_feedback(context: &mut Context, mode: GLenum) -> Result<()> {
    let kind = CapturedPrimitive::TABLE.decode("primitiveMode", mode)?;
    if context.transform_feedback.is_active() {
        return invalid_operation(
            SECTION,
            "transform feedback is active: glEndTransformFeedback is missing",
        );
    }
    let Some(linked) = context.objects.shared.linked_program(context.state.bindings.program.name())
    else {
        return invalid_operation(SECTION, "no program is in use: call glUseProgram");
    };
    let count = linked.program.captured.len();
    if count == 0 {
        return invalid_operation(
            SECTION,
            "the program captures nothing: call glTransformFeedbackVaryings before it is linked",
        );
    }
    let needed = match linked.program.buffer_mode {
        BufferMode::Interleaved => 1,
        BufferMode::Separate => count,
    };
    let buffers = context.transform_feedback.buffers.iter().take(needed);
    if let Some(index) = buffers.clone().position(|range| range.buffer.name() == 0) {
        return invalid_operation(
            SECTION,
            format!(
                "no buffer is bound to index {index} of GL_TRANSFORM_FEEDBACK_BUFFER: call \
                 glBindBufferBase"
            ),
        );
    }
    let written = [0; MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS];
    context.transform_feedback.active = Some(Active { kind, written });
    Ok(())
}

pub(crate) fn end_transform_feedback(context: &mut Context) -> Result<()> {
    match context.transform_feedback.active.take() {
        Some(_) => Ok(()),
        None => invalid_operation(
            SECTION,
            "transform feedback is not active: glBeginTransformFeedback is missing",
        ),
    }
}

/// Refuses what must not change while vertices are captured.
///
/// # Errors
/// `GL_INVALID_OPERATION`.
pub(crate) fn not_while_active(context: &Context) -> Result<()> {
    if context.transform_feedback.is_active() {
        return invalid_operation(
            SECTION,
            "transform feedback is active: call glEndTransformFeedback first",
        );
    }
    Ok(())
}
