//! Points and their sprites: GL 2.1, section 3.3.

use crate::base::constants::*;
use crate::base::error::Table;
use rasterizer::driver::{MAX_POINT_SIZE, SpriteOrigin};

const SECTION: &str = "GL 2.1, section 3.3";

/// Point parameters.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Points {
    pub size: f32,
    /// The derived size is at least this.
    pub size_min: f32,
    /// The derived size is at most this.
    pub size_max: f32,
    /// Smaller sizes fade, with multisampling.
    pub fade: f32,
    /// Constant, linear and quadratic.
    pub attenuation: [f32; 3],
    pub origin: SpriteOrigin,
}

impl Default for Points {
    fn default() -> Self {
        Self {
            size: 1.0,
            size_min: 0.0,
            size_max: MAX_POINT_SIZE,
            fade: 1.0,
            attenuation: [1.0, 0.0, 0.0],
            origin: SpriteOrigin::UpperLeft,
        }
    }
}

impl Points {
    /// Whether the size falls with the distance from the eye.
    pub fn attenuates(&self) -> bool {
        self.attenuation != [1.0, 0.0, 0.0]
    }

    /// The size of points at no distance: the state's, within its limits.
    pub fn derived_size(&self) -> f32 {
        let size = self.size.min(self.size_max).max(self.size_min);
        if size > 0.0 { size } else { 1.0 }
    }
}

pub(crate) const ORIGIN: Table<SpriteOrigin> = Table {
    section: SECTION,
    rows: &[(GL_UPPER_LEFT, SpriteOrigin::UpperLeft), (GL_LOWER_LEFT, SpriteOrigin::LowerLeft)],
};
