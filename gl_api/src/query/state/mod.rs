//! The table of the state that `glGet` and `glIsEnabled` read: one [`Row`] for each name, in a file for each
//! chapter of the state tables of GL 2.1, section 6.2. State with an index is in [`crate::query::indexed`].

mod current;
mod evaluators;
mod fragment;
mod framebuffer;
mod lighting;
mod limits;
mod miscellaneous;
mod pixels;
mod programs;
mod raster;
mod textures;
mod transform;
mod vertex_arrays;

use crate::base::availability::{Availability, Version};
use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum};
use crate::base::types::*;
use crate::base::value::Value;
use crate::context::Context;
use crate::query::enabled::is_on;

/// Where a value is in the context. The variant is the type of the value, which says how it becomes the type that
/// was asked for (GL 2.1, section 6.1.2): see [`crate::base::answer`].
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

    const fn of(spelling: &str) -> Self {
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
    fn value(&self, context: &Context) -> Result<Value> {
        Ok(match self.read {
            Read::Enabled => Value::Bools(vec![is_on(context, self.name)?]),
            Read::Flag(read) => Value::Bools(vec![read(context)]),
            Read::Flags(read) => Value::Bools(read(context).to_vec()),
            Read::Integer(read) => Value::Ints(vec![read(context)]),
            Read::Integers(read) => Value::Ints(read(context)),
            Read::Word(read) => Value::Word(read(context)),
            Read::Float(read) => Value::Floats(vec![read(context).into()]),
            Read::Floats(read) => Value::Floats(read(context)),
            Read::Fractions(read) => Value::Unit(read(context)),
            Read::UnitInteger(read) => Value::Ints(vec![read(context)?]),
            Read::UnitFloats(read) => Value::Floats(read(context)?),
        })
    }
}

/// `GL_NAME: Read;`, with `, AVAILABILITY` before the semicolon where the registry's is not the state's.
macro_rules! rows {
    ($($name:ident: $read:expr $(, $availability:expr)?;)*) => {
        &[$($crate::query::state::Row {
            name: $name,
            spelling: stringify!($name),
            read: $read,
            availability: rows!(@ $name $($availability)?),
        }),*]
    };
    (@ $name:ident) => { $crate::query::state::StateAvailability::of(stringify!($name)) };
    (@ $name:ident $availability:expr) => {
        $crate::query::state::StateAvailability::Stated($availability)
    };
}
use rows;

/// A count or a size as an integer; the largest one where it is larger.
fn saturated(value: impl TryInto<i32>) -> i32 {
    value.try_into().unwrap_or(i32::MAX)
}

fn doubles(values: &[f32]) -> Vec<f64> {
    values.iter().map(|&value| value.into()).collect()
}

/// State that the core profile and OpenGL ES 2.0 do not have.
const fn fixed_function(compatibility: Version, es1: Option<Version>) -> Availability {
    Availability { compatibility: Some(compatibility), core: None, es1, es2: None, extensions: &[] }
}

const CHAPTERS: [&[Row]; 13] = [
    current::ROWS,
    vertex_arrays::ROWS,
    transform::ROWS,
    lighting::ROWS,
    raster::ROWS,
    textures::ROWS,
    fragment::ROWS,
    framebuffer::ROWS,
    pixels::ROWS,
    evaluators::ROWS,
    programs::ROWS,
    limits::ROWS,
    miscellaneous::ROWS,
];

const COUNT: usize = {
    let (mut chapter, mut count) = (0, 0);
    while chapter < CHAPTERS.len() {
        count += CHAPTERS[chapter].len();
        chapter += 1;
    }
    count
};

/// All rows by ascending name. Two rows of one name do not compile.
static ROWS: [&Row; COUNT] = {
    let mut sorted = [&CHAPTERS[0][0]; COUNT];
    let (mut chapter, mut count) = (0, 0);
    while chapter < CHAPTERS.len() {
        let mut row = 0;
        while row < CHAPTERS[chapter].len() {
            let inserted = &CHAPTERS[chapter][row];
            let mut at = count;
            while at > 0 && sorted[at - 1].name > inserted.name {
                sorted[at] = sorted[at - 1];
                at -= 1;
            }
            assert!(at == 0 || sorted[at - 1].name != inserted.name, "two rows of one name");
            sorted[at] = inserted;
            count += 1;
            row += 1;
        }
        chapter += 1;
    }
    sorted
};

/// The row of a name.
fn row(pname: GLenum) -> Option<&'static Row> {
    ROWS.binary_search_by_key(&pname, |row| row.name).ok().map(|at| ROWS[at])
}

/// State by its name.
///
/// # Errors
/// `GL_INVALID_ENUM` where there is none of that name.
pub(crate) fn state_value(context: &Context, pname: GLenum) -> Result<Value> {
    match row(pname) {
        Some(row) => row.value(context),
        None => invalid_enum(
            "GL 2.1, section 6.1.1",
            format!("pname = {} names no state that DetGL has", enum_name(pname)),
        ),
    }
}

/// The type of a value before it is converted to what was asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ValueType {
    /// Truth values that `glIsEnabled` reads too.
    Capability,
    /// Truth values.
    Boolean,
    /// Numbers without a fraction.
    Integer,
    /// A symbol, name or mask.
    Word,
    /// Numbers that are rounded to integers.
    Float,
    /// Colours, normals and depths: as an integer, 1.0 is the largest one.
    Fraction,
}

/// What the table says of a name of state.
#[derive(Clone, Copy, Debug)]
pub struct StateDescription {
    /// GL's name.
    pub name: &'static str,
    /// Its value as an enum.
    pub value: GLenum,
    /// Its type.
    pub ty: ValueType,
    /// Where it can be asked for.
    pub availability: StateAvailability,
}

/// Every name of state that `glGet` answers, by ascending value.
pub fn states() -> impl Iterator<Item = StateDescription> {
    ROWS.iter().map(|row| StateDescription {
        name: row.spelling,
        value: row.name,
        ty: match row.read {
            Read::Enabled => ValueType::Capability,
            Read::Flag(_) | Read::Flags(_) => ValueType::Boolean,
            Read::Integer(_) | Read::Integers(_) | Read::UnitInteger(_) => ValueType::Integer,
            Read::Word(_) => ValueType::Word,
            Read::Float(_) | Read::Floats(_) | Read::UnitFloats(_) => ValueType::Float,
            Read::Fractions(_) => ValueType::Fraction,
        },
        availability: row.availability,
    })
}
