//! Blended draws.

use super::error::ProbeError;
use super::picture::{CELLS, cell_corners, cell_values};
use super::session::Session;
use crate::gl::*;
use crate::oracle::blend::{Equation, Factor};
use gl_api::constants::*;

/// Blend state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlendState {
    /// `glBlendEquation`.
    pub equation: Equation,
    /// `glBlendFunc`: factors of source and destination.
    pub factors: [Factor; 2],
    /// `glBlendColor`.
    pub constant: [f32; 4],
}

/// The colours of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlendedCell {
    /// The framebuffer's colour.
    pub destination: [u8; 4],
    /// The drawn colour.
    pub source: [f32; 4],
}

impl Session {
    /// The colour of each cell after blending, rounded to bytes.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn blended(
        &self,
        state: &BlendState,
        cells: &[BlendedCell],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        set_blend(state);
        let mut values = Vec::with_capacity(cells.len());
        for chunk in cells.chunks(CELLS * CELLS) {
            glClear(GL_COLOR_BUFFER_BIT);
            glDisable(GL_BLEND);
            quads(chunk.iter().map(|cell| cell.destination.map(|c| f32::from(c) / 255.0)));
            glEnable(GL_BLEND);
            quads(chunk.iter().map(|cell| cell.source));
            let picture = self.read_components()?;
            values.extend(cell_values(&picture).take(chunk.len()));
        }
        Ok(values)
    }
}

/// Sets GL's blend state.
pub(super) fn set_blend(state: &BlendState) {
    let [r, g, b, a] = state.constant;
    glBlendColor(r, g, b, a);
    glBlendEquation(equation_enum(state.equation));
    let [source, destination] = state.factors.map(factor_enum);
    glBlendFunc(source, destination);
}

/// Draws a quad over each cell, in the colour that the iterator returns.
fn quads(colors: impl Iterator<Item = [f32; 4]>) {
    glBegin(GL_QUADS);
    for (k, [r, g, b, a]) in colors.enumerate() {
        glColor4f(r, g, b, a);
        for [x, y] in cell_corners(k) {
            glVertex2f(x, y);
        }
    }
    glEnd();
}

/// GL's name of an equation.
pub fn equation_enum(equation: Equation) -> u32 {
    match equation {
        Equation::Add => GL_FUNC_ADD,
        Equation::Subtract => GL_FUNC_SUBTRACT,
        Equation::ReverseSubtract => GL_FUNC_REVERSE_SUBTRACT,
        Equation::Min => GL_MIN,
        Equation::Max => GL_MAX,
    }
}

/// GL's name of a factor.
pub fn factor_enum(factor: Factor) -> u32 {
    match factor {
        Factor::Zero => GL_ZERO,
        Factor::One => GL_ONE,
        Factor::SrcColor => GL_SRC_COLOR,
        Factor::OneMinusSrcColor => GL_ONE_MINUS_SRC_COLOR,
        Factor::DstColor => GL_DST_COLOR,
        Factor::OneMinusDstColor => GL_ONE_MINUS_DST_COLOR,
        Factor::SrcAlpha => GL_SRC_ALPHA,
        Factor::OneMinusSrcAlpha => GL_ONE_MINUS_SRC_ALPHA,
        Factor::DstAlpha => GL_DST_ALPHA,
        Factor::OneMinusDstAlpha => GL_ONE_MINUS_DST_ALPHA,
        Factor::ConstantColor => GL_CONSTANT_COLOR,
        Factor::OneMinusConstantColor => GL_ONE_MINUS_CONSTANT_COLOR,
        Factor::ConstantAlpha => GL_CONSTANT_ALPHA,
        Factor::OneMinusConstantAlpha => GL_ONE_MINUS_CONSTANT_ALPHA,
        Factor::SrcAlphaSaturate => GL_SRC_ALPHA_SATURATE,
    }
}
