//! Matrix stacks: GL 2.1, section 2.11.2.
//!
//! Each call computes in `f64`, where glam is the same scalar code on every machine, and rounds its
//! result to what an `f32` holds: a matrix that a program reads with `glGetFloatv` and loads again
//! is the same matrix, so that two passes agree in depth to the bit.

use crate::base::assembly_limits::{MAX_PROGRAM_MATRICES, MAX_PROGRAM_MATRIX_STACK_DEPTH};
use crate::base::constants::*;
use crate::base::error::Table;
use crate::interface::MAX_TEXTURE_UNITS;
use glam::DMat4;

const SECTION: &str = "GL 2.1, section 2.11.2";

/// Depth of the model-view stack.
pub(crate) const MAX_MODELVIEW_STACK_DEPTH: usize = 32;
/// Depth of the other stacks.
pub(crate) const MAX_STACK_DEPTH: usize = 10;

/// Which stack matrix calls work on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum MatrixMode {
    #[default]
    ModelView,
    Projection,
    Texture,
    /// Of assembly programs.
    Program(u8),
}

pub(crate) const MATRIX_MODE: Table<MatrixMode> = Table {
    section: SECTION,
    rows: &[
        (GL_MODELVIEW, MatrixMode::ModelView),
        (GL_PROJECTION, MatrixMode::Projection),
        (GL_TEXTURE, MatrixMode::Texture),
        (GL_MATRIX0_ARB, MatrixMode::Program(0)),
        (GL_MATRIX1_ARB, MatrixMode::Program(1)),
        (GL_MATRIX2_ARB, MatrixMode::Program(2)),
        (GL_MATRIX3_ARB, MatrixMode::Program(3)),
        (GL_MATRIX4_ARB, MatrixMode::Program(4)),
        (GL_MATRIX5_ARB, MatrixMode::Program(5)),
        (GL_MATRIX6_ARB, MatrixMode::Program(6)),
        (GL_MATRIX7_ARB, MatrixMode::Program(7)),
    ],
};

/// A stack; never empty.
#[derive(Clone, Debug)]
pub(crate) struct Stack {
    pub below: Vec<DMat4>,
    pub top: DMat4,
    pub limit: usize,
}

impl Stack {
    fn new(limit: usize) -> Self {
        Self { below: Vec::new(), top: DMat4::IDENTITY, limit }
    }

    /// How many matrices are on it.
    pub fn depth(&self) -> usize {
        self.below.len() + 1
    }
}

/// All stacks.
#[derive(Clone, Debug)]
pub(crate) struct Matrices {
    pub mode: MatrixMode,
    pub modelview: Stack,
    pub projection: Stack,
    pub texture: [Stack; MAX_TEXTURE_UNITS as usize],
    pub program: [Stack; MAX_PROGRAM_MATRICES as usize],
}

impl Default for Matrices {
    fn default() -> Self {
        Self {
            mode: MatrixMode::ModelView,
            modelview: Stack::new(MAX_MODELVIEW_STACK_DEPTH),
            projection: Stack::new(MAX_STACK_DEPTH),
            texture: std::array::from_fn(|_| Stack::new(MAX_STACK_DEPTH)),
            program: std::array::from_fn(|_| Stack::new(MAX_PROGRAM_MATRIX_STACK_DEPTH)),
        }
    }
}
