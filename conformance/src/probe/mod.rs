//! Computes values with the driver, through GL: contexts, draws of thousands of cases at once, and
//! exact read-back.
//!
//! One case is one 2×2 cell of the picture, drawn as a quad whose vertices all carry the same
//! three vectors; the fragment shader computes the value in question from them, and the lower left
//! pixel of the cell is read. Where neither derivatives nor vertices matter, a case is one pixel of
//! a *field*, and its inputs are texels of float textures. Values come back as bytes, or exactly: [`pack`]
//! spreads a float over the four bytes of a pixel.

mod blend;
mod error;
mod extreme;
mod field;
mod fixed;
mod fragment;
mod frame;
mod mipmaps;
mod own_context;
pub mod pack;
mod picture;
mod pixels;
mod points;
mod program;
mod pyramid;
mod session;
pub mod shader;
mod stages;
mod target;
mod texels;
mod texture;
mod words;

pub use blend::{BlendState, BlendedCell, equation_enum, factor_enum};
pub use error::ProbeError;
pub use extreme::{DepthBuffer, MatrixStep};
pub use fixed::FixedCell;
pub use fragment::operation_enum;
pub use mipmaps::MipmapRequest;
pub use own_context::OwnContext;
pub use picture::{FIELD, SIZE};
pub use pixels::{ClientPixels, StoredBox};
pub use points::GlTexGen;
pub use program::{Precision, Program};
pub use pyramid::{GREY, IntegerRow};
pub use session::{Dialect, Session, Vertex};
pub use stages::{Capture, Captured, Stages, mode_enum};

pub use texels::TexelRow;
pub use texture::{DepthTexture, Storage, compare_enum, filter_enum, min_filter_enum, wrap_enum};
