//! Objects that several contexts share: GL 2.1, appendix D.
//!
//! The contexts of a group take turns: a call puts the group's objects in the place of the
//! context's own for as long as it runs, under the group's lock. A context without a group does
//! none of this. What one context records another sees after `glFlush` or `glFinish`.

use crate::context::Context;
use crate::objects::Objects;
use parking_lot::{ArcMutexGuard, Condvar, Mutex, RawMutex};
use rasterizer::driver::Device;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Whether a call of a context runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Entered {
    No,
    /// Calls within it, as those of a display list, have the group's objects already.
    Yes,
}

/// The objects of a group, while no call of its contexts runs.
#[derive(Clone, Debug, Default)]
pub(crate) struct Group(pub(crate) Arc<Mutex<Objects>>);

impl Group {
    /// A group that has the shareable objects of a context.
    pub fn of(objects: &mut Objects) -> Self {
        let mut shared = Objects::default();
        exchange(objects, &mut shared);
        Self(Arc::new(Mutex::new(shared)))
    }
}

/// What a new context needs to share the objects of another.
#[derive(Clone, Debug)]
pub(crate) struct Shared {
    pub group: Group,
    pub device: Arc<Device>,
}

/// How a thread comes to share the objects of a context that is current on another: it asks, and the
/// context answers at its next call or when it is released.
#[derive(Clone, Debug, Default)]
pub(crate) struct Invitation(Arc<Asked>);

#[derive(Debug, Default)]
struct Asked {
    open: AtomicBool,
    answer: Mutex<Option<Shared>>,
    answered: Condvar,
}

impl Invitation {
    /// Whether a thread waits.
    pub fn is_open(&self) -> bool {
        self.0.open.load(Ordering::Acquire)
    }

    /// Asks: [`Self::wait`] waits for the answer.
    pub fn open(&self) {
        self.0.open.store(true, Ordering::Release);
    }

    /// Waits until the context has answered; `None` if it makes no call for so long.
    pub fn wait(&self, patience: Duration) -> Option<Shared> {
        let end = Instant::now() + patience;
        let mut answer = self.0.answer.lock();
        while answer.is_none() {
            if self.0.answered.wait_until(&mut answer, end).timed_out() {
                break;
            }
        }
        self.0.open.store(false, Ordering::Release);
        answer.clone()
    }

    /// Ends the waiting of all who ask.
    pub fn answer(&self, shared: Shared) {
        self.0.open.store(false, Ordering::Release);
        *self.0.answer.lock() = Some(shared);
        self.0.answered.notify_all();
    }
}

/// Exchanges what can be shared. Framebuffers, and the textures and assembly programs
/// named 0, are a context's own.
pub(crate) fn exchange(a: &mut Objects, b: &mut Objects) {
    std::mem::swap(&mut a.textures, &mut b.textures);
    std::mem::swap(&mut a.samplers, &mut b.samplers);
    std::mem::swap(&mut a.buffers, &mut b.buffers);
    std::mem::swap(&mut a.renderbuffers, &mut b.renderbuffers);
    std::mem::swap(&mut a.programs, &mut b.programs);
    std::mem::swap(&mut a.doomed_programs, &mut b.doomed_programs);
    std::mem::swap(&mut a.assemblies, &mut b.assemblies);
    std::mem::swap(&mut a.syncs, &mut b.syncs);
    std::mem::swap(&mut a.lists, &mut b.lists);
}

/// A call, which has the objects of its context's group; gives them back, even if it panics.
pub(crate) struct Turn<'a> {
    pub context: &'a mut Context,
    shared: Option<ArcMutexGuard<RawMutex, Objects>>,
}

impl<'a> Turn<'a> {
    /// Waits for the calls of other contexts of the group; without a group there is nothing to do.
    pub fn begin(context: &'a mut Context) -> Self {
        let mut turn = Self { context, shared: None };
        if turn.context.group_outside().is_some() {
            turn.fetch();
        }
        turn
    }

    #[inline(never)]
    fn fetch(&mut self) {
        if let Some(group) = self.context.group_outside() {
            let mut shared = group.0.lock_arc();
            exchange(&mut self.context.objects, &mut shared);
            self.context.entered = Entered::Yes;
            self.shared = Some(shared);
        }
    }

    #[inline(never)]
    fn give_back(&mut self) {
        if let Some(mut shared) = self.shared.take() {
            self.context.entered = Entered::No;
            exchange(&mut self.context.objects, &mut shared);
        }
    }
}

impl Drop for Turn<'_> {
    #[inline]
    fn drop(&mut self) {
        if self.shared.is_some() {
            self.give_back();
        }
    }
}
