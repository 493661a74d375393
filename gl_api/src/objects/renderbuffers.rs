//! Renderbuffer objects: `ARB_framebuffer_object`, section 4.4.2.

use crate::base::constants::*;
use crate::base::error::Table;
use crate::base::types::*;
use crate::objects::egl_images::Siblings;
use crate::objects::framebuffers::Planes;
use crate::pixel::formats;
use crate::pixel::formats::{InternalFormat, Renderable};
use rasterizer::driver::{Image, LevelInfo};
use texunit::image::{Image as Texels, Shape};

/// The only target of renderbuffers.
pub(crate) const RENDERBUFFER_TARGET: Table<()> =
    Table { section: "ARB_framebuffer_object, section 4.4.2", rows: &[(GL_RENDERBUFFER, ())] };

/// What resolves the samples of a renderbuffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Resolving {
    /// `glBlitFramebuffer` alone.
    ByBlit,
    /// Whatever reads it (`EXT_multisampled_render_to_texture`).
    WhereItIsRead,
}

/// A renderbuffer object.
#[derive(Clone, Debug)]
pub(crate) struct Renderbuffer {
    /// The internal format that was asked for.
    pub format: &'static InternalFormat,
    /// One level, once there is a size.
    pub image: Image,
    pub resolving: Resolving,
    /// The EGL images that have its storage too.
    pub siblings: Siblings,
}

impl Renderbuffer {
    /// One without storage, that says it has an internal format.
    pub(crate) fn new(internal: GLenum) -> Self {
        let format = formats::find(internal).expect("a row of the table");
        let image = Image::new(Texels::new(Shape::D2));
        Self { format, image, resolving: Resolving::ByBlit, siblings: Siblings::default() }
    }

    pub(crate) fn level(&self) -> Option<LevelInfo> {
        self.image.level(0, 0)
    }

    /// Which of depth and stencil can be used: stencil formats are stored beside a depth.
    pub fn planes(&self) -> Planes {
        Planes { depth: self.format.renderable != Renderable::Stencil, stencil: true }
    }
}
