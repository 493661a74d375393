//! Displays, contexts, surfaces and syncs by handle, and what belongs to a thread.

use super::config::Config;
use super::error::{Code, Result, fail};
use super::{Handle, Int};
use gl_api::Context;
use gl_api::host::{Invitation, Surface};
use std::cell::Cell;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A handle as a number.
pub(crate) type Id = usize;

/// Where a display came from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Platform {
    /// `eglGetDisplay(EGL_DEFAULT_DISPLAY)`.
    Default,
    /// `EGL_PLATFORM_SURFACELESS_MESA`.
    Surfaceless,
    /// `EGL_PLATFORM_DEVICE_EXT`.
    Device,
}

impl Platform {
    pub const ALL: [Self; 3] = [Self::Default, Self::Surfaceless, Self::Device];

    /// The handle of the platform's one display.
    pub fn display(self) -> Id {
        match self {
            Self::Default => 0x10,
            Self::Surfaceless => 0x20,
            Self::Device => 0x30,
        }
    }
}

/// What OSMesa's contexts have as display: no EGL handle is this number.
pub(crate) const OSMESA: Id = 0x50;
/// The handle of the one device.
pub(super) const DEVICE: Id = 0x40;
/// Objects' handles begin here.
const FIRST: Id = 0x1000;

/// Who has a context.
#[derive(Debug)]
pub(crate) enum Holder {
    /// The registry: it is current on no thread.
    Registry(Box<Context>),
    /// The thread on which it is current.
    Thread(ThreadId),
}

#[derive(Debug)]
pub(crate) struct ContextEntry {
    pub display: Id,
    /// `None` was made with `EGL_NO_CONFIG_KHR`.
    pub config: Option<&'static Config>,
    pub holder: Holder,
    /// How other threads ask it to share while it is current.
    pub invitation: Invitation,
    /// Destroyed, and gone when it is current no more.
    pub doomed: bool,
    /// Whether viewport and scissor have had their first surface (GL 2.1, section 2.11.1).
    pub sized: bool,
}

impl ContextEntry {
    /// A new one, current nowhere.
    pub fn new(display: Id, config: Option<&'static Config>, context: Box<Context>) -> Self {
        let invitation = Invitation::of(&context);
        let holder = Holder::Registry(context);
        Self { display, config, holder, invitation, doomed: false, sized: false }
    }
}

/// What `eglSurfaceAttrib` sets, which has no effect without a swap and without mipmaps.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Settings {
    pub mipmap_level: i32,
    pub swap: SwapBehavior,
}

/// What a swap does to the buffer that was drawn to (EGL 1.5, section 3.5.6).
#[derive(Clone, Copy, Debug, Default)]
pub(crate) enum SwapBehavior {
    #[default]
    Preserved,
    Destroyed,
}

#[derive(Debug)]
pub(crate) struct SurfaceEntry {
    pub display: Id,
    /// `None` is the memory of an OSMesa client.
    pub config: Option<&'static Config>,
    pub width: u32,
    pub height: u32,
    pub largest: bool,
    pub settings: Settings,
    /// The buffers, unless the surface is current.
    pub buffers: Option<Surface>,
    /// The thread it is current on.
    pub thread: Option<ThreadId>,
    /// Destroyed, and gone when it is current no more.
    pub doomed: bool,
}

/// Everything that has a handle.
#[derive(Debug)]
pub(crate) struct Registry {
    next: Id,
    pub initialized: Vec<Id>,
    pub contexts: BTreeMap<Id, ContextEntry>,
    pub surfaces: BTreeMap<Id, SurfaceEntry>,
    /// Fences, and the display of each.
    pub syncs: BTreeMap<Id, Id>,
}

static REGISTRY: Mutex<Registry> = Mutex::new(Registry {
    next: FIRST,
    initialized: Vec::new(),
    contexts: BTreeMap::new(),
    surfaces: BTreeMap::new(),
    syncs: BTreeMap::new(),
});

/// Locks the registry. Nothing is half done in it when a panic lets go of it.
pub(crate) fn registry() -> MutexGuard<'static, Registry> {
    REGISTRY.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Registry {
    /// A handle that was never used.
    pub fn new_id(&mut self) -> Id {
        let id = self.next;
        self.next += 0x10;
        id
    }

    /// A display that is initialized.
    pub fn display(&self, handle: Handle) -> Result<Id> {
        let id = display(handle)?;
        if self.initialized.contains(&id) {
            return Ok(id);
        }
        fail(Code::NotInitialized, "dpy is not initialized: call eglInitialize")
    }

    /// A context of a display.
    pub fn context(&mut self, display: Id, handle: Handle) -> Result<(Id, &mut ContextEntry)> {
        let id = handle.addr();
        match self.contexts.get_mut(&id) {
            Some(entry) if entry.display == display && !entry.doomed => Ok((id, entry)),
            _ => fail(Code::BadContext, format!("ctx = {id:#x} is no context of this display")),
        }
    }

    /// A surface of a display.
    pub fn surface(&mut self, display: Id, handle: Handle) -> Result<(Id, &mut SurfaceEntry)> {
        let id = handle.addr();
        match self.surfaces.get_mut(&id) {
            Some(entry) if entry.display == display && !entry.doomed => Ok((id, entry)),
            _ => fail(Code::BadSurface, format!("surface {id:#x} is none of this display")),
        }
    }
}

/// A display, initialized or not.
pub(super) fn display(handle: Handle) -> Result<Id> {
    let id = handle.addr();
    if Platform::ALL.into_iter().any(|platform| platform.display() == id) {
        return Ok(id);
    }
    fail(Code::BadDisplay, format!("dpy = {id:#x} is no display"))
}

/// A number as a handle.
pub(crate) fn handle(id: Id) -> Handle {
    std::ptr::without_provenance_mut(id)
}

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
    /// Before the first call: OpenGL ES would be the default, but there is none.
    None,
    OpenGl,
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
            error: Cell::new(super::constants::EGL_SUCCESS),
            api: Cell::new(Api::None),
            binding: Cell::new(None),
        }
    };
}

/// Runs `f` with what belongs to this thread.
pub(crate) fn thread<R>(f: impl FnOnce(&Thread) -> R) -> R {
    THREAD.with(f)
}
