//! Evaluators: GL 2.1, section 5.1. Polynomial maps from one or two parameters to vertex attributes, and grids.

use crate::base::constants::*;
use crate::base::error::Table;

/// The attribute that a map computes (GL 2.1, table 5.1), in the order of GL's constants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EvaluatorKind {
    Color,
    Index,
    Normal,
    TexCoord1,
    TexCoord2,
    TexCoord3,
    TexCoord4,
    Vertex3,
    Vertex4,
}

impl EvaluatorKind {
    pub const ALL: [Self; 9] = [
        Self::Color,
        Self::Index,
        Self::Normal,
        Self::TexCoord1,
        Self::TexCoord2,
        Self::TexCoord3,
        Self::TexCoord4,
        Self::Vertex3,
        Self::Vertex4,
    ];

    /// Components of a control point.
    pub fn components(self) -> usize {
        match self {
            Self::Index | Self::TexCoord1 => 1,
            Self::TexCoord2 => 2,
            Self::Normal | Self::TexCoord3 | Self::Vertex3 => 3,
            Self::Color | Self::TexCoord4 | Self::Vertex4 => 4,
        }
    }

    /// The control point of a map that was never set (GL 2.1, table 6.31).
    pub(crate) fn initial(self) -> [f32; 4] {
        match self {
            Self::Color | Self::Index => [1.0; 4],
            Self::Normal => [0.0, 0.0, 1.0, 0.0],
            Self::TexCoord1 | Self::TexCoord2 | Self::TexCoord3 | Self::TexCoord4 => {
                [0.0, 0.0, 0.0, 1.0]
            }
            Self::Vertex3 | Self::Vertex4 => [0.0, 0.0, 0.0, 1.0],
        }
    }
}

/// The number of parameters of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dimension {
    One,
    Two,
}

/// The name of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct EvaluatorName {
    pub dimension: Dimension,
    pub kind: EvaluatorKind,
}

/// A grid along one parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct GridSteps {
    pub segments: i32,
    pub domain: [f64; 2],
}

impl Default for GridSteps {
    fn default() -> Self {
        Self { segments: 1, domain: [0.0, 1.0] }
    }
}

/// The enabled maps and the grids: the state of `GL_EVAL_BIT`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct EvaluatorState {
    /// Bit by [`EvaluatorKind`], of maps with one and two parameters.
    enabled: [u16; 2],
    pub grid_1: GridSteps,
    pub grid_2: [GridSteps; 2],
}

impl EvaluatorState {
    /// Whether a map is enabled.
    pub fn has(&self, name: EvaluatorName) -> bool {
        self.enabled[name.dimension as usize] >> name.kind as u16 & 1 == 1
    }

    /// Enables or disables a map.
    pub fn set(&mut self, name: EvaluatorName, on: bool) {
        let bits = &mut self.enabled[name.dimension as usize];
        *bits = *bits & !(1 << name.kind as u16) | u16::from(on) << name.kind as u16;
    }

    /// Enables the maps that `other` has enabled, and disables the others.
    pub fn take_enabled(&mut self, other: &Self) {
        self.enabled = other.enabled;
    }
}

/// All maps, by dimension and [`EvaluatorKind`].
#[derive(Clone, Debug)]
pub(crate) struct EvaluatorMaps(pub(crate) [[EvaluatorMap; 9]; 2]);

impl Default for EvaluatorMaps {
    fn default() -> Self {
        Self([EvaluatorKind::ALL.map(EvaluatorMap::new), EvaluatorKind::ALL.map(EvaluatorMap::new)])
    }
}

impl EvaluatorMaps {
    pub fn get(&self, name: EvaluatorName) -> &EvaluatorMap {
        &self.0[name.dimension as usize][name.kind as usize]
    }

    pub fn get_mut(&mut self, name: EvaluatorName) -> &mut EvaluatorMap {
        &mut self.0[name.dimension as usize][name.kind as usize]
    }
}

/// The largest order of a map, one more than its degree (`GL_MAX_EVAL_ORDER`).
pub(crate) const MAX_EVAL_ORDER: usize = 30;

pub(crate) const fn name(dimension: Dimension, kind: EvaluatorKind) -> EvaluatorName {
    EvaluatorName { dimension, kind }
}

/// Every map, as `glEnable` and `glGetMap` know it: those with one parameter first.
pub(crate) const MAP: Table<EvaluatorName> = Table {
    section: "GL 2.1, table 5.1",
    rows: &[
        (GL_MAP1_COLOR_4, name(Dimension::One, EvaluatorKind::Color)),
        (GL_MAP1_INDEX, name(Dimension::One, EvaluatorKind::Index)),
        (GL_MAP1_NORMAL, name(Dimension::One, EvaluatorKind::Normal)),
        (GL_MAP1_TEXTURE_COORD_1, name(Dimension::One, EvaluatorKind::TexCoord1)),
        (GL_MAP1_TEXTURE_COORD_2, name(Dimension::One, EvaluatorKind::TexCoord2)),
        (GL_MAP1_TEXTURE_COORD_3, name(Dimension::One, EvaluatorKind::TexCoord3)),
        (GL_MAP1_TEXTURE_COORD_4, name(Dimension::One, EvaluatorKind::TexCoord4)),
        (GL_MAP1_VERTEX_3, name(Dimension::One, EvaluatorKind::Vertex3)),
        (GL_MAP1_VERTEX_4, name(Dimension::One, EvaluatorKind::Vertex4)),
        (GL_MAP2_COLOR_4, name(Dimension::Two, EvaluatorKind::Color)),
        (GL_MAP2_INDEX, name(Dimension::Two, EvaluatorKind::Index)),
        (GL_MAP2_NORMAL, name(Dimension::Two, EvaluatorKind::Normal)),
        (GL_MAP2_TEXTURE_COORD_1, name(Dimension::Two, EvaluatorKind::TexCoord1)),
        (GL_MAP2_TEXTURE_COORD_2, name(Dimension::Two, EvaluatorKind::TexCoord2)),
        (GL_MAP2_TEXTURE_COORD_3, name(Dimension::Two, EvaluatorKind::TexCoord3)),
        (GL_MAP2_TEXTURE_COORD_4, name(Dimension::Two, EvaluatorKind::TexCoord4)),
        (GL_MAP2_VERTEX_3, name(Dimension::Two, EvaluatorKind::Vertex3)),
        (GL_MAP2_VERTEX_4, name(Dimension::Two, EvaluatorKind::Vertex4)),
    ],
};

/// A map's control points. A map with one parameter has the order 1 along the other.
#[derive(Clone, Debug)]
pub(crate) struct EvaluatorMap {
    pub order: [usize; 2],
    pub domain: [[f64; 2]; 2],
    /// Numbers of a point.
    pub components: usize,
    /// Point by point, the second parameter's first.
    pub points: Vec<f32>,
}

impl EvaluatorMap {
    /// A map in its initial state.
    pub fn new(kind: EvaluatorKind) -> Self {
        let components = kind.components();
        let points = kind.initial()[..components].to_vec();
        Self { order: [1; 2], domain: [[0.0, 1.0]; 2], components, points }
    }
}
