//! User clip planes: GL 2.1, section 2.12.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum, invalid_operation};
use crate::base::inverse::inverse;
use crate::base::query_value::put;
use crate::base::types::*;
use crate::context::Context;
use crate::interface::MAX_CLIP_PLANES;
use glam::DVec4;

const SECTION: &str = "GL 2.1, section 2.12";

/// A plane's number.
fn index(plane: GLenum) -> Result<usize> {
    match plane.checked_sub(GL_CLIP_PLANE0) {
        Some(index) if index < MAX_CLIP_PLANES.into() => Ok(index as usize),
        _ => invalid_enum(
            SECTION,
            format!(
                "plane = {} must be GL_CLIP_PLANE0 to GL_CLIP_PLANE{}",
                enum_name(plane),
                MAX_CLIP_PLANES - 1
            ),
        ),
    }
}

/// A plane of object coordinates in eye coordinates: the row times the inverse of the model-view
/// matrix.
pub(crate) fn eye_plane(context: &Context, plane: DVec4) -> DVec4 {
    inverse(context.state.matrices.modelview.top).transpose() * plane
}

pub(crate) fn clip_plane(
    context: &mut Context,
    plane: GLenum,
    equation: &[GLdouble],
) -> Result<()> {
    let index = index(plane)?;
    let Some(equation) = equation.first_chunk::<4>() else {
        return invalid_operation(
            SECTION,
            format!("equation has {} of the 4 numbers of a plane", equation.len()),
        );
    };
    context.state.clip.planes[index] = eye_plane(context, DVec4::from(*equation));
    Ok(())
}

pub(crate) fn get_clip_plane(
    context: &mut Context,
    plane: GLenum,
    equation: &mut [GLdouble],
) -> Result<()> {
    put(equation, &context.state.clip.planes[index(plane)?].to_array())
}
