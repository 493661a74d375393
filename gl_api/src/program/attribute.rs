//! Generic attributes: GL 2.1, section 2.7.

use crate::context::Context;
use crate::draw::immediate::{Slot, attribute};
use crate::error::{Result, invalid_operation};
use crate::types::*;

pub(crate) fn vertex_attrib_1f(context: &mut Context, index: GLuint, x: GLfloat) -> Result<()> {
    attribute(context, Slot::Generic(index), [x, 0.0, 0.0, 1.0])
}

pub(crate) fn vertex_attrib_2f(
    context: &mut Context,
    index: GLuint,
    x: GLfloat,
    y: GLfloat,
) -> Result<()> {
    attribute(context, Slot::Generic(index), [x, y, 0.0, 1.0])
}

pub(crate) fn vertex_attrib_3f(
    context: &mut Context,
    index: GLuint,
    x: GLfloat,
    y: GLfloat,
    z: GLfloat,
) -> Result<()> {
    attribute(context, Slot::Generic(index), [x, y, z, 1.0])
}

pub(crate) fn vertex_attrib_4f(
    context: &mut Context,
    index: GLuint,
    x: GLfloat,
    y: GLfloat,
    z: GLfloat,
    w: GLfloat,
) -> Result<()> {
    attribute(context, Slot::Generic(index), [x, y, z, w])
}

/// The first `N` numbers of a slice, and (0, 0, 0, 1) for the rest.
fn vector<const N: usize>(context: &mut Context, index: GLuint, v: &[GLfloat]) -> Result<()> {
    let Some(v) = v.first_chunk::<N>() else {
        return invalid_operation(
            "GL 2.1, section 2.7",
            format!("v has {} of {N} numbers", v.len()),
        );
    };
    let mut value = [0.0, 0.0, 0.0, 1.0];
    value[..N].copy_from_slice(v);
    attribute(context, Slot::Generic(index), value)
}

pub(crate) fn vertex_attrib_1fv(context: &mut Context, index: GLuint, v: &[GLfloat]) -> Result<()> {
    vector::<1>(context, index, v)
}

pub(crate) fn vertex_attrib_2fv(context: &mut Context, index: GLuint, v: &[GLfloat]) -> Result<()> {
    vector::<2>(context, index, v)
}

pub(crate) fn vertex_attrib_3fv(context: &mut Context, index: GLuint, v: &[GLfloat]) -> Result<()> {
    vector::<3>(context, index, v)
}

pub(crate) fn vertex_attrib_4fv(context: &mut Context, index: GLuint, v: &[GLfloat]) -> Result<()> {
    vector::<4>(context, index, v)
}
