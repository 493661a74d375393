//! Calls that name their framebuffer or renderbuffer: `ARB_direct_state_access`, chapters 9, 17 and 18. Each gives the call
//! of the same subject an object that need not be bound.

use crate::base::error::Result;
use crate::base::types::*;
use crate::calls::framebuffer::attach::{
    Destination, attach_layer, attach_level, attach_renderbuffer, status,
};
use crate::calls::framebuffer::blit::{Sides, blit};
use crate::calls::framebuffer::buffers::{
    select_draw_buffer, select_draw_buffers, select_read_buffer,
};
use crate::calls::framebuffer::clear::{clear_both, clear_floats, clear_signed, clear_unsigned};
use crate::calls::framebuffer::inspect::attachment_parameter;
use crate::calls::framebuffer::invalidate::{check_attachments, check_size};
use crate::calls::framebuffer::names::{check_framebuffer, check_object};
use crate::calls::framebuffer::parameters;
use crate::calls::framebuffer::renderbuffers::{initial_format, named, parameter, set_storage};
use crate::context::Context;
use crate::objects::framebuffers::{FRAMEBUFFER_TARGET, Framebuffer};
use crate::objects::renderbuffers::Renderbuffer;

const SECTION: &str = "ARB_direct_state_access, section 9.2";

pub(crate) fn create_framebuffers(
    context: &mut Context,
    n: GLsizei,
    framebuffers: &mut [GLuint],
) -> Result<()> {
    context.objects.framebuffers.add_each(SECTION, n, framebuffers, Framebuffer::new)
}

pub(crate) fn create_renderbuffers(
    context: &mut Context,
    n: GLsizei,
    renderbuffers: &mut [GLuint],
) -> Result<()> {
    let initial = initial_format(context);
    context
        .objects
        .shared
        .renderbuffers
        .add_each(SECTION, n, renderbuffers, || Renderbuffer::new(initial))
}

/// A point of a framebuffer object.
fn destination(context: &Context, framebuffer: GLuint, attachment: GLenum) -> Result<Destination> {
    check_object(context, "framebuffer", framebuffer)?;
    Destination::of(framebuffer, attachment)
}

pub(crate) fn named_framebuffer_renderbuffer(
    context: &mut Context,
    framebuffer: GLuint,
    attachment: GLenum,
    renderbuffertarget: GLenum,
    renderbuffer: GLuint,
) -> Result<()> {
    let destination = destination(context, framebuffer, attachment)?;
    attach_renderbuffer(context, destination, renderbuffertarget, renderbuffer)
}

pub(crate) fn named_framebuffer_texture(
    context: &mut Context,
    framebuffer: GLuint,
    attachment: GLenum,
    texture: GLuint,
    level: GLint,
) -> Result<()> {
    let destination = destination(context, framebuffer, attachment)?;
    attach_level(context, destination, texture, level)
}

pub(crate) fn named_framebuffer_texture_layer(
    context: &mut Context,
    framebuffer: GLuint,
    attachment: GLenum,
    texture: GLuint,
    level: GLint,
    layer: GLint,
) -> Result<()> {
    let destination = destination(context, framebuffer, attachment)?;
    attach_layer(context, destination, texture, level, layer)
}

pub(crate) fn named_framebuffer_parameteri(
    context: &mut Context,
    framebuffer: GLuint,
    pname: GLenum,
    param: GLint,
) -> Result<()> {
    check_object(context, "framebuffer", framebuffer)?;
    parameters::set_parameter(context, framebuffer, pname, param)
}

pub(crate) fn named_framebuffer_draw_buffer(
    context: &mut Context,
    framebuffer: GLuint,
    buf: GLenum,
) -> Result<()> {
    check_framebuffer(context, "framebuffer", framebuffer)?;
    select_draw_buffer(context, framebuffer, buf)
}

pub(crate) fn named_framebuffer_draw_buffers(
    context: &mut Context,
    framebuffer: GLuint,
    n: GLsizei,
    bufs: &[GLenum],
) -> Result<()> {
    check_framebuffer(context, "framebuffer", framebuffer)?;
    select_draw_buffers(context, framebuffer, n, bufs)
}

pub(crate) fn named_framebuffer_read_buffer(
    context: &mut Context,
    framebuffer: GLuint,
    src: GLenum,
) -> Result<()> {
    check_framebuffer(context, "framebuffer", framebuffer)?;
    select_read_buffer(context, framebuffer, src)
}

pub(crate) fn invalidate_named_framebuffer_data(
    context: &mut Context,
    framebuffer: GLuint,
    num_attachments: GLsizei,
    attachments: &[GLenum],
) -> Result<()> {
    check_framebuffer(context, "framebuffer", framebuffer)?;
    check_attachments(framebuffer, num_attachments, attachments)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn invalidate_named_framebuffer_sub_data(
    context: &mut Context,
    framebuffer: GLuint,
    num_attachments: GLsizei,
    attachments: &[GLenum],
    _x: GLint,
    _y: GLint,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    check_framebuffer(context, "framebuffer", framebuffer)?;
    check_size(width, height)?;
    check_attachments(framebuffer, num_attachments, attachments)
}

pub(crate) fn clear_named_framebufferiv(
    context: &mut Context,
    framebuffer: GLuint,
    buffer: GLenum,
    drawbuffer: GLint,
    value: &[GLint],
) -> Result<()> {
    check_framebuffer(context, "framebuffer", framebuffer)?;
    clear_signed(context, framebuffer, (buffer, drawbuffer), value)
}

pub(crate) fn clear_named_framebufferuiv(
    context: &mut Context,
    framebuffer: GLuint,
    buffer: GLenum,
    drawbuffer: GLint,
    value: &[GLuint],
) -> Result<()> {
    check_framebuffer(context, "framebuffer", framebuffer)?;
    clear_unsigned(context, framebuffer, (buffer, drawbuffer), value)
}

pub(crate) fn clear_named_framebufferfv(
    context: &mut Context,
    framebuffer: GLuint,
    buffer: GLenum,
    drawbuffer: GLint,
    value: &[GLfloat],
) -> Result<()> {
    check_framebuffer(context, "framebuffer", framebuffer)?;
    clear_floats(context, framebuffer, (buffer, drawbuffer), value)
}

pub(crate) fn clear_named_framebufferfi(
    context: &mut Context,
    framebuffer: GLuint,
    buffer: GLenum,
    drawbuffer: GLint,
    depth: GLfloat,
    stencil: GLint,
) -> Result<()> {
    check_framebuffer(context, "framebuffer", framebuffer)?;
    clear_both(context, framebuffer, (buffer, drawbuffer), (depth, stencil))
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn blit_named_framebuffer(
    context: &mut Context,
    read_framebuffer: GLuint,
    draw_framebuffer: GLuint,
    src_x0: GLint,
    src_y0: GLint,
    src_x1: GLint,
    src_y1: GLint,
    dst_x0: GLint,
    dst_y0: GLint,
    dst_x1: GLint,
    dst_y1: GLint,
    mask: GLbitfield,
    filter: GLenum,
) -> Result<()> {
    check_framebuffer(context, "readFramebuffer", read_framebuffer)?;
    check_framebuffer(context, "drawFramebuffer", draw_framebuffer)?;
    let sides = Sides { read: read_framebuffer, draw: draw_framebuffer };
    let (src, dst) = ([src_x0, src_y0, src_x1, src_y1], [dst_x0, dst_y0, dst_x1, dst_y1]);
    blit(context, sides, (src, dst), mask, filter)
}

pub(crate) fn check_named_framebuffer_status(
    context: &mut Context,
    framebuffer: GLuint,
    target: GLenum,
) -> Result<GLenum> {
    FRAMEBUFFER_TARGET.decode("target", target)?;
    check_framebuffer(context, "framebuffer", framebuffer)?;
    Ok(status(context, framebuffer))
}

pub(crate) fn get_named_framebuffer_parameteriv(
    context: &mut Context,
    framebuffer: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    check_framebuffer(context, "framebuffer", framebuffer)?;
    parameters::parameter(context, framebuffer, pname, params)
}

pub(crate) fn get_named_framebuffer_attachment_parameteriv(
    context: &mut Context,
    framebuffer: GLuint,
    attachment: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    check_framebuffer(context, "framebuffer", framebuffer)?;
    attachment_parameter(context, framebuffer, attachment, pname, params)
}

pub(crate) fn named_renderbuffer_storage(
    context: &mut Context,
    renderbuffer: GLuint,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    let samples = 0;
    named_renderbuffer_storage_multisample(
        context,
        renderbuffer,
        samples,
        internalformat,
        width,
        height,
    )
}

pub(crate) fn named_renderbuffer_storage_multisample(
    context: &mut Context,
    renderbuffer: GLuint,
    samples: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    let renderbuffer = named(context, renderbuffer)?;
    set_storage(context, renderbuffer, samples, internalformat, [width, height])
}

pub(crate) fn get_named_renderbuffer_parameteriv(
    context: &mut Context,
    renderbuffer: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let renderbuffer = named(context, renderbuffer)?;
    parameter(context, &renderbuffer, pname, params)
}
