//! How the components of a pixel are written in the client's memory (GL 2.1, table 3.5; GL 3.0 for
//! floats).

use crate::base::constants::*;
use crate::base::error::Table;
use crate::base::types::*;
use crate::pixel::client::format::Numbers;
use crate::pixel::packed::{PACKED, Packed};
use texunit::format::Field;
use texunit::pixel::{ByteOrder, NumberEncoding, PixelLayout};

/// How the components of a pixel are written (GL 2.1, table 3.5).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ClientType {
    /// A bit, eight to a byte; it is taken apart to a byte before it is read.
    Bit,
    U8,
    I8,
    U16,
    I16,
    U32,
    I32,
    F16,
    F32,
    /// All components in one word.
    Packed(Packed),
    /// Three 9-bit mantissas with a common exponent (`EXT_texture_shared_exponent`).
    Rgb9E5,
    /// Unsigned floats of 11, 11 and 10 bits (`EXT_packed_float`).
    R11G11B10F,
    /// 24 bits of depth above 8 of stencil.
    Depth24Stencil8,
    /// A float of depth, then a word with 8 bits of stencil.
    Depth32FStencil8,
}

const PLAIN: [(GLenum, ClientType); 13] = [
    (GL_BITMAP, ClientType::Bit),
    (GL_UNSIGNED_BYTE, ClientType::U8),
    (GL_BYTE, ClientType::I8),
    (GL_UNSIGNED_SHORT, ClientType::U16),
    (GL_SHORT, ClientType::I16),
    (GL_UNSIGNED_INT, ClientType::U32),
    (GL_INT, ClientType::I32),
    (GL_FLOAT, ClientType::F32),
    (GL_HALF_FLOAT, ClientType::F16),
    (GL_UNSIGNED_INT_5_9_9_9_REV, ClientType::Rgb9E5),
    (GL_UNSIGNED_INT_10F_11F_11F_REV, ClientType::R11G11B10F),
    (GL_UNSIGNED_INT_24_8, ClientType::Depth24Stencil8),
    (GL_FLOAT_32_UNSIGNED_INT_24_8_REV, ClientType::Depth32FStencil8),
];

const TYPES: [(GLenum, ClientType); PLAIN.len() + PACKED.len()] = {
    let mut rows = [PLAIN[0]; PLAIN.len() + PACKED.len()];
    let mut row = 0;
    while row < rows.len() {
        rows[row] = if row < PLAIN.len() {
            PLAIN[row]
        } else {
            let (name, packed) = PACKED[row - PLAIN.len()];
            (name, ClientType::Packed(packed))
        };
        row += 1;
    }
    rows
};

/// What `type` can be.
pub(crate) const TYPE: Table<ClientType> = Table { section: "GL 2.1, table 3.5", rows: &TYPES };

impl ClientType {
    /// Bytes of an element, a component or a whole packed pixel: what alignment and byte order
    /// are about.
    pub fn size(self) -> usize {
        match self {
            Self::Bit | Self::U8 | Self::I8 => 1,
            Self::U16 | Self::I16 | Self::F16 => 2,
            Self::U32 | Self::I32 | Self::F32 => 4,
            Self::Rgb9E5 | Self::R11G11B10F | Self::Depth24Stencil8 | Self::Depth32FStencil8 => 4,
            Self::Packed(packed) => packed.bytes.into(),
        }
    }

    /// Elements of a pixel of so many components.
    pub fn elements(self, components: usize) -> usize {
        match self {
            Self::U8 | Self::I8 | Self::U16 | Self::I16 | Self::U32 | Self::I32 => components,
            Self::Bit | Self::F16 | Self::F32 => components,
            Self::Packed(_) | Self::Rgb9E5 | Self::R11G11B10F | Self::Depth24Stencil8 => 1,
            Self::Depth32FStencil8 => 2,
        }
    }

    pub(crate) fn is_float(self) -> bool {
        match self {
            Self::F16 | Self::F32 => true,
            // Packed types go with a row of formats.
            Self::Rgb9E5 | Self::R11G11B10F | Self::Depth32FStencil8 => false,
            Self::U8 | Self::I8 | Self::U16 | Self::I16 | Self::U32 | Self::I32 => false,
            Self::Bit | Self::Packed(_) | Self::Depth24Stencil8 => false,
        }
    }

    /// How a pixel of so many components lies in memory, whose integers mean `numbers`. Bits are taken apart to bytes
    /// before.
    pub fn record(self, components: usize, numbers: Numbers, order: ByteOrder) -> PixelLayout {
        let (unsigned, signed) = match numbers {
            Numbers::Fixed => (NumberEncoding::Unorm, NumberEncoding::Fixed),
            Numbers::SignedNormalized => (NumberEncoding::Unorm, NumberEncoding::Snorm),
            Numbers::Integer => (NumberEncoding::Uint, NumberEncoding::Sint),
        };
        let field = |word, shift, bits| Field { word, shift, bits };
        let uniform = |code| PixelLayout::uniform(components, self.size(), code, order);
        let packed = |words, numbers: &[_]| PixelLayout::packed(self.size(), words, order, numbers);
        match self {
            Self::Bit | Self::U8 | Self::U16 | Self::U32 => uniform(unsigned),
            Self::I8 | Self::I16 | Self::I32 => uniform(signed),
            Self::F16 | Self::F32 => uniform(NumberEncoding::Float),
            Self::Packed(packed) => {
                let fields = [0, 1, 2, 3].map(|index| (packed.field(index), unsigned));
                PixelLayout::packed(self.size(), 1, order, &fields[..packed.bits.len()])
            }
            Self::Rgb9E5 => packed(
                1,
                &[0, 9, 18].map(|shift| (field(0, shift, 9), NumberEncoding::SharedExponent)),
            ),
            Self::R11G11B10F => {
                let fields = [field(0, 0, 11), field(0, 11, 11), field(0, 22, 10)];
                packed(1, &fields.map(|field| (field, NumberEncoding::Float)))
            }
            Self::Depth24Stencil8 => packed(
                1,
                &[(field(0, 8, 24), NumberEncoding::Unorm), (field(0, 0, 8), NumberEncoding::Uint)],
            ),
            Self::Depth32FStencil8 => packed(
                2,
                &[(field(0, 0, 32), NumberEncoding::Float), (field(1, 0, 8), NumberEncoding::Uint)],
            ),
        }
    }
}
