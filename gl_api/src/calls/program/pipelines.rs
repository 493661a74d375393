//! Program pipeline objects: ARB_separate_shader_objects, section 2.14.PPO.

use crate::base::args::{Names, Strings, TextOut};
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::program::programs::{
    attach_shader, create_program, detach_shader, link_program, no_longer_in_use, program,
};
use crate::calls::program::shaders::{
    compile_shader, create_shader, delete_shader, shader, shader_source,
};
use crate::calls::transform_feedback::not_while_active;
use crate::context::Context;
use crate::draw::program_pipeline::{has_stage, validate};
use crate::glsl::Separable;
use crate::objects::name_table::listed;
use crate::objects::pipelines::{ProgramPipeline, STAGES};
use crate::objects::shaders::{c_length, put_text};

const SECTION: &str = "ARB_separate_shader_objects, section 2.14.PPO";

/// The bit of each of [`STAGES`].
const BITS: [GLbitfield; 3] =
    [GL_VERTEX_SHADER_BIT, GL_GEOMETRY_SHADER_BIT, GL_FRAGMENT_SHADER_BIT];

pub(crate) fn gen_program_pipelines(
    context: &mut Context,
    n: GLsizei,
    pipelines: &mut [GLuint],
) -> Result<()> {
    context.objects.pipelines.named.reserve(SECTION, n, pipelines)
}

pub(crate) fn create_program_pipelines(
    context: &mut Context,
    n: GLsizei,
    pipelines: &mut [GLuint],
) -> Result<()> {
    context.objects.pipelines.named.add_each(SECTION, n, pipelines, ProgramPipeline::default)
}

pub(crate) fn delete_program_pipelines(
    context: &mut Context,
    n: GLsizei,
    pipelines: &[GLuint],
) -> Result<()> {
    for &name in listed(SECTION, n, pipelines)?.iter().filter(|&&name| name != 0) {
        let own = &mut context.objects.pipelines;
        if own.bound == name {
            own.bound = 0;
        }
        let gone = own.named.get_mut(name).map(std::mem::take);
        own.named.remove(name);
        let Some(gone) = gone else { continue };
        let mut programs = gone.names().to_vec();
        programs.push(gone.active.name());
        drop(gone);
        for program in programs {
            no_longer_in_use(&mut context.objects.shared, program);
        }
    }
    Ok(())
}

pub(crate) fn is_program_pipeline(context: &mut Context, pipeline: GLuint) -> Result<bool> {
    Ok(context.objects.pipelines.named.get(pipeline).is_some())
}

/// Refuses a name that is not reserved; makes its object.
fn pipeline(context: &mut Context, name: GLuint) -> Result<&mut ProgramPipeline> {
    let named = &mut context.objects.pipelines.named;
    if named.is_reserved(name) {
        named.create(name, ProgramPipeline::default);
    }
    match named.get_mut(name) {
        Some(pipeline) => Ok(pipeline),
        None => invalid_operation(
            SECTION,
            format!("pipeline = {name} must be a name that glGenProgramPipelines gave"),
        ),
    }
}

pub(crate) fn bind_program_pipeline(context: &mut Context, name: GLuint) -> Result<()> {
    not_while_active(context)?;
    if name != 0 {
        pipeline(context, name)?;
    }
    context.objects.pipelines.bound = name;
    Ok(())
}

/// Refuses a program that is not linked.
fn check_linked(context: &mut Context, name: GLuint) -> Result<()> {
    if program(context, name)?.linked().is_none() {
        return invalid_operation(
            SECTION,
            format!("program = {name} is not linked: see glGetProgramInfoLog"),
        );
    }
    Ok(())
}

pub(crate) fn use_program_stages(
    context: &mut Context,
    name: GLuint,
    stages: GLbitfield,
    used: GLuint,
) -> Result<()> {
    let known = BITS.iter().fold(0, |all, bit| all | bit);
    let unknown = stages & !known;
    if stages != GL_ALL_SHADER_BITS && unknown != 0 {
        return invalid_value(
            SECTION,
            format!(
                "stages = {stages:#x} has the bits {unknown:#x}: there are GL_VERTEX_SHADER_BIT, \
                 GL_GEOMETRY_SHADER_BIT and GL_FRAGMENT_SHADER_BIT, and GL_ALL_SHADER_BITS alone"
            ),
        );
    }
    pipeline(context, name)?;
    if name == context.objects.pipelines.bound && context.state.bindings.program.name() == 0 {
        not_while_active(context)?;
    }
    if used != 0 {
        check_linked(context, used)?;
        let linked = context.objects.shared.linked_program(used);
        if linked.is_some_and(|linked| linked.sources.bindings.separable == Separable::No) {
            return invalid_operation(
                SECTION,
                format!(
                    "program = {used} is not separable: call glProgramParameteri({used}, GL_PROGRAM_SEPARABLE, \
                     GL_TRUE) before glLinkProgram"
                ),
            );
        }
    }
    let shared = &mut context.objects.shared;
    for stage in STAGES {
        if stages & BITS[stage as usize] == 0 {
            continue;
        }
        // A program without the stage is as none.
        let is_active = shared.linked_program(used).is_some_and(|linked| has_stage(linked, stage));
        let now = if is_active { shared.programs.hold(used) } else { Default::default() };
        let Some(pipeline) = context.objects.pipelines.named.get_mut(name) else { continue };
        let before = std::mem::replace(&mut pipeline.stages[stage as usize], now).name();
        no_longer_in_use(shared, before);
    }
    Ok(())
}

pub(crate) fn active_shader_program(
    context: &mut Context,
    name: GLuint,
    active: GLuint,
) -> Result<()> {
    pipeline(context, name)?;
    if active != 0 {
        check_linked(context, active)?;
    }
    let now = context.objects.shared.programs.hold(active);
    let before = std::mem::replace(&mut pipeline(context, name)?.active, now).name();
    no_longer_in_use(&mut context.objects.shared, before);
    Ok(())
}

/// Makes a separable program of one shader.
pub(crate) fn create_shader_programv(
    context: &mut Context,
    ty: GLenum,
    count: GLsizei,
    strings: Names<'_>,
) -> Result<GLuint> {
    let added = create_shader(context, ty)?;
    let created = match shader_source(context, added, count, Strings(strings.0), &[]) {
        Ok(()) => separable_program(context, added),
        Err(error) => Err(error),
    };
    delete_shader(context, added)?;
    created
}

/// A separable program of a shader, which is compiled.
fn separable_program(context: &mut Context, added: GLuint) -> Result<GLuint> {
    compile_shader(context, added)?;
    let name = create_program(context)?;
    program(context, name)?.separable = Separable::Yes;
    let of_shader = shader(context, added)?;
    let (is_compiled, log) = (of_shader.compiled.is_some(), of_shader.log.clone());
    if is_compiled {
        attach_shader(context, name, added)?;
        link_program(context, name)?;
        detach_shader(context, name, added)?;
    }
    program(context, name)?.log.push_str(&log);
    Ok(name)
}

pub(crate) fn validate_program_pipeline(context: &mut Context, name: GLuint) -> Result<()> {
    pipeline(context, name)?;
    let problem = validate(context, name).err();
    let object = pipeline(context, name)?;
    object.validated = problem.is_none();
    object.log = problem.map_or_else(String::new, |problem| format!("error: {problem}\n"));
    Ok(())
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Active,
    Vertex,
    Geometry,
    Fragment,
    Validated,
    LogLength,
}

pub(crate) fn get_program_pipelineiv(
    context: &mut Context,
    name: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    const PROPERTY: Table<Property> = Table {
        section: "ARB_separate_shader_objects, section 6.1.18",
        rows: &[
            (GL_ACTIVE_PROGRAM, Property::Active),
            (GL_VERTEX_SHADER, Property::Vertex),
            (GL_GEOMETRY_SHADER, Property::Geometry),
            (GL_FRAGMENT_SHADER, Property::Fragment),
            (GL_VALIDATE_STATUS, Property::Validated),
            (GL_INFO_LOG_LENGTH, Property::LogLength),
        ],
    };
    let object = pipeline(context, name)?;
    let [vertex, geometry, fragment] = object.names();
    let value = match PROPERTY.decode("pname", pname)? {
        Property::Active => object.active.name() as GLint,
        Property::Vertex => vertex as GLint,
        Property::Geometry => geometry as GLint,
        Property::Fragment => fragment as GLint,
        Property::Validated => object.validated.into(),
        Property::LogLength => c_length(&object.log),
    };
    put(params, &[value])
}

pub(crate) fn get_program_pipeline_info_log(
    context: &mut Context,
    name: GLuint,
    buf_size: GLsizei,
    length: &mut [GLsizei],
    info_log: TextOut<'_>,
) -> Result<()> {
    put_text(&pipeline(context, name)?.log, buf_size, length, info_log)
}
