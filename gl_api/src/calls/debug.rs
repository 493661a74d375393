//! The calls of `KHR_debug`.

use crate::base::args::TextOut;
use crate::base::constants::*;
use crate::base::error::{
    ErrorCode, GlError, Result, Table, invalid_operation, invalid_value, not_negative,
};
use crate::base::memory::{copied, out_of_memory};
use crate::base::types::*;
use crate::context::Context;
use crate::context::debug::Output;
use crate::context::log::{
    Filter, GLDEBUGPROC, LogMessage, MAX_GROUPS, MAX_LABEL, MAX_LENGTH, MessageClass,
};

const SECTION: &str = "KHR_debug, section 5.5";

macro_rules! plain_table {
    ($($name:ident: $($value:ident),+;)*) => {
        $(const $name: Table<()> = Table { section: SECTION, rows: &[$(($value, ())),+] };)*
    };
}

plain_table! {
    SOURCE: GL_DEBUG_SOURCE_API, GL_DEBUG_SOURCE_WINDOW_SYSTEM, GL_DEBUG_SOURCE_SHADER_COMPILER,
        GL_DEBUG_SOURCE_THIRD_PARTY, GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_SOURCE_OTHER;
    TYPE: GL_DEBUG_TYPE_ERROR, GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR,
        GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR, GL_DEBUG_TYPE_PORTABILITY, GL_DEBUG_TYPE_PERFORMANCE,
        GL_DEBUG_TYPE_OTHER, GL_DEBUG_TYPE_MARKER, GL_DEBUG_TYPE_PUSH_GROUP,
        GL_DEBUG_TYPE_POP_GROUP;
    SEVERITY: GL_DEBUG_SEVERITY_HIGH, GL_DEBUG_SEVERITY_MEDIUM, GL_DEBUG_SEVERITY_LOW,
        GL_DEBUG_SEVERITY_NOTIFICATION;
    OWN_SOURCE: GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_SOURCE_THIRD_PARTY;
}

/// What can have a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Labelled {
    Buffer,
    Shader,
    Program,
    Texture,
    Framebuffer,
    Renderbuffer,
    VertexArray,
    Sampler,
    Query,
    ProgramPipeline,
    TransformFeedback,
    List,
}

const IDENTIFIER: Table<Labelled> = Table {
    section: "KHR_debug, table 6.X",
    rows: &[
        (GL_BUFFER, Labelled::Buffer),
        (GL_SHADER, Labelled::Shader),
        (GL_PROGRAM, Labelled::Program),
        (GL_TEXTURE, Labelled::Texture),
        (GL_FRAMEBUFFER, Labelled::Framebuffer),
        (GL_RENDERBUFFER, Labelled::Renderbuffer),
        (GL_VERTEX_ARRAY, Labelled::VertexArray),
        (GL_SAMPLER, Labelled::Sampler),
        (GL_QUERY, Labelled::Query),
        (GL_PROGRAM_PIPELINE, Labelled::ProgramPipeline),
        (GL_TRANSFORM_FEEDBACK, Labelled::TransformFeedback),
        (GL_DISPLAY_LIST, Labelled::List),
    ],
};

/// The text of a call: `length` bytes, or all where it is negative.
fn text(argument: &str, length: GLsizei, text: &str, most: usize) -> Result<String> {
    let length = usize::try_from(length).unwrap_or(text.len());
    if length >= most {
        return invalid_value(
            SECTION,
            format!("{argument} has {length} bytes; it must have fewer than {most}"),
        );
    }
    let text = text.get(..length).unwrap_or(text);
    Ok(text.to_owned())
}

pub(crate) fn debug_message_control(
    context: &mut Context,
    source: GLenum,
    ty: GLenum,
    severity: GLenum,
    count: GLsizei,
    ids: &[GLuint],
    enabled: bool,
) -> Result<()> {
    for (argument, value, table) in
        [("source", source, &SOURCE), ("type", ty, &TYPE), ("severity", severity, &SEVERITY)]
    {
        if value != GL_DONT_CARE {
            table.decode(argument, value)?;
        }
    }
    let count = not_negative(SECTION, "count", count.into())?;
    let Some(ids) = ids.get(..count) else {
        let has = ids.len();
        return invalid_operation(SECTION, format!("count = {count}, but ids has {has} elements"));
    };
    if count > 0 && (source == GL_DONT_CARE || ty == GL_DONT_CARE || severity != GL_DONT_CARE) {
        return invalid_operation(
            SECTION,
            "with ids, source and type must not be GL_DONT_CARE, and severity must be it",
        );
    }
    let kind = MessageClass { source, ty, severity };
    let ids = copied(ids).map_err(out_of_memory(SECTION, "a copy of ids"))?;
    context.debug.log.add_filter(Filter { kind, ids, on: enabled });
    Ok(())
}

pub(crate) fn debug_message_insert(
    context: &mut Context,
    source: GLenum,
    ty: GLenum,
    id: GLuint,
    severity: GLenum,
    length: GLsizei,
    message: &str,
) -> Result<()> {
    OWN_SOURCE.decode("source", source)?;
    TYPE.decode("type", ty)?;
    SEVERITY.decode("severity", severity)?;
    let text = text("message", length, message, MAX_LENGTH)?;
    if context.debug.output == Output::On {
        context.debug.log.push(LogMessage {
            kind: MessageClass { source, ty, severity },
            id,
            text,
        });
    }
    Ok(())
}

pub(crate) fn debug_message_callback(
    context: &mut Context,
    callback: GLDEBUGPROC,
    user: *const GLvoid,
) -> Result<()> {
    context.debug.log.set_callback(callback, user as usize);
    if callback.is_some() {
        context.debug.read();
    }
    Ok(())
}

/// Writes an element, where there is buf_size for it.
fn set<T>(slice: &mut [T], at: usize, value: T) {
    if let Some(out) = slice.get_mut(at) {
        *out = value;
    }
}

#[allow(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn get_debug_message_log(
    context: &mut Context,
    count: GLuint,
    buf_size: GLsizei,
    sources: &mut [GLenum],
    types: &mut [GLenum],
    ids: &mut [GLuint],
    severities: &mut [GLenum],
    lengths: &mut [GLsizei],
    text: TextOut<'_>,
) -> Result<GLuint> {
    let mut remaining = match &text {
        TextOut::Null => usize::MAX,
        TextOut::Bytes(_) | TextOut::String(_) => {
            not_negative(SECTION, "bufSize", buf_size.into())?
        }
    };
    context.debug.read();
    let mut all = String::new();
    let mut taken = 0;
    while taken < count as usize {
        let fits = |first: &LogMessage| first.text.len() < remaining;
        if !context.debug.log.first().is_some_and(fits) {
            break;
        }
        let Some(message) = context.debug.log.pop() else { break };
        let length = message.text.len() + 1;
        remaining -= length;
        set(sources, taken, message.kind.source);
        set(types, taken, message.kind.ty);
        set(ids, taken, message.id);
        set(severities, taken, message.kind.severity);
        set(lengths, taken, length as GLsizei);
        all.push_str(&message.text);
        all.push('\0');
        taken += 1;
    }
    // The last zero is the one that every text ends with.
    text.write(all.strip_suffix('\0').unwrap_or(""), usize::MAX);
    Ok(taken as GLuint)
}

pub(crate) fn push_debug_group(
    context: &mut Context,
    source: GLenum,
    id: GLuint,
    length: GLsizei,
    message: &str,
) -> Result<()> {
    OWN_SOURCE.decode("source", source)?;
    let text = text("message", length, message, MAX_LENGTH)?;
    if context.debug.log.depth() >= MAX_GROUPS {
        return Err(GlError::new(
            ErrorCode::StackOverflow,
            SECTION,
            format!(
                "{MAX_GROUPS} groups are open, the most there may be: glPopDebugGroup is missing"
            ),
        ));
    }
    let (ty, severity) = (GL_DEBUG_TYPE_PUSH_GROUP, GL_DEBUG_SEVERITY_NOTIFICATION);
    context.debug.log.push_group(LogMessage {
        kind: MessageClass { source, ty, severity },
        id,
        text,
    });
    Ok(())
}

pub(crate) fn pop_debug_group(context: &mut Context) -> Result<()> {
    if context.debug.log.depth() == 1 {
        return Err(GlError::new(
            ErrorCode::StackUnderflow,
            SECTION,
            "no group is open: glPushDebugGroup is missing",
        ));
    }
    context.debug.log.pop_group();
    Ok(())
}

/// Checks that there is an object to label.
fn exists(context: &Context, identifier: GLenum, name: GLuint) -> Result<()> {
    let objects = &context.objects;
    let exists = match IDENTIFIER.decode("identifier", identifier)? {
        Labelled::Buffer => objects.shared.buffers.get(name).is_some(),
        Labelled::Shader | Labelled::Program => objects.shared.programs.get(name).is_some(),
        Labelled::Texture => objects.shared.textures.get(name).is_some(),
        Labelled::Framebuffer => objects.framebuffers.get(name).is_some(),
        Labelled::Renderbuffer => objects.shared.renderbuffers.get(name).is_some(),
        Labelled::VertexArray => objects.vertex_arrays.get(name).is_some(),
        Labelled::Sampler => objects.shared.samplers.get(name).is_some(),
        Labelled::Query => objects.queries.get(name).is_some(),
        Labelled::ProgramPipeline => objects.pipelines.named.get(name).is_some(),
        Labelled::TransformFeedback => context.transform_feedback_objects.named.get(name).is_some(),
        Labelled::List => objects.shared.lists.contains(name),
    };
    if exists {
        return Ok(());
    }
    invalid_value(SECTION, format!("name = {name} is no object of {}", enum_name(identifier)))
}

fn set_label(
    context: &mut Context,
    key: (GLenum, usize),
    length: GLsizei,
    label: &str,
) -> Result<()> {
    let label = text("label", length, label, MAX_LABEL)?;
    if label.is_empty() {
        context.debug.log.labels.remove(&key);
    } else {
        context.debug.log.labels.insert(key, label);
    }
    Ok(())
}

fn get_label(
    context: &Context,
    key: (GLenum, usize),
    buf_size: GLsizei,
    length: &mut [GLsizei],
    label: TextOut<'_>,
) -> Result<()> {
    let buf_size = not_negative(SECTION, "bufSize", buf_size.into())?;
    let text = context.debug.log.labels.get(&key).map_or("", String::as_str);
    let written = match label {
        TextOut::Null => text.len(),
        out @ (TextOut::Bytes(_) | TextOut::String(_)) => out.write(text, buf_size),
    };
    set(length, 0, written as GLsizei);
    Ok(())
}

pub(crate) fn object_label(
    context: &mut Context,
    identifier: GLenum,
    name: GLuint,
    length: GLsizei,
    label: &str,
) -> Result<()> {
    exists(context, identifier, name)?;
    set_label(context, (identifier, name as usize), length, label)
}

pub(crate) fn get_object_label(
    context: &mut Context,
    identifier: GLenum,
    name: GLuint,
    buf_size: GLsizei,
    length: &mut [GLsizei],
    label: TextOut<'_>,
) -> Result<()> {
    exists(context, identifier, name)?;
    get_label(context, (identifier, name as usize), buf_size, length, label)
}

/// The key of a sync object's label.
fn sync_key(context: &Context, sync: *const GLvoid) -> Result<(GLenum, usize)> {
    if context.objects.shared.syncs.contains(sync as usize) {
        return Ok((GL_SYNC_FENCE, sync as usize));
    }
    invalid_value(SECTION, "ptr is no handle that glFenceSync gave")
}

pub(crate) fn object_ptr_label(
    context: &mut Context,
    sync: *const GLvoid,
    length: GLsizei,
    label: &str,
) -> Result<()> {
    let key = sync_key(context, sync)?;
    set_label(context, key, length, label)
}

pub(crate) fn get_object_ptr_label(
    context: &mut Context,
    sync: *const GLvoid,
    buf_size: GLsizei,
    length: &mut [GLsizei],
    label: TextOut<'_>,
) -> Result<()> {
    let key = sync_key(context, sync)?;
    get_label(context, key, buf_size, length, label)
}
