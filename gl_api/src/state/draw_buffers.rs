//! State of each draw buffer (colour mask, blending; `EXT_draw_buffers2`), and logical operations: GL 2.1, sections
//! 4.1.10 and 4.2.2.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_value};
use crate::base::limits;
use crate::base::types::*;
use crate::state::blend::Formula;
use rasterizer::driver::LogicOp;
use std::ops::{Index, Range};

const SECTION: &str = "EXT_draw_buffers2, section 4.2.2";

pub(crate) const LOGIC_OP: Table<LogicOp> = Table {
    section: "GL 2.1, table 4.3",
    rows: &[
        (GL_CLEAR, LogicOp::Clear),
        (GL_AND, LogicOp::And),
        (GL_AND_REVERSE, LogicOp::AndReverse),
        (GL_COPY, LogicOp::Copy),
        (GL_AND_INVERTED, LogicOp::AndInverted),
        (GL_NOOP, LogicOp::Noop),
        (GL_XOR, LogicOp::Xor),
        (GL_OR, LogicOp::Or),
        (GL_NOR, LogicOp::Nor),
        (GL_EQUIV, LogicOp::Equivalent),
        (GL_INVERT, LogicOp::Invert),
        (GL_OR_REVERSE, LogicOp::OrReverse),
        (GL_COPY_INVERTED, LogicOp::CopyInverted),
        (GL_OR_INVERTED, LogicOp::OrInverted),
        (GL_NAND, LogicOp::Nand),
        (GL_SET, LogicOp::Set),
    ],
};

/// The state of one draw buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct BufferState {
    /// Which of red, green, blue, alpha are written.
    pub mask: [bool; 4],
    /// Whether it is blended.
    pub blend: bool,
    /// The blend equation and factors (`ARB_draw_buffers_blend`).
    pub formula: Formula,
}

/// The state of all draw buffers. Few programs set it by buffer, and it is copied and compared between draws: where all
/// buffers have the same it is one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum BufferStates {
    /// Of each buffer.
    Same(BufferState),
    /// Of buffers that differ.
    ByBuffer(Box<[BufferState; limits::MAX_COLOR_ATTACHMENTS]>),
}

impl BufferStates {
    /// The initial state.
    pub const INITIAL: Self =
        Self::Same(BufferState { mask: [true; 4], blend: false, formula: Formula::REPLACE });

    /// The state of each buffer, in their order.
    pub fn iter(&self) -> impl Iterator<Item = &BufferState> {
        (0..limits::MAX_COLOR_ATTACHMENTS).map(|buffer| &self[buffer])
    }

    /// Changes the states of some buffers.
    pub fn change(&mut self, buffers: Range<usize>, mut change: impl FnMut(&mut BufferState)) {
        const COUNT: usize = limits::MAX_COLOR_ATTACHMENTS;
        if let (Self::Same(state), 0, COUNT) = (&mut *self, buffers.start, buffers.end) {
            change(state);
            return;
        }
        let mut states: [BufferState; COUNT] = std::array::from_fn(|buffer| self[buffer]);
        states[buffers].iter_mut().for_each(change);
        *self = match states {
            [first, rest @ ..] if rest.iter().all(|state| *state == first) => Self::Same(first),
            states => Self::ByBuffer(Box::new(states)),
        };
    }

    /// Whether all are blended, or none.
    pub fn all_blend(&self, on: bool) -> bool {
        match self {
            Self::Same(state) => state.blend == on,
            Self::ByBuffer(states) => states.iter().all(|state| state.blend == on),
        }
    }
}

/// All draw buffers.
pub(crate) const ALL_BUFFERS: Range<usize> = 0..limits::MAX_COLOR_ATTACHMENTS;

impl Index<usize> for BufferStates {
    type Output = BufferState;

    fn index(&self, buffer: usize) -> &BufferState {
        match self {
            Self::Same(state) => state,
            Self::ByBuffer(states) => &states[buffer],
        }
    }
}

/// The number of a draw buffer.
pub(crate) fn buffer_index(argument: &str, index: GLuint) -> Result<usize> {
    let limit = limits::MAX_COLOR_ATTACHMENTS;
    match usize::try_from(index) {
        Ok(index) if index < limit => Ok(index),
        Ok(_) | Err(_) => {
            invalid_value(SECTION, format!("{argument} = {index} must be 0 to {}", limit - 1))
        }
    }
}
