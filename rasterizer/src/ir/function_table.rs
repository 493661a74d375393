//! Functions of one number, as tables.

use super::byte_table::ByteTable;
use super::ops::Op;
use std::sync::Arc;
use texunit::lanes::math::Power;

/// A function of one `f32` whose tables are made with the module.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum FunctionTable {
    /// Any function of bytes.
    OfByte(Arc<ByteTable>),
    /// A power with this exponent.
    Power(Arc<Power>),
}

impl FunctionTable {
    /// The powers with this exponent, given by its bits; `None` if there is no table of them.
    pub fn power(exponent: u32) -> Option<Self> {
        Power::new(f32::from_bits(exponent)).map(|power| Self::Power(Arc::new(power)))
    }

    /// About how many additions of 64 lanes it takes as long as.
    pub fn cost(&self) -> u32 {
        match self {
            Self::OfByte(_) => ByteTable::COST,
            Self::Power(_) => Power::COST,
        }
    }

    /// The word for a number.
    pub fn word(&self, x: f32) -> u32 {
        match self {
            Self::OfByte(table) => table.word(x),
            Self::Power(power) => power.of(x).to_bits(),
        }
    }
}

impl Op {
    /// The operation on constants of a module that is being built: a power with a constant exponent is that of its table.
    pub fn fold(self, args: [u32; 3]) -> u32 {
        if self == Self::Pow
            && let Some(power) = FunctionTable::power(args[1])
        {
            return power.word(f32::from_bits(args[0]));
        }
        self.eval(args)
    }
}
