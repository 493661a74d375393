//! Generation of texture coordinates: GL 2.1, section 2.11.4.

use glam::DVec4;

/// The generation function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum GenMode {
    ObjectLinear,
    EyeLinear,
    SphereMap,
    ReflectionMap,
    NormalMap,
}

/// The generation of one coordinate of a unit.
#[derive(Clone, Debug)]
pub(crate) struct Generate {
    pub enabled: bool,
    pub mode: GenMode,
    pub object_plane: DVec4,
    /// In eye coordinates.
    pub eye_plane: DVec4,
}

impl Generate {
    /// The initial state: `[s, t, r, q]`.
    pub fn initial() -> [Self; 4] {
        [DVec4::X, DVec4::Y, DVec4::ZERO, DVec4::ZERO].map(|plane| Self {
            enabled: false,
            mode: GenMode::EyeLinear,
            object_plane: plane,
            eye_plane: plane,
        })
    }
}
