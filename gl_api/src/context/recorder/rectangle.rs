//! A rectangle of fragments whose colours or depths come from an image of the window's size, and
//! everything else from the current raster position; and the pixels of bitmaps, all of which does.
//!
//! The fragment stage is that of any other draw (GL 2.1, section 3.6.4: fragments are textured,
//! fogged and tested), with the primary colour read from the image instead of a varying.

use rasterizer::driver::{PixelMask, ShaderModule, Stipple};
use std::collections::HashMap;
use std::sync::Arc;
use texunit::plan::SamplePlan;

/// What the image holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Holds {
    /// The primary colour.
    Color,
    /// The depth, as red.
    Depth,
}

/// A fragment stage with an image in the place of its colour.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Key {
    pub module: ShaderModule,
    pub holds: Holds,
    /// The uniform words of the image's corner.
    pub word: u32,
}

/// What rectangles bring to a draw.
pub(crate) struct Rectangle {
    pub content: Content,
    /// Depth of the fragments, where an image has none.
    pub depth: f32,
}

/// What is in them.
pub(crate) enum Content {
    Image {
        holds: Holds,
        plan: Arc<SamplePlan>,
        /// The first pixel.
        origin: [i32; 2],
    },
    /// These pixels.
    Mask(Arc<PixelMask>),
}

impl Rectangle {
    /// Which pixels of it there are, if not all.
    pub fn stipple(&self) -> Option<Stipple> {
        match &self.content {
            Content::Image { .. } => None,
            Content::Mask(mask) => Some(Stipple::Mask(Arc::clone(mask))),
        }
    }
}

/// The modules that rectangles are drawn with.
#[derive(Debug, Default)]
pub(crate) struct RectangleModules {
    pub vertex: Option<ShaderModule>,
    pub fragment: HashMap<Key, ShaderModule>,
}
