//! The generic attributes of integer types that have a vector form only (GL 2.1, section 2.7). The other forms are rows
//! of `entry/table/attributes.rs`.

use crate::base::component::{Component, filled};
use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::calls::vertex::immediate::attribute;
use crate::context::Context;
use crate::context::immediate::Slot;

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
