//! EGL 1.5 without windows: the surfaceless, device and default platforms.
//!
//! Handles are numbers that are looked up, never addresses, and are not used twice: one that is
//! null, freed or made up gets its `EGL_BAD_…`. Contexts and surfaces lie in one registry under a
//! lock; while current, a context is in its thread's place ([`gl_api::set_current`]), and GL
//! calls touch no lock.
//!
//! | module | is |
//! |---|---|
//! | [`functions`] | the table of functions |
//! | [`error`] | refusals, and `eglGetError` |
//! | [`registry`] | displays, contexts, surfaces and syncs by handle; what a thread has |
//! | [`display`] | platforms, devices, `eglInitialize`, `eglQueryString` |
//! | [`config`] | the table of configs, `eglChooseConfig` |
//! | [`surface`] | pbuffers |
//! | [`context`] | `eglCreateContext` and its attributes |
//! | [`current`] | `eglMakeCurrent` |
//! | [`sync`] | fences |

mod config;
mod context;
pub(crate) mod current;
pub(crate) mod display;
mod error;
mod functions;
pub(crate) mod registry;
mod surface;
mod sync;

pub(crate) use context::shared_by;
pub(crate) use error::{Code, call, fail};
pub(crate) use functions::FUNCTIONS;

use std::ffi::c_void;

/// EGL's constants, from the Khronos registry.
#[expect(dead_code, non_upper_case_globals, reason = "the whole registry with its own names")]
pub(crate) mod constants {
    include!(concat!(env!("OUT_DIR"), "/egl.rs"));
}

/// A handle as C has it.
pub(crate) type Handle = *mut c_void;
/// `EGLint`.
pub(crate) type Int = i32;
/// `EGLAttrib`.
pub(crate) type Attrib = isize;

/// The attribute list of EGL 1.4 and of extensions: pairs up to `EGL_NONE`.
///
/// # Safety
/// A pointer that is not null ends with `EGL_NONE`.
unsafe fn int_attributes(list: *const Int) -> Vec<(Int, Attrib)> {
    let mut pairs = Vec::new();
    let mut at = list;
    while !at.is_null() {
        // SAFETY: promised by the caller; the list has not ended yet.
        let name = unsafe { at.read_unaligned() };
        if name == constants::EGL_NONE {
            break;
        }
        // SAFETY: a name is followed by its value, and by the next name or the end.
        unsafe {
            pairs.push((name, at.add(1).read_unaligned() as Attrib));
            at = at.add(2);
        }
    }
    pairs
}

/// The attribute list of EGL 1.5.
///
/// # Safety
/// As for [`int_attributes`].
pub(crate) unsafe fn attributes(list: *const Attrib) -> Vec<(Int, Attrib)> {
    let mut pairs = Vec::new();
    let mut at = list;
    while !at.is_null() {
        // SAFETY: promised by the caller; the list has not ended yet.
        let name = unsafe { at.read_unaligned() };
        if name == constants::EGL_NONE as Attrib {
            break;
        }
        // SAFETY: a name is followed by its value, and by the next name or the end.
        unsafe {
            // A name that does not fit is none that exists.
            pairs.push((Int::try_from(name).unwrap_or(Int::MIN), at.add(1).read_unaligned()));
            at = at.add(2);
        }
    }
    pairs
}

/// Writes a result where the client wants one.
///
/// # Safety
/// A pointer that is not null can be written to.
unsafe fn put<T>(out: *mut T, value: T) {
    if !out.is_null() {
        // SAFETY: promised by the caller.
        unsafe { out.write_unaligned(value) };
    }
}
