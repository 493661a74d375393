//! Fence sync objects: `ARB_sync`, GL 3.2, section 5.3. Submitting executes recorded draws, so a fence is signalled by
//! the next flush of the context that made it.

use parking_lot::{Condvar, Mutex};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Whether the commands before a fence have completed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Status {
    #[default]
    Unsignaled,
    Signaled,
}

/// A fence, which threads can wait for without the lock of the share group.
#[derive(Debug, Default)]
pub(crate) struct Fence {
    status: Mutex<Status>,
    signaled: Condvar,
}

impl Fence {
    pub fn status(&self) -> Status {
        *self.status.lock()
    }

    fn signal(&self) {
        *self.status.lock() = Status::Signaled;
        self.signaled.notify_all();
    }

    /// Waits until the fence is signalled, or for so long.
    pub fn wait(&self, timeout: Duration) -> Status {
        let end = Instant::now().checked_add(timeout);
        let mut status = self.status.lock();
        while *status == Status::Unsignaled {
            match end {
                Some(end) if self.signaled.wait_until(&mut status, end).timed_out() => break,
                Some(_) => {}
                None => self.signaled.wait(&mut status),
            }
        }
        *status
    }
}

/// The fence of the commands that a context has recorded and not executed: they are executed together, so that all fences
/// among them are one. Dropped, it is signalled: with a context its recorded commands end, and nobody waits in vain.
#[derive(Debug, Default)]
pub(crate) struct PendingFences(Option<Arc<Fence>>);

impl PendingFences {
    /// The fence of what is recorded, and of what is until it is executed.
    pub fn fence(&mut self) -> Arc<Fence> {
        Arc::clone(self.0.get_or_insert_default())
    }

    pub fn contains(&self, fence: &Arc<Fence>) -> bool {
        self.0.as_ref().is_some_and(|pending| Arc::ptr_eq(pending, fence))
    }

    /// Signals all: what was recorded before them has been executed.
    pub fn signal(&mut self) {
        if let Some(fence) = self.0.take() {
            fence.signal();
        }
    }
}

impl Drop for PendingFences {
    fn drop(&mut self) {
        self.signal();
    }
}

/// The fences of a share group, sorted by handle.
#[derive(Debug, Default)]
pub(crate) struct Syncs {
    fences: Vec<(usize, Arc<Fence>)>,
    last: usize,
}

impl Syncs {
    /// Whether a handle is a fence.
    pub fn contains(&self, handle: usize) -> bool {
        self.position(handle).is_some()
    }

    fn position(&self, handle: usize) -> Option<usize> {
        self.fences.binary_search_by_key(&handle, |(handle, _)| *handle).ok()
    }

    /// The fence of a handle.
    pub fn get(&self, handle: usize) -> Option<&Arc<Fence>> {
        self.position(handle).map(|at| &self.fences[at].1)
    }

    /// Adds a fence; gives its handle.
    pub fn add(&mut self, fence: Arc<Fence>) -> usize {
        self.last += 1;
        self.fences.push((self.last, fence));
        self.last
    }

    /// Removes a fence; who waits for it goes on waiting.
    pub fn remove(&mut self, handle: usize) {
        if let Some(at) = self.position(handle) {
            self.fences.remove(at);
        }
    }
}
