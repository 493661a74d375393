//! Immediate mode: GL 2.1, sections 2.6 and 2.7.
//!
//! `glBegin` opens a collection of vertices: positions, and a column for each attribute that is set
//! before `glEnd`, which draws them. Attributes that are not set are constants of the draw. One `glEnd`
//! after the other with nothing else in between is one draw: see [`super::pending_primitives`].

use crate::base::error::Result;
use crate::base::limits::LOCATIONS;
use crate::base::texture_unit::texture_unit;
use crate::base::types::*;
use crate::interface::ATTRIB_TEX_COORD;
use crate::objects::arrays::generic;
use crate::state::State;
use crate::state::material::{MATERIAL_COLUMNS, Materials};
use crate::state::versioned::Versioned;
use rasterizer::driver::{Buffer, Topology};
use std::collections::TryReserveError;
use std::ops::Range;

/// What can have a column: the attributes, and behind them the parts of the materials.
pub(crate) const COLUMNS: usize = LOCATIONS + MATERIAL_COLUMNS;
/// [`Immediate::column_by_location`] of a location without a column.
pub(crate) const NO_COLUMN: u8 = u8::MAX;
/// Bytes of a value in a column.
pub(crate) const VALUE: usize = 16;

/// The vertices since `glBegin`.
#[derive(Debug)]
pub(crate) struct Immediate {
    pub(crate) topology: Topology,
    pub(crate) positions: Vec<[f32; 4]>,
    pub(crate) columns: Vec<Column>,
    /// By location, which of the columns is its own.
    pub column_by_location: [u8; COLUMNS],
    /// Whether there was no memory for a vertex: then nothing of the primitive is drawn.
    pub(crate) is_lost: bool,
    /// What the materials were before the first `glMaterial` since `glBegin`.
    pub(crate) materials: Option<Box<Versioned<Materials>>>,
}

/// The values of an attribute, or of a part of a material, that is set since `glBegin`.
#[derive(Debug)]
pub(crate) struct Column {
    pub location: usize,
    pub values: Vec<[f32; 4]>,
}

/// What an attribute call sets.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Slot {
    /// The position: ends the vertex.
    Vertex,
    /// A conventional attribute, or a part of a material, by its location.
    Location(u8),
    /// The coordinates of a texture unit, as `GL_TEXTUREi`.
    TexCoord(GLenum),
    /// A generic attribute by its index; 0 is the position.
    Generic(GLuint),
}

impl Immediate {
    pub(crate) fn new(topology: Topology) -> Self {
        Self {
            topology,
            positions: Vec::new(),
            columns: Vec::new(),
            column_by_location: [NO_COLUMN; COLUMNS],
            is_lost: false,
            materials: None,
        }
    }

    /// Gives all vertices back, as there is no memory for one.
    #[cold]
    #[inline(never)]
    pub(crate) fn lose(&mut self) {
        self.is_lost = true;
        self.positions = Vec::new();
        self.columns.iter_mut().for_each(|column| column.values = Vec::new());
    }

    /// Makes room for so many more vertices, in all columns.
    ///
    /// # Errors
    /// Where there is no memory; then no column has more values than another.
    #[inline]
    pub(crate) fn make_room(&mut self, vertices: usize) -> Result<(), TryReserveError> {
        self.positions.try_reserve(vertices)?;
        self.columns.iter_mut().try_for_each(|column| column.values.try_reserve(vertices))
    }

    /// Which of the columns is a location's.
    pub(crate) fn column_of(&self, location: usize) -> Option<usize> {
        let place = self.column_by_location[location];
        (place != NO_COLUMN).then_some(place.into())
    }
}

/// How many components of each value are read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum ColumnComponents {
    /// Three, as the fourth is 1 in all values, which it also is where an array has three: then texture coordinates need
    /// no division, and colours no blending.
    #[default]
    Three,
    /// All.
    Four,
}

impl ColumnComponents {
    /// Those of a column with these values.
    pub fn of(values: &[[f32; 4]]) -> Self {
        let is_one = |[.., last]: &[f32; 4]| last.to_bits() == 1f32.to_bits();
        if values.iter().all(is_one) { Self::Three } else { Self::Four }
    }

    /// Those of a column that has the values of both.
    pub fn with(self, other: Self) -> Self {
        match self {
            Self::Three => other,
            Self::Four => Self::Four,
        }
    }

    /// As a number.
    pub fn count(self) -> u8 {
        match self {
            Self::Three => 3,
            Self::Four => 4,
        }
    }
}

/// Vertices in a buffer of columns: positions, then a column for each attribute that has one.
pub(crate) struct Columns<'a> {
    pub buffer: &'a Buffer,
    /// Of the positions, then of each column.
    pub components: [ColumnComponents; COLUMNS + 1],
    /// How many vertices the columns are of.
    pub count: usize,
    /// The vertices that are drawn.
    pub range: Range<usize>,
}

/// The location that an attribute call sets; `None` for the position.
///
/// # Errors
/// When there is no such unit or generic attribute.
pub(crate) fn location(slot: Slot) -> Result<Option<usize>> {
    Ok(match slot {
        Slot::Vertex => None,
        Slot::Location(location) => Some(usize::from(location)),
        Slot::TexCoord(texture) => {
            let unit = texture_unit("GL 2.1, section 2.7", texture)?;
            Some(usize::from(ATTRIB_TEX_COORD + unit))
        }
        Slot::Generic(index) => Some(usize::from(generic(index)?)).filter(|&index| index != 0),
    })
}

/// The current value of an attribute, or of a part of a material.
pub(crate) fn current(state: &State, location: usize) -> [f32; 4] {
    match state.current.get(location) {
        Some(value) => *value,
        None => state.materials.column(location),
    }
}
