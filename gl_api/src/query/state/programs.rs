//! Programs: GL 2.1, tables 6.32 to 6.35, assembly programs, and the buffers of uniform blocks and of transform
//! feedback.

use super::row::Read::*;
use super::row::{Row, rows, saturated};
use crate::base::constants::*;

pub(super) const ROWS: &[Row] = rows! {
    GL_CURRENT_PROGRAM: Word(|c| c.state.bindings.program.name());
    GL_PROGRAM_PIPELINE_BINDING: Word(|c| c.objects.pipelines.bound);
    GL_VERTEX_PROGRAM_ARB: Enabled;
    GL_VERTEX_PROGRAM_POINT_SIZE: Enabled;
    GL_VERTEX_PROGRAM_TWO_SIDE: Enabled;
    GL_FRAGMENT_PROGRAM_ARB: Enabled;
    GL_PROGRAM_ERROR_POSITION_ARB:
        Integer(|c| c.state.assembly.error.map_or(-1, |(position, _)| saturated(position)));
    GL_UNIFORM_BUFFER_BINDING: Word(|c| c.state.bindings.uniform_buffer.name());
    GL_TRANSFORM_FEEDBACK_BUFFER_BINDING:
        Word(|c| c.state.bindings.transform_feedback_buffer.name());
    GL_TRANSFORM_FEEDBACK_BINDING: Word(|c| c.transform_feedback_objects.bound);
    GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE: Flag(|c| c.transform_feedback.has_begun());
    GL_TRANSFORM_FEEDBACK_BUFFER_PAUSED: Flag(|c| c.transform_feedback.paused.is_some());
    GL_NUM_PROGRAM_BINARY_FORMATS: Integer(|_| 0);
    GL_PROGRAM_BINARY_FORMATS: Integers(|_| Vec::new());
};
