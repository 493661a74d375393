//! Attaching images to framebuffer objects: `ARB_framebuffer_object`, sections 4.4.2 to 4.4.4.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum};
use crate::base::limits;
use crate::base::types::*;
use crate::objects::color_buffers::attachment_index;

const SECTION: &str = "ARB_framebuffer_object, section 4.4.2";

/// Where an image can be attached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Point {
    Color(usize),
    Depth,
    Stencil,
    /// Both at once.
    DepthStencil,
}

pub(crate) fn point(attachment: GLenum) -> Result<Point> {
    match attachment {
        GL_DEPTH_ATTACHMENT => Ok(Point::Depth),
        GL_STENCIL_ATTACHMENT => Ok(Point::Stencil),
        GL_DEPTH_STENCIL_ATTACHMENT => Ok(Point::DepthStencil),
        _ => match attachment_index(attachment) {
            Some(index) => Ok(Point::Color(index)),
            None => invalid_enum(
                SECTION,
                format!(
                    "attachment = {} must be GL_COLOR_ATTACHMENT0 to {}, GL_DEPTH_ATTACHMENT, \
                     GL_STENCIL_ATTACHMENT or GL_DEPTH_STENCIL_ATTACHMENT",
                    enum_name(attachment),
                    limits::MAX_COLOR_ATTACHMENTS - 1
                ),
            ),
        },
    }
}
