//! Texture parameters: GL 2.1, section 3.8.4 and tables 3.18, 6.17.

use super::{TARGET, TextureTarget, bound, bound_mut};
use crate::constants::*;
use crate::context::Context;
use crate::env::{lod_bias, signed_to_unit, unit_to_signed};
use crate::error::{Result, Table, invalid_enum, invalid_operation, invalid_value};
use crate::query::put;
use crate::state::fragment::COMPARE;
use crate::state::viewport::unit;
use crate::types::*;
use texunit::sampler::{Compare, DepthMode, Filter, Mipmap, Wrap};

const SECTION: &str = "GL 2.1, section 3.8.4";

const WRAP: Table<Wrap> = Table {
    section: "GL 2.1, table 3.18",
    rows: &[
        (GL_REPEAT, Wrap::Repeat),
        (GL_CLAMP, Wrap::Clamp),
        (GL_CLAMP_TO_EDGE, Wrap::ClampToEdge),
        (GL_CLAMP_TO_BORDER, Wrap::ClampToBorder),
        (GL_MIRRORED_REPEAT, Wrap::MirroredRepeat),
    ],
};

const MIN_FILTER: Table<(Filter, Mipmap)> = Table {
    section: "GL 2.1, table 3.18",
    rows: &[
        (GL_NEAREST, (Filter::Nearest, Mipmap::None)),
        (GL_LINEAR, (Filter::Linear, Mipmap::None)),
        (GL_NEAREST_MIPMAP_NEAREST, (Filter::Nearest, Mipmap::Nearest)),
        (GL_LINEAR_MIPMAP_NEAREST, (Filter::Linear, Mipmap::Nearest)),
        (GL_NEAREST_MIPMAP_LINEAR, (Filter::Nearest, Mipmap::Linear)),
        (GL_LINEAR_MIPMAP_LINEAR, (Filter::Linear, Mipmap::Linear)),
    ],
};

const MAG_FILTER: Table<Filter> = Table {
    section: "GL 2.1, table 3.18",
    rows: &[(GL_NEAREST, Filter::Nearest), (GL_LINEAR, Filter::Linear)],
};

const COMPARE_MODE: Table<bool> = Table {
    section: "GL 2.1, table 3.18",
    rows: &[(GL_NONE, false), (GL_COMPARE_R_TO_TEXTURE, true)],
};

const DEPTH_MODE: Table<DepthMode> = Table {
    section: "GL 2.1, table 3.18",
    rows: &[
        (GL_LUMINANCE, DepthMode::Luminance),
        (GL_INTENSITY, DepthMode::Intensity),
        (GL_ALPHA, DepthMode::Alpha),
    ],
};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Parameter {
    /// Of s, t or r.
    Wrap(u8),
    MinFilter,
    MagFilter,
    BorderColor,
    Priority,
    Resident,
    MinLod,
    MaxLod,
    BaseLevel,
    MaxLevel,
    LodBias,
    DepthMode,
    CompareMode,
    CompareFunc,
    GenerateMipmap,
}

const PARAMETER: Table<Parameter> = Table {
    section: SECTION,
    rows: &[
        (GL_TEXTURE_WRAP_S, Parameter::Wrap(0)),
        (GL_TEXTURE_WRAP_T, Parameter::Wrap(1)),
        (GL_TEXTURE_WRAP_R, Parameter::Wrap(2)),
        (GL_TEXTURE_MIN_FILTER, Parameter::MinFilter),
        (GL_TEXTURE_MAG_FILTER, Parameter::MagFilter),
        (GL_TEXTURE_BORDER_COLOR, Parameter::BorderColor),
        (GL_TEXTURE_PRIORITY, Parameter::Priority),
        (GL_TEXTURE_RESIDENT, Parameter::Resident),
        (GL_TEXTURE_MIN_LOD, Parameter::MinLod),
        (GL_TEXTURE_MAX_LOD, Parameter::MaxLod),
        (GL_TEXTURE_BASE_LEVEL, Parameter::BaseLevel),
        (GL_TEXTURE_MAX_LEVEL, Parameter::MaxLevel),
        (GL_TEXTURE_LOD_BIAS, Parameter::LodBias),
        (GL_DEPTH_TEXTURE_MODE, Parameter::DepthMode),
        (GL_TEXTURE_COMPARE_MODE, Parameter::CompareMode),
        (GL_TEXTURE_COMPARE_FUNC, Parameter::CompareFunc),
        (GL_GENERATE_MIPMAP, Parameter::GenerateMipmap),
    ],
};

fn level_number(pname: GLenum, value: f32) -> Result<u32> {
    if value >= 0.0 {
        Ok(value.round() as u32)
    } else {
        invalid_value(SECTION, format!("{} = {value} must not be negative", enum_name(pname)))
    }
}

/// Sets a parameter of one number.
fn set(
    context: &mut Context,
    target: TextureTarget,
    pname: GLenum,
    parameter: Parameter,
    value: f32,
) -> Result<()> {
    let symbol = crate::env::symbol(value);
    let texture = bound_mut(context, target);
    let sampler = &mut texture.sampler;
    match parameter {
        Parameter::Wrap(axis) => sampler.wrap[usize::from(axis)] = WRAP.decode("param", symbol)?,
        Parameter::MinFilter => {
            (sampler.min, sampler.mipmap) = MIN_FILTER.decode("param", symbol)?;
        }
        Parameter::MagFilter => sampler.mag = MAG_FILTER.decode("param", symbol)?,
        Parameter::Priority => texture.priority = unit(value.into()) as f32,
        Parameter::MinLod => sampler.min_lod = value,
        Parameter::MaxLod => sampler.max_lod = value,
        Parameter::BaseLevel => sampler.base_level = level_number(pname, value)?,
        Parameter::MaxLevel => sampler.max_level = level_number(pname, value)?,
        Parameter::LodBias => sampler.lod_bias = lod_bias(value),
        Parameter::DepthMode => sampler.depth_mode = DEPTH_MODE.decode("param", symbol)?,
        Parameter::CompareMode => {
            let func = texture.compare_func;
            sampler.compare = COMPARE_MODE.decode("param", symbol)?.then_some(func);
        }
        Parameter::CompareFunc => {
            let func = COMPARE.decode("param", symbol)?;
            texture.compare_func = func;
            sampler.compare = sampler.compare.map(|_: Compare| func);
        }
        Parameter::GenerateMipmap => texture.generate_mipmap = value != 0.0,
        Parameter::BorderColor => {
            return invalid_enum(
                SECTION,
                "pname = GL_TEXTURE_BORDER_COLOR has four components: use glTexParameterfv",
            );
        }
        Parameter::Resident => {
            return invalid_enum(SECTION, "pname = GL_TEXTURE_RESIDENT can only be read");
        }
    }
    texture.changed();
    Ok(())
}

fn scalar(context: &mut Context, target: GLenum, pname: GLenum, value: f32) -> Result<()> {
    let target = TARGET.decode("target", target)?;
    set(context, target, pname, PARAMETER.decode("pname", pname)?, value)
}

fn vector(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    values: &[f32],
    color: &[f32],
) -> Result<()> {
    let target = TARGET.decode("target", target)?;
    let parameter = PARAMETER.decode("pname", pname)?;
    let needed = if parameter == Parameter::BorderColor { 4 } else { 1 };
    if values.len() < needed {
        return invalid_operation(
            SECTION,
            format!("params has {} of {needed} values of {}", values.len(), enum_name(pname)),
        );
    }
    match color.first_chunk::<4>() {
        Some(color) if parameter == Parameter::BorderColor => {
            let texture = bound_mut(context, target);
            texture.sampler.border = color.map(|c| unit(c.into()) as f32);
            texture.changed();
            Ok(())
        }
        _ => set(context, target, pname, parameter, values[0]),
    }
}

pub(crate) fn tex_parameteri(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    param: GLint,
) -> Result<()> {
    scalar(context, target, pname, param as f32)
}

pub(crate) fn tex_parameterf(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    param: GLfloat,
) -> Result<()> {
    scalar(context, target, pname, param)
}

pub(crate) fn tex_parameteriv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &[GLint],
) -> Result<()> {
    let values: Vec<f32> = params.iter().take(4).map(|&value| value as f32).collect();
    let color: Vec<f32> = params.iter().take(4).map(|&value| signed_to_unit(value)).collect();
    vector(context, target, pname, &values, &color)
}

pub(crate) fn tex_parameterfv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &[GLfloat],
) -> Result<()> {
    vector(context, target, pname, params, params)
}

/// A parameter as one number.
fn get(context: &Context, target: TextureTarget, parameter: Parameter) -> f32 {
    let texture = bound(context, target);
    let sampler = &texture.sampler;
    let symbol = |value: GLenum| value as f32;
    match parameter {
        Parameter::Wrap(axis) => symbol(WRAP.encode(sampler.wrap[usize::from(axis)])),
        Parameter::MinFilter => symbol(MIN_FILTER.encode((sampler.min, sampler.mipmap))),
        Parameter::MagFilter => symbol(MAG_FILTER.encode(sampler.mag)),
        Parameter::BorderColor => sampler.border[0],
        Parameter::Priority => texture.priority,
        Parameter::Resident => 1.0,
        Parameter::MinLod => sampler.min_lod,
        Parameter::MaxLod => sampler.max_lod,
        Parameter::BaseLevel => sampler.base_level as f32,
        Parameter::MaxLevel => sampler.max_level as f32,
        Parameter::LodBias => sampler.lod_bias,
        Parameter::DepthMode => symbol(DEPTH_MODE.encode(sampler.depth_mode)),
        Parameter::CompareMode => symbol(COMPARE_MODE.encode(sampler.compare.is_some())),
        Parameter::CompareFunc => symbol(COMPARE.encode(texture.compare_func)),
        Parameter::GenerateMipmap => f32::from(u8::from(texture.generate_mipmap)),
    }
}

pub(crate) fn get_tex_parameteriv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let target = TARGET.decode("target", target)?;
    match PARAMETER.decode("pname", pname)? {
        Parameter::BorderColor => {
            put(params, &bound(context, target).sampler.border.map(unit_to_signed))
        }
        parameter => put(params, &[get(context, target, parameter).round() as GLint]),
    }
}

pub(crate) fn get_tex_parameterfv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLfloat],
) -> Result<()> {
    let target = TARGET.decode("target", target)?;
    match PARAMETER.decode("pname", pname)? {
        Parameter::BorderColor => put(params, &bound(context, target).sampler.border),
        parameter => put(params, &[get(context, target, parameter)]),
    }
}
