//! Framebuffers: what is drawn to and read from (GL 2.1, chapter 4; framebuffer objects).

use crate::context::SurfaceDesc;
pub(crate) use crate::context::presence::Presence;
use crate::context::recorder::depths::Depths;
use crate::objects::accumulation::Accumulation;
use crate::objects::color_buffers::Selection;
use crate::objects::framebuffers::Planes;
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

/// The texels of an image of one level.
pub(crate) fn texels(format: Format, width: u32, height: u32) -> Result<Texels, ImageError> {
    let mut texels = Texels::new(Shape::D2);
    texels.set_level(0, 0, Level::new(format, width, height)?)?;
    Ok(texels)
}

/// The only face and level of a surface.
pub(crate) fn whole(image: &Image) -> Attachment {
    Attachment { image: image.clone(), face: 0, level: 0 }
}

/// The format of an attachment, if it exists.
pub(crate) fn format_of(attachment: &Attachment) -> Option<Format> {
    // Every face and slice of a level has the same.
    attachment.image.level(0, attachment.level.into()).map(|level| level.format)
}

/// The default framebuffer: one colour buffer, whatever it is called, depth and stencil.
#[derive(Debug)]
pub(crate) struct Window {
    pub width: u32,
    pub height: u32,
    pub format: Format,
    pub color: Image,
    pub depth: Option<Image>,
    /// Which planes of `depth` there are.
    pub planes: Planes,
    pub selection: Selection,
    pub presence: Presence,
    pub accumulation: Accumulation,
    /// What warnings of its depths go by.
    pub depths: Depths,
}

impl Window {
    pub fn new(width: u32, height: u32, desc: SurfaceDesc) -> Result<Self, ImageError> {
        let image = |format| Image::blank(format, width, height, desc.samples.max(1));
        let format = desc.color.format();
        Ok(Self {
            width,
            height,
            format,
            color: image(format)?,
            depth: desc.depth_format().map(image).transpose()?,
            planes: Planes { depth: desc.depth_bits > 0, stencil: desc.stencil_bits > 0 },
            selection: Selection::window(),
            presence: Presence::Present,
            accumulation: Accumulation::default(),
            depths: Depths::default(),
        })
    }

    /// How depth and stencil are stored.
    pub fn depth_format(&self) -> Option<Format> {
        self.depth.as_ref()?.level(0, 0).map(|level| level.format)
    }
}
