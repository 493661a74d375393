//! What is known of the results of filtered lookups, whatever their coordinates: shaders leave out by it what they would
//! compute of them.

use super::{Alpha, Anisotropy, LevelSelection, Texture};
use crate::format::{BaseFormat, Block, Encoding};
use crate::sampler::{Filter, Mipmap, Swizzle};

/// What is known of the results of filtered lookups.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LookupFacts {
    /// Of every component.
    pub components: ComponentsFact,
    /// Of the last one.
    pub alpha: AlphaFact,
}

/// What is known of every component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ComponentsFact {
    /// They are k/255, k from 0 to 255: of one texel each, or 0 or 1.
    Bytes,
    /// They are numbers from 0 to 1, and none is a negative zero.
    Fractions,
    /// Nothing.
    Any,
}

/// What is known of alpha. Alpha of integers is none of these numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AlphaFact {
    /// It is 1.
    One,
    /// Nothing.
    Any,
}

impl LookupFacts {
    /// Of incomplete textures: (0, 0, 0, 1).
    pub const OF_INCOMPLETE: Self =
        Self { components: ComponentsFact::Bytes, alpha: AlphaFact::One };
}

impl Texture {
    /// What is known of its lookups.
    pub fn lookup_facts(&self) -> LookupFacts {
        // Means of fractions are fractions; border colours are clamped as texels are.
        let components = match self.format.info().encoding {
            Encoding::Unorm | Encoding::Srgb | Encoding::SrgbBlock(_) => ComponentsFact::Fractions,
            Encoding::Block(
                Block::Dxt1 | Block::Dxt3 | Block::Dxt5 | Block::Rgtc1 | Block::Rgtc2 | Block::Bptc,
            ) => ComponentsFact::Fractions,
            Encoding::Block(
                Block::Rgtc1Snorm
                | Block::Rgtc2Snorm
                | Block::BptcUnsignedFloat
                | Block::BptcSignedFloat,
            )
            | Encoding::Snorm
            | Encoding::Float
            | Encoding::SharedExponent
            | Encoding::Uint
            | Encoding::Sint => ComponentsFact::Any,
        };
        let is_one_texel = match &self.level_selection {
            LevelSelection::Fixed { filter, .. } => *filter == Filter::Nearest,
            LevelSelection::PerLane { min, mag, range, anisotropy } => {
                [*min, *mag] == [Filter::Nearest; 2]
                    && range.mipmap != Mipmap::Linear
                    && *anisotropy == Anisotropy::Off
            }
        };
        let is_byte = is_one_texel
            && self.compare.is_none()
            && self.format.is_bytes()
            && !self.reaches_border(Filter::Nearest);
        let components = if is_byte { ComponentsFact::Bytes } else { components };
        let has_border = [Filter::Nearest, Filter::Linear].map(|by| self.reaches_border(by));
        let is_integer = match self.format.info().encoding {
            Encoding::Uint | Encoding::Sint => true,
            Encoding::Unorm
            | Encoding::Srgb
            | Encoding::SrgbBlock(_)
            | Encoding::Block(_)
            | Encoding::Snorm
            | Encoding::Float
            | Encoding::SharedExponent => false,
        };
        let is_one = self.alpha == Alpha::One
            && !is_integer
            && self.swizzle == Swizzle::IDENTITY
            && (self.format.base() == BaseFormat::Rgb || has_border == [false; 2]);
        LookupFacts { components, alpha: if is_one { AlphaFact::One } else { AlphaFact::Any } }
    }
}
