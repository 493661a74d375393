//! A row of the table of state: the name, where its value is and of which type, and which APIs have it.

use crate::base::availability::{Api, Availability, REMOVED_VALUES, VALUES_OUTSIDE_ES, Version};
use crate::base::core_profile::{self, removed_value};
use crate::base::error::{ErrorCode, Result};
use crate::base::es_profile::foreign_value;
use crate::base::query_value::QueryValue;
use crate::base::types::*;
use crate::base::version;
use crate::context::Context;
use crate::context::profile::Profile;
use crate::query::enabled::is_on;

/// Where a value is in the context. The variant is the type of the value, which says how it becomes the type that
/// was asked for (GL 2.1, section 6.1.2): see [`crate::base::query_value`].
pub(crate) enum Read {
    /// A capability or a client's array, by the row's own name: what `glIsEnabled` answers.
    Enabled,
    Flag(fn(&Context) -> bool),
    Flags(fn(&Context) -> [bool; 4]),
    Integer(fn(&Context) -> i32),
    Integers(fn(&Context) -> Vec<i32>),
    /// A symbol, name or mask.
    Word(fn(&Context) -> GLenum),
    Float(fn(&Context) -> f32),
    Floats(fn(&Context) -> Vec<f64>),
    /// A colour, normal or depth: as an integer, 1.0 is the largest one.
    Fractions(fn(&Context) -> Vec<f64>),
    /// As `Integer`, of the active texture unit, which need not have this state.
    UnitInteger(fn(&Context) -> Result<i32>),
    /// As `Floats`, of the active texture unit, which need not have this state.
    UnitFloats(fn(&Context) -> Result<Vec<f64>>),
}

/// Which APIs and versions have a name of state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StateAvailability {
    /// What the Khronos registry says of the enum. It tells no uses of an enum apart, and has names of OpenGL 1.0
    /// that commands of 1.0 take in 1.1.
    Registry(Availability),
    /// Typed in, as the registry's enum has other uses that are there in more versions than the state.
    Stated(Availability),
}

impl StateAvailability {
    /// What is known.
    pub const fn get(self) -> Availability {
        match self {
            Self::Registry(availability) | Self::Stated(availability) => availability,
        }
    }

    pub(crate) const fn of(spelling: &str) -> Self {
        match crate::base::availability::of_enum(spelling) {
            Some(availability) => Self::Registry(availability),
            None => {
                panic!("the registry has no enum of that name: state its availability in the row")
            }
        }
    }
}

/// State by one name.
pub(crate) struct Row {
    pub name: GLenum,
    /// The name as it is written, with `GL_`.
    pub spelling: &'static str,
    pub read: Read,
    pub availability: StateAvailability,
}

impl Row {
    /// Checks that contexts of a profile have the state.
    pub fn check_profile(&self, profile: Profile) -> Result<()> {
        let has = match (profile, self.availability) {
            (Profile::Compatibility(_), _) => true,
            // By value: names that the core profile has replaced have the same.
            (Profile::Core(_), StateAvailability::Registry(_)) => {
                REMOVED_VALUES.binary_search(&self.name).is_err()
            }
            (Profile::Core(_), StateAvailability::Stated(availability)) => {
                core_profile::has(&availability)
            }
            (Profile::Es, StateAvailability::Registry(_)) => {
                VALUES_OUTSIDE_ES.binary_search(&self.name).is_err()
            }
            (Profile::Es, StateAvailability::Stated(availability)) => {
                availability.is_in(Api::Es2, version::IMPLEMENTED_ES)
            }
        };
        match profile {
            _ if has => Ok(()),
            Profile::Es => Err(foreign_value("pname", self.name, ErrorCode::InvalidEnum)),
            Profile::Core(_) | Profile::Compatibility(_) => {
                Err(removed_value("pname", self.name, ErrorCode::InvalidEnum))
            }
        }
    }

    pub fn value(&self, context: &Context) -> Result<QueryValue> {
        Ok(match self.read {
            Read::Enabled => QueryValue::Bools(vec![is_on(context, self.name)?]),
            Read::Flag(read) => QueryValue::Bools(vec![read(context)]),
            Read::Flags(read) => QueryValue::Bools(read(context).to_vec()),
            Read::Integer(read) => QueryValue::Ints(vec![read(context)]),
            Read::Integers(read) => QueryValue::Ints(read(context)),
            Read::Word(read) => QueryValue::Word(read(context)),
            Read::Float(read) => QueryValue::Floats(vec![read(context).into()]),
            Read::Floats(read) => QueryValue::Floats(read(context)),
            Read::Fractions(read) => QueryValue::Unit(read(context)),
            Read::UnitInteger(read) => QueryValue::Ints(vec![read(context)?]),
            Read::UnitFloats(read) => QueryValue::Floats(read(context)?),
        })
    }
}

/// `GL_NAME: Read;`, with `, AVAILABILITY` before the semicolon where the registry's is not the state's.
macro_rules! rows {
    ($($name:ident: $read:expr $(, $availability:expr)?;)*) => {
        &[$($crate::query::state::row::Row {
            name: $name,
            spelling: stringify!($name),
            read: $read,
            availability: rows!(@ $name $($availability)?),
        }),*]
    };
    (@ $name:ident) => { $crate::query::state::row::StateAvailability::of(stringify!($name)) };
    (@ $name:ident $availability:expr) => {
        $crate::query::state::row::StateAvailability::Stated($availability)
    };
}
pub(super) use rows;

/// A count or a size as an integer; the largest one where it is larger.
pub(super) fn saturated(value: impl TryInto<i32>) -> i32 {
    value.try_into().unwrap_or(i32::MAX)
}

pub(super) fn doubles(values: &[f32]) -> Vec<f64> {
    values.iter().map(|&value| value.into()).collect()
}

/// State that the core profile and OpenGL ES 2.0 do not have.
pub(super) const fn fixed_function(compatibility: Version, es1: Option<Version>) -> Availability {
    Availability { compatibility: Some(compatibility), core: None, es1, es2: None, extensions: &[] }
}
