//! The texture lookups (GLSL 1.30 section 8.7; GLSL 1.20 section 8.7; `EXT_gpu_shader4`,
//! `EXT_texture_array`, `ARB_texture_rectangle`, `ARB_shader_texture_lod`,
//! `ARB_texture_cube_map_array`, `ARB_texture_multisample`, `ARB_texture_gather`; GLSL 1.40), generated from a table of what each kind of
//! sampler takes.

use super::functions::{Lower, P, Row};
use crate::language::{Extension, Since, Stages};
use crate::types::{Comparison, Dim, Sampler, Scalar};

/// Where a lookup's level of detail comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LodForm {
    /// From the quad.
    Implicit,
    /// From the quad, and the last argument is added.
    Bias,
    /// An argument.
    Explicit,
    /// Two arguments, the derivatives.
    Gradient,
}

/// Whether the coordinates are divided by their last component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Projection {
    /// No.
    None,
    /// Yes.
    Divide,
}

/// Whether an argument shifts the texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shift {
    /// No.
    None,
    /// By a constant number of texels.
    Texels,
}

/// A lookup.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lookup {
    /// A filtered sample.
    Sample(Projection, LodForm, Shift),
    /// One component of four texels: `textureGather`.
    Gather(Shift),
    /// One texel: `texelFetch`.
    Fetch(Shift),
    /// The size of a level: `textureSize`.
    Size,
    /// Which level would be read: `textureQueryLOD`.
    QueryLod,
}

/// Which levels of detail a kind of sampler can be asked for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Levels {
    /// From the quad only.
    Implicit,
    /// From the quad or from derivatives only.
    Derived,
    /// As above, and with a bias.
    Biased,
    /// All.
    All,
}

/// What the lookups on a kind of sampler take.
struct Kind {
    dim: Dim,
    comparison: Comparison,
    /// Components of the coordinates, layer and reference included; where there are five, the
    /// last is an argument of its own.
    coords: u8,
    /// Components of coordinates that are divided by their last.
    projected: &'static [u8],
    /// Components of a derivative.
    gradient: u8,
    /// Components of an offset; 0 where there is none.
    offset: u8,
    /// Components of a size.
    size: u8,
    levels: Levels,
    /// How the functions before 1.30 begin, and what brought those of them that are not of
    /// `EXT_gpu_shader4` alone.
    older: Option<(&'static str, Since)>,
    /// What brought those of 1.30.
    since: Since,
}

const GPU_SHADER4: Since = Since::only(Extension::GpuShader4);

const KINDS: [Kind; 15] = {
    use Comparison::{No, Yes};
    use Dim::{Cube, CubeArray, D1, D1Array, D2, D2Array, D3, Rect};
    use Levels::{All, Biased, Derived, Implicit};
    const fn row(
        (dim, comparison): (Dim, Comparison),
        coords: u8,
        projected: &'static [u8],
        [gradient, offset, size]: [u8; 3],
        levels: Levels,
        older: (&'static str, Since),
    ) -> Kind {
        let (older, since) = (Some(older), Since::V130);
        Kind { dim, comparison, coords, projected, gradient, offset, size, levels, older, since }
    }
    /// Cubes in an array, which have no functions before 1.30.
    const fn cubes(comparison: Comparison, coords: u8, levels: Levels) -> Kind {
        let (dim, projected, older) = (CubeArray, &[], None);
        let [gradient, offset, size] = [3, 0, 3];
        let since = Since::only(Extension::TextureCubeMapArray);
        Kind { dim, comparison, coords, projected, gradient, offset, size, levels, older, since }
    }
    const RECT: Since = Since::only(Extension::TextureRectangle);
    const ARRAY: Since = GPU_SHADER4.or(Extension::TextureArray);
    [
        row((D1, No), 1, &[2, 4], [1, 1, 1], All, ("texture1D", Since::V110)),
        row((D2, No), 2, &[3, 4], [2, 2, 2], All, ("texture2D", Since::ALWAYS)),
        row((D3, No), 3, &[4], [3, 3, 3], All, ("texture3D", Since::V110)),
        row((Cube, No), 3, &[], [3, 0, 2], All, ("textureCube", Since::ALWAYS)),
        row((Rect, No), 2, &[3, 4], [2, 2, 2], Derived, ("texture2DRect", RECT)),
        row((D1Array, No), 2, &[], [1, 1, 2], All, ("texture1DArray", ARRAY)),
        row((D2Array, No), 3, &[], [2, 2, 3], All, ("texture2DArray", ARRAY)),
        row((D1, Yes), 3, &[4], [1, 1, 1], All, ("shadow1D", Since::V110)),
        row((D2, Yes), 3, &[4], [2, 2, 2], All, ("shadow2D", Since::V110)),
        row((Cube, Yes), 4, &[], [3, 0, 2], Biased, ("shadowCube", GPU_SHADER4)),
        row((Rect, Yes), 3, &[4], [2, 2, 2], Derived, ("shadow2DRect", RECT)),
        row((D1Array, Yes), 3, &[], [1, 1, 2], All, ("shadow1DArray", ARRAY)),
        row((D2Array, Yes), 4, &[], [2, 2, 3], Derived, ("shadow2DArray", ARRAY)),
        cubes(No, 4, All),
        cubes(Yes, 5, Implicit),
    ]
};

const FORMS: [LodForm; 4] =
    [LodForm::Implicit, LodForm::Bias, LodForm::Explicit, LodForm::Gradient];

impl Kind {
    fn allows(&self, form: LodForm) -> bool {
        match form {
            LodForm::Implicit => true,
            LodForm::Gradient => self.levels != Levels::Implicit,
            LodForm::Bias => matches!(self.levels, Levels::Biased | Levels::All),
            LodForm::Explicit => self.levels == Levels::All,
        }
    }

    /// The coordinates that a sample can take, projected ones too.
    fn coordinates(&self) -> impl Iterator<Item = (Projection, u8)> {
        let projected = self.projected.iter().map(|&size| (Projection::Divide, size));
        std::iter::once((Projection::None, self.coords)).chain(projected)
    }

    /// The texels that its samplers give.
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

    /// With offset and without, as far as there are offsets.
    fn shifts(&self) -> &'static [(Shift, &'static str)] {
        const ALL: [(Shift, &str); 2] = [(Shift::None, ""), (Shift::Texels, "Offset")];
        if self.offset == 0 { &ALL[..1] } else { &ALL }
    }

    /// The parameters of a sample.
    fn parameters(&self, sampler: Sampler, size: u8, form: LodForm, shift: Shift) -> Vec<P> {
        let mut all = vec![P::Sampler(sampler), P::Fixed(Scalar::Float, size.min(4))];
        if size > 4 {
            all.push(P::Fixed(Scalar::Float, size - 4));
        }
        match form {
            LodForm::Implicit | LodForm::Bias => {}
            LodForm::Explicit => all.push(P::Fixed(Scalar::Float, 1)),
            LodForm::Gradient => all.extend([P::Fixed(Scalar::Float, self.gradient); 2]),
        }
        if shift == Shift::Texels {
            all.push(P::Fixed(Scalar::Int, self.offset));
        }
        if form == LodForm::Bias {
            all.push(P::Fixed(Scalar::Float, 1));
        }
        all
    }
}

/// What the names of both generations have in common.
fn infix(projection: Projection, form: LodForm) -> String {
    let projection = match projection {
        Projection::None => "",
        Projection::Divide => "Proj",
    };
    let form = match form {
        LodForm::Implicit | LodForm::Bias => "",
        LodForm::Explicit => "Lod",
        LodForm::Gradient => "Grad",
    };
    format!("{projection}{form}")
}

/// Implicit derivatives and so a bias are of the fragment stage only.
fn stages(form: LodForm) -> Stages {
    if form == LodForm::Bias { Stages::Fragment } else { Stages::Any }
}

/// Every lookup.
pub fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    for kind in &KINDS {
        for &scalar in kind.scalars() {
            let sampler = Sampler { dim: kind.dim, scalar, comparison: kind.comparison };
            if let Some(older) = kind.older {
                named_by_kind(kind, older, sampler, &mut rows);
            }
            overloaded(kind, sampler, &mut rows);
            query(kind, sampler, &mut rows);
            gathered(kind, sampler, &mut rows);
        }
    }
    multisample(&mut rows);
    buffers(&mut rows);
    rows
}

/// `texelFetch` and `textureSize`, before with `Buffer` in their names: the texels of a buffer lie in one row and have no
/// levels.
fn buffers(rows: &mut Vec<Row>) {
    let int = P::Fixed(Scalar::Int, 1);
    for scalar in [Scalar::Float, Scalar::Int, Scalar::Uint] {
        let sampler = Sampler { dim: Dim::Buffer, scalar, comparison: Comparison::No };
        let (sampler, texel) = (P::Sampler(sampler), P::Fixed(scalar, 4));
        for (suffix, since) in [("Buffer", GPU_SHADER4), ("", Since::V140)] {
            let (name, lookup) = (format!("texelFetch{suffix}"), Lookup::Fetch(Shift::None));
            rows.push(row(name, texel, vec![sampler, int], since, lookup));
            rows.push(row(format!("textureSize{suffix}"), int, vec![sampler], since, Lookup::Size));
        }
    }
}

/// `textureSize` and `texelFetch` where there are several samples a texel, whose number comes last.
fn multisample(rows: &mut Vec<Row>) {
    let int = |size| P::Fixed(Scalar::Int, size);
    let since = Since::only(Extension::TextureMultisample);
    for (dim, coords) in [(Dim::D2Multisample, 2), (Dim::D2MultisampleArray, 3)] {
        for scalar in [Scalar::Float, Scalar::Int, Scalar::Uint] {
            let sampler = P::Sampler(Sampler { dim, scalar, comparison: Comparison::No });
            let (name, texel) = ("texelFetch".to_owned(), P::Fixed(scalar, 4));
            let parameters = vec![sampler, int(coords), int(1)];
            rows.push(row(name, texel, parameters, since, Lookup::Fetch(Shift::None)));
            let name = "textureSize".to_owned();
            rows.push(row(name, int(coords), vec![sampler], since, Lookup::Size));
        }
    }
}

/// A row of any stage.
fn row(name: String, result: P, parameters: Vec<P>, since: Since, lookup: Lookup) -> Row {
    let (stages, lower) = (Stages::Any, Lower::Texture(lookup));
    Row { name, result, parameters, since, stages, lower }
}

/// The functions that have the kind of sampler in their names: `texture2DProjLod`. Integers,
/// offsets and gradients are of `EXT_gpu_shader4`; gradients with an `ARB` behind them of
/// `ARB_shader_texture_lod`.
fn named_by_kind(
    kind: &Kind,
    (prefix, since_float): (&str, Since),
    sampler: Sampler,
    rows: &mut Vec<Row>,
) {
    let result = P::Fixed(sampler.scalar, 4);
    for (projection, size) in kind.coordinates() {
        for form in FORMS.into_iter().filter(|form| kind.allows(*form)) {
            for &(shift, suffix) in kind.shifts() {
                let lookup = Lookup::Sample(projection, form, shift);
                let since = match (sampler.scalar, form, shift) {
                    (Scalar::Float, LodForm::Gradient, Shift::None) if !kind.is_array() => {
                        let name = format!("{prefix}{}ARB", infix(projection, form));
                        let parameters = kind.parameters(sampler, size, form, shift);
                        let since = Since::only(Extension::ShaderTextureLod);
                        rows.push(row(name, result, parameters, since, lookup));
                        GPU_SHADER4
                    }
                    (
                        Scalar::Float,
                        LodForm::Implicit | LodForm::Bias | LodForm::Explicit,
                        Shift::None,
                    ) => since_float,
                    (_, _, _) => GPU_SHADER4,
                };
                let name = format!("{prefix}{}{suffix}", infix(projection, form));
                let parameters = kind.parameters(sampler, size, form, shift);
                let row = row(name, result, parameters, since, lookup);
                rows.push(Row { stages: stages(form), ..row });
            }
        }
    }
    // `texelFetch2DRect`, `textureSize1DArray`.
    if let Some(dim) = prefix.strip_prefix("texture") {
        unfiltered(kind, sampler, dim, GPU_SHADER4, rows);
    }
}

/// The functions of GLSL 1.30: `textureProjLodOffset`.
fn overloaded(kind: &Kind, sampler: Sampler, rows: &mut Vec<Row>) {
    let result = match kind.comparison {
        Comparison::Yes => P::Fixed(Scalar::Float, 1),
        Comparison::No => P::Fixed(sampler.scalar, 4),
    };
    for (projection, size) in kind.coordinates() {
        for form in FORMS.into_iter().filter(|form| kind.allows(*form)) {
            for &(shift, suffix) in kind.shifts() {
                let name = format!("texture{}{suffix}", infix(projection, form));
                let parameters = kind.parameters(sampler, size, form, shift);
                let lookup = Lookup::Sample(projection, form, shift);
                let row = row(name, result, parameters, kind.since, lookup);
                rows.push(Row { stages: stages(form), ..row });
            }
        }
    }
    unfiltered(kind, sampler, "", kind.since, rows);
}

/// `textureQueryLOD` (ARB_texture_query_lod), whose coordinates have no layer and no reference. A
/// rectangle has one level.
fn query(kind: &Kind, sampler: Sampler, rows: &mut Vec<Row>) {
    if kind.dim == Dim::Rect {
        return;
    }
    let parameters = vec![P::Sampler(sampler), P::Fixed(Scalar::Float, kind.gradient)];
    let since = Since::only(Extension::TextureQueryLod);
    let (name, result) = ("textureQueryLOD".to_owned(), P::Fixed(Scalar::Float, 2));
    let row = row(name, result, parameters, since, Lookup::QueryLod);
    rows.push(Row { stages: Stages::Fragment, ..row });
}

/// `textureGather` and `textureGatherOffset` (ARB_texture_gather), of textures with two axes that do not compare.
fn gathered(kind: &Kind, sampler: Sampler, rows: &mut Vec<Row>) {
    let has_two_axes = match kind.dim {
        Dim::D2 | Dim::D2Array | Dim::Cube | Dim::CubeArray => true,
        Dim::D1
        | Dim::D3
        | Dim::Rect
        | Dim::D1Array
        | Dim::D2Multisample
        | Dim::D2MultisampleArray
        | Dim::Buffer => false,
    };
    if !has_two_axes || kind.comparison == Comparison::Yes {
        return;
    }
    let (since, result) = (Since::only(Extension::TextureGather), P::Fixed(sampler.scalar, 4));
    for &(shift, suffix) in kind.shifts() {
        let parameters = kind.parameters(sampler, kind.coords, LodForm::Implicit, shift);
        let name = format!("textureGather{suffix}");
        rows.push(row(name, result, parameters, since, Lookup::Gather(shift)));
    }
}

/// `textureSize`, `texelFetch` and `texelFetchOffset`, with `dim` in their names.
fn unfiltered(kind: &Kind, sampler: Sampler, dim: &str, since: Since, rows: &mut Vec<Row>) {
    let int = |size| P::Fixed(Scalar::Int, size);
    let result = P::Fixed(sampler.scalar, 4);
    // A rectangle has one level.
    let level: &[P] = if kind.dim == Dim::Rect { &[] } else { &[P::Fixed(Scalar::Int, 1)] };
    let with = |more: &[P]| [&[P::Sampler(sampler)], more, level].concat();
    let name = format!("textureSize{dim}");
    rows.push(row(name, int(kind.size), with(&[]), since, Lookup::Size));
    if kind.comparison == Comparison::No && kind.offset > 0 {
        let mut parameters = with(&[int(kind.coords)]);
        let name = format!("texelFetch{dim}");
        rows.push(row(name, result, parameters.clone(), since, Lookup::Fetch(Shift::None)));
        parameters.push(int(kind.offset));
        let name = format!("texelFetch{dim}Offset");
        rows.push(row(name, result, parameters, since, Lookup::Fetch(Shift::Texels)));
    }
}
