//! Parameters of textures that calls name: `ARB_direct_state_access`, sections 8.10 and 8.11.2.

use crate::base::error::Result;
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::texture::bound::ChosenTexture;
use crate::calls::texture::parameter::{query_of, scalar, vector};
use crate::calls::texture::samplers::clamped;
use crate::context::Context;
use crate::objects::sampler::{Answer, Values};

fn set(context: &mut Context, name: GLuint, pname: GLenum, value: &Values) -> Result<()> {
    let texture = ChosenTexture::named(context, name)?;
    scalar(context, &texture, pname, value)
}

fn set_vector(context: &mut Context, name: GLuint, pname: GLenum, values: &Values) -> Result<()> {
    let texture = ChosenTexture::named(context, name)?;
    vector(context, &texture, pname, values)
}

fn query(context: &mut Context, name: GLuint, pname: GLenum) -> Result<Answer> {
    let texture = ChosenTexture::named(context, name)?;
    query_of(context, &texture, pname)
}

pub(crate) fn texture_parameteri(
    context: &mut Context,
    texture: GLuint,
    pname: GLenum,
    param: GLint,
) -> Result<()> {
    set(context, texture, pname, &Values::fixed(&[param]))
}

pub(crate) fn texture_parameterf(
    context: &mut Context,
    texture: GLuint,
    pname: GLenum,
    param: GLfloat,
) -> Result<()> {
    set(context, texture, pname, &Values::floats(&[param]))
}

pub(crate) fn texture_parameteriv(
    context: &mut Context,
    texture: GLuint,
    pname: GLenum,
    params: &[GLint],
) -> Result<()> {
    set_vector(context, texture, pname, &Values::fixed(params))
}

pub(crate) fn texture_parameterfv(
    context: &mut Context,
    texture: GLuint,
    pname: GLenum,
    params: &[GLfloat],
) -> Result<()> {
    set_vector(context, texture, pname, &Values::floats(params))
}

pub(crate) fn texture_parameter_i_iv(
    context: &mut Context,
    texture: GLuint,
    pname: GLenum,
    params: &[GLint],
) -> Result<()> {
    set_vector(context, texture, pname, &Values::signed(params))
}

pub(crate) fn texture_parameter_i_uiv(
    context: &mut Context,
    texture: GLuint,
    pname: GLenum,
    params: &[GLuint],
) -> Result<()> {
    set_vector(context, texture, pname, &Values::unsigned(params))
}

pub(crate) fn get_texture_parameteriv(
    context: &mut Context,
    texture: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let answer = query(context, texture, pname)?;
    put(params, &clamped(context, answer).fixed())
}

pub(crate) fn get_texture_parameterfv(
    context: &mut Context,
    texture: GLuint,
    pname: GLenum,
    params: &mut [GLfloat],
) -> Result<()> {
    let answer = query(context, texture, pname)?;
    put(params, &clamped(context, answer).floats())
}

pub(crate) fn get_texture_parameter_i_iv(
    context: &mut Context,
    texture: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    put(params, &query(context, texture, pname)?.signed())
}

pub(crate) fn get_texture_parameter_i_uiv(
    context: &mut Context,
    texture: GLuint,
    pname: GLenum,
    params: &mut [GLuint],
) -> Result<()> {
    put(params, &query(context, texture, pname)?.unsigned())
}
