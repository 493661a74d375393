//! State of per-fragment operations (GL 2.1, section 4.1) and clear values (section 4.2).

use crate::base::types::*;
use crate::state::draw_buffers::BufferStates;
use crate::state::per_viewport::PerViewport;
use crate::state::stencil::Stencil;
use rasterizer::driver::{DepthWrite, LogicOp, Rect};
use texunit::sampler::Compare;

/// State of per-fragment operations.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FragmentState {
    pub scissor: PerViewport<Rect>,
    /// Whether the scissor test of the viewports from number 1 on is enabled, bit by number.
    pub scissor_tests: u16,
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

/// All viewports from number 1 on, in [`FragmentState::scissor_tests`].
pub(crate) const MORE_SCISSOR_TESTS: u16 = !1;

/// The clear colour.
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

/// Clear values.
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
