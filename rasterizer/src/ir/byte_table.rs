//! Functions of bytes, as tables.

use std::fmt;
use texunit::lanes::math;

/// A function of the fractions k/255, k from 0 to 255: its 256 results. Of other numbers it gives the result for some k,
/// the same on every machine.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct ByteTable([u32; 256]);

impl ByteTable {
    /// About how many additions of 64 lanes a lookup takes as long as.
    pub const COST: u32 = 8;

    /// The table of a function.
    pub fn new(mut function: impl FnMut(f32) -> u32) -> Self {
        Self(std::array::from_fn(|byte| function(byte as f32 / 255.0)))
    }

    /// The word for a fraction.
    #[inline(always)]
    pub fn word(&self, fraction: f32) -> u32 {
        self.0[math::unit_byte(fraction) as usize & 0xff]
    }
}

impl fmt::Debug for ByteTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "ByteTable({:#x}, …, {:#x})", self.0[0], self.0[255])
    }
}

#[cfg(test)]
mod tests {
    use super::ByteTable;

    #[test]
    fn every_byte_has_its_word() {
        let table = ByteTable::new(f32::to_bits);
        for byte in 0..=255u8 {
            let fraction = f32::from(byte) / 255.0;
            assert_eq!(table.word(fraction), fraction.to_bits(), "{byte}");
        }
    }

    #[test]
    fn other_numbers_have_a_word() {
        let table = ByteTable::new(f32::to_bits);
        for number in [-1.0, 1.5, f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -0.0] {
            assert!(f32::from_bits(table.word(number)) <= 1.0, "{number}");
        }
    }
}
