//! Per-fragment operations: GL 2.1, section 4.1; masks and clear values: section 4.2.

use super::masks::{BUFFERS, BufferStates};
use super::stencil::Stencil;
use super::viewport::unit;
use crate::constants::*;
use crate::context::Context;
use crate::error::{Result, Table, not_negative};
use crate::types::*;
use rasterizer::driver::{DepthWrite, LogicOp, Rect};
use texunit::sampler::Compare;

/// What happens to fragments.
#[derive(Clone, Debug)]
pub(crate) struct FragmentState {
    pub scissor: Rect,
    pub alpha_func: Compare,
    pub alpha_ref: f32,
    pub depth_func: Compare,
    pub depth_write: DepthWrite,
    pub blend_color: [f32; 4],
    pub stencil: Stencil,
    pub logic_op: LogicOp,
    pub buffers: BufferStates,
    /// Of colour index mode; kept, not used.
    pub index_mask: GLuint,
}

impl FragmentState {
    pub fn new(width: u32, height: u32) -> Self {
        Self {
            scissor: Rect { x: 0, y: 0, width, height },
            alpha_func: Compare::Always,
            alpha_ref: 0.0,
            depth_func: Compare::Less,
            depth_write: DepthWrite::On,
            blend_color: [0.0; 4],
            stencil: Stencil::default(),
            logic_op: LogicOp::Copy,
            buffers: BUFFERS,
            index_mask: GLuint::MAX,
        }
    }
}

/// The colour that `glClear` writes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ClearColor {
    Floats([f32; 4]),
    /// For buffers of integers (`EXT_texture_integer`).
    Signed([i32; 4]),
    Unsigned([u32; 4]),
}

impl ClearColor {
    /// The colour as floats.
    pub fn floats(self) -> [f32; 4] {
        match self {
            Self::Floats(color) => color,
            Self::Signed(color) => color.map(|c| c as f32),
            Self::Unsigned(color) => color.map(|c| c as f32),
        }
    }

    /// The colour as integers; of floats, those nearest to zero.
    pub fn integers(self) -> [i64; 4] {
        match self {
            Self::Floats(color) => color.map(|c| c as i64),
            Self::Signed(color) => color.map(i64::from),
            Self::Unsigned(color) => color.map(i64::from),
        }
    }
}

/// What `glClear` writes.
#[derive(Clone, Debug)]
pub(crate) struct ClearState {
    pub color: ClearColor,
    pub depth: f64,
    pub stencil: i32,
    /// Of the accumulation buffer.
    pub accumulation: [f32; 4],
    /// Of colour index mode; kept, not used.
    pub index: f32,
}

impl Default for ClearState {
    fn default() -> Self {
        Self {
            color: ClearColor::Floats([0.0; 4]),
            depth: 1.0,
            stencil: 0,
            accumulation: [0.0; 4],
            index: 0.0,
        }
    }
}

pub(crate) const COMPARE: Table<Compare> = Table {
    section: "GL 2.1, section 4.1.5",
    rows: &[
        (GL_NEVER, Compare::Never),
        (GL_LESS, Compare::Less),
        (GL_EQUAL, Compare::Equal),
        (GL_LEQUAL, Compare::LessEqual),
        (GL_GREATER, Compare::Greater),
        (GL_NOTEQUAL, Compare::NotEqual),
        (GL_GEQUAL, Compare::GreaterEqual),
        (GL_ALWAYS, Compare::Always),
    ],
};

/// The reference is kept as it is, and clamped where fragments are (`ARB_color_buffer_float`).
pub(crate) fn alpha_func(context: &mut Context, func: GLenum, reference: GLclampf) -> Result<()> {
    let func = COMPARE.decode("func", func)?;
    context.state.fragment.alpha_func = func;
    context.state.fragment.alpha_ref = reference;
    Ok(())
}

pub(crate) fn depth_func(context: &mut Context, func: GLenum) -> Result<()> {
    context.state.fragment.depth_func = COMPARE.decode("func", func)?;
    Ok(())
}

pub(crate) fn depth_mask(context: &mut Context, flag: bool) -> Result<()> {
    context.state.fragment.depth_write = if flag { DepthWrite::On } else { DepthWrite::Off };
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
    context.state.fragment.scissor = Rect { x, y, width: width as u32, height: height as u32 };
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
