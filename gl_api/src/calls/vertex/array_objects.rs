//! The names and bindings of vertex array objects (`ARB_vertex_array_object`). The state of the bound object is in the
//! context, that of the others with their names.

use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::context::Context;
use crate::objects::arrays::{Arrays, VertexArray};
use crate::objects::bound::Bound;
use crate::objects::name_table::{Sweep, listed};

const SECTION: &str = "ARB_vertex_array_object, section 2.10";

pub(crate) fn gen_vertex_arrays(
    context: &mut Context,
    n: GLsizei,
    arrays: &mut [GLuint],
) -> Result<()> {
    context.objects.vertex_arrays.reserve(SECTION, n, arrays)
}

pub(crate) fn delete_vertex_arrays(
    context: &mut Context,
    n: GLsizei,
    arrays: &[GLuint],
) -> Result<()> {
    for &name in listed(SECTION, n, arrays)?.iter().filter(|&&name| name != 0) {
        if context.state.bindings.vertex_array == name {
            switch(context, 0);
        }
        context.objects.vertex_arrays.remove(name);
    }
    context.objects.shared.sweep(Sweep::Deleted);
    Ok(())
}

/// Refuses a call of arrays where no vertex array object is bound, in a core context.
pub(crate) fn require_vertex_array(context: &Context) -> Result<()> {
    if context.state.bindings.vertex_array != 0 || !context.profile.is_core() {
        return Ok(());
    }
    invalid_operation(
        "GL 3.3, appendix E.2.2",
        "no vertex array object is bound, which core profiles need: call glGenVertexArrays and glBindVertexArray",
    )
}

/// The vertex array object that a call works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ChosenArrays {
    /// The one that is bound.
    Bound,
    /// Another one, by its name.
    Parked(GLuint),
}

impl ChosenArrays {
    /// The one of a name; 0 is the default one, which core profiles do not have.
    ///
    /// # Errors
    /// `GL_INVALID_OPERATION` for a name that no vertex array object has.
    pub fn named(context: &Context, name: GLuint) -> Result<Self> {
        let is_default = name == 0 && !context.profile.is_core();
        if !is_default && context.objects.vertex_arrays.get(name).is_none() {
            return invalid_operation(
                "ARB_direct_state_access, section 10.3",
                format!(
                    "vaobj = {name} is no vertex array object: glCreateVertexArrays makes some, and so does binding a \
                     name once"
                ),
            );
        }
        let is_bound = name == context.state.bindings.vertex_array;
        Ok(if is_bound { Self::Bound } else { Self::Parked(name) })
    }

    fn parked(context: &Context, name: GLuint) -> &VertexArray {
        let objects = &context.objects;
        objects.vertex_arrays.get(name).unwrap_or(&objects.default_vertex_array)
    }

    fn parked_mut(context: &mut Context, name: GLuint) -> &mut VertexArray {
        let objects = &mut context.objects;
        objects.vertex_arrays.get_mut(name).unwrap_or(&mut objects.default_vertex_array)
    }

    pub fn arrays(self, context: &Context) -> &Arrays {
        match self {
            Self::Bound => &context.state.arrays,
            Self::Parked(name) => &Self::parked(context, name).arrays,
        }
    }

    pub fn arrays_mut(self, context: &mut Context) -> &mut Arrays {
        match self {
            Self::Bound => &mut context.state.arrays,
            Self::Parked(name) => &mut Self::parked_mut(context, name).arrays,
        }
    }

    pub fn element_array_buffer(self, context: &Context) -> &Bound {
        match self {
            Self::Bound => &context.state.bindings.element_array_buffer,
            Self::Parked(name) => &Self::parked(context, name).element_array_buffer,
        }
    }

    pub fn element_array_buffer_mut(self, context: &mut Context) -> &mut Bound {
        match self {
            Self::Bound => &mut context.state.bindings.element_array_buffer,
            Self::Parked(name) => &mut Self::parked_mut(context, name).element_array_buffer,
        }
    }

    /// Refuses the default object in a core context ([`require_vertex_array`]).
    pub fn require(self, context: &Context) -> Result<()> {
        match self {
            Self::Bound => require_vertex_array(context),
            Self::Parked(_) => Ok(()),
        }
    }
}

/// Exchanges the current arrays for those of another name. What the bound object has by its name is a placeholder, which
/// moves by way of `Objects::spare_vertex_array`.
fn switch(context: &mut Context, name: GLuint) {
    let (state, objects) = (&mut context.state, &mut context.objects);
    objects.vertex_arrays.create(name, VertexArray::default);
    let default = &mut objects.default_vertex_array;
    let next = objects.vertex_arrays.get_mut(name).unwrap_or(default);
    std::mem::swap(&mut state.arrays, &mut next.arrays);
    std::mem::swap(&mut state.bindings.element_array_buffer, &mut next.element_array_buffer);
    std::mem::swap(next, &mut objects.spare_vertex_array);
    let before = std::mem::replace(&mut state.bindings.vertex_array, name);
    let before = objects.vertex_arrays.get_mut(before).unwrap_or(default);
    std::mem::swap(before, &mut objects.spare_vertex_array);
}

pub(crate) fn bind_vertex_array(context: &mut Context, array: GLuint) -> Result<()> {
    if array != 0 && !context.objects.vertex_arrays.is_reserved(array) {
        return invalid_operation(
            SECTION,
            format!("array = {array} must be a name that glGenVertexArrays gave"),
        );
    }
    if array != context.state.bindings.vertex_array {
        switch(context, array);
    }
    context.state_changes.values_only();
    Ok(())
}

pub(crate) fn is_vertex_array(context: &mut Context, array: GLuint) -> Result<bool> {
    Ok(context.objects.vertex_arrays.get(array).is_some())
}
