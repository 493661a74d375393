//! The levels that a batch reads, where all lanes read the same.

use super::coordinates::Coordinates;
use super::footprint::IsotropicOnly;
use super::level_taps;
use super::level_view::LevelView;
use super::lookup::Lod;
use super::recorder::NoRecorder;
use crate::lanes::{F32s, Simd, U32s};
use crate::plan::{LevelSelection, Texture};
use crate::sampler::Filter;

/// The filter and the levels that all lanes of a batch read.
#[derive(Clone, Copy, Debug)]
pub struct UniformLevels {
    pub(crate) filter: Filter,
    /// The two levels that are mixed; twice the same where there is one.
    pub(crate) levels: [u32; 2],
}

/// The levels that all lanes read; `None` where lanes read different ones. `weight` gets the weight of the second level.
#[inline(always)]
pub fn select<S: Simd>(
    texture: &Texture,
    coords: &[&F32s; 3],
    lod: &Lod<'_>,
    weight: &mut F32s,
) -> Option<UniformLevels> {
    match &texture.level_selection {
        LevelSelection::Fixed { filter, level, .. } => {
            Some(UniformLevels { filter: *filter, levels: [*level, *level] })
        }
        LevelSelection::PerLane { min, range, anisotropy, .. } => {
            let (at, recorder) = (Coordinates::in_plane(*coords), &mut NoRecorder);
            let (base, _, bias) = level_taps::base_lambda::<S, IsotropicOnly>(
                texture,
                &at,
                *lod,
                *anisotropy,
                recorder,
            );
            let each;
            (each, *weight) = range.levels(&range.lambda(&base, bias));
            let levels = level_taps::common_levels::<S>(&each, weight)?;
            Some(UniformLevels { filter: *min, levels })
        }
    }
}

/// A level of a two-dimensional texture.
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
