//! The client's side of the C ABI: a driver's libEGL is opened at run time, and its GL is called
//! through the function pointers that `eglGetProcAddress` gives.
//!
//! The only `unsafe` code of this crate: calls through function pointers of another library. The public
//! functions are safe. Numbers are passed unchanged, since GL reports wrong ones by an error; memory is
//! passed as slices, whose lengths are checked against the number of bytes that the call accesses.

#![allow(unsafe_code)]

mod bindings;
mod context;
mod error;
mod gl;
mod mesh;

pub use context::Client;
pub use error::ClientError;
pub use gl::Gl;
pub use mesh::{Mesh, MeshName, Vertex};
