//! Blending: GL 2.1, section 4.1.8; each draw buffer by a formula of its own:
//! `ARB_draw_buffers_blend`.

use super::masks::{BufferStates, buffer_index};
use crate::constants::*;
use crate::context::Context;
use crate::error::{Result, Table};
use crate::types::*;
use rasterizer::driver::{Blend, BlendEquation, BlendFactor};

/// What is made of a fragment's colour and a stored one; each for colour, then for alpha.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Formula {
    equation: [BlendEquation; 2],
    src: [BlendFactor; 2],
    dst: [BlendFactor; 2],
}

impl Formula {
    /// The initial one: what is stored is replaced.
    pub const REPLACE: Self = Self {
        equation: [BlendEquation::Add; 2],
        src: [BlendFactor::One; 2],
        dst: [BlendFactor::Zero; 2],
    };

    /// With the constant colour, as the driver has it.
    pub fn to_driver(self, constant: [f32; 4]) -> Blend {
        let Self { equation, src, dst } = self;
        Blend { equation, src, dst, constant }
    }

    /// A part of it by the name that queries have for it.
    pub fn get(&self, pname: GLenum) -> Option<GLenum> {
        Some(match pname {
            GL_BLEND_SRC | GL_BLEND_SRC_RGB => SRC_FACTOR.encode(self.src[0]),
            GL_BLEND_SRC_ALPHA => SRC_FACTOR.encode(self.src[1]),
            GL_BLEND_DST | GL_BLEND_DST_RGB => DST_FACTOR.encode(self.dst[0]),
            GL_BLEND_DST_ALPHA => DST_FACTOR.encode(self.dst[1]),
            GL_BLEND_EQUATION => BLEND_EQUATION.encode(self.equation[0]),
            GL_BLEND_EQUATION_ALPHA => BLEND_EQUATION.encode(self.equation[1]),
            _ => return None,
        })
    }
}

const BLEND_EQUATION: Table<BlendEquation> = Table {
    section: "GL 2.1, section 4.1.8",
    rows: &[
        (GL_FUNC_ADD, BlendEquation::Add),
        (GL_FUNC_SUBTRACT, BlendEquation::Subtract),
        (GL_FUNC_REVERSE_SUBTRACT, BlendEquation::ReverseSubtract),
        (GL_MIN, BlendEquation::Min),
        (GL_MAX, BlendEquation::Max),
    ],
};

const DESTINATION: &[(GLenum, BlendFactor)] = &[
    (GL_ZERO, BlendFactor::Zero),
    (GL_ONE, BlendFactor::One),
    (GL_SRC_COLOR, BlendFactor::SrcColor),
    (GL_ONE_MINUS_SRC_COLOR, BlendFactor::OneMinusSrcColor),
    (GL_DST_COLOR, BlendFactor::DstColor),
    (GL_ONE_MINUS_DST_COLOR, BlendFactor::OneMinusDstColor),
    (GL_SRC_ALPHA, BlendFactor::SrcAlpha),
    (GL_ONE_MINUS_SRC_ALPHA, BlendFactor::OneMinusSrcAlpha),
    (GL_DST_ALPHA, BlendFactor::DstAlpha),
    (GL_ONE_MINUS_DST_ALPHA, BlendFactor::OneMinusDstAlpha),
    (GL_CONSTANT_COLOR, BlendFactor::ConstantColor),
    (GL_ONE_MINUS_CONSTANT_COLOR, BlendFactor::OneMinusConstantColor),
    (GL_CONSTANT_ALPHA, BlendFactor::ConstantAlpha),
    (GL_ONE_MINUS_CONSTANT_ALPHA, BlendFactor::OneMinusConstantAlpha),
    (GL_SRC_ALPHA_SATURATE, BlendFactor::SrcAlphaSaturate),
];

const FACTORS: &str = "GL 2.1, table 4.2";

/// What a source is weighted with.
const SRC_FACTOR: Table<BlendFactor> = Table { section: FACTORS, rows: DESTINATION };

/// What a destination is weighted with: everything but `GL_SRC_ALPHA_SATURATE`.
const DST_FACTOR: Table<BlendFactor> = Table { section: FACTORS, rows: DESTINATION.split_at(14).0 };

/// The draw buffers that a call is about.
#[derive(Clone, Copy, Debug)]
enum Buffers {
    All,
    One(GLuint),
}

impl Buffers {
    /// Their states.
    fn of(self, states: &mut BufferStates) -> Result<&mut [super::masks::BufferState]> {
        Ok(match self {
            Self::All => states,
            Self::One(buf) => std::slice::from_mut(&mut states[buffer_index("buf", buf)?]),
        })
    }
}

/// Sets the factors: of the source and the destination, for colour, then for alpha.
fn set_factors(context: &mut Context, buffers: Buffers, factors: [GLenum; 4]) -> Result<()> {
    let buffers = buffers.of(&mut context.state.fragment.buffers)?;
    let [src_rgb, dst_rgb, src_alpha, dst_alpha] = factors;
    let src = [
        SRC_FACTOR.decode("source factor", src_rgb)?,
        SRC_FACTOR.decode("source alpha factor", src_alpha)?,
    ];
    let dst = [
        DST_FACTOR.decode("destination factor", dst_rgb)?,
        DST_FACTOR.decode("destination alpha factor", dst_alpha)?,
    ];
    for buffer in buffers {
        buffer.formula = Formula { src, dst, ..buffer.formula };
    }
    Ok(())
}

/// Sets the equations, for colour and for alpha.
fn set_equations(context: &mut Context, buffers: Buffers, [rgb, alpha]: [GLenum; 2]) -> Result<()> {
    let buffers = buffers.of(&mut context.state.fragment.buffers)?;
    let equation =
        [BLEND_EQUATION.decode("mode", rgb)?, BLEND_EQUATION.decode("alpha mode", alpha)?];
    for buffer in buffers {
        buffer.formula.equation = equation;
    }
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
