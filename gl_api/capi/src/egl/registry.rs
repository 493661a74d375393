//! Displays, contexts, surfaces, syncs and images by handle.

use super::config::Config;
use super::error::{Code, Result, fail};
use super::raw::{Handle, Id};
use super::thread::{Api, ThreadId};
use gl_api::host::{self, EglImage, ShareHandle, Surface};
use gl_api::{Context, ResetNotification};
use std::collections::BTreeMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

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
    pub client: Api,
    /// `None` was made with `EGL_NO_CONFIG_KHR`.
    pub config: Option<&'static Config>,
    pub holder: Holder,
    /// For those that share its objects, wherever it is current.
    pub share: ShareHandle,
    /// What it reports of stopped draws: the same in all that share.
    pub reset_notification: ResetNotification,
    /// Destroyed, and gone when it is current no more.
    pub doomed: bool,
    /// Whether viewport and scissor have had their first surface (GL 2.1, section 2.11.1).
    pub sized: bool,
}

impl ContextEntry {
    /// A new one, current nowhere.
    pub fn new(
        display: Id,
        client: Api,
        config: Option<&'static Config>,
        context: Box<Context>,
    ) -> Self {
        let share = host::share(&context);
        let reset_notification = host::reset_notification(&context);
        let holder = Holder::Registry(context);
        let (doomed, sized) = (false, false);
        Self { display, client, config, holder, share, reset_notification, doomed, sized }
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
    /// Images, and the display of each.
    pub images: BTreeMap<Id, (Id, EglImage)>,
}

static REGISTRY: Mutex<Registry> = Mutex::new(Registry {
    next: FIRST,
    initialized: Vec::new(),
    contexts: BTreeMap::new(),
    surfaces: BTreeMap::new(),
    syncs: BTreeMap::new(),
    images: BTreeMap::new(),
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
