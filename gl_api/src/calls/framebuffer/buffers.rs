//! `glDrawBuffers` and `glReadBuffer`, and the formats of the buffers that they select: GL 2.1, sections 4.2.1 and 4.3.2.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum, invalid_operation, invalid_value, not_negative};
use crate::base::limits;
use crate::base::types::*;
use crate::context::Context;
use crate::draw::completeness::attached_format;
use crate::objects::color_buffers::{Selection, attachment_index};
use crate::pixel::component_bits::Component;
use texunit::format::Format;

const DRAW: &str = "GL 2.1, section 4.2.1";
const READ: &str = "GL 2.1, section 4.3.2";

/// Names of the default framebuffer's only colour buffer.
const WINDOW: [GLenum; 6] =
    [GL_FRONT, GL_BACK, GL_LEFT, GL_FRONT_LEFT, GL_BACK_LEFT, GL_FRONT_AND_BACK];
/// Names of buffers that the default framebuffer lacks.
const ABSENT: [GLenum; 7] =
    [GL_RIGHT, GL_FRONT_RIGHT, GL_BACK_RIGHT, GL_AUX0, GL_AUX1, GL_AUX2, GL_AUX3];

/// Checks the name of a buffer against a framebuffer (0 is the default one).
fn checked(
    section: &'static str,
    framebuffer: GLuint,
    argument: &str,
    buffer: GLenum,
) -> Result<()> {
    let name = enum_name(buffer);
    let of_object = buffer.wrapping_sub(GL_COLOR_ATTACHMENT0) < 16;
    if buffer == GL_NONE
        || framebuffer == 0 && WINDOW.contains(&buffer)
        || framebuffer != 0 && attachment_index(buffer).is_some()
    {
        return Ok(());
    }
    if of_object && framebuffer == 0 {
        return invalid_operation(
            section,
            format!("{argument} = {name}, but the default framebuffer is bound; use GL_BACK"),
        );
    }
    if framebuffer != 0 && (WINDOW.contains(&buffer) || ABSENT.contains(&buffer)) {
        return invalid_operation(
            section,
            format!(
                "{argument} = {name}, but framebuffer {framebuffer} is bound; use \
                 GL_COLOR_ATTACHMENTi"
            ),
        );
    }
    if ABSENT.contains(&buffer) || of_object {
        return invalid_operation(section, format!("{argument} = {name}: there is no such buffer"));
    }
    invalid_enum(section, format!("{argument} = {name} must name a colour buffer"))
}

/// Which buffers of a framebuffer are drawn to and read from.
pub(crate) fn selection(context: &Context, framebuffer: GLuint) -> &Selection {
    let window = &context.window.selection;
    context.objects.framebuffers.get(framebuffer).map_or(window, |object| &object.selection)
}

/// The same, to be changed.
pub(crate) fn selection_mut(context: &mut Context, framebuffer: GLuint) -> &mut Selection {
    match context.objects.framebuffers.get_mut(framebuffer) {
        Some(object) => &mut object.selection,
        None => &mut context.window.selection,
    }
}

pub(crate) fn draw_buffer(context: &mut Context, buf: GLenum) -> Result<()> {
    let framebuffer = context.state.bindings.draw_framebuffer;
    select_draw_buffer(context, framebuffer, buf)
}

/// Sets which colour buffer of a framebuffer is drawn to.
pub(crate) fn select_draw_buffer(
    context: &mut Context,
    framebuffer: GLuint,
    buf: GLenum,
) -> Result<()> {
    checked(DRAW, framebuffer, "buf", buf)?;
    let selection = selection_mut(context, framebuffer);
    selection.draw = Selection::first(buf).draw;
    Ok(())
}

/// What `glPushAttrib` saves: what the bound framebuffers draw to and read from.
pub(crate) fn selected(context: &Context) -> Selection {
    let bindings = &context.state.bindings;
    Selection {
        draw: selection(context, bindings.draw_framebuffer).draw,
        read: selection(context, bindings.read_framebuffer).read,
    }
}

/// Draws to saved buffers again, unless another framebuffer is bound that has none of such names.
pub(crate) fn draw_again(context: &mut Context, saved: &Selection) {
    let framebuffer = context.state.bindings.draw_framebuffer;
    if saved.draw.iter().all(|&buffer| checked(DRAW, framebuffer, "buf", buffer).is_ok()) {
        selection_mut(context, framebuffer).draw = saved.draw;
    }
}

/// Reads from a saved buffer again, as [`draw_again`].
pub(crate) fn read_again(context: &mut Context, saved: &Selection) {
    let framebuffer = context.state.bindings.read_framebuffer;
    if checked(READ, framebuffer, "src", saved.read).is_ok() {
        selection_mut(context, framebuffer).read = saved.read;
    }
}

/// What names one buffer or more, which has no place in an array of buffers.
const SEVERAL: [GLenum; 5] = [GL_FRONT, GL_BACK, GL_LEFT, GL_RIGHT, GL_FRONT_AND_BACK];

pub(crate) fn draw_buffers(context: &mut Context, n: GLsizei, bufs: &[GLenum]) -> Result<()> {
    let framebuffer = context.state.bindings.draw_framebuffer;
    select_draw_buffers(context, framebuffer, n, bufs)
}

/// Sets which colour buffer of a framebuffer each fragment colour is drawn to.
pub(crate) fn select_draw_buffers(
    context: &mut Context,
    framebuffer: GLuint,
    n: GLsizei,
    bufs: &[GLenum],
) -> Result<()> {
    let n = not_negative(DRAW, "n", n.into())?;
    if n > limits::MAX_COLOR_ATTACHMENTS {
        return invalid_value(
            DRAW,
            format!("n = {n} must not be above {}", limits::MAX_COLOR_ATTACHMENTS),
        );
    }
    let Some(bufs) = bufs.get(..n) else {
        return invalid_operation(DRAW, format!("n = {n}, but bufs has {}", bufs.len()));
    };
    if context.profile.is_es() {
        check_es_order(framebuffer, bufs)?;
        return select(context, framebuffer, bufs);
    }
    for (index, &buf) in bufs.iter().enumerate() {
        if SEVERAL.contains(&buf) {
            return invalid_enum(
                "GL 3.1, section 4.2.1",
                format!(
                    "bufs[{index}] = {} may name several buffers: name one, as GL_BACK_LEFT",
                    enum_name(buf)
                ),
            );
        }
        checked(DRAW, framebuffer, &format!("bufs[{index}]"), buf)?;
        if buf != GL_NONE && bufs[..index].contains(&buf) {
            return invalid_operation(
                DRAW,
                format!("bufs[{index}] = {} was named before", enum_name(buf)),
            );
        }
    }
    select(context, framebuffer, bufs)
}

fn select(context: &mut Context, framebuffer: GLuint, bufs: &[GLenum]) -> Result<()> {
    let mut draw = [GL_NONE; limits::MAX_COLOR_ATTACHMENTS];
    draw[..bufs.len()].copy_from_slice(bufs);
    selection_mut(context, framebuffer).draw = draw;
    Ok(())
}

/// In OpenGL ES, the default framebuffer has `GL_BACK`, and buffer `i` of others is their attachment `i` (3.0, section
/// 4.2.1).
fn check_es_order(framebuffer: GLuint, bufs: &[GLenum]) -> Result<()> {
    const SECTION: &str = "OpenGL ES 3.0, section 4.2.1";
    if framebuffer == 0 && bufs.len() != 1 {
        let rule = format!("n = {} must be 1 for the default framebuffer", bufs.len());
        return invalid_operation(SECTION, rule);
    }
    for (index, &buf) in bufs.iter().enumerate() {
        let own = if framebuffer == 0 { GL_BACK } else { GL_COLOR_ATTACHMENT0 + index as GLenum };
        check_es_name(SECTION, &format!("bufs[{index}]"), buf)?;
        if buf != GL_NONE && buf != own {
            let [name, own] = [buf, own].map(enum_name);
            let rule = format!("bufs[{index}] = {name} must be {own} or GL_NONE");
            return invalid_operation(SECTION, rule);
        }
    }
    Ok(())
}

/// OpenGL ES names no buffers but `GL_BACK` and the colour attachments, whose numbers may be too large (3.0, section
/// 4.3.1).
fn check_es_name(section: &'static str, argument: &str, buffer: GLenum) -> Result<()> {
    let is_color = buffer.wrapping_sub(GL_COLOR_ATTACHMENT0) < 32;
    if buffer == GL_NONE || buffer == GL_BACK || is_color && attachment_index(buffer).is_some() {
        return Ok(());
    }
    let name = enum_name(buffer);
    if is_color {
        let most = limits::MAX_COLOR_ATTACHMENTS - 1;
        let rule = format!("{argument} = {name} must be GL_COLOR_ATTACHMENT0 to {most}");
        return invalid_operation(section, rule);
    }
    invalid_enum(section, format!("{argument} = {name} names no colour buffer of OpenGL ES"))
}

pub(crate) fn read_buffer(context: &mut Context, src: GLenum) -> Result<()> {
    let framebuffer = context.state.bindings.read_framebuffer;
    select_read_buffer(context, framebuffer, src)
}

/// Sets which colour buffer of a framebuffer is read from.
pub(crate) fn select_read_buffer(
    context: &mut Context,
    framebuffer: GLuint,
    src: GLenum,
) -> Result<()> {
    if context.profile.is_es() {
        check_es_name("OpenGL ES 3.0, section 4.3.1", "src", src)?;
    }
    checked(READ, framebuffer, "src", src)?;
    selection_mut(context, framebuffer).read = src;
    Ok(())
}

/// The format of the first buffer that is drawn to, or of depth or stencil.
pub(crate) fn drawn_format(context: &Context, component: Component) -> Option<Format> {
    let Some(object) = context.objects.framebuffers.get(context.state.bindings.draw_framebuffer)
    else {
        let window = &context.window;
        return match component {
            Component::Depth => window.depth_format().filter(|_| window.planes.depth),
            Component::Stencil => window.depth_format().filter(|_| window.planes.stencil),
            Component::Red
            | Component::Green
            | Component::Blue
            | Component::Alpha
            | Component::Luminance
            | Component::Intensity => Some(window.format),
        };
    };
    let attached = match component {
        Component::Depth => object.depth.as_ref(),
        Component::Stencil => object.stencil.as_ref(),
        Component::Red
        | Component::Green
        | Component::Blue
        | Component::Alpha
        | Component::Luminance
        | Component::Intensity => {
            let drawn = object.selection.draw.iter().find_map(|&buffer| attachment_index(buffer));
            object.colors[drawn?].as_ref()
        }
    };
    attached_format(attached?)
}
