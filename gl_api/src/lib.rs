//! # gl_api: OpenGL 2.1 over the rasterizer
//!
//! The GL state machine: entry points, validation, objects, GLU, the GLSL front end, and the
//! translation of validated state into commands of the driver.
#![deny(unsafe_code)]

pub mod glsl;
pub mod interface;
