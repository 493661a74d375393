//! `glClear` and `glClearBuffer`: GL 2.1, section 4.2.3; GL 3.0, section 4.2.3.

use crate::base::constants::*;
use crate::base::convert::unit;
use crate::base::error::{Result, invalid_enum, invalid_operation, invalid_value};
use crate::base::limits;
use crate::base::types::*;
use crate::context::Context;
use crate::context::feedback::RenderMode;
use crate::draw::completeness::{draw_pass, draw_pass_of, draw_planes_of};
use crate::draw::pass::drawn_area;
use crate::draw::pipeline::srgb_write;
use crate::state::enable::Flag;
use crate::state::fragment::ClearColor;
use rasterizer::driver::{Attachment, ClearValue, Command, DepthWrite, PassDesc, texel_words};
use texunit::format::integer::encode_int;

/// The words of a colour in an attachment.
fn words(context: &Context, attachment: &Attachment, color: ClearColor) -> [u32; 4] {
    let Some(format) = crate::context::window::format_of(attachment) else { return [0; 4] };
    if format.is_integer() {
        let texel = encode_int(format, color.integers());
        return [0, 4, 8, 12].map(|at| {
            u32::from_le_bytes([texel[at], texel[at + 1], texel[at + 2], texel[at + 3]])
        });
    }
    texel_words(srgb_write(context).format(format), color.floats())
}

/// The clear of a colour attachment, if its mask lets anything through.
fn color(
    context: &Context,
    pass: &PassDesc,
    target: usize,
    color: ClearColor,
) -> Option<ClearValue> {
    let attachment = pass.colors.get(target)?.as_ref()?;
    let mask = context.state.fragment.buffers[target].mask;
    let words = words(context, attachment, color);
    let target = target as u8;
    mask.contains(&true).then_some(ClearValue::Texel { target, words, mask })
}

fn depth(context: &Context, framebuffer: GLuint, depth: f64) -> Option<ClearValue> {
    let is_written = context.state.fragment.depth_write == DepthWrite::On;
    (is_written && draw_planes_of(context, framebuffer).depth)
        .then_some(ClearValue::Depth(unit(depth) as f32))
}

fn stencil(context: &Context, framebuffer: GLuint, value: GLint) -> Option<ClearValue> {
    // The mask is that of the front face (GL 2.1, section 4.2.3).
    let mask = context.state.fragment.stencil.active().write_mask as u8;
    let is_written = draw_planes_of(context, framebuffer).stencil && mask != 0;
    is_written.then_some(ClearValue::Stencil { value: value as u8, mask })
}

/// Whether clears have an effect now.
fn is_effective(context: &Context) -> bool {
    context.feedback.mode == RenderMode::Render
        && !context.queries.discards()
        && !context.state.enables.has(Flag::RasterizerDiscard)
}

fn record(context: &mut Context, framebuffer: GLuint, pass: PassDesc, clears: Vec<ClearValue>) {
    let area = drawn_area(context, &pass);
    if !is_effective(context) || clears.is_empty() || area.width == 0 || area.height == 0 {
        return;
    }
    if framebuffer == 0 {
        context.window.depths.clear(&clears);
        let is_whole = [area.width, area.height] == [pass.width, pass.height];
        for value in &clears {
            match *value {
                ClearValue::Stencil { value, mask } if is_whole => {
                    context.window.stencils.clear(value, mask);
                }
                ClearValue::Stencil { .. } => context.window.stencils.written(),
                ClearValue::Depth(_) | ClearValue::Color { .. } | ClearValue::Texel { .. } => {}
            }
        }
    }
    let pixels = u64::from(area.width) * u64::from(area.height);
    context.lists.charge_pixels(pixels.saturating_mul(u64::from(pass.layers.max(1))));
    let watched = crate::draw::watched_pixel::is_watched(context, &pass);
    crate::draw::pass::begin_pass(context, pass);
    if watched {
        crate::draw::watched_pixel::watch_clear(context);
    }
    for value in clears {
        context.recorder.push(Command::Clear { value, area });
    }
}

pub(crate) fn clear(context: &mut Context, mask: GLbitfield) -> Result<()> {
    let accumulation = if context.profile.is_es() { 0 } else { GL_ACCUM_BUFFER_BIT };
    let known = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | accumulation;
    if mask & !known != 0 {
        return invalid_value(
            "GL 2.1, section 4.2.3",
            format!("mask = {mask:#x} has bits that name no buffer: {:#x}", mask & !known),
        );
    }
    let pass = draw_pass(context)?;
    let framebuffer = context.state.bindings.draw_framebuffer;
    let state = &context.state.clear;
    let mut clears = Vec::new();
    if mask & GL_COLOR_BUFFER_BIT != 0 {
        let targets = 0..pass.colors.len();
        clears.extend(targets.filter_map(|target| color(context, &pass, target, state.color)));
    }
    if mask & GL_DEPTH_BUFFER_BIT != 0 {
        clears.extend(depth(context, framebuffer, state.depth));
    }
    if mask & GL_STENCIL_BUFFER_BIT != 0 {
        clears.extend(stencil(context, framebuffer, state.stencil));
    }
    if mask & GL_ACCUM_BUFFER_BIT != 0 && is_effective(context) {
        let area = drawn_area(context, &pass);
        crate::calls::framebuffer::accumulate::clear(context, area)?;
    }
    record(context, framebuffer, pass, clears);
    Ok(())
}

const BUFFERS: &str = "GL 3.0, section 4.2.3";

/// What a `glClearBuffer` call clears.
enum Buffer {
    Color(usize),
    Depth,
    Stencil,
}

/// Checks `buffer` and `drawbuffer`; `takes` are the buffers that the call is for.
fn buffer(buffer: GLenum, drawbuffer: GLint, takes: &[GLenum]) -> Result<Buffer> {
    if !takes.contains(&buffer) {
        let names: Vec<String> = takes.iter().map(|&name| enum_name(name)).collect();
        return invalid_enum(
            BUFFERS,
            format!("buffer = {} must be {}", enum_name(buffer), names.join(" or ")),
        );
    }
    let most = if buffer == GL_COLOR { limits::MAX_COLOR_ATTACHMENTS } else { 1 };
    match usize::try_from(drawbuffer) {
        Ok(index) if index < most => Ok(match buffer {
            GL_COLOR => Buffer::Color(index),
            GL_DEPTH => Buffer::Depth,
            _ => Buffer::Stencil,
        }),
        Ok(_) | Err(_) => invalid_value(
            BUFFERS,
            format!("drawbuffer = {drawbuffer} must be 0 to {} here", most - 1),
        ),
    }
}

/// As many numbers as are needed.
fn numbers<const N: usize, T: Copy>(value: &[T]) -> Result<[T; N]> {
    match value.first_chunk() {
        Some(numbers) => Ok(*numbers),
        None => invalid_operation(BUFFERS, format!("value has {} numbers of {N}", value.len())),
    }
}

pub(crate) fn clear_bufferiv(
    context: &mut Context,
    name: GLenum,
    drawbuffer: GLint,
    value: &[GLint],
) -> Result<()> {
    let framebuffer = context.state.bindings.draw_framebuffer;
    clear_signed(context, framebuffer, (name, drawbuffer), value)
}

/// Clears colours of signed integers, or stencils.
pub(crate) fn clear_signed(
    context: &mut Context,
    framebuffer: GLuint,
    (name, drawbuffer): (GLenum, GLint),
    value: &[GLint],
) -> Result<()> {
    let clear = match buffer(name, drawbuffer, &[GL_COLOR, GL_STENCIL])? {
        Buffer::Color(target) => {
            let value = ClearColor::Signed(numbers(value)?);
            color(context, &draw_pass_of(context, framebuffer)?, target, value)
        }
        Buffer::Depth | Buffer::Stencil => {
            let [value] = numbers(value)?;
            stencil(context, framebuffer, value)
        }
    };
    let pass = draw_pass_of(context, framebuffer)?;
    record(context, framebuffer, pass, clear.into_iter().collect());
    Ok(())
}

pub(crate) fn clear_bufferuiv(
    context: &mut Context,
    name: GLenum,
    drawbuffer: GLint,
    value: &[GLuint],
) -> Result<()> {
    let framebuffer = context.state.bindings.draw_framebuffer;
    clear_unsigned(context, framebuffer, (name, drawbuffer), value)
}

/// Clears colours of unsigned integers.
pub(crate) fn clear_unsigned(
    context: &mut Context,
    framebuffer: GLuint,
    (name, drawbuffer): (GLenum, GLint),
    value: &[GLuint],
) -> Result<()> {
    let Buffer::Color(target) = buffer(name, drawbuffer, &[GL_COLOR])? else { return Ok(()) };
    let value = ClearColor::Unsigned(numbers(value)?);
    let pass = draw_pass_of(context, framebuffer)?;
    let clear = color(context, &pass, target, value);
    record(context, framebuffer, pass, clear.into_iter().collect());
    Ok(())
}

pub(crate) fn clear_bufferfv(
    context: &mut Context,
    name: GLenum,
    drawbuffer: GLint,
    value: &[GLfloat],
) -> Result<()> {
    let framebuffer = context.state.bindings.draw_framebuffer;
    clear_floats(context, framebuffer, (name, drawbuffer), value)
}

/// Clears colours of floats or fractions, or depths.
pub(crate) fn clear_floats(
    context: &mut Context,
    framebuffer: GLuint,
    (name, drawbuffer): (GLenum, GLint),
    value: &[GLfloat],
) -> Result<()> {
    let clear = match buffer(name, drawbuffer, &[GL_COLOR, GL_DEPTH])? {
        Buffer::Color(target) => {
            let value = ClearColor::Floats(numbers(value)?);
            color(context, &draw_pass_of(context, framebuffer)?, target, value)
        }
        Buffer::Depth | Buffer::Stencil => {
            let [value] = numbers(value)?;
            depth(context, framebuffer, value.into())
        }
    };
    let pass = draw_pass_of(context, framebuffer)?;
    record(context, framebuffer, pass, clear.into_iter().collect());
    Ok(())
}

pub(crate) fn clear_bufferfi(
    context: &mut Context,
    name: GLenum,
    drawbuffer: GLint,
    depth_value: GLfloat,
    stencil_value: GLint,
) -> Result<()> {
    let framebuffer = context.state.bindings.draw_framebuffer;
    clear_both(context, framebuffer, (name, drawbuffer), (depth_value, stencil_value))
}

/// Clears depths and stencils.
pub(crate) fn clear_both(
    context: &mut Context,
    framebuffer: GLuint,
    (name, drawbuffer): (GLenum, GLint),
    (depth_value, stencil_value): (GLfloat, GLint),
) -> Result<()> {
    buffer(name, drawbuffer, &[GL_DEPTH_STENCIL])?;
    let pass = draw_pass_of(context, framebuffer)?;
    let clears = depth(context, framebuffer, depth_value.into()).into_iter();
    let clears = clears.chain(stencil(context, framebuffer, stencil_value)).collect();
    record(context, framebuffer, pass, clears);
    Ok(())
}
