//! Transform feedback (GL 3.0, section 2.15), and its objects (`ARB_transform_feedback2`; OpenGL ES 3.0, section 2.14).

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value};
use crate::base::limits::{MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS, MAX_VERTEX_STREAMS};
use crate::base::types::*;
use crate::calls::vertex::draws::draw_arrays;
use crate::context::Context;
use crate::glsl::CapturedScalar;
use crate::objects::buffers::BufferRange;
use crate::objects::name_table::listed;
use crate::state::transform_feedback::{Active, CapturedPrimitive, SECTION, TransformFeedback};

const OBJECTS: &str = "OpenGL ES 3.0, section 2.14";

pub(crate) fn begin_transform_feedback(context: &mut Context, mode: GLenum) -> Result<()> {
    let kind = CapturedPrimitive::TABLE.decode("primitiveMode", mode)?;
    if context.transform_feedback.has_begun() {
        return invalid_operation(
            SECTION,
            "transform feedback is active: glEndTransformFeedback is missing",
        );
    }
    crate::draw::program_pipeline::prepare(context);
    crate::draw::program_pipeline::check(context)?;
    let (program, pipeline) = in_use(context);
    let Some(linked) = context.executable() else {
        return invalid_operation(SECTION, "no program is in use: call glUseProgram");
    };
    let count = linked.program.captured.len();
    if count == 0 {
        return invalid_operation(
            SECTION,
            "the program captures nothing: call glTransformFeedbackVaryings before it is linked",
        );
    }
    let captured = linked.program.captured_by_buffer();
    let mut buffers = context.transform_feedback.buffers.iter().zip(captured);
    let is_missing = |(range, scalars): (&BufferRange, Vec<CapturedScalar>)| {
        range.buffer.name() == 0 && !scalars.is_empty()
    };
    if let Some(index) = buffers.position(is_missing) {
        return invalid_operation(
            SECTION,
            format!(
                "no buffer is bound to index {index} of GL_TRANSFORM_FEEDBACK_BUFFER: call \
                 glBindBufferBase"
            ),
        );
    }
    let written = [0; MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS];
    context.transform_feedback.active =
        Some(Active { kind, program, pipeline, written, vertices: 0 });
    Ok(())
}

/// The name of the program in use, or else that of the pipeline in use and of its programs.
fn in_use(context: &Context) -> (GLuint, (GLuint, [GLuint; 3])) {
    let pipelines = &context.objects.pipelines;
    match (context.state.bindings.program.name(), pipelines.current()) {
        (0, Some(pipeline)) => (0, (pipelines.bound, pipeline.names())),
        (program, _) => (program, (0, [0; 3])),
    }
}

pub(crate) fn end_transform_feedback(context: &mut Context) -> Result<()> {
    let state = &mut context.transform_feedback;
    match state.active.take().or(state.paused.take()) {
        Some(ended) => {
            state.captured = Some(ended.vertices);
            Ok(())
        }
        None => invalid_operation(
            SECTION,
            "transform feedback is not active: glBeginTransformFeedback is missing",
        ),
    }
}

pub(crate) fn pause_transform_feedback(context: &mut Context) -> Result<()> {
    let state = &mut context.transform_feedback;
    match state.active.take() {
        Some(active) => {
            state.paused = Some(active);
            Ok(())
        }
        None => invalid_operation(
            OBJECTS,
            "transform feedback is not active, or paused already: call glBeginTransformFeedback",
        ),
    }
}

pub(crate) fn resume_transform_feedback(context: &mut Context) -> Result<()> {
    let Some(paused) = context.transform_feedback.paused else {
        return invalid_operation(
            OBJECTS,
            "transform feedback is not paused: glPauseTransformFeedback is missing",
        );
    };
    let (program, pipeline) = in_use(context);
    if program == paused.program && pipeline != paused.pipeline {
        return invalid_operation(
            "ARB_separate_shader_objects, section 2.20",
            format!(
                "program pipeline {} is in use, but pipeline {} was when transform feedback began, or its programs \
                 were others: call glBindProgramPipeline",
                pipeline.0, paused.pipeline.0
            ),
        );
    }
    if program != paused.program {
        return invalid_operation(
            OBJECTS,
            format!(
                "program {program} is in use, but program {} was when transform feedback began: call glUseProgram",
                paused.program
            ),
        );
    }
    let state = &mut context.transform_feedback;
    state.active = state.paused.take();
    Ok(())
}

pub(crate) fn gen_transform_feedbacks(
    context: &mut Context,
    n: GLsizei,
    ids: &mut [GLuint],
) -> Result<()> {
    context.transform_feedback_objects.named.reserve(OBJECTS, n, ids)
}

/// The state of an object that is not bound.
fn parked(context: &mut Context, name: GLuint) -> &mut TransformFeedback {
    let objects = &mut context.transform_feedback_objects;
    objects.named.get_mut(name).unwrap_or(&mut objects.default)
}

/// Makes an object the current one.
fn bind(context: &mut Context, name: GLuint) {
    let before = context.transform_feedback_objects.bound;
    let leaving = std::mem::take(&mut context.transform_feedback);
    *parked(context, before) = leaving;
    context.transform_feedback_objects.named.create(name, TransformFeedback::default);
    context.transform_feedback = std::mem::take(parked(context, name));
    context.transform_feedback_objects.bound = name;
}

pub(crate) fn delete_transform_feedbacks(
    context: &mut Context,
    n: GLsizei,
    ids: &[GLuint],
) -> Result<()> {
    let names = listed(OBJECTS, n, ids)?;
    let current = context.transform_feedback_objects.bound;
    for &name in names {
        let has_begun = match name == current {
            true => context.transform_feedback.has_begun(),
            false => context
                .transform_feedback_objects
                .named
                .get(name)
                .is_some_and(TransformFeedback::has_begun),
        };
        if name != 0 && has_begun {
            let rule = format!("transform feedback {name} is active: call glEndTransformFeedback");
            return invalid_operation(OBJECTS, rule);
        }
    }
    for &name in names.iter().filter(|&&name| name != 0) {
        if name == context.transform_feedback_objects.bound {
            bind(context, 0);
        }
        context.transform_feedback_objects.named.remove(name);
    }
    Ok(())
}

pub(crate) fn is_transform_feedback(context: &mut Context, id: GLuint) -> Result<bool> {
    Ok(context.transform_feedback_objects.named.get(id).is_some())
}

pub(crate) fn bind_transform_feedback(
    context: &mut Context,
    target: GLenum,
    id: GLuint,
) -> Result<()> {
    const TARGET: Table<()> = Table { section: OBJECTS, rows: &[(GL_TRANSFORM_FEEDBACK, ())] };
    TARGET.decode("target", target)?;
    if context.transform_feedback.is_active() {
        return invalid_operation(
            OBJECTS,
            "transform feedback is active: call glPauseTransformFeedback or glEndTransformFeedback",
        );
    }
    context.transform_feedback_objects.named.check_given("id", id, "glGenTransformFeedbacks")?;
    bind(context, id);
    Ok(())
}

/// Draws as many vertices as an object has captured.
pub(crate) fn draw_transform_feedback(
    context: &mut Context,
    mode: GLenum,
    id: GLuint,
) -> Result<()> {
    let is_bound = id == context.transform_feedback_objects.bound;
    if !is_bound && id != 0 && context.transform_feedback_objects.named.get(id).is_none() {
        let rule =
            format!("id = {id} is no transform feedback object: call glBindTransformFeedback");
        return invalid_value(OBJECTS, rule);
    }
    let captured = match is_bound {
        true => context.transform_feedback.captured,
        false => parked(context, id).captured,
    };
    let Some(captured) = captured else {
        let rule =
            format!("transform feedback {id} has captured nothing: call glEndTransformFeedback");
        return invalid_operation(OBJECTS, rule);
    };
    draw_arrays(context, mode, 0, captured.min(GLsizei::MAX as u32) as GLsizei)
}

/// As `glDrawTransformFeedback`, of one of the vertex streams (`ARB_transform_feedback3`).
pub(crate) fn draw_transform_feedback_stream(
    context: &mut Context,
    mode: GLenum,
    id: GLuint,
    stream: GLuint,
) -> Result<()> {
    checked_stream("stream", stream)?;
    draw_transform_feedback(context, mode, id)
}

/// Checks the number of a vertex stream.
pub(crate) fn checked_stream(argument: &str, stream: GLuint) -> Result<()> {
    if stream < MAX_VERTEX_STREAMS {
        return Ok(());
    }
    invalid_value(
        "ARB_transform_feedback3, section 2.17",
        format!("{argument} = {stream} must be below GL_MAX_VERTEX_STREAMS, {MAX_VERTEX_STREAMS}"),
    )
}

/// Refuses what must not change while vertices are captured, or will be once that is resumed.
///
/// # Errors
/// `GL_INVALID_OPERATION`.
pub(crate) fn not_while_begun(context: &Context) -> Result<()> {
    if context.transform_feedback.has_begun() {
        return invalid_operation(
            SECTION,
            "transform feedback is active: call glEndTransformFeedback first",
        );
    }
    Ok(())
}

/// Refuses what must not change while vertices are captured.
///
/// # Errors
/// `GL_INVALID_OPERATION`.
pub(crate) fn not_while_active(context: &Context) -> Result<()> {
    if context.transform_feedback.is_active() {
        return invalid_operation(
            SECTION,
            "transform feedback is active: call glEndTransformFeedback first",
        );
    }
    Ok(())
}
