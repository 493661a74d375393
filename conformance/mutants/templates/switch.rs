//! Which mistake this process has.

use std::sync::atomic::{AtomicU8, Ordering};

/// The number of the mistake, 0 for none, [`RECORD`] to record which are reached. Not atomic: loops that ask for it are
/// compiled as if it were a constant. It is written before any thread starts.
static mut CURRENT: u32 = 0;

/// Records which mistakes are reached.
pub const RECORD: u32 = u32::MAX;

static REACHED: [AtomicU8; 1 << 14] = [const { AtomicU8::new(0) }; 1 << 14];

/// Reads `DETGL_MUTANT`, a number or `record`.
pub fn start() {
    let number = match std::env::var("DETGL_MUTANT") {
        Ok(text) if text == "record" => RECORD,
        Ok(text) => text.parse().unwrap_or(0),
        Err(_) => 0,
    };
    // SAFETY: there is one thread.
    unsafe { CURRENT = number }
}

/// Whether this process has a mistake.
#[inline(always)]
pub fn is(number: u32) -> bool {
    // SAFETY: it is written only before threads start.
    let current = unsafe { CURRENT };
    current == number || current == RECORD && record(number)
}

#[cold]
#[inline(never)]
fn record(number: u32) -> bool {
    REACHED[number as usize].store(1, Ordering::Relaxed);
    false
}

/// The mistakes that were reached since the last call.
pub fn reached() -> Vec<u32> {
    let all = (0..).zip(&REACHED);
    all.filter(|(_, mark)| mark.swap(0, Ordering::Relaxed) != 0).map(|(number, _)| number).collect()
}
