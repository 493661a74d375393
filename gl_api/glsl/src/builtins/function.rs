//! A row of the table of functions: its signatures, and what a call is lowered to.

use super::expand::Args;
use super::table::{functions, textures};
use super::texture_lookup::Lookup;
use crate::emit::Emit;
use crate::language::{Availability, Language, Stages};
use crate::types::{Sampler, Scalar, Type, vec};
use rasterizer::ir::{Axis, Op, Stage, Value};
use std::borrow::Cow;
use std::sync::LazyLock;

/// The type of a parameter or result, with sizes left open: `n` and `m` are the same all over a
/// signature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pattern {
    /// Scalar or vector of `n` components: `genType`, `genIType`, …
    Gen(Scalar),
    /// Vector of `n` (2 to 4) components: `vec`, `ivec`, …
    Vec(Scalar),
    /// Exactly this many components.
    Fixed(Scalar, u8),
    /// Matrix of `n` columns, `m` rows.
    Mat,
    /// Matrix of `m` columns, `n` rows.
    MatTransposed,
    /// Matrix of `n` columns and rows.
    MatSquare,
    /// Vector of `m` components.
    MatColumn,
    /// `out genType`.
    OutGen,
    /// No result.
    Void,
    /// A sampler.
    Sampler(Sampler),
}

impl Pattern {
    /// The type for these sizes; `None` if the pattern has no such size.
    fn instance(self, n: u8, m: u8) -> Option<Type> {
        match self {
            Self::Gen(scalar) => Some(Type::Vector(scalar, n)),
            Self::Vec(scalar) => (n >= 2).then_some(Type::Vector(scalar, n)),
            Self::Fixed(scalar, size) => Some(Type::Vector(scalar, size)),
            Self::Mat => (n >= 2).then_some(Type::Matrix(n, m)),
            Self::MatTransposed => (n >= 2).then_some(Type::Matrix(m, n)),
            Self::MatSquare => (n >= 2).then_some(Type::Matrix(n, n)),
            Self::MatColumn => Some(vec(m)),
            Self::OutGen => Some(vec(n)),
            Self::Void => Some(Type::Void),
            Self::Sampler(sampler) => Some(Type::Sampler(sampler)),
        }
    }
}

/// Appends the IR of a call and gives the scalars of its result.
pub type Expansion = fn(&mut Emit, Args<'_>) -> Vec<Value>;

/// What a call is lowered to.
#[derive(Clone, Copy, Debug)]
pub enum Lowering {
    /// The operation on each component; a scalar goes with all components.
    PerComponent(Op),
    /// The derivative of each component.
    Derivative(Axis),
    /// Several operations.
    Expand(Expansion),
    /// Several operations; a call is never a constant expression.
    ExpandAtRunTime(Expansion),
    /// A texture lookup.
    Texture(Lookup),
    /// `EmitVertex`.
    EmitVertex,
    /// `EndPrimitive`.
    EndPrimitive,
    /// `modf`, which writes its second argument.
    Modf,
    /// `ftransform`: the checker replaces the call by `gl_ModelViewProjectionMatrix * gl_Vertex`.
    Ftransform,
}

/// A function, for all the sizes that its signature leaves open.
#[derive(Clone, Debug)]
pub struct FunctionRow {
    /// Its name.
    pub name: Cow<'static, str>,
    /// What it returns.
    pub result: Pattern,
    /// Its parameters.
    pub parameters: Cow<'static, [Pattern]>,
    /// The versions, profiles and extensions that have it.
    pub availability: Availability,
    /// The stages that have it.
    pub stages: Stages,
    /// What a call is lowered to.
    pub lowering: Lowering,
}

impl FunctionRow {
    /// Whether it must be called exactly once where it stands.
    pub fn has_effects(&self) -> bool {
        self.writes() || matches!(self.lowering, Lowering::EmitVertex | Lowering::EndPrimitive)
    }

    /// Whether it writes an argument.
    pub fn writes(&self) -> bool {
        self.parameters.contains(&Pattern::OutGen)
    }

    /// Whether a call with constant arguments is a constant expression.
    pub fn folds(&self) -> bool {
        match self.lowering {
            Lowering::PerComponent(_) | Lowering::Derivative(_) | Lowering::Expand(_) => true,
            Lowering::ExpandAtRunTime(_)
            | Lowering::Texture(_)
            | Lowering::Modf
            | Lowering::EmitVertex
            | Lowering::EndPrimitive
            | Lowering::Ftransform => false,
        }
    }

    /// Whether a stage of a shader in this language has it.
    fn is_in(&self, stage: Stage, language: Language) -> bool {
        self.stages.has(stage) && language.has(self.availability)
    }

    /// Every signature: the parameters and the result.
    pub fn signatures(&self) -> Vec<(Vec<Type>, Type)> {
        let mut all: Vec<(Vec<Type>, Type)> = Vec::new();
        for n in 1..=4 {
            for m in 2..=4 {
                let parameters: Option<Vec<Type>> =
                    self.parameters.iter().map(|pattern| pattern.instance(n, m)).collect();
                if let (Some(parameters), Some(result)) = (parameters, self.result.instance(n, m))
                    && !all.iter().any(|known| known.0 == parameters)
                {
                    all.push((parameters, result));
                }
            }
        }
        all
    }
}

/// The rows of a name that a shader has.
pub fn find(
    name: &str,
    stage: Stage,
    language: Language,
) -> impl Iterator<Item = &'static FunctionRow> {
    named(name).filter(move |row| row.is_in(stage, language))
}

/// The rows of a name, whatever the stage and the version.
pub fn named(name: &str) -> impl Iterator<Item = &'static FunctionRow> {
    let start = ROWS.partition_point(|row| *row.name < *name);
    let len = ROWS[start..].iter().take_while(|row| row.name == name).count();
    ROWS[start..start + len].iter()
}

/// The names that a shader has.
pub fn names(stage: Stage, language: Language) -> impl Iterator<Item = &'static str> {
    ROWS.iter().filter(move |row| row.is_in(stage, language)).map(|row| &*row.name)
}

/// Every row.
#[cfg(test)]
pub fn all() -> &'static [FunctionRow] {
    &ROWS
}

/// Every function, sorted by name; rows of one name in the order of the table.
static ROWS: LazyLock<Vec<FunctionRow>> = LazyLock::new(|| {
    let mut rows = functions::FUNCTIONS.to_vec();
    rows.extend(textures::rows());
    rows.sort_by(|a, b| a.name.cmp(&b.name));
    rows
});
