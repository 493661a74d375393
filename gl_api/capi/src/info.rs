//! DetGL's own functions, for programs that have no other way to ask: the Python module, scripts, debuggers.

use crate::guard::c_functions;
use gl_api::host::{self, ContextInfo};
use gl_api::{Context, with_current};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::ffi::{c_char, c_int};
use std::fmt::Write;

/// What contexts of this process have, a line each: `name=value`; where they cannot be made, `error=`.
pub fn info() -> String {
    let mut text = format!("version={}\n", env!("CARGO_PKG_VERSION"));
    let mut line = |name: &str, value: &dyn std::fmt::Display| {
        writeln!(text, "{name}={value}").expect("a String takes everything");
    };
    match host::context_info() {
        Ok(ContextInfo { isa, threads, gl, es, limits }) => {
            line("isa", &isa);
            line("threads", &threads);
            line("gl", &gl);
            line("es", &es);
            limits.iter().for_each(|(name, value)| line(name, value));
        }
        Err(error) => line("error", &error),
    }
    text
}

thread_local! {
    /// Messages that were taken from a context and have not been asked for.
    static MESSAGES: RefCell<VecDeque<String>> = const { RefCell::new(VecDeque::new()) };
}

/// The oldest message of the thread's current context.
fn next_message() -> Option<String> {
    MESSAGES.with_borrow_mut(|messages| {
        let new = with_current(Context::messages).unwrap_or_default();
        messages.extend(new.iter().map(ToString::to_string));
        messages.pop_front()
    })
}

/// Writes text with a final zero, as much of it as there is memory for; how many bytes all of it has.
///
/// # Safety
/// `out` has `size` bytes, or is null.
unsafe fn put(text: &str, out: *mut c_char, size: c_int) -> c_int {
    let room = usize::try_from(size).ok().and_then(|size| size.checked_sub(1));
    if let Some(room) = room.filter(|_| !out.is_null()) {
        let length = text.floor_char_boundary(room);
        // SAFETY: less than `size` bytes.
        unsafe {
            out.cast::<u8>().copy_from_nonoverlapping(text.as_ptr(), length);
            out.add(length).write(0);
        }
    }
    text.len() as c_int
}

c_functions! {
    detglInfo(out: *mut c_char, size: c_int) -> c_int {
        put(&info(), out, size)
    }

    // Nothing if there is none. A message that is longer than the memory is cut off.
    detglNextMessage(out: *mut c_char, size: c_int) -> c_int {
        put(&next_message().unwrap_or_default(), out, size)
    }
}
