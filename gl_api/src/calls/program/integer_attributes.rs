//! Generic attributes that stay integers: `EXT_gpu_shader4`, section 2.7. They are stored as the bits of
//! floats, which a shader reads by the type that it declares.

use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::calls::vertex::immediate::attribute;
use crate::context::Context;
use crate::context::immediate::Slot;

/// Sets the first components; the others are 0, 0, 1.
fn set(context: &mut Context, index: GLuint, values: &[u32]) -> Result<()> {
    let mut words = [0, 0, 0, 1];
    words[..values.len()].copy_from_slice(values);
    attribute(context, Slot::Generic(index), words.map(f32::from_bits))
}

fn vector<const N: usize, T: Copy>(
    context: &mut Context,
    index: GLuint,
    v: &[T],
    word: impl Fn(T) -> u32,
) -> Result<()> {
    let Some(v) = v.first_chunk::<N>() else {
        return invalid_operation(
            "EXT_gpu_shader4, section 2.7",
            format!("v has {} of {N} numbers", v.len()),
        );
    };
    set(context, index, &v.map(word))
}

pub(crate) fn vertex_attrib_i_1i(context: &mut Context, index: GLuint, x: GLint) -> Result<()> {
    set(context, index, &[x as u32])
}

pub(crate) fn vertex_attrib_i_1iv(context: &mut Context, index: GLuint, v: &[GLint]) -> Result<()> {
    vector::<1, _>(context, index, v, |x| x as u32)
}

pub(crate) fn vertex_attrib_i_1ui(context: &mut Context, index: GLuint, x: GLuint) -> Result<()> {
    set(context, index, &[x])
}

pub(crate) fn vertex_attrib_i_1uiv(
    context: &mut Context,
    index: GLuint,
    v: &[GLuint],
) -> Result<()> {
    vector::<1, _>(context, index, v, |x| x)
}

pub(crate) fn vertex_attrib_i_2i(
    context: &mut Context,
    index: GLuint,
    x: GLint,
    y: GLint,
) -> Result<()> {
    set(context, index, &[x as u32, y as u32])
}

pub(crate) fn vertex_attrib_i_2iv(context: &mut Context, index: GLuint, v: &[GLint]) -> Result<()> {
    vector::<2, _>(context, index, v, |x| x as u32)
}

pub(crate) fn vertex_attrib_i_2ui(
    context: &mut Context,
    index: GLuint,
    x: GLuint,
    y: GLuint,
) -> Result<()> {
    set(context, index, &[x, y])
}

pub(crate) fn vertex_attrib_i_2uiv(
    context: &mut Context,
    index: GLuint,
    v: &[GLuint],
) -> Result<()> {
    vector::<2, _>(context, index, v, |x| x)
}

pub(crate) fn vertex_attrib_i_3i(
    context: &mut Context,
    index: GLuint,
    x: GLint,
    y: GLint,
    z: GLint,
) -> Result<()> {
    set(context, index, &[x as u32, y as u32, z as u32])
}

pub(crate) fn vertex_attrib_i_3iv(context: &mut Context, index: GLuint, v: &[GLint]) -> Result<()> {
    vector::<3, _>(context, index, v, |x| x as u32)
}

pub(crate) fn vertex_attrib_i_3ui(
    context: &mut Context,
    index: GLuint,
    x: GLuint,
    y: GLuint,
    z: GLuint,
) -> Result<()> {
    set(context, index, &[x, y, z])
}

pub(crate) fn vertex_attrib_i_3uiv(
    context: &mut Context,
    index: GLuint,
    v: &[GLuint],
) -> Result<()> {
    vector::<3, _>(context, index, v, |x| x)
}

pub(crate) fn vertex_attrib_i_4i(
    context: &mut Context,
    index: GLuint,
    x: GLint,
    y: GLint,
    z: GLint,
    w: GLint,
) -> Result<()> {
    set(context, index, &[x as u32, y as u32, z as u32, w as u32])
}

pub(crate) fn vertex_attrib_i_4iv(context: &mut Context, index: GLuint, v: &[GLint]) -> Result<()> {
    vector::<4, _>(context, index, v, |x| x as u32)
}

pub(crate) fn vertex_attrib_i_4ui(
    context: &mut Context,
    index: GLuint,
    x: GLuint,
    y: GLuint,
    z: GLuint,
    w: GLuint,
) -> Result<()> {
    set(context, index, &[x, y, z, w])
}

pub(crate) fn vertex_attrib_i_4uiv(
    context: &mut Context,
    index: GLuint,
    v: &[GLuint],
) -> Result<()> {
    vector::<4, _>(context, index, v, |x| x)
}

pub(crate) fn vertex_attrib_i_4bv(
    context: &mut Context,
    index: GLuint,
    v: &[GLbyte],
) -> Result<()> {
    vector::<4, _>(context, index, v, |x| i32::from(x) as u32)
}

pub(crate) fn vertex_attrib_i_4sv(
    context: &mut Context,
    index: GLuint,
    v: &[GLshort],
) -> Result<()> {
    vector::<4, _>(context, index, v, |x| i32::from(x) as u32)
}

pub(crate) fn vertex_attrib_i_4ubv(
    context: &mut Context,
    index: GLuint,
    v: &[GLubyte],
) -> Result<()> {
    vector::<4, _>(context, index, v, u32::from)
}

pub(crate) fn vertex_attrib_i_4usv(
    context: &mut Context,
    index: GLuint,
    v: &[GLushort],
) -> Result<()> {
    vector::<4, _>(context, index, v, u32::from)
}
