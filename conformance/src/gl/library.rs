//! Another library: its EGL, the functions of its GL, and contexts.

use gl_api::Api;
use gl_api::context::ContextDesc;
use khronos_egl as egl;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::atomic::{AtomicPtr, Ordering};
use std::sync::{Mutex, OnceLock, PoisonError};
use thiserror::Error;

type Egl = egl::DynamicInstance<egl::EGL1_4>;

/// Why a library cannot be used.
#[derive(Debug, Error)]
pub enum LibraryError {
    /// The library is not there, or is no EGL 1.4.
    #[error("{library} cannot be opened as EGL 1.4: {reason}")]
    Open {
        /// Its path or name.
        library: String,
        /// The loader's words.
        reason: String,
    },
    /// An EGL call failed.
    #[error("{call}: {reason}")]
    Egl {
        /// Which.
        call: &'static str,
        /// Its error.
        reason: String,
    },
}

/// A library whose functions stand in the place of DetGL's. It is never closed.
#[derive(Debug)]
pub struct Library {
    egl: &'static Egl,
    display: egl::Display,
    addresses: Mutex<BTreeMap<&'static str, usize>>,
}

static CHOSEN: AtomicPtr<Library> = AtomicPtr::new(std::ptr::null_mut());

thread_local! {
    static MISSING: RefCell<BTreeSet<&'static str>> = const { RefCell::new(BTreeSet::new()) };
}

/// The library that was chosen, if any.
pub fn chosen() -> Option<&'static Library> {
    // SAFETY: what is stored there is never freed.
    unsafe { CHOSEN.load(Ordering::Acquire).as_ref() }
}

/// Sends the calls of this process to a library, or to DetGL. No context may be current.
pub fn choose(library: Option<&'static Library>) {
    let pointer =
        library.map_or(std::ptr::null_mut(), |library| std::ptr::from_ref(library).cast_mut());
    CHOSEN.store(pointer, Ordering::Release);
}

/// The functions that this thread has asked for in vain, and forgets them.
pub(super) fn missing() -> String {
    let names = MISSING.take().into_iter().collect::<Vec<_>>();
    if names.is_empty() { String::new() } else { format!("it has no {}", names.join(", ")) }
}

fn failed(call: &'static str) -> impl Fn(egl::Error) -> LibraryError {
    move |error| LibraryError::Egl { call, reason: error.to_string() }
}

const CONTEXT_MAJOR: egl::Int = 0x3098;
const CONTEXT_MINOR: egl::Int = 0x30FB;
const CONTEXT_PROFILE: egl::Int = 0x30FD;
const PROFILE_CORE: egl::Int = 1;

/// The address of a function in the library that was asked first, whose own address stands beside it.
#[derive(Debug)]
pub(super) struct CachedAddress(OnceLock<(usize, Option<usize>)>);

impl CachedAddress {
    pub(super) const fn new() -> Self {
        Self(OnceLock::new())
    }
}

impl Library {
    /// Opens a libEGL by its path or name.
    ///
    /// # Errors
    /// When it is not there, or has no display.
    pub fn open(path: &Path) -> Result<&'static Self, LibraryError> {
        // SAFETY: loading runs the library's initializers; the path is the user's own argument.
        let opened = unsafe { Egl::load_required_from_filename(path) };
        let opened = opened.map_err(|error| LibraryError::Open {
            library: path.display().to_string(),
            reason: error.to_string(),
        })?;
        let egl: &'static Egl = Box::leak(Box::new(opened));
        // SAFETY: EGL_DEFAULT_DISPLAY is not dereferenced.
        let display = unsafe { egl.get_display(egl::DEFAULT_DISPLAY) };
        let display = display.ok_or_else(|| failed("eglGetDisplay")(egl::Error::BadDisplay))?;
        egl.initialize(display).map_err(failed("eglInitialize"))?;
        Ok(Box::leak(Box::new(Self { egl, display, addresses: Mutex::default() })))
    }

    /// The address of a function, which `cache` keeps: a look into a map would take longer than many calls.
    pub(super) fn cached_address(
        &'static self,
        cache: &CachedAddress,
        name: &'static str,
    ) -> Option<*const ()> {
        let library = std::ptr::from_ref(self).addr();
        let found = || self.address(name).map(|found| found.expose_provenance());
        match cache.0.get_or_init(|| (library, found())) {
            (of, Some(found)) if *of == library => Some(std::ptr::with_exposed_provenance(*found)),
            _ => self.address(name),
        }
    }

    /// The address of a function.
    fn address(&self, name: &'static str) -> Option<*const ()> {
        let mut known = self.addresses.lock().unwrap_or_else(PoisonError::into_inner);
        let found = *known.entry(name).or_insert_with(|| {
            self.egl.get_proc_address(name).map_or(0, |function| function as *const () as usize)
        });
        if found == 0 {
            MISSING.with_borrow_mut(|missing| missing.insert(name));
            return None;
        }
        Some(std::ptr::with_exposed_provenance(found))
    }

    /// Makes a new context current that draws to a pbuffer.
    ///
    /// # Errors
    /// What EGL says.
    pub fn context(&'static self, desc: &ContextDesc) -> Result<ForeignContext, LibraryError> {
        let Self { egl, display, .. } = self;
        let is_es = desc.api == Api::Es2;
        let api = if is_es { egl::OPENGL_ES_API } else { egl::OPENGL_API };
        egl.bind_api(api).map_err(failed("eglBindAPI"))?;
        #[rustfmt::skip]
        let wanted = [
            egl::SURFACE_TYPE, egl::PBUFFER_BIT,
            egl::RENDERABLE_TYPE, if is_es { egl::OPENGL_ES2_BIT } else { egl::OPENGL_BIT },
            egl::RED_SIZE, 8, egl::GREEN_SIZE, 8, egl::BLUE_SIZE, 8, egl::ALPHA_SIZE, 8,
            egl::DEPTH_SIZE, 24, egl::STENCIL_SIZE, 8,
            egl::NONE,
        ];
        let config =
            egl.choose_first_config(*display, &wanted).map_err(failed("eglChooseConfig"))?;
        let config = config.ok_or_else(|| failed("eglChooseConfig")(egl::Error::BadConfig))?;
        let size = [
            egl::WIDTH,
            desc.width.max(1) as egl::Int,
            egl::HEIGHT,
            desc.height.max(1) as egl::Int,
            egl::NONE,
        ];
        let surface = egl
            .create_pbuffer_surface(*display, config, &size)
            .map_err(failed("eglCreatePbufferSurface"))?;
        let core = [CONTEXT_MAJOR, 3, CONTEXT_MINOR, 3, CONTEXT_PROFILE, PROFILE_CORE, egl::NONE];
        let es = [CONTEXT_MAJOR, 3, CONTEXT_MINOR, 0, egl::NONE];
        let attributes: &[egl::Int] = match desc.api {
            Api::Core => &core,
            Api::Es2 => &es,
            Api::Compatibility | Api::Es1 => &[egl::NONE],
        };
        let context = egl
            .create_context(*display, config, None, attributes)
            .map_err(failed("eglCreateContext"))?;
        egl.make_current(*display, Some(surface), Some(surface), Some(context))
            .map_err(failed("eglMakeCurrent"))?;
        Ok(ForeignContext { library: self, context, surface })
    }
}

/// A context of a library, current until it is dropped.
#[derive(Debug)]
pub struct ForeignContext {
    library: &'static Library,
    context: egl::Context,
    surface: egl::Surface,
}

impl Drop for ForeignContext {
    fn drop(&mut self) {
        let Library { egl, display, .. } = self.library;
        // What a library refuses here costs memory only.
        let _ = egl.make_current(*display, None, None, None);
        let _ = egl.destroy_context(*display, self.context);
        let _ = egl.destroy_surface(*display, self.surface);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_library_is_named() {
        let error = Library::open(Path::new("/no/libEGL.so")).expect_err("there is none");
        assert!(error.to_string().contains("/no/libEGL.so"), "{error}");
    }
}
