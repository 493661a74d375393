//! The table of texel formats.
//!
//! Texels are stored as what they are; a filter converts the ones it reads. The table itself is
//! in `format/table.rs`; the conversions that follow from its columns in [`convert`], [`integer`]
//! and [`block`].

pub mod block;
pub mod convert;
pub mod integer;
mod layout;
mod properties;
pub mod shared_exponent;
pub mod small_float;
pub mod srgb;
mod table;
mod words;

pub(crate) use layout::Component;
pub use layout::{BaseFormat, Block, Encoding, Field, FormatInfo};
pub use table::Format;
