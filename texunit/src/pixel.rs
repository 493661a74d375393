//! Pixels in memory, a client's or a texture's, as numbers: 64 at a time.
//!
//! A [`Record`] says how a pixel lies in memory: as one to four words, whose [`Field`](crate::format::Field)s are numbers in a
//! [`Code`]. [`read`] and [`write`] are the way through `f64`, which holds every number of GL's types;
//! where two records have the same bits in whatever places, [`Moves`] takes them over.

pub mod boxes;
mod change;
mod code;
mod mean;
mod moves;
mod numbers;
mod record;

pub use change::{Change, add, change};
pub use code::Code;
pub use mean::{Tap, interleave, means};
pub use moves::{Moves, Source, move_all};
pub use numbers::{Numbers, read, write, write_floats};
pub(crate) use numbers::{read_by, write_by};
pub use record::{ByteOrder, Record};

#[cfg(test)]
mod tests;
