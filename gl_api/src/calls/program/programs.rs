//! Program objects: GL 2.1, section 2.15.2.

use crate::base::error::{Result, invalid_operation, invalid_value};
use crate::base::limits;
use crate::base::types::*;
use crate::calls::program::shaders::shader;
use crate::calls::transform_feedback::{not_while_active, not_while_begun};
use crate::context::Context;
use crate::generate::executable::executable;
use crate::glsl;
use crate::glsl::FragmentColor;
use crate::interface::MAX_VERTEX_ATTRIBS;
use crate::objects::name_table::Sweep;
use crate::objects::programs::{LinkSources, LinkStatus, ProgramObject, ShaderOrProgram};
use crate::objects::shared::SharedObjects;
use std::sync::Arc;

const SECTION: &str = "GL 2.1, section 2.15.2";

/// The program of a name.
pub(crate) fn program(context: &mut Context, name: GLuint) -> Result<&mut ProgramObject> {
    match context.objects.shared.programs.get_mut(name) {
        Some(ShaderOrProgram::Program(program)) => Ok(program),
        Some(ShaderOrProgram::Shader(_)) => {
            invalid_operation(SECTION, format!("program = {name} is a shader, not a program"))
        }
        None => invalid_value(SECTION, format!("program = {name} is no program")),
    }
}

pub(crate) fn create_program(context: &mut Context) -> Result<GLuint> {
    Ok(context.objects.shared.programs.add(ShaderOrProgram::Program(Box::default())))
}

pub(crate) fn delete_program(context: &mut Context, name: GLuint) -> Result<()> {
    if name == 0 {
        return Ok(());
    }
    if std::mem::replace(&mut program(context, name)?.doomed, true) {
        return Ok(());
    }
    // As long as it is part of the state of any context, it is only flagged.
    context.objects.shared.doomed_programs.push(name);
    context.objects.shared.sweep(Sweep::Deleted);
    Ok(())
}

pub(crate) fn is_program(context: &mut Context, name: GLuint) -> Result<bool> {
    context.objects.shared.sweep_programs();
    Ok(matches!(context.objects.shared.programs.get(name), Some(ShaderOrProgram::Program(_))))
}

pub(crate) fn attach_shader(context: &mut Context, name: GLuint, added: GLuint) -> Result<()> {
    let stage = shader(context, added)?.stage;
    let attached = program(context, name)?.attached.clone();
    if attached.contains(&added) {
        return invalid_operation(SECTION, format!("shader {added} is attached already"));
    }
    if context.profile.is_es() {
        for other in attached {
            if shader(context, other)?.stage == stage {
                let rule = format!(
                    "shader {other} of the same stage is attached: OpenGL ES has one a stage"
                );
                return invalid_operation("OpenGL ES 3.0, section 2.12.3", rule);
            }
        }
    }
    program(context, name)?.attached.push(added);
    shader(context, added)?.attachments += 1;
    Ok(())
}

pub(crate) fn detach_shader(context: &mut Context, name: GLuint, gone: GLuint) -> Result<()> {
    shader(context, gone)?;
    let program = program(context, name)?;
    match program.attached.iter().position(|attached| *attached == gone) {
        Some(index) => {
            program.attached.remove(index);
            context.objects.shared.detach(gone);
            Ok(())
        }
        None => invalid_operation(SECTION, format!("shader {gone} is not attached to it")),
    }
}

/// A name that a location can be bound to.
fn checked_name(name: &str) -> Result<&str> {
    if name.starts_with("gl_") {
        return invalid_operation(
            "GL 2.1, section 2.15.3",
            format!("name = \"{name}\" begins with gl_, which is reserved"),
        );
    }
    Ok(name)
}

pub(crate) fn bind_attrib_location(
    context: &mut Context,
    name: GLuint,
    index: GLuint,
    attribute: &str,
) -> Result<()> {
    let location = match u8::try_from(index) {
        Ok(location) if location < MAX_VERTEX_ATTRIBS => location,
        _ => {
            return invalid_value(
                "GL 2.1, section 2.15.3",
                format!("index = {index} must be below {MAX_VERTEX_ATTRIBS}"),
            );
        }
    };
    let attribute = checked_name(attribute)?.to_owned();
    program(context, name)?.bindings.attributes.insert(attribute, location);
    Ok(())
}

pub(crate) fn bind_frag_data_location(
    context: &mut Context,
    name: GLuint,
    color: GLuint,
    output: &str,
) -> Result<()> {
    let limit = limits::MAX_COLOR_ATTACHMENTS;
    if color as usize >= limit {
        return invalid_value(
            "GL 3.0, section 3.12.2",
            format!("color = {color} must be below {limit}"),
        );
    }
    bind_fragment_color(context, name, FragmentColor { location: color as u8, index: 0 }, output)
}

pub(crate) fn bind_frag_data_location_indexed(
    context: &mut Context,
    name: GLuint,
    color_number: GLuint,
    index: GLuint,
    output: &str,
) -> Result<()> {
    let (limit, what) = match index {
        0 => (limits::MAX_COLOR_ATTACHMENTS, "GL_MAX_DRAW_BUFFERS"),
        1 => (limits::MAX_DUAL_SOURCE_DRAW_BUFFERS, "GL_MAX_DUAL_SOURCE_DRAW_BUFFERS"),
        _ => {
            return invalid_value(
                "GL 3.3, section 3.9.2",
                format!("index = {index} must be 0 or 1, the first or the second colour"),
            );
        }
    };
    if color_number as usize >= limit {
        return invalid_value(
            "GL 3.3, section 3.9.2",
            format!(
                "colorNumber = {color_number} must be below {what}, {limit}, where index = {index}"
            ),
        );
    }
    let color = FragmentColor { location: color_number as u8, index: index as u8 };
    bind_fragment_color(context, name, color, output)
}

/// The colour that an output is from the next link on.
fn bind_fragment_color(
    context: &mut Context,
    name: GLuint,
    color: FragmentColor,
    output: &str,
) -> Result<()> {
    let output = checked_name(output)?.to_owned();
    program(context, name)?.bindings.frag_data.insert(output, color);
    Ok(())
}

pub(crate) fn link_program(context: &mut Context, name: GLuint) -> Result<()> {
    let state = &context.transform_feedback;
    if state.active.or(state.paused).is_some_and(|active| active.is_of(name)) {
        not_while_begun(context)?;
    }
    let object = program(context, name)?;
    let is_separable = object.separable == glsl::Separable::Yes;
    let attached = object.attached.clone();
    let mut log = String::new();
    let (mut shaders, mut stages) = (Vec::new(), Vec::new());
    for &attached in &attached {
        let Some(ShaderOrProgram::Shader(shader)) = context.objects.shared.programs.get(attached)
        else {
            continue;
        };
        stages.push(shader.stage);
        match &shader.compiled {
            Some(compiled) => shaders.push(compiled),
            None => log.push_str(&format!("error: shader {attached} is not compiled\n")),
        }
    }
    if context.profile.is_es() {
        for (stage, name) in [(glsl::Stage::Vertex, "vertex"), (glsl::Stage::Fragment, "fragment")]
        {
            if log.is_empty() && !is_separable && !stages.contains(&stage) {
                log = format!(
                    "error: there is no {name} shader, and OpenGL ES has no fixed function (3.0, section 2.12.3)\n"
                );
            }
        }
    }
    if log.is_empty() && attached.is_empty() && !context.profile.is_compatibility() {
        log = "error: no shader is attached, and there is no fixed function (GL 3.3, section 2.11.2)\n".into();
    }
    let mut linked = None;
    if log.is_empty() {
        let bindings = match context.objects.shared.programs.get(name) {
            Some(ShaderOrProgram::Program(program)) => {
                glsl::Bindings { separable: program.separable, ..program.bindings.clone() }
            }
            Some(ShaderOrProgram::Shader(_)) | None => glsl::Bindings::default(),
        };
        let result = glsl::link(&shaders, &bindings);
        log = result.log;
        let shaders = shaders.into_iter().cloned().collect();
        let sources = Arc::new(LinkSources { shaders, bindings });
        match result.program.map(|program| executable(program, sources)).transpose() {
            Ok(program) => linked = program,
            Err(error) => log.push_str(&format!("error: internal: {error}\n")),
        }
    }
    let in_use = context.objects.shared.programs.is_held(name);
    let program = program(context, name)?;
    program.binary_hint = program.next_binary_hint;
    program.link = if linked.is_some() { LinkStatus::Linked } else { LinkStatus::Failed };
    if linked.is_some() || !in_use {
        program.executable = linked;
    }
    program.log = log;
    program.validated = false;
    if program.link == LinkStatus::Failed {
        let text = format!("glLinkProgram: program {name} did not link:\n{}", program.log);
        context.debug.warn_each_time(text);
    } else if !program.log.is_empty() {
        let text = format!("glLinkProgram: program {name} linked:\n{}", program.log);
        context.debug.warn_each_time(text);
    }
    Ok(())
}

pub(crate) fn use_program(context: &mut Context, name: GLuint) -> Result<()> {
    if name != 0 && program(context, name)?.linked().is_none() {
        return invalid_operation(
            SECTION,
            format!("program {name} is not linked: see glGetProgramInfoLog"),
        );
    }
    not_while_active(context)?;
    if context.state.bindings.program.name() == name {
        context.state_changes.no_change();
        return Ok(());
    }
    context.leave_plain_state();
    let objects = &mut *context.objects.shared;
    let now = objects.programs.hold(name);
    let before = std::mem::replace(&mut context.state.bindings.program, now).name();
    no_longer_in_use(objects, before);
    context.state_changes.program_only();
    Ok(())
}

/// Frees what is left of a program that one thing less uses.
pub(crate) fn no_longer_in_use(objects: &mut SharedObjects, name: GLuint) {
    objects.sweep_programs();
    if !objects.programs.is_held(name)
        && let Some(ShaderOrProgram::Program(program)) = objects.programs.get_mut(name)
        && program.link == LinkStatus::Failed
    {
        program.executable = None;
    }
}
