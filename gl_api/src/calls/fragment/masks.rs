//! Which components are written, which buffers are blended, and the logical operation: GL 2.1,
//! sections 4.1.10 and 4.2.2; `EXT_draw_buffers2`.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum};
use crate::base::query_value::{QueryValue, flag, int, symbol};
use crate::base::query_value::{put_bools, put_ints, put_longs};
use crate::base::types::*;
use crate::context::Context;
use crate::state::blend::Formula;
use crate::state::draw_buffers::{LOGIC_OP, buffer_index};
use crate::state::enable::{Flag, Switch};

const SECTION: &str = "EXT_draw_buffers2, section 4.2.2";

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
fn indexed(target: GLenum, buffer: GLuint) -> Result<usize> {
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

pub(crate) fn is_enabledi(context: &mut Context, target: GLenum, index: GLuint) -> Result<bool> {
    let buffer = indexed(target, index)?;
    Ok(context.state.fragment.buffers[buffer].blend)
}

/// State that has an index: of one draw buffer, of an indexed buffer, or a word of the sample mask.
fn indexed_state(context: &Context, target: GLenum, index: GLuint) -> Result<QueryValue> {
    if let Some(value) = number(context, target, index) {
        return int(value?);
    }
    let buffers = &context.state.fragment.buffers;
    let at = || Ok(&buffers[buffer_index("index", index)?]);
    match target {
        GL_COLOR_WRITEMASK => at().map(|state| QueryValue::Bools(state.mask.to_vec())),
        GL_BLEND => at().and_then(|state| flag(state.blend)),
        _ if Formula::REPLACE.get(target).is_some() => {
            symbol(at()?.formula.get(target).unwrap_or_default())
        }
        _ => invalid_enum(
            SECTION,
            format!(
                "target = {} must be GL_BLEND, GL_BLEND_SRC_RGB or another part of a blend \
                 formula, GL_COLOR_WRITEMASK, GL_SAMPLE_MASK_VALUE or an indexed buffer",
                enum_name(target)
            ),
        ),
    }
}

pub(crate) fn get_booleani_v(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    data: &mut [GLboolean],
) -> Result<()> {
    put_bools(data, indexed_state(context, target, index)?)
}

pub(crate) fn get_integeri_v(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    data: &mut [GLint],
) -> Result<()> {
    put_ints(data, indexed_state(context, target, index)?)
}

pub(crate) fn get_integer64i_v(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    data: &mut [GLint64],
) -> Result<()> {
    if let Some(value) = number(context, target, index) {
        return crate::base::query_value::put(data, &[value?]);
    }
    put_longs(data, indexed_state(context, target, index)?)
}

/// Indexed state that is a number.
fn number(context: &Context, target: GLenum, index: GLuint) -> Option<Result<GLint64>> {
    crate::calls::buffer::indexed::indexed_value(context, target, index).or_else(|| {
        let word = crate::calls::raster::multisample::indexed_value(context, target, index)?;
        Some(word.map(GLint64::from))
    })
}
