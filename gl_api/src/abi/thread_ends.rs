//! What happens to a thread's current context when the thread ends.
//!
//! It goes back to EGL's registry, so that another thread can use it. Not on the main thread: with
//! that the process ends, and what C runs last, functions of `atexit` and destructors of static
//! objects, comes after the destructors of the thread and may still use its context.

use super::egl::{current, registry::thread};
use crate::entry::{swap_current, with_current};

/// Its destructor is the thread's end.
struct End;

impl Drop for End {
    fn drop(&mut self) {
        if is_main_thread() {
            return;
        }
        // An OSMesa client's memory may have ended with its thread.
        with_current(|context| context.mirror = None);
        thread(current::release);
        drop(swap_current(None));
    }
}

thread_local! {
    static END: End = const { End };
}

/// Sees to it that the current context is taken care of when this thread ends. A thread that is
/// ending already keeps it.
pub(crate) fn expect() {
    // The first use registers the destructor.
    let _ = END.try_with(|_| ());
}

#[cfg(all(
    target_os = "linux",
    any(target_arch = "x86_64", target_arch = "aarch64", target_arch = "x86", target_arch = "arm")
))]
unsafe extern "C" {
    safe fn getpid() -> std::ffi::c_int;
    fn syscall(number: std::ffi::c_long, ...) -> std::ffi::c_long;
}

/// Whether this is the thread that the process began with.
#[cfg(all(
    target_os = "linux",
    any(target_arch = "x86_64", target_arch = "aarch64", target_arch = "x86", target_arch = "arm")
))]
fn is_main_thread() -> bool {
    // `gettid`, as a function, is younger than the C libraries that this one runs with.
    const GETTID: std::ffi::c_long = if cfg!(target_arch = "x86_64") {
        186
    } else if cfg!(target_arch = "aarch64") {
        178
    } else {
        224
    };
    // SAFETY: the call takes no arguments and cannot fail.
    let id = unsafe { syscall(GETTID) };
    id == std::ffi::c_long::from(getpid())
}

/// Whether this is the thread that the process began with; not known here.
#[cfg(not(all(
    target_os = "linux",
    any(target_arch = "x86_64", target_arch = "aarch64", target_arch = "x86", target_arch = "arm")
)))]
fn is_main_thread() -> bool {
    false
}
