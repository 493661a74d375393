//! Evaluators: GL 2.1, section 5.1. Polynomial maps from one or two parameters to attributes of
//! vertices ([`map`]), their value at a point ([`basis`]), and grids of points ([`grid`]).

use crate::state::evaluator_map::Map;

/// What a map gives (GL 2.1, table 5.1), in the order of GL's constants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
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

impl Kind {
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

    /// Numbers of a control point.
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

/// How many parameters a map has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dimension {
    One,
    Two,
}

/// Which map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Name {
    pub dimension: Dimension,
    pub kind: Kind,
}

/// A grid along one parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Steps {
    pub segments: i32,
    pub domain: [f64; 2],
}

impl Default for Steps {
    fn default() -> Self {
        Self { segments: 1, domain: [0.0, 1.0] }
    }
}

/// The maps that are on, and the grids: what `glPushAttrib(GL_EVAL_BIT)` keeps.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct EvaluatorState {
    /// Bit by [`Kind`], of maps with one and two parameters.
    enabled: [u16; 2],
    pub grid_1: Steps,
    pub grid_2: [Steps; 2],
}

impl EvaluatorState {
    /// Whether a map is on.
    pub fn has(&self, name: Name) -> bool {
        self.enabled[name.dimension as usize] >> name.kind as u16 & 1 == 1
    }

    /// Switches a map on or off.
    pub fn set(&mut self, name: Name, on: bool) {
        let bits = &mut self.enabled[name.dimension as usize];
        *bits = *bits & !(1 << name.kind as u16) | u16::from(on) << name.kind as u16;
    }

    /// Puts the switches back that another state has.
    pub fn take_enabled(&mut self, other: &Self) {
        self.enabled = other.enabled;
    }
}

/// All maps, by dimension and [`Kind`].
#[derive(Clone, Debug)]
pub(crate) struct Maps(pub(crate) [[Map; 9]; 2]);

impl Default for Maps {
    fn default() -> Self {
        Self([Kind::ALL.map(Map::new), Kind::ALL.map(Map::new)])
    }
}

impl Maps {
    pub fn get(&self, name: Name) -> &Map {
        &self.0[name.dimension as usize][name.kind as usize]
    }

    pub fn get_mut(&mut self, name: Name) -> &mut Map {
        &mut self.0[name.dimension as usize][name.kind as usize]
    }
}
