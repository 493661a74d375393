//! `glTransformFeedbackVaryings`, and the query of the varyings that the last link captures.

use crate::base::args::{Names, TextOut};
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value, not_negative};
use crate::base::limits::{
    MAX_TRANSFORM_FEEDBACK_BUFFERS, MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS,
    MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS,
};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::program::data_type::gl_type;
use crate::calls::program::inspect::indexed;
use crate::calls::program::programs::program;
use crate::context::Context;
use crate::glsl::{BufferMode, Capture, CaptureRequest, CapturedItem};
use crate::objects::shaders::put_text;
use crate::state::transform_feedback::SECTION;

/// How buffers are filled.
pub(crate) const BUFFER_MODE: Table<BufferMode> = Table {
    section: SECTION,
    rows: &[
        (GL_INTERLEAVED_ATTRIBS, BufferMode::Interleaved),
        (GL_SEPARATE_ATTRIBS, BufferMode::Separate),
    ],
};

const GAPS: &str = "ARB_transform_feedback3, section 2.17";

/// What a name asks for.
fn request(name: &str, is_es: bool) -> CaptureRequest {
    match name {
        "gl_NextBuffer" if !is_es => return CaptureRequest::NextBuffer,
        "gl_SkipComponents1" if !is_es => return CaptureRequest::Gap(1),
        "gl_SkipComponents2" if !is_es => return CaptureRequest::Gap(2),
        "gl_SkipComponents3" if !is_es => return CaptureRequest::Gap(3),
        "gl_SkipComponents4" if !is_es => return CaptureRequest::Gap(4),
        _ => {}
    }
    match indexed(name) {
        Some((variable, element)) => {
            CaptureRequest::Varying { variable: variable.to_owned(), element: Some(element) }
        }
        None => CaptureRequest::Varying { variable: name.to_owned(), element: None },
    }
}

/// Gaps and steps to the next buffer are for interleaved capture, into as many buffers as there are.
fn check_gaps(varyings: &[CaptureRequest], mode: BufferMode) -> Result<()> {
    let other = varyings.iter().find(|name| !matches!(name, CaptureRequest::Varying { .. }));
    if let (BufferMode::Separate, Some(name)) = (mode, other) {
        let rule = format!("varyings has {name}, which needs bufferMode = GL_INTERLEAVED_ATTRIBS");
        return invalid_operation(GAPS, rule);
    }
    let steps = varyings.iter().filter(|name| **name == CaptureRequest::NextBuffer).count();
    if steps >= MAX_TRANSFORM_FEEDBACK_BUFFERS {
        return invalid_operation(
            GAPS,
            format!(
                "varyings has gl_NextBuffer {steps} times, but there are \
                 GL_MAX_TRANSFORM_FEEDBACK_BUFFERS = {MAX_TRANSFORM_FEEDBACK_BUFFERS} buffers"
            ),
        );
    }
    Ok(())
}

/// What the next link is to capture.
pub(crate) fn transform_feedback_varyings(
    context: &mut Context,
    name: GLuint,
    count: GLsizei,
    varyings: Names<'_>,
    buffer_mode: GLenum,
) -> Result<()> {
    let is_es = context.profile.is_es();
    let program = program(context, name)?;
    let count = not_negative(SECTION, "count", count.into())?;
    let mode = BUFFER_MODE.decode("bufferMode", buffer_mode)?;
    let most = MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS;
    if mode == BufferMode::Separate && count > most {
        return invalid_value(
            SECTION,
            format!(
                "count = {count}, but at most {most} buffers are filled \
                 (GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS)"
            ),
        );
    }
    // With so many linking fails, whatever they are.
    let count = count.min(MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS + 1);
    let Some(names) = varyings.0.get(..count) else {
        let has = varyings.0.len();
        return invalid_operation(SECTION, format!("count = {count}, but there are {has} names"));
    };
    let varyings: Vec<CaptureRequest> = names.iter().map(|name| request(name, is_es)).collect();
    check_gaps(&varyings, mode)?;
    program.bindings.capture = Capture { mode, varyings };
    Ok(())
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn get_transform_feedback_varying(
    context: &mut Context,
    name: GLuint,
    index: GLuint,
    max_length: GLsizei,
    length: &mut [GLsizei],
    size: &mut [GLsizei],
    ty: &mut [GLenum],
    out: TextOut<'_>,
) -> Result<()> {
    let Some(linked) = program(context, name)?.linked() else {
        return invalid_operation(SECTION, format!("program {name} is not linked"));
    };
    let captured = &linked.program.captured;
    let Some(found) = captured.get(index as usize) else {
        return invalid_value(
            SECTION,
            format!(
                "index = {index} must be below GL_TRANSFORM_FEEDBACK_VARYINGS, {}",
                captured.len()
            ),
        );
    };
    put_text(&found.name, max_length, length, out)?;
    put(size, &[found.size as GLsizei])?;
    let found = match found.item {
        CapturedItem::Varying(ty) => gl_type(ty),
        CapturedItem::Gap | CapturedItem::NextBuffer => GL_NONE,
    };
    put(ty, &[found])
}
