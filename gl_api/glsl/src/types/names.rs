//! The keywords that name types, and in which versions they are keywords (GLSL 1.30 section 4.1).

use super::{Comparison, Dim, Sampler, Scalar, Type};
use crate::language::{Availability, EsVersions, Extension, Language};
use std::fmt;

/// The keywords and their availability.
static NAMES: [(&str, Type, Availability); 70] = {
    use Dim::{
        Buffer, Cube, CubeArray, D1, D1Array, D2, D2Array, D2Multisample, D2MultisampleArray, D3,
        External, Rect,
    };
    use Scalar::{Bool, Float, Int, Uint};
    use Type::{Matrix, Vector, Void};
    const DESKTOP_AND_ES: Availability = Availability::DESKTOP_AND_ES;
    const DESKTOP: Availability = Availability::DESKTOP;
    const V120: Availability = Availability::V120.and_es(EsVersions::From300);
    const ES_300: Availability = DESKTOP.and_es(EsVersions::From300);
    const INTEGERS: Availability = Availability::INTEGERS;
    const GPU_SHADER4: Availability = INTEGERS.and_es(EsVersions::None);
    const ARRAY: Availability = INTEGERS.or(Extension::TextureArray);
    const ARRAY_1D: Availability = ARRAY.and_es(EsVersions::None);
    const CUBE_ARRAY: Availability = Availability::extension(Extension::TextureCubeMapArray);
    const RECT: Availability = Availability::V140.or(Extension::TextureRectangle);
    const INTEGER_RECT: Availability = Availability::V140.or(Extension::GpuShader4);
    const MULTISAMPLE: Availability = Availability::MULTISAMPLE;
    const BUFFER: Availability = Availability::V140.or(Extension::GpuShader4);
    const EXTERNAL: Availability =
        Availability::extension(Extension::EglImageExternal).or(Extension::EglImageExternal300);
    const fn plain(dim: Dim, scalar: Scalar) -> Type {
        Type::Sampler(Sampler { dim, scalar, comparison: Comparison::No })
    }
    const fn shadow(dim: Dim) -> Type {
        Type::Sampler(Sampler { dim, scalar: Float, comparison: Comparison::Yes })
    }
    [
        ("void", Void, DESKTOP_AND_ES),
        ("float", Vector(Float, 1), DESKTOP_AND_ES),
        ("int", Vector(Int, 1), DESKTOP_AND_ES),
        ("bool", Vector(Bool, 1), DESKTOP_AND_ES),
        ("uint", Vector(Uint, 1), INTEGERS),
        ("vec2", Vector(Float, 2), DESKTOP_AND_ES),
        ("vec3", Vector(Float, 3), DESKTOP_AND_ES),
        ("vec4", Vector(Float, 4), DESKTOP_AND_ES),
        ("ivec2", Vector(Int, 2), DESKTOP_AND_ES),
        ("ivec3", Vector(Int, 3), DESKTOP_AND_ES),
        ("ivec4", Vector(Int, 4), DESKTOP_AND_ES),
        ("bvec2", Vector(Bool, 2), DESKTOP_AND_ES),
        ("bvec3", Vector(Bool, 3), DESKTOP_AND_ES),
        ("bvec4", Vector(Bool, 4), DESKTOP_AND_ES),
        ("uvec2", Vector(Uint, 2), INTEGERS),
        ("uvec3", Vector(Uint, 3), INTEGERS),
        ("uvec4", Vector(Uint, 4), INTEGERS),
        ("mat2", Matrix(2, 2), DESKTOP_AND_ES),
        ("mat3", Matrix(3, 3), DESKTOP_AND_ES),
        ("mat4", Matrix(4, 4), DESKTOP_AND_ES),
        ("mat2x2", Matrix(2, 2), V120),
        ("mat2x3", Matrix(2, 3), V120),
        ("mat2x4", Matrix(2, 4), V120),
        ("mat3x2", Matrix(3, 2), V120),
        ("mat3x3", Matrix(3, 3), V120),
        ("mat3x4", Matrix(3, 4), V120),
        ("mat4x2", Matrix(4, 2), V120),
        ("mat4x3", Matrix(4, 3), V120),
        ("mat4x4", Matrix(4, 4), V120),
        ("sampler1D", plain(D1, Float), DESKTOP),
        ("isampler1D", plain(D1, Int), GPU_SHADER4),
        ("usampler1D", plain(D1, Uint), GPU_SHADER4),
        ("sampler2D", plain(D2, Float), DESKTOP_AND_ES),
        ("isampler2D", plain(D2, Int), INTEGERS),
        ("usampler2D", plain(D2, Uint), INTEGERS),
        ("sampler3D", plain(D3, Float), ES_300),
        ("isampler3D", plain(D3, Int), INTEGERS),
        ("usampler3D", plain(D3, Uint), INTEGERS),
        ("samplerCube", plain(Cube, Float), DESKTOP_AND_ES),
        ("samplerExternalOES", plain(External, Float), EXTERNAL),
        ("isamplerCube", plain(Cube, Int), INTEGERS),
        ("usamplerCube", plain(Cube, Uint), INTEGERS),
        ("sampler2DRect", plain(Rect, Float), RECT),
        ("isampler2DRect", plain(Rect, Int), INTEGER_RECT),
        ("usampler2DRect", plain(Rect, Uint), INTEGER_RECT),
        ("sampler1DArray", plain(D1Array, Float), ARRAY_1D),
        ("isampler1DArray", plain(D1Array, Int), GPU_SHADER4),
        ("usampler1DArray", plain(D1Array, Uint), GPU_SHADER4),
        ("sampler2DArray", plain(D2Array, Float), ARRAY),
        ("isampler2DArray", plain(D2Array, Int), INTEGERS),
        ("usampler2DArray", plain(D2Array, Uint), INTEGERS),
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
        ("sampler1DShadow", shadow(D1), DESKTOP),
        ("sampler2DShadow", shadow(D2), ES_300),
        ("samplerCubeShadow", shadow(Cube), INTEGERS),
        ("sampler2DRectShadow", shadow(Rect), RECT),
        ("sampler1DArrayShadow", shadow(D1Array), ARRAY_1D),
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
