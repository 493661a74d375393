//! `glTexParameter` and its queries: GL 2.1, section 3.8.4 and tables 3.18, 6.17.

use crate::base::constants::*;
use crate::base::convert::{symbol, unit};
use crate::base::error::{Result, Table, invalid_enum, invalid_operation, invalid_value, must_be};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::texture::bound::{ChosenTexture, bindable};
use crate::calls::texture::read_only::{READ_ONLY, ReadOnly};
use crate::calls::texture::samplers::clamped;
use crate::context::Context;
use crate::objects::sampler::{
    Answer, SAMPLER_PARAMETER, SamplerParameter, SamplerState, Values, needs_vector,
};
use crate::objects::target::{TARGET, TextureTarget};
use crate::objects::texture::{DepthStencilMode, Texture};
use texunit::sampler::{DepthMode, Swizzle};

const SECTION: &str = "GL 2.1, section 3.8.4";

const DEPTH_MODE: Table<DepthMode> = Table {
    section: "GL 2.1, table 3.18",
    rows: &[
        (GL_LUMINANCE, DepthMode::Luminance),
        (GL_INTENSITY, DepthMode::Intensity),
        (GL_ALPHA, DepthMode::Alpha),
        (GL_RED, DepthMode::Red),
    ],
};

const SWIZZLE: Table<Swizzle> = Table {
    section: "EXT_texture_swizzle, section 3.8.4",
    rows: &[
        (GL_RED, Swizzle::Red),
        (GL_GREEN, Swizzle::Green),
        (GL_BLUE, Swizzle::Blue),
        (GL_ALPHA, Swizzle::Alpha),
        (GL_ZERO, Swizzle::Zero),
        (GL_ONE, Swizzle::One),
    ],
};

const DEPTH_STENCIL_MODE: Table<DepthStencilMode> = Table {
    section: "ARB_stencil_texturing, section 3.9.X",
    rows: &[
        (GL_DEPTH_COMPONENT, DepthStencilMode::Depth),
        (GL_STENCIL_INDEX, DepthStencilMode::Stencil),
    ],
};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Parameter {
    Sampler(SamplerParameter),
    BorderColor,
    Priority,
    ReadOnly(ReadOnly),
    BaseLevel,
    MaxLevel,
    DepthMode,
    DepthStencilMode,
    GenerateMipmap,
    /// Of one component.
    Swizzle(u8),
    /// Of all four.
    Swizzles,
}

/// Those that sampler objects have not.
const PARAMETER: Table<Parameter> = Table {
    section: SECTION,
    rows: &[
        (GL_TEXTURE_BORDER_COLOR, Parameter::BorderColor),
        (GL_TEXTURE_PRIORITY, Parameter::Priority),
        (GL_TEXTURE_BASE_LEVEL, Parameter::BaseLevel),
        (GL_TEXTURE_MAX_LEVEL, Parameter::MaxLevel),
        (GL_DEPTH_TEXTURE_MODE, Parameter::DepthMode),
        (GL_DEPTH_STENCIL_TEXTURE_MODE, Parameter::DepthStencilMode),
        (GL_GENERATE_MIPMAP, Parameter::GenerateMipmap),
        (GL_TEXTURE_SWIZZLE_R, Parameter::Swizzle(0)),
        (GL_TEXTURE_SWIZZLE_G, Parameter::Swizzle(1)),
        (GL_TEXTURE_SWIZZLE_B, Parameter::Swizzle(2)),
        (GL_TEXTURE_SWIZZLE_A, Parameter::Swizzle(3)),
        (GL_TEXTURE_SWIZZLE_RGBA, Parameter::Swizzles),
    ],
};

fn parameter(pname: GLenum) -> Result<Parameter> {
    if let Some(parameter) = SAMPLER_PARAMETER.get(pname) {
        return Ok(Parameter::Sampler(parameter));
    }
    match PARAMETER.get(pname).or(READ_ONLY.get(pname).map(Parameter::ReadOnly)) {
        Some(parameter) => Ok(parameter),
        None => {
            let all = [SAMPLER_PARAMETER.values(), PARAMETER.values(), READ_ONLY.values()];
            let rule = format!("pname = {} {}", enum_name(pname), must_be(pname, &all.concat()));
            invalid_enum(SECTION, rule)
        }
    }
}

/// A level's number: an integer, to which floats are rounded before it is checked.
fn level_number(target: TextureTarget, pname: GLenum, number: f64) -> Result<u32> {
    let name = enum_name(pname);
    let (value, level) = (number as f32, number.round());
    if level.is_nan() || level < 0.0 {
        return invalid_value(SECTION, format!("{name} = {value} must not be negative"));
    }
    if target.levels() == 1 && pname == GL_TEXTURE_BASE_LEVEL && level != 0.0 {
        let target = enum_name(TARGET.encode(target));
        return invalid_operation(
            "GL 3.3, section 3.8.7",
            format!("{name} = {value} of {target} must be 0"),
        );
    }
    // The state is an integer with a sign.
    Ok(level.min(GLint::MAX.into()) as u32)
}

/// The texture that is bound to a target.
fn bound(context: &Context, target: GLenum) -> Result<ChosenTexture> {
    Ok(ChosenTexture::bound(context, bindable(context.profile).decode("target", target)?))
}

/// Refuses textures that have no parameters: those of buffers.
fn check_target(texture: &ChosenTexture) -> Result<()> {
    if texture.target == TextureTarget::Buffer {
        return texture.wrong_target(
            "GL 3.1, section 3.8.5",
            "has no parameters: the texels of a buffer are fetched",
        );
    }
    Ok(())
}

/// A parameter that a texture has: where there are several samples a texel, nothing is filtered, wrapped or compared.
fn parameter_of(texture: &ChosenTexture, pname: GLenum) -> Result<Parameter> {
    let parameter = parameter(pname)?;
    let is_samplers = matches!(parameter, Parameter::Sampler(_) | Parameter::BorderColor);
    if is_samplers && texture.target.is_multisample() {
        return texture.wrong_target(
            "ARB_texture_storage_multisample, section 3.8.8",
            &format!("has nothing of samplers, as pname = {} is", enum_name(pname)),
        );
    }
    Ok(parameter)
}

/// What `glTexParameter` sets.
#[derive(Clone, Debug, PartialEq)]
struct Parameters {
    state: SamplerState,
    priority: f32,
    depth_stencil: DepthStencilMode,
    generate_mipmap: bool,
}

impl Parameters {
    fn of(texture: &Texture) -> Self {
        let &Texture { ref state, priority, depth_stencil, generate_mipmap, .. } = texture;
        Self { state: state.clone(), priority, depth_stencil, generate_mipmap }
    }

    /// Makes these the parameters of a texture. What is set again leaves vertices pending.
    fn set(self, context: &mut Context, texture: &ChosenTexture) {
        if self == Self::of(texture.get(context)) {
            context.state_changes.no_change();
            return;
        }
        context.leave_plain_state();
        let texture = texture.get_mut(context);
        if texture.depth_stencil != self.depth_stencil {
            texture.changed();
        }
        let Self { state, priority, depth_stencil, generate_mipmap } = self;
        (texture.state, texture.priority) = (state, priority);
        (texture.depth_stencil, texture.generate_mipmap) = (depth_stencil, generate_mipmap);
    }
}

/// Sets a parameter of one number.
fn set(
    context: &mut Context,
    chosen: &ChosenTexture,
    pname: GLenum,
    parameter: Parameter,
    values: &Values,
) -> Result<()> {
    let value = values.one(SECTION, pname)?;
    let symbol = symbol(value as f32);
    let target = chosen.target;
    if let Parameter::Sampler(parameter) = parameter
        && let Some(symbol) = parameter.symbol(value)
    {
        context.profile.check_value("param", symbol)?;
    }
    let mut new = Parameters::of(chosen.get(context));
    let sampler = &mut new.state.sampler;
    match parameter {
        Parameter::Sampler(parameter) => new.state.set(Some(target), parameter, value)?,
        Parameter::Priority => {
            new.priority = unit(values.fraction(SECTION, pname)?.into()) as f32;
        }
        Parameter::BaseLevel => sampler.base_level = level_number(target, pname, value)?,
        Parameter::MaxLevel => sampler.max_level = level_number(target, pname, value)?,
        Parameter::DepthMode => sampler.depth_mode = DEPTH_MODE.decode("param", symbol)?,
        Parameter::DepthStencilMode => {
            new.depth_stencil = DEPTH_STENCIL_MODE.decode("param", symbol)?;
        }
        Parameter::GenerateMipmap => new.generate_mipmap = value != 0.0,
        Parameter::Swizzle(component) => {
            sampler.swizzle[usize::from(component)] = SWIZZLE.decode("param", symbol)?;
        }
        Parameter::BorderColor | Parameter::Swizzles => {
            return needs_vector(SECTION, pname, "glTexParameter");
        }
        Parameter::ReadOnly(_) => {
            return invalid_enum(SECTION, format!("pname = {} can only be read", enum_name(pname)));
        }
    }
    new.set(context, chosen);
    Ok(())
}

/// Sets a parameter that is one number.
pub(crate) fn scalar(
    context: &mut Context,
    texture: &ChosenTexture,
    pname: GLenum,
    value: &Values,
) -> Result<()> {
    check_target(texture)?;
    set(context, texture, pname, parameter_of(texture, pname)?, value)
}

/// Sets a parameter that may be several numbers.
pub(crate) fn vector(
    context: &mut Context,
    texture: &ChosenTexture,
    pname: GLenum,
    values: &Values,
) -> Result<()> {
    check_target(texture)?;
    let parameter = parameter_of(texture, pname)?;
    let mut new = Parameters::of(texture.get(context));
    match parameter {
        Parameter::BorderColor => new.state.sampler.border = values.four(SECTION, pname)?,
        Parameter::Swizzles => {
            values.four(SECTION, pname)?;
            let mut swizzle = Swizzle::IDENTITY;
            for (component, &value) in swizzle.iter_mut().zip(&values.plain()) {
                *component = SWIZZLE.decode("params", symbol(value as f32))?;
            }
            new.state.sampler.swizzle = swizzle;
        }
        Parameter::Sampler(_)
        | Parameter::Priority
        | Parameter::ReadOnly(_)
        | Parameter::BaseLevel
        | Parameter::MaxLevel
        | Parameter::DepthMode
        | Parameter::DepthStencilMode
        | Parameter::GenerateMipmap
        | Parameter::Swizzle(_) => {
            return set(context, texture, pname, parameter, values);
        }
    }
    new.set(context, texture);
    Ok(())
}

pub(crate) fn tex_parameteri(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    param: GLint,
) -> Result<()> {
    let texture = bound(context, target)?;
    scalar(context, &texture, pname, &Values::fixed(&[param]))
}

pub(crate) fn tex_parameterf(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    param: GLfloat,
) -> Result<()> {
    let texture = bound(context, target)?;
    scalar(context, &texture, pname, &Values::floats(&[param]))
}

pub(crate) fn tex_parameteriv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &[GLint],
) -> Result<()> {
    let texture = bound(context, target)?;
    vector(context, &texture, pname, &Values::fixed(params))
}

pub(crate) fn tex_parameterfv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &[GLfloat],
) -> Result<()> {
    let texture = bound(context, target)?;
    vector(context, &texture, pname, &Values::floats(params))
}

pub(crate) fn tex_parameter_i_iv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &[GLint],
) -> Result<()> {
    let texture = bound(context, target)?;
    vector(context, &texture, pname, &Values::signed(params))
}

pub(crate) fn tex_parameter_i_uiv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &[GLuint],
) -> Result<()> {
    let texture = bound(context, target)?;
    vector(context, &texture, pname, &Values::unsigned(params))
}

fn get(texture: &Texture, parameter: Parameter) -> Answer {
    let sampler = &texture.state.sampler;
    let one = match parameter {
        Parameter::BorderColor => return Answer::Color(sampler.border),
        Parameter::Swizzles => {
            let names = sampler.swizzle.iter().map(|&from| SWIZZLE.encode(from).into());
            return Answer::Numbers(names.collect());
        }
        Parameter::Sampler(parameter) => texture.state.get(parameter).into(),
        Parameter::Priority => return Answer::Fraction(texture.priority),
        Parameter::ReadOnly(read) => read.of(texture).into(),
        // Bounded by the levels of immutable storage (ARB_texture_storage, section 3.8.X).
        Parameter::BaseLevel => texture.sampler().base_level.into(),
        Parameter::MaxLevel => sampler.max_level.into(),
        Parameter::DepthMode => DEPTH_MODE.encode(sampler.depth_mode).into(),
        Parameter::DepthStencilMode => DEPTH_STENCIL_MODE.encode(texture.depth_stencil).into(),
        Parameter::GenerateMipmap => f64::from(u8::from(texture.generate_mipmap)),
        Parameter::Swizzle(at) => SWIZZLE.encode(sampler.swizzle[usize::from(at)]).into(),
    };
    Answer::Numbers(vec![one])
}

fn query(context: &Context, target: GLenum, pname: GLenum) -> Result<Answer> {
    query_of(context, &bound(context, target)?, pname)
}

/// What a parameter of a texture is.
pub(crate) fn query_of(
    context: &Context,
    texture: &ChosenTexture,
    pname: GLenum,
) -> Result<Answer> {
    check_target(texture)?;
    Ok(get(texture.get(context), parameter(pname)?))
}

pub(crate) fn get_tex_parameteriv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    put(params, &clamped(context, query(context, target, pname)?).fixed())
}

pub(crate) fn get_tex_parameterfv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLfloat],
) -> Result<()> {
    put(params, &clamped(context, query(context, target, pname)?).floats())
}

pub(crate) fn get_tex_parameter_i_iv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    put(params, &query(context, target, pname)?.signed())
}

pub(crate) fn get_tex_parameter_i_uiv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLuint],
) -> Result<()> {
    put(params, &query(context, target, pname)?.unsigned())
}
