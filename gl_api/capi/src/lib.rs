//! # capi: the C ABI of DetGL
//!
//! Every entry point of GL under its own name, and EGL, OSMesa and GLU around them, in one shared library. The exports
//! are made from the table of entry points of [`gl_api`]; what a context lets its host do is in [`gl_api::host`].
//!
//! The modules, each over those before it:
//!
//! | module | is |
//! |---|---|
//! | `memory` | the memory behind C's pointers |
//! | `main_thread` | whether this is the thread that the process began with |
//! | `param` | C's arguments and results, and Rust's |
//! | `lengths` | how many elements a typed pointer has |
//! | `guard` | the door: what every call from C goes through |
//! | `gl` | the entry points of GL |
//! | `glu` | GLU |
//! | `imaging` | the names of the imaging subset |
//! | `glx` | the names of GLX |
//! | `egl` | EGL 1.5: displays, configs, surfaces, contexts |
//! | `osmesa` | OSMesa: contexts that draw into the client's memory |
//! | `info` | DetGL's own functions |
//! | `proc_address` | functions by name |
//! | `glvnd` | the vendor interface of libglvnd |
//!
//! This crate has `unsafe`. What it trusts is what C's prototypes cannot say: that a pointer has as many elements as
//! the specification lets the call read or write.
#![allow(unsafe_code, reason = "C's pointers; see the crate's documentation")]

mod egl;
mod gl;
mod glu;
#[cfg(feature = "c-names")]
mod glvnd;
#[cfg(feature = "c-names")]
mod glx;
mod guard;
#[cfg(feature = "c-names")]
mod imaging;
mod info;
mod lengths;
mod main_thread;
mod memory;
mod osmesa;
mod param;
mod proc_address;

pub use info::info;
pub use proc_address::{get_proc_address, get_proc_address_of};
