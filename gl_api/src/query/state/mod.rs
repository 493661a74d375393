//! The table of the state that `glGet` and `glIsEnabled` read: one [`row::Row`] for each name, in a file for each
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
mod row;
mod textures;
mod transform;
mod vertex_arrays;

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum};
use crate::base::query_value::QueryValue;
use crate::base::types::*;
use crate::context::Context;
use row::{Read, Row};

pub use row::StateAvailability;

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

pub(crate) use limits::compressed_formats;

/// The row of a name.
fn row(pname: GLenum) -> Option<&'static Row> {
    ROWS.binary_search_by_key(&pname, |row| row.name).ok().map(|at| ROWS[at])
}

/// State by its name.
///
/// # Errors
/// `GL_INVALID_ENUM` where there is none of that name.
pub(crate) fn state_value(context: &Context, pname: GLenum) -> Result<QueryValue> {
    match row(pname) {
        Some(row) => {
            row.check_profile(context.profile)?;
            row.value(context)
        }
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
#[non_exhaustive]
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
