//! The stencil test: GL 2.1, section 4.1.5, and `EXT_stencil_two_side`.

use crate::base::constants::*;
use crate::base::error::Table;
use crate::base::types::*;
use rasterizer::driver::{StencilFace, StencilOp, StencilState};
use texunit::sampler::Compare;

const SECTION: &str = "GL 2.1, section 4.1.5";

/// The state of a face, as GL keeps it: reference and masks have all their bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Face {
    pub func: Compare,
    pub reference: GLint,
    pub value_mask: GLuint,
    pub write_mask: GLuint,
    pub fail: StencilOp,
    pub depth_fail: StencilOp,
    pub pass: StencilOp,
}

impl Face {
    /// The driver's form, for 8 bits of stencil.
    fn to_driver(self) -> StencilFace {
        StencilFace {
            test: self.func,
            reference: self.reference.clamp(0, 255) as u8,
            read_mask: self.value_mask as u8,
            write_mask: self.write_mask as u8,
            fail: self.fail,
            depth_fail: self.depth_fail,
            pass: self.pass,
        }
    }
}

/// A face with stencil state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Front,
    Back,
    /// The back face of `EXT_stencil_two_side`, which has state of its own.
    TwoSideBack,
}

/// The stencil state.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stencil {
    /// By [`Side`].
    pub faces: [Face; 3],
    /// What `glStencilFunc`, `glStencilOp` and `glStencilMask` set with `EXT_stencil_two_side`.
    pub active: Side,
}

impl Default for Stencil {
    fn default() -> Self {
        let face = Face {
            func: Compare::Always,
            reference: 0,
            value_mask: !0,
            write_mask: !0,
            fail: StencilOp::Keep,
            depth_fail: StencilOp::Keep,
            pass: StencilOp::Keep,
        };
        Self { faces: [face; 3], active: Side::Front }
    }
}

impl Stencil {
    /// The driver's form; back faces have the state of `back`.
    pub fn to_driver(&self, back: Side) -> StencilState {
        StencilState {
            front: self.faces[Side::Front as usize].to_driver(),
            back: self.faces[back as usize].to_driver(),
        }
    }

    /// The state of the active face, which queries read.
    pub fn active(&self) -> &Face {
        &self.faces[self.active as usize]
    }

    /// The faces that a call without a face parameter sets.
    pub(crate) fn unnamed(&mut self) -> &mut [Face] {
        match self.active {
            Side::Front | Side::Back => &mut self.faces[..2],
            Side::TwoSideBack => &mut self.faces[2..],
        }
    }
}

pub(crate) const ACTIVE_FACE: Table<Side> = Table {
    section: "EXT_stencil_two_side, section 4.1.5",
    rows: &[(GL_FRONT, Side::Front), (GL_BACK, Side::TwoSideBack)],
};

pub(crate) const STENCIL_OP: Table<StencilOp> = Table {
    section: SECTION,
    rows: &[
        (GL_KEEP, StencilOp::Keep),
        (GL_ZERO, StencilOp::Zero),
        (GL_REPLACE, StencilOp::Replace),
        (GL_INCR, StencilOp::Increment),
        (GL_DECR, StencilOp::Decrement),
        (GL_INVERT, StencilOp::Invert),
        (GL_INCR_WRAP, StencilOp::IncrementWrap),
        (GL_DECR_WRAP, StencilOp::DecrementWrap),
    ],
};
