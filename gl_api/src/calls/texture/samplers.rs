//! Sampler objects: `ARB_sampler_objects`, section 3.8.2.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum, invalid_operation, invalid_value};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::context::Context;
use crate::interface::MAX_COMBINED_TEXTURE_IMAGE_UNITS;
use crate::objects::bound::Bound;
use crate::objects::name_table::{Sweep, listed};
use crate::objects::sampler::{
    Answer, SAMPLER_PARAMETER, SamplerParameter, SamplerState, Values, needs_vector,
};
use texunit::sampler::Border;

const SECTION: &str = "ARB_sampler_objects, section 3.8.2";

pub(crate) fn gen_samplers(
    context: &mut Context,
    n: GLsizei,
    samplers: &mut [GLuint],
) -> Result<()> {
    context.objects.shared.samplers.reserve(SECTION, n, samplers)?;
    // Generated names are samplers at once, unlike those of textures.
    for &name in samplers.iter().take(n as usize) {
        context.objects.shared.samplers.create(name, SamplerState::default);
    }
    Ok(())
}

pub(crate) fn create_samplers(
    context: &mut Context,
    n: GLsizei,
    samplers: &mut [GLuint],
) -> Result<()> {
    gen_samplers(context, n, samplers)
}

pub(crate) fn delete_samplers(
    context: &mut Context,
    n: GLsizei,
    samplers: &[GLuint],
) -> Result<()> {
    for &name in listed(SECTION, n, samplers)?.iter().filter(|&&name| name != 0) {
        let gone = context.objects.shared.samplers.hold(name);
        let units = &mut context.state.units;
        for at in 0..units.units.len() {
            if gone != Bound::default() && units.units[at].sampler == gone {
                units.unit_mut(at).sampler.forget(&gone);
            }
        }
        drop(gone);
        context.objects.shared.samplers.remove(name);
    }
    context.objects.shared.sweep(Sweep::Deleted);
    Ok(())
}

pub(crate) fn is_sampler(context: &mut Context, sampler: GLuint) -> Result<bool> {
    Ok(context.objects.shared.samplers.get(sampler).is_some())
}

pub(crate) fn bind_sampler(context: &mut Context, unit: GLuint, sampler: GLuint) -> Result<()> {
    if unit >= u32::from(MAX_COMBINED_TEXTURE_IMAGE_UNITS) {
        return invalid_value(
            SECTION,
            format!(
                "unit = {unit} must be below {MAX_COMBINED_TEXTURE_IMAGE_UNITS}: it is a number, \
                 not GL_TEXTURE0 + i"
            ),
        );
    }
    if sampler != 0 {
        found(context, sampler)?;
    }
    let sampler = context.objects.shared.samplers.hold(sampler);
    let unit = context.state.units.unit_mut(unit as usize);
    if unit.sampler == sampler {
        context.state_changes.no_change();
    } else {
        unit.sampler = sampler;
        context.state_changes.bindings_only();
    }
    Ok(())
}

fn found(context: &mut Context, sampler: GLuint) -> Result<&mut SamplerState> {
    match context.objects.shared.samplers.get_mut(sampler) {
        Some(state) => Ok(state),
        None => {
            invalid_operation(SECTION, format!("sampler = {sampler} was not made by glGenSamplers"))
        }
    }
}

/// A parameter of one number, or `None` for the border colour.
fn parameter(pname: GLenum) -> Result<Option<SamplerParameter>> {
    match (pname, SAMPLER_PARAMETER.get(pname)) {
        (GL_TEXTURE_BORDER_COLOR, _) => Ok(None),
        (_, Some(parameter)) => Ok(Some(parameter)),
        (_, None) => invalid_enum(
            SECTION,
            format!(
                "pname = {} must be GL_TEXTURE_BORDER_COLOR, {}",
                enum_name(pname),
                SAMPLER_PARAMETER.list()
            ),
        ),
    }
}

/// Sets a parameter of one number.
fn set(
    context: &mut Context,
    sampler: GLuint,
    parameter: SamplerParameter,
    value: f64,
) -> Result<()> {
    let profile = context.profile;
    let state = found(context, sampler)?;
    if let Some(symbol) = parameter.symbol(value) {
        profile.check_value("param", symbol)?;
    }
    state.set(None, parameter, value)
}

fn scalar(context: &mut Context, sampler: GLuint, pname: GLenum, value: f64) -> Result<()> {
    found(context, sampler)?;
    match parameter(pname)? {
        Some(parameter) => set(context, sampler, parameter, value),
        None => needs_vector(SECTION, pname, "glSamplerParameter"),
    }
}

fn vector(context: &mut Context, sampler: GLuint, pname: GLenum, values: &Values) -> Result<()> {
    let state = found(context, sampler)?;
    match parameter(pname)? {
        Some(parameter) => set(context, sampler, parameter, values.one(SECTION, pname)?),
        None => {
            state.sampler.border = values.four(SECTION, pname)?;
            Ok(())
        }
    }
}

pub(crate) fn sampler_parameteri(
    context: &mut Context,
    sampler: GLuint,
    pname: GLenum,
    param: GLint,
) -> Result<()> {
    scalar(context, sampler, pname, param.into())
}

pub(crate) fn sampler_parameterf(
    context: &mut Context,
    sampler: GLuint,
    pname: GLenum,
    param: GLfloat,
) -> Result<()> {
    scalar(context, sampler, pname, param.into())
}

pub(crate) fn sampler_parameteriv(
    context: &mut Context,
    sampler: GLuint,
    pname: GLenum,
    params: &[GLint],
) -> Result<()> {
    vector(context, sampler, pname, &Values::fixed(params))
}

pub(crate) fn sampler_parameterfv(
    context: &mut Context,
    sampler: GLuint,
    pname: GLenum,
    params: &[GLfloat],
) -> Result<()> {
    vector(context, sampler, pname, &Values::floats(params))
}

pub(crate) fn sampler_parameter_i_iv(
    context: &mut Context,
    sampler: GLuint,
    pname: GLenum,
    params: &[GLint],
) -> Result<()> {
    vector(context, sampler, pname, &Values::signed(params))
}

pub(crate) fn sampler_parameter_i_uiv(
    context: &mut Context,
    sampler: GLuint,
    pname: GLenum,
    params: &[GLuint],
) -> Result<()> {
    vector(context, sampler, pname, &Values::unsigned(params))
}

/// An answer as fractions are asked for: a border is clamped where fragments are
/// (`ARB_color_buffer_float`, section 6.1.2).
pub(crate) fn clamped(context: &Context, answer: Answer) -> Answer {
    match answer {
        Answer::Color(Border::Float(color)) => Answer::Color(Border::Float(
            crate::draw::color_clamp::of_fragments(context).color(color),
        )),
        Answer::Color(Border::Sint(_) | Border::Uint(_))
        | Answer::Numbers(_)
        | Answer::Fraction(_) => answer,
    }
}

fn query(context: &mut Context, sampler: GLuint, pname: GLenum) -> Result<Answer> {
    let state = found(context, sampler)?;
    Ok(match parameter(pname)? {
        Some(parameter) => Answer::Numbers(vec![state.get(parameter).into()]),
        None => Answer::Color(state.sampler.border),
    })
}

pub(crate) fn get_sampler_parameteriv(
    context: &mut Context,
    sampler: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let answer = query(context, sampler, pname)?;
    put(params, &clamped(context, answer).fixed())
}

pub(crate) fn get_sampler_parameterfv(
    context: &mut Context,
    sampler: GLuint,
    pname: GLenum,
    params: &mut [GLfloat],
) -> Result<()> {
    let answer = query(context, sampler, pname)?;
    put(params, &clamped(context, answer).floats())
}

pub(crate) fn get_sampler_parameter_i_iv(
    context: &mut Context,
    sampler: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    put(params, &query(context, sampler, pname)?.signed())
}

pub(crate) fn get_sampler_parameter_i_uiv(
    context: &mut Context,
    sampler: GLuint,
    pname: GLenum,
    params: &mut [GLuint],
) -> Result<()> {
    put(params, &query(context, sampler, pname)?.unsigned())
}
