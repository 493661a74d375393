//! The calls of the alpha test, the depth test and the scissor test (GL 2.1, section 4.1), the depth mask and the values
//! that `glClear` writes (section 4.2).

use crate::base::compare::COMPARE;
use crate::base::convert::unit;
use crate::base::error::{Result, not_negative};
use crate::base::types::*;
use crate::context::Context;
use crate::state::draw_buffers::BufferStates;
use crate::state::fragment::{ClearColor, FragmentState};
use crate::state::per_viewport::PerViewport;
use crate::state::stencil::Stencil;
use rasterizer::driver::{DepthWrite, LogicOp, Rect};
use texunit::sampler::Compare;

impl FragmentState {
    pub fn new(width: u32, height: u32) -> Self {
        Self {
            scissor: PerViewport::new(Rect { x: 0, y: 0, width, height }),
            scissor_tests: 0,
            alpha_func: Compare::Always,
            alpha_ref: 0.0,
            depth_func: Compare::Less,
            depth_write: DepthWrite::On,
            blend_color: [0.0; 4],
            stencil: Stencil::default(),
            logic_op: LogicOp::Copy,
            buffers: BufferStates::INITIAL,
            index_mask: GLuint::MAX,
        }
    }
}

/// The reference is kept as it is, and clamped where fragments are (`ARB_color_buffer_float`).
pub(crate) fn alpha_func(context: &mut Context, func: GLenum, reference: GLclampf) -> Result<()> {
    let func = COMPARE.decode("func", func)?;
    let fragment = &mut context.state.fragment;
    if (fragment.alpha_func, fragment.alpha_ref) == (func, reference) {
        context.state_changes.no_change();
    }
    (fragment.alpha_func, fragment.alpha_ref) = (func, reference);
    Ok(())
}

pub(crate) fn depth_func(context: &mut Context, func: GLenum) -> Result<()> {
    let func = COMPARE.decode("func", func)?;
    context.set_plain(|state| &mut state.fragment.depth_func, func);
    Ok(())
}

pub(crate) fn depth_mask(context: &mut Context, flag: bool) -> Result<()> {
    let write = if flag { DepthWrite::On } else { DepthWrite::Off };
    context.set_plain(|state| &mut state.fragment.depth_write, write);
    Ok(())
}

pub(crate) fn scissor(
    context: &mut Context,
    x: GLint,
    y: GLint,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    const SECTION: &str = "GL 2.1, section 4.1.2";
    not_negative(SECTION, "width", width.into())?;
    not_negative(SECTION, "height", height.into())?;
    let scissor = Rect { x, y, width: width as u32, height: height as u32 };
    context.set_plain(|state| &mut state.fragment.scissor, PerViewport::new(scissor));
    Ok(())
}

/// Kept as it is, and clamped where the buffer is fixed-point (`ARB_color_buffer_float`).
pub(crate) fn clear_color(
    context: &mut Context,
    red: GLclampf,
    green: GLclampf,
    blue: GLclampf,
    alpha: GLclampf,
) -> Result<()> {
    context.state.clear.color = ClearColor::Floats([red, green, blue, alpha]);
    Ok(())
}

pub(crate) fn clear_color_ii_ext(
    context: &mut Context,
    red: GLint,
    green: GLint,
    blue: GLint,
    alpha: GLint,
) -> Result<()> {
    context.state.clear.color = ClearColor::Signed([red, green, blue, alpha]);
    Ok(())
}

pub(crate) fn clear_color_iui_ext(
    context: &mut Context,
    red: GLuint,
    green: GLuint,
    blue: GLuint,
    alpha: GLuint,
) -> Result<()> {
    context.state.clear.color = ClearColor::Unsigned([red, green, blue, alpha]);
    Ok(())
}

pub(crate) fn clear_depth(context: &mut Context, depth: GLclampd) -> Result<()> {
    context.state.clear.depth = unit(depth);
    Ok(())
}

pub(crate) fn clear_depthf(context: &mut Context, depth: GLclampf) -> Result<()> {
    clear_depth(context, depth.into())
}

pub(crate) fn clear_stencil(context: &mut Context, s: GLint) -> Result<()> {
    context.state.clear.stencil = s;
    Ok(())
}
