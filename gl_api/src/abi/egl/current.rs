//! Making contexts and surfaces current (EGL 1.5, section 3.7.3).

use super::constants::*;
use super::error::{Code, Result, fail};
use super::registry::{
    Api, Binding, Id, OSMESA, Place, Registry, Thread, ThreadId, display, handle, registry,
    this_thread, thread,
};
use super::{Handle, Int};
use crate::abi::thread_ends;
use crate::context::Context;
use crate::entry::{swap_current, with_current};
use crate::framebuffer::Window;
use std::mem::replace;

/// What was current on this thread goes back to where it lies otherwise.
pub(in crate::abi) fn release(thread: &Thread) {
    let Some(binding) = thread.binding.take() else { return };
    let mut context = swap_current(None);
    if let Some(context) = &mut context {
        // While the registry is locked, every thread's calls of EGL wait.
        context.end_mirror();
    }
    put_back(&mut registry(), binding, context);
}

/// Gives a context and its surface back to the registry; everything was drawn before.
fn put_back(registry: &mut Registry, binding: Binding, context: Option<Box<Context>>) {
    let Some(mut context) = context else {
        // A program took it with Rust's `set_current`: nothing is left of it.
        registry.contexts.remove(&binding.context);
        for surface in [binding.surface, binding.read].into_iter().flatten() {
            registry.surfaces.remove(&surface);
        }
        return;
    };
    if context.invitation.is_open() {
        let shared = context.shared();
        context.invitation.answer(shared);
    }
    let read = context.swap_read_window(None);
    registry.lay_down(binding.read, read);
    let window = context.swap_window(Window::absent());
    registry.lay_down(binding.surface, Some(window));
    if let Some(entry) = registry.contexts.get_mut(&binding.context) {
        entry.place = Place::Idle(context);
        if entry.doomed {
            registry.contexts.remove(&binding.context);
        }
    }
}

impl Registry {
    /// Takes the buffers of a surface for a thread; `None` if another has them.
    fn pick_up(&mut self, surface: Id, thread: ThreadId) -> Option<Window> {
        let entry = self.surfaces.get_mut(&surface)?;
        let window = entry.window.take()?;
        entry.thread = Some(thread);
        Some(window)
    }

    /// The buffers to draw to and, if they are others, to read from; `None` if another thread has
    /// either.
    fn pick_up_both(
        &mut self,
        draw: Id,
        read: Option<Id>,
        thread: ThreadId,
    ) -> Option<(Window, Option<Window>)> {
        let window = self.pick_up(draw, thread)?;
        let Some(read) = read else { return Some((window, None)) };
        let found = self.pick_up(read, thread);
        if found.is_none() {
            self.lay_down(Some(draw), Some(window));
            return None;
        }
        Some((window, found))
    }

    /// Gives the buffers of a surface back, unless it was destroyed meanwhile.
    fn lay_down(&mut self, surface: Option<Id>, window: Option<Window>) {
        let Some(id) = surface else { return };
        let Some(entry) = self.surfaces.get_mut(&id) else { return };
        entry.window = window;
        entry.thread = None;
        if entry.doomed {
            self.surfaces.remove(&id);
        }
    }
}

/// Checks everything about making a context current; nothing has changed yet.
fn check(
    registry: &mut Registry,
    dpy: Id,
    draw: Handle,
    read: Handle,
    context: Handle,
) -> Result<Binding> {
    if draw.is_null() != read.is_null() {
        return fail(Code::BadMatch, "draw and read must both be surfaces, or both EGL_NO_SURFACE");
    }
    let here = this_thread();
    let (context, entry) = registry.context(dpy, context)?;
    match entry.place {
        Place::Current(thread) if thread != here => {
            return fail(Code::BadAccess, "ctx is current on another thread");
        }
        Place::Current(_) | Place::Idle(_) => {}
    }
    let config = entry.config;
    if draw.is_null() {
        return Ok(Binding { display: dpy, context, surface: None, read: None });
    }
    let mut checked = |name: &str, surface: Handle| {
        let (id, entry) = registry.surface(dpy, surface)?;
        if entry.thread.is_some_and(|thread| thread != here) {
            return fail(Code::BadAccess, format!("{name} is current on another thread"));
        }
        if config.is_some() && config != entry.config {
            return fail(Code::BadMatch, format!("{name}'s config is not the context's"));
        }
        Ok(id)
    };
    let (draw, read) = (checked("draw", draw)?, checked("read", read)?);
    let read = (read != draw).then_some(read);
    Ok(Binding { display: dpy, context, surface: Some(draw), read })
}

pub(super) fn make(dpy: Handle, draw: Handle, read: Handle, context: Handle) -> Result<u32> {
    if context.is_null() {
        display(dpy)?;
        if !draw.is_null() || !read.is_null() {
            return fail(Code::BadMatch, "draw and read must be EGL_NO_SURFACE without a context");
        }
        thread(release);
        return Ok(1);
    }
    let binding = {
        let mut registry = registry();
        let dpy = registry.display(dpy)?;
        check(&mut registry, dpy, draw, read, context)?
    };
    thread(|thread| bind(thread, binding))?;
    Ok(1)
}

/// Makes current what was checked, in place of what is.
pub(in crate::abi) fn bind(thread: &Thread, binding: Binding) -> Result<()> {
    thread_ends::expect();
    release(thread);
    let mut registry = registry();
    let here = this_thread();
    let Some(entry) = registry.contexts.get_mut(&binding.context) else {
        return fail(Code::BadContext, "ctx was destroyed meanwhile");
    };
    let mut context = match replace(&mut entry.place, Place::Current(here)) {
        Place::Idle(context) => context,
        Place::Current(other) => {
            entry.place = Place::Current(other);
            return fail(Code::BadAccess, "ctx has become current on another thread");
        }
    };
    if binding.surface.is_none() {
        context.swap_window(Window::absent());
    }
    let first = !replace(&mut entry.sized, true);
    let mut size = (0, 0);
    if let Some(id) = binding.surface {
        let Some((draw, read)) = registry.pick_up_both(id, binding.read, here) else {
            if let Some(entry) = registry.contexts.get_mut(&binding.context) {
                entry.place = Place::Idle(context);
            }
            return fail(Code::BadAccess, "a surface has become current on another thread");
        };
        size = registry.surfaces.get(&id).map_or(size, |entry| (entry.width, entry.height));
        context.swap_window(draw);
        context.swap_read_window(read);
    }
    if first {
        context.first_window(size.0, size.1);
    }
    drop(registry);
    // A context that Rust code made current is dropped, as if the thread had ended.
    drop(swap_current(Some(context)));
    thread.binding.set(Some(binding));
    Ok(())
}

/// What EGL has made current; OSMesa's contexts have no display that it knows.
fn binding() -> Option<Binding> {
    thread(|thread| thread.binding.get()).filter(|binding| binding.display != OSMESA)
}

pub(super) fn current_context() -> Result<Handle> {
    let id = binding().map_or(0, |binding| binding.context);
    Ok(if thread(|thread| thread.api.get()) == Api::None { handle(0) } else { handle(id) })
}

pub(super) fn current_display() -> Result<Handle> {
    Ok(handle(binding().map_or(0, |binding| binding.display)))
}

pub(super) fn current_surface(which: Int) -> Result<Handle> {
    if which != EGL_DRAW && which != EGL_READ {
        return fail(Code::BadParameter, "readdraw must be EGL_DRAW or EGL_READ");
    }
    let surface = binding().and_then(|binding| match which {
        EGL_READ => binding.read.or(binding.surface),
        _ => binding.surface,
    });
    Ok(handle(surface.unwrap_or(0)))
}

pub(super) fn release_thread() -> Result<u32> {
    thread(|thread| {
        release(thread);
        thread.api.set(Api::None);
    });
    Ok(1)
}

/// `eglWaitClient` and `eglWaitGL`: calls are carried out before they are waited for.
pub(super) fn wait() -> Result<u32> {
    with_current(Context::flush);
    Ok(1)
}

pub(super) fn wait_native(engine: Int) -> Result<u32> {
    if engine != EGL_CORE_NATIVE_ENGINE {
        return fail(Code::BadParameter, "engine must be EGL_CORE_NATIVE_ENGINE");
    }
    Ok(1)
}

/// `eglSwapInterval`: nothing is swapped.
pub(super) fn swap_interval(dpy: Handle) -> Result<u32> {
    registry().display(dpy)?;
    match binding() {
        Some(binding) if binding.surface.is_some() => Ok(1),
        Some(_) => fail(Code::BadSurface, "no surface is current"),
        None => fail(Code::BadContext, "no context is current"),
    }
}
