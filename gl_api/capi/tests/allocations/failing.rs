//! An allocator whose allocations can fail.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The system's allocator, of which one allocation fails.
pub struct Failing;

/// Smaller allocations than this never fail: nobody chose their size.
static LEAST: AtomicUsize = AtomicUsize::new(usize::MAX);
/// How many allocations are left until one fails; 0 when none will.
static LEFT: AtomicUsize = AtomicUsize::new(0);

/// Whether an allocation of so many bytes fails.
fn fails(bytes: usize) -> bool {
    bytes >= LEAST.load(Ordering::Relaxed)
        && LEFT.try_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1))
            == Ok(1)
}

/// Runs `call` with allocation `number`, from 1 on, of those of at least so many bytes failing; whether one failed.
pub fn with_failing(number: usize, least: usize, call: impl FnOnce()) -> bool {
    LEFT.store(number, Ordering::Relaxed);
    LEAST.store(least, Ordering::Relaxed);
    call();
    LEAST.store(usize::MAX, Ordering::Relaxed);
    LEFT.swap(0, Ordering::Relaxed) == 0
}

// SAFETY: the system's allocator does it all, or null is returned, which says that there is no memory.
#[allow(unsafe_code)]
unsafe impl GlobalAlloc for Failing {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        match fails(layout.size()) {
            true => std::ptr::null_mut(),
            // SAFETY: the caller's promises are those that the system's allocator asks for.
            false => unsafe { System.alloc(layout) },
        }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        match fails(layout.size()) {
            true => std::ptr::null_mut(),
            // SAFETY: as above.
            false => unsafe { System.alloc_zeroed(layout) },
        }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        // SAFETY: as above; what was allocated is the system's.
        unsafe { System.dealloc(memory, layout) }
    }

    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, bytes: usize) -> *mut u8 {
        match bytes > layout.size() && fails(bytes) {
            true => std::ptr::null_mut(),
            // SAFETY: as above.
            false => unsafe { System.realloc(memory, layout, bytes) },
        }
    }
}
