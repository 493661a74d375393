//! Functions by name: what `eglGetProcAddress`, `OSMesaGetProcAddress` and Rust's loaders answer.

use crate::context::Context;
use std::collections::BTreeMap;
use std::ffi::c_void;
use std::sync::LazyLock;

/// Addresses, as numbers so that threads can share them.
static GL: LazyLock<BTreeMap<&str, usize>> = LazyLock::new(|| {
    crate::entry::rows().map(|(name, _, f)| (name, f.expose_provenance())).collect()
});

/// The C function of a GL entry point; null where there is none.
pub(crate) fn gl(name: &str) -> *const c_void {
    GL.get(name).map_or(std::ptr::null(), |&address| std::ptr::with_exposed_provenance(address))
}

/// A function of any of the libraries that this one stands in for; null where there is none.
pub(crate) fn any(name: &str) -> *const c_void {
    let libraries = [gl, super::egl::address, super::osmesa::address, super::glu::address];
    let found = libraries.into_iter().map(|library| library(name));
    found.into_iter().find(|address| !address.is_null()).unwrap_or(std::ptr::null())
}

impl Context {
    /// The C function of a GL entry point, for the thread's current context; null for a name that
    /// is not implemented. Loaders take it as it is:
    /// `glow::Context::from_loader_function(Context::get_proc_address)`,
    /// `gl::load_with(Context::get_proc_address)`. Names of EGL, OSMesa and GLU are known too.
    pub fn get_proc_address(name: &str) -> *const c_void {
        any(name)
    }
}
