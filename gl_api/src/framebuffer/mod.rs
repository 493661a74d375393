//! Framebuffers: what is drawn to and read from (GL 2.1, chapter 4; framebuffer objects).

pub(crate) mod attach;
pub(crate) mod buffers;
pub(crate) mod clear;
pub(crate) mod complete;
pub(crate) mod read;

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
}

impl Window {
    pub fn new(width: u32, height: u32) -> Result<Self, ImageError> {
        Ok(Self {
            width,
            height,
            color: surface(Format::Rgba8, width, height)?,
            depth: surface(Format::D24, width, height)?,
            selection: Selection::window(),
        })
    }
}
