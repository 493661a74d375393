//! Matrix stacks: GL 2.1, section 2.11.2.
//!
//! Each call computes in `f64`, where glam is the same scalar code on every machine, and rounds its
//! result to what an `f32` holds: a matrix that a program reads with `glGetFloatv` and loads again
//! is the same matrix, so that two passes agree in depth to the bit.

use crate::base::angle::sin_cos_degrees;
use crate::base::error::{ErrorCode, GlError, Result, invalid_operation, invalid_value};
use crate::base::types::*;
use crate::context::Context;
use crate::state::matrix::{MATRIX_MODE, MatrixMode, Stack};
use crate::state::plain::is_same_matrix;
use glam::{DMat4, DVec3};

const SECTION: &str = "GL 2.1, section 2.11.2";

/// The stack that the matrix mode selects.
///
/// # Errors
/// `GL_INVALID_OPERATION` for the texture matrix of a unit that has none.
fn stack(context: &mut Context) -> Result<&mut Stack> {
    let matrices = &mut context.state.matrices;
    Ok(match matrices.mode {
        MatrixMode::ModelView => &mut matrices.modelview,
        MatrixMode::Projection => &mut matrices.projection,
        MatrixMode::Texture => {
            &mut matrices.texture[context.state.units.active_coordinates(SECTION)?]
        }
        MatrixMode::Program(number) => &mut matrices.program[usize::from(number)],
    })
}

/// The same, to be read.
pub(crate) fn current(context: &Context) -> Result<&Stack> {
    let matrices = &context.state.matrices;
    Ok(match matrices.mode {
        MatrixMode::ModelView => &matrices.modelview,
        MatrixMode::Projection => &matrices.projection,
        MatrixMode::Texture => {
            &matrices.texture[context.state.units.active_coordinates(SECTION)?]
        }
        MatrixMode::Program(number) => &matrices.program[usize::from(number)],
    })
}

/// Sets the current matrix. Pending vertices keep the one that they have, where it is plain state.
fn set(context: &mut Context, matrix: DMat4) -> Result<()> {
    if is_same_matrix(&current(context)?.top, &matrix) {
        context.state_changes.no_change();
        return Ok(());
    }
    match context.state.matrices.mode {
        MatrixMode::ModelView | MatrixMode::Projection => context.state_changes.values_only(),
        // Whether there is one decides what is generated.
        MatrixMode::Texture | MatrixMode::Program(_) => context.leave_plain_state(),
    }
    stack(context)?.top = matrix;
    Ok(())
}

fn multiply(context: &mut Context, matrix: DMat4) -> Result<()> {
    let product = current(context)?.top * matrix;
    set(context, single(product))
}

/// The nearest matrix of `f32`s.
fn single(matrix: DMat4) -> DMat4 {
    DMat4::from_cols_array(&matrix.to_cols_array().map(|x| f64::from(x as f32)))
}

/// 16 numbers, column by column.
pub(crate) fn matrix<T: Copy + Into<f64>>(m: &[T]) -> Result<DMat4> {
    match m.first_chunk::<16>() {
        Some(m) => Ok(DMat4::from_cols_array(&m.map(Into::into))),
        None => {
            invalid_operation(SECTION, format!("m has {} of the 16 numbers of a matrix", m.len()))
        }
    }
}

pub(crate) fn matrix_mode(context: &mut Context, mode: GLenum) -> Result<()> {
    context.state.matrices.mode = MATRIX_MODE.decode("mode", mode)?;
    context.state_changes.no_change();
    Ok(())
}

pub(crate) fn load_identity(context: &mut Context) -> Result<()> {
    set(context, DMat4::IDENTITY)
}

pub(crate) fn load_matrixf(context: &mut Context, m: &[GLfloat]) -> Result<()> {
    set(context, single(matrix(m)?))
}

pub(crate) fn load_matrixd(context: &mut Context, m: &[GLdouble]) -> Result<()> {
    set(context, single(matrix(m)?))
}

pub(crate) fn load_transpose_matrixf(context: &mut Context, m: &[GLfloat]) -> Result<()> {
    set(context, single(matrix(m)?.transpose()))
}

pub(crate) fn load_transpose_matrixd(context: &mut Context, m: &[GLdouble]) -> Result<()> {
    set(context, single(matrix(m)?.transpose()))
}

pub(crate) fn mult_matrixf(context: &mut Context, m: &[GLfloat]) -> Result<()> {
    multiply(context, matrix(m)?)
}

pub(crate) fn mult_matrixd(context: &mut Context, m: &[GLdouble]) -> Result<()> {
    multiply(context, matrix(m)?)
}

pub(crate) fn mult_transpose_matrixf(context: &mut Context, m: &[GLfloat]) -> Result<()> {
    multiply(context, matrix(m)?.transpose())
}

pub(crate) fn mult_transpose_matrixd(context: &mut Context, m: &[GLdouble]) -> Result<()> {
    multiply(context, matrix(m)?.transpose())
}

pub(crate) fn push_matrix(context: &mut Context) -> Result<()> {
    let stack = stack(context)?;
    if stack.depth() == stack.limit {
        return Err(GlError::new(
            ErrorCode::StackOverflow,
            SECTION,
            format!("the stack holds {} matrices and no more", stack.limit),
        ));
    }
    stack.below.push(stack.top);
    context.state_changes.no_change();
    Ok(())
}

pub(crate) fn pop_matrix(context: &mut Context) -> Result<()> {
    match stack(context)?.below.pop() {
        Some(matrix) => set(context, matrix),
        None => Err(GlError::new(
            ErrorCode::StackUnderflow,
            SECTION,
            "the stack holds one matrix, which cannot be popped",
        )),
    }
}

pub(crate) fn rotatef(
    context: &mut Context,
    angle: GLfloat,
    x: GLfloat,
    y: GLfloat,
    z: GLfloat,
) -> Result<()> {
    rotated(context, angle.into(), x.into(), y.into(), z.into())
}

/// An axis of length zero turns nothing; the specification leaves it open.
pub(crate) fn rotated(
    context: &mut Context,
    angle: GLdouble,
    x: GLdouble,
    y: GLdouble,
    z: GLdouble,
) -> Result<()> {
    let length = DVec3::new(x, y, z).length();
    if length == 0.0 {
        return Ok(());
    }
    let (x, y, z) = (x / length, y / length, z / length);
    let (s, c) = sin_cos_degrees(angle);
    let t = 1.0 - c;
    multiply(
        context,
        DMat4::from_cols_array_2d(&[
            [x * x * t + c, y * x * t + z * s, x * z * t - y * s, 0.0],
            [x * y * t - z * s, y * y * t + c, y * z * t + x * s, 0.0],
            [x * z * t + y * s, y * z * t - x * s, z * z * t + c, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ]),
    )
}

pub(crate) fn translatef(context: &mut Context, x: GLfloat, y: GLfloat, z: GLfloat) -> Result<()> {
    translated(context, x.into(), y.into(), z.into())
}

pub(crate) fn translated(
    context: &mut Context,
    x: GLdouble,
    y: GLdouble,
    z: GLdouble,
) -> Result<()> {
    multiply(context, DMat4::from_translation(DVec3::new(x, y, z)))
}

pub(crate) fn scalef(context: &mut Context, x: GLfloat, y: GLfloat, z: GLfloat) -> Result<()> {
    scaled(context, x.into(), y.into(), z.into())
}

pub(crate) fn scaled(context: &mut Context, x: GLdouble, y: GLdouble, z: GLdouble) -> Result<()> {
    multiply(context, DMat4::from_scale(DVec3::new(x, y, z)))
}

pub(crate) fn frustum(
    context: &mut Context,
    left: GLdouble,
    right: GLdouble,
    bottom: GLdouble,
    top: GLdouble,
    near: GLdouble,
    far: GLdouble,
) -> Result<()> {
    if !(near > 0.0 && far > 0.0) {
        return invalid_value(SECTION, format!("near = {near} and far = {far} must be positive"));
    }
    box_has_volume([left, right], [bottom, top], [near, far])?;
    let (width, height, depth) = (right - left, top - bottom, far - near);
    multiply(
        context,
        DMat4::from_cols_array_2d(&[
            [2.0 * near / width, 0.0, 0.0, 0.0],
            [0.0, 2.0 * near / height, 0.0, 0.0],
            [(right + left) / width, (top + bottom) / height, -(far + near) / depth, -1.0],
            [0.0, 0.0, -(2.0 * far * near) / depth, 0.0],
        ]),
    )
}

pub(crate) fn ortho(
    context: &mut Context,
    left: GLdouble,
    right: GLdouble,
    bottom: GLdouble,
    top: GLdouble,
    near: GLdouble,
    far: GLdouble,
) -> Result<()> {
    box_has_volume([left, right], [bottom, top], [near, far])?;
    let (width, height, depth) = (right - left, top - bottom, far - near);
    multiply(
        context,
        DMat4::from_cols_array_2d(&[
            [2.0 / width, 0.0, 0.0, 0.0],
            [0.0, 2.0 / height, 0.0, 0.0],
            [0.0, 0.0, -2.0 / depth, 0.0],
            [-(right + left) / width, -(top + bottom) / height, -(far + near) / depth, 1.0],
        ]),
    )
}

fn box_has_volume(x: [f64; 2], y: [f64; 2], z: [f64; 2]) -> Result<()> {
    for (axis, [from, to]) in [("left and right", x), ("bottom and top", y), ("near and far", z)] {
        if from == to {
            return invalid_value(SECTION, format!("{axis} must differ; both are {from}"));
        }
    }
    Ok(())
}
