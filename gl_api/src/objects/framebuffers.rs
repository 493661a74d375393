//! Framebuffer objects: names and bindings (`ARB_framebuffer_object`, section 4.4.1).

use crate::base::constants::*;
use crate::base::error::Table;
use crate::base::limits;
use crate::base::types::*;
use crate::objects::color_buffers::Selection;
use crate::objects::target::FaceTarget;
use rasterizer::driver::Image;

const SECTION: &str = "ARB_framebuffer_object, section 4.4.1";

/// What is attached to a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    /// A slice of a level of a texture.
    Texture {
        name: GLuint,
        target: FaceTarget,
        level: usize,
        slice: u16,
    },
    Renderbuffer(GLuint),
}

/// An attached image. It outlives the name that it had when it was attached
/// (`ARB_framebuffer_object`, section 4.4.2.2).
#[derive(Clone, Debug)]
pub(crate) struct Attached {
    pub source: Source,
    pub image: Image,
    /// Which planes of it can be drawn to.
    pub planes: Planes,
}

impl Attached {
    /// Whether both are the same slice of the same image.
    pub fn same(&self, other: &Self) -> bool {
        self.source == other.source && self.image.same(&other.image)
    }
}

/// What of depth and stencil there is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Planes {
    pub depth: bool,
    pub stencil: bool,
}

/// A framebuffer object.
#[derive(Clone, Debug)]
pub(crate) struct Framebuffer {
    pub colors: [Option<Attached>; limits::MAX_COLOR_ATTACHMENTS],
    pub depth: Option<Attached>,
    pub stencil: Option<Attached>,
    pub selection: Selection,
}

impl Framebuffer {
    pub(crate) fn new() -> Self {
        Self {
            colors: [const { None }; limits::MAX_COLOR_ATTACHMENTS],
            depth: None,
            stencil: None,
            selection: Selection::object(),
        }
    }

    /// Every attachment point.
    pub fn points_mut(&mut self) -> impl Iterator<Item = &mut Option<Attached>> {
        self.colors.iter_mut().chain([&mut self.depth, &mut self.stencil])
    }

    /// Everything that is attached.
    pub fn attached(&self) -> impl Iterator<Item = &Attached> {
        self.colors.iter().chain([&self.depth, &self.stencil]).flatten()
    }
}

/// Which binding a call works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Binding {
    Draw,
    Read,
    Both,
}

pub(crate) const FRAMEBUFFER_TARGET: Table<Binding> = Table {
    section: SECTION,
    rows: &[
        (GL_FRAMEBUFFER, Binding::Both),
        (GL_DRAW_FRAMEBUFFER, Binding::Draw),
        (GL_READ_FRAMEBUFFER, Binding::Read),
    ],
};
