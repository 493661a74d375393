//! Polygon stipple as masks of lanes.

use crate::desc::{PixelMask, Stipple};
use std::sync::Arc;
use texunit::lanes::{LANES, lane_x, lane_y};

/// The lanes that a stipple leaves of each block of the window.
#[derive(Debug)]
pub enum StippleLanes {
    /// Of 4×4 blocks, and so on.
    Pattern([u64; 16]),
    /// Of all.
    Mask(Arc<PixelMask>),
}

impl StippleLanes {
    pub fn new(stipple: &Stipple) -> Self {
        match stipple {
            Stipple::Pattern(rows) => Self::Pattern(pattern(rows)),
            Stipple::Mask(mask) => Self::Mask(Arc::clone(mask)),
        }
    }

    /// The lanes of a block, by its column and row.
    #[inline]
    pub fn block(&self, at: [u32; 2]) -> u64 {
        match self {
            Self::Pattern(lanes) => lanes[(at[1] % 4 * 4 + at[0] % 4) as usize],
            Self::Mask(mask) => mask.block(at),
        }
    }
}

fn pattern(rows: &[u32; 32]) -> [u64; 16] {
    let mut blocks = [0; 16];
    for (index, block) in blocks.iter_mut().enumerate() {
        for lane in 0..LANES {
            let (x, y) = (index % 4 * 8 + lane_x(lane), index / 4 * 8 + lane_y(lane));
            *block |= u64::from(rows[y] >> (31 - x) & 1) << lane;
        }
    }
    blocks
}
