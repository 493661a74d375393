//! The sources of vertex attributes.

use super::buffer::Buffer;
use std::num::NonZeroU32;

/// The type of an attribute's components in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum VertexType {
    /// Signed byte.
    I8,
    /// Unsigned byte.
    U8,
    /// Signed 16 bits.
    I16,
    /// Unsigned 16 bits.
    U16,
    /// Signed 32 bits.
    I32,
    /// Unsigned 32 bits.
    U32,
    /// Half precision (GL 3.0, section 2.1.2).
    F16,
    /// Single precision.
    F32,
    /// Double precision.
    F64,
    /// Signed, with 16 bits behind the point.
    Fixed,
    /// Four signed components in a word: three of 10 bits from the lowest on, then one of 2.
    I1010102,
    /// The same, unsigned.
    U1010102,
    /// Three unsigned floats in a word: of 11, 11 and 10 bits from the lowest on.
    F111110,
}

impl VertexType {
    /// Bytes from a component to the next; none where a word holds all of them.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 | Self::F16 => 2,
            Self::I32 | Self::U32 | Self::F32 | Self::Fixed => 4,
            Self::F64 => 8,
            Self::I1010102 | Self::U1010102 | Self::F111110 => 0,
        }
    }

    /// Bytes of an attribute with this many components.
    pub fn bytes(self, components: u8) -> usize {
        if self.is_packed() { 4 } else { usize::from(components) * self.size() }
    }

    /// Whether a word holds all components.
    pub fn is_packed(self) -> bool {
        self.size() == 0
    }
}

/// How an attribute's components become `f32`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum VertexFormat {
    /// Converted: 255 gives 255.0.
    Plain,
    /// Integers are divided by their largest value; signed by `(2c + 1) / (2^b - 1)` (GL 2.1, table 2.9).
    Normalized,
    /// The same; the components lie in the order blue, green, red, alpha.
    NormalizedBgra,
    /// Integers are divided by their largest value; signed ones are `max(c / (2^(b-1) - 1), -1)` (OpenGL ES 3.0,
    /// equation 2.2).
    NormalizedSymmetric,
    /// The bits of the integers, sign-extended to 32 (GL 3.0, section 2.7), for
    /// [`crate::ir::Op::FloatBits`]; floats keep their bits.
    Integer,
}

/// The source of an attribute. Missing components are 0, 0, 0, 1.
#[derive(Clone, Debug)]
pub enum VertexSource {
    /// The same for every vertex.
    Constant([f32; 4]),
    /// A strided array in memory. Bytes past the end of the buffer read as zeros.
    Array {
        /// The bytes.
        buffer: Buffer,
        /// The number of the first element in them; elements before it read as zeros.
        first: u32,
        /// Byte offset of that element.
        offset: usize,
        /// Bytes from a vertex to the next.
        stride: usize,
        /// Type of each component.
        ty: VertexType,
        /// 1 to 4.
        components: u8,
        /// The conversion.
        format: VertexFormat,
        /// 0: an element for each vertex; `n`: an element for each `n` instances (`ARB_instanced_arrays`).
        divisor: u32,
    },
}

impl VertexSource {
    /// How many instances share an element; `None` for attributes that advance with vertices.
    pub(crate) fn divisor(&self) -> Option<NonZeroU32> {
        match self {
            Self::Constant(_) => None,
            Self::Array { divisor, .. } => NonZeroU32::new(*divisor),
        }
    }

    /// The element that a vertex of an instance reads: the vertex number, or the instance divided by the divisor.
    pub fn element(&self, vertex: u32, instance: u32) -> u32 {
        self.divisor().map_or(vertex, |divisor| instance / divisor)
    }
}

/// The source of the attribute at a location.
#[derive(Clone, Debug)]
pub struct VertexBinding {
    /// Which attribute.
    pub location: u8,
    /// Its source.
    pub source: VertexSource,
}

impl VertexSource {
    /// The memory that it reads.
    pub fn buffer(&self) -> Option<&Buffer> {
        match self {
            Self::Array { buffer, .. } => Some(buffer),
            Self::Constant(_) => None,
        }
    }

    /// The end of that memory, in bytes from element 0.
    pub fn end(&self) -> usize {
        match self {
            Self::Array { buffer, first, stride, .. } => {
                *first as usize * stride + buffer.bytes().len()
            }
            Self::Constant(_) => 0,
        }
    }
}
