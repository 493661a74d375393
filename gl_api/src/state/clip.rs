//! User clip planes: GL 2.1, section 2.12.

use crate::interface::MAX_CLIP_PLANES;
use glam::DVec4;

/// The planes, in eye coordinates; points with a negative distance are clipped.
#[derive(Clone, Debug, Default)]
pub(crate) struct ClipPlanes {
    pub planes: [DVec4; MAX_CLIP_PLANES as usize],
    /// Bit by plane.
    pub enabled: u8,
}
