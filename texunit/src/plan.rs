//! One decision per draw: how this image is sampled with this sampler.

mod describe;
mod prepare;
mod row;

use crate::format::{Block, Format};
use crate::image::{FACES, Image, Incomplete, Level, Shape};
use crate::lanes::{F32s, I32s, Isa, LANES, Simd};
pub use crate::sample::ahead::Like;
pub use crate::sample::flat::Read;
use crate::sample::gather::Gather;
use crate::sample::lod::LodRange;
use crate::sample::plain::Class;
pub use crate::sample::plain::Places;
use crate::sample::query::Query;
pub use crate::sample::take::{Known, Room, Take, Texels};
use crate::sample::texel::Fetch;
use crate::sample::{Off, Probed, Sample, Scanned};
use crate::sample::{ahead, flat, take};
use crate::sampler::{Compare, DepthMode, Filter, Sampler, Seamless, Swizzle, Wrap};
use prepare::wrap_of;
use std::marker::PhantomData;
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
    /// From these derivatives of s, t, r, plus a bias.
    Gradient {
        /// `∂(s, t, r)/∂x`.
        dx: [&'a F32s; 3],
        /// `∂(s, t, r)/∂y`.
        dy: [&'a F32s; 3],
        /// As of [`Lod::Implicit`].
        bias: Option<&'a F32s>,
    },
}

/// Where 64 lanes look a texture up. Any bits are legal in any lane: NaN counts as 0.
#[derive(Clone, Copy, Debug)]
pub struct Points<'a> {
    /// s, t, r, of which those that the shape has are read: the one after those that are filtered
    /// along is the layer of an array.
    pub coords: [&'a F32s; 3],
    /// The layer of an array of cubes, whose coordinates are a direction; layer 0 where there is
    /// none.
    pub layer: Option<&'a F32s>,
    /// What is compared when the plan compares; r where there is none.
    pub reference: Option<&'a F32s>,
}

/// An image and a sampler, with every decision taken. Keeps the levels it reaches alive.
#[derive(Clone, Debug)]
pub struct SamplePlan(Result<Texture, Incomplete>);

/// A complete image with its sampler, as the kernels read it.
#[derive(Clone, Debug)]
pub(crate) struct Texture {
    pub shape: Shape,
    pub format: Format,
    /// Width, height and depth (layers) of the base level.
    pub size: [u32; 3],
    /// Texels of the base level per unit of s, t, r.
    pub scale: [f32; 3],
    /// `levels[face][level]`, levels counted from the base level: those that a filter reaches,
    /// and those that fit them, which only a fetch reads. In an array of cubes, all faces are
    /// slices of the same levels.
    pub levels: Vec<Vec<Arc<Level>>>,
    /// Wrap of s, t, r.
    pub wrap: [Wrap; 3],
    /// Only ever on for cubes.
    pub seamless: Seamless,
    /// The border colour as stored channels.
    pub border: [f32; 4],
    /// Set only where texels are depths.
    pub compare: Option<Compare>,
    pub depth_mode: DepthMode,
    pub swizzle: [Swizzle; 4],
    pub way: Way,
    pub detail: Detail,
    pub kernel: SampleKernel,
    pub alpha: Alpha,
    /// Whether texels may go to who looks them up as words of bytes: red, green, blue and, if any, alpha.
    pub gives_words: bool,
}

/// What there is to alpha.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Alpha {
    /// It is a channel like others, or made of them.
    Read,
    /// It is 1 in every texel that a filter reaches: means of it need not be computed.
    One,
}

/// Which kernel samples. Where several can, they give the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SampleKernel {
    /// Of most textures: in a plane, one filter, texels of a class that has a short way.
    Flat(Class),
    /// Of any whose footprints are not read row by row.
    Probed,
    /// Of those whose are, where a lookup has a footprint.
    Scanned,
}

impl SampleKernel {
    fn new(shape: Shape, way: Way, detail: &Detail) -> Self {
        let (anisotropy, min, mag) = match detail {
            Detail::Fixed { filter, .. } => (Anisotropy::Off, filter, filter),
            Detail::PerLane { anisotropy, min, mag, .. } => (*anisotropy, min, mag),
        };
        let suit = match way {
            Way::Compared(_) => (min, mag) == (&Filter::Nearest, &Filter::Nearest),
            Way::General | Way::Plain(_) | Way::Blocks(_) => min == mag,
        };
        match (anisotropy, flat::class(shape, way)) {
            (Anisotropy::Off, Some(class)) if suit => Self::Flat(class),
            (Anisotropy::Off | Anisotropy::Probes(_), _) => Self::Probed,
            (Anisotropy::Scan(_), _) => Self::Scanned,
        }
    }
}

/// Which kernels read texels. All give the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// Any texture.
    General,
    /// Two-dimensional, not compared, of a class of texels that is worth loops of its own.
    Plain(Class),
    /// The same of compressed texels.
    Blocks(Block),
    /// Depths in a plane that are compared, of such a class: short where a filter takes one texel.
    Compared(Class),
}

impl Way {
    fn new(shape: Shape, format: Format, compare: Option<Compare>) -> Self {
        let short = match shape {
            Shape::D2 | Shape::Rect => true,
            Shape::Cube => compare.is_none(),
            Shape::D1 | Shape::D3 | Shape::D1Array | Shape::D2Array | Shape::CubeArray => false,
        };
        match (short, format.block(), Class::of(format), compare) {
            (true, Some(block), _, None) => Self::Blocks(block),
            (true, None, Some(class), None) => Self::Plain(class),
            (true, None, Some(class), Some(_)) => Self::Compared(class),
            (true, Some(_), _, Some(_)) | (true, None, None, _) | (false, _, _, _) => Self::General,
        }
    }
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
        /// The sampler's bias, for who asks for λ all the same.
        bias: f32,
    },
    /// λ decides.
    PerLane { min: Filter, mag: Filter, range: LodRange, anisotropy: Anisotropy },
}

/// How footprints that are longer than wide are filtered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anisotropy {
    /// As wide as they are long.
    Off,
    /// In so many samples along the major axis at most.
    Probes(u32),
    /// Row by row, up to this ratio of the axes.
    Scan(u32),
}

impl Anisotropy {
    /// `most` is the largest ratio of the axes.
    fn new(shape: Shape, sampler: &Sampler, most: u32) -> Self {
        let in_rows = |wrap: Wrap| match wrap_of(shape, sampler.seamless, wrap) {
            Wrap::Repeat | Wrap::MirroredRepeat | Wrap::ClampToEdge => true,
            Wrap::Clamp
            | Wrap::ClampToBorder
            | Wrap::MirrorClamp
            | Wrap::MirrorClampToEdge
            | Wrap::MirrorClampToBorder => false,
        };
        let filters = [sampler.min, sampler.mag] == [Filter::Linear; 2];
        match shape {
            _ if most == 1 => Self::Off,
            Shape::D2 | Shape::Rect
                if filters && in_rows(sampler.wrap[0]) && in_rows(sampler.wrap[1]) =>
            {
                Self::Scan(most)
            }
            // A line has no minor axis.
            Shape::D1 | Shape::D1Array => Self::Off,
            Shape::D2
            | Shape::D3
            | Shape::Rect
            | Shape::Cube
            | Shape::D2Array
            | Shape::CubeArray => Self::Probes(most),
        }
    }
}

impl SamplePlan {
    /// Decides. An incomplete image gives a plan that returns (0, 0, 0, 1) everywhere (GL 2.1,
    /// section 3.8.10); ask the image for the reason.
    pub fn new(image: &Image, sampler: &Sampler) -> Self {
        Self(Texture::new(image, sampler))
    }

    /// The same plan with alpha left out, where it is 1 in every texel; else, and where it is left out already, none.
    /// Reads all texels to know, which a second draw makes up for.
    pub fn without_alpha(&self) -> Option<Self> {
        let texture = self.texture().filter(|texture| texture.has_alpha_to_leave_out())?;
        Some(Self(Ok(Texture { alpha: Alpha::One, ..texture.clone() })))
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

    /// Whether [`Self::take`] may be asked: the image is complete, and what it gives is not compared.
    pub fn gives_colors(&self) -> bool {
        self.0.as_ref().is_ok_and(|texture| texture.compare.is_none())
    }

    /// The decisions in one line.
    pub fn describe(&self) -> String {
        match &self.0 {
            Ok(texture) => texture.describe(),
            Err(reason) => format!("incomplete, every sample is (0, 0, 0, 1): {reason}"),
        }
    }

    /// Samples 64 lanes at these [`Points`], those of an array of cubes in its first. Components of
    /// integer formats are bits, not numbers.
    pub fn sample(
        &self,
        isa: Isa,
        coords: [&F32s; 3],
        reference: Option<&F32s>,
        lod: Lod<'_>,
        out: &mut [F32s; 4],
    ) {
        let mut room = Room::default();
        let points = Points { coords, layer: None, reference };
        self.sample_offset(isa, points, [0; 3], lod, Places::Own, &mut room);
        *out = room.lanes;
    }

    /// [`SamplePlan::sample`] with texels added along s, t, r on each level that is read
    /// (`textureOffset`, GLSL 1.30, section 8.7), into the lanes of `room`. λ does not depend on them. With
    /// [`Places::Kept`] what the lookup before found in this room is not looked for again.
    #[inline(always)]
    pub fn sample_offset(
        &self,
        isa: Isa,
        points: Points<'_>,
        offset: [i32; 3],
        lod: Lod<'_>,
        places: Places,
        room: &mut Room,
    ) {
        let Room { lanes: out, squares, detail } = room;
        match &self.0 {
            Ok(texture) => {
                let (recorder, reads) = (&mut Off, PhantomData::<Probed>);
                let Points { coords, layer, reference } = points;
                let (coords, lod) = (&coords, &lod);
                let sample =
                    Sample { texture, coords, layer, reference, offset, lod, out, recorder, reads };
                // Kernels of their own: none pays for another's size.
                match (texture.kernel, lod) {
                    (SampleKernel::Flat(class), _) if offset == [0; 3] => {
                        sample.run_flat(isa, class, places, (squares, detail));
                    }
                    (SampleKernel::Scanned, Lod::Implicit { .. } | Lod::Gradient { .. }) => {
                        sample.reading::<Scanned>().run_on(isa);
                    }
                    // With a level that is told, the footprint is not looked at.
                    (SampleKernel::Scanned, Lod::Explicit(_))
                    | (SampleKernel::Flat(_) | SampleKernel::Probed, _) => sample.run_on(isa),
                }
            }
            Err(_) => *out = OPAQUE_BLACK,
        }
    }

    /// Asks for the texels that [`SamplePlan::take`] will read around these points (s and t), as part of a kernel.
    /// `like` is of one of the batches that the points are of.
    #[inline(always)]
    pub fn ask<S: Simd>(&self, points: [&F32s; 2], like: Like<'_>) {
        if let Ok(texture) = &self.0
            && S::WIDE
            && texture.gives_words
        {
            ahead::ask::<S>(texture, points, like);
        }
    }

    /// Whether a lookup reads the same levels at the same places as one of `other` with the same points, offset and
    /// level of detail does: whether [`Places::Kept`] can be asked for.
    pub fn reads_like(&self, other: &Self) -> bool {
        let (Ok(one), Ok(other)) = (&self.0, &other.0) else { return false };
        let of = |level: &Arc<Level>| (level.size(), level.border, level.format.bytes());
        let [levels, others] = [one, other].map(|texture| texture.levels[0].iter().map(of));
        one.gives_words
            && other.gives_words
            && (one.shape, one.wrap) == (other.shape, other.wrap)
            && one.detail == other.detail
            && levels.eq(others)
    }

    /// Whether what [`SamplePlan::read`] gives is all that [`SamplePlan::take`] needs of the level of detail, where
    /// all lanes read the same.
    pub fn takes_by_reading(&self, isa: Isa) -> bool {
        let takes = |texture: &Texture| texture.gives_words && take::always_leads(texture);
        isa.is_wide() && self.0.as_ref().is_ok_and(takes)
    }

    /// What all lanes of a batch with these coordinates read, for [`SamplePlan::take`], as part of a kernel; `None`
    /// where they read different levels. Where they read two, `weight` takes that of the second.
    #[inline(always)]
    pub fn read<S: Simd>(
        &self,
        coords: [&F32s; 3],
        lod: &Lod<'_>,
        weight: &mut F32s,
    ) -> Option<Read> {
        match &self.0 {
            Ok(texture) if S::WIDE && texture.gives_words => {
                flat::read::<S>(texture, &coords, lod, weight)
            }
            Ok(_) | Err(_) => None,
        }
    }

    /// [`SamplePlan::sample`] as part of a kernel, of images that are not compared. What it gives goes to `take`
    /// without a detour, where texels are bytes and all lanes read the same level, or the same two; else by way
    /// of lanes. What is `known` is what [`SamplePlan::read`] gave, of this batch or of one that reads the same.
    #[inline(always)]
    pub fn take<S: Simd, T: Take>(
        &self,
        isa: Isa,
        coords: [&F32s; 3],
        lod: Lod<'_>,
        known: Known<'_>,
        room: &mut Room,
        take: T,
    ) -> T::Output {
        let take = match &self.0 {
            Ok(texture) if S::WIDE && texture.gives_words => {
                let squares = &mut room.squares;
                match take::take::<S, T>(texture, coords, known, squares, take) {
                    Ok(output) => return output,
                    Err(take) => take,
                }
            }
            Ok(_) | Err(_) => take,
        };
        // By the same kernels that shaders call: another copy of them would be a megabyte.
        let points = Points { coords, layer: None, reference: None };
        self.sample_offset(isa, points, [0; 3], lod, Places::Own, room);
        take.take::<S>(&take::Lanes(&room.lanes))
    }

    /// The first component of the texels at (i, j + 1), (i + 1, j + 1), (i + 1, j) and (i, j) that a linear filter of the
    /// base level would weigh (`textureGather`). Of two axes; an incomplete image has zeros.
    pub fn gather(&self, isa: Isa, points: Points<'_>, offset: [i32; 2], out: &mut [F32s; 4]) {
        match &self.0 {
            Ok(texture) => isa.run(Gather { texture, points, offset, out }),
            Err(_) => *out = [F32s::ZERO; 4],
        }
    }

    /// What level of detail a lookup with these coordinates has (`textureQueryLOD`): the level that
    /// it reads, counted from the base level, with a fraction where it mixes two; and λ with every
    /// bias before it is held in the sampler's range. An incomplete image has zeros.
    pub fn query_lod(&self, isa: Isa, coords: [&F32s; 3], lod: Lod<'_>, out: &mut [F32s; 2]) {
        match &self.0 {
            Ok(texture) => isa.run(Query { texture, coords, lod, out }),
            Err(_) => *out = [F32s::ZERO; 2],
        }
    }

    /// Single texels by column, row and slice (of an array: layer, after the coordinates that are
    /// filtered along), of a level counted from the base level (`texelFetch`). No filter, no wrap,
    /// no compare. A texel or level that is not there gives 0 in all components, and so do the
    /// border's texels.
    pub fn fetch(
        &self,
        isa: Isa,
        texel: [&I32s; 3],
        level: &I32s,
        offset: [i32; 3],
        out: &mut [F32s; 4],
    ) {
        match &self.0 {
            Ok(texture) => isa.run(Fetch { texture, texel, level, offset, out }),
            Err(_) => *out = OPAQUE_BLACK,
        }
    }

    /// Width, height and depth of a level counted from the base level (`textureSize`); the number
    /// of layers comes after the sizes of what is filtered along. 0 where there is no such level.
    pub fn size(&self, level: &I32s) -> [I32s; 3] {
        let mut out = [I32s::ZERO; 3];
        let Ok(texture) = &self.0 else { return out };
        for lane in 0..LANES {
            let found = usize::try_from(level[lane]).ok().and_then(|n| texture.levels[0].get(n));
            let Some(found) = found else { continue };
            let mut size = found.size();
            size[2] = layers(texture.shape, size);
            if texture.shape == Shape::D1Array {
                size.swap(1, 2);
            }
            for (out, side) in out.iter_mut().zip(size) {
                out[lane] = side as i32;
            }
        }
        out
    }
}

/// What an incomplete texture gives (GL 2.1, section 3.11.2).
const OPAQUE_BLACK: [F32s; 4] = [F32s::ZERO, F32s::ZERO, F32s::ZERO, F32s::splat(1.0)];

impl SamplePlan {
    /// The same plan without its quicker kernels.
    pub(crate) fn general(&self) -> Self {
        let way = Way::General;
        Self(self.0.clone().map(|texture| {
            let kernel = SampleKernel::new(texture.shape, way, &texture.detail);
            Texture { way, kernel, alpha: Alpha::Read, gives_words: false, ..texture }
        }))
    }

    /// What the kernels read, if the image is complete.
    pub(crate) fn texture(&self) -> Option<&Texture> {
        self.0.as_ref().ok()
    }
}

impl Texture {
    /// Whether a sample with this filter can mix in the border colour.
    #[inline(always)]
    pub fn reaches_border(&self, filter: Filter) -> bool {
        let axes = self.shape.axes();
        self.seamless == Seamless::Off
            && (self.wrap[0].reaches_border(filter)
                || (axes > 1 && self.wrap[1].reaches_border(filter))
                || (axes > 2 && self.wrap[2].reaches_border(filter)))
    }

    /// Whether one coordinate is a layer.
    #[inline(always)]
    pub fn is_array(&self) -> bool {
        matches!(self.shape, Shape::D1Array | Shape::D2Array | Shape::CubeArray)
    }

    /// How many layers a lookup chooses from.
    #[inline(always)]
    pub fn layers(&self) -> u32 {
        layers(self.shape, self.size)
    }
}

/// The layers of an image of this size: of an array of cubes, the cubes.
#[inline(always)]
fn layers(shape: Shape, size: [u32; 3]) -> u32 {
    if shape == Shape::CubeArray { size[2] / FACES as u32 } else { size[2] }
}
