//! One decision per draw: how this image is sampled with this sampler.

use crate::format::Format;
use crate::image::{Image, Incomplete, Level, Shape};
use crate::lanes::{F32s, Isa};
use crate::sample::Sample;
use crate::sample::lod::LodRange;
use crate::sampler::{Compare, DepthMode, Filter, Mipmap, Sampler, Wrap};
use std::sync::Arc;

/// Where the level of detail of a batch comes from.
#[derive(Clone, Copy, Debug)]
pub enum Lod<'a> {
    /// From the differences within each quad of the batch (quad-planar lane order), plus a bias.
    Implicit {
        /// Per lane, added to λ before the clamp.
        bias: Option<&'a F32s>,
    },
    /// This λ, to which the sampler's bias is added.
    Explicit(&'a F32s),
    /// From these derivatives of s, t, r.
    Gradient {
        /// `∂(s, t, r)/∂x`.
        dx: [&'a F32s; 3],
        /// `∂(s, t, r)/∂y`.
        dy: [&'a F32s; 3],
    },
}

/// An image and a sampler, with every decision taken. Keeps the levels it reaches alive.
#[derive(Clone, Debug)]
pub struct SamplePlan(Result<Texture, Incomplete>);

/// A complete image with its sampler, as the kernels read it.
#[derive(Clone, Debug)]
pub(crate) struct Texture {
    pub shape: Shape,
    pub format: Format,
    /// Width and height of the base level.
    pub size: [u32; 2],
    /// `levels[face][level]`, levels counted from the base level; those that are reached.
    pub levels: Vec<Vec<Arc<Level>>>,
    /// Wrap of s and t.
    pub wrap: [Wrap; 2],
    /// The border colour as stored channels.
    pub border: [f32; 4],
    /// Set only where texels are depths.
    pub compare: Option<Compare>,
    pub depth_mode: DepthMode,
    pub detail: Detail,
}

/// How lanes come to their filter and level.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Detail {
    /// Every lane alike: λ decides nothing.
    Fixed {
        filter: Filter,
        level: u32,
        /// Why λ is not computed.
        why: &'static str,
    },
    /// λ decides.
    PerLane { min: Filter, mag: Filter, range: LodRange },
}

impl SamplePlan {
    /// Decides. An incomplete image gives a plan that returns (0, 0, 0, 1) everywhere (GL 2.1,
    /// section 3.8.10); ask the image for the reason.
    pub fn new(image: &Image, sampler: &Sampler) -> Self {
        Self(Texture::new(image, sampler))
    }

    /// Why the image cannot be sampled, if it cannot.
    pub fn incomplete(&self) -> Option<&Incomplete> {
        self.0.as_ref().err()
    }

    /// Whether λ is computed. Where it is not, the derivatives of coordinates do not matter.
    pub fn needs_lod(&self) -> bool {
        match &self.0 {
            Ok(texture) => matches!(texture.detail, Detail::PerLane { .. }),
            Err(_) => false,
        }
    }

    /// The decisions in one line.
    pub fn describe(&self) -> String {
        match &self.0 {
            Ok(texture) => texture.describe(),
            Err(reason) => format!("incomplete, every sample is (0, 0, 0, 1): {reason}"),
        }
    }

    /// Samples 64 lanes. `coords` are s, t, r (those the shape has are read); `reference` is
    /// compared when the plan compares, and is r where there is none. Any bits are legal
    /// coordinates in any lane: NaN counts as 0.
    pub fn sample(
        &self,
        isa: Isa,
        coords: [&F32s; 3],
        reference: Option<&F32s>,
        lod: Lod<'_>,
        out: &mut [F32s; 4],
    ) {
        match &self.0 {
            Ok(texture) => isa.run(Sample { texture, coords, reference, lod, out }),
            Err(_) => *out = [F32s::ZERO, F32s::ZERO, F32s::ZERO, F32s::splat(1.0)],
        }
    }
}

impl Texture {
    fn new(image: &Image, sampler: &Sampler) -> Result<Self, Incomplete> {
        let reached = image.completeness(sampler)?;
        let detail = Detail::new(sampler, reached.last - reached.base);
        let levels: Vec<Vec<Arc<Level>>> = (0..image.shape().faces())
            .map(|face| {
                (reached.base..=reached.base + detail.last_level())
                    .filter_map(|level| image.level(face, level as usize).cloned())
                    .collect()
            })
            .collect();
        let base = &levels[0][0];
        let (format, size) = (base.format, [base.width, base.height]);
        let mut border = [0.0; 4];
        for (to, &from) in border.iter_mut().zip(format.base().sources()) {
            *to = sampler.border[from];
        }
        Ok(Self {
            shape: image.shape(),
            format,
            size,
            levels,
            wrap: [sampler.wrap[0], sampler.wrap[1]],
            border,
            compare: if format.is_depth() { sampler.compare } else { None },
            depth_mode: sampler.depth_mode,
            detail,
        })
    }

    /// Whether a sample with this filter can mix in the border colour.
    #[inline(always)]
    pub fn reaches_border(&self, filter: Filter) -> bool {
        self.wrap[0].reaches_border(filter) || self.wrap[1].reaches_border(filter)
    }

    /// Whether texels of this channel are linear bytes that are neither compared nor mixed with
    /// the border.
    #[inline(always)]
    pub fn is_plain_byte(&self, filter: Filter, channel: usize) -> bool {
        self.format.is_byte_channel(channel) && !self.reaches_border(filter)
    }

    fn describe(&self) -> String {
        let Self { shape, format, size: [width, height], wrap: [s, t], .. } = self;
        let mut line = format!("{shape:?} {format:?} {width}x{height}, wrap {s:?} {t:?}");
        if let Some(op) = self.compare {
            line += &format!(", depth compare {op:?} before the filter");
        }
        match &self.detail {
            Detail::Fixed { filter, level, why } => {
                line += &format!(", {filter:?} of level {level} (from the base), no LOD: {why}");
            }
            Detail::PerLane { min, mag, range } => {
                let LodRange { mipmap, last, magnified_to, .. } = range;
                line += &format!(
                    ", min {min:?} mipmap {mipmap:?} of levels 0 to {last} (from the base), \
                     mag {mag:?} up to lambda {magnified_to}, LOD per lane"
                );
            }
        }
        line
    }
}

impl Detail {
    /// Decides whether λ is needed at all. `last` counts from the base level.
    fn new(sampler: &Sampler, last: u32) -> Self {
        let Sampler { min, mipmap, mag, .. } = *sampler;
        // GL 2.1, section 3.8.9: the switch-over to magnification.
        let magnified_to = match (mag, min, mipmap) {
            (Filter::Linear, Filter::Nearest, Mipmap::Nearest | Mipmap::Linear) => 0.5,
            (Filter::Linear, Filter::Nearest, Mipmap::None)
            | (Filter::Linear, Filter::Linear, _)
            | (Filter::Nearest, _, _) => 0.0,
        };
        let fixed = |filter, why| Self::Fixed { filter, level: 0, why };
        if sampler.max_lod <= magnified_to {
            return fixed(mag, "the largest LOD never leaves magnification");
        }
        if min == mag {
            match mipmap {
                Mipmap::None => return fixed(mag, "both filters are alike and without mipmaps"),
                Mipmap::Nearest | Mipmap::Linear if last == 0 => {
                    return fixed(mag, "both filters are alike and there is one level");
                }
                Mipmap::Nearest | Mipmap::Linear => {}
            }
        }
        let mut range = LodRange {
            bias: sampler.lod_bias,
            min: sampler.min_lod,
            max: sampler.max_lod,
            magnified_to,
            mipmap,
            last,
        };
        // No λ is above `max`, so no level above that one's is read.
        let ([first, second], _) = range.levels(&F32s::splat(range.max));
        range.last = first[0].max(second[0]);
        Self::PerLane { min, mag, range }
    }

    /// The last level that is read, counted from the base level.
    fn last_level(&self) -> u32 {
        match self {
            Self::Fixed { level, .. } => *level,
            Self::PerLane { range, .. } => range.last,
        }
    }
}
