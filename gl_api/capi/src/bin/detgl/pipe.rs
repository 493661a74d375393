//! What happens where a pipe that is written to has no reader any more, as in `detgl doctor | head`.
#![allow(unsafe_code, reason = "calls a function of C")]

use std::ffi::c_int;

unsafe extern "C" {
    fn signal(number: c_int, handler: usize) -> usize;
}

const SIGPIPE: c_int = 13;
const SIG_DFL: usize = 0;

/// Lets the process end without a word there, as other programs do; Rust's runtime makes it an error, which `println` makes
/// a panic.
pub fn end_with_reader() {
    // SAFETY: the default needs no function of ours.
    unsafe { signal(SIGPIPE, SIG_DFL) };
}
