//! Words asked for before they are needed.

use super::U32s;

/// Asks the processor to have these words near soon: what is written a while later then does not
/// wait for memory. Never changes a result; does nothing where there is no such instruction.
#[inline(always)]
pub fn prefetch(words: &U32s) {
    #[cfg(target_arch = "x86_64")]
    for line in words.0.chunks_exact(16) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: every x86-64 has it, and it faults at no address.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(line.as_ptr().cast()) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = words;
}
