//! Objects that several contexts share: GL 2.1, appendix D.
//!
//! The contexts of a group take turns: a call puts the group's objects in the place of the
//! context's own for as long as it runs, under the group's lock. A context without a group does
//! none of this. What one context records another sees after `glFlush` or `glFinish`.

use super::Objects;
use crate::context::Context;
use parking_lot::{Mutex, MutexGuard};
use std::sync::Arc;

/// Whether a call of a context runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Entered {
    No,
    /// Calls within it, as those of a display list, have the group's objects already.
    Yes,
}

/// The objects of a group, while no call of its contexts runs.
#[derive(Clone, Debug, Default)]
pub(crate) struct Group(Arc<Mutex<Objects>>);

impl Group {
    /// A group that has the shareable objects of a context.
    pub fn of(objects: &mut Objects) -> Self {
        let mut shared = Objects::default();
        exchange(objects, &mut shared);
        Self(Arc::new(Mutex::new(shared)))
    }

    /// Runs `f` with the group's objects in the context, whatever becomes of it.
    pub fn run<R>(&self, context: &mut Context, f: impl FnOnce(&mut Context) -> R) -> R {
        let mut shared = self.0.lock();
        exchange(&mut context.objects, &mut shared);
        context.entered = Entered::Yes;
        let turn = Turn { context, shared };
        f(turn.context)
    }
}

/// A call that has the group's objects; gives them back, even if the call panics.
struct Turn<'a> {
    context: &'a mut Context,
    shared: MutexGuard<'a, Objects>,
}

impl Drop for Turn<'_> {
    fn drop(&mut self) {
        self.context.entered = Entered::No;
        exchange(&mut self.context.objects, &mut self.shared);
    }
}

/// Exchanges what can be shared. Framebuffers, and the textures named 0, are a context's own.
fn exchange(a: &mut Objects, b: &mut Objects) {
    std::mem::swap(&mut a.textures, &mut b.textures);
    std::mem::swap(&mut a.samplers, &mut b.samplers);
    std::mem::swap(&mut a.buffers, &mut b.buffers);
    std::mem::swap(&mut a.renderbuffers, &mut b.renderbuffers);
    std::mem::swap(&mut a.programs, &mut b.programs);
    std::mem::swap(&mut a.syncs, &mut b.syncs);
    std::mem::swap(&mut a.lists, &mut b.lists);
}
