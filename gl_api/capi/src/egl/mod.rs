//! EGL 1.5 without windows: the surfaceless, device and default platforms.
//!
//! Handles are numbers that are looked up, never addresses, and are not used twice: one that is
//! null, freed or made up gets its `EGL_BAD_…`. Contexts and surfaces lie in one registry under a
//! lock; while current, a context is in its thread's place ([`gl_api::set_current`]), and GL
//! calls touch no lock.
//!
//! | module | is |
//! |---|---|
//! | [`constants`], [`raw`] | C's constants and types, attribute lists |
//! | [`thread`] | what belongs to a thread |
//! | [`error`] | refusals, and `eglGetError` |
//! | [`config`] | the table of configs |
//! | [`registry`] | displays, contexts, surfaces, syncs and images by handle |
//! | [`choose`] | `eglChooseConfig` |
//! | [`display`] | platforms, devices, `eglInitialize`, `eglQueryString` |
//! | [`surface`] | pbuffers |
//! | [`context`] | `eglCreateContext` and its attributes |
//! | [`current`] | `eglMakeCurrent` |
//! | [`sync`] | fences |
//! | [`image`] | EGL images |
//! | [`functions`] | the table of functions |

mod choose;
mod config;
pub(crate) mod constants;
mod context;
pub(crate) mod current;
pub(crate) mod display;
pub(crate) mod error;
mod functions;
mod image;
pub(crate) mod raw;
pub(crate) mod registry;
mod surface;
mod sync;
pub(crate) mod thread;

pub(crate) use context::shared_by;
pub(crate) use functions::FUNCTIONS;
