//! The types of the language (GLSL 1.30 section 4.1).

use super::version::{Extension, Language, Since};
use super::{DataType, Scalar};
use rasterizer::ir::Ty;
use std::fmt;
use std::sync::Arc;

/// The shape of the textures that a sampler takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Dim {
    /// `sampler1D`.
    D1,
    /// `sampler2D`.
    D2,
    /// `sampler3D`.
    D3,
    /// `samplerCube`.
    Cube,
    /// `sampler2DRect`.
    Rect,
    /// `sampler1DArray`.
    D1Array,
    /// `sampler2DArray`.
    D2Array,
    /// `samplerCubeArray`.
    CubeArray,
    /// `sampler2DMS`.
    D2Multisample,
    /// `sampler2DMSArray`.
    D2MultisampleArray,
    /// `samplerBuffer`.
    Buffer,
}

impl Dim {
    /// How many coordinates find a texel, the layer included.
    pub fn coords(self) -> usize {
        match self {
            Self::D1 | Self::Buffer => 1,
            Self::D2 | Self::Rect | Self::D1Array | Self::D2Multisample => 2,
            Self::D3 | Self::Cube | Self::D2Array | Self::D2MultisampleArray => 3,
            Self::CubeArray => 4,
        }
    }
}

/// Whether a sampler compares with a reference (`sampler2DShadow`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Comparison {
    /// It gives the texel.
    No,
    /// It gives the result of the comparison.
    Yes,
}

/// A kind of sampler.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sampler {
    /// The shape of its textures.
    pub dim: Dim,
    /// What their texels are made of.
    pub scalar: Scalar,
    /// Whether it compares.
    pub comparison: Comparison,
}

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
    /// The type of what was wrong already; goes with everything.
    Error,
}

/// A structure.
#[derive(Debug, PartialEq, Eq)]
pub struct Struct {
    /// Its name; empty when it has none.
    pub name: Arc<str>,
    /// Its members.
    pub fields: Vec<(Arc<str>, Type)>,
    /// How many scalars it has.
    pub scalars: u32,
    /// How deep structures stand inside one another in it.
    pub depth: u32,
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
        Self { name, fields, scalars, depth }
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

/// The words that name types, and since when.
static NAMES: [(&str, Type, Since); 69] = {
    use Dim::{
        Buffer, Cube, CubeArray, D1, D1Array, D2, D2Array, D2Multisample, D2MultisampleArray, D3,
        Rect,
    };
    use Scalar::{Bool, Float, Int, Uint};
    use Type::{Matrix, Vector, Void};
    const ALWAYS: Since = Since::ALWAYS;
    const V110: Since = Since::V110;
    const V120: Since = Since::V120;
    const V130: Since = Since::V130;
    const INTEGER: Since = V130.or(Extension::GpuShader4);
    const ARRAY: Since = INTEGER.or(Extension::TextureArray);
    const CUBE_ARRAY: Since = Since::only(Extension::TextureCubeMapArray);
    const RECT: Since = Since::V140.or(Extension::TextureRectangle);
    const INTEGER_RECT: Since = Since::V140.or(Extension::GpuShader4);
    const MULTISAMPLE: Since = Since::only(Extension::TextureMultisample);
    const BUFFER: Since = Since::V140.or(Extension::GpuShader4);
    const fn plain(dim: Dim, scalar: Scalar) -> Type {
        Type::Sampler(Sampler { dim, scalar, comparison: Comparison::No })
    }
    const fn shadow(dim: Dim) -> Type {
        Type::Sampler(Sampler { dim, scalar: Float, comparison: Comparison::Yes })
    }
    [
        ("void", Void, ALWAYS),
        ("float", Vector(Float, 1), ALWAYS),
        ("int", Vector(Int, 1), ALWAYS),
        ("bool", Vector(Bool, 1), ALWAYS),
        ("uint", Vector(Uint, 1), INTEGER),
        ("vec2", Vector(Float, 2), ALWAYS),
        ("vec3", Vector(Float, 3), ALWAYS),
        ("vec4", Vector(Float, 4), ALWAYS),
        ("ivec2", Vector(Int, 2), ALWAYS),
        ("ivec3", Vector(Int, 3), ALWAYS),
        ("ivec4", Vector(Int, 4), ALWAYS),
        ("bvec2", Vector(Bool, 2), ALWAYS),
        ("bvec3", Vector(Bool, 3), ALWAYS),
        ("bvec4", Vector(Bool, 4), ALWAYS),
        ("uvec2", Vector(Uint, 2), INTEGER),
        ("uvec3", Vector(Uint, 3), INTEGER),
        ("uvec4", Vector(Uint, 4), INTEGER),
        ("mat2", Matrix(2, 2), ALWAYS),
        ("mat3", Matrix(3, 3), ALWAYS),
        ("mat4", Matrix(4, 4), ALWAYS),
        ("mat2x2", Matrix(2, 2), V120),
        ("mat2x3", Matrix(2, 3), V120),
        ("mat2x4", Matrix(2, 4), V120),
        ("mat3x2", Matrix(3, 2), V120),
        ("mat3x3", Matrix(3, 3), V120),
        ("mat3x4", Matrix(3, 4), V120),
        ("mat4x2", Matrix(4, 2), V120),
        ("mat4x3", Matrix(4, 3), V120),
        ("mat4x4", Matrix(4, 4), V120),
        ("sampler1D", plain(D1, Float), V110),
        ("isampler1D", plain(D1, Int), INTEGER),
        ("usampler1D", plain(D1, Uint), INTEGER),
        ("sampler2D", plain(D2, Float), ALWAYS),
        ("isampler2D", plain(D2, Int), INTEGER),
        ("usampler2D", plain(D2, Uint), INTEGER),
        ("sampler3D", plain(D3, Float), V110),
        ("isampler3D", plain(D3, Int), INTEGER),
        ("usampler3D", plain(D3, Uint), INTEGER),
        ("samplerCube", plain(Cube, Float), ALWAYS),
        ("isamplerCube", plain(Cube, Int), INTEGER),
        ("usamplerCube", plain(Cube, Uint), INTEGER),
        ("sampler2DRect", plain(Rect, Float), RECT),
        ("isampler2DRect", plain(Rect, Int), INTEGER_RECT),
        ("usampler2DRect", plain(Rect, Uint), INTEGER_RECT),
        ("sampler1DArray", plain(D1Array, Float), ARRAY),
        ("isampler1DArray", plain(D1Array, Int), INTEGER),
        ("usampler1DArray", plain(D1Array, Uint), INTEGER),
        ("sampler2DArray", plain(D2Array, Float), ARRAY),
        ("isampler2DArray", plain(D2Array, Int), INTEGER),
        ("usampler2DArray", plain(D2Array, Uint), INTEGER),
        ("samplerCubeArray", plain(CubeArray, Float), CUBE_ARRAY),
        ("isamplerCubeArray", plain(CubeArray, Int), CUBE_ARRAY),
        ("usamplerCubeArray", plain(CubeArray, Uint), CUBE_ARRAY),
        ("sampler2DMS", plain(D2Multisample, Float), MULTISAMPLE),
        ("isampler2DMS", plain(D2Multisample, Int), MULTISAMPLE),
        ("usampler2DMS", plain(D2Multisample, Uint), MULTISAMPLE),
        ("sampler2DMSArray", plain(D2MultisampleArray, Float), MULTISAMPLE),
        ("isampler2DMSArray", plain(D2MultisampleArray, Int), MULTISAMPLE),
        ("usampler2DMSArray", plain(D2MultisampleArray, Uint), MULTISAMPLE),
        ("samplerBuffer", plain(Buffer, Float), BUFFER),
        ("isamplerBuffer", plain(Buffer, Int), BUFFER),
        ("usamplerBuffer", plain(Buffer, Uint), BUFFER),
        ("sampler1DShadow", shadow(D1), V110),
        ("sampler2DShadow", shadow(D2), V110),
        ("samplerCubeShadow", shadow(Cube), INTEGER),
        ("sampler2DRectShadow", shadow(Rect), RECT),
        ("sampler1DArrayShadow", shadow(D1Array), ARRAY),
        ("sampler2DArrayShadow", shadow(D2Array), ARRAY),
        ("samplerCubeArrayShadow", shadow(CubeArray), CUBE_ARRAY),
    ]
};

impl Type {
    /// The type that a word names.
    pub fn named(word: &str, language: Language) -> Option<Self> {
        let row = NAMES.iter().find(|row| row.0 == word && language.has(row.2));
        row.map(|row| row.1.clone())
    }

    /// What brings the type that a word names.
    pub fn since(word: &str) -> Option<Since> {
        NAMES.iter().find(|row| row.0 == word).map(|row| row.2)
    }

    /// The words that name types.
    pub fn names(language: Language) -> impl Iterator<Item = &'static str> {
        NAMES.iter().filter(move |row| language.has(row.2)).map(|row| row.0)
    }

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

    /// The types of its scalars, in order; a sampler is its unit, an `i32`.
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

    /// What a vector or matrix is made of.
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

    /// The same shape made of another scalar.
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

    /// What indexing gives, and how many of them there are (`None`: not known yet).
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

    /// The type of what an array holds in its last dimension, or itself when it is no array.
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

    /// Whether it is an array with a dimension that has no size.
    pub fn is_unsized(&self) -> bool {
        matches!(self, Self::Array(element, len) if len.is_none() || element.is_unsized())
    }

    /// Itself, with the sizes of `other` in the dimensions that have none, where that makes it
    /// `other`.
    pub fn sized_as(self, other: &Self) -> Self {
        if self.is_unsized() && self.fits(other) { other.clone() } else { self }
    }

    /// Whether it is `other` but for the dimensions that have no size.
    fn fits(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Array(a, len), Self::Array(b, other)) => {
                (len.is_none() || len == other) && a.fits(b)
            }
            (a, b) => a == b,
        }
    }

    /// Whether something in it satisfies `test`.
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

    /// Whether it has a sampler in it.
    pub fn has_sampler(&self) -> bool {
        self.any(&|ty| matches!(ty, Self::Sampler(_)))
    }

    /// Whether it has an array in it.
    pub fn has_array(&self) -> bool {
        self.any(&|ty| matches!(ty, Self::Array(..)))
    }

    /// As GL reports an element of it; `None` for what GL does not report.
    pub fn data_type(&self) -> Option<DataType> {
        match self {
            Self::Vector(scalar, size) => Some(DataType::Vector(*scalar, *size)),
            Self::Matrix(columns, rows) => Some(DataType::Matrix(*columns, *rows)),
            Self::Sampler(sampler) => Some(DataType::Sampler(*sampler)),
            Self::Void | Self::Struct(_) | Self::Array(..) | Self::Error => None,
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

impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Struct(structure) if structure.name.is_empty() => write!(f, "struct"),
            Self::Struct(structure) => write!(f, "{}", structure.name),
            Self::Array(..) => {
                write!(f, "{}", self.base())?;
                let mut rest = self;
                while let Self::Array(element, len) = rest {
                    match len {
                        Some(len) => write!(f, "[{len}]")?,
                        None => write!(f, "[]")?,
                    }
                    rest = element;
                }
                Ok(())
            }
            Self::Error => write!(f, "unknown type"),
            other => match NAMES.iter().find(|row| row.1 == *other) {
                Some(row) => write!(f, "{}", row.0),
                None => write!(f, "unknown type"),
            },
        }
    }
}
