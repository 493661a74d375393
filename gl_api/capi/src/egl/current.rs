//! Making contexts and surfaces current (EGL 1.5, section 3.7.3).

use super::constants::*;
use super::error::{Code, Result, fail};
use super::raw::{Handle, Id, Int, handle};
use super::registry::{Holder, OSMESA, Registry, display, registry};
use super::thread::{Api, Binding, Thread, ThreadId, this_thread, thread};
use crate::main_thread::is_main_thread;
use gl_api::host::{self, FloatEnv, Surface, swap_current};
use gl_api::{Context, with_current};
use std::mem::replace;

/// What was current on this thread goes back to where it lies otherwise.
pub(crate) fn release(thread: &Thread) {
    let Some(binding) = thread.binding.take() else { return };
    let mut context = swap_current(None);
    if let Some(context) = &mut context {
        // While the registry is locked, every thread's calls of EGL wait.
        host::end_mirror(context);
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
    let read = host::swap_read_surface(&mut context, None);
    registry.lay_down(binding.read, read);
    let drawn = host::swap_surface(&mut context, Surface::absent());
    registry.lay_down(binding.surface, Some(drawn));
    if let Some(entry) = registry.contexts.get_mut(&binding.context) {
        entry.holder = Holder::Registry(context);
        if entry.doomed {
            registry.contexts.remove(&binding.context);
        }
    }
}

impl Registry {
    /// Takes the buffers of a surface for a thread; `None` if another has them.
    fn pick_up(&mut self, surface: Id, thread: ThreadId) -> Option<Surface> {
        let entry = self.surfaces.get_mut(&surface)?;
        let buffers = entry.buffers.take()?;
        entry.thread = Some(thread);
        Some(buffers)
    }

    /// The buffers to draw to and, if they are others, to read from; `None` if another thread has
    /// either.
    fn pick_up_both(
        &mut self,
        draw: Id,
        read: Option<Id>,
        thread: ThreadId,
    ) -> Option<(Surface, Option<Surface>)> {
        let drawn = self.pick_up(draw, thread)?;
        let Some(read) = read else { return Some((drawn, None)) };
        let found = self.pick_up(read, thread);
        if found.is_none() {
            self.lay_down(Some(draw), Some(drawn));
            return None;
        }
        Some((drawn, found))
    }

    /// Gives the buffers of a surface back, unless it was destroyed meanwhile.
    fn lay_down(&mut self, surface: Option<Id>, buffers: Option<Surface>) {
        let Some(id) = surface else { return };
        let Some(entry) = self.surfaces.get_mut(&id) else { return };
        entry.buffers = buffers;
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
    match entry.holder {
        Holder::Thread(thread) if thread != here => {
            return fail(Code::BadAccess, "ctx is current on another thread");
        }
        Holder::Thread(_) | Holder::Registry(_) => {}
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

/// What becomes of the current context where a thread ends: it goes back to the registry, so that another thread can
/// use it. Not on the main thread: with that the process ends, and what C runs last, functions of `atexit` and
/// destructors of static objects, comes after the destructors of the thread and may still use its context.
fn thread_ended() {
    if is_main_thread() {
        return;
    }
    let _float_env = FloatEnv::enter();
    // An OSMesa client's memory may have ended with its thread.
    with_current(|context| host::set_mirror(context, None));
    thread(release);
    drop(swap_current(None));
}

/// Makes current what was checked, in place of what is.
pub(crate) fn bind(thread: &Thread, binding: Binding) -> Result<()> {
    host::expect_thread_end(thread_ended);
    release(thread);
    let mut registry = registry();
    let here = this_thread();
    let Some(entry) = registry.contexts.get_mut(&binding.context) else {
        return fail(Code::BadContext, "ctx was destroyed meanwhile");
    };
    let mut context = match replace(&mut entry.holder, Holder::Thread(here)) {
        Holder::Registry(context) => context,
        Holder::Thread(other) => {
            entry.holder = Holder::Thread(other);
            return fail(Code::BadAccess, "ctx has become current on another thread");
        }
    };
    if binding.surface.is_none() {
        host::swap_surface(&mut context, Surface::absent());
    }
    let first = !replace(&mut entry.sized, true);
    let mut size = (0, 0);
    if let Some(id) = binding.surface {
        let Some((draw, read)) = registry.pick_up_both(id, binding.read, here) else {
            if let Some(entry) = registry.contexts.get_mut(&binding.context) {
                entry.holder = Holder::Registry(context);
            }
            return fail(Code::BadAccess, "a surface has become current on another thread");
        };
        size = registry.surfaces.get(&id).map_or(size, |entry| (entry.width, entry.height));
        host::swap_surface(&mut context, draw);
        host::swap_read_surface(&mut context, read);
    }
    if first {
        host::first_surface(&mut context, size.0, size.1);
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
    Ok(handle(binding().map_or(0, |binding| binding.context)))
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
        thread.api.set(Api::OpenGlEs);
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
