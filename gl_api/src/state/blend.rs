//! Blending: GL 3.3, section 4.1.7; each draw buffer by a formula of its own:
//! `ARB_draw_buffers_blend`.

use crate::base::constants::*;
use crate::base::error::Table;
use crate::base::types::*;
use rasterizer::driver::{Blend, BlendEquation, BlendFactor};

/// Blend equation and factors; each for colour, then for alpha.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Formula {
    pub equation: [BlendEquation; 2],
    pub src: [BlendFactor; 2],
    pub dst: [BlendFactor; 2],
}

impl Formula {
    /// The initial one, which replaces the stored colour.
    pub const REPLACE: Self = Self {
        equation: [BlendEquation::Add; 2],
        src: [BlendFactor::One; 2],
        dst: [BlendFactor::Zero; 2],
    };

    /// Whether a factor is made of the second source colour.
    pub fn has_second_color(&self) -> bool {
        self.src.iter().chain(&self.dst).any(|factor| factor.is_of_second_color())
    }

    /// With the constant colour, as the driver has it.
    pub fn to_driver(self, constant: [f32; 4]) -> Blend {
        let Self { equation, src, dst } = self;
        Blend { equation, src, dst, constant }
    }

    /// The value that a query of `pname` reads.
    pub fn get(&self, pname: GLenum) -> Option<GLenum> {
        Some(match pname {
            GL_BLEND_SRC | GL_BLEND_SRC_RGB => FACTOR.encode(self.src[0]),
            GL_BLEND_SRC_ALPHA => FACTOR.encode(self.src[1]),
            GL_BLEND_DST | GL_BLEND_DST_RGB => FACTOR.encode(self.dst[0]),
            GL_BLEND_DST_ALPHA => FACTOR.encode(self.dst[1]),
            GL_BLEND_EQUATION => BLEND_EQUATION.encode(self.equation[0]),
            GL_BLEND_EQUATION_ALPHA => BLEND_EQUATION.encode(self.equation[1]),
            _ => return None,
        })
    }
}

pub(crate) const BLEND_EQUATION: Table<BlendEquation> = Table {
    section: "GL 2.1, section 4.1.8",
    rows: &[
        (GL_FUNC_ADD, BlendEquation::Add),
        (GL_FUNC_SUBTRACT, BlendEquation::Subtract),
        (GL_FUNC_REVERSE_SUBTRACT, BlendEquation::ReverseSubtract),
        (GL_MIN, BlendEquation::Min),
        (GL_MAX, BlendEquation::Max),
    ],
};

/// Source and destination factors.
pub(crate) const FACTOR: Table<BlendFactor> = Table {
    section: "GL 3.3, table 4.2",
    rows: &[
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
        (GL_SRC1_COLOR, BlendFactor::Src1Color),
        (GL_ONE_MINUS_SRC1_COLOR, BlendFactor::OneMinusSrc1Color),
        (GL_SRC1_ALPHA, BlendFactor::Src1Alpha),
        (GL_ONE_MINUS_SRC1_ALPHA, BlendFactor::OneMinusSrc1Alpha),
    ],
};
