//! Pixel types that hold all components of a pixel in one word (GL 2.1, tables 3.8 to 3.11).

use crate::base::constants::*;
use crate::base::types::GLenum;
use texunit::format::Field;

/// A packed pixel type of unsigned fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Packed {
    /// Bytes of the whole pixel: 1, 2 or 4.
    pub bytes: u8,
    /// Bits of each component, the first component first.
    pub bits: &'static [u8],
    first: FirstComponent,
}

/// The end of the word at which the first component is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FirstComponent {
    Top,
    /// The `_REV` types.
    Bottom,
}

const fn top(bytes: u8, bits: &'static [u8]) -> Packed {
    Packed { bytes, bits, first: FirstComponent::Top }
}

const fn bottom(bytes: u8, bits: &'static [u8]) -> Packed {
    Packed { bytes, bits, first: FirstComponent::Bottom }
}

/// The packed types of GL 2.1, table 3.8.
pub(crate) const PACKED: [(GLenum, Packed); 12] = [
    (GL_UNSIGNED_BYTE_3_3_2, top(1, &[3, 3, 2])),
    (GL_UNSIGNED_BYTE_2_3_3_REV, bottom(1, &[3, 3, 2])),
    (GL_UNSIGNED_SHORT_5_6_5, top(2, &[5, 6, 5])),
    (GL_UNSIGNED_SHORT_5_6_5_REV, bottom(2, &[5, 6, 5])),
    (GL_UNSIGNED_SHORT_4_4_4_4, top(2, &[4, 4, 4, 4])),
    (GL_UNSIGNED_SHORT_4_4_4_4_REV, bottom(2, &[4, 4, 4, 4])),
    (GL_UNSIGNED_SHORT_5_5_5_1, top(2, &[5, 5, 5, 1])),
    (GL_UNSIGNED_SHORT_1_5_5_5_REV, bottom(2, &[5, 5, 5, 1])),
    (GL_UNSIGNED_INT_8_8_8_8, top(4, &[8, 8, 8, 8])),
    (GL_UNSIGNED_INT_8_8_8_8_REV, bottom(4, &[8, 8, 8, 8])),
    (GL_UNSIGNED_INT_10_10_10_2, top(4, &[10, 10, 10, 2])),
    (GL_UNSIGNED_INT_2_10_10_10_REV, bottom(4, &[10, 10, 10, 2])),
];

impl Packed {
    /// The field of component `index`; a component that the type lacks has no bits.
    pub fn field(self, index: usize) -> Field {
        let bits = self.bits.get(index).copied().unwrap_or(0);
        let below: u8 = match self.first {
            FirstComponent::Top => self.bits.iter().skip(index + 1).sum(),
            FirstComponent::Bottom => self.bits.iter().take(index).sum(),
        };
        Field { word: 0, shift: below.into(), bits: bits.into() }
    }
}
