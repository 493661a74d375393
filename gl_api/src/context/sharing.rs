//! Share groups: objects that several contexts share (GL 2.1, appendix D).
//!
//! **What a group owns.** A [`ShareGroup`] owns the names and the objects of textures, samplers, buffers, renderbuffers,
//! shaders and programs, assembly programs, sync objects and display lists. Framebuffer objects, vertex array objects,
//! queries, the objects named 0 and all state are each context's own. A context that shares with nobody has no group:
//! its objects are in [`Context::objects`] for good, and there is no lock.
//!
//! **When the lock is taken.** Every entry point of a context with a group takes the group's lock for as long as it runs
//! ([`SharedObjectsGuard`]), so calls of different contexts never overlap. A call within a call, as those of a display
//! list, finds the lock held ([`GroupLock::Held`]) and does not take it again.
//!
//! **What a call sees.** Under the lock, the group's objects are exchanged with those in [`Context::objects`], and
//! exchanged back when the call returns or panics. So the code of a call finds objects in one place, whether they are
//! shared or not. Names and parameters that another context has changed are seen by the next call. What another context
//! has drawn is seen after its `glFlush` or `glFinish`, as draws are recorded until then.
//!
//! **How a context joins.** [`Context::shared`] gives a [`ShareHandle`], from which a context is made. Where the context
//! to share with is current on another thread, a [`ShareRequest`] asks for the handle.

use crate::context::Context;
use crate::objects::Objects;
use parking_lot::{ArcMutexGuard, Condvar, Mutex, RawMutex};
use rasterizer::driver::Device;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Whether a context holds the lock of its group. One without a group never does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum GroupLock {
    /// No call runs: the shared objects are in the group.
    NotHeld,
    /// A call runs: the shared objects are in the context.
    Held,
}

/// A share group. Its objects are here while none of its contexts holds the lock.
#[derive(Clone, Debug, Default)]
pub(crate) struct ShareGroup(pub(crate) Arc<Mutex<Objects>>);

impl ShareGroup {
    /// A group that takes over the shareable objects of a context.
    pub fn of(objects: &mut Objects) -> Self {
        let mut shared = Objects::default();
        exchange(objects, &mut shared);
        Self(Arc::new(Mutex::new(shared)))
    }
}

/// What a new context needs to share the objects of another.
#[derive(Clone, Debug)]
pub(crate) struct ShareHandle {
    pub group: ShareGroup,
    pub device: Arc<Device>,
}

/// A request to share the objects of a context that is current on another thread. The context answers at its next call,
/// or when it is released.
#[derive(Clone, Debug, Default)]
pub(crate) struct ShareRequest(Arc<RequestState>);

#[derive(Debug, Default)]
struct RequestState {
    open: AtomicBool,
    answer: Mutex<Option<ShareHandle>>,
    answered: Condvar,
}

impl ShareRequest {
    /// Whether a thread waits for the answer.
    pub fn is_open(&self) -> bool {
        self.0.open.load(Ordering::Acquire)
    }

    /// Makes the request; [`Self::wait`] waits for the answer.
    pub fn open(&self) {
        self.0.open.store(true, Ordering::Release);
    }

    /// Waits for the answer; `None` if there is none within `patience`.
    pub fn wait(&self, patience: Duration) -> Option<ShareHandle> {
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

    /// Answers all threads that wait.
    pub fn answer(&self, shared: ShareHandle) {
        self.0.open.store(false, Ordering::Release);
        *self.0.answer.lock() = Some(shared);
        self.0.answered.notify_all();
    }
}

/// Exchanges the objects that can be shared. The textures and assembly programs named 0 are not among them.
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

/// A running call. While it exists, the context holds the lock of its group, if it has one, and has the group's objects;
/// dropped, also by a panic, it gives them back.
pub(crate) struct SharedObjectsGuard<'a> {
    pub context: &'a mut Context,
    shared: Option<ArcMutexGuard<RawMutex, Objects>>,
}

impl<'a> SharedObjectsGuard<'a> {
    /// Waits for the calls of other contexts of the group, and takes the group's objects. Without a group, or within a
    /// call that has them already, there is nothing to do.
    pub fn lock(context: &'a mut Context) -> Self {
        let mut guard = Self { context, shared: None };
        if guard.context.group_to_lock().is_some() {
            guard.take_objects();
        }
        guard
    }

    #[inline(never)]
    fn take_objects(&mut self) {
        if let Some(group) = self.context.group_to_lock() {
            let mut shared = group.0.lock_arc();
            exchange(&mut self.context.objects, &mut shared);
            self.context.group_lock = GroupLock::Held;
            self.shared = Some(shared);
        }
    }

    #[inline(never)]
    fn give_back_objects(&mut self) {
        if let Some(mut shared) = self.shared.take() {
            self.context.group_lock = GroupLock::NotHeld;
            exchange(&mut self.context.objects, &mut shared);
        }
    }
}

impl Drop for SharedObjectsGuard<'_> {
    #[inline]
    fn drop(&mut self) {
        if self.shared.is_some() {
            self.give_back_objects();
        }
    }
}
