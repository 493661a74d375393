//! `glInvalidateFramebuffer` and `glInvalidateSubFramebuffer` (`ARB_invalidate_subdata`; OpenGL ES 3.0, section 4.5),
//! `glDiscardFramebufferEXT`: what is named may be forgotten. It is kept: contents that depend on nothing else are the
//! same on every machine.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum, invalid_operation, not_negative};
use crate::base::types::*;
use crate::calls::framebuffer::names::bound;
use crate::context::Context;
use crate::objects::color_buffers::attachment_index;
use crate::objects::framebuffers::FRAMEBUFFER_TARGET;

const SECTION: &str = "OpenGL ES 3.0, section 4.5";

/// Checks the names of the attachments of the framebuffer that is bound to a target.
fn check(context: &Context, target: GLenum, count: GLsizei, attachments: &[GLenum]) -> Result<()> {
    let name = bound(context, FRAMEBUFFER_TARGET.decode("target", target)?);
    check_attachments(name, count, attachments)
}

/// Checks the names of the attachments of a framebuffer.
pub(crate) fn check_attachments(
    name: GLuint,
    count: GLsizei,
    attachments: &[GLenum],
) -> Result<()> {
    let count = not_negative(SECTION, "numAttachments", count.into())?;
    for &attachment in attachments.iter().take(count) {
        let fits = match name {
            0 => matches!(attachment, GL_COLOR | GL_DEPTH | GL_STENCIL),
            _ => matches!(
                attachment,
                GL_DEPTH_ATTACHMENT | GL_STENCIL_ATTACHMENT | GL_DEPTH_STENCIL_ATTACHMENT
            ),
        };
        let is_color =
            name != 0 && (GL_COLOR_ATTACHMENT0..=GL_COLOR_ATTACHMENT31).contains(&attachment);
        if is_color && attachment_index(attachment).is_none() {
            let rule = format!("{} is beyond GL_MAX_COLOR_ATTACHMENTS", enum_name(attachment));
            return invalid_operation(SECTION, rule);
        }
        if !fits && !is_color {
            let attachment = enum_name(attachment);
            let names = if name == 0 {
                "the default framebuffer has GL_COLOR, GL_DEPTH and GL_STENCIL"
            } else {
                "framebuffer objects have GL_COLOR_ATTACHMENT0 and so on, GL_DEPTH_ATTACHMENT and \
                 GL_STENCIL_ATTACHMENT"
            };
            return invalid_enum(SECTION, format!("attachments: {attachment}: {names}"));
        }
    }
    Ok(())
}

pub(crate) fn invalidate_framebuffer(
    context: &mut Context,
    target: GLenum,
    numattachments: GLsizei,
    attachments: &[GLenum],
) -> Result<()> {
    check(context, target, numattachments, attachments)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn invalidate_sub_framebuffer(
    context: &mut Context,
    target: GLenum,
    numattachments: GLsizei,
    attachments: &[GLenum],
    _x: GLint,
    _y: GLint,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    check_size(width, height)?;
    check(context, target, numattachments, attachments)
}

/// Checks the size of a part of a framebuffer.
pub(crate) fn check_size(width: GLsizei, height: GLsizei) -> Result<()> {
    not_negative(SECTION, "width", width.into())?;
    not_negative(SECTION, "height", height.into())?;
    Ok(())
}
