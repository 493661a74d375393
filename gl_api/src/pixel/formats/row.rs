//! A row of the table of internal formats.

use crate::base::availability::{Api, Availability};
use crate::base::constants::*;
use crate::base::es_extensions::EXTENSIONS_OF_ES;
use crate::base::types::*;
use crate::base::version;
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
#[non_exhaustive]
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

/// Whether contexts have what is available there: they are of [`version::IMPLEMENTED`] with the compatibility profile and
/// every extension that the table names.
fn in_contexts(availability: &Availability) -> bool {
    availability.is_in(Api::Compatibility, version::IMPLEMENTED)
        || availability.extensions_of(Api::Compatibility).next().is_some()
}

/// Whether contexts of OpenGL ES have what is available there.
fn in_es(availability: &Availability) -> bool {
    availability.is_in(Api::Es2, version::IMPLEMENTED_ES)
        || availability.extensions_of(Api::Es2).any(|name| EXTENSIONS_OF_ES.contains(&name))
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

    /// Whether textures of OpenGL ES may have it.
    pub fn is_for_textures_in_es(&self) -> bool {
        in_es(&self.texture)
    }

    /// Whether contexts of OpenGL ES draw to images of it; of unsized ones, to textures (section 4.4.4).
    pub fn is_drawn_to_in_es(&self) -> bool {
        let by_row = in_es(&self.renderbuffer);
        by_row || self.class == FormatClass::Unsized && self.is_color()
    }

    /// Whether renderbuffers of OpenGL ES may have it.
    pub fn is_for_renderbuffers_in_es(&self) -> bool {
        in_es(&self.renderbuffer)
    }

    /// Whether linear filters of OpenGL ES take it.
    pub fn is_filtered_in_es(&self) -> bool {
        in_es(&self.filter)
    }

    /// Whether it has red, as formats that unsized textures are drawn to with have.
    fn is_color(&self) -> bool {
        matches!(self.base, GL_RED | GL_RG | GL_RGB | GL_RGBA)
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
