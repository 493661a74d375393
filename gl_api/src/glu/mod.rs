//! GLU 1.3: the utility library that the lectures' programs call beside GL.
//!
//! Tessellation and NURBS are not there: a program that needs them keeps the system's libGLU, which
//! works on top of this library.
//!
//! Everything here goes through GL's public functions, as the real GLU does.
//!
//! | module | is |
//! |---|---|
//! | [`angle`] | sine and cosine with the same bits on every machine |
//! | `matrix` | `gluPerspective`, `gluLookAt`, `gluOrtho2D` |
//! | `pixels` | client memory to numbers and back |
//! | `scale` | the box filter |
//! | `image` | `gluScaleImage`, the pixel store |
//! | `mipmap` | `gluBuild2DMipmaps` and its kin |
//! | `project` | `gluProject`, `gluUnProject`, `gluPickMatrix` |
//! | `quadric` | `gluSphere`, `gluCylinder`, `gluDisk` |
//! | `error` | GLU's error codes, `gluErrorString`, `gluGetString` |
#![allow(non_snake_case)]

mod error;
mod image;
mod matrix;
mod mipmap;
mod pixels;
mod project;
mod quadric;
mod revolve;
mod scale;

pub use crate::base::angle;
pub use error::*;
pub use image::gluScaleImage;
pub use matrix::{gluLookAt, gluOrtho2D, gluPerspective};
pub use mipmap::{
    gluBuild1DMipmapLevels, gluBuild1DMipmaps, gluBuild2DMipmapLevels, gluBuild2DMipmaps,
    gluBuild3DMipmapLevels, gluBuild3DMipmaps,
};
pub use project::{gluPickMatrix, gluProject, gluUnProject, gluUnProject4};
pub use quadric::*;
