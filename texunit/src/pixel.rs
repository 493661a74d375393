//! Pixels in memory, a client's or a texture's, as numbers: 64 at a time.
//!
//! A [`PixelLayout`] says how a pixel lies in memory: as one to four words, whose [`Field`](crate::format::Field)s are numbers in a
//! [`NumberEncoding`]. [`read`] and [`write`] are the way through `f64`, which holds every number of GL's types;
//! where two records have the same bits in whatever places, [`BitMoves`] takes them over.

pub mod boxes;
mod layout;
mod mean;
mod moves;
mod number;
mod numbers;
mod transform;

pub use layout::{ByteOrder, PixelLayout};
pub use mean::{Tap, interleave, means};
pub use moves::{BitMoves, Source, move_all};
pub use number::NumberEncoding;
pub use numbers::{Numbers, read, write, write_floats};
pub(crate) use numbers::{read_by, write_by};
pub use transform::{NumberTransform, add, transform};

#[cfg(test)]
mod tests;
