//! The default framebuffer (GL 2.1, chapter 4), and rectangles of pixels in framebuffers.
//!
//! EGL's surfaces and OSMesa's memory are default framebuffers that a context takes in place of its own; a context can
//! also be current without one ([`Presence::Absent`]).

use crate::context::depth_history::{DepthHistory, KnownStencil};
use crate::context::{Context, SurfaceDesc};
use crate::objects::color_buffers::Selection;
use crate::objects::framebuffers::{Accumulation, Planes};
use crate::state::State;
use rasterizer::driver::{Attachment, Image};
use texunit::format::Format;
use texunit::image::{Image as Texels, ImageError, Level, Shape};

/// A rectangle of pixels, which may reach outside of the framebuffer or image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Region {
    pub x: i64,
    pub y: i64,
    pub width: usize,
    pub height: usize,
}

/// The part of a [`Region`] that lies inside.
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
pub(crate) fn base_level_attachment(image: &Image) -> Attachment {
    Attachment::new(image.clone(), 0, 0)
}

/// The format of an attachment, if it exists.
pub(crate) fn format_of(attachment: &Attachment) -> Option<Format> {
    // Every face and slice of a level has the same.
    attachment.image.level(0, attachment.level.into()).map(|level| level.format)
}

/// A default framebuffer: one colour buffer, which stands for front and back, depth and stencil.
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
    /// Where its depths are from, for warnings.
    pub depths: DepthHistory,
    /// Its stencils, for warnings.
    pub stencils: KnownStencil,
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
            depths: DepthHistory::default(),
            stencils: KnownStencil::default(),
        })
    }

    /// How depth and stencil are stored.
    pub fn depth_format(&self) -> Option<Format> {
        self.depth.as_ref()?.level(0, 0).map(|level| level.format)
    }
}

/// Whether there is a default framebuffer at all: a context can be current without one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Presence {
    Present,
    Absent,
}

impl Window {
    /// The placeholder where there is none; it is not framebuffer complete.
    pub fn absent() -> Self {
        Self {
            width: 0,
            height: 0,
            format: Format::Rgba8,
            color: Image::new(Texels::new(Shape::D2)),
            depth: None,
            planes: Planes { depth: false, stencil: false },
            selection: Selection::window(),
            presence: Presence::Absent,
            accumulation: Accumulation::default(),
            depths: DepthHistory::default(),
            stencils: KnownStencil::default(),
        }
    }
}

impl Context {
    /// Replaces the default framebuffer; everything must have been submitted. Which buffers are drawn to and read from
    /// is state of the context, and stays.
    pub(crate) fn swap_window(&mut self, mut window: Window) -> Window {
        window.selection = self.window.selection.clone();
        std::mem::replace(&mut self.window, window)
    }

    /// The default framebuffer that is read from.
    pub(crate) fn read_window(&self) -> &Window {
        self.read_window.as_ref().unwrap_or(&self.window)
    }

    /// Replaces the default framebuffer that is read from; with `None` it is the one that is drawn to. Nothing that is
    /// recorded may read it.
    pub(crate) fn swap_read_window(&mut self, window: Option<Window>) -> Option<Window> {
        std::mem::replace(&mut self.read_window, window)
    }

    /// Sets viewport and scissor to the size of the first default framebuffer (GL 2.1, sections 2.11.1
    /// and 4.1.2).
    pub(crate) fn first_window(&mut self, width: u32, height: u32) {
        let fresh = State::new(width, height);
        self.state.viewport = fresh.viewport;
        self.state.fragment.scissor = fresh.fragment.scissor;
    }
}
