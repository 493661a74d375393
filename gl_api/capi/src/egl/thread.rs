//! What belongs to a thread: its error, its API, and what is current on it.

use super::constants::{EGL_OPENGL_API, EGL_OPENGL_ES_API, EGL_SUCCESS};
use super::raw::{Id, Int};
use std::cell::Cell;
use std::sync::atomic::{AtomicU64, Ordering};

/// What is current on a thread.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Binding {
    pub display: Id,
    pub context: Id,
    /// What is drawn to; `None` without a default framebuffer.
    pub surface: Option<Id>,
    /// What is read from, if it is another.
    pub read: Option<Id>,
}

/// The API that `eglBindAPI` chose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Api {
    /// Before the first call (EGL 1.5, section 3.7).
    OpenGlEs,
    OpenGl,
}

impl Api {
    /// EGL's value.
    pub fn encode(self) -> Int {
        match self {
            Self::OpenGlEs => EGL_OPENGL_ES_API,
            Self::OpenGl => EGL_OPENGL_API,
        }
    }
}

/// A thread, by a number that no other has. (One that is ending has no `std::thread::ThreadId`.)
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ThreadId(u64);

/// The thread that asks.
pub(crate) fn this_thread() -> ThreadId {
    static LAST: AtomicU64 = AtomicU64::new(0);
    thread(|thread| {
        let id = thread.id.get().unwrap_or_else(|| ThreadId(LAST.fetch_add(1, Ordering::Relaxed)));
        thread.id.set(Some(id));
        id
    })
}

/// What belongs to a thread. Nothing of it is to be destroyed, so it is there to the thread's end.
#[derive(Debug)]
pub(crate) struct Thread {
    id: Cell<Option<ThreadId>>,
    pub error: Cell<Int>,
    pub api: Cell<Api>,
    pub binding: Cell<Option<Binding>>,
}

thread_local! {
    static THREAD: Thread = const {
        Thread {
            id: Cell::new(None),
            error: Cell::new(EGL_SUCCESS),
            api: Cell::new(Api::OpenGlEs),
            binding: Cell::new(None),
        }
    };
}

/// Runs `f` with what belongs to this thread.
pub(crate) fn thread<R>(f: impl FnOnce(&Thread) -> R) -> R {
    THREAD.with(f)
}
