//! The types of uniforms and attributes as GL names them: GL 2.1, section 2.15.3.

use crate::base::constants::*;
use crate::base::types::GLenum;
use crate::glsl;

/// The type of a uniform or attribute as GL names it.
pub(crate) fn gl_type(ty: glsl::DataType) -> GLenum {
    use glsl::{DataType, Scalar};
    let of = |types: [GLenum; 4], size: u8| types[usize::from(size.clamp(1, 4) - 1)];
    match ty {
        DataType::Vector(Scalar::Float, size) => {
            of([GL_FLOAT, GL_FLOAT_VEC2, GL_FLOAT_VEC3, GL_FLOAT_VEC4], size)
        }
        DataType::Vector(Scalar::Int, size) => {
            of([GL_INT, GL_INT_VEC2, GL_INT_VEC3, GL_INT_VEC4], size)
        }
        DataType::Vector(Scalar::Uint, size) => of(
            [GL_UNSIGNED_INT, GL_UNSIGNED_INT_VEC2, GL_UNSIGNED_INT_VEC3, GL_UNSIGNED_INT_VEC4],
            size,
        ),
        DataType::Vector(Scalar::Bool, size) => {
            of([GL_BOOL, GL_BOOL_VEC2, GL_BOOL_VEC3, GL_BOOL_VEC4], size)
        }
        DataType::Matrix(columns, rows) => {
            const MATRICES: [[GLenum; 3]; 3] = [
                [GL_FLOAT_MAT2, GL_FLOAT_MAT2x3, GL_FLOAT_MAT2x4],
                [GL_FLOAT_MAT3x2, GL_FLOAT_MAT3, GL_FLOAT_MAT3x4],
                [GL_FLOAT_MAT4x2, GL_FLOAT_MAT4x3, GL_FLOAT_MAT4],
            ];
            let index = |size: u8| usize::from(size.clamp(2, 4) - 2);
            MATRICES[index(columns)][index(rows)]
        }
        DataType::Sampler(sampler) => sampler_type(sampler),
    }
}

/// The type of a sampler as GL names it.
fn sampler_type(sampler: glsl::Sampler) -> GLenum {
    use glsl::{Comparison, Dim, Scalar};
    let of = |float, int, uint| match sampler.scalar {
        Scalar::Int => int,
        Scalar::Uint => uint,
        Scalar::Float | Scalar::Bool => float,
    };
    match (sampler.dim, sampler.comparison) {
        (Dim::D1, Comparison::No) => {
            of(GL_SAMPLER_1D, GL_INT_SAMPLER_1D, GL_UNSIGNED_INT_SAMPLER_1D)
        }
        (Dim::D2, Comparison::No) => {
            of(GL_SAMPLER_2D, GL_INT_SAMPLER_2D, GL_UNSIGNED_INT_SAMPLER_2D)
        }
        (Dim::D3, Comparison::No) => {
            of(GL_SAMPLER_3D, GL_INT_SAMPLER_3D, GL_UNSIGNED_INT_SAMPLER_3D)
        }
        (Dim::Cube, Comparison::No) => {
            of(GL_SAMPLER_CUBE, GL_INT_SAMPLER_CUBE, GL_UNSIGNED_INT_SAMPLER_CUBE)
        }
        (Dim::Rect, Comparison::No) => {
            of(GL_SAMPLER_2D_RECT, GL_INT_SAMPLER_2D_RECT, GL_UNSIGNED_INT_SAMPLER_2D_RECT)
        }
        (Dim::D1Array, Comparison::No) => {
            of(GL_SAMPLER_1D_ARRAY, GL_INT_SAMPLER_1D_ARRAY, GL_UNSIGNED_INT_SAMPLER_1D_ARRAY)
        }
        (Dim::D2Array, Comparison::No) => {
            of(GL_SAMPLER_2D_ARRAY, GL_INT_SAMPLER_2D_ARRAY, GL_UNSIGNED_INT_SAMPLER_2D_ARRAY)
        }
        (Dim::CubeArray, Comparison::No) => of(
            GL_SAMPLER_CUBE_MAP_ARRAY,
            GL_INT_SAMPLER_CUBE_MAP_ARRAY,
            GL_UNSIGNED_INT_SAMPLER_CUBE_MAP_ARRAY,
        ),
        (Dim::D2Multisample, _) => of(
            GL_SAMPLER_2D_MULTISAMPLE,
            GL_INT_SAMPLER_2D_MULTISAMPLE,
            GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE,
        ),
        (Dim::D2MultisampleArray, _) => of(
            GL_SAMPLER_2D_MULTISAMPLE_ARRAY,
            GL_INT_SAMPLER_2D_MULTISAMPLE_ARRAY,
            GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY,
        ),
        (Dim::Buffer, _) => {
            of(GL_SAMPLER_BUFFER, GL_INT_SAMPLER_BUFFER, GL_UNSIGNED_INT_SAMPLER_BUFFER)
        }
        (Dim::External, _) => GL_SAMPLER_EXTERNAL_OES,
        (Dim::D1, Comparison::Yes) => GL_SAMPLER_1D_SHADOW,
        (Dim::D2 | Dim::D3, Comparison::Yes) => GL_SAMPLER_2D_SHADOW,
        (Dim::Cube, Comparison::Yes) => GL_SAMPLER_CUBE_SHADOW,
        (Dim::Rect, Comparison::Yes) => GL_SAMPLER_2D_RECT_SHADOW,
        (Dim::D1Array, Comparison::Yes) => GL_SAMPLER_1D_ARRAY_SHADOW,
        (Dim::D2Array, Comparison::Yes) => GL_SAMPLER_2D_ARRAY_SHADOW,
        (Dim::CubeArray, Comparison::Yes) => GL_SAMPLER_CUBE_MAP_ARRAY_SHADOW,
    }
}
