//! The calls of blending: GL 2.1, section 4.1.8; by draw buffer: `ARB_draw_buffers_blend`.

use crate::base::error::Result;
use crate::base::types::*;
use crate::context::Context;
use crate::state::blend::{BLEND_EQUATION, FACTOR, Formula};
use crate::state::draw_buffers::{ALL_BUFFERS, buffer_index};
use std::ops::Range;

/// The draw buffers that a call is about.
#[derive(Clone, Copy, Debug)]
enum Buffers {
    All,
    One(GLuint),
}

impl Buffers {
    /// Their numbers.
    fn range(self) -> Result<Range<usize>> {
        Ok(match self {
            Self::All => ALL_BUFFERS,
            Self::One(buf) => {
                let number = buffer_index("buf", buf)?;
                number..number + 1
            }
        })
    }
}

/// Changes the formulas of these buffers, and notes whether any is another one then.
fn set_formulas(context: &mut Context, buffers: Range<usize>, change: impl Fn(Formula) -> Formula) {
    let mut is_same = true;
    context.state.fragment.buffers.change(buffers, |state| {
        let formula = change(state.formula);
        is_same &= formula == state.formula;
        state.formula = formula;
    });
    if is_same {
        context.state_changes.no_change();
    }
}

/// Sets the factors: of the source and the destination, for colour, then for alpha.
fn set_factors(context: &mut Context, buffers: Buffers, factors: [GLenum; 4]) -> Result<()> {
    let buffers = buffers.range()?;
    let [src_rgb, dst_rgb, src_alpha, dst_alpha] = factors;
    let src = [
        FACTOR.decode("source factor", src_rgb)?,
        FACTOR.decode("source alpha factor", src_alpha)?,
    ];
    let dst = [
        FACTOR.decode("destination factor", dst_rgb)?,
        FACTOR.decode("destination alpha factor", dst_alpha)?,
    ];
    set_formulas(context, buffers, |formula| Formula { src, dst, ..formula });
    Ok(())
}

/// Sets the equations, for colour and for alpha.
fn set_equations(context: &mut Context, buffers: Buffers, [rgb, alpha]: [GLenum; 2]) -> Result<()> {
    let buffers = buffers.range()?;
    let equation =
        [BLEND_EQUATION.decode("mode", rgb)?, BLEND_EQUATION.decode("alpha mode", alpha)?];
    set_formulas(context, buffers, |formula| Formula { equation, ..formula });
    Ok(())
}

pub(crate) fn blend_func(context: &mut Context, sfactor: GLenum, dfactor: GLenum) -> Result<()> {
    set_factors(context, Buffers::All, [sfactor, dfactor, sfactor, dfactor])
}

pub(crate) fn blend_func_separate(
    context: &mut Context,
    src_rgb: GLenum,
    dst_rgb: GLenum,
    src_alpha: GLenum,
    dst_alpha: GLenum,
) -> Result<()> {
    set_factors(context, Buffers::All, [src_rgb, dst_rgb, src_alpha, dst_alpha])
}

pub(crate) fn blend_funci(
    context: &mut Context,
    buf: GLuint,
    src: GLenum,
    dst: GLenum,
) -> Result<()> {
    set_factors(context, Buffers::One(buf), [src, dst, src, dst])
}

pub(crate) fn blend_func_separatei(
    context: &mut Context,
    buf: GLuint,
    src_rgb: GLenum,
    dst_rgb: GLenum,
    src_alpha: GLenum,
    dst_alpha: GLenum,
) -> Result<()> {
    set_factors(context, Buffers::One(buf), [src_rgb, dst_rgb, src_alpha, dst_alpha])
}

pub(crate) fn blend_equation(context: &mut Context, mode: GLenum) -> Result<()> {
    set_equations(context, Buffers::All, [mode; 2])
}

pub(crate) fn blend_equation_separate(
    context: &mut Context,
    mode_rgb: GLenum,
    mode_alpha: GLenum,
) -> Result<()> {
    set_equations(context, Buffers::All, [mode_rgb, mode_alpha])
}

pub(crate) fn blend_equationi(context: &mut Context, buf: GLuint, mode: GLenum) -> Result<()> {
    set_equations(context, Buffers::One(buf), [mode; 2])
}

pub(crate) fn blend_equation_separatei(
    context: &mut Context,
    buf: GLuint,
    mode_rgb: GLenum,
    mode_alpha: GLenum,
) -> Result<()> {
    set_equations(context, Buffers::One(buf), [mode_rgb, mode_alpha])
}

/// Kept as it is, and clamped where the framebuffer is fixed-point (`ARB_color_buffer_float`).
pub(crate) fn blend_color(
    context: &mut Context,
    red: GLclampf,
    green: GLclampf,
    blue: GLclampf,
    alpha: GLclampf,
) -> Result<()> {
    context.state.fragment.blend_color = [red, green, blue, alpha];
    Ok(())
}
