//! Polygon mode, offset and stipple: GL 2.1, section 3.5.

use crate::base::constants::*;
use crate::base::error::Table;
use rasterizer::driver::PolygonMode;

/// State of polygon rasterization.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Polygons {
    /// Front and back.
    pub mode: [PolygonMode; 2],
    pub offset_factor: f32,
    pub offset_units: f32,
    /// `ARB_polygon_offset_clamp`; 0 bounds nothing.
    pub offset_clamp: f32,
    /// Rows from the lowest, the leftmost pixel in the highest bit.
    pub stipple: [u32; 32],
}

impl Default for Polygons {
    fn default() -> Self {
        Self {
            mode: [PolygonMode::Fill; 2],
            offset_factor: 0.0,
            offset_units: 0.0,
            offset_clamp: 0.0,
            stipple: [!0; 32],
        }
    }
}

pub(crate) const POLYGON_MODE: Table<PolygonMode> = Table {
    section: "GL 2.1, section 3.5.4",
    rows: &[
        (GL_POINT, PolygonMode::Point),
        (GL_LINE, PolygonMode::Line),
        (GL_FILL, PolygonMode::Fill),
    ],
};
