//! Which buffers are drawn to and read from: GL 2.1, sections 4.2.1 and 4.3.2.

use crate::base::constants::*;
use crate::base::limits;
use crate::base::types::*;

/// The draw and read buffers of a framebuffer, as GL names them.
#[derive(Clone, Debug)]
pub(crate) struct Selection {
    /// By fragment colour.
    pub draw: [GLenum; limits::MAX_COLOR_ATTACHMENTS],
    pub read: GLenum,
}

impl Selection {
    pub(crate) fn first(buffer: GLenum) -> Self {
        let mut draw = [GL_NONE; limits::MAX_COLOR_ATTACHMENTS];
        draw[0] = buffer;
        Self { draw, read: buffer }
    }

    /// Of a new default framebuffer.
    pub fn window() -> Self {
        Self::first(GL_FRONT)
    }

    /// Of a new framebuffer object.
    pub fn object() -> Self {
        Self::first(GL_COLOR_ATTACHMENT0)
    }
}

/// The attachment that a name stands for in a framebuffer object.
pub(crate) fn attachment_index(buffer: GLenum) -> Option<usize> {
    let index = buffer.checked_sub(GL_COLOR_ATTACHMENT0)? as usize;
    (index < limits::MAX_COLOR_ATTACHMENTS).then_some(index)
}
