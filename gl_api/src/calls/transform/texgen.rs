//! Generation of texture coordinates: GL 2.1, section 2.11.4.

use crate::base::constants::*;
use crate::base::error::{Result, Table};
use crate::base::params::Params;
use crate::base::query_value::{QueryValue, put_doubles, symbol};
use crate::base::types::*;
use crate::calls::parameter_forms::{parameter_calls, parameter_queries};
use crate::calls::transform::clip::eye_plane;
use crate::context::Context;
use crate::interface::TexCoord;
use crate::state::texture_units::texgen::GenMode;
use glam::DVec4;

const SECTION: &str = "GL 2.1, section 2.11.4";

const COORD: Table<TexCoord> = Table {
    section: SECTION,
    rows: &[(GL_S, TexCoord::S), (GL_T, TexCoord::T), (GL_R, TexCoord::R), (GL_Q, TexCoord::Q)],
};

const MODES: &[(GLenum, GenMode)] = &[
    (GL_OBJECT_LINEAR, GenMode::ObjectLinear),
    (GL_EYE_LINEAR, GenMode::EyeLinear),
    (GL_REFLECTION_MAP, GenMode::ReflectionMap),
    (GL_NORMAL_MAP, GenMode::NormalMap),
    (GL_SPHERE_MAP, GenMode::SphereMap),
];

/// The modes of a coordinate: maps have no q, and a sphere map no r.
fn modes(coord: TexCoord) -> Table<GenMode> {
    let rows = match coord {
        TexCoord::S | TexCoord::T => MODES,
        TexCoord::R => &MODES[..4],
        TexCoord::Q => &MODES[..2],
    };
    Table { section: SECTION, rows }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Parameter {
    Mode,
    ObjectPlane,
    EyePlane,
}

const PARAMETER: Table<Parameter> = Table {
    section: SECTION,
    rows: &[
        (GL_TEXTURE_GEN_MODE, Parameter::Mode),
        (GL_OBJECT_PLANE, Parameter::ObjectPlane),
        (GL_EYE_PLANE, Parameter::EyePlane),
    ],
};

fn set_tex_gen(context: &mut Context, coord: GLenum, pname: GLenum, params: &Params) -> Result<()> {
    context.state.units.active_coordinates(SECTION)?;
    let coord = COORD.decode("coord", coord)?;
    let parameter = PARAMETER.decode("pname", pname)?;
    params.need(SECTION, pname, if parameter == Parameter::Mode { 1 } else { 4 })?;
    let plane = DVec4::from(params.point());
    let in_eye = eye_plane(context, plane);
    let generate = &mut context.state.units.active_mut().generate[coord as usize];
    match parameter {
        Parameter::Mode => generate.mode = modes(coord).decode("param", params.symbol())?,
        Parameter::ObjectPlane => generate.object_plane = plane,
        Parameter::EyePlane => generate.eye_plane = in_eye,
    }
    Ok(())
}

parameter_calls!(set_tex_gen(coord, pname): tex_genf, tex_geni, tex_genfv, tex_geniv);

pub(crate) fn tex_gend(
    context: &mut Context,
    coord: GLenum,
    pname: GLenum,
    param: GLdouble,
) -> Result<()> {
    set_tex_gen(context, coord, pname, &Params::scalar(param))
}

pub(crate) fn tex_gendv(
    context: &mut Context,
    coord: GLenum,
    pname: GLenum,
    params: &[GLdouble],
) -> Result<()> {
    set_tex_gen(context, coord, pname, &Params::vector(params))
}

fn get_tex_gen(context: &Context, coord: GLenum, pname: GLenum) -> Result<QueryValue> {
    context.state.units.active_coordinates(SECTION)?;
    let coord = COORD.decode("coord", coord)?;
    let generate = &context.state.units.active().generate[coord as usize];
    match PARAMETER.decode("pname", pname)? {
        Parameter::Mode => symbol(modes(coord).encode(generate.mode)),
        Parameter::ObjectPlane => Ok(QueryValue::Floats(generate.object_plane.to_array().to_vec())),
        Parameter::EyePlane => Ok(QueryValue::Floats(generate.eye_plane.to_array().to_vec())),
    }
}

parameter_queries!(get_tex_gen(coord, pname): get_tex_genfv, get_tex_geniv);

pub(crate) fn get_tex_gendv(
    context: &mut Context,
    coord: GLenum,
    pname: GLenum,
    params: &mut [GLdouble],
) -> Result<()> {
    put_doubles(params, get_tex_gen(context, coord, pname)?)
}
