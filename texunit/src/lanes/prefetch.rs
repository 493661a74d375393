//! Values asked for before they are needed. Nothing here changes a result; it does nothing where there is no such
//! instruction.

/// Asks the processor to have all of a value near soon: what is read or written a while later then does
/// not wait for memory.
#[inline(always)]
pub fn prefetch<T>(value: &T) {
    for byte in (0..size_of::<T>()).step_by(64) {
        line(std::ptr::from_ref(value).cast::<i8>().wrapping_add(byte));
    }
}

/// As [`prefetch`], of the line of bytes around an offset, which may lie anywhere.
#[inline(always)]
pub fn prefetch_at(bytes: &[u8], offset: usize) {
    line(bytes.as_ptr().cast::<i8>().wrapping_add(offset));
}

/// Asks for the line that an address lies in.
#[inline(always)]
fn line(at: *const i8) {
    #[cfg(target_arch = "x86_64")]
    {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: every x86-64 has it, and it faults at no address.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(at) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = at;
}
