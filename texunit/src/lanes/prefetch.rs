//! Prefetch instructions. They change no result, and do nothing on machines without them.

/// Prefetches all cache lines of a value.
#[inline(always)]
pub fn prefetch<T>(value: &T) {
    for byte in (0..size_of::<T>()).step_by(64) {
        line(std::ptr::from_ref(value).cast::<i8>().wrapping_add(byte));
    }
}

/// Prefetches the cache line of an offset, which may be outside of `bytes`.
#[inline(always)]
pub fn prefetch_at(bytes: &[u8], offset: usize) {
    line(bytes.as_ptr().cast::<i8>().wrapping_add(offset));
}

/// Prefetches the cache line of an address.
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
