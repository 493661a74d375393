//! Pixels in memory, a client's or a texture's, as numbers: 64 at a time.
//!
//! A [`PixelLayout`] describes a pixel in memory: one to four words, whose [`Field`](crate::format::Field)s are numbers in
//! a [`NumberEncoding`]. [`read()`] and [`write()`] convert through `f64`, which holds every number of GL's types. Where two
//! layouts have the same bits at different positions, [`BitMoves`] moves them without conversion.

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
