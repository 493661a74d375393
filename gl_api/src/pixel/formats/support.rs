//! Columns of the table of internal formats that several rows share: versions and extensions.

use super::row::{ComponentType, FormatClass, InternalFormat, Renderable};
use crate::base::availability::{Api, Availability, CoreVersions, Extension, Version};
use crate::base::types::GLenum;
use texunit::format::Format;

const COMPATIBILITY: &[Api] = &[Api::Compatibility];
const DESKTOP: &[Api] = &[Api::Compatibility, Api::Core];

const ES: &[Api] = &[Api::Es2];

const fn of(name: &'static str, apis: &'static [Api]) -> Extension {
    Extension { name, apis }
}

pub(super) const NONE: &[Extension] = &[];
pub(super) const ES2_COMPATIBILITY: &[Extension] = &[of("GL_ARB_ES2_compatibility", DESKTOP)];
pub(super) const TEXTURE_BUFFER_OBJECT_RGB32: &[Extension] =
    &[of("GL_ARB_texture_buffer_object_rgb32", DESKTOP)];
pub(super) const TEXTURE_COMPRESSION_3DC: &[Extension] =
    &[of("GL_ATI_texture_compression_3dc", COMPATIBILITY)];
pub(super) const TEXTURE_COMPRESSION_BPTC: &[Extension] =
    &[of("GL_ARB_texture_compression_bptc", DESKTOP), of("GL_EXT_texture_compression_bptc", ES)];
pub(super) const TEXTURE_COMPRESSION_LATC: &[Extension] =
    &[of("GL_EXT_texture_compression_latc", COMPATIBILITY)];
pub(super) const TEXTURE_COMPRESSION_RGTC: &[Extension] =
    &[of("GL_EXT_texture_compression_rgtc", ES)];
pub(super) const TEXTURE_COMPRESSION_S3TC: &[Extension] =
    &[of("GL_EXT_texture_compression_s3tc", &[Api::Compatibility, Api::Core, Api::Es2])];
pub(super) const TEXTURE_FLOAT: &[Extension] = &[of("GL_ARB_texture_float", COMPATIBILITY)];
pub(super) const TEXTURE_INTEGER: &[Extension] = &[of("GL_EXT_texture_integer", COMPATIBILITY)];
pub(super) const TEXTURE_RGB10_A2UI: &[Extension] = &[of("GL_ARB_texture_rgb10_a2ui", DESKTOP)];
pub(super) const TEXTURE_STENCIL8: &[Extension] = &[of("GL_ARB_texture_stencil8", DESKTOP)];
pub(super) const TEXTURE_SNORM: &[Extension] = &[of("GL_EXT_texture_snorm", COMPATIBILITY)];
pub(super) const TEXTURE_SRGB: &[Extension] = &[of("GL_EXT_texture_sRGB", DESKTOP)];

pub(super) const SRGB: &[Extension] = &[of("GL_EXT_sRGB", ES)];
pub(super) const COLOR_BUFFER_FLOAT: &[Extension] = &[of("GL_EXT_color_buffer_float", ES)];
pub(super) const COLOR_BUFFER_HALF_FLOAT: &[Extension] =
    &[of("GL_EXT_color_buffer_half_float", ES)];
pub(super) const REQUIRED_INTERNALFORMAT: &[Extension] =
    &[of("GL_OES_required_internalformat", ES)];
pub(super) const FLOAT_LINEAR: &[Extension] = &[of("GL_OES_texture_float_linear", ES)];

/// Which versions and extensions allow each use of a format.
pub(super) struct Support {
    texture: Availability,
    renderbuffer: Availability,
    filter: Availability,
    texel_buffer: Availability,
}

/// A version written without the point; `None` for 0.
const fn version(digits: u8) -> Option<Version> {
    match digits {
        0 => None,
        _ => Some(Version::new(digits / 10, digits % 10)),
    }
}

/// The later of a version and the first one of what a format needs besides: framebuffer objects, the core profile.
const fn later(a: u8, b: u8) -> u8 {
    if a > b { a } else { b }
}

const NEVER: Availability =
    Availability { compatibility: None, core: None, es1: None, es2: None, extensions: NONE };

/// In OpenGL from a version on.
const fn desktop(from: u8) -> Availability {
    let core = match version(later(from, 32)) {
        Some(from) => Some(CoreVersions { from, removed_in: None }),
        None => None,
    };
    Availability { compatibility: version(from), core, ..NEVER }
}

/// A format of both profiles of OpenGL, for textures from a version on.
pub(super) const fn core(from: u8) -> Support {
    Support {
        texture: desktop(from),
        renderbuffer: desktop(later(from, 30)),
        filter: desktop(from),
        texel_buffer: NEVER,
    }
}

/// A format that the core profile does not have.
pub(super) const fn compatibility(from: u8) -> Support {
    let mut support = core(from);
    support.texture.core = None;
    support.renderbuffer.core = None;
    support.filter.core = None;
    support
}

/// A format that no version has.
pub(super) const fn extension(extensions: &'static [Extension]) -> Support {
    let by_extension = Availability { extensions, ..NEVER };
    Support {
        texture: by_extension,
        renderbuffer: by_extension,
        filter: by_extension,
        texel_buffer: NEVER,
    }
}

impl Support {
    /// An extension adds it to earlier versions.
    pub const fn or(mut self, extensions: &'static [Extension]) -> Self {
        self.texture.extensions = extensions;
        self.renderbuffer.extensions = extensions;
        self.filter.extensions = extensions;
        self
    }

    /// The versions of OpenGL from which renderbuffers may have it, if textures may not have it then.
    pub const fn renderbuffers(mut self, from: u8) -> Self {
        self.renderbuffer = desktop(from);
        self
    }

    /// The versions of OpenGL ES from which textures and renderbuffers may have it, and it is filtered.
    pub const fn es(mut self, texture: u8, renderbuffer: u8, filter: u8) -> Self {
        if texture < 20 {
            self.texture.es1 = version(texture);
            self.filter.es1 = version(filter);
        }
        self.texture.es2 = version(later(texture, 20));
        self.renderbuffer.es2 = version(renderbuffer);
        self.filter.es2 = match filter {
            0 => None,
            _ => version(later(filter, 20)),
        };
        self
    }

    /// An extension of OpenGL ES adds it to textures, which are filtered.
    pub const fn in_textures(mut self, extensions: &'static [Extension]) -> Self {
        self.texture.extensions = extensions;
        self.filter.extensions = extensions;
        self
    }

    /// An extension of OpenGL ES draws to it.
    pub const fn drawn_to(mut self, extensions: &'static [Extension]) -> Self {
        self.renderbuffer.extensions = extensions;
        self
    }

    /// An extension of OpenGL ES filters it.
    pub const fn filtered(mut self, extensions: &'static [Extension]) -> Self {
        self.filter.extensions = extensions;
        self
    }

    /// The version of OpenGL from which buffer textures may have it; where OpenGL ES has the format, from 3.2 on.
    pub const fn texel_buffers(mut self, from: u8, extensions: &'static [Extension]) -> Self {
        self.texel_buffer = Availability { extensions, ..desktop(from) };
        if self.texture.core.is_none() {
            self.texel_buffer.core = None;
        }
        if self.texture.es2.is_some() {
            self.texel_buffer.es2 = version(32);
        }
        self
    }
}

/// A row: no compressed format is one of renderbuffers, and no integers are filtered.
pub(super) const fn row(
    name: GLenum,
    base: GLenum,
    stored: Format,
    components: ComponentType,
    class: FormatClass,
    renderable: Renderable,
    support: Support,
) -> InternalFormat {
    let Support { texture, renderbuffer, filter, texel_buffer } = support;
    let renderbuffer = match class {
        FormatClass::Sized | FormatClass::Unsized => renderbuffer,
        FormatClass::GenericCompressed
        | FormatClass::GeneralCompressed
        | FormatClass::SpecialCompressed => NEVER,
    };
    let filter = match components {
        ComponentType::Unorm | ComponentType::Snorm | ComponentType::Float => filter,
        ComponentType::Uint | ComponentType::Sint => NEVER,
    };
    InternalFormat {
        name,
        base,
        stored,
        components,
        class,
        renderable,
        texture,
        renderbuffer,
        filter,
        texel_buffer,
    }
}
