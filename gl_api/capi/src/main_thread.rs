//! Whether this is the thread that the process began with.

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
pub(crate) fn is_main_thread() -> bool {
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
pub(crate) fn is_main_thread() -> bool {
    false
}
