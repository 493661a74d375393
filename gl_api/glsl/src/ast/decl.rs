//! Types, qualifiers and declarations.

use super::{Expr, Name, Stmt};
use crate::text::source::Span;
use crate::types::Precision;
use std::sync::Arc;

/// A type as written.
#[derive(Clone, Debug)]
pub struct TypeName {
    /// Where.
    pub span: Span,
    /// Its base.
    pub base: TypeBase,
    /// `[n]` or `[]` after the base (from version 120 on), the outermost first.
    pub array: Vec<ArraySize>,
}

/// The base of a type.
#[derive(Clone, Debug)]
pub enum TypeBase {
    /// A keyword or the name of a structure.
    Named(Arc<str>),
    /// `struct name { ... }`.
    Struct(Arc<StructDecl>),
}

/// A structure as written.
#[derive(Clone, Debug)]
pub struct StructDecl {
    /// Its name, if it has one.
    pub name: Option<Name>,
    /// Its members.
    pub fields: Vec<(QualifiedType, Name, Vec<ArraySize>)>,
}

/// `[]` or `[size]`.
#[derive(Clone, Debug)]
pub struct ArraySize {
    /// Where.
    pub span: Span,
    /// The size.
    pub size: Option<Box<Expr>>,
}

/// A qualifier in a declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Qualifier {
    /// `const`.
    Const,
    /// `attribute`.
    Attribute,
    /// `varying`.
    Varying,
    /// `uniform`.
    Uniform,
    /// `in`.
    In,
    /// `out`.
    Out,
    /// `inout`.
    Inout,
    /// `centroid`.
    Centroid,
    /// `invariant`.
    Invariant,
    /// `smooth`.
    Smooth,
    /// `flat`.
    Flat,
    /// `noperspective`.
    NoPerspective,
    /// `lowp`, `mediump` or `highp`.
    Precision(Precision),
    /// `layout(origin_upper_left)` of `gl_FragCoord`.
    OriginUpperLeft,
    /// `layout(pixel_center_integer)` of `gl_FragCoord`.
    PixelCenterInteger,
    /// `layout(location = n)`.
    Location(u32),
    /// `layout(index = n)` of an output of the fragment stage.
    Index(u32),
    /// `layout(binding = n)` of samplers and uniform blocks.
    Binding(u32),
    /// `layout(depth_less)` and the like of `gl_FragDepth`.
    Depth(DepthLayout),
    /// `layout(std140)` and the like, of uniform blocks.
    Block(BlockLayout),
    /// `layout(triangles)` and the like, of the geometry stage.
    Primitive(PrimitiveLayout),
    /// `layout(max_vertices = n)` of the geometry stage.
    MaxVertices(u32),
}

/// How the fragment stage changes the depth (ARB_conservative_depth). Nothing depends on it: the
/// depth test comes after the stage that writes the depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthLayout {
    /// `depth_any`.
    Any,
    /// `depth_greater`.
    Greater,
    /// `depth_less`.
    Less,
    /// `depth_unchanged`.
    Unchanged,
}

/// The primitives that the geometry stage takes and makes (GLSL 1.50 section 4.3.8).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PrimitiveLayout {
    /// `points`, both taken and made.
    Points,
    /// `lines`.
    Lines,
    /// `lines_adjacency`.
    LinesAdjacency,
    /// `triangles`.
    Triangles,
    /// `triangles_adjacency`.
    TrianglesAdjacency,
    /// `line_strip`.
    LineStrip,
    /// `triangle_strip`.
    TriangleStrip,
}

/// A layout qualifier of a uniform block (ARB_uniform_buffer_object, section 4.3.5.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockLayout {
    /// `shared`.
    Shared,
    /// `packed`.
    Packed,
    /// `std140`.
    Std140,
    /// `row_major`.
    RowMajor,
    /// `column_major`.
    ColumnMajor,
}

impl Qualifier {
    /// Whether it stands in `layout(...)`.
    pub fn is_layout(self) -> bool {
        match self {
            Self::OriginUpperLeft
            | Self::PixelCenterInteger
            | Self::Location(_)
            | Self::Index(_)
            | Self::Binding(_)
            | Self::Depth(_)
            | Self::Block(_)
            | Self::Primitive(_)
            | Self::MaxVertices(_) => true,
            Self::Const
            | Self::Attribute
            | Self::Varying
            | Self::Uniform
            | Self::In
            | Self::Out
            | Self::Inout
            | Self::Centroid
            | Self::Invariant
            | Self::Smooth
            | Self::Flat
            | Self::NoPerspective
            | Self::Precision(_) => false,
        }
    }

    /// Its position among others (GLSL 1.30 section 4.7): invariance, interpolation, storage,
    /// precision.
    pub fn rank(self) -> u8 {
        match self {
            Self::OriginUpperLeft
            | Self::PixelCenterInteger
            | Self::Location(_)
            | Self::Index(_)
            | Self::Binding(_)
            | Self::Depth(_)
            | Self::Block(_)
            | Self::Primitive(_)
            | Self::MaxVertices(_)
            | Self::Invariant => 0,
            Self::Smooth | Self::Flat | Self::NoPerspective => 1,
            Self::Centroid | Self::Const => 2,
            Self::Attribute
            | Self::Varying
            | Self::Uniform
            | Self::In
            | Self::Out
            | Self::Inout => 3,
            Self::Precision(_) => 4,
        }
    }
}

/// A qualified type.
#[derive(Clone, Debug)]
pub struct QualifiedType {
    /// Its qualifiers, in order.
    pub qualifiers: Vec<(Qualifier, Span)>,
    /// The type.
    pub ty: TypeName,
}

/// A declared name.
#[derive(Clone, Debug)]
pub struct Declarator {
    /// The name.
    pub name: Name,
    /// `[n]` after it, the outermost first.
    pub array: Vec<ArraySize>,
    /// `= value`.
    pub init: Option<Expr>,
}

/// A declaration of variables, or of a structure alone.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// The type.
    pub ty: QualifiedType,
    /// The names.
    pub names: Vec<Declarator>,
}

/// A parameter.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its type.
    pub ty: QualifiedType,
    /// Its name, if it has one.
    pub name: Option<Name>,
    /// `[n]` after the name, the outermost first.
    pub array: Vec<ArraySize>,
}

/// A function.
#[derive(Clone, Debug)]
pub struct Function {
    /// What it returns.
    pub ty: QualifiedType,
    /// Its name.
    pub name: Name,
    /// Its parameters.
    pub parameters: Vec<Parameter>,
    /// Its body; `None` for a prototype.
    pub body: Option<Vec<Stmt>>,
}

/// The name behind a block, with which its members are written.
#[derive(Clone, Debug)]
pub struct InstanceName {
    /// The name.
    pub name: Name,
    /// `[n]` after it, the outermost first.
    pub array: Vec<ArraySize>,
}

/// A block of uniforms, inputs or outputs.
#[derive(Clone, Debug)]
pub struct BlockDecl {
    /// The qualifiers before its name.
    pub qualifiers: Vec<(Qualifier, Span)>,
    /// Its name.
    pub name: Name,
    /// Its members.
    pub members: Vec<Declaration>,
    /// The name of its instance, if it has one.
    pub instance: Option<InstanceName>,
}

/// A declaration outside of functions.
#[derive(Clone, Debug)]
pub enum Item {
    /// Variables.
    Declaration(Declaration),
    /// A function.
    Function(Function),
    /// A block.
    Block(BlockDecl),
    /// `layout(std140) uniform;`, `layout(triangles) in;`: default layout qualifiers (GLSL 1.50 section 4.3.8).
    LayoutDefaults(Vec<(Qualifier, Span)>),
    /// `invariant a, b;`.
    Invariant(Vec<Name>),
    /// `precision highp float;`, with the type.
    Precision(Precision, TypeName),
}
