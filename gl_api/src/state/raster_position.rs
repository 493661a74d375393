//! The current raster position: GL 2.1, section 2.13, and `glWindowPos`.

use crate::interface::*;

/// The current raster position and its associated data.
#[derive(Clone, Debug)]
pub(crate) struct RasterPosition {
    /// Window x, y and z, and clip w.
    pub window: [f64; 4],
    pub valid: bool,
    pub distance: f32,
    pub color: [f32; 4],
    pub secondary_color: [f32; 4],
    /// The colour index; kept, not used.
    pub index: f32,
    pub tex_coords: [[f32; 4]; MAX_TEXTURE_UNITS as usize],
}
