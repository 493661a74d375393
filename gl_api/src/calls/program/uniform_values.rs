//! `glGetUniform`: the values of uniforms (GL 2.1, section 6.1.14).

use crate::base::error::{Result, invalid_operation};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::program::inspect::{SECTION, linked};
use crate::calls::program::uniform::{at_location, element_words};
use crate::context::Context;
use crate::glsl::{DataType, Scalar};

/// The words of the uniform element at a location, and their scalar type.
pub(crate) fn words(
    context: &mut Context,
    name: GLuint,
    location: GLint,
) -> Result<(Scalar, Vec<u32>)> {
    let linked = linked(context, name)?;
    let Some((uniform, element)) = at_location(&linked.program.uniforms, location) else {
        return invalid_operation(
            SECTION,
            format!("location = {location} is no uniform's of program {name}"),
        );
    };
    let each = element_words(uniform.ty);
    let first = uniform.word as usize + element * each;
    let scalar = match uniform.ty {
        DataType::Vector(scalar, _) => scalar,
        DataType::Matrix(..) => Scalar::Float,
        DataType::Sampler(_) => Scalar::Int,
    };
    Ok((scalar, linked.words.get(first..first + each).unwrap_or_default().to_vec()))
}

/// How many values a uniform has.
///
/// # Errors
/// Where the program has no such location, or is not linked.
pub(crate) fn uniform_words(context: &mut Context, name: GLuint, location: GLint) -> Result<usize> {
    words(context, name, location).map(|(_, words)| words.len())
}

pub(crate) fn get_uniformfv(
    context: &mut Context,
    name: GLuint,
    location: GLint,
    params: &mut [GLfloat],
) -> Result<()> {
    let (scalar, words) = words(context, name, location)?;
    let number = |word: u32| match scalar {
        Scalar::Float => f32::from_bits(word),
        Scalar::Int => word as i32 as f32,
        Scalar::Uint => word as f32,
        Scalar::Bool => f32::from(u8::from(word != 0)),
    };
    put(params, &words.into_iter().map(number).collect::<Vec<_>>())
}

pub(crate) fn get_uniformuiv(
    context: &mut Context,
    name: GLuint,
    location: GLint,
    params: &mut [GLuint],
) -> Result<()> {
    let (scalar, words) = words(context, name, location)?;
    let number = |word: u32| match scalar {
        Scalar::Float => f32::from_bits(word).round() as GLuint,
        Scalar::Int | Scalar::Uint => word,
        Scalar::Bool => GLuint::from(word != 0),
    };
    put(params, &words.into_iter().map(number).collect::<Vec<_>>())
}

pub(crate) fn get_uniformiv(
    context: &mut Context,
    name: GLuint,
    location: GLint,
    params: &mut [GLint],
) -> Result<()> {
    let (scalar, words) = words(context, name, location)?;
    let number = |word: u32| match scalar {
        Scalar::Float => f32::from_bits(word).round() as GLint,
        Scalar::Int | Scalar::Uint => word as GLint,
        Scalar::Bool => GLint::from(word != 0),
    };
    put(params, &words.into_iter().map(number).collect::<Vec<_>>())
}
