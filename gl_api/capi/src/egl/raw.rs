//! EGL's types as C has them, and what is behind its pointers.

use super::constants::EGL_NONE;
use std::ffi::c_void;

/// A handle as C has it.
pub(crate) type Handle = *mut c_void;
/// A handle as a number.
pub(crate) type Id = usize;

/// A number as a handle.
pub(crate) fn handle(id: Id) -> Handle {
    std::ptr::without_provenance_mut(id)
}

/// `EGLint`.
pub(crate) type Int = i32;
/// `EGLAttrib`.
pub(crate) type Attrib = isize;

/// The attribute list of EGL 1.4 and of extensions: pairs up to `EGL_NONE`.
///
/// # Safety
/// A pointer that is not null ends with `EGL_NONE`.
pub(crate) unsafe fn int_attributes(list: *const Int) -> Vec<(Int, Attrib)> {
    let mut pairs = Vec::new();
    let mut at = list;
    while !at.is_null() {
        // SAFETY: promised by the caller; the list has not ended yet.
        let name = unsafe { at.read_unaligned() };
        if name == EGL_NONE {
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
        if name == EGL_NONE as Attrib {
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
pub(crate) unsafe fn put<T>(out: *mut T, value: T) {
    if !out.is_null() {
        // SAFETY: promised by the caller.
        unsafe { out.write_unaligned(value) };
    }
}
