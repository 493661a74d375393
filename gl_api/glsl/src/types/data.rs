//! Types as GL reports them, of uniforms and attributes; precisions and matrix orders.

use super::Sampler;
use rasterizer::ir::Ty;

/// The type of a uniform or attribute as GL reports it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DataType {
    /// A scalar or vector: its scalar type, and 1 to 4 components.
    Vector(Scalar, u8),
    /// A matrix: columns, rows.
    Matrix(u8, u8),
    /// A sampler.
    Sampler(Sampler),
}

impl DataType {
    /// How many uniform words it takes.
    pub fn words(self) -> u32 {
        match self {
            Self::Vector(_, size) => size.into(),
            Self::Matrix(columns, rows) => u32::from(columns) * u32::from(rows),
            Self::Sampler(_) => 1,
        }
    }
}

/// The scalar type of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Scalar {
    /// `float`.
    Float,
    /// `int`.
    Int,
    /// `uint`.
    Uint,
    /// `bool`.
    Bool,
}

/// The order of a matrix in a buffer (ARB_uniform_buffer_object, section 2.15.3.1.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MatrixOrder {
    /// Column-major.
    Columns,
    /// Row-major.
    Rows,
}

/// `lowp`, `mediump` and `highp`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// `lowp`.
    Low,
    /// `mediump`.
    Medium,
    /// `highp`.
    High,
}

impl Precision {
    /// The keyword.
    pub fn word(self) -> &'static str {
        match self {
            Self::Low => "lowp",
            Self::Medium => "mediump",
            Self::High => "highp",
        }
    }
}

impl Scalar {
    /// The type in the IR.
    pub fn ty(self) -> Ty {
        match self {
            Self::Float => Ty::F32,
            Self::Int => Ty::I32,
            Self::Uint => Ty::U32,
            Self::Bool => Ty::Bool,
        }
    }
}
