//! Fences: `ARB_sync`, GL 3.2, section 5.3. A fence is signalled once what was recorded before it is
//! carried out; as submitting carries it out, that is when somebody flushes.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value, not_negative};
use crate::base::types::*;
use crate::context::Context;
use crate::draw::pass::submit;
use crate::objects::syncs::Status;

const SECTION: &str = "ARB_sync, section 5.3";

/// Where a fence is.
fn known(context: &Context, sync: GLsync) -> Result<usize> {
    match context.objects.syncs.position(sync as usize) {
        Some(at) => Ok(at),
        None => invalid_value(SECTION, "sync is no handle that glFenceSync gave"),
    }
}

pub(crate) fn fence_sync(
    context: &mut Context,
    condition: GLenum,
    flags: GLbitfield,
) -> Result<GLsync> {
    const CONDITION: Table<()> =
        Table { section: SECTION, rows: &[(GL_SYNC_GPU_COMMANDS_COMPLETE, ())] };
    CONDITION.decode("condition", condition)?;
    if flags != 0 {
        return invalid_value(SECTION, format!("flags = {flags:#x} must be 0"));
    }
    let syncs = &mut context.objects.syncs;
    syncs.last += 1;
    syncs.fences.push((syncs.last, Status::Unsignaled));
    Ok(syncs.last as GLsync)
}

pub(crate) fn is_sync(context: &mut Context, sync: GLsync) -> Result<bool> {
    Ok(context.objects.syncs.contains(sync as usize))
}

pub(crate) fn delete_sync(context: &mut Context, sync: GLsync) -> Result<()> {
    if !sync.is_null() {
        let at = known(context, sync)?;
        context.objects.syncs.fences.remove(at);
    }
    Ok(())
}

/// A refused wait has failed.
pub(crate) fn client_wait_sync(
    context: &mut Context,
    sync: GLsync,
    flags: GLbitfield,
    timeout: u64,
) -> Result<GLenum> {
    Ok(waited(context, sync, flags, timeout).unwrap_or_else(|error| {
        context.refuse("glClientWaitSync", error);
        GL_WAIT_FAILED
    }))
}

fn waited(context: &mut Context, sync: GLsync, flags: GLbitfield, timeout: u64) -> Result<GLenum> {
    let (_, status) = context.objects.syncs.fences[known(context, sync)?];
    if flags & !GL_SYNC_FLUSH_COMMANDS_BIT != 0 {
        return invalid_value(
            SECTION,
            format!("flags = {flags:#x} must be 0 or GL_SYNC_FLUSH_COMMANDS_BIT"),
        );
    }
    match status {
        Status::Signaled => Ok(GL_ALREADY_SIGNALED),
        Status::Unsignaled => {
            submit(context);
            // Who does not wait asks after the commands were carried out.
            Ok(if timeout == 0 { GL_ALREADY_SIGNALED } else { GL_CONDITION_SATISFIED })
        }
    }
}

pub(crate) fn wait_sync(
    context: &mut Context,
    sync: GLsync,
    flags: GLbitfield,
    timeout: u64,
) -> Result<()> {
    known(context, sync)?;
    if flags != 0 || timeout != GL_TIMEOUT_IGNORED {
        return invalid_value(
            SECTION,
            format!(
                "flags = {flags:#x} must be 0, and timeout = {timeout:#x} must be \
                 GL_TIMEOUT_IGNORED"
            ),
        );
    }
    Ok(())
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Type,
    Status,
    Condition,
    Flags,
}

pub(crate) fn get_synciv(
    context: &mut Context,
    sync: GLsync,
    pname: GLenum,
    buf_size: GLsizei,
    length: &mut [GLsizei],
    values: &mut [GLint],
) -> Result<()> {
    const PROPERTY: Table<Property> = Table {
        section: SECTION,
        rows: &[
            (GL_OBJECT_TYPE, Property::Type),
            (GL_SYNC_STATUS, Property::Status),
            (GL_SYNC_CONDITION, Property::Condition),
            (GL_SYNC_FLAGS, Property::Flags),
        ],
    };
    let (_, status) = context.objects.syncs.fences[known(context, sync)?];
    let property = PROPERTY.decode("pname", pname)?;
    let buf_size = not_negative(SECTION, "bufSize", buf_size.into())?;
    let value = match property {
        Property::Type => GL_SYNC_FENCE,
        Property::Status => match status {
            Status::Signaled => GL_SIGNALED,
            Status::Unsignaled => GL_UNSIGNALED,
        },
        Property::Condition => GL_SYNC_GPU_COMMANDS_COMPLETE,
        Property::Flags => 0,
    };
    if buf_size > 0 {
        match values.first_mut() {
            Some(place) => *place = value as GLint,
            None => return invalid_operation(SECTION, "values has room for nothing"),
        }
    }
    if let Some(length) = length.first_mut() {
        *length = GLsizei::from(buf_size > 0);
    }
    Ok(())
}
