//! Framebuffers: what is drawn to and read from (GL 2.1, chapter 4; framebuffer objects).

pub(crate) mod attach;
pub(crate) mod buffers;
pub(crate) mod clear;
pub(crate) mod complete;
pub(crate) mod read;

use crate::context::Context;
use buffers::Selection;
use rasterizer::driver::{Attachment, Image};
use texunit::format::Format;
use texunit::image::{Image as Texels, ImageError, Level, Shape};

/// A rectangle in a framebuffer or image, which may reach outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Region {
    pub x: i64,
    pub y: i64,
    pub width: usize,
    pub height: usize,
}

/// The part of a region that lies inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Visible {
    pub x: usize,
    pub y: usize,
    pub width: usize,
    pub height: usize,
}

impl Region {
    pub fn new(x: i32, y: i32, width: usize, height: usize) -> Self {
        Self { x: x.into(), y: y.into(), width, height }
    }

    /// The part inside an image of this size, if any.
    pub fn within(&self, width: u32, height: u32) -> Option<Visible> {
        let clip = |at: i64, size: usize, limit: u32| {
            let from = at.clamp(0, limit.into());
            let to = (at + size as i64).clamp(0, limit.into());
            (to > from).then_some((from as usize, (to - from) as usize))
        };
        let (x, width) = clip(self.x, self.width, width)?;
        let (y, height) = clip(self.y, self.height, height)?;
        Some(Visible { x, y, width, height })
    }
}

/// A new image of one level.
pub(crate) fn surface(format: Format, width: u32, height: u32) -> Result<Image, ImageError> {
    let mut texels = Texels::new(Shape::D2);
    texels.set_level(0, 0, Level::new(format, width, height)?)?;
    Ok(Image::new(texels))
}

/// The only face and level of a surface.
pub(crate) fn whole(image: &Image) -> Attachment {
    Attachment { image: image.clone(), face: 0, level: 0 }
}

/// The default framebuffer: one colour buffer, whatever it is called, and depth.
#[derive(Debug)]
pub(crate) struct Window {
    pub width: u32,
    pub height: u32,
    pub color: Image,
    pub depth: Image,
    pub selection: Selection,
    pub presence: Presence,
}

/// Whether there is a default framebuffer at all: a context can be current without one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Presence {
    Present,
    Absent,
}

/// The formats of a default framebuffer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Buffers {
    pub color: Format,
    pub depth: Format,
}

impl Buffers {
    /// Of a context that does not say.
    pub const DEFAULT: Self = Self { color: Format::Rgba8, depth: Format::D24 };
}

impl Window {
    pub fn new(width: u32, height: u32, buffers: Buffers) -> Result<Self, ImageError> {
        Ok(Self {
            width,
            height,
            color: surface(buffers.color, width, height)?,
            depth: surface(buffers.depth, width, height)?,
            selection: Selection::window(),
            presence: Presence::Present,
        })
    }

    /// What stands in where there is none: complete it is not.
    pub fn absent() -> Self {
        let empty = || Image::new(Texels::new(Shape::D2));
        Self {
            width: 0,
            height: 0,
            color: empty(),
            depth: empty(),
            selection: Selection::window(),
            presence: Presence::Absent,
        }
    }
}

impl Context {
    /// Puts another default framebuffer in place, with everything drawn to the one that was. Which
    /// of its buffers are drawn to and read from is the context's.
    pub(crate) fn swap_window(&mut self, mut window: Window) -> Window {
        self.flush();
        window.selection = self.window.selection.clone();
        std::mem::replace(&mut self.window, window)
    }

    /// Viewport and scissor take the size of the first default framebuffer (GL 2.1, sections 2.11.1
    /// and 4.1.2).
    pub(crate) fn first_window(&mut self, width: u32, height: u32) {
        let fresh = crate::state::State::new(width, height);
        self.state.viewport = fresh.viewport;
        self.state.fragment.scissor = fresh.fragment.scissor;
    }
}
