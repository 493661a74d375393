//! Which components are written, which buffers are blended, and the logical operation: GL 2.1,
//! sections 4.1.10 and 4.2.2; `EXT_draw_buffers2`.

use super::enable::Flag;
use super::multisample;
use crate::constants::*;
use crate::context::{Context, limits};
use crate::error::{Result, Table, invalid_enum, invalid_value};
use crate::transform_feedback::bindings;
use crate::types::*;
use rasterizer::driver::LogicOp;

const SECTION: &str = "EXT_draw_buffers2, section 4.2.2";

pub(crate) const LOGIC_OP: Table<LogicOp> = Table {
    section: "GL 2.1, table 4.3",
    rows: &[
        (GL_CLEAR, LogicOp::Clear),
        (GL_AND, LogicOp::And),
        (GL_AND_REVERSE, LogicOp::AndReverse),
        (GL_COPY, LogicOp::Copy),
        (GL_AND_INVERTED, LogicOp::AndInverted),
        (GL_NOOP, LogicOp::Noop),
        (GL_XOR, LogicOp::Xor),
        (GL_OR, LogicOp::Or),
        (GL_NOR, LogicOp::Nor),
        (GL_EQUIV, LogicOp::Equivalent),
        (GL_INVERT, LogicOp::Invert),
        (GL_OR_REVERSE, LogicOp::OrReverse),
        (GL_COPY_INVERTED, LogicOp::CopyInverted),
        (GL_OR_INVERTED, LogicOp::OrInverted),
        (GL_NAND, LogicOp::Nand),
        (GL_SET, LogicOp::Set),
    ],
};

/// What differs from draw buffer to draw buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct BufferState {
    /// Which of red, green, blue, alpha are written.
    pub mask: [bool; 4],
    /// Whether it is blended.
    pub blend: bool,
}

/// By draw buffer.
pub(crate) type BufferStates = [BufferState; limits::MAX_COLOR_ATTACHMENTS];

/// The initial state.
pub(crate) const BUFFERS: BufferStates =
    [BufferState { mask: [true; 4], blend: false }; limits::MAX_COLOR_ATTACHMENTS];

pub(crate) fn logic_op(context: &mut Context, opcode: GLenum) -> Result<()> {
    context.state.fragment.logic_op = LOGIC_OP.decode("opcode", opcode)?;
    Ok(())
}

/// The number of a draw buffer.
fn index(argument: &str, index: GLuint) -> Result<usize> {
    let limit = limits::MAX_COLOR_ATTACHMENTS;
    match usize::try_from(index) {
        Ok(index) if index < limit => Ok(index),
        Ok(_) | Err(_) => {
            invalid_value(SECTION, format!("{argument} = {index} must be 0 to {}", limit - 1))
        }
    }
}

pub(crate) fn color_mask(
    context: &mut Context,
    red: bool,
    green: bool,
    blue: bool,
    alpha: bool,
) -> Result<()> {
    for buffer in &mut context.state.fragment.buffers {
        buffer.mask = [red, green, blue, alpha];
    }
    Ok(())
}

pub(crate) fn color_maski(
    context: &mut Context,
    buf: GLuint,
    red: bool,
    green: bool,
    blue: bool,
    alpha: bool,
) -> Result<()> {
    let buf = index("buf", buf)?;
    context.state.fragment.buffers[buf].mask = [red, green, blue, alpha];
    Ok(())
}

/// A capability that each draw buffer has on its own, and the buffer.
fn indexed(target: GLenum, buffer: GLuint) -> Result<usize> {
    if target != GL_BLEND {
        return invalid_enum(SECTION, format!("target = {} must be GL_BLEND", enum_name(target)));
    }
    index("index", buffer)
}

fn switch(context: &mut Context, target: GLenum, buffer: GLuint, on: bool) -> Result<()> {
    let buffer = indexed(target, buffer)?;
    context.state.fragment.buffers[buffer].blend = on;
    // `glIsEnabled(GL_BLEND)` answers for the first one.
    let first = context.state.fragment.buffers[0].blend;
    context.state.enables.set(Flag::Blend, first);
    Ok(())
}

pub(crate) fn enablei(context: &mut Context, target: GLenum, index: GLuint) -> Result<()> {
    switch(context, target, index, true)
}

pub(crate) fn disablei(context: &mut Context, target: GLenum, index: GLuint) -> Result<()> {
    switch(context, target, index, false)
}

pub(crate) fn is_enabledi(context: &mut Context, target: GLenum, index: GLuint) -> Result<bool> {
    let buffer = indexed(target, index)?;
    Ok(context.state.fragment.buffers[buffer].blend)
}

/// State of one draw buffer.
fn indexed_state(context: &Context, target: GLenum, buffer: GLuint) -> Result<Vec<bool>> {
    let at = |buffer| Ok(&context.state.fragment.buffers[index("index", buffer)?]);
    match target {
        GL_COLOR_WRITEMASK => at(buffer).map(|state: &BufferState| state.mask.to_vec()),
        GL_BLEND => at(buffer).map(|state: &BufferState| vec![state.blend]),
        _ => invalid_enum(
            SECTION,
            format!("target = {} must be GL_BLEND or GL_COLOR_WRITEMASK", enum_name(target)),
        ),
    }
}

/// Writes an answer into the slice, which must have room for it.
fn answer<T: Copy + From<u8>>(data: &mut [T], values: &[bool]) -> Result<()> {
    let values: Vec<T> = values.iter().map(|&on| T::from(u8::from(on))).collect();
    crate::query::put(data, &values)
}

pub(crate) fn get_booleani_v(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    data: &mut [GLboolean],
) -> Result<()> {
    answer(data, &indexed_state(context, target, index)?)
}

pub(crate) fn get_integeri_v(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    data: &mut [GLint],
) -> Result<()> {
    let value = bindings::indexed_value(context, target, index)
        .or_else(|| multisample::indexed_value(context, target, index));
    if let Some(value) = value {
        return crate::query::put(data, &[value?]);
    }
    answer(data, &indexed_state(context, target, index)?)
}
