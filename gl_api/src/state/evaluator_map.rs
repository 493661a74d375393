//! `glMap` and `glGetMap`: GL 2.1, sections 5.1 and 6.1.3.

use crate::base::constants::*;
use crate::base::error::Table;
use crate::state::evaluate::{Dimension, Kind, Name};

/// The largest order of a map, one more than its degree (`GL_MAX_EVAL_ORDER`).
pub(crate) const MAX_EVAL_ORDER: usize = 30;

pub(crate) const fn name(dimension: Dimension, kind: Kind) -> Name {
    Name { dimension, kind }
}

/// Every map, as `glEnable` and `glGetMap` know it: those with one parameter first.
pub(crate) const MAP: Table<Name> = Table {
    section: "GL 2.1, table 5.1",
    rows: &[
        (GL_MAP1_COLOR_4, name(Dimension::One, Kind::Color)),
        (GL_MAP1_INDEX, name(Dimension::One, Kind::Index)),
        (GL_MAP1_NORMAL, name(Dimension::One, Kind::Normal)),
        (GL_MAP1_TEXTURE_COORD_1, name(Dimension::One, Kind::TexCoord1)),
        (GL_MAP1_TEXTURE_COORD_2, name(Dimension::One, Kind::TexCoord2)),
        (GL_MAP1_TEXTURE_COORD_3, name(Dimension::One, Kind::TexCoord3)),
        (GL_MAP1_TEXTURE_COORD_4, name(Dimension::One, Kind::TexCoord4)),
        (GL_MAP1_VERTEX_3, name(Dimension::One, Kind::Vertex3)),
        (GL_MAP1_VERTEX_4, name(Dimension::One, Kind::Vertex4)),
        (GL_MAP2_COLOR_4, name(Dimension::Two, Kind::Color)),
        (GL_MAP2_INDEX, name(Dimension::Two, Kind::Index)),
        (GL_MAP2_NORMAL, name(Dimension::Two, Kind::Normal)),
        (GL_MAP2_TEXTURE_COORD_1, name(Dimension::Two, Kind::TexCoord1)),
        (GL_MAP2_TEXTURE_COORD_2, name(Dimension::Two, Kind::TexCoord2)),
        (GL_MAP2_TEXTURE_COORD_3, name(Dimension::Two, Kind::TexCoord3)),
        (GL_MAP2_TEXTURE_COORD_4, name(Dimension::Two, Kind::TexCoord4)),
        (GL_MAP2_VERTEX_3, name(Dimension::Two, Kind::Vertex3)),
        (GL_MAP2_VERTEX_4, name(Dimension::Two, Kind::Vertex4)),
    ],
};

/// A map's control points. A map with one parameter has the order 1 along the other.
#[derive(Clone, Debug)]
pub(crate) struct Map {
    pub order: [usize; 2],
    pub domain: [[f64; 2]; 2],
    /// Numbers of a point.
    pub components: usize,
    /// Point by point, the second parameter's first.
    pub points: Vec<f32>,
}

impl Map {
    /// A map in its initial state.
    pub fn new(kind: Kind) -> Self {
        let components = kind.components();
        let points = kind.initial()[..components].to_vec();
        Self { order: [1; 2], domain: [[0.0, 1.0]; 2], components, points }
    }
}
