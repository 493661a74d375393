//! The indices of a draw.

use super::buffer::Buffer;

/// The type of an index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum IndexType {
    /// 8 bits.
    U8,
    /// 16 bits.
    U16,
    /// 32 bits.
    U32,
}

impl IndexType {
    /// Bytes of an index.
    pub fn size(self) -> usize {
        match self {
            Self::U8 => 1,
            Self::U16 => 2,
            Self::U32 => 4,
        }
    }

    /// The index that these bytes are, the lowest first; 0 where there are none.
    pub fn index(bytes: &[u8]) -> u32 {
        bytes.iter().rev().fold(0, |index, &byte| index << 8 | u32::from(byte))
    }
}

/// The indices of a draw. What lies past the buffer's end reads as index 0.
#[derive(Clone, Debug)]
pub struct Indices {
    /// The bytes.
    pub buffer: Buffer,
    /// Byte of the first index.
    pub offset: usize,
    /// Their type.
    pub ty: IndexType,
    /// Added to each index.
    pub base_vertex: i32,
}
