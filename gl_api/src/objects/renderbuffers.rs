//! Renderbuffers: `ARB_framebuffer_object`, section 4.4.2.

use crate::base::constants::*;
use crate::base::types::*;
use crate::objects::framebuffers::Planes;
use crate::pixel::internal::STENCIL_FORMAT;
use rasterizer::driver::{Image, LevelInfo};
use texunit::image::{Image as Texels, Shape};

/// A renderbuffer object.
#[derive(Clone, Debug)]
pub(crate) struct Renderbuffer {
    pub requested: GLenum,
    /// One level, once there is a size.
    pub image: Image,
}

impl Renderbuffer {
    pub(crate) fn new() -> Self {
        Self { requested: GL_RGBA, image: Image::new(Texels::new(Shape::D2)) }
    }

    pub(crate) fn level(&self) -> Option<LevelInfo> {
        self.image.level(0, 0)
    }

    /// Which of depth and stencil it shows.
    pub fn planes(&self) -> Planes {
        Planes { depth: STENCIL_FORMAT.get(self.requested).is_none(), stencil: true }
    }
}
