//! The kernel of lanes that read from faces, layers and levels of their own: cube maps, arrays of planes and of cubes.
//!
//! A batch on one face whose lanes read the same levels is sampled as one of a two-dimensional texture
//! ([`super::uniform`]), if no footprint crosses an edge of the face.
//!
//! Another batch is sampled at once, and not once for each face and level: the size of its level and the place of its texels
//! are numbers of each lane, and gathers take each lane's bytes from a slice of its own ([`Sources`]). A footprint
//! across the edge of a face reads the texels beyond it from the face that touches it ([`edges`]), and all lanes of the
//! batch then take the four texels one by one.
//!
//! Same bits as [`super::general`]: the arithmetic of a lane is the same (a test holds this).

mod edges;
mod lane_level;
mod linear;
mod nearest;
#[cfg(test)]
mod tests;

use super::call::SampleCall;
use super::compare::unit_range;
use super::coordinates::Coordinates;
use super::fast::Addresses;
use super::footprint::IsotropicOnly;
use super::interpolate::mix;
use super::recorder::NoRecorder;
use super::scratch::{QuadScratch, SelectedLevels};
use super::uniform::{self, Outcome};
use super::uniform_levels::UniformLevels;
use super::{expand, level_taps};
use crate::image::{FACES, Shape};
use crate::kernels::LookupKernel;
use crate::lanes::{F32s, Kernel, LANES, Simd, Sources, U32s};
use crate::plan::{Anisotropy, LevelSelection, TexelClass, Texture};
use crate::sampler::Filter;
use lane_level::LaneLevel;

/// One call: 64 samples of a texture with texels of this class.
pub(super) struct ScatteredCall<'s, 'a, F> {
    pub sample: &'s mut SampleCall<'a, NoRecorder, F>,
    pub class: TexelClass,
    pub quads: &'s mut QuadScratch,
}

impl<F> Kernel for ScatteredCall<'_, '_, F> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { sample, class, quads } = self;
        let texture = sample.texture;
        let mut at = Coordinates::in_plane(*sample.coords);
        at.locate(texture, sample.layer, &mut NoRecorder);
        let [s, t, _] = at.filtered();
        let (mut levels, mut weight) = ([U32s::ZERO; 2], F32s::ZERO);
        let (filter, common) =
            select_levels::<S, F>(texture, &at, sample, &mut levels, &mut weight);
        if let (Some(levels), Some(face)) = (common, common_face::<S>(texture, &at)) {
            let levels = UniformLevels { filter, face, levels };
            let one_face = OneFace { sample, class, levels, at: [s, t], weight: &weight, quads };
            if S::outlined(one_face) == Outcome::Sampled {
                LookupKernel::ScatteredOneFace.note();
                return;
            }
        }
        let reference = match texture.compare {
            Some(_) => unit_range(sample.reference.unwrap_or(sample.coords[2])),
            None => F32s::ZERO,
        };
        let is_mixed = S::any(weight.as_u32());
        let mut sources = Sources::empty();
        let read = [&levels[0], &levels[usize::from(is_mixed)]];
        set_sources::<S>(texture, read, &mut sources);
        // Initialized only where there is a second level.
        let mut second = None;
        for (index, level) in levels.iter().enumerate().take(1 + usize::from(is_mixed)) {
            let out = match index {
                0 => &mut *sample.out,
                _ => second.get_or_insert([F32s::ZERO; 4]),
            };
            let level = LaneLevel::new(texture, level, at.face(), &at.layer);
            let lanes = ScatteredLevel {
                texture,
                class,
                sources: &sources,
                level: &level,
                at: [s, t],
                reference: &reference,
            };
            // Outlined, so that the code size of one does not add to the other.
            match filter {
                Filter::Nearest => {
                    LookupKernel::ScatteredNearest.note();
                    S::outlined(nearest::Nearest { lanes: &lanes, out });
                }
                Filter::Linear => {
                    LookupKernel::ScatteredLinear.note();
                    S::outlined(linear::Linear { lanes: &lanes, out });
                }
            }
        }
        if let Some(second) = &second {
            LookupKernel::ScatteredTwoLevels.note();
            let channels = texture.format.channels();
            for (out, second) in sample.out.iter_mut().zip(second).take(channels) {
                let first = *out;
                mix(&first, second, &weight, out);
            }
        }
        expand::expand(texture.format, texture.depth_mode, sample.out);
        expand::swizzle(texture.format, texture.swizzle, sample.out);
    }
}

/// The face that all lanes read, if it is one of a cube.
#[inline(always)]
fn common_face<S: Simd>(texture: &Texture, at: &Coordinates<'_>) -> Option<u32> {
    let faces = at.face();
    let mut different = U32s::ZERO;
    for lane in 0..LANES {
        different[lane] = faces[lane] ^ faces[0];
    }
    (texture.shape == Shape::Cube && !S::any(&different)).then_some(faces[0])
}

/// The lookup in a batch on one face.
struct OneFace<'s, 'a, 'c, F> {
    sample: &'s mut SampleCall<'a, NoRecorder, F>,
    class: TexelClass,
    levels: UniformLevels,
    /// s and t.
    at: [&'c F32s; 2],
    weight: &'c F32s,
    quads: &'s mut QuadScratch,
}

impl<F> Kernel for OneFace<'_, '_, '_, F> {
    type Output = Outcome;

    #[inline(always)]
    fn run<S: Simd>(self) -> Outcome {
        let Self { sample, class, levels, at: [s, t], weight, quads } = self;
        let (levels, addresses) = (Some(levels), Addresses::Compute);
        let selected = SelectedLevels { levels, weight, addresses };
        uniform::sample_uniform::<S, F>(sample, [s, t, t], class, selected, quads)
    }
}

/// A level of each lane, and what all its texels share.
struct ScatteredLevel<'a> {
    texture: &'a Texture,
    class: TexelClass,
    sources: &'a Sources<'a>,
    level: &'a LaneLevel<'a>,
    /// s and t.
    at: [&'a F32s; 2],
    /// The reference of a depth compare.
    reference: &'a F32s,
}

/// The filter, and the levels that all lanes read, if all read the same; sets the levels of each lane, and the weight of
/// the second.
///
/// Magnification and minification have the same filter, so up to λ = 0 the level is 0 in any case.
#[inline(always)]
fn select_levels<S: Simd, F>(
    texture: &Texture,
    at: &Coordinates<'_>,
    sample: &SampleCall<'_, NoRecorder, F>,
    levels: &mut [U32s; 2],
    weight: &mut F32s,
) -> (Filter, Option<[u32; 2]>) {
    match &texture.level_selection {
        LevelSelection::Fixed { filter, level, .. } => {
            *levels = [U32s::splat(*level), U32s::splat(*level)];
            (*filter, Some([*level; 2]))
        }
        LevelSelection::PerLane { min, range, .. } => {
            let (off, recorder) = (Anisotropy::Off, &mut NoRecorder);
            let (base, _, bias) = level_taps::base_lambda::<S, IsotropicOnly>(
                texture,
                at,
                *sample.lod,
                off,
                recorder,
            );
            (*levels, *weight) = range.levels(&range.lambda(&base, bias));
            (*min, level_taps::common_levels::<S>(levels, weight))
        }
    }
}

/// Sets the faces of the levels that lanes read.
#[inline(always)]
fn set_sources<'a, S: Simd>(texture: &'a Texture, levels: [&U32s; 2], sources: &mut Sources<'a>) {
    let (first, last) = (S::smallest(levels[0]) as usize, S::largest(levels[1]) as usize);
    for (face, levels) in texture.levels.iter().enumerate() {
        for (number, level) in levels.iter().enumerate().take(last + 1).skip(first) {
            sources.set(number * FACES + face, &level.texels);
        }
    }
}
