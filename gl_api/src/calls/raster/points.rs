//! The calls of points and point sprites: GL 2.1, section 3.3.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum, invalid_operation, invalid_value};
use crate::base::types::*;
use crate::context::Context;
use crate::state::points::ORIGIN;
use crate::state::raster::positive;

const SECTION: &str = "GL 2.1, section 3.3";

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Parameter {
    SizeMin,
    SizeMax,
    Fade,
    Attenuation,
    Origin,
}

const PARAMETER: Table<Parameter> = Table {
    section: SECTION,
    rows: &[
        (GL_POINT_SIZE_MIN, Parameter::SizeMin),
        (GL_POINT_SIZE_MAX, Parameter::SizeMax),
        (GL_POINT_FADE_THRESHOLD_SIZE, Parameter::Fade),
        (GL_POINT_DISTANCE_ATTENUATION, Parameter::Attenuation),
        (GL_POINT_SPRITE_COORD_ORIGIN, Parameter::Origin),
    ],
};

pub(crate) fn point_size(context: &mut Context, size: GLfloat) -> Result<()> {
    context.state.raster.points.size = positive(SECTION, "size", size)?;
    Ok(())
}

fn not_below_zero(pname: GLenum, value: f32) -> Result<f32> {
    if value >= 0.0 {
        return Ok(value);
    }
    invalid_value(SECTION, format!("{} = {value} must not be negative", enum_name(pname)))
}

fn set(context: &mut Context, pname: GLenum, values: &[f32]) -> Result<()> {
    let parameter = PARAMETER.decode("pname", pname)?;
    let needed = if parameter == Parameter::Attenuation { 3 } else { 1 };
    if values.len() < needed {
        return invalid_operation(
            SECTION,
            format!("params has {} of {needed} values of {}", values.len(), enum_name(pname)),
        );
    }
    let points = &mut context.state.raster.points;
    match parameter {
        Parameter::SizeMin => points.size_min = not_below_zero(pname, values[0])?,
        Parameter::SizeMax => points.size_max = not_below_zero(pname, values[0])?,
        Parameter::Fade => points.fade = not_below_zero(pname, values[0])?,
        Parameter::Attenuation => {
            for &value in &values[..3] {
                not_below_zero(pname, value)?;
            }
            points.attenuation.copy_from_slice(&values[..3]);
        }
        Parameter::Origin => {
            points.origin = ORIGIN.decode("param", crate::base::convert::symbol(values[0]))?;
        }
    }
    Ok(())
}

fn set_scalar(context: &mut Context, pname: GLenum, value: f32) -> Result<()> {
    if PARAMETER.decode("pname", pname)? == Parameter::Attenuation {
        return invalid_enum(
            SECTION,
            "pname = GL_POINT_DISTANCE_ATTENUATION has three values: use glPointParameterfv",
        );
    }
    set(context, pname, &[value])
}

pub(crate) fn point_parameterf(context: &mut Context, pname: GLenum, param: f32) -> Result<()> {
    set_scalar(context, pname, param)
}

pub(crate) fn point_parameteri(context: &mut Context, pname: GLenum, param: GLint) -> Result<()> {
    set_scalar(context, pname, param as f32)
}

pub(crate) fn point_parameterfv(
    context: &mut Context,
    pname: GLenum,
    params: &[GLfloat],
) -> Result<()> {
    set(context, pname, params)
}

pub(crate) fn point_parameteriv(
    context: &mut Context,
    pname: GLenum,
    params: &[GLint],
) -> Result<()> {
    let values: Vec<f32> = params.iter().map(|&value| value as f32).collect();
    set(context, pname, &values)
}
