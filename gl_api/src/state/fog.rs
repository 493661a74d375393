//! Fog: GL 2.1, section 3.10.

use crate::base::constants::*;
use crate::base::error::Table;

const SECTION: &str = "GL 2.1, section 3.10";

/// The fog equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum FogMode {
    Linear,
    Exp,
    Exp2,
}

pub(crate) const FOG_MODE: Table<FogMode> = Table {
    section: SECTION,
    rows: &[(GL_EXP, FogMode::Exp), (GL_EXP2, FogMode::Exp2), (GL_LINEAR, FogMode::Linear)],
};

/// The source of the fog coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum FogSource {
    /// The distance from the eye's plane, `|z|` in eye coordinates.
    Depth,
    /// `glFogCoord`.
    Coordinate,
}

pub(crate) const FOG_SOURCE: Table<FogSource> = Table {
    section: SECTION,
    rows: &[(GL_FRAGMENT_DEPTH, FogSource::Depth), (GL_FOG_COORD, FogSource::Coordinate)],
};

/// What `glFog` sets.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FogState {
    pub mode: FogMode,
    pub density: f32,
    pub start: f32,
    pub end: f32,
    /// Of colour index mode; kept, not used.
    pub index: f32,
    pub color: [f32; 4],
    pub source: FogSource,
}

impl Default for FogState {
    fn default() -> Self {
        Self {
            mode: FogMode::Exp,
            density: 1.0,
            start: 0.0,
            end: 1.0,
            index: 0.0,
            color: [0.0; 4],
            source: FogSource::Depth,
        }
    }
}
