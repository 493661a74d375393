//! The draw buffers and the read buffer of a framebuffer: GL 2.1, sections 4.2.1 and 4.3.2.

use crate::base::constants::*;
use crate::base::limits;
use crate::base::types::*;

/// The draw and read buffers of a framebuffer, as GL names them.
#[derive(Clone, Debug)]
pub(crate) struct Selection {
    /// By the number of the fragment colour.
    pub draw: [GLenum; limits::MAX_COLOR_ATTACHMENTS],
    pub read: GLenum,
}

impl Selection {
    pub(crate) fn first(buffer: GLenum) -> Self {
        let mut draw = [GL_NONE; limits::MAX_COLOR_ATTACHMENTS];
        draw[0] = buffer;
        Self { draw, read: buffer }
    }

    /// The initial selection of the default framebuffer.
    pub fn window() -> Self {
        Self::first(GL_FRONT)
    }

    /// The same of OpenGL ES, which has no other name of the buffer (3.0, section 4.2.1).
    pub fn window_of_es() -> Self {
        Self::first(GL_BACK)
    }

    /// The initial selection of a framebuffer object.
    pub fn object() -> Self {
        Self::first(GL_COLOR_ATTACHMENT0)
    }
}

/// The index of a colour attachment.
pub(crate) fn attachment_index(buffer: GLenum) -> Option<usize> {
    let index = buffer.checked_sub(GL_COLOR_ATTACHMENT0)? as usize;
    (index < limits::MAX_COLOR_ATTACHMENTS).then_some(index)
}
