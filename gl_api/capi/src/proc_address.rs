//! Functions by name: what `eglGetProcAddress`, `OSMesaGetProcAddress`, `glXGetProcAddress` and Rust's loaders answer.

use crate::egl::error::{Code, call, fail};
#[cfg(feature = "c-names")]
use crate::glx;
use crate::guard::guard;
use crate::{egl, gl, glu, info, osmesa};
use gl_api::availability::{Api, Version};
use std::collections::BTreeMap;
use std::ffi::{CStr, c_char, c_void};
use std::sync::LazyLock;

/// Addresses, as numbers so that threads can share them.
static GL: LazyLock<BTreeMap<&str, usize>> = LazyLock::new(|| {
    gl::functions().into_iter().map(|(name, f)| (name, f.expose_provenance())).collect()
});

/// Those of this module that programs ask for by name.
const FUNCTIONS: &[(&str, *const ())] = &[
    ("eglGetProcAddress", eglGetProcAddress as *const ()),
    ("OSMesaGetProcAddress", OSMesaGetProcAddress as *const ()),
];

/// The C function of a GL entry point; null where there is none.
fn gl_function(name: &str) -> *const c_void {
    GL.get(name).map_or(std::ptr::null(), |&address| std::ptr::with_exposed_provenance(address))
}

/// The C function of a name of GL, EGL, OSMesa or GLU, for the thread's current context; null where there is none.
/// Loaders take it as it is: `glow::Context::from_loader_function(detgl::get_proc_address)`,
/// `gl::load_with(detgl::get_proc_address)`.
pub fn get_proc_address(name: &str) -> *const c_void {
    let found = gl_function(name);
    if !found.is_null() {
        return found;
    }
    let others = [FUNCTIONS, egl::FUNCTIONS, osmesa::FUNCTIONS, glu::FUNCTIONS, info::FUNCTIONS];
    let found = others.into_iter().flatten().find(|row| row.0 == name);
    found.map_or(std::ptr::null(), |row| row.1.cast())
}

/// The C function of a GL entry point that a version of an API has, by itself or by one of its extensions; null where
/// there is none.
pub fn get_proc_address_of(api: Api, version: Version, name: &str) -> *const c_void {
    let names = gl_api::table().flat_map(|row| row.names).filter(|row| row.name == name);
    let mut names = names.map(|row| row.availability);
    let of_api = |found: gl_api::availability::Availability| {
        found.is_in(api, version) || found.extensions_of(api).next().is_some()
    };
    if names.any(of_api) { gl_function(name) } else { std::ptr::null() }
}

/// [`get_proc_address`] of a name from C; null for null.
///
/// # Safety
/// What is not null is text that a zero ends.
pub(crate) unsafe fn named(name: *const c_char) -> *const c_void {
    if name.is_null() {
        return std::ptr::null();
    }
    // SAFETY: promised by the caller.
    let name = unsafe { CStr::from_ptr(name) };
    name.to_str().map_or(std::ptr::null(), get_proc_address)
}

#[cfg_attr(feature = "c-names", unsafe(no_mangle))]
#[allow(non_snake_case, reason = "EGL's name")]
unsafe extern "C" fn eglGetProcAddress(name: *const c_char) -> *const c_void {
    call::<*const c_void>("eglGetProcAddress", || {
        if name.is_null() {
            return fail(Code::BadParameter, "procname must not be NULL");
        }
        // SAFETY: ended by a zero, as C's prototype says.
        Ok(unsafe { named(name) })
    })
}

/// [`named`], and the functions of GLX: programs that load those by name call what GLX 1.4 has without looking.
///
/// # Safety
/// What is not null is text that a zero ends.
#[cfg(feature = "c-names")]
unsafe fn named_in_glx(name: *const c_char) -> *const c_void {
    // SAFETY: promised by the caller.
    let found = unsafe { named(name) };
    if name.is_null() || !found.is_null() {
        return found;
    }
    // SAFETY: promised by the caller.
    match unsafe { CStr::from_ptr(name) }.to_bytes() {
        b"glXGetProcAddress" => (glXGetProcAddress as *const ()).cast(),
        b"glXGetProcAddressARB" => (glXGetProcAddressARB as *const ()).cast(),
        other => std::str::from_utf8(other).map_or(std::ptr::null(), glx::function),
    }
}

/// Functions that answer an address and have no errors.
macro_rules! by_name {
    ($($(#[$meta:meta])* $name:ident: $find:ident)*) => { $(
        $(#[$meta])*
        #[cfg_attr(feature = "c-names", unsafe(no_mangle))]
        #[allow(non_snake_case, reason = "C's name")]
        unsafe extern "C" fn $name(name: *const c_char) -> *const c_void {
            // SAFETY: C's prototype promises the same.
            guard(stringify!($name), || unsafe { $find(name) })
        }
    )* };
}

by_name! {
    OSMesaGetProcAddress: named
    #[cfg(feature = "c-names")] glXGetProcAddress: named_in_glx
    #[cfg(feature = "c-names")] glXGetProcAddressARB: named_in_glx
}
