//! Of what numbers a pixel is made, and where they lie.

use crate::pixel::client::format::{ClientFormat, LuminanceOf, Numbers};
use crate::pixel::layout::Layout;
use crate::pixel::texel;
use rasterizer::driver::SrgbWrite;
use texunit::format::Format;
use texunit::pixel::PixelLayout;

/// What the four numbers of a pixel are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Components {
    Client(ClientFormat),
    Texel(Format),
}

impl Components {
    /// The numbers as R, G, B, A.
    pub fn rgba<T: Copy>(self, numbers: [T; 4], zero: T, one: T) -> [T; 4] {
        match self {
            Self::Client(format) => format.expand(numbers, zero, one),
            Self::Texel(format) => texel::rgba(format, numbers, zero, one),
        }
    }

    /// The numbers of R, G, B, A.
    pub fn numbers<T: Copy>(self, rgba: [T; 4], zero: T, luminance: T) -> [T; 4] {
        match self {
            Self::Client(format) => format.select(rgba, zero, luminance),
            Self::Texel(format) => texel::channels(format, rgba),
        }
    }
}

/// A pixel of the source or destination of a conversion: its components and their memory layout.
pub(super) struct PixelRecord {
    pub components: Components,
    pub layout: PixelLayout,
}

impl PixelRecord {
    pub fn client(layout: &Layout, numbers: Numbers) -> Self {
        let pixel = layout.pixel;
        let record = pixel.ty.record(pixel.format.components(), numbers, layout.order.in_memory());
        Self { components: Components::Client(pixel.format), layout: record }
    }

    pub fn texel(format: Format) -> Self {
        Self { components: Components::Texel(format), layout: PixelLayout::of(format) }
    }

    /// The stencils of texels.
    pub fn stencil(format: Format) -> Self {
        Self {
            components: Components::Client(ClientFormat::Stencil),
            layout: PixelLayout::of_stencil(format),
        }
    }

    /// Colours as they are copied: sRGB as light where it is written so.
    pub fn color(format: Format, srgb: SrgbWrite) -> Self {
        let record = match srgb {
            SrgbWrite::AsIs => PixelLayout::of(format),
            SrgbWrite::Encode => PixelLayout::of_light(format),
        };
        Self { components: Components::Texel(format), layout: record }
    }

    /// Whether a luminance is made of R, G and B.
    pub fn is_sum(&self, luminance: LuminanceOf) -> bool {
        match self.components {
            Components::Client(ClientFormat::Luminance | ClientFormat::LuminanceAlpha) => {
                luminance == LuminanceOf::Sum
            }
            Components::Client(_) | Components::Texel(_) => false,
        }
    }
}
