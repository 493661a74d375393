//! Internal formats of textures and renderbuffers: one table, a row a format.
//!
//! [`FORMATS`] says of each what is stored for it, what it may be used for, and which versions and extensions of which
//! API allow that (GL 2.1, tables 3.15 and 3.16; GL 3.3 core, tables 3.12 and 3.13; OpenGL ES 3.0, table 3.13).
//! `docs/formats.md` is generated from it.

mod row;
mod support;
mod table;
#[cfg(test)]
mod tests;
mod view_class;

pub use crate::base::availability::Availability;
pub use row::{ComponentType, FormatClass, InternalFormat, Renderable};
pub use table::FORMATS;
pub(crate) use view_class::{view_class, viewed_as};

use crate::base::constants::*;
use crate::base::error::{Result, not_a_choice};
use crate::base::types::*;
use texunit::format::Format;

/// Whether an internal format is of stencils alone. They are stored beside depths that nothing reads.
pub(crate) fn is_of_stencils(internal: GLenum) -> bool {
    find(internal).is_some_and(|row| row.renderable == Renderable::Stencil)
}

/// The row of a format.
pub fn find(name: GLenum) -> Option<&'static InternalFormat> {
    FORMATS.iter().find(|format| format.name == name)
}

/// The formats that a parameter takes.
pub(crate) struct FormatSet {
    /// Where the specification lists them.
    section: &'static str,
    contains: fn(&InternalFormat) -> bool,
}

/// Formats of textures that are not stored in blocks, generic compressed ones included.
pub(crate) const UNCOMPRESSED: FormatSet = FormatSet {
    section: "GL 2.1, table 3.16",
    contains: |format| !format.is_compressed() && format.is_for_textures(),
};

/// Formats of textures that are stored in blocks.
pub(crate) const COMPRESSED: FormatSet = FormatSet {
    section: "GL 2.1, section 3.8.3",
    contains: |format| format.is_compressed() && format.is_for_textures(),
};

/// Those of OpenGL ES; of ETC2 and EAC knows the module of their blocks.
pub(crate) const COMPRESSED_IN_ES: FormatSet = FormatSet {
    section: "OpenGL ES 3.0, section 3.8.6",
    contains: |format| format.is_compressed() && format.is_for_textures_in_es(),
};

impl FormatSet {
    /// The formats for which `contains` holds.
    pub const fn new(section: &'static str, contains: fn(&InternalFormat) -> bool) -> Self {
        Self { section, contains }
    }

    /// The row of a format of the set.
    pub fn get(&self, name: GLenum) -> Option<&'static InternalFormat> {
        find(name).filter(|format| (self.contains)(format))
    }

    /// The row of a format of the set; `argument` names it in the message.
    ///
    /// # Errors
    /// `GL_INVALID_ENUM`, listing what is possible.
    pub fn decode(&self, argument: &str, name: GLenum) -> Result<&'static InternalFormat> {
        self.get(name).ok_or_else(|| not_a_choice(self.section, argument, name, &self.values()))
    }

    /// The names of the set, in the order of the table.
    pub fn values(&self) -> Vec<GLenum> {
        let formats = FORMATS.iter().filter(|format| (self.contains)(format));
        formats.map(|format| format.name).collect()
    }
}

/// The format that `GL_TEXTURE_INTERNAL_FORMAT` reports where this one was asked for (GL 2.1, section 3.8.1): itself,
/// or the base format of a generic compressed one.
pub(crate) fn reported(name: GLenum) -> GLenum {
    match find(name) {
        Some(format) if format.class == FormatClass::GenericCompressed => format.base,
        Some(_) | None => name,
    }
}

/// The formats that `GL_COMPRESSED_TEXTURE_FORMATS` lists.
pub(crate) fn general_purpose_formats() -> Vec<GLenum> {
    let general = |format: &&InternalFormat| format.class == FormatClass::GeneralCompressed;
    FORMATS.iter().filter(general).map(|format| format.name).collect()
}

/// How formats are stored.
pub(crate) fn stored_formats() -> impl Iterator<Item = Format> {
    FORMATS.iter().map(|format| format.stored)
}

/// GL's name of a stored format: that of the last row with a size that is stored so, or else of the last row.
pub(crate) fn format_name(stored: Format) -> String {
    let rows = || FORMATS.iter().rev().filter(|format| format.stored == stored);
    let row = rows().find(|format| format.class == FormatClass::Sized).or_else(|| rows().next());
    row.map_or_else(String::new, |format| enum_name(format.name))
}

/// The numbers of components that `glTexImage` takes since GL 1.0.
const COMPONENTS: [(GLenum, Format); 4] =
    [(1, Format::L8), (2, Format::La8), (3, Format::Rgb8), (4, Format::Rgba8)];

/// What is stored of a texture image; the numbers 1 to 4 count too.
pub(crate) fn texture_format(internal: GLenum) -> Option<Format> {
    let number = || COMPONENTS.iter().find(|(number, _)| *number == internal).map(|row| row.1);
    match find(internal).filter(|format| format.is_for_textures()) {
        Some(format) => Some(format.stored),
        None => number(),
    }
}

/// What is stored for immutable storage: the name must be sized.
pub(crate) fn sized_format(internal: GLenum) -> Option<&'static InternalFormat> {
    find(internal).filter(|format| format.is_for_textures() && format.is_sized())
}
