//! The sampler types and the lookups that they allow (GLSL 1.30 section 8.7, and the extensions that
//! [`textures`](super::textures) lists).

use crate::language::{Availability, EsVersions, Extension};
use crate::types::{Comparison, Dim};

const GPU_SHADER4: Availability = Availability::extension(Extension::GpuShader4);

/// Which sources of the level of detail the lookups of a sampler type take.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum LodSupport {
    /// The quad.
    Implicit,
    /// The quad or derivatives.
    Derived,
    /// The quad, with or without a bias, or derivatives.
    Biased,
    /// Every source.
    All,
}

/// A sampler type, for each type of texel, and what its lookups take.
pub struct SamplerRow {
    /// The shape of its textures.
    pub dim: Dim,
    /// Whether it compares.
    pub comparison: Comparison,
    /// Components of the coordinates, with the layer and the reference; the fifth is an argument of
    /// its own.
    pub coords: u8,
    /// Components of the coordinates of projections, with the divisor.
    pub projected: &'static [u8],
    /// Components of a derivative.
    pub gradient: u8,
    /// Components of an offset; 0 if there is none.
    pub offset: u8,
    /// Components of a size.
    pub size: u8,
    /// The sources of the level of detail.
    pub lod_support: LodSupport,
    /// Of the functions that have the sampler type in their names: how the names begin, and the
    /// availability of those that `EXT_gpu_shader4` has not added.
    pub prefixed: Option<(&'static str, Availability)>,
    /// The availability of the overloads of `texture`.
    pub overloaded: Availability,
}

/// The table: sampler; components of coordinates and of projections; components of gradient, offset
/// and size; sources of the level of detail; names before 1.30.
pub const SAMPLERS: [SamplerRow; 15] = {
    use Comparison::{No, Yes};
    use Dim::{Cube, CubeArray, D1, D1Array, D2, D2Array, D3, Rect};
    use LodSupport::{All, Biased, Derived, Implicit};
    const fn row(
        (dim, comparison): (Dim, Comparison),
        coords: u8,
        projected: &'static [u8],
        [gradient, offset, size]: [u8; 3],
        lod_support: LodSupport,
        prefixed: (&'static str, Availability),
    ) -> SamplerRow {
        let es = match dim {
            D2 | D3 | Cube | D2Array => EsVersions::From300,
            D1
            | D1Array
            | Rect
            | CubeArray
            | Dim::D2Multisample
            | Dim::D2MultisampleArray
            | Dim::Buffer
            | Dim::External => EsVersions::None,
        };
        let (prefixed, overloaded) = (Some(prefixed), Availability::V130.and_es(es));
        SamplerRow {
            dim,
            comparison,
            coords,
            projected,
            gradient,
            offset,
            size,
            lod_support,
            prefixed,
            overloaded,
        }
    }
    /// Arrays of cubes, which have only the overloads.
    const fn cubes(comparison: Comparison, coords: u8, lod_support: LodSupport) -> SamplerRow {
        let (dim, projected, prefixed) = (CubeArray, &[], None);
        let [gradient, offset, size] = [3, 0, 3];
        let overloaded = Availability::extension(Extension::TextureCubeMapArray);
        SamplerRow {
            dim,
            comparison,
            coords,
            projected,
            gradient,
            offset,
            size,
            lod_support,
            prefixed,
            overloaded,
        }
    }
    const DESKTOP: Availability = Availability::DESKTOP;
    const DESKTOP_AND_ES: Availability = Availability::DESKTOP_AND_ES_100;
    const RECT: Availability = Availability::extension(Extension::TextureRectangle);
    const ARRAY: Availability = GPU_SHADER4.or(Extension::TextureArray);
    [
        row((D1, No), 1, &[2, 4], [1, 1, 1], All, ("texture1D", DESKTOP)),
        row((D2, No), 2, &[3, 4], [2, 2, 2], All, ("texture2D", DESKTOP_AND_ES)),
        row((D3, No), 3, &[4], [3, 3, 3], All, ("texture3D", DESKTOP)),
        row((Cube, No), 3, &[], [3, 0, 2], All, ("textureCube", DESKTOP_AND_ES)),
        row((Rect, No), 2, &[3, 4], [2, 2, 2], Derived, ("texture2DRect", RECT)),
        row((D1Array, No), 2, &[], [1, 1, 2], All, ("texture1DArray", ARRAY)),
        row((D2Array, No), 3, &[], [2, 2, 3], All, ("texture2DArray", ARRAY)),
        row((D1, Yes), 3, &[4], [1, 1, 1], All, ("shadow1D", DESKTOP)),
        row((D2, Yes), 3, &[4], [2, 2, 2], All, ("shadow2D", DESKTOP)),
        row((Cube, Yes), 4, &[], [3, 0, 2], Biased, ("shadowCube", GPU_SHADER4)),
        row((Rect, Yes), 3, &[4], [2, 2, 2], Derived, ("shadow2DRect", RECT)),
        row((D1Array, Yes), 3, &[], [1, 1, 2], All, ("shadow1DArray", ARRAY)),
        row((D2Array, Yes), 4, &[], [2, 2, 3], Derived, ("shadow2DArray", ARRAY)),
        cubes(No, 4, All),
        cubes(Yes, 5, Implicit),
    ]
};
