//! Hints, display lists, attribute stacks, selection and feedback (GL 2.1, tables 6.33 and 6.41), debugging
//! (`KHR_debug`), and what no table of GL 2.1 has.

use super::row::Read::*;
use super::row::{Row, rows, saturated};
use crate::base::constants::*;
use crate::base::types::*;
use crate::calls::sync::fences::MAX_SERVER_WAIT_TIMEOUT;
use crate::context::Context;
use crate::context::feedback::record::FeedbackType;
use crate::context::feedback::select::MAX_NAME_STACK_DEPTH;
use crate::context::log::{MAX_GROUPS, MAX_LABEL, MAX_LENGTH, MAX_LOGGED};
use crate::objects::queries;
use crate::record::lists::{MAX_LIST_NESTING, MODE};
use crate::record::render_mode;
use crate::state::attrib::MAX_ATTRIB_STACK_DEPTH;
use crate::state::raster::HINTS;

fn hint(context: &Context, target: GLenum) -> GLenum {
    HINTS.get(target).map_or(GL_NONE, |row| context.state.raster.hints[row])
}

pub(super) const ROWS: &[Row] = rows! {
    GL_PERSPECTIVE_CORRECTION_HINT: Word(|c| hint(c, GL_PERSPECTIVE_CORRECTION_HINT));
    GL_POINT_SMOOTH_HINT: Word(|c| hint(c, GL_POINT_SMOOTH_HINT));
    GL_LINE_SMOOTH_HINT: Word(|c| hint(c, GL_LINE_SMOOTH_HINT));
    GL_POLYGON_SMOOTH_HINT: Word(|c| hint(c, GL_POLYGON_SMOOTH_HINT));
    GL_FOG_HINT: Word(|c| hint(c, GL_FOG_HINT));
    GL_GENERATE_MIPMAP_HINT: Word(|c| hint(c, GL_GENERATE_MIPMAP_HINT));
    GL_TEXTURE_COMPRESSION_HINT: Word(|c| hint(c, GL_TEXTURE_COMPRESSION_HINT));
    GL_FRAGMENT_SHADER_DERIVATIVE_HINT: Word(|c| hint(c, GL_FRAGMENT_SHADER_DERIVATIVE_HINT));

    GL_LIST_BASE: Word(|c| c.lists.base());
    GL_LIST_INDEX: Word(|c| c.compiling.as_ref().map_or(0, |list| list.name));
    GL_LIST_MODE: Word(|c| c.compiling.as_ref().map_or(0, |list| MODE.encode(list.mode)));
    GL_MAX_LIST_NESTING: Integer(|_| MAX_LIST_NESTING as i32);
    GL_ATTRIB_STACK_DEPTH: Integer(|c| c.attribs.depths()[0] as i32);
    GL_CLIENT_ATTRIB_STACK_DEPTH: Integer(|c| c.attribs.depths()[1] as i32);
    GL_MAX_ATTRIB_STACK_DEPTH: Integer(|_| MAX_ATTRIB_STACK_DEPTH as i32);
    GL_MAX_CLIENT_ATTRIB_STACK_DEPTH: Integer(|_| MAX_ATTRIB_STACK_DEPTH as i32);

    GL_RENDER_MODE: Word(|c| render_mode::MODE.encode(c.feedback.mode));
    GL_NAME_STACK_DEPTH: Integer(|c| saturated(c.feedback.select.depth()));
    GL_MAX_NAME_STACK_DEPTH: Integer(|_| saturated(MAX_NAME_STACK_DEPTH));
    GL_SELECTION_BUFFER_SIZE: Integer(|c| saturated(c.feedback.select.size()));
    GL_FEEDBACK_BUFFER_SIZE: Integer(|c| saturated(c.feedback.record.size()));
    GL_FEEDBACK_BUFFER_TYPE: Word(|c| FeedbackType::TABLE.encode(c.feedback.record.ty()));

    GL_DEBUG_OUTPUT: Enabled;
    GL_DEBUG_OUTPUT_SYNCHRONOUS: Enabled;
    GL_DEBUG_LOGGED_MESSAGES: Integer(|c| c.debug.log.len() as i32);
    GL_DEBUG_NEXT_LOGGED_MESSAGE_LENGTH:
        Integer(|c| c.debug.log.first().map_or(0, |first| first.text.len() as i32 + 1));
    GL_DEBUG_GROUP_STACK_DEPTH: Integer(|c| c.debug.log.depth() as i32);
    GL_MAX_DEBUG_LOGGED_MESSAGES: Integer(|_| MAX_LOGGED as i32);
    GL_MAX_DEBUG_MESSAGE_LENGTH: Integer(|_| MAX_LENGTH as i32);
    GL_MAX_DEBUG_GROUP_STACK_DEPTH: Integer(|_| MAX_GROUPS as i32);
    GL_MAX_LABEL_LENGTH: Integer(|_| MAX_LABEL as i32);
    GL_RESET_NOTIFICATION_STRATEGY: Word(|c| c.resets.notification.encode());
    // No access of a shader reaches beyond its buffers and textures, whatever was asked for.
    GL_CONTEXT_ROBUST_ACCESS: Integer(|_| 1);
    GL_CONTEXT_FLAGS: Word(|c| c.debug.context_flags() | c.profile.flags());
    GL_CONTEXT_PROFILE_MASK: Word(|c| c.profile.mask());

    GL_COPY_READ_BUFFER: Word(|c| c.state.bindings.copy_read_buffer.name());
    GL_DRAW_INDIRECT_BUFFER_BINDING: Word(|c| c.state.bindings.draw_indirect_buffer.name());
    GL_COPY_WRITE_BUFFER: Word(|c| c.state.bindings.copy_write_buffer.name());
    GL_MAX_SERVER_WAIT_TIMEOUT: Integer(|_| MAX_SERVER_WAIT_TIMEOUT as i32);
    // The clock runs on whatever the processor does.
    GL_GPU_DISJOINT_EXT: Flag(|_| false);
    // A double is exact for a hundred days of nanoseconds.
    GL_TIMESTAMP: Floats(|_| vec![queries::timestamp() as f64]);
};
