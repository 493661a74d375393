//! The levels that all lanes of a batch read, where they read the same.

use super::coordinates::Coordinates;
use super::footprint::Round;
use super::level_taps;
use super::level_view::Place;
use super::lookup::Lod;
use super::recorder::Off;
use crate::lanes::{F32s, Simd, U32s};
use crate::plan::{Detail, Texture};
use crate::sampler::Filter;

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
                level_taps::base_lambda::<S, Round>(texture, &at, *lod, *anisotropy, off);
            let each;
            (each, *weight) = range.levels(&range.lambda(&base, bias));
            let levels = level_taps::same_levels::<S>(&each, weight)?;
            Some(Read { filter: *min, levels })
        }
    }
}

/// A level of a texture in a plane.
#[inline(always)]
pub fn place(texture: &Texture, filter: Filter, number: u32) -> Place<'_> {
    Place {
        texture,
        filter,
        face: 0,
        number: number as usize,
        level: &texture.levels[0][number as usize],
        layer: &U32s::ZERO,
        reference: &F32s::ZERO,
    }
}
