//! State of rasterization: GL 2.1, sections 3.4 and 3.5, and 2.14.7; hints.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_value};
use crate::base::types::*;
use crate::state::multisample::Multisample;
use crate::state::points::Points;
use crate::state::polygon::Polygons;
use rasterizer::driver::{Cull, FrontFace, Provoking};
use rasterizer::ir::Interpolation;

/// State of rasterization.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RasterState {
    pub cull: Cull,
    pub front_face: FrontFace,
    pub shade_model: Interpolation,
    /// The provoking vertex (`ARB_provoking_vertex`).
    pub provoking: Provoking,
    pub line_width: f32,
    /// 1 to 256.
    pub stipple_factor: u16,
    pub stipple_pattern: u16,
    pub points: Points,
    pub polygons: Polygons,
    pub multisample: Multisample,
    /// By row of [`HINTS`].
    pub hints: [GLenum; HINTS.rows.len()],
}

pub(crate) const FACE: Table<Cull> = Table {
    section: "GL 2.1, section 3.5.1",
    rows: &[(GL_FRONT, Cull::Front), (GL_BACK, Cull::Back), (GL_FRONT_AND_BACK, Cull::Both)],
};

pub(crate) const FRONT_FACE: Table<FrontFace> = Table {
    section: "GL 2.1, section 3.5.1",
    rows: &[(GL_CCW, FrontFace::Ccw), (GL_CW, FrontFace::Cw)],
};

pub(crate) const SHADE_MODEL: Table<Interpolation> = Table {
    section: "GL 2.1, section 2.14.7",
    rows: &[(GL_SMOOTH, Interpolation::Smooth), (GL_FLAT, Interpolation::Flat)],
};

pub(crate) const PROVOKING: Table<Provoking> = Table {
    section: "ARB_provoking_vertex, flatshading",
    rows: &[
        (GL_FIRST_VERTEX_CONVENTION, Provoking::First),
        (GL_LAST_VERTEX_CONVENTION, Provoking::Last),
    ],
};

/// The hints, and the index of each in the state.
pub(crate) const HINTS: Table<usize> = Table {
    section: "GL 2.1, section 5.6",
    rows: &[
        (GL_PERSPECTIVE_CORRECTION_HINT, 0),
        (GL_POINT_SMOOTH_HINT, 1),
        (GL_LINE_SMOOTH_HINT, 2),
        (GL_POLYGON_SMOOTH_HINT, 3),
        (GL_FOG_HINT, 4),
        (GL_GENERATE_MIPMAP_HINT, 5),
        (GL_TEXTURE_COMPRESSION_HINT, 6),
        (GL_FRAGMENT_SHADER_DERIVATIVE_HINT, 7),
    ],
};

pub(crate) fn positive(section: &'static str, argument: &str, value: f32) -> Result<f32> {
    if value > 0.0 {
        Ok(value)
    } else {
        invalid_value(section, format!("{argument} = {value} must be positive"))
    }
}
