//! `glColorMask`, `glLogicOp`, and blending by draw buffer (`glEnablei`): GL 2.1, sections 4.1.10 and 4.2.2;
//! `EXT_draw_buffers2`. The scissor test by viewport: `ARB_viewport_array`.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum};
use crate::base::types::*;
use crate::calls::transform::viewport_arrays::viewport_index;
use crate::context::Context;
use crate::state::draw_buffers::{ALL_BUFFERS, BufferStates, LOGIC_OP, buffer_index};
use crate::state::enable::{Flag, Switch};

pub(crate) const SECTION: &str =
    "EXT_draw_buffers2, section 4.2.2; ARB_viewport_array, section 4.1.2";

pub(crate) fn logic_op(context: &mut Context, opcode: GLenum) -> Result<()> {
    let op = LOGIC_OP.decode("opcode", opcode)?;
    context.set_plain(|state| &mut state.fragment.logic_op, op);
    Ok(())
}

pub(crate) fn color_mask(
    context: &mut Context,
    red: bool,
    green: bool,
    blue: bool,
    alpha: bool,
) -> Result<()> {
    let mask = [red, green, blue, alpha];
    let set = |buffers: &mut BufferStates| buffers.change(ALL_BUFFERS, |buffer| buffer.mask = mask);
    context.change_plain(|state| &mut state.fragment.buffers, set);
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
    let mask = [red, green, blue, alpha];
    context.state.fragment.buffers.change(buf..buf + 1, |buffer| buffer.mask = mask);
    Ok(())
}

/// A capability with a number.
#[derive(Clone, Copy)]
enum Indexed {
    /// Blending of a draw buffer.
    Blend(usize),
    /// The scissor test of a viewport.
    ScissorTest(usize),
}

fn indexed(context: &Context, target: GLenum, index: GLuint) -> Result<Indexed> {
    match target {
        GL_BLEND => Ok(Indexed::Blend(buffer_index("index", index)?)),
        GL_SCISSOR_TEST if !context.profile.is_es() => {
            Ok(Indexed::ScissorTest(viewport_index("index", index)?))
        }
        _ => {
            let target = enum_name(target);
            let rule = format!("target = {target} must be GL_BLEND or GL_SCISSOR_TEST");
            invalid_enum(SECTION, rule)
        }
    }
}

/// Whether a capability with a number is on.
pub(crate) fn is_on(context: &Context, target: GLenum, index: GLuint) -> Result<bool> {
    Ok(match indexed(context, target, index)? {
        Indexed::Blend(buffer) => context.state.fragment.buffers[buffer].blend,
        Indexed::ScissorTest(0) => context.state.enables.has(Flag::ScissorTest),
        Indexed::ScissorTest(viewport) => context.state.fragment.scissor_tests >> viewport & 1 == 1,
    })
}

fn switch(context: &mut Context, target: GLenum, index: GLuint, to: Switch) -> Result<()> {
    let on = to == Switch::On;
    match indexed(context, target, index)? {
        Indexed::Blend(buffer) => {
            let buffers = &mut context.state.fragment.buffers;
            buffers.change(buffer..buffer + 1, |buffer| buffer.blend = on);
            // `glIsEnabled(GL_BLEND)` answers for the first one.
            let first = context.state.fragment.buffers[0].blend;
            context.state.enables.set(Flag::Blend, first);
        }
        Indexed::ScissorTest(0) => context.state.enables.set(Flag::ScissorTest, on),
        Indexed::ScissorTest(viewport) => {
            let tests = &mut context.state.fragment.scissor_tests;
            *tests = *tests & !(1 << viewport) | u16::from(on) << viewport;
        }
    }
    Ok(())
}

pub(crate) fn enablei(context: &mut Context, target: GLenum, index: GLuint) -> Result<()> {
    switch(context, target, index, Switch::On)
}

pub(crate) fn disablei(context: &mut Context, target: GLenum, index: GLuint) -> Result<()> {
    switch(context, target, index, Switch::Off)
}
