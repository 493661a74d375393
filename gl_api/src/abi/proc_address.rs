//! Functions by name: what `eglGetProcAddress`, `OSMesaGetProcAddress` and Rust's loaders answer.

use super::{egl, glu, osmesa};
use crate::context::Context;
use std::collections::BTreeMap;
use std::ffi::{CStr, c_char, c_void};
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
    let found = gl(name);
    if !found.is_null() {
        return found;
    }
    let others = [egl::FUNCTIONS, osmesa::FUNCTIONS, glu::FUNCTIONS];
    let found = others.into_iter().flatten().find(|row| row.0 == name);
    found.map_or(std::ptr::null(), |row| row.1.cast())
}

/// [`any`] of a name from C; null for null.
///
/// # Safety
/// What is not null is text that a zero ends.
pub(super) unsafe fn named(name: *const c_char) -> *const c_void {
    if name.is_null() {
        return std::ptr::null();
    }
    // SAFETY: promised by the caller.
    let name = unsafe { CStr::from_ptr(name) };
    name.to_str().map_or(std::ptr::null(), any)
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
