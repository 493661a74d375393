//! # gl_api: OpenGL 3.1, compatibility, over the rasterizer
//!
//! The GL state machine: entry points, validation, objects, GLU, and the
//! translation of validated state into commands of the driver.
//!
//! ```
//! use gl_api::*;
//! let _current = Context::new(ContextDesc { width: 64, height: 64, ..Default::default() })
//!     .expect("a device")
//!     .make_current();
//! glClearColor(0, 0.5, 1, 1);
//! glClear(GL_COLOR_BUFFER_BIT);
//! glBegin(GL_TRIANGLES);
//! glTexCoord2f(0, 1);
//! glVertex2f(-0.8, 0.8);
//! glVertex2f(0.8, 0.8);
//! glVertex2f(0, -0.8);
//! glEnd();
//! assert_eq!(glGetError(), GL_NO_ERROR);
//! ```
//!
//! The modules in the order in which a call passes through them:
//!
//! | module | is |
//! |---|---|
//! | [`entry`] | the table of entry points: methods on [`Context`] and free functions |
//! | `client_memory`, `host` | what the crate of the C ABI hands in, and what it may do with contexts |
//! | [`constants`], [`types`] | GL's constants, from the Khronos registry, and C's types |
//! | [`error`] | refusals, and the tables that convert enums at the door |
//! | [`context`] | the context, its messages and limits |
//! | `state`, `env` | plain state by chapter; texture units and environments |
//! | `object` | names of textures, buffers, framebuffers, shaders, programs |
//! | `texture` | client pixels, internal formats, images and parameters |
//! | `framebuffer` | attachments, completeness, clearing, reading back |
//! | `pixels` | pixel rectangles and bitmaps as fragments, the raster position |
//! | `program` | uniforms, attributes, what a link found |
//! | [`glsl`], [`interface`] | the GLSL front end, a crate of its own, and where programs and state meet |
//! | `assembly` | assembly programs: parser, IR, the parameters they read |
//! | `fixed` | the fixed function as generated shaders |
//! | `uniform_buffer`, `transform_feedback` | blocks of uniforms from buffers; captured vertices |
//! | `draw` | vertices, draw calls, and their translation into driver commands |
//! | `list`, `evaluate`, `feedback` | display lists, evaluators, selection and feedback |
//! | `query` | `glGet` |
//! | [`explain`] | how a pixel came to be |
//! | [`glu`] | the utility library over the free functions |
#![forbid(unsafe_code)]

mod assembly;
mod client_memory;
pub mod constants;
pub mod context;
mod draw;
pub mod entry;
mod env;
pub mod error;
mod evaluate;
pub mod explain;
mod feedback;
mod fixed;
mod framebuffer;
pub mod glu;
#[doc(hidden)]
pub mod host;
mod list;
mod object;
mod pixels;
mod program;
mod query;
mod state;
mod texture;
mod transform_feedback;
pub mod types;
mod uniform_buffer;

pub use ::glsl;
pub use client_memory::{ClientMemory, ClientPointer};
pub use constants::*;
pub use context::{
    Context, ContextDesc, ContextError, GLDEBUGPROC, Message, Severity, SurfaceColor, SurfaceDesc,
};
pub use entry::*;
pub use glsl::interface;
pub use types::*;
