//! # architecture: the order of layers, read from the sources
//!
//! A *layer* is a file or folder directly under a crate's `src`. [`Sources::read`] parses every module of a crate
//! with `syn`, [`resolve`] finds the file that defines what a path names (through re-exports), and [`Graph`] has
//! the references between files. [`page::orders`] reads the order of the layers from the tables of ARCHITECTURE.md;
//! [`check`] compares the two.
//!
//! Two things count as a reference from one file to another:
//!
//! - a path (in a `use`, an expression, a type, a pattern, or the tokens of a macro call) that names an item of the
//!   other file;
//! - a call of a method that only the other file defines, where that file's layer is not the layer of the method's
//!   type: `impl Context` in `calls` adds methods to a type of `context`, and a call of one needs `calls`.
//!
//! Tests (`#[cfg(test)]`) do not count.

pub mod check;
pub mod graph;
pub mod page;
pub mod resolve;
pub mod sources;

pub use check::{Violation, check};
pub use graph::Graph;
pub use sources::{ReadError, Sources};
