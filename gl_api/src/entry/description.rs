//! What the tables say of an entry point, and of the state that `glGet` answers.

use crate::base::availability;
use crate::base::availability::{Api, Availability, Version};
pub use crate::base::begin_end::BeginEnd;
pub use crate::query::state::{StateAvailability, StateDescription, ValueType, states};

/// An entry point, under all of its names.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct EntryPoint {
    /// The name that messages have, then its aliases.
    pub names: &'static [Name],
    /// Its parameters, in order.
    pub parameters: &'static [Parameter],
    /// The type of its result, as Rust writes it.
    pub result: Option<&'static str>,
    /// Whether it is allowed between `glBegin` and `glEnd`.
    pub begin_end: BeginEnd,
    /// Whether it is compiled into display lists.
    pub display_list: DisplayList,
}

/// One of the names of an entry point.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Name {
    /// GL's name.
    pub name: &'static str,
    /// Where there is a command of this name.
    pub availability: Availability,
}

impl Name {
    /// A name of the Khronos registry.
    ///
    /// # Panics
    /// If there is no such command, which is an error when the table is compiled.
    pub(crate) const fn of(name: &'static str) -> Self {
        match availability::of(name) {
            Some(availability) => Self { name, availability },
            None => panic!("an entry point that is not in the Khronos registry"),
        }
    }
}

/// A parameter of an entry point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Parameter {
    /// The registry's name, but where that is a word of Rust's.
    pub name: &'static str,
    /// Its type, as Rust writes it: `&'a [T]` and `&'a mut [T]` are arrays that are read and written,
    /// [`Data`](super::Data) and [`DataOut`](super::DataOut) `void` pointers.
    pub ty: &'static str,
}

/// What becomes of a call while a display list is compiled (GL 2.1, section 5.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DisplayList {
    /// It is part of the list.
    Compiled,
    /// It is carried out at once, or its function records what the list needs.
    NotCompiled,
}

impl EntryPoint {
    /// Whether a version of an API has it, under any of its names.
    pub fn is_in(&self, api: Api, version: Version) -> bool {
        self.names.iter().any(|name| name.availability.is_in(api, version))
    }
}
