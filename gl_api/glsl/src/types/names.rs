//! The keywords that name types, and in which versions they are keywords (GLSL 1.30 section 4.1).

use super::{Comparison, Dim, Sampler, Scalar, Type};
use crate::language::{Availability, Extension, Language};
use std::fmt;

/// The keywords and their availability.
static NAMES: [(&str, Type, Availability); 69] = {
    use Dim::{
        Buffer, Cube, CubeArray, D1, D1Array, D2, D2Array, D2Multisample, D2MultisampleArray, D3,
        Rect,
    };
    use Scalar::{Bool, Float, Int, Uint};
    use Type::{Matrix, Vector, Void};
    const ALWAYS: Availability = Availability::ALL;
    const V110: Availability = Availability::V110;
    const V120: Availability = Availability::V120;
    const V130: Availability = Availability::V130;
    const INTEGER: Availability = V130.or(Extension::GpuShader4);
    const ARRAY: Availability = INTEGER.or(Extension::TextureArray);
    const CUBE_ARRAY: Availability = Availability::extension(Extension::TextureCubeMapArray);
    const RECT: Availability = Availability::V140.or(Extension::TextureRectangle);
    const INTEGER_RECT: Availability = Availability::V140.or(Extension::GpuShader4);
    const MULTISAMPLE: Availability = Availability::extension(Extension::TextureMultisample);
    const BUFFER: Availability = Availability::V140.or(Extension::GpuShader4);
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

    /// The availability of the type that a word names.
    pub fn availability(word: &str) -> Option<Availability> {
        NAMES.iter().find(|row| row.0 == word).map(|row| row.2)
    }

    /// The words that name types.
    pub fn names(language: Language) -> impl Iterator<Item = &'static str> {
        NAMES.iter().filter(move |row| language.has(row.2)).map(|row| row.0)
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
