//! The built-in functions (GLSL 1.30 chapter 8): signatures, versions, and what they become.

use super::lookups::{self, Lookup};
use super::math::Args;
use super::table;
use crate::emit::Emit;
use crate::language::{Language, Since, Stages};
use crate::types::{Sampler, Scalar, Type, vec};
use rasterizer::ir::{Axis, Op, Stage, Value};
use std::sync::LazyLock;

/// A type in a signature, which may leave sizes open: `n` and `m` are the same all over it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum P {
    /// Scalar or vector of `n` components: `genType`, `genIType`, …
    Gen(Scalar),
    /// Vector of `n` (2 to 4) components.
    Vec(Scalar),
    /// This many components.
    Fixed(Scalar, u8),
    /// Matrix of `n` columns, `m` rows.
    Mat,
    /// Matrix of `m` columns, `n` rows.
    MatTransposed,
    /// Matrix of `n` columns and rows.
    Square,
    /// Vector of `m` components.
    Column,
    /// `out genType`.
    Out,
    /// A sampler.
    Sampler(Sampler),
}

/// What a call becomes.
#[derive(Clone, Copy, Debug)]
pub enum Lower {
    /// The operation on each component; a scalar goes with all components.
    Map(Op),
    /// The derivative of each component.
    Derivative(Axis),
    /// This.
    With(fn(&mut Emit, Args<'_>) -> Vec<Value>),
    /// A texture lookup.
    Texture(Lookup),
    /// `modf`.
    Modf,
    /// `ftransform`.
    Ftransform,
}

/// A function, for all the sizes its signature leaves open.
#[derive(Debug)]
pub struct Row {
    /// Its name.
    pub name: String,
    /// What it returns.
    pub result: P,
    /// Its parameters.
    pub parameters: Vec<P>,
    /// What brings it.
    pub since: Since,
    /// The stages that have it.
    pub stages: Stages,
    /// What it becomes.
    pub lower: Lower,
}

impl Row {
    /// Whether it writes an argument.
    pub fn writes(&self) -> bool {
        self.parameters.contains(&P::Out)
    }

    /// Whether a call with constant arguments is constant.
    pub fn folds(&self) -> bool {
        match self.lower {
            Lower::With(_) => !self.name.starts_with("noise"),
            Lower::Map(_) | Lower::Derivative(_) => true,
            Lower::Texture(..) | Lower::Modf | Lower::Ftransform => false,
        }
    }

    /// Every signature: the parameters and the result.
    pub fn signatures(&self) -> Vec<(Vec<Type>, Type)> {
        let mut all: Vec<(Vec<Type>, Type)> = Vec::new();
        for n in 1..=4 {
            for m in 2..=4 {
                let parameters: Option<Vec<Type>> =
                    self.parameters.iter().map(|p| p.instance(n, m)).collect();
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

impl P {
    fn instance(self, n: u8, m: u8) -> Option<Type> {
        match self {
            Self::Gen(scalar) => Some(Type::Vector(scalar, n)),
            Self::Vec(scalar) => (n >= 2).then_some(Type::Vector(scalar, n)),
            Self::Fixed(scalar, size) => Some(Type::Vector(scalar, size)),
            Self::Mat => (n >= 2).then_some(Type::Matrix(n, m)),
            Self::MatTransposed => (n >= 2).then_some(Type::Matrix(m, n)),
            Self::Square => (n >= 2).then_some(Type::Matrix(n, n)),
            Self::Column => Some(vec(m)),
            Self::Out => Some(vec(n)),
            Self::Sampler(sampler) => Some(Type::Sampler(sampler)),
        }
    }
}

/// The rows of a name that a shader has.
pub fn find(name: &str, stage: Stage, language: Language) -> impl Iterator<Item = &'static Row> {
    named(name).filter(move |row| row.stages.has(stage) && language.has(row.since))
}

/// The rows of a name, whatever the stage and the version.
pub fn named(name: &str) -> impl Iterator<Item = &'static Row> {
    TABLE.rows[TABLE.range(name)].iter()
}

/// The names that a shader has.
pub fn names(stage: Stage, language: Language) -> impl Iterator<Item = &'static str> {
    let has = move |row: &&Row| row.stages.has(stage) && language.has(row.since);
    TABLE.rows.iter().filter(has).map(|row| &*row.name)
}

/// Every function, sorted by name; rows of one name in the order of their tables.
struct Table {
    rows: Vec<Row>,
}

impl Table {
    fn range(&self, name: &str) -> std::ops::Range<usize> {
        let start = self.rows.partition_point(|row| *row.name < *name);
        let len = self.rows[start..].iter().take_while(|row| row.name == name).count();
        start..start + len
    }
}

static TABLE: LazyLock<Table> = LazyLock::new(|| {
    let mut rows = table::rows();
    rows.extend(lookups::rows());
    rows.sort_by(|a, b| a.name.cmp(&b.name));
    Table { rows }
});
