//! Transformation: GL 2.1, table 6.11, and the current matrix of `ARB_vertex_program`.

use super::row::Read::*;
use super::row::{Row, doubles, rows, saturated};
use crate::base::constants::*;
use crate::base::error::Result;
use crate::calls::transform::matrix::current;
use crate::context::Context;
use crate::state::clip::{CLIP_DEPTH, CLIP_ORIGIN};
use crate::state::matrix::{MATRIX_MODE, Stack};
use glam::DMat4;

fn elements(matrix: DMat4) -> Vec<f64> {
    matrix.to_cols_array().to_vec()
}

/// The stack of texture matrices of the active unit.
fn texture(context: &Context) -> Result<&Stack> {
    let unit = context.state.units.active_coordinates("GL 2.1, section 2.11.2")?;
    Ok(&context.state.matrices.texture[unit])
}

pub(super) const ROWS: &[Row] = rows! {
    GL_MATRIX_MODE: Word(|c| MATRIX_MODE.encode(c.state.matrices.mode));
    GL_MODELVIEW_MATRIX: Floats(|c| elements(c.state.matrices.modelview.top));
    GL_PROJECTION_MATRIX: Floats(|c| elements(c.state.matrices.projection.top));
    GL_TEXTURE_MATRIX: UnitFloats(|c| Ok(elements(texture(c)?.top)));
    GL_TRANSPOSE_MODELVIEW_MATRIX: Floats(|c| elements(c.state.matrices.modelview.top.transpose()));
    GL_TRANSPOSE_PROJECTION_MATRIX: Floats(|c| elements(c.state.matrices.projection.top.transpose()));
    GL_TRANSPOSE_TEXTURE_MATRIX: UnitFloats(|c| Ok(elements(texture(c)?.top.transpose())));
    GL_MODELVIEW_STACK_DEPTH: Integer(|c| saturated(c.state.matrices.modelview.depth()));
    GL_PROJECTION_STACK_DEPTH: Integer(|c| saturated(c.state.matrices.projection.depth()));
    GL_TEXTURE_STACK_DEPTH: UnitInteger(|c| Ok(saturated(texture(c)?.depth())));
    GL_CURRENT_MATRIX_ARB: UnitFloats(|c| Ok(elements(current(c)?.top)));
    GL_TRANSPOSE_CURRENT_MATRIX_ARB: UnitFloats(|c| Ok(elements(current(c)?.top.transpose())));
    GL_CURRENT_MATRIX_STACK_DEPTH_ARB: UnitInteger(|c| Ok(saturated(current(c)?.depth())));

    GL_VIEWPORT: Floats(|c| doubles(&c.state.viewport.first.sides()));
    GL_DEPTH_RANGE: Fractions(|c| c.state.viewport.first.depth.to_vec());
    // glProvokingVertex says which (ARB_viewport_array).
    GL_LAYER_PROVOKING_VERTEX: Word(|_| GL_PROVOKING_VERTEX);
    GL_VIEWPORT_INDEX_PROVOKING_VERTEX: Word(|_| GL_PROVOKING_VERTEX);
    GL_CLIP_ORIGIN: Word(|c| CLIP_ORIGIN.encode(c.state.clip.control.origin));
    GL_CLIP_DEPTH_MODE: Word(|c| CLIP_DEPTH.encode(c.state.clip.control.depth));

    GL_NORMALIZE: Enabled;
    GL_RESCALE_NORMAL: Enabled;
    GL_DEPTH_CLAMP: Enabled;
    GL_CLIP_PLANE0: Enabled;
    GL_CLIP_PLANE1: Enabled;
    GL_CLIP_PLANE2: Enabled;
    GL_CLIP_PLANE3: Enabled;
    GL_CLIP_PLANE4: Enabled;
    GL_CLIP_PLANE5: Enabled;
    GL_CLIP_DISTANCE6: Enabled;
    GL_CLIP_DISTANCE7: Enabled;
};
