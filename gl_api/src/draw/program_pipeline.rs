//! The bound program pipeline as the program of a draw: its programs are linked together when it is first drawn with,
//! and again when one of them is linked again (ARB_separate_shader_objects, section 2.14.PPO).

use crate::base::error::{Result, invalid_operation};
use crate::base::types::GLuint;
use crate::context::Context;
use crate::draw::validate::runnable;
use crate::generate::executable::executable;
use crate::glsl::{self, Bindings, Part, Separable, Stage};
use crate::objects::pipelines::{
    PipelineExecutable, PipelineInUse, PipelineKey, ProgramPipeline, STAGES,
};
use crate::objects::programs::Linked;
use crate::objects::shared::SharedObjects;
use std::sync::Arc;

/// When so many combinations of programs are linked, all are dropped.
const MAX_LINKED: usize = 256;

/// The name and the executable of the program of each stage that has one.
type Active<'a> = [Option<(GLuint, &'a Linked)>; 3];

/// Whether an executable has a stage.
pub(crate) fn has_stage(linked: &Linked, stage: Stage) -> bool {
    match stage {
        Stage::Vertex => linked.vertex.is_some(),
        Stage::Geometry => linked.geometry.is_some(),
        Stage::Fragment => linked.fragment.is_some(),
    }
}

/// The programs that are active for the stages of a pipeline.
fn active<'a>(shared: &'a SharedObjects, pipeline: &ProgramPipeline) -> Active<'a> {
    STAGES.map(|stage| {
        let name = pipeline.stages[stage as usize].name();
        let linked = if name == 0 { None } else { shared.linked_program(name) }?;
        has_stage(linked, stage).then_some((name, linked))
    })
}

/// Finds out what the bound pipeline draws with, if no program is in use.
pub(crate) fn prepare(context: &mut Context) {
    let bound = context.objects.pipelines.bound;
    if bound != 0 && context.state.bindings.program.name() == 0 {
        context.objects.pipelines.in_use = of_pipeline(context, bound);
        sync(context);
    }
}

/// Refuses to draw with a pipeline that cannot run.
///
/// # Errors
/// `GL_INVALID_OPERATION`.
pub(crate) fn check(context: &Context) -> Result<()> {
    let pipelines = &context.objects.pipelines;
    if let PipelineInUse::Refused(problem) = &pipelines.in_use
        && pipelines.bound != 0
        && context.state.bindings.program.name() == 0
    {
        return invalid_operation(
            "ARB_separate_shader_objects, section 2.14.8",
            format!("program pipeline {} cannot run: {problem}", pipelines.bound),
        );
    }
    Ok(())
}

/// What a pipeline draws with.
pub(crate) fn of_pipeline(context: &mut Context, name: GLuint) -> PipelineInUse {
    let objects = &mut context.objects;
    let Some(pipeline) = objects.pipelines.named.get(name) else { return PipelineInUse::Empty };
    let active = active(&objects.shared, pipeline);
    if active.iter().all(Option::is_none) {
        return PipelineInUse::Empty;
    }
    if let Some(problem) = problem(&active) {
        return PipelineInUse::Refused(problem);
    }
    let sources = |stage: usize| active[stage].map(|(_, linked)| &linked.sources);
    let is_same = |known: &PipelineExecutable| {
        known.key.iter().enumerate().all(|(stage, key)| match (key, sources(stage)) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            (None, None) => true,
            (Some(_), None) | (None, Some(_)) => false,
        })
    };
    let all = &mut objects.pipelines.linked;
    let index = match all.iter().position(is_same) {
        Some(index) => index,
        None => {
            let executable = linked(&active);
            if all.len() >= MAX_LINKED {
                all.clear();
            }
            all.push(executable);
            all.len() - 1
        }
    };
    match &all[index].result {
        Ok(_) => PipelineInUse::Linked(index),
        Err(problem) => PipelineInUse::Refused(problem.clone()),
    }
}

/// The rule of pipelines that these programs break.
fn problem(active: &Active<'_>) -> Option<String> {
    for &(name, linked) in active.iter().flatten() {
        if linked.sources.bindings.separable == Separable::No {
            return Some(format!(
                "program {name} was linked again without GL_PROGRAM_SEPARABLE: call glProgramParameteri before \
                 glLinkProgram"
            ));
        }
        let is_its = |stage: Stage| active[stage as usize].is_some_and(|(other, _)| other == name);
        let present = || STAGES.into_iter().filter(|stage| has_stage(linked, *stage));
        let Some(missing) = present().find(|stage| !is_its(*stage)) else { continue };
        return Some(format!(
            "program {name} has a {} stage that the pipeline does not use: call glUseProgramStages with all of its \
             stages",
            stage_name(missing)
        ));
    }
    let [vertex, geometry, fragment] = active.map(|stage| stage.map(|(name, _)| name));
    if vertex.is_some() && vertex == fragment && geometry.is_some() && geometry != vertex {
        return Some(
            "its geometry stage is of another program than the stages before and after it, which are of one".into(),
        );
    }
    if geometry.is_some() && vertex.is_none() {
        return Some("it has a geometry stage and no vertex stage".into());
    }
    None
}

/// The name of a stage.
fn stage_name(stage: Stage) -> &'static str {
    match stage {
        Stage::Vertex => "vertex",
        Stage::Geometry => "geometry",
        Stage::Fragment => "fragment",
    }
}

/// Links the programs of a pipeline.
fn linked(active: &Active<'_>) -> PipelineExecutable {
    let key: PipelineKey = active.map(|stage| stage.map(|(_, linked)| Arc::clone(&linked.sources)));
    let mut parts: Vec<usize> = Vec::new();
    for (stage, of_stage) in active.iter().enumerate() {
        let Some((name, _)) = of_stage else { continue };
        if !parts.iter().any(|part| active[*part].is_some_and(|(other, _)| other == *name)) {
            parts.push(stage);
        }
    }
    let programs: Vec<Part<'_>> = parts
        .iter()
        .filter_map(|part| active[*part])
        .map(|(_, linked)| Part { shaders: &linked.sources.shaders, program: &linked.program })
        .collect();
    let bindings = |stage: usize| key[stage].as_ref().map(|sources| sources.bindings.clone());
    let bindings = Bindings {
        attributes: bindings(0).unwrap_or_default().attributes,
        frag_data: bindings(2).unwrap_or_default().frag_data,
        capture: bindings(1).or_else(|| bindings(0)).unwrap_or_default().capture,
        separable: Separable::Yes,
    };
    let result = glsl::link_pipeline(&programs, &bindings);
    let executable = match result.linked.program {
        Some(program) => executable(program, Arc::default()).map_err(|error| error.to_string()),
        None => Err(format!("its programs do not fit together:\n{}", result.linked.log)),
    };
    PipelineExecutable {
        key,
        result: executable.map(Box::new),
        parts,
        words: result.words,
        blocks: result.blocks,
    }
}

/// Brings the uniforms of the pipeline in use up to date with those of its programs.
pub(crate) fn sync(context: &mut Context) {
    let objects = &mut context.objects;
    let pipelines = &mut objects.pipelines;
    if pipelines.bound == 0 || context.state.bindings.program.name() != 0 {
        return;
    }
    let PipelineInUse::Linked(index) = pipelines.in_use else { return };
    let Some(pipeline) = pipelines.named.get(pipelines.bound) else { return };
    if let Some(executable) = pipelines.linked.get_mut(index) {
        copy_values(&objects.shared, pipeline, executable);
    }
}

/// Copies the uniforms of the programs of a pipeline to its executable.
fn copy_values(
    shared: &SharedObjects,
    pipeline: &ProgramPipeline,
    executable: &mut PipelineExecutable,
) {
    let Ok(linked) = &mut executable.result else { return };
    let stages = executable.parts.iter().map(|stage| pipeline.stages[*stage].name());
    let programs: Vec<Option<&Linked>> = stages.map(|name| shared.linked_program(name)).collect();
    for words in &executable.words {
        let Some(own) = programs[words.part] else { continue };
        let [from, to, count] = [words.from, words.to, words.count].map(|word| word as usize);
        let own = own.words.get(from..from + count).unwrap_or_default();
        if let Some(place) = linked.words.get_mut(to..to + own.len()) {
            place.copy_from_slice(own);
        }
    }
    for (block, &(part, index)) in linked.blocks.iter_mut().zip(&executable.blocks) {
        if let Some(own) = programs.get(part).and_then(|own| own.as_ref()?.blocks.get(index)) {
            block.binding = own.binding;
        }
    }
}

/// Whether a pipeline can run with the current state, for `glValidateProgramPipeline`.
///
/// # Errors
/// What is wrong.
pub(crate) fn validate(context: &mut Context, name: GLuint) -> Result<(), String> {
    let in_use = of_pipeline(context, name);
    let objects = &mut context.objects;
    match in_use {
        PipelineInUse::Empty => Ok(()),
        PipelineInUse::Refused(problem) => Err(problem),
        PipelineInUse::Linked(index) => {
            let pipelines = &mut objects.pipelines;
            let (Some(pipeline), Some(executable)) =
                (pipelines.named.get(name), pipelines.linked.get_mut(index))
            else {
                return Ok(());
            };
            copy_values(&objects.shared, pipeline, executable);
            executable.result.as_ref().map_or(Ok(()), |linked| runnable(linked))
        }
    }
}
