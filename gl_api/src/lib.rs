//! # gl_api: OpenGL 3.3, core and compatibility, over the rasterizer
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
//! The layers, from below; each uses only those above it in this table (ARCHITECTURE.md has the same order, and a test
//! holds it):
//!
//! | layer | is |
//! |---|---|
//! | `base` | [`constants`] and [`types`] of GL, [`error`]s, limits, the types of parameters |
//! | `pixel` | pixels in the client's memory and texels in storage: formats, layout, transfer, conversion |
//! | `assembly` | assembly programs: text to IR |
//! | `objects` | objects and their names, as plain data |
//! | `state` | the state tables of the specification, as plain values |
//! | `generate` | the fixed function as a generator of shaders |
//! | [`context`] | the context: state, objects, share group, messages, what is recorded and not submitted |
//! | `draw` | state and objects frozen into a draw, then commands of the driver |
//! | `calls` | the commands by subject: each converts its arguments, validates them, and applies the request |
//! | `record` | display lists, attribute stacks, selection and feedback |
//! | [`explain`] | how a pixel came to be |
//! | `entry` | the table of entry points: methods of [`Context`] and free functions with GL's names |
//! | [`glu`] | the utility library over the free functions |
//! | `host` | what the crate of the C ABI may do with contexts |
#![forbid(unsafe_code)]

mod query;

mod assembly;
mod base;
mod calls;
pub mod context;
mod draw;
mod entry;
pub mod explain;
mod generate;
pub mod glu;
#[doc(hidden)]
pub mod host;
mod objects;
mod pixel;
mod record;
mod state;

pub use ::glsl;
pub use base::availability::{Api, Version};
pub use base::client_memory::{ClientMemory, ClientPointer};
pub use base::constants::*;
pub use base::types::*;
pub use base::{constants, error, types};
pub use context::{
    Context, ContextDesc, ContextError, ForwardCompatible, GLDEBUGPROC, Message, ResetNotification,
    Severity, SurfaceColor, SurfaceDesc,
};
pub use entry::*;
pub use glsl::interface;
pub use pixel::formats;
