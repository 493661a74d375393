//! Generic attributes: those of integer types that have a vector form only (GL 2.1, section 2.7; the
//! other forms are rows of `entry/attributes.rs`), and what is read as other types than `float` and
//! `int` (section 6.1.14).

use crate::base::answer::put;
use crate::base::component::{Component, filled};
use crate::base::constants::GL_CURRENT_VERTEX_ATTRIB;
use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::calls::vertex::immediate::attribute;
use crate::context::Context;
use crate::context::immediate::Slot;
use crate::query::arrays::property;

macro_rules! vectors {
    ($($name:ident $ty:ident $convert:ident;)*) => {
        $(pub(crate) fn $name(context: &mut Context, index: GLuint, v: &[$ty]) -> Result<()> {
            match v.first_chunk::<4>() {
                Some(v) => {
                    let value = filled(v.map(Component::$convert));
                    attribute(context, Slot::Generic(index), value)
                }
                None => invalid_operation(
                    "GL 2.1, section 2.7",
                    format!("v has {} of 4 numbers", v.len()),
                ),
            }
        })*
    };
}

vectors! {
    vertex_attrib_4bv GLbyte plain;
    vertex_attrib_4iv GLint plain;
    vertex_attrib_4ubv GLubyte plain;
    vertex_attrib_4usv GLushort plain;
    vertex_attrib_4uiv GLuint plain;
    vertex_attrib_4nbv GLbyte normalized;
    vertex_attrib_4nsv GLshort normalized;
    vertex_attrib_4niv GLint normalized;
    vertex_attrib_4nusv GLushort normalized;
    vertex_attrib_4nuiv GLuint normalized;
}

pub(crate) fn get_vertex_attribdv(
    context: &mut Context,
    index: GLuint,
    pname: GLenum,
    params: &mut [GLdouble],
) -> Result<()> {
    let values = property(context, index, pname)?;
    put(params, &values.into_iter().map(f64::from).collect::<Vec<_>>())
}

/// The words of a property: integers of an attribute travel as the bits of floats.
fn words(context: &Context, index: GLuint, pname: GLenum) -> Result<Vec<u32>> {
    let word = |value: f32| match pname {
        GL_CURRENT_VERTEX_ATTRIB => value.to_bits(),
        _ => value as u32,
    };
    Ok(property(context, index, pname)?.into_iter().map(word).collect())
}

pub(crate) fn get_vertex_attrib_i_iv(
    context: &mut Context,
    index: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let words = words(context, index, pname)?;
    put(params, &words.into_iter().map(u32::cast_signed).collect::<Vec<_>>())
}

pub(crate) fn get_vertex_attrib_i_uiv(
    context: &mut Context,
    index: GLuint,
    pname: GLenum,
    params: &mut [GLuint],
) -> Result<()> {
    put(params, &words(context, index, pname)?)
}
