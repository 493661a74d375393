//! What a rectangle of pixels brings to a draw, and the shader modules that rectangles were drawn with;
//! `draw/pixel_rectangle.rs` draws them.

use rasterizer::driver::{PixelMask, ShaderModule, Stipple};
use std::collections::HashMap;
use std::sync::Arc;
use texunit::plan::SamplePlan;

/// Which value of fragments the image replaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum ReplacedValue {
    /// The primary colour.
    Color,
    /// The depth, as red.
    Depth,
}

/// What a fragment stage that reads an image is made from.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Key {
    pub module: ShaderModule,
    pub replaces: ReplacedValue,
    /// The first of the two uniform words with the image's corner.
    pub word: u32,
}

/// A rectangle of pixels, besides its corners.
pub(crate) struct PixelRectangle {
    pub content: RectangleContent,
    /// Depth of the fragments, where an image has none.
    pub depth: f32,
    pub samples: RectangleSamples,
}

/// The samples that are drawn to. Zoomed pixels may cover some samples of a pixel and not others (GL 2.1, section 3.6.6).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RectangleSamples {
    All,
    /// The one with this number.
    One(u8),
}

impl RectangleSamples {
    /// Those that are left of a sample mask.
    pub fn masked(self, mask: u32) -> u32 {
        match self {
            Self::All => mask,
            Self::One(sample) => mask & 1 << sample,
        }
    }
}

/// Where the fragments of a rectangle come from.
pub(crate) enum RectangleContent {
    Image {
        replaces: ReplacedValue,
        plan: Arc<SamplePlan>,
        /// The pixel of the framebuffer where it begins.
        origin: [i32; 2],
    },
    /// A fragment for each pixel of the mask.
    Mask(Arc<PixelMask>),
}

impl PixelRectangle {
    /// Which pixels of it there are, if not all.
    pub fn stipple(&self) -> Option<Stipple> {
        match &self.content {
            RectangleContent::Image { .. } => None,
            RectangleContent::Mask(mask) => Some(Stipple::Mask(Arc::clone(mask))),
        }
    }
}

/// The modules that rectangles are drawn with.
#[derive(Debug, Default)]
pub(crate) struct PixelRectangleModules {
    pub vertex: Option<ShaderModule>,
    pub fragment: HashMap<Key, ShaderModule>,
}
