//! The texture lookups (GLSL 1.30 section 8.7, GLSL 1.20 section 8.7 and its extensions), generated
//! from two tables: what each kind of sampler takes, and how the functions are named.

use super::functions::{Lower, P, Row};
use crate::glsl::Scalar;
use crate::glsl::types::{Comparison, Dim, Sampler};
use crate::glsl::version::{Extension, Since, Stages};

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
    /// One texel: `texelFetch`.
    Fetch(Shift),
    /// The size of a level: `textureSize`.
    Size,
}

/// Which levels of detail a kind of sampler can be asked for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Levels {
    /// It has none: from the quad or from derivatives only.
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
    /// Components of the coordinates, layer and reference included.
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
    /// How the functions before 1.30 begin, and since when.
    old: Option<(&'static str, Since)>,
}

const KINDS: [Kind; 13] = {
    use Comparison::{No, Yes};
    use Dim::{Cube, D1, D1Array, D2, D2Array, D3, Rect};
    use Levels::{All, Biased, Derived};
    const fn row(
        (dim, comparison): (Dim, Comparison),
        coords: u8,
        projected: &'static [u8],
        [gradient, offset, size]: [u8; 3],
        levels: Levels,
        old: Option<(&'static str, Since)>,
    ) -> Kind {
        Kind { dim, comparison, coords, projected, gradient, offset, size, levels, old }
    }
    const RECT: Since = Since::only(Extension::TextureRectangle);
    const ARRAY: Since = Since::only(Extension::TextureArray);
    [
        row((D1, No), 1, &[2, 4], [1, 1, 1], All, Some(("texture1D", Since::V110))),
        row((D2, No), 2, &[3, 4], [2, 2, 2], All, Some(("texture2D", Since::ALWAYS))),
        row((D3, No), 3, &[4], [3, 3, 3], All, Some(("texture3D", Since::V110))),
        row((Cube, No), 3, &[], [3, 0, 2], All, Some(("textureCube", Since::ALWAYS))),
        row((Rect, No), 2, &[3, 4], [2, 2, 2], Derived, Some(("texture2DRect", RECT))),
        row((D1Array, No), 2, &[], [1, 1, 2], All, Some(("texture1DArray", ARRAY))),
        row((D2Array, No), 3, &[], [2, 2, 3], All, Some(("texture2DArray", ARRAY))),
        row((D1, Yes), 3, &[4], [1, 1, 1], All, Some(("shadow1D", Since::V110))),
        row((D2, Yes), 3, &[4], [2, 2, 2], All, Some(("shadow2D", Since::V110))),
        row((Cube, Yes), 4, &[], [3, 0, 2], Biased, None),
        row((Rect, Yes), 3, &[4], [2, 2, 2], Derived, Some(("shadow2DRect", RECT))),
        row((D1Array, Yes), 3, &[], [1, 1, 2], All, Some(("shadow1DArray", ARRAY))),
        row((D2Array, Yes), 4, &[], [2, 2, 3], Derived, Some(("shadow2DArray", ARRAY))),
    ]
};

const FORMS: [LodForm; 4] =
    [LodForm::Implicit, LodForm::Bias, LodForm::Explicit, LodForm::Gradient];

impl Kind {
    fn allows(&self, form: LodForm) -> bool {
        match form {
            LodForm::Implicit | LodForm::Gradient => true,
            LodForm::Bias => self.levels != Levels::Derived,
            LodForm::Explicit => self.levels == Levels::All,
        }
    }

    /// The coordinates that a sample can take, projected ones too.
    fn coordinates(&self) -> impl Iterator<Item = (Projection, u8)> {
        let projected = self.projected.iter().map(|&size| (Projection::Divide, size));
        std::iter::once((Projection::None, self.coords)).chain(projected)
    }

    /// The parameters of a sample.
    fn parameters(&self, sampler: Sampler, size: u8, form: LodForm, shift: Shift) -> Vec<P> {
        let mut all = vec![P::Sampler(sampler), P::Fixed(Scalar::Float, size)];
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
        old(kind, &mut rows);
        let scalars: &[Scalar] = match kind.comparison {
            Comparison::Yes => &[Scalar::Float],
            Comparison::No => &[Scalar::Float, Scalar::Int, Scalar::Uint],
        };
        for &scalar in scalars {
            let sampler = Sampler { dim: kind.dim, scalar, comparison: kind.comparison };
            new(kind, sampler, &mut rows);
        }
    }
    rows
}

/// The functions that have the kind of sampler in their names: `texture2DProjLod`.
fn old(kind: &Kind, rows: &mut Vec<Row>) {
    let Some((prefix, since)) = kind.old else { return };
    let sampler = Sampler { dim: kind.dim, scalar: Scalar::Float, comparison: kind.comparison };
    for (projection, size) in kind.coordinates() {
        for form in FORMS.into_iter().filter(|form| kind.allows(*form)) {
            let suffix = if form == LodForm::Gradient { "ARB" } else { "" };
            let since = match form {
                LodForm::Gradient => Since::only(Extension::ShaderTextureLod),
                LodForm::Implicit | LodForm::Bias | LodForm::Explicit => since,
            };
            rows.push(Row {
                name: format!("{prefix}{}{suffix}", infix(projection, form)),
                result: P::Fixed(Scalar::Float, 4),
                parameters: kind.parameters(sampler, size, form, Shift::None),
                since,
                stages: stages(form),
                lower: Lower::Texture(Lookup::Sample(projection, form, Shift::None)),
            });
        }
    }
}

/// The functions of GLSL 1.30: `textureProjLodOffset`, `texelFetch`, `textureSize`.
fn new(kind: &Kind, sampler: Sampler, rows: &mut Vec<Row>) {
    let result = match kind.comparison {
        Comparison::Yes => P::Fixed(Scalar::Float, 1),
        Comparison::No => P::Fixed(sampler.scalar, 4),
    };
    let mut row = |name: String, result, parameters, stages, lookup| {
        let (since, lower) = (Since::V130, Lower::Texture(lookup));
        rows.push(Row { name, result, parameters, since, stages, lower });
    };
    for (projection, size) in kind.coordinates() {
        for form in FORMS.into_iter().filter(|form| kind.allows(*form)) {
            for (shift, suffix) in [(Shift::None, ""), (Shift::Texels, "Offset")] {
                if shift == Shift::Texels && kind.offset == 0 {
                    continue;
                }
                let name = format!("texture{}{suffix}", infix(projection, form));
                let parameters = kind.parameters(sampler, size, form, shift);
                row(
                    name,
                    result,
                    parameters,
                    stages(form),
                    Lookup::Sample(projection, form, shift),
                );
            }
        }
    }
    let int = |size| P::Fixed(Scalar::Int, size);
    let mut level = vec![int(1)];
    if kind.dim == Dim::Rect {
        level.clear();
    }
    let mut parameters = vec![P::Sampler(sampler)];
    parameters.extend(&level);
    row("textureSize".into(), int(kind.size), parameters, Stages::Any, Lookup::Size);
    if kind.comparison == Comparison::No && kind.offset > 0 {
        let mut parameters = vec![P::Sampler(sampler), int(kind.coords)];
        parameters.extend(&level);
        row(
            "texelFetch".into(),
            result,
            parameters.clone(),
            Stages::Any,
            Lookup::Fetch(Shift::None),
        );
        parameters.push(int(kind.offset));
        let lookup = Lookup::Fetch(Shift::Texels);
        row("texelFetchOffset".into(), result, parameters, Stages::Any, lookup);
    }
}
