//! The texture lookups (GLSL 1.30 section 8.7; GLSL 1.20 section 8.7; `EXT_gpu_shader4`,
//! `EXT_texture_array`, `ARB_texture_rectangle`, `ARB_shader_texture_lod`,
//! `ARB_texture_cube_map_array`, `ARB_texture_multisample`, `ARB_texture_gather`; GLSL 1.40): the
//! rows are generated from a table of sampler types, because the name of a function is made of the
//! sampler type, projection, source of the level of detail and offset.

use super::samplers::{LodSupport, SAMPLERS, SamplerRow};
use crate::builtins::function::{FunctionRow, Lowering, Pattern};
use crate::builtins::texture_lookup::{LodSource, Lookup, Projection, TexelOffset};
use crate::language::{Availability, EsVersions, Extension, Stages};
use crate::types::{Comparison, Dim, Sampler, Scalar};
use std::borrow::Cow;

const GPU_SHADER4: Availability = Availability::extension(Extension::GpuShader4);

const LOD_SOURCES: [LodSource; 4] =
    [LodSource::Implicit, LodSource::Bias, LodSource::Explicit, LodSource::Gradient];

impl SamplerRow {
    fn allows(&self, lod: LodSource) -> bool {
        match lod {
            LodSource::Implicit => true,
            LodSource::Gradient => self.lod_support != LodSupport::Implicit,
            LodSource::Bias => matches!(self.lod_support, LodSupport::Biased | LodSupport::All),
            LodSource::Explicit => self.lod_support == LodSupport::All,
        }
    }

    /// The projections, each with the components of its coordinates.
    fn coordinates(&self) -> impl Iterator<Item = (Projection, u8)> {
        let projected = self.projected.iter().map(|&size| (Projection::Divide, size));
        std::iter::once((Projection::None, self.coords)).chain(projected)
    }

    /// The types of texel that its samplers can give.
    fn scalars(&self) -> &'static [Scalar] {
        match self.comparison {
            Comparison::Yes => &[Scalar::Float],
            Comparison::No => &[Scalar::Float, Scalar::Int, Scalar::Uint],
        }
    }

    /// Whether there is a layer among the coordinates.
    fn is_array(&self) -> bool {
        matches!(self.dim, Dim::D1Array | Dim::D2Array | Dim::CubeArray)
    }

    /// Without an offset and, if there are offsets, with one; each with the end of the name.
    fn offsets(&self) -> &'static [(TexelOffset, &'static str)] {
        const ALL: [(TexelOffset, &str); 2] =
            [(TexelOffset::None, ""), (TexelOffset::Constant, "Offset")];
        if self.offset == 0 { &ALL[..1] } else { &ALL }
    }

    /// The parameters of a sample whose coordinates have `size` components.
    fn parameters(
        &self,
        sampler: Sampler,
        size: u8,
        lod: LodSource,
        offset: TexelOffset,
    ) -> Vec<Pattern> {
        let mut all = vec![Pattern::Sampler(sampler), Pattern::Fixed(Scalar::Float, size.min(4))];
        if size > 4 {
            all.push(Pattern::Fixed(Scalar::Float, size - 4));
        }
        match lod {
            LodSource::Implicit | LodSource::Bias => {}
            LodSource::Explicit => all.push(Pattern::Fixed(Scalar::Float, 1)),
            LodSource::Gradient => all.extend([Pattern::Fixed(Scalar::Float, self.gradient); 2]),
        }
        if offset == TexelOffset::Constant {
            all.push(Pattern::Fixed(Scalar::Int, self.offset));
        }
        if lod == LodSource::Bias {
            all.push(Pattern::Fixed(Scalar::Float, 1));
        }
        all
    }
}

/// The middle of a name: `ProjLod`.
fn infix(projection: Projection, lod: LodSource) -> String {
    let projection = match projection {
        Projection::None => "",
        Projection::Divide => "Proj",
    };
    let lod = match lod {
        LodSource::Implicit | LodSource::Bias => "",
        LodSource::Explicit => "Lod",
        LodSource::Gradient => "Grad",
    };
    format!("{projection}{lod}")
}

/// A bias is added to a level from implicit derivatives, which only the fragment stage has.
fn stages(lod: LodSource) -> Stages {
    if lod == LodSource::Bias { Stages::Fragment } else { Stages::Any }
}

/// Every texture lookup function.
pub fn rows() -> Vec<FunctionRow> {
    let mut rows = Vec::new();
    for sampler_row in &SAMPLERS {
        for &scalar in sampler_row.scalars() {
            let sampler =
                Sampler { dim: sampler_row.dim, scalar, comparison: sampler_row.comparison };
            if let Some(prefixed) = sampler_row.prefixed {
                prefixed_rows(sampler_row, prefixed, sampler, &mut rows);
            }
            overloaded_rows(sampler_row, sampler, &mut rows);
            query_rows(sampler_row, sampler, &mut rows);
            query_levels_row(sampler_row, sampler, &mut rows);
            gather_rows(sampler_row, sampler, &mut rows);
        }
    }
    multisample_rows(&mut rows);
    buffer_rows(&mut rows);
    external_rows(&mut rows);
    rows
}

/// `texelFetch` and `textureSize` of buffer textures, which have one axis and no levels;
/// `EXT_gpu_shader4` has `Buffer` in their names.
fn buffer_rows(rows: &mut Vec<FunctionRow>) {
    let int = Pattern::Fixed(Scalar::Int, 1);
    for scalar in [Scalar::Float, Scalar::Int, Scalar::Uint] {
        let sampler = Sampler { dim: Dim::Buffer, scalar, comparison: Comparison::No };
        let (sampler, texel) = (Pattern::Sampler(sampler), Pattern::Fixed(scalar, 4));
        for (suffix, availability) in [("Buffer", GPU_SHADER4), ("", Availability::V140)] {
            let (name, lookup) = (format!("texelFetch{suffix}"), Lookup::Fetch(TexelOffset::None));
            rows.push(row(name, texel, vec![sampler, int], availability, lookup));
            rows.push(row(
                format!("textureSize{suffix}"),
                int,
                vec![sampler],
                availability,
                Lookup::Size,
            ));
        }
    }
}

/// Lookups of external images, which have one level (OES_EGL_image_external, OES_EGL_image_external_essl3).
fn external_rows(rows: &mut Vec<FunctionRow>) {
    let sampler = Sampler { dim: Dim::External, scalar: Scalar::Float, comparison: Comparison::No };
    let (sampler, texel) = (Pattern::Sampler(sampler), Pattern::Fixed(Scalar::Float, 4));
    let (int, float) =
        (|size| Pattern::Fixed(Scalar::Int, size), |size| Pattern::Fixed(Scalar::Float, size));
    let es_100 = Availability::extension(Extension::EglImageExternal);
    let es_300 = Availability::extension(Extension::EglImageExternal300);
    for (projection, infix, size) in [
        (Projection::None, "", 2),
        (Projection::Divide, "Proj", 3),
        (Projection::Divide, "Proj", 4),
    ] {
        let lookup = |lod| Lookup::Sample(projection, lod, TexelOffset::None);
        let plain = vec![sampler, float(size)];
        let implicit = lookup(LodSource::Implicit);
        rows.push(row(format!("texture2D{infix}"), texel, plain.clone(), es_100, implicit));
        rows.push(row(format!("texture{infix}"), texel, plain, es_300, implicit));
        let biased = vec![sampler, float(size), float(1)];
        let row = row(format!("texture{infix}"), texel, biased, es_300, lookup(LodSource::Bias));
        rows.push(FunctionRow { stages: stages(LodSource::Bias), ..row });
    }
    let fetch = Lookup::Fetch(TexelOffset::None);
    rows.push(row("texelFetch".into(), texel, vec![sampler, int(2), int(1)], es_300, fetch));
    rows.push(row("textureSize".into(), int(2), vec![sampler, int(1)], es_300, Lookup::Size));
}

/// `textureSize` and `texelFetch` of multisample textures; the number of the sample comes last.
fn multisample_rows(rows: &mut Vec<FunctionRow>) {
    let int = |size| Pattern::Fixed(Scalar::Int, size);
    let availability = Availability::MULTISAMPLE;
    for (dim, coords) in [(Dim::D2Multisample, 2), (Dim::D2MultisampleArray, 3)] {
        for scalar in [Scalar::Float, Scalar::Int, Scalar::Uint] {
            let sampler = Pattern::Sampler(Sampler { dim, scalar, comparison: Comparison::No });
            let (name, texel) = ("texelFetch".to_owned(), Pattern::Fixed(scalar, 4));
            let parameters = vec![sampler, int(coords), int(1)];
            rows.push(row(name, texel, parameters, availability, Lookup::Fetch(TexelOffset::None)));
            let name = "textureSize".to_owned();
            rows.push(row(name, int(coords), vec![sampler], availability, Lookup::Size));
        }
    }
}

/// A row of both stages.
fn row(
    name: String,
    result: Pattern,
    parameters: Vec<Pattern>,
    availability: Availability,
    lookup: Lookup,
) -> FunctionRow {
    let (name, parameters) = (Cow::Owned(name), Cow::Owned(parameters));
    let (stages, lowering) = (Stages::Any, Lowering::Texture(lookup));
    FunctionRow { name, result, parameters, availability, stages, lowering }
}

/// The functions that have the sampler type in their names: `texture2DProjLod`. Integer texels,
/// offsets and gradients are of `EXT_gpu_shader4`; gradients whose names end in `ARB` of
/// `ARB_shader_texture_lod`.
fn prefixed_rows(
    sampler_row: &SamplerRow,
    (prefix, float_availability): (&str, Availability),
    sampler: Sampler,
    rows: &mut Vec<FunctionRow>,
) {
    let result = Pattern::Fixed(sampler.scalar, 4);
    for (projection, size) in sampler_row.coordinates() {
        for lod in LOD_SOURCES.into_iter().filter(|lod| sampler_row.allows(*lod)) {
            for &(offset, suffix) in sampler_row.offsets() {
                let lookup = Lookup::Sample(projection, lod, offset);
                let availability = match (sampler.scalar, lod, offset) {
                    (Scalar::Float, LodSource::Gradient, TexelOffset::None)
                        if !sampler_row.is_array() =>
                    {
                        let name = format!("{prefix}{}ARB", infix(projection, lod));
                        let parameters = sampler_row.parameters(sampler, size, lod, offset);
                        let availability = Availability::extension(Extension::ShaderTextureLod);
                        rows.push(row(name, result, parameters, availability, lookup));
                        es_row(sampler_row, (prefix, sampler, size), lookup, rows);
                        GPU_SHADER4
                    }
                    (
                        Scalar::Float,
                        LodSource::Implicit | LodSource::Bias | LodSource::Explicit,
                        TexelOffset::None,
                    ) => {
                        es_row(sampler_row, (prefix, sampler, size), lookup, rows);
                        match lod {
                            LodSource::Explicit => float_availability.and_es(EsVersions::None),
                            LodSource::Implicit | LodSource::Bias | LodSource::Gradient => {
                                float_availability
                            }
                        }
                    }
                    (_, _, _) => GPU_SHADER4,
                };
                let name = format!("{prefix}{}{suffix}", infix(projection, lod));
                let parameters = sampler_row.parameters(sampler, size, lod, offset);
                let row = row(name, result, parameters, availability, lookup);
                rows.push(FunctionRow { stages: stages(lod), ..row });
            }
        }
    }
    // `texelFetch2DRect`, `textureSize1DArray`: not of `shadow2D` and the like.
    if let Some(dim) = prefix.strip_prefix("texture") {
        unfiltered_rows(sampler_row, sampler, dim, GPU_SHADER4, rows);
    }
}

/// Explicit levels and gradients of GLSL ES 1.00: `texture2DLod` of the vertex stage, and `texture2DLodEXT` of the
/// fragment stage (EXT_shader_texture_lod).
fn es_row(
    sampler_row: &SamplerRow,
    (prefix, sampler, size): (&str, Sampler, u8),
    lookup: Lookup,
    rows: &mut Vec<FunctionRow>,
) {
    let Lookup::Sample(projection, lod, offset) = lookup else { return };
    let is_explicit = matches!(lod, LodSource::Explicit | LodSource::Gradient);
    let is_in_es =
        matches!(sampler.dim, Dim::D2 | Dim::Cube) && sampler.comparison == Comparison::No;
    if !is_explicit || !is_in_es {
        return;
    }
    let name = format!("{prefix}{}", infix(projection, lod));
    let parameters = sampler_row.parameters(sampler, size, lod, offset);
    let extension = Availability::extension(Extension::EsShaderTextureLod);
    let es_100 = Availability::ES.and_es(EsVersions::Only100);
    let result = Pattern::Fixed(Scalar::Float, 4);
    if lod == LodSource::Explicit {
        let row = row(name.clone(), result, parameters.clone(), es_100, lookup);
        rows.push(FunctionRow { stages: Stages::Vertex, ..row });
    }
    let row = row(format!("{name}EXT"), result, parameters, extension, lookup);
    rows.push(FunctionRow { stages: Stages::Fragment, ..row });
}

/// The overloads that came with GLSL 1.30: `textureProjLodOffset`.
fn overloaded_rows(sampler_row: &SamplerRow, sampler: Sampler, rows: &mut Vec<FunctionRow>) {
    let result = match sampler_row.comparison {
        Comparison::Yes => Pattern::Fixed(Scalar::Float, 1),
        Comparison::No => Pattern::Fixed(sampler.scalar, 4),
    };
    for (projection, size) in sampler_row.coordinates() {
        for lod in LOD_SOURCES.into_iter().filter(|lod| sampler_row.allows(*lod)) {
            for &(offset, suffix) in sampler_row.offsets() {
                let name = format!("texture{}{suffix}", infix(projection, lod));
                let parameters = sampler_row.parameters(sampler, size, lod, offset);
                let lookup = Lookup::Sample(projection, lod, offset);
                // GLSL ES 3.00 section 8.8 has no `textureOffset` of sampler2DArrayShadow.
                let availability = match (sampler.dim, sampler.comparison, lookup) {
                    (
                        Dim::D2Array,
                        Comparison::Yes,
                        Lookup::Sample(_, LodSource::Implicit, TexelOffset::Constant),
                    ) => sampler_row.overloaded.and_es(EsVersions::None),
                    _ => sampler_row.overloaded,
                };
                let row = row(name, result, parameters, availability, lookup);
                rows.push(FunctionRow { stages: stages(lod), ..row });
            }
        }
    }
    unfiltered_rows(sampler_row, sampler, "", sampler_row.overloaded, rows);
}

/// `textureQueryLOD` (ARB_texture_query_lod), whose coordinates have no layer and no reference. A
/// rectangle has one level.
fn query_rows(sampler_row: &SamplerRow, sampler: Sampler, rows: &mut Vec<FunctionRow>) {
    if sampler_row.dim == Dim::Rect {
        return;
    }
    let parameters =
        vec![Pattern::Sampler(sampler), Pattern::Fixed(Scalar::Float, sampler_row.gradient)];
    let availability = Availability::extension(Extension::TextureQueryLod);
    let (name, result) = ("textureQueryLOD".to_owned(), Pattern::Fixed(Scalar::Float, 2));
    let row = row(name, result, parameters, availability, Lookup::QueryLod);
    rows.push(FunctionRow { stages: Stages::Fragment, ..row });
}

/// `textureQueryLevels` (ARB_texture_query_levels). A rectangle has one level.
fn query_levels_row(sampler_row: &SamplerRow, sampler: Sampler, rows: &mut Vec<FunctionRow>) {
    if sampler_row.dim == Dim::Rect {
        return;
    }
    let availability = Availability::extension(Extension::TextureQueryLevels);
    let (name, result) = ("textureQueryLevels".to_owned(), Pattern::Fixed(Scalar::Int, 1));
    rows.push(row(
        name,
        result,
        vec![Pattern::Sampler(sampler)],
        availability,
        Lookup::QueryLevels,
    ));
}

/// `textureGather` and `textureGatherOffset` (ARB_texture_gather) of textures that have two axes and
/// do not compare.
fn gather_rows(sampler_row: &SamplerRow, sampler: Sampler, rows: &mut Vec<FunctionRow>) {
    let has_two_axes = match sampler_row.dim {
        Dim::D2 | Dim::D2Array | Dim::Cube | Dim::CubeArray => true,
        Dim::D1
        | Dim::D3
        | Dim::Rect
        | Dim::D1Array
        | Dim::D2Multisample
        | Dim::D2MultisampleArray
        | Dim::Buffer
        | Dim::External => false,
    };
    if !has_two_axes || sampler_row.comparison == Comparison::Yes {
        return;
    }
    let (availability, result) =
        (Availability::extension(Extension::TextureGather), Pattern::Fixed(sampler.scalar, 4));
    for &(offset, suffix) in sampler_row.offsets() {
        let parameters =
            sampler_row.parameters(sampler, sampler_row.coords, LodSource::Implicit, offset);
        let name = format!("textureGather{suffix}");
        rows.push(row(name, result, parameters, availability, Lookup::Gather(offset)));
    }
}

/// `textureSize`, `texelFetch` and `texelFetchOffset`, with `dim` in their names.
fn unfiltered_rows(
    sampler_row: &SamplerRow,
    sampler: Sampler,
    dim: &str,
    availability: Availability,
    rows: &mut Vec<FunctionRow>,
) {
    let int = |size| Pattern::Fixed(Scalar::Int, size);
    let result = Pattern::Fixed(sampler.scalar, 4);
    // A rectangle has one level.
    let level: &[Pattern] =
        if sampler_row.dim == Dim::Rect { &[] } else { &[Pattern::Fixed(Scalar::Int, 1)] };
    let with = |more: &[Pattern]| [&[Pattern::Sampler(sampler)], more, level].concat();
    let name = format!("textureSize{dim}");
    rows.push(row(name, int(sampler_row.size), with(&[]), availability, Lookup::Size));
    if sampler_row.comparison == Comparison::No && sampler_row.offset > 0 {
        let mut parameters = with(&[int(sampler_row.coords)]);
        let name = format!("texelFetch{dim}");
        rows.push(row(
            name,
            result,
            parameters.clone(),
            availability,
            Lookup::Fetch(TexelOffset::None),
        ));
        parameters.push(int(sampler_row.offset));
        let name = format!("texelFetch{dim}Offset");
        rows.push(row(
            name,
            result,
            parameters,
            availability,
            Lookup::Fetch(TexelOffset::Constant),
        ));
    }
}
