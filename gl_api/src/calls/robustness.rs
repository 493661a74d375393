//! The calls of `KHR_robustness`: graphics resets, and reads with a bounded destination.

use crate::base::args::DataOut;
use crate::base::constants::*;
use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::calls::program::uniform_values;
use crate::context::Context;
use crate::context::reset::ResetStatus;

const SECTION: &str = "KHR_robustness";

/// What was recorded is executed, so that a draw of a moment ago counts.
pub(crate) fn get_graphics_reset_status(context: &mut Context) -> Result<GLenum> {
    crate::draw::pass::submit_unlocked(context);
    let status = std::mem::replace(&mut context.resets.status, ResetStatus::NoError);
    Ok(match status {
        ResetStatus::NoError => GL_NO_ERROR,
        ResetStatus::Guilty => {
            crate::draw::pass::end_of_frame(context);
            GL_GUILTY_CONTEXT_RESET
        }
    })
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn readn_pixels(
    context: &mut Context,
    x: GLint,
    y: GLint,
    width: GLsizei,
    height: GLsizei,
    format: GLenum,
    ty: GLenum,
    buf_size: GLsizei,
    data: DataOut<'_>,
) -> Result<()> {
    let size = [width, height];
    let request = crate::calls::framebuffer::read::request(context, [x, y], size, (format, ty))?;
    check_size(request.needed(), buf_size)?;
    request.apply(context, data)
}

/// The first values of `params`, as many as `buf_size` bytes hold.
fn destination<T>(params: &mut [T], needed: usize, buf_size: GLsizei) -> Result<&mut [T]> {
    check_size(needed * size_of::<T>(), buf_size)?;
    Ok(params)
}

fn check_size(needed: usize, buf_size: GLsizei) -> Result<()> {
    if usize::try_from(buf_size).is_ok_and(|size| needed <= size) {
        return Ok(());
    }
    invalid_operation(SECTION, format!("bufSize = {buf_size}, but {needed} bytes are needed"))
}

pub(crate) fn getn_uniformfv(
    context: &mut Context,
    program: GLuint,
    location: GLint,
    buf_size: GLsizei,
    params: &mut [GLfloat],
) -> Result<()> {
    let needed = uniform_values::uniform_words(context, program, location)?;
    uniform_values::get_uniformfv(
        context,
        program,
        location,
        destination(params, needed, buf_size)?,
    )
}

pub(crate) fn getn_uniformiv(
    context: &mut Context,
    program: GLuint,
    location: GLint,
    buf_size: GLsizei,
    params: &mut [GLint],
) -> Result<()> {
    let needed = uniform_values::uniform_words(context, program, location)?;
    uniform_values::get_uniformiv(
        context,
        program,
        location,
        destination(params, needed, buf_size)?,
    )
}

pub(crate) fn getn_uniformuiv(
    context: &mut Context,
    program: GLuint,
    location: GLint,
    buf_size: GLsizei,
    params: &mut [GLuint],
) -> Result<()> {
    let needed = uniform_values::uniform_words(context, program, location)?;
    uniform_values::get_uniformuiv(
        context,
        program,
        location,
        destination(params, needed, buf_size)?,
    )
}
