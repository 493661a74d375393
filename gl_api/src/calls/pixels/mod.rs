//! Pixel rectangles as fragments: GL 2.1, sections 2.13, 3.6.4, 3.6.5, 3.7 and 4.3.3.
//!
//! The modules in the order in which pixels pass through them: the raster position says where they
//! go, `glDrawPixels`, `glCopyPixels` and `glBitmap` bring them, zoom says which of them each
//! pixel of the window gets, and a rectangle of fragments takes its colour or depth from there.

pub(crate) mod bitmap;
pub(crate) mod copy;
pub(crate) mod draw;
pub(crate) mod map;
pub(crate) mod memory;
pub(crate) mod position;
pub(crate) mod stencil;
pub(crate) mod store;
pub(crate) mod transfer;
pub(crate) mod zoom;
