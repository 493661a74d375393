//! The shortest way: a texture in a plane whose texels have a short way ([`super::plain`]) and whose two
//! filters are alike, of which all lanes read the same level, or the same two. Most batches of most draws are so.
//!
//! A kernel of its own, so that these do not carry the stack and the branches of probes, faces, layers
//! and lanes that read different levels. Every number is computed by the functions of the general way.

use super::compare::compare;
use super::footprint::Round;
use super::plain::{Class, Places};
use super::record::Off;
use super::{Coordinates, Sample, expand, filter, plain, take, taps, unit_range};
use crate::image::Shape;
use crate::lanes::{F32s, Kernel, Simd, U32s};
use crate::plan::{Detail, Lod, Texture, Way};
use crate::sampler::Filter;

/// One call: 64 samples of a texture that goes this way, of texels of this class.
pub(crate) struct Flat<'s, 'a, F> {
    pub sample: &'s mut Sample<'a, Off, F>,
    pub class: Class,
    pub places: Places,
    pub squares: &'s mut take::Squares,
    pub detail: &'s mut take::Found,
}

/// What became of a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    Sampled,
    /// Lanes read different levels, or texels that have no short way: nothing is done.
    NotFlat,
}

/// The class of the texels, where the image and its texels go this way.
pub(crate) fn class(shape: Shape, way: Way) -> Option<Class> {
    match (shape, way) {
        (Shape::D2 | Shape::Rect, Way::Plain(class) | Way::Compared(class)) => Some(class),
        (Shape::D2 | Shape::Rect, Way::General | Way::Blocks(_))
        | (
            Shape::D1
            | Shape::D3
            | Shape::Cube
            | Shape::D1Array
            | Shape::D2Array
            | Shape::CubeArray,
            _,
        ) => None,
    }
}

/// What all lanes of a batch read: what their level of detail comes to.
#[derive(Clone, Copy, Debug)]
pub struct Read {
    pub(crate) filter: Filter,
    /// Twice the same where no lane reads another.
    pub(crate) levels: [u32; 2],
}

/// Which levels all lanes read; `None` where they read different ones. Where they read two, `weight` takes that of
/// the second.
#[inline(always)]
pub fn read<S: Simd>(
    texture: &Texture,
    coords: &[&F32s; 3],
    lod: &Lod<'_>,
    weight: &mut F32s,
) -> Option<Read> {
    match &texture.detail {
        Detail::Fixed { filter, level, .. } => {
            Some(Read { filter: *filter, levels: [*level, *level] })
        }
        Detail::PerLane { min, range, anisotropy, .. } => {
            let (at, off) = (Coordinates::in_plane(*coords), &mut Off);
            let (base, _, bias) =
                taps::base_lambda::<S, Round>(texture, &at, *lod, *anisotropy, off);
            let each;
            (each, *weight) = range.levels(&range.lambda(&base, bias));
            let levels = taps::same_levels::<S>(&each, weight)?;
            Some(Read { filter: *min, levels })
        }
    }
}

/// A level of a texture in a plane.
#[inline(always)]
pub fn place(texture: &Texture, filter: Filter, number: u32) -> filter::Place<'_> {
    filter::Place {
        texture,
        filter,
        face: 0,
        number: number as usize,
        level: &texture.levels[0][number as usize],
        layer: &U32s::ZERO,
        reference: &F32s::ZERO,
    }
}

impl<F> Kernel for Flat<'_, '_, F> {
    type Output = Outcome;

    #[inline(always)]
    fn run<S: Simd>(self) -> Outcome {
        let Self { sample, class, places, squares, detail } = self;
        let texture = sample.texture;
        let take::Found { read: found, weight } = detail;
        if places == Places::Own {
            *found = read::<S>(texture, sample.coords, sample.lod, weight);
        }
        let Some(Read { filter, levels }) = *found else { return Outcome::NotFlat };
        if texture.gives_words && filter == Filter::Linear {
            let spread = take::Spread(&mut *sample.out);
            let known = take::Known { read: *found, weight, places };
            let taken = take::take::<S, _>(texture, *sample.coords, known, squares, spread);
            return if taken.is_ok() { Outcome::Sampled } else { Outcome::NotFlat };
        }
        // Takes no time where there is no second level.
        let mut second = None;
        let reads_both = levels[0] != levels[1];
        for (turn, number) in levels.into_iter().take(1 + usize::from(reads_both)).enumerate() {
            let place = place(texture, filter, number);
            let out = match turn {
                0 => &mut *sample.out,
                _ => second.get_or_insert([F32s::ZERO; 4]),
            };
            let is_done = match filter {
                Filter::Nearest => plain::nearest::<S>(&place, class, *sample.coords, out),
                Filter::Linear => plain::linear::<S>(&place, class, *sample.coords, out),
            };
            if !is_done {
                return Outcome::NotFlat;
            }
            // Each texel by itself, which is why there is only one a lane.
            if let Some(op) = texture.compare {
                let reference = unit_range(sample.reference.unwrap_or(sample.coords[2]));
                compare(op, &reference, &mut out[0]);
            }
        }
        if let Some(second) = &second {
            let channels = texture.format.channels();
            for (out, second) in sample.out.iter_mut().zip(second).take(channels) {
                let first = *out;
                filter::mix(&first, second, weight, out);
            }
        }
        expand::expand(texture.format, texture.depth_mode, sample.out);
        expand::swizzle(texture.format, texture.swizzle, sample.out);
        Outcome::Sampled
    }
}
