//! Evaluators: GL 2.1, table 6.31. Maps have a query of their own.

use super::row::Read::*;
use super::row::{Row, rows, saturated};
use crate::base::constants::*;
use crate::state::evaluators::MAX_EVAL_ORDER;

pub(super) const ROWS: &[Row] = rows! {
    GL_MAX_EVAL_ORDER: Integer(|_| saturated(MAX_EVAL_ORDER));
    GL_MAP1_GRID_DOMAIN: Floats(|c| c.state.evaluators.grid_1.domain.to_vec());
    GL_MAP1_GRID_SEGMENTS: Integer(|c| saturated(c.state.evaluators.grid_1.segments));
    GL_MAP2_GRID_DOMAIN: Floats(|c| c.state.evaluators.grid_2.map(|axis| axis.domain).concat());
    GL_MAP2_GRID_SEGMENTS: Integers(|c| c.state.evaluators.grid_2.map(|axis| axis.segments).to_vec());
    GL_AUTO_NORMAL: Enabled;
    GL_MAP1_COLOR_4: Enabled;
    GL_MAP1_INDEX: Enabled;
    GL_MAP1_NORMAL: Enabled;
    GL_MAP1_TEXTURE_COORD_1: Enabled;
    GL_MAP1_TEXTURE_COORD_2: Enabled;
    GL_MAP1_TEXTURE_COORD_3: Enabled;
    GL_MAP1_TEXTURE_COORD_4: Enabled;
    GL_MAP1_VERTEX_3: Enabled;
    GL_MAP1_VERTEX_4: Enabled;
    GL_MAP2_COLOR_4: Enabled;
    GL_MAP2_INDEX: Enabled;
    GL_MAP2_NORMAL: Enabled;
    GL_MAP2_TEXTURE_COORD_1: Enabled;
    GL_MAP2_TEXTURE_COORD_2: Enabled;
    GL_MAP2_TEXTURE_COORD_3: Enabled;
    GL_MAP2_TEXTURE_COORD_4: Enabled;
    GL_MAP2_VERTEX_3: Enabled;
    GL_MAP2_VERTEX_4: Enabled;
};
