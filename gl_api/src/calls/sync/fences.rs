//! Fences: `ARB_sync`, GL 3.2, section 5.3. A fence is signalled once what was recorded before it has been executed:
//! by the next flush of the context that made it. That context flushes when it waits; another one waits for the flush.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value, not_negative};
use crate::base::types::*;
use crate::context::Context;
use crate::draw::pass::submit;
use crate::objects::syncs::{Fence, Status};
use std::sync::Arc;
use std::time::Duration;

const SECTION: &str = "ARB_sync, section 5.3";

/// `GL_MAX_SERVER_WAIT_TIMEOUT`, in nanoseconds: how long `glWaitSync` waits for another context's flush.
pub(crate) const MAX_SERVER_WAIT_TIMEOUT: u64 = 1_000_000_000;

/// The fence of a handle.
fn fence(context: &Context, sync: GLsync) -> Result<Arc<Fence>> {
    match context.objects.shared.syncs.get(sync as usize) {
        Some(fence) => Ok(Arc::clone(fence)),
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
    let fence = context.recorder.fences.fence();
    Ok(context.objects.shared.syncs.add(fence) as GLsync)
}

pub(crate) fn is_sync(context: &mut Context, sync: GLsync) -> Result<bool> {
    Ok(context.objects.shared.syncs.contains(sync as usize))
}

pub(crate) fn delete_sync(context: &mut Context, sync: GLsync) -> Result<()> {
    if !sync.is_null() {
        fence(context, sync)?;
        context.objects.shared.syncs.remove(sync as usize);
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
    let fence = fence(context, sync)?;
    if flags & !GL_SYNC_FLUSH_COMMANDS_BIT != 0 {
        return invalid_value(
            SECTION,
            format!("flags = {flags:#x} must be 0 or GL_SYNC_FLUSH_COMMANDS_BIT"),
        );
    }
    match fence.status() {
        Status::Signaled => Ok(GL_ALREADY_SIGNALED),
        Status::Unsignaled if context.recorder.fences.contains(&fence) => {
            submit(context);
            // With a timeout of 0 the status is queried, after the commands were executed.
            Ok(if timeout == 0 { GL_ALREADY_SIGNALED } else { GL_CONDITION_SATISFIED })
        }
        Status::Unsignaled => {
            context.objects.shared.release();
            Ok(match fence.wait(Duration::from_nanos(timeout)) {
                Status::Signaled => GL_CONDITION_SATISFIED,
                Status::Unsignaled => GL_TIMEOUT_EXPIRED,
            })
        }
    }
}

pub(crate) fn wait_sync(
    context: &mut Context,
    sync: GLsync,
    flags: GLbitfield,
    timeout: u64,
) -> Result<()> {
    let fence = fence(context, sync)?;
    if flags != 0 || timeout != GL_TIMEOUT_IGNORED {
        return invalid_value(
            SECTION,
            format!(
                "flags = {flags:#x} must be 0, and timeout = {timeout:#x} must be \
                 GL_TIMEOUT_IGNORED"
            ),
        );
    }
    // What this context has recorded before is executed in order.
    if !context.recorder.fences.contains(&fence) {
        context.objects.shared.release();
        match fence.wait(Duration::from_nanos(MAX_SERVER_WAIT_TIMEOUT)) {
            Status::Signaled => {}
            Status::Unsignaled => context.debug.warn(
                "glWaitSync: the context that made the fence has not called glFlush for a second \
                 (GL_MAX_SERVER_WAIT_TIMEOUT): call it there after glFenceSync, or what comes now \
                 may not see what was drawn there (ARB_sync, section 5.3.1)"
                    .into(),
            ),
        }
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
    let fence = fence(context, sync)?;
    let property = PROPERTY.decode("pname", pname)?;
    let buf_size = not_negative(SECTION, "bufSize", buf_size.into())?;
    let value = match property {
        Property::Type => GL_SYNC_FENCE,
        Property::Status => match fence.status() {
            Status::Signaled => GL_SIGNALED,
            Status::Unsignaled => GL_UNSIGNALED,
        },
        Property::Condition => GL_SYNC_GPU_COMMANDS_COMPLETE,
        Property::Flags => 0,
    };
    if buf_size > 0 {
        match values.first_mut() {
            Some(out) => *out = value as GLint,
            None => return invalid_operation(SECTION, "values has room for nothing"),
        }
    }
    if let Some(length) = length.first_mut() {
        *length = GLsizei::from(buf_size > 0);
    }
    Ok(())
}
