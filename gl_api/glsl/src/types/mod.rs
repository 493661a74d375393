//! The types of the language (GLSL 1.30 section 4.1).

mod data;
mod names;
mod sampler;

pub use data::{DataType, MatrixOrder, Precision, Scalar};
use rasterizer::ir::Ty;
pub use sampler::{Comparison, ComparisonResult, Dim, Sampler};
use std::sync::Arc;

/// A type.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Type {
    /// `void`.
    Void,
    /// A scalar (1 component) or a vector (2 to 4).
    Vector(Scalar, u8),
    /// Columns, rows; 2 to 4 each.
    Matrix(u8, u8),
    /// A sampler.
    Sampler(Sampler),
    /// A structure.
    Struct(Arc<Struct>),
    /// An array; `None` until its size is known.
    Array(Box<Type>, Option<u32>),
    /// The type of an expression with an error, which goes with every other type.
    Error,
}

/// A structure.
#[derive(Debug, Eq)]
pub struct Struct {
    /// Its name; empty when it has none.
    pub name: Arc<str>,
    /// Its members.
    pub fields: Vec<(Arc<str>, Type)>,
    /// The precision of each member, of its own or by default; shorter where no precision is known.
    pub precisions: Vec<Option<Precision>>,
    /// How many scalars it has.
    pub scalars: u32,
    /// The depth of nested structures in it.
    pub depth: u32,
}

/// Precisions are no part of a type (GLSL ES 3.00 section 4.5.2).
impl PartialEq for Struct {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.fields == other.fields
    }
}

impl Struct {
    /// A structure of these members.
    pub fn new(name: Arc<str>, fields: Vec<(Arc<str>, Type)>) -> Self {
        let (mut scalars, mut depth) = (0u32, 1);
        for (_, field) in &fields {
            scalars = scalars.saturating_add(field.scalars());
            if let Type::Struct(inner) = field.base() {
                depth = depth.max(inner.depth + 1);
            }
        }
        Self { name, fields, precisions: Vec::new(), scalars, depth }
    }

    /// The same with the precisions of the members.
    pub fn with_precisions(self, precisions: Vec<Option<Precision>>) -> Self {
        Self { precisions, ..self }
    }
}

/// `float`.
pub const FLOAT: Type = Type::Vector(Scalar::Float, 1);
/// `int`.
pub const INT: Type = Type::Vector(Scalar::Int, 1);
/// `uint`.
pub const UINT: Type = Type::Vector(Scalar::Uint, 1);
/// `bool`.
pub const BOOL: Type = Type::Vector(Scalar::Bool, 1);

/// `vecN`, or `float`.
pub const fn vec(size: u8) -> Type {
    Type::Vector(Scalar::Float, size)
}

impl Type {
    /// How many scalars it has; a sampler counts as one. Saturates.
    pub fn scalars(&self) -> u32 {
        match self {
            Self::Void | Self::Error => 0,
            Self::Vector(_, size) => u32::from(*size),
            Self::Matrix(columns, rows) => u32::from(columns * rows),
            Self::Sampler(_) => 1,
            Self::Struct(structure) => structure.scalars,
            Self::Array(element, len) => element.scalars().saturating_mul(len.unwrap_or(0)),
        }
    }

    /// How many locations it takes as an input or output between stages (ARB_separate_shader_objects, section
    /// 4.3.8.1).
    pub fn locations(&self) -> u32 {
        match self {
            Self::Array(element, len) => element.locations().saturating_mul(len.unwrap_or(1)),
            Self::Struct(structure) => {
                let fields = structure.fields.iter();
                fields.fold(0, |sum, (_, field)| sum.saturating_add(field.locations()))
            }
            Self::Matrix(columns, _) => (*columns).into(),
            Self::Vector(..) | Self::Sampler(_) | Self::Void | Self::Error => 1,
        }
    }

    /// The IR types of its scalars, in order; a sampler is its unit, an `i32`.
    pub fn flat(&self) -> Vec<Ty> {
        let mut all = Vec::with_capacity(self.scalars() as usize);
        self.flatten(&mut all);
        all
    }

    fn flatten(&self, all: &mut Vec<Ty>) {
        match self {
            Self::Void | Self::Error => {}
            Self::Vector(scalar, size) => all.extend((0..*size).map(|_| scalar.ty())),
            Self::Matrix(columns, rows) => all.extend((0..columns * rows).map(|_| Ty::F32)),
            Self::Sampler(_) => all.push(Ty::I32),
            Self::Struct(structure) => {
                structure.fields.iter().for_each(|(_, field)| field.flatten(all));
            }
            Self::Array(element, len) => {
                (0..len.unwrap_or(0)).for_each(|_| element.flatten(all));
            }
        }
    }

    /// The scalar type of a vector or matrix.
    pub fn scalar(&self) -> Option<Scalar> {
        match self {
            Self::Vector(scalar, _) => Some(*scalar),
            Self::Matrix(..) => Some(Scalar::Float),
            Self::Void | Self::Sampler(_) | Self::Struct(_) | Self::Array(..) | Self::Error => None,
        }
    }

    /// How many columns a matrix has.
    pub fn columns(&self) -> Option<u8> {
        if let Self::Matrix(columns, _) = self { Some(*columns) } else { None }
    }

    /// How many rows a matrix has.
    pub fn rows(&self) -> Option<u8> {
        if let Self::Matrix(_, rows) = self { Some(*rows) } else { None }
    }

    /// The same shape with another scalar type.
    pub fn with_scalar(&self, scalar: Scalar) -> Self {
        match self {
            Self::Vector(_, size) => Self::Vector(scalar, *size),
            other => other.clone(),
        }
    }

    /// Whether this is a scalar.
    pub fn is_scalar(&self) -> bool {
        matches!(self, Self::Vector(_, 1))
    }

    /// The type of an element, and the number of elements (`None`: not known yet).
    pub fn element(&self) -> Option<(Self, Option<u32>)> {
        match self {
            Self::Vector(scalar, size @ 2..) => {
                Some((Self::Vector(*scalar, 1), Some(u32::from(*size))))
            }
            Self::Matrix(columns, rows) => Some((vec(*rows), Some(u32::from(*columns)))),
            Self::Array(element, len) => Some(((**element).clone(), *len)),
            Self::Vector(..) | Self::Void | Self::Sampler(_) | Self::Struct(_) | Self::Error => {
                None
            }
        }
    }

    /// The type of the innermost elements of an array; itself if it is no array.
    pub fn base(&self) -> &Self {
        match self {
            Self::Array(element, _) => element.base(),
            Self::Void
            | Self::Vector(..)
            | Self::Matrix(..)
            | Self::Sampler(_)
            | Self::Struct(_)
            | Self::Error => self,
        }
    }

    /// Whether it is an array with an unsized dimension.
    pub fn is_unsized(&self) -> bool {
        matches!(self, Self::Array(element, len) if len.is_none() || element.is_unsized())
    }

    /// The size of the array that is this many arrays inside of it.
    pub fn inner_size_mut(&mut self, depth: usize) -> Option<&mut Option<u32>> {
        match self {
            Self::Array(_, size) if depth == 0 => Some(size),
            Self::Array(element, _) => element.inner_size_mut(depth - 1),
            Self::Void
            | Self::Vector(..)
            | Self::Matrix(..)
            | Self::Sampler(_)
            | Self::Struct(_)
            | Self::Error => None,
        }
    }

    /// Itself, with the sizes of `other` in its unsized dimensions, if that makes it `other`.
    pub fn sized_as(self, other: &Self) -> Self {
        if self.is_unsized() && self.fits(other) { other.clone() } else { self }
    }

    /// Whether it is `other` except for the unsized dimensions.
    fn fits(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Array(a, len), Self::Array(b, other)) => {
                (len.is_none() || len == other) && a.fits(b)
            }
            (a, b) => a == b,
        }
    }

    /// Whether a type in it satisfies `test`.
    pub fn any(&self, test: &dyn Fn(&Self) -> bool) -> bool {
        test(self)
            || match self {
                Self::Struct(structure) => structure.fields.iter().any(|(_, ty)| ty.any(test)),
                Self::Array(element, _) => element.any(test),
                Self::Void
                | Self::Vector(..)
                | Self::Matrix(..)
                | Self::Sampler(_)
                | Self::Error => false,
            }
    }

    /// Whether members of structures have other precisions than in `other`, an equal type.
    pub fn differs_in_precision(&self, other: &Self) -> bool {
        let (Self::Struct(a), Self::Struct(b)) = (self.base(), other.base()) else { return false };
        let known = |pair: (&Option<Precision>, &Option<Precision>)| match pair {
            (Some(a), Some(b)) => a != b,
            (None, _) | (_, None) => false,
        };
        let members = a.fields.iter().zip(&b.fields);
        !Arc::ptr_eq(a, b)
            && (a.precisions.iter().zip(&b.precisions).any(known)
                || members.into_iter().any(|((_, a), (_, b))| a.differs_in_precision(b)))
    }

    /// Whether it has a sampler in it.
    pub fn has_sampler(&self) -> bool {
        self.any(&|ty| matches!(ty, Self::Sampler(_)))
    }

    /// Whether it has an array in it.
    pub fn has_array(&self) -> bool {
        self.any(&|ty| matches!(ty, Self::Array(..)))
    }

    /// The type that GL reports for an element of it; `None` for what GL does not report.
    pub fn data_type(&self) -> Option<DataType> {
        match self {
            Self::Vector(scalar, size) => Some(DataType::Vector(*scalar, *size)),
            Self::Matrix(columns, rows) => Some(DataType::Matrix(*columns, *rows)),
            Self::Sampler(sampler) => Some(DataType::Sampler(*sampler)),
            Self::Void | Self::Struct(_) | Self::Array(..) | Self::Error => None,
        }
    }
}
