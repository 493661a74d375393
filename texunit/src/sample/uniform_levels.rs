//! The levels that a batch reads, where all lanes read the same.

use super::coordinates::Coordinates;
use super::derivatives::rho_squared_of;
use super::footprint::IsotropicOnly;
use super::level_taps;
use super::level_view::LevelView;
use super::lookup::Lod;
use super::recorder::NoRecorder;
use super::row_scan::{self, LaneFootprint};
use crate::lanes::{F32s, LANES, Simd, U32s, log2_of_root};
use crate::plan::{Anisotropy, LevelSelection, Texture};
use crate::sampler::Filter;

/// The filter and the levels that all lanes of a batch read.
#[derive(Clone, Copy, Debug)]
pub struct UniformLevels {
    pub(crate) filter: Filter,
    /// Of a cube, the face.
    pub(crate) face: u32,
    /// The two levels that are mixed; twice the same where there is one.
    pub(crate) levels: [u32; 2],
}

/// The levels that all lanes read; `None` where lanes read different ones, or footprints are not round. `weight`
/// gets the weight of the second level.
#[inline(always)]
pub fn select<S: Simd>(
    texture: &Texture,
    coords: &[&F32s; 3],
    lod: &Lod<'_>,
    weight: &mut F32s,
) -> Option<UniformLevels> {
    let (min, mag, range, anisotropy) = match &texture.level_selection {
        LevelSelection::Fixed { filter, level, .. } => {
            return Some(UniformLevels { filter: *filter, face: 0, levels: [*level; 2] });
        }
        LevelSelection::PerLane { min, mag, range, anisotropy } => (*min, *mag, range, *anisotropy),
    };
    let magnified = UniformLevels { filter: mag, face: 0, levels: [0; 2] };
    if let Some([u, v]) = common_derivatives::<S>(texture, lod) {
        let (base, footprint) = match anisotropy {
            Anisotropy::Scan(most) => {
                let most = most as f32;
                let footprint = LaneFootprint::new(u, v, 1.0 / (most * most));
                (footprint.lambda, Some(footprint))
            }
            Anisotropy::Off | Anisotropy::Probes(_) => (log2_of_root(rho_squared_of(u, v)), None),
        };
        let lambda = range.lambda_of(base);
        // With one filter, level 0 is what minified lanes read up to this λ.
        if min != mag && !range.is_minified(lambda) {
            return Some(magnified);
        }
        let (mut levels, part) = range.levels_of(lambda);
        if part > 0.0 {
            *weight = F32s::splat(part);
        } else {
            levels[1] = levels[0];
        }
        if let Some(of) = footprint {
            let is_round = |number| row_scan::is_round(&plane_view(texture, min, number), &of);
            if !levels.into_iter().all(is_round) {
                return None;
            }
        }
        return Some(UniformLevels { filter: min, face: 0, levels });
    }
    match anisotropy {
        Anisotropy::Scan(_) => None,
        Anisotropy::Off | Anisotropy::Probes(_) => {
            let (at, recorder) = (Coordinates::in_plane(*coords), &mut NoRecorder);
            let (base, _, bias) = level_taps::base_lambda::<S, IsotropicOnly>(
                texture, &at, *lod, anisotropy, recorder,
            );
            let lambda = range.lambda(&base, bias);
            if min != mag {
                let mut minified = U32s::ZERO;
                for lane in 0..LANES {
                    minified[lane] = if range.is_minified(lambda[lane]) { !0 } else { 0 };
                }
                if !S::any(&minified) {
                    return Some(magnified);
                }
                let mut is_mixed = U32s::ZERO;
                for lane in 0..LANES {
                    is_mixed[lane] = minified[lane] ^ minified[0];
                }
                if S::any(&is_mixed) {
                    return None;
                }
            }
            let each;
            (each, *weight) = range.levels(&lambda);
            let levels = level_taps::common_levels::<S>(&each, weight)?;
            Some(UniformLevels { filter: min, face: 0, levels })
        }
    }
}

/// The derivatives of u and of v along x and y in texels, if they are given and the same in all lanes, as those of an
/// affine map are, and the lookup has no bias of its own: the footprint of one lane is that of all.
#[inline(always)]
fn common_derivatives<S: Simd>(texture: &Texture, lod: &Lod<'_>) -> Option<[[f32; 2]; 2]> {
    let Lod::Gradient { dx, dy, bias: None } = lod else { return None };
    let mut different = U32s::ZERO;
    for given in [dx[0], dy[0], dx[1], dy[1]] {
        let bits = given.as_u32();
        for lane in 0..LANES {
            different[lane] |= bits[lane] ^ bits[0];
        }
    }
    if S::any(&different) {
        return None;
    }
    let scale = texture.scale;
    Some([0, 1].map(|axis| [dx[axis][0] * scale[axis], dy[axis][0] * scale[axis]]))
}

/// A level of a two-dimensional texture.
#[inline(always)]
pub fn plane_view(texture: &Texture, filter: Filter, number: u32) -> LevelView<'_> {
    face_view(texture, filter, 0, number)
}

/// A level of a face of a cube; face 0 is that of a two-dimensional texture.
#[inline(always)]
pub fn face_view(texture: &Texture, filter: Filter, face: u32, number: u32) -> LevelView<'_> {
    LevelView {
        texture,
        filter,
        face: face as usize,
        number: number as usize,
        level: &texture.levels[face as usize][number as usize],
        layer: &U32s::ZERO,
        reference: &F32s::ZERO,
    }
}
