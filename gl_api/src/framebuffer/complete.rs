//! Framebuffer completeness (`ARB_framebuffer_object`, section 4.4.4), and the pass that a complete
//! framebuffer is drawn in.

use super::buffers::attachment_index;
use super::{Presence, whole};
use crate::constants::*;
use crate::context::Context;
use crate::error::{ErrorCode, GlError, Result};
use crate::object::framebuffers::Attached;
use crate::texture::internal::{Component, component_bits};
use crate::texture::texel::is_renderable;
use crate::types::*;
use rasterizer::driver::{Attachment, PassDesc};
use texunit::format::Format;

const SECTION: &str = "ARB_framebuffer_object, section 4.4.4";

/// Why a framebuffer cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Incomplete {
    /// What `glCheckFramebufferStatus` answers.
    pub status: GLenum,
    pub reason: String,
}

/// An attached image, found.
struct Found {
    format: Format,
    width: u32,
    height: u32,
    attachment: Attachment,
}

/// The image behind an attachment, or what is missing.
fn find(context: &Context, attached: Attached) -> std::result::Result<Found, String> {
    match attached {
        Attached::Texture { name, target, level } => {
            let Some(texture) = context.objects.textures.get(name) else {
                return Err(format!("texture {name} was deleted"));
            };
            let texels = texture.image.texels();
            match texels.level(target.face.into(), level) {
                Some(texels) if texels.border != [0; 3] => Err(format!(
                    "texture {name} has a border at level {level}, which cannot be drawn to"
                )),
                Some(texels) if texels.width > 0 && texels.height > 0 => Ok(Found {
                    format: texels.format,
                    width: texels.width,
                    height: texels.height,
                    attachment: Attachment {
                        image: texture.image.clone(),
                        face: target.face,
                        level: level as u8,
                    },
                }),
                Some(_) | None => Err(format!(
                    "texture {name} has no image at level {level}: call glTexImage2D with a size"
                )),
            }
        }
        Attached::Renderbuffer(name) => {
            let Some(renderbuffer) = context.objects.renderbuffers.get(name) else {
                return Err(format!("renderbuffer {name} was deleted"));
            };
            match &renderbuffer.storage {
                Some((format, image)) => Ok(Found {
                    format: *format,
                    width: renderbuffer.width,
                    height: renderbuffer.height,
                    attachment: whole(image),
                }),
                None => Err(format!(
                    "renderbuffer {name} has no image: call glRenderbufferStorage with a size"
                )),
            }
        }
    }
}

/// Bits of a component of an attached image.
pub(super) fn bits(context: &Context, attached: Attached, component: Component) -> GLint {
    find(context, attached).map_or(0, |found| component_bits(found.format, component))
}

/// Bits of the depth buffer that is drawn to.
pub(super) fn draw_depth_bits(context: &Context) -> GLint {
    match context.objects.framebuffers.get(context.state.bindings.draw_framebuffer) {
        Some(object) => {
            object.depth.map_or(0, |attached| bits(context, attached, Component::Depth))
        }
        None => 24,
    }
}

/// Whether a framebuffer (0 is the default one, which is complete) can be used.
pub(super) fn completeness(context: &Context, name: GLuint) -> std::result::Result<(), Incomplete> {
    let incomplete = |status, reason: String| Err(Incomplete { status, reason });
    let Some(object) = context.objects.framebuffers.get(name) else {
        return match context.window.presence {
            Presence::Present => Ok(()),
            Presence::Absent => incomplete(
                GL_FRAMEBUFFER_UNDEFINED,
                "the context is current without a surface: bind a framebuffer object".into(),
            ),
        };
    };
    let mut any = false;
    let colors = object
        .colors
        .iter()
        .enumerate()
        .map(|(index, attached)| (format!("GL_COLOR_ATTACHMENT{index}"), *attached, false));
    let depth = ("GL_DEPTH_ATTACHMENT".to_owned(), object.depth, true);
    for (point, attached, wants_depth) in colors.chain([depth]) {
        let Some(attached) = attached else { continue };
        any = true;
        let reason = match find(context, attached) {
            Ok(found) if !is_renderable(found.format) => {
                format!("nothing is drawn to images of {:?}", found.format)
            }
            Ok(found) if found.format.is_depth() == wants_depth => continue,
            Ok(_) if wants_depth => "its format has no depth".to_owned(),
            Ok(_) => "a depth format cannot be a colour".to_owned(),
            Err(reason) => reason,
        };
        return incomplete(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT, format!("{point}: {reason}"));
    }
    if !any {
        return incomplete(
            GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT,
            format!("framebuffer {name} has no attachment at all"),
        );
    }
    let absent = |buffer: GLenum| {
        attachment_index(buffer).is_some_and(|index| object.colors[index].is_none())
    };
    for &buffer in &object.selection.draw {
        if absent(buffer) {
            return incomplete(
                GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER,
                format!(
                    "{} is drawn to, but nothing is attached there; without colours call \
                     glDrawBuffer(GL_NONE)",
                    enum_name(buffer)
                ),
            );
        }
    }
    if absent(object.selection.read) {
        return incomplete(
            GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER,
            format!(
                "{} is read from, but nothing is attached there; without colours call \
                 glReadBuffer(GL_NONE)",
                enum_name(object.selection.read)
            ),
        );
    }
    Ok(())
}

/// [`completeness`] as the error of a call that needs it.
pub(super) fn checked_complete(context: &Context, name: GLuint) -> Result<()> {
    completeness(context, name).map_err(|incomplete| GlError {
        code: ErrorCode::InvalidFramebufferOperation,
        rule: format!("framebuffer {name} is incomplete: {}", incomplete.reason),
        section: SECTION,
    })
}

/// The pass that the draw framebuffer is drawn in; colours by fragment output.
///
/// # Errors
/// `GL_INVALID_FRAMEBUFFER_OPERATION` where it is incomplete.
pub(crate) fn draw_pass(context: &Context) -> Result<PassDesc> {
    let name = context.state.bindings.draw_framebuffer;
    checked_complete(context, name)?;
    let Some(object) = context.objects.framebuffers.get(name) else {
        let window = &context.window;
        let color = (window.selection.draw[0] != GL_NONE).then(|| whole(&window.color));
        return Ok(PassDesc {
            colors: vec![color],
            depth: Some(whole(&window.depth)),
            width: window.width,
            height: window.height,
        });
    };
    // Attachments of different sizes are drawn to where all of them are.
    let (mut width, mut height) = (u32::MAX, u32::MAX);
    let mut found = |attached: Option<Attached>| {
        let found = find(context, attached?).ok()?;
        width = width.min(found.width);
        height = height.min(found.height);
        Some(found.attachment)
    };
    for attached in object.colors.iter().chain([&object.depth]) {
        found(*attached);
    }
    let mut colors: Vec<_> = object
        .selection
        .draw
        .iter()
        .map(|&buffer| attachment_index(buffer).and_then(|index| found(object.colors[index])))
        .collect();
    let used = colors.iter().rposition(Option::is_some).map_or(0, |last| last + 1);
    colors.truncate(used);
    let depth = found(object.depth);
    Ok(PassDesc { colors, depth, width, height })
}

/// The image that is read from: colour, or depth.
pub(super) fn read_attachment(context: &Context, depth: bool) -> Result<Option<Attachment>> {
    let name = context.state.bindings.read_framebuffer;
    checked_complete(context, name)?;
    let Some(object) = context.objects.framebuffers.get(name) else {
        let window = &context.window;
        let color = (window.selection.read != GL_NONE).then(|| whole(&window.color));
        return Ok(if depth { Some(whole(&window.depth)) } else { color });
    };
    let attached = if depth {
        object.depth
    } else {
        attachment_index(object.selection.read).and_then(|index| object.colors[index])
    };
    Ok(attached.and_then(|attached| find(context, attached).ok()).map(|found| found.attachment))
}
