//! `glColorMask`, `glLogicOp`, and blending by draw buffer (`glEnablei`): GL 2.1, sections 4.1.10 and 4.2.2;
//! `EXT_draw_buffers2`.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum};
use crate::base::types::*;
use crate::context::Context;
use crate::state::draw_buffers::{LOGIC_OP, buffer_index};
use crate::state::enable::{Flag, Switch};

pub(crate) const SECTION: &str = "EXT_draw_buffers2, section 4.2.2";

pub(crate) fn logic_op(context: &mut Context, opcode: GLenum) -> Result<()> {
    context.state.fragment.logic_op = LOGIC_OP.decode("opcode", opcode)?;
    Ok(())
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
    let buf = buffer_index("buf", buf)?;
    context.state.fragment.buffers[buf].mask = [red, green, blue, alpha];
    Ok(())
}

/// A capability that each draw buffer has on its own, and the buffer.
pub(crate) fn indexed(target: GLenum, buffer: GLuint) -> Result<usize> {
    if target != GL_BLEND {
        return invalid_enum(SECTION, format!("target = {} must be GL_BLEND", enum_name(target)));
    }
    buffer_index("index", buffer)
}

fn switch(context: &mut Context, target: GLenum, buffer: GLuint, to: Switch) -> Result<()> {
    let buffer = indexed(target, buffer)?;
    context.state.fragment.buffers[buffer].blend = to == Switch::On;
    // `glIsEnabled(GL_BLEND)` answers for the first one.
    let first = context.state.fragment.buffers[0].blend;
    context.state.enables.set(Flag::Blend, first);
    Ok(())
}

pub(crate) fn enablei(context: &mut Context, target: GLenum, index: GLuint) -> Result<()> {
    switch(context, target, index, Switch::On)
}

pub(crate) fn disablei(context: &mut Context, target: GLenum, index: GLuint) -> Result<()> {
    switch(context, target, index, Switch::Off)
}
