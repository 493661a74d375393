//! # architecture: the order of layers, read from the sources
//!
//! A *layer* is a module at the root of a crate: a file or folder directly under its `src`. ARCHITECTURE.md has a
//! table of the layers of each crate, from below, and `tests/layers.rs` holds the sources to these tables.
//!
//! | step | is done by |
//! |---|---|
//! | the crates of the workspace, and what each depends on | [`manifest`] |
//! | every module of a crate: items, imports, paths, method calls | [`read_crate`] |
//! | the items that a path names, through imports and re-exports | [`resolve`] |
//! | the references between the files of a crate | [`Graph::of`] |
//! | the order of layers that the page prints | [`page`] |
//! | what breaks the order | [`check()`] |
//!
//! ```text
//! cargo run -p architecture -- texunit
//! ```
//!
//! prints the references between the layers of `texunit`, the circles of layers and files, and the violations of
//! the table. `--to LAYER` and `--from LAYER` list the references one by one; each takes a file as well.
//!
//! # References
//!
//! A reference from one file to another is
//!
//! - a path (in a `use`, an expression, a type, a pattern, or the tokens of a macro) that names an item of the other
//!   file, or a glob import of its module;
//! - a call of a macro that the other file defines;
//! - a call of a method that only the other file defines, where that file is in another layer than the method's
//!   type: `impl Context` in `calls` adds methods to a type of `context`, and a call of one needs `calls`.
//!
//! # What does not count
//!
//! - Code that no build without `test` has ([`is_test`]).
//! - The crate's root, `lib.rs`: it lists and re-exports.
//! - Programs (`src/main.rs`, `src/bin`): nothing can name them, so they are above every layer.
//! - Paths that begin with another crate's name.
//!
//! # Limits
//!
//! Types are not inferred, and macros are not expanded. A method is known by its name alone, so one whose name a
//! second type or a trait of the crate has as well is not followed. The items that a macro call makes are taken to be
//! all names in its tokens, and those that the macro's definition has after `struct`, `fn` and the like.

pub mod api;
mod cfg;
pub mod check;
mod circles;
mod dependencies;
mod error;
pub mod graph;
mod late_errors;
pub mod manifest;
mod methods;
pub mod page;
mod read;
mod requests;
pub mod resolve;
pub mod sources;
mod tokens;
mod unsafe_code;

pub use cfg::is_test;
pub use check::{Violation, check};
pub use dependencies::against_chain;
pub use error::ReadError;
pub use graph::Graph;
pub use late_errors::{LateError, late_errors};
pub use read::read_crate;
pub use requests::fallible_requests;
pub use sources::Sources;
pub use unsafe_code::unsafe_files;
