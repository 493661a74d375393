//! Fences (EGL 1.5, section 3.8). What was recorded is carried out when a fence is made, so each is
//! signaled from the start.

use super::constants::*;
use super::current::{current_context, current_display};
use super::error::{Code, Result, fail, name_of};
use super::raw::{Attrib, Handle, Id, Int, handle, put};
use super::registry::{Registry, registry};

/// A new fence; `unknown` is the error of another type.
pub(super) fn create(
    dpy: Handle,
    ty: u32,
    attributes: &[(Int, Attrib)],
    unknown: Code,
) -> Result<Handle> {
    let display = registry().display(dpy)?;
    if ty as Int != EGL_SYNC_FENCE {
        return fail(unknown, format!("type = {} must be EGL_SYNC_FENCE", name_of(ty)));
    }
    if let Some((name, _)) = attributes.first() {
        return fail(Code::BadAttribute, format!("attrib_list: no attribute {}", name_of(*name)));
    }
    if current_display()? != dpy {
        return fail(Code::BadMatch, "no context of dpy is current");
    }
    gl_api::with_current(gl_api::Context::flush);
    let mut registry = registry();
    let id = registry.new_id();
    registry.syncs.insert(id, display);
    Ok(handle(id))
}

impl Registry {
    /// A sync of a display.
    fn sync(&self, dpy: Handle, sync: Handle) -> Result<Id> {
        let display = self.display(dpy)?;
        let id = sync.addr();
        if self.syncs.get(&id) == Some(&display) {
            return Ok(id);
        }
        fail(Code::BadParameter, format!("sync = {id:#x} is none of this display"))
    }
}

pub(super) fn destroy(dpy: Handle, sync: Handle) -> Result<u32> {
    let mut registry = registry();
    let id = registry.sync(dpy, sync)?;
    registry.syncs.remove(&id);
    Ok(1)
}

pub(super) fn client_wait(dpy: Handle, sync: Handle) -> Result<u32> {
    registry().sync(dpy, sync)?;
    Ok(EGL_CONDITION_SATISFIED as u32)
}

pub(super) fn server_wait(dpy: Handle, sync: Handle, flags: Int) -> Result<u32> {
    registry().sync(dpy, sync)?;
    if flags != 0 {
        return fail(Code::BadParameter, format!("flags = {flags:#x} must be 0"));
    }
    if current_context()?.is_null() {
        return fail(Code::BadMatch, "no context is current");
    }
    Ok(1)
}

/// An attribute of a fence.
fn attribute(dpy: Handle, sync: Handle, attribute: Int) -> Result<Int> {
    registry().sync(dpy, sync)?;
    match attribute {
        EGL_SYNC_TYPE => Ok(EGL_SYNC_FENCE),
        EGL_SYNC_STATUS => Ok(EGL_SIGNALED),
        EGL_SYNC_CONDITION => Ok(EGL_SYNC_PRIOR_COMMANDS_COMPLETE),
        _ => fail(
            Code::BadAttribute,
            format!("attribute = {} is none of fences", name_of(attribute)),
        ),
    }
}

pub(super) unsafe fn get_attrib<T: From<Int>>(
    dpy: Handle,
    sync: Handle,
    name: Int,
    value: *mut T,
) -> Result<u32> {
    let found = attribute(dpy, sync, name)?;
    if value.is_null() {
        return fail(Code::BadParameter, "value must not be NULL");
    }
    // SAFETY: not null, and the client's.
    unsafe { put(value, found.into()) };
    Ok(1)
}
