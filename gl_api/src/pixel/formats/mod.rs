//! Internal formats of textures and renderbuffers: one table, a row a format.
//!
//! [`FORMATS`] says of each what is stored for it, what it may be used for, and which versions and extensions of which
//! API allow that (GL 2.1, tables 3.15 and 3.16; GL 3.3 core, tables 3.12 and 3.13; OpenGL ES 3.0, table 3.13).
//! `docs/formats.md` is generated from it.

mod support;
mod table;
#[cfg(test)]
mod tests;

pub use crate::base::availability::Availability;
pub use table::FORMATS;

use crate::base::availability::{Api, Version};
use crate::base::constants::*;
use crate::base::error::{Result, not_a_choice};
use crate::base::limits;
use crate::base::types::*;
use texunit::format::Format;

/// What the components of a format are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ComponentType {
    /// Fractions from 0 to 1.
    Unorm,
    /// Fractions from -1 to 1.
    Snorm,
    /// Floats, also with an exponent that they share.
    Float,
    /// Signed integers.
    Sint,
    /// Unsigned integers.
    Uint,
}

/// How much of the storage a format's name determines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FormatClass {
    /// The sizes of components, which the implementation chooses.
    Unsized,
    /// Nothing: the sizes of components are part of the name.
    Sized,
    /// The compression, which the implementation chooses: none.
    GenericCompressed,
    /// Nothing: blocks that serve any texture, so that `GL_COMPRESSED_TEXTURE_FORMATS` lists them.
    GeneralCompressed,
    /// Nothing: blocks that serve some textures only: of one bit of alpha (`EXT_texture_compression_s3tc`), for sRGB
    /// (`EXT_texture_sRGB`), or of fewer channels (`ARB_texture_compression_rgtc`, `EXT_texture_compression_latc`).
    SpecialCompressed,
}

/// Which attachments of a framebuffer an image of a format can be drawn to as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Renderable {
    /// None.
    No,
    /// Colour attachments.
    Color,
    /// The depth attachment.
    Depth,
    /// The depth and the stencil attachment.
    DepthStencil,
    /// The stencil attachment.
    Stencil,
}

/// An internal format.
#[derive(Clone, Copy, Debug)]
pub struct InternalFormat {
    /// GL's value.
    pub name: GLenum,
    /// The base internal format.
    pub base: GLenum,
    /// How texels are stored: where none is stored with so many bits, with the next larger number.
    pub stored: Format,
    /// The type of its components.
    pub components: ComponentType,
    /// Sized, unsized or compressed.
    pub class: FormatClass,
    /// What images of it can be attached as, where they can be drawn to at all.
    pub renderable: Renderable,
    /// Where textures may have it.
    pub texture: Availability,
    /// Where renderbuffers may have it. In OpenGL, `GL_RGB9_E5` is stored but not drawn to (GL 3.0, section 4.4.4).
    pub renderbuffer: Availability,
    /// Where linear filters take it.
    pub filter: Availability,
    /// Where buffer textures may have it.
    pub texel_buffer: Availability,
}

/// Whether contexts have what is available there: they are of [`limits::VERSION`] with the compatibility profile and
/// every extension that the table names.
fn in_contexts(availability: &Availability) -> bool {
    let version = Version::new(limits::VERSION.0 as u8, limits::VERSION.1 as u8);
    availability.is_in(Api::Compatibility, version)
        || availability.extensions_of(Api::Compatibility).next().is_some()
}

impl InternalFormat {
    /// Whether textures may have it.
    pub fn is_for_textures(&self) -> bool {
        in_contexts(&self.texture)
    }

    /// Whether renderbuffers may have it.
    pub fn is_for_renderbuffers(&self) -> bool {
        in_contexts(&self.renderbuffer)
    }

    /// Whether buffer textures may have it.
    pub fn is_for_texel_buffers(&self) -> bool {
        in_contexts(&self.texel_buffer)
    }

    /// Whether texels are stored in blocks.
    pub fn is_compressed(&self) -> bool {
        match self.class {
            FormatClass::GeneralCompressed | FormatClass::SpecialCompressed => true,
            FormatClass::Unsized | FormatClass::Sized | FormatClass::GenericCompressed => false,
        }
    }

    /// Whether its name alone says what is stored, which immutable storage needs (`ARB_texture_storage`, section
    /// 3.8.X).
    pub fn is_sized(&self) -> bool {
        match self.class {
            FormatClass::Sized
            | FormatClass::GeneralCompressed
            | FormatClass::SpecialCompressed => true,
            FormatClass::Unsized | FormatClass::GenericCompressed => false,
        }
    }

    /// Whether images of it may have several samples a texel: what nothing is drawn to stays empty.
    pub fn is_for_multisampling(&self) -> bool {
        self.renderable != Renderable::No && self.class != FormatClass::GenericCompressed
    }
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

impl FormatSet {
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

/// The format that `GL_TEXTURE_INTERNAL_FORMAT` reports where this one was asked for (GL 2.1, section 3.8.1): itself, or
/// the base format of a generic compressed one.
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

/// GL's name of a stored format: that of the last row that is stored so.
pub(crate) fn format_name(stored: Format) -> String {
    let row = FORMATS.iter().rev().find(|format| format.stored == stored);
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
