//! Clipping: GL 2.1, section 2.12, and `ARB_clip_control`.

use crate::base::constants::*;
use crate::base::error::Table;
use crate::interface::MAX_CLIP_PLANES;
use glam::DVec4;
use rasterizer::driver::{ClipControl, ClipDepth, ClipOrigin};

/// The user clip planes, and the conventions of clip coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ClipState {
    /// In eye coordinates; points with a negative distance are clipped.
    pub planes: [DVec4; MAX_CLIP_PLANES as usize],
    /// Bit by plane.
    pub enabled: u8,
    pub control: ClipControl,
}

pub(crate) const CLIP_ORIGIN: Table<ClipOrigin> = Table {
    section: "ARB_clip_control",
    rows: &[(GL_LOWER_LEFT, ClipOrigin::LowerLeft), (GL_UPPER_LEFT, ClipOrigin::UpperLeft)],
};

pub(crate) const CLIP_DEPTH: Table<ClipDepth> = Table {
    section: "ARB_clip_control",
    rows: &[
        (GL_NEGATIVE_ONE_TO_ONE, ClipDepth::NegativeOneToOne),
        (GL_ZERO_TO_ONE, ClipDepth::ZeroToOne),
    ],
};
