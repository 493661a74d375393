//! The client's side of the C ABI: a driver's libEGL is opened at run time, and its GL is called
//! through the function pointers that `eglGetProcAddress` gives.
//!
//! The only `unsafe` of this crate: a call through a pointer of another library. What comes out of
//! here is safe to call. Numbers go to GL as they are, and GL answers wrong ones with an error;
//! memory goes as slices whose length is checked against what the call reads or writes.

#![allow(unsafe_code)]

mod bindings;
mod context;
mod gl;
mod mesh;

pub use context::Client;
pub use gl::Gl;
pub use mesh::{Mesh, MeshName, Vertex};

/// Why a driver cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum ClientError {
    /// The library is not there, or is no EGL 1.4.
    #[error("{library} cannot be opened as EGL 1.4: {reason}")]
    Library {
        /// Its path or name.
        library: String,
        /// What the loader says.
        reason: String,
    },
    /// EGL refuses.
    #[error("{call}: {reason}")]
    Egl {
        /// The call.
        call: &'static str,
        /// Its error.
        reason: String,
    },
    /// A shader does not compile, or a program does not link.
    #[error("the driver refuses a {stage}: {log}")]
    Shader {
        /// "vertex shader", "fragment shader" or "program".
        stage: &'static str,
        /// Its info log.
        log: String,
    },
    /// The error flag is set.
    #[error("{after}: glGetError is {code:#06x}")]
    Gl {
        /// What was being done.
        after: &'static str,
        /// The code.
        code: u32,
    },
}
