//! The levels that all lanes of a batch read, where they read the same.

use super::coordinates::Coordinates;
use super::footprint::RoundOnly;
use super::level_taps;
use super::level_view::LevelView;
use super::lookup::Lod;
use super::recorder::NoRecorder;
use crate::lanes::{F32s, Simd, U32s};
use crate::plan::{LevelSelection, Texture};
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
pub fn select<S: Simd>(
    texture: &Texture,
    coords: &[&F32s; 3],
    lod: &Lod<'_>,
    weight: &mut F32s,
) -> Option<Read> {
    match &texture.level_selection {
        LevelSelection::Fixed { filter, level, .. } => {
            Some(Read { filter: *filter, levels: [*level, *level] })
        }
        LevelSelection::PerLane { min, range, anisotropy, .. } => {
            let (at, off) = (Coordinates::in_plane(*coords), &mut NoRecorder);
            let (base, _, bias) =
                level_taps::base_lambda::<S, RoundOnly>(texture, &at, *lod, *anisotropy, off);
            let each;
            (each, *weight) = range.levels(&range.lambda(&base, bias));
            let levels = level_taps::common_levels::<S>(&each, weight)?;
            Some(Read { filter: *min, levels })
        }
    }
}

/// A level of a texture in a plane.
#[inline(always)]
pub fn plane_view(texture: &Texture, filter: Filter, number: u32) -> LevelView<'_> {
    LevelView {
        texture,
        filter,
        face: 0,
        number: number as usize,
        level: &texture.levels[0][number as usize],
        layer: &U32s::ZERO,
        reference: &F32s::ZERO,
    }
}
