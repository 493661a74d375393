//! `glPixelTransfer` (GL 2.1, section 3.6.3). What it sets is [`crate::pixel::transfer`]; the look-up tables are those of
//! [`super::map`].

use crate::base::constants::*;
use crate::base::error::{Result, invalid_value};
use crate::base::types::*;
use crate::context::Context;
use crate::pixel::transfer::{PARAMETER, Parameter};

const SECTION: &str = "GL 2.1, section 3.6.3";

fn set(context: &mut Context, pname: GLenum, param: f64) -> Result<()> {
    let parameter = PARAMETER.decode("pname", pname)?;
    if param.is_nan() {
        return invalid_value(SECTION, format!("{} must be a number", enum_name(pname)));
    }
    let transfer = &mut context.state.transfer;
    match parameter {
        Parameter::Scale(which) => transfer.linear[usize::from(which)].scale = param as f32,
        Parameter::Bias(which) => transfer.linear[usize::from(which)].bias = param as f32,
        Parameter::MapColor => transfer.map_color = param != 0.0,
        Parameter::MapStencil => transfer.map_stencil = param != 0.0,
        Parameter::IndexShift => transfer.index_shift = param.round() as i32,
        Parameter::IndexOffset => transfer.index_offset = param.round() as i32,
    }
    Ok(())
}

pub(crate) fn pixel_transferi(context: &mut Context, pname: GLenum, param: GLint) -> Result<()> {
    set(context, pname, param.into())
}

pub(crate) fn pixel_transferf(context: &mut Context, pname: GLenum, param: GLfloat) -> Result<()> {
    set(context, pname, param.into())
}
