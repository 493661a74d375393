//! Pages that an unmapped page follows, and the signal handler that names the call which reaches that one.

use super::random::Random;
use std::cell::Cell;
use std::ffi::{c_int, c_void};
use std::ptr::null_mut;

/// At least the page size of every machine.
pub(super) const PAGE: usize = 1 << 16;
unsafe extern "C" {
    fn mmap(
        at: *mut c_void,
        len: usize,
        prot: c_int,
        flags: c_int,
        fd: c_int,
        offset: i64,
    ) -> *mut c_void;
    fn mprotect(at: *mut c_void, len: usize, prot: c_int) -> c_int;
    fn signal(number: c_int, handler: usize) -> usize;
    fn write(fd: c_int, bytes: *const c_void, count: usize) -> isize;
    fn _exit(code: c_int) -> !;
}

thread_local! {
    /// The name of the call that runs, for the handler.
    pub(super) static NAME: Cell<&'static str> = const { Cell::new("") };
}

extern "C" fn names_the_call(_: c_int) {
    let text = b"\nreads or writes past the end of its memory: ";
    // SAFETY: such bytes as the slices have; both functions may be called from a handler.
    unsafe {
        write(2, text.as_ptr().cast(), text.len());
        let name = NAME.get();
        write(2, name.as_ptr().cast(), name.len());
        write(2, b"\n".as_ptr().cast(), 1);
        _exit(101);
    }
}

/// A page, and after it one that cannot be reached.
#[derive(Clone, Copy)]
pub(super) struct Slot(*mut u8);

impl Slot {
    pub(super) fn new() -> Self {
        const READ_WRITE: c_int = 3;
        const NONE: c_int = 0;
        // Linux: private and of no file.
        const PRIVATE_ANONYMOUS: c_int = 0x22;
        // SAFETY: memory of its own.
        unsafe {
            let start = mmap(null_mut(), 2 * PAGE, READ_WRITE, PRIVATE_ANONYMOUS, -1, 0);
            assert_ne!(start.addr(), usize::MAX, "no memory");
            assert_eq!(mprotect(start.byte_add(PAGE), PAGE, NONE), 0);
            Self(start.cast())
        }
    }

    /// The last `bytes` of the page, with small numbers in them.
    pub(super) fn last(self, bytes: usize, random: &Random) -> *mut u8 {
        let bytes = bytes.min(PAGE);
        // SAFETY: within the page.
        unsafe {
            let start = self.0.add(PAGE - bytes);
            for at in 0..bytes {
                *start.add(at) = if at % 4 == 0 { random.below(6) as u8 } else { 0 };
            }
            start
        }
    }
}

/// Pages for the pointers of a call; a fault names the call and ends the process.
pub(super) fn guarded<const N: usize>() -> [Slot; N] {
    // SAFETY: the handler calls what handlers may call.
    unsafe { signal(11, names_the_call as *const () as usize) };
    std::array::from_fn(|_| Slot::new())
}
