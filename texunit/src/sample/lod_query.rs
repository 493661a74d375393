//! The level of detail of a lookup, without the lookup (`textureQueryLOD`, ARB_texture_query_lod).

use super::coordinates::Coordinates;
use super::footprint::AllFootprints;
use super::level_taps::base_lambda;
use super::lookup::Lod;
use super::recorder::NoRecorder;
use crate::lanes::{F32s, Kernel, LANES, Simd};
use crate::plan::{Anisotropy, LevelSelection, LodRange, Texture};
use crate::sampler::Mipmap;

/// One call: 64 levels of detail.
pub(crate) struct Query<'a> {
    pub texture: &'a Texture,
    pub coords: [&'a F32s; 3],
    pub lod: Lod<'a>,
    /// The level that is read, a fraction between two; and λ before it is held in the sampler's
    /// range.
    pub out: &'a mut [F32s; 2],
}

impl Kernel for Query<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { texture, coords, lod, out } = self;
        let mut at = Coordinates::in_plane(coords);
        at.locate(texture, None, &mut NoRecorder);
        let (range, anisotropy) = match &texture.level_selection {
            LevelSelection::PerLane { range, anisotropy, .. } => (*range, *anisotropy),
            // Only the bias has an effect.
            LevelSelection::Fixed { bias, .. } => (
                LodRange {
                    bias: *bias,
                    min: 0.0,
                    max: 0.0,
                    magnified_to: 0.0,
                    mipmap: Mipmap::None,
                    last: 0,
                },
                Anisotropy::Off,
            ),
        };
        let (base, _, bias) =
            base_lambda::<S, AllFootprints>(texture, &at, lod, anisotropy, &mut NoRecorder);
        let free = LodRange { min: f32::NEG_INFINITY, max: f32::INFINITY, ..range };
        out[1] = free.lambda(&base, bias);
        let lambda = range.lambda(&base, bias);
        let (levels, weight) = range.levels(&lambda);
        for lane in 0..LANES {
            let minified = lambda[lane] > range.magnified_to;
            out[0][lane] = if minified { levels[0][lane] as f32 + weight[lane] } else { 0.0 };
        }
    }
}
