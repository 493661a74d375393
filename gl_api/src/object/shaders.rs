//! Shader objects: GL 2.1, sections 2.15.1 and 6.1.14.

use super::Objects;
use super::programs::ShaderOrProgram;
use crate::constants::*;
use crate::context::Context;
use crate::entry::{Strings, TextOut};
use crate::error::{Result, Table, invalid_operation, invalid_value, not_negative};
use crate::glsl;
use crate::query::put;
use crate::types::*;

const SECTION: &str = "GL 2.1, section 2.15.1";

/// A shader object.
#[derive(Debug)]
pub(crate) struct ShaderObject {
    pub stage: glsl::Stage,
    pub source: String,
    /// The result of the last successful compilation.
    pub compiled: Option<glsl::Shader>,
    pub log: String,
    /// How many programs it is attached to.
    pub attachments: usize,
    /// Whether it goes when the last program lets go of it.
    pub doomed: bool,
}

pub(crate) const STAGE: Table<glsl::Stage> = Table {
    section: SECTION,
    rows: &[(GL_VERTEX_SHADER, glsl::Stage::Vertex), (GL_FRAGMENT_SHADER, glsl::Stage::Fragment)],
};

/// The shader of a name.
pub(crate) fn shader(context: &mut Context, name: GLuint) -> Result<&mut ShaderObject> {
    match context.objects.programs.get_mut(name) {
        Some(ShaderOrProgram::Shader(shader)) => Ok(shader),
        Some(ShaderOrProgram::Program(_)) => {
            invalid_operation(SECTION, format!("shader = {name} is a program, not a shader"))
        }
        None => invalid_value(SECTION, format!("shader = {name} is no shader")),
    }
}

pub(crate) fn create_shader(context: &mut Context, ty: GLenum) -> Result<GLuint> {
    let stage = STAGE.decode("type", ty)?;
    Ok(context.objects.programs.add(ShaderOrProgram::Shader(ShaderObject {
        stage,
        source: String::new(),
        compiled: None,
        log: String::new(),
        attachments: 0,
        doomed: false,
    })))
}

pub(crate) fn delete_shader(context: &mut Context, name: GLuint) -> Result<()> {
    if name != 0 {
        shader(context, name)?.doomed = true;
        forget_if_doomed(&mut context.objects, name);
    }
    Ok(())
}

/// Removes a shader that was deleted, once no program holds it.
pub(super) fn forget_if_doomed(objects: &mut Objects, name: GLuint) {
    if let Some(ShaderOrProgram::Shader(shader)) = objects.programs.get(name)
        && shader.doomed
        && shader.attachments == 0
    {
        objects.programs.remove(name);
    }
}

pub(crate) fn is_shader(context: &mut Context, name: GLuint) -> Result<bool> {
    Ok(matches!(context.objects.programs.get(name), Some(ShaderOrProgram::Shader(_))))
}

/// A length that is missing or negative means: to the end.
pub(crate) fn shader_source(
    context: &mut Context,
    name: GLuint,
    count: GLsizei,
    strings: Strings<'_>,
    lengths: &[GLint],
) -> Result<()> {
    let count = not_negative(SECTION, "count", count.into())?;
    let shader = shader(context, name)?;
    let Some(strings) = strings.0.get(..count) else {
        let has = strings.0.len();
        return invalid_operation(SECTION, format!("count = {count}, but there are {has} strings"));
    };
    let mut source = String::new();
    for (index, string) in strings.iter().enumerate() {
        let length = lengths.get(index).and_then(|&length| usize::try_from(length).ok());
        match string.get(..length.unwrap_or(string.len())) {
            Some(part) => source.push_str(part),
            None => {
                return invalid_operation(
                    SECTION,
                    format!("lengths[{index}] does not fit a string of {} bytes", string.len()),
                );
            }
        }
    }
    shader.source = source;
    Ok(())
}

pub(crate) fn compile_shader(context: &mut Context, name: GLuint) -> Result<()> {
    let options = glsl::Options { fix_its: context.fix_its };
    let shader = shader(context, name)?;
    let compiled = glsl::compile(shader.stage, &shader.source, &options);
    shader.compiled = compiled.shader;
    shader.log = compiled.log;
    if shader.compiled.is_none() {
        let text = format!("glCompileShader: shader {name} did not compile:\n{}", shader.log);
        context.debug.say(text);
    }
    Ok(())
}

/// The length of a text with C's final zero; 0 for none.
pub(crate) fn c_length(text: &str) -> GLint {
    if text.is_empty() { 0 } else { GLint::try_from(text.len() + 1).unwrap_or(GLint::MAX) }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Type,
    Deleted,
    Compiled,
    LogLength,
    SourceLength,
}

pub(crate) fn get_shaderiv(
    context: &mut Context,
    name: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    const PROPERTY: Table<Property> = Table {
        section: "GL 2.1, section 6.1.14",
        rows: &[
            (GL_SHADER_TYPE, Property::Type),
            (GL_DELETE_STATUS, Property::Deleted),
            (GL_COMPILE_STATUS, Property::Compiled),
            (GL_INFO_LOG_LENGTH, Property::LogLength),
            (GL_SHADER_SOURCE_LENGTH, Property::SourceLength),
        ],
    };
    let shader = shader(context, name)?;
    let value = match PROPERTY.decode("pname", pname)? {
        Property::Type => STAGE.encode(shader.stage) as GLint,
        Property::Deleted => shader.doomed.into(),
        Property::Compiled => shader.compiled.is_some().into(),
        Property::LogLength => c_length(&shader.log),
        Property::SourceLength => c_length(&shader.source),
    };
    put(params, &[value])
}

/// Writes text and its length as `glGet…InfoLog` and others do.
pub(crate) fn put_text(
    text: &str,
    max_length: GLsizei,
    length: &mut [GLsizei],
    out: TextOut<'_>,
) -> Result<()> {
    let limit = not_negative("GL 2.1, section 6.1.14", "maxLength", max_length.into())?;
    let written = out.write(text, limit);
    if let Some(length) = length.first_mut() {
        *length = written as GLsizei;
    }
    Ok(())
}

pub(crate) fn get_shader_info_log(
    context: &mut Context,
    name: GLuint,
    max_length: GLsizei,
    length: &mut [GLsizei],
    info_log: TextOut<'_>,
) -> Result<()> {
    put_text(&shader(context, name)?.log, max_length, length, info_log)
}

pub(crate) fn get_shader_source(
    context: &mut Context,
    name: GLuint,
    max_length: GLsizei,
    length: &mut [GLsizei],
    source: TextOut<'_>,
) -> Result<()> {
    put_text(&shader(context, name)?.source, max_length, length, source)
}
