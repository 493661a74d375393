//! Shader objects: GL 2.1, sections 2.15.1 and 6.1.14.

use crate::base::args::{Strings, TextOut};
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value, not_negative};
use crate::base::memory::out_of_memory;
use crate::base::query_value::put;
use crate::base::types::*;
use crate::context::Context;
use crate::glsl;
use crate::objects::programs::ShaderOrProgram;
use crate::objects::shaders::{STAGE, ShaderObject, c_length, put_text};

const SECTION: &str = "GL 2.1, section 2.15.1";

/// The shader of a name.
pub(crate) fn shader(context: &mut Context, name: GLuint) -> Result<&mut ShaderObject> {
    match context.objects.shared.programs.get_mut(name) {
        Some(ShaderOrProgram::Shader(shader)) => Ok(shader),
        Some(ShaderOrProgram::Program(_)) => {
            invalid_operation(SECTION, format!("shader = {name} is a program, not a shader"))
        }
        None => invalid_value(SECTION, format!("shader = {name} is no shader")),
    }
}

pub(crate) fn create_shader(context: &mut Context, ty: GLenum) -> Result<GLuint> {
    let stage = STAGE.decode("type", ty)?;
    Ok(context.objects.shared.programs.add(ShaderOrProgram::Shader(ShaderObject {
        stage,
        source: String::new(),
        strings: Vec::new(),
        compiled: None,
        log: String::new(),
        attachments: 0,
        doomed: false,
    })))
}

pub(crate) fn delete_shader(context: &mut Context, name: GLuint) -> Result<()> {
    if name != 0 {
        shader(context, name)?.doomed = true;
        context.objects.shared.remove_unattached(name);
    }
    Ok(())
}

pub(crate) fn is_shader(context: &mut Context, name: GLuint) -> Result<bool> {
    Ok(matches!(context.objects.shared.programs.get(name), Some(ShaderOrProgram::Shader(_))))
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
    let (mut source, mut starts) = (String::new(), Vec::new());
    for (index, string) in strings.iter().enumerate() {
        let length = lengths.get(index).and_then(|&length| usize::try_from(length).ok());
        match string.get(..length.unwrap_or(string.len())) {
            Some(part) => {
                // A source that is too long for a u32 does not compile.
                starts.push(u32::try_from(source.len()).unwrap_or(u32::MAX));
                source.try_reserve(part.len()).map_err(out_of_memory(SECTION, "the source"))?;
                source.push_str(part);
            }
            None => {
                return invalid_operation(
                    SECTION,
                    format!("lengths[{index}] does not fit a string of {} bytes", string.len()),
                );
            }
        }
    }
    starts.drain(..starts.len().min(1));
    shader.source = source;
    shader.strings = starts;
    Ok(())
}

pub(crate) fn compile_shader(context: &mut Context, name: GLuint) -> Result<()> {
    let options = context.compiler.clone();
    let shader = shader(context, name)?;
    let compiled = glsl::compile_strings(shader.stage, &shader.source, &shader.strings, &options);
    shader.compiled = compiled.shader;
    shader.log = compiled.log;
    if shader.compiled.is_none() {
        let text = format!("glCompileShader: shader {name} did not compile:\n{}", shader.log);
        context.debug.warn_each_time(text);
    }
    Ok(())
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
