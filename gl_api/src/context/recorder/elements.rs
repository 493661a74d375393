//! Which vertices a draw takes: a range of them, or indices.

use rasterizer::driver::{IndexType, Indices};
use std::ops::Range;

/// Which vertices a draw takes.
#[derive(Debug)]
pub(crate) enum Elements {
    Range { first: u32, count: u32, instances: Range<u32> },
    Indexed { indices: Indices, count: u32, instances: Range<u32> },
}

impl Elements {
    /// How many vertices an instance has, and which instances there are.
    pub fn counts(&self) -> (u32, Range<u32>) {
        match self {
            Self::Range { count, instances, .. } | Self::Indexed { count, instances, .. } => {
                (*count, instances.clone())
            }
        }
    }

    /// The number of vertex `at`; 0 past the end of the indices.
    pub fn number(&self, at: u32) -> u32 {
        match self {
            Self::Range { first, .. } => first.saturating_add(at),
            Self::Indexed { indices, .. } => {
                let size = indices.ty.size();
                let start = indices.offset.saturating_add(at as usize * size);
                let bytes = indices.buffer.bytes().get(start..start.saturating_add(size));
                let index = IndexType::index(bytes.unwrap_or_default());
                index.wrapping_add_signed(indices.base_vertex)
            }
        }
    }
}

/// A location in a set of attributes.
pub(crate) fn bit(location: u8) -> u64 {
    1_u64.checked_shl(location.into()).unwrap_or(0)
}
