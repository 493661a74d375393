//! A context's default framebuffer can be another one, or none: EGL's surfaces, OSMesa's memory.

use crate::context::recorder::depths::Depths;
use crate::context::window::Window;
use crate::objects::accumulation::Accumulation;
use crate::objects::color_buffers::Selection;
use crate::objects::framebuffers::Planes;
use rasterizer::driver::Image;
use texunit::format::Format;
use texunit::image::{Image as Texels, Shape};

/// Whether there is a default framebuffer at all: a context can be current without one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Presence {
    Present,
    Absent,
}

impl Window {
    /// What stands in where there is none; it is not complete.
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
            depths: Depths::default(),
        }
    }
}
