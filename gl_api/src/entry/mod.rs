//! The entry points: one table row each.
//!
//! A row of the `table` gives GL's name (and its aliases), the parameters with C's types, and the function that
//! does the work; `implement!` makes of it a method on [`Context`](crate::Context) and free functions
//! with GL's own names over the thread's current context. What a parameter accepts is in [`Arg`].
//!
//! | module | is |
//! |---|---|
//! | `table` | the rows, a file per chapter of the specification |
//! | [`description`] | what the table says of an entry point, as values |
//! | [`availability`] | which APIs, versions and extensions have a command |
//! | `implement` | methods and free functions from rows |
//! | `args` | what a parameter accepts |
//! | `component` | conversion of the components of attributes |
//! | `current` | the thread's current context |
//! | `exercise` | every call with random arguments |

#[macro_use]
mod implement;

pub(crate) mod args;
pub(crate) mod current;
pub mod description;
#[cfg(any(test, feature = "exercise"))]
pub mod exercise;
mod table;

pub use crate::base::args::{Data, DataOut, Names, Pointers, Strings, TextOut};
pub use crate::base::availability;
pub use args::{Arg, BUFFER_OFFSET, NULL, Null, Offset};
pub use current::{Current, set_current, with_current};
pub use table::*;

use description::EntryPoint;

/// Every entry point.
pub fn table() -> impl Iterator<Item = &'static EntryPoint> {
    CHAPTERS.iter().copied().flatten()
}

/// Every name of an entry point, with the number of its parameters.
pub fn implemented() -> impl Iterator<Item = (&'static str, usize)> {
    table().flat_map(|row| row.names.iter().map(|name| (name.name, row.parameters.len())))
}

/// Every entry point once, by the name that its messages have.
pub fn canonical() -> impl Iterator<Item = &'static str> {
    table().filter_map(|row| row.names.first()).map(|name| name.name)
}
