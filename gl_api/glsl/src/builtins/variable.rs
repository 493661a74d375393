//! A row of the table of variables: its type, who may write it, and what it stands for.

use super::table::variables::VARIABLES;
use crate::interface::{MatrixForm, Side, StateMatrix, StateVar, TexCoord, TexGenPlane};
use crate::language::{Availability, Language, Stages};
use crate::limits::{MAX_CLIP_PLANES, MAX_LIGHTS, MAX_TEXTURE_UNITS};
use crate::types::{BOOL, FLOAT, INT, Struct, Type, vec};
use rasterizer::ir::Stage;
use std::sync::{Arc, LazyLock};

/// What a built-in variable stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Builtin {
    /// `gl_Position`.
    Position,
    /// `gl_PointSize`.
    PointSize,
    /// `gl_ClipVertex`: what user clip planes are applied to.
    ClipVertex,
    /// `gl_ClipDistance`.
    ClipDistance,
    /// `gl_CullDistance`.
    CullDistance,
    /// `gl_InstanceID`.
    InstanceId,
    /// `gl_VertexID`.
    VertexId,
    /// A conventional attribute, by location.
    Attribute(u8),
    /// A built-in varying, by slot: written by the vertex stage, read by the fragment stage.
    Varying(u16),
    /// `gl_FragCoord`.
    FragCoord,
    /// `gl_FrontFacing`.
    FrontFacing,
    /// `gl_PointCoord`.
    PointCoord,
    /// `gl_PrimitiveID`: written by the geometry stage, read by the fragment stage.
    PrimitiveId,
    /// `gl_PrimitiveIDIn`.
    PrimitiveIdIn,
    /// `gl_Layer`: written by the stage before the fragments', which may read it.
    Layer,
    /// `gl_ViewportIndex`: the same.
    ViewportIndex,
    /// A member of `gl_in`.
    Incoming(Incoming),
    /// `gl_FragColor`.
    FragColor,
    /// `gl_FragData`.
    FragData,
    /// `gl_SecondaryFragColorEXT`.
    SecondaryFragColor,
    /// `gl_SecondaryFragDataEXT`.
    SecondaryFragData,
    /// `gl_FragDepth`.
    FragDepth,
    /// `gl_FragStencilRefARB`.
    FragStencilRef,
    /// `gl_SampleID`.
    SampleId,
    /// `gl_SamplePosition`.
    SamplePosition,
    /// `gl_SampleMask`.
    SampleMask,
    /// `gl_NumSamples`.
    SampleCount,
    /// State of the context.
    State(StateVar),
    /// State of each texture unit, light or plane.
    States(StateArray),
    /// An implementation limit.
    Limit(i32),
}

/// The members of the block `gl_PerVertex` (GLSL 1.50 section 7.1).
pub const PER_VERTEX: [&str; 11] = [
    "gl_Position",
    "gl_PointSize",
    "gl_ClipDistance",
    "gl_CullDistance",
    "gl_ClipVertex",
    "gl_FrontColor",
    "gl_BackColor",
    "gl_FrontSecondaryColor",
    "gl_BackSecondaryColor",
    "gl_TexCoord",
    "gl_FogFragCoord",
];

/// Outputs of the vertex stage that its redeclaration of the block may have and need not
/// (AMD_vertex_shader_layer, AMD_vertex_shader_viewport_index).
pub const ALSO_PER_VERTEX: [&str; 2] = ["gl_Layer", "gl_ViewportIndex"];

/// What the geometry stage reads of each vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Incoming {
    /// `gl_Position`.
    Position,
    /// `gl_PointSize`.
    PointSize,
    /// `gl_ClipDistance`.
    ClipDistance,
    /// `gl_CullDistance`.
    CullDistance,
    /// `gl_ClipVertex`.
    ClipVertex,
    /// A built-in varying, by slot.
    Varying(u16),
}

/// Whether a variable can be declared `invariant`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Invariance {
    /// In every version: what passes from the vertex to the fragment stage.
    Allowed,
    /// In GLSL ES and from 1.30 on: what the fragment stage writes.
    AllowedLater,
    /// Never.
    Forbidden,
}

impl Builtin {
    /// Whether a shader may declare it again: with a size, an interpolation qualifier or a layout
    /// (GLSL 1.30 sections 7.1 and 7.6, ARB_fragment_coord_conventions).
    pub fn is_redeclarable(self) -> bool {
        match self {
            Self::Varying(_)
            | Self::ClipDistance
            | Self::CullDistance
            | Self::FragCoord
            | Self::SampleMask
            | Self::FragDepth => true,
            Self::Position
            | Self::PointSize
            | Self::ClipVertex
            | Self::VertexId
            | Self::InstanceId
            | Self::Attribute(_)
            | Self::PointCoord
            | Self::PrimitiveId
            | Self::PrimitiveIdIn
            | Self::Layer
            | Self::ViewportIndex
            | Self::Incoming(_)
            | Self::FrontFacing
            | Self::FragColor
            | Self::FragData
            | Self::SecondaryFragColor
            | Self::SecondaryFragData
            | Self::FragStencilRef
            | Self::SampleId
            | Self::SamplePosition
            | Self::SampleCount
            | Self::State(_)
            | Self::States(_)
            | Self::Limit(_) => false,
        }
    }

    /// Whether it can be declared `invariant` (GLSL 1.20 section 4.6.1).
    pub fn invariance(self) -> Invariance {
        match self {
            Self::Position
            | Self::PointSize
            | Self::ClipVertex
            | Self::ClipDistance
            | Self::CullDistance
            | Self::Varying(_)
            | Self::FragCoord
            | Self::PointCoord => Invariance::Allowed,
            Self::FragColor
            | Self::FragData
            | Self::SecondaryFragColor
            | Self::SecondaryFragData
            | Self::FragDepth
            | Self::FragStencilRef
            | Self::SampleMask => Invariance::AllowedLater,
            Self::InstanceId
            | Self::VertexId
            | Self::Attribute(_)
            | Self::FrontFacing
            | Self::PrimitiveId
            | Self::PrimitiveIdIn
            | Self::Layer
            | Self::ViewportIndex
            | Self::Incoming(_)
            | Self::SampleId
            | Self::SamplePosition
            | Self::SampleCount
            | Self::State(_)
            | Self::States(_)
            | Self::Limit(_) => Invariance::Forbidden,
        }
    }
}

/// State with an element for each texture unit, light or clip plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum StateArray {
    /// `gl_TextureMatrix`.
    TextureMatrix(MatrixForm),
    /// `gl_TextureEnvColor`.
    EnvColor,
    /// `gl_EyePlaneS` and the like.
    TexGen(TexGenPlane, TexCoord),
    /// `gl_LightSource`.
    Light,
    /// `gl_FrontLightProduct`, `gl_BackLightProduct`.
    LightProduct(Side),
    /// `gl_ClipPlane`.
    ClipPlane,
}

impl StateArray {
    /// How many elements there are.
    pub const fn len(self) -> u8 {
        match self {
            Self::TextureMatrix(_) | Self::EnvColor | Self::TexGen(..) => MAX_TEXTURE_UNITS,
            Self::Light | Self::LightProduct(_) => MAX_LIGHTS,
            Self::ClipPlane => MAX_CLIP_PLANES,
        }
    }

    /// The state of an element.
    pub fn element(self, index: u8) -> StateVar {
        match self {
            Self::TextureMatrix(form) => StateVar::Matrix(StateMatrix::Texture(index), form),
            Self::EnvColor => StateVar::TextureEnvColor(index),
            Self::TexGen(plane, coord) => StateVar::TexGen(plane, coord, index),
            Self::Light => StateVar::Light(index),
            Self::LightProduct(side) => StateVar::LightProduct(side, index),
            Self::ClipPlane => StateVar::ClipPlane(index),
        }
    }
}

/// Who may write a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Nobody.
    ReadOnly,
    /// The shader.
    ReadWrite,
}

/// A built-in structure: its name, and its members with how many floats each has.
#[derive(Debug)]
pub struct Structure {
    /// Its name.
    pub name: &'static str,
    /// Its members.
    pub members: &'static [(&'static str, u8)],
}

/// The type of a variable, as the table writes it.
#[derive(Clone, Copy, Debug)]
pub enum VariableType {
    /// `int`.
    Int,
    /// So many `int`.
    Ints(u8),
    /// `bool`.
    Bool,
    /// `float`, or a vector of this many floats.
    Vec(u8),
    /// A square matrix of this many columns.
    Mat(u8),
    /// `float[]`: the largest index or a redeclaration gives the size (GLSL 1.30 section 7.1).
    UnsizedFloats,
    /// A member of `gl_in`: this type for each vertex of the primitive.
    OfVertices(&'static Self),
    /// So many `vec4`.
    Vec4Array(u8),
    /// So many `mat4`.
    Mat4Array(u8),
    /// A structure.
    Struct(&'static Structure),
    /// So many structures.
    StructArray(&'static Structure, u8),
}

impl VariableType {
    fn ty(self) -> Type {
        let array = |ty, len: u8| Type::Array(Box::new(ty), Some(len.into()));
        let structure = |of: &Structure| {
            let members = of.members.iter().map(|&(name, size)| (Arc::from(name), vec(size)));
            Type::Struct(Arc::new(Struct::new(of.name.into(), members.collect())))
        };
        match self {
            Self::Int => INT,
            Self::Ints(len) => array(INT, len),
            Self::Bool => BOOL,
            Self::Vec(size) => vec(size),
            Self::Mat(side) => Type::Matrix(side, side),
            Self::UnsizedFloats => Type::Array(Box::new(FLOAT), None),
            Self::OfVertices(ty) => Type::Array(Box::new(ty.ty()), None),
            Self::Vec4Array(len) => array(vec(4), len),
            Self::Mat4Array(len) => array(Type::Matrix(4, 4), len),
            Self::Struct(of) => structure(of),
            Self::StructArray(of, len) => array(structure(of), len),
        }
    }
}

/// A built-in variable of a stage.
#[derive(Debug)]
pub struct VariableRow {
    /// Its name.
    pub name: &'static str,
    /// Its type.
    pub ty: VariableType,
    /// The stages that have it.
    pub stages: Stages,
    /// The versions, profiles and extensions that have it.
    pub availability: Availability,
    /// Who may write it.
    pub access: Access,
    /// What it stands for.
    pub builtin: Builtin,
}

impl VariableRow {
    /// Whether a stage of a shader in this language has it.
    fn is_in(&self, stage: Stage, language: Language) -> bool {
        self.stages.has(stage) && language.has(self.availability)
    }
}

/// A row and its type as the checker has types.
#[derive(Debug)]
pub struct BuiltinVariable {
    /// The row.
    pub row: &'static VariableRow,
    /// The type.
    pub ty: Type,
}

/// Every variable, in the order of the table.
static ALL: LazyLock<Vec<BuiltinVariable>> = LazyLock::new(|| {
    VARIABLES.iter().map(|row| BuiltinVariable { row, ty: row.ty.ty() }).collect()
});

/// The variable of that name that a shader has.
pub fn find(name: &str, stage: Stage, language: Language) -> Option<&'static BuiltinVariable> {
    if !name.starts_with("gl_") {
        return None;
    }
    ALL.iter().find(|known| known.row.name == name && known.row.is_in(stage, language))
}

/// The structure of that name that a built-in variable has.
pub fn structure(name: &str, language: Language) -> Option<Type> {
    let named = |ty: &Type| matches!(ty, Type::Struct(structure) if *structure.name == *name);
    let known = ALL.iter().filter(|known| language.has(known.row.availability));
    known.map(|known| known.ty.base()).find(|ty| named(ty)).cloned()
}

/// The availability of a variable that a stage has in some version.
pub fn availability(name: &str, stage: Stage) -> Option<Availability> {
    let row = VARIABLES.iter().find(|row| row.name == name && row.stages.has(stage));
    row.map(|row| row.availability)
}

/// The names that a shader has.
pub fn names(stage: Stage, language: Language) -> impl Iterator<Item = &'static str> {
    let named = move |row: &&VariableRow| row.is_in(stage, language) && !row.name.contains('.');
    VARIABLES.iter().filter(named).map(|row| row.name)
}

/// Whether a stage may write it.
pub fn is_writable(builtin: Builtin, stage: Stage) -> bool {
    let row = VARIABLES.iter().find(|row| row.builtin == builtin && row.stages.has(stage));
    row.is_some_and(|row| row.access == Access::ReadWrite)
}

/// Every variable.
#[cfg(test)]
pub fn all() -> &'static [BuiltinVariable] {
    &ALL
}
