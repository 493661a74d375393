//! How long the processors have worked for this process: what else a machine does has next to no part in it.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// One at a time, so that what is measured is one test's.
static ALONE: Mutex<()> = Mutex::new(());

/// A measurement; others of this program wait until it ends.
pub struct CpuTime {
    _alone: MutexGuard<'static, ()>,
    start: Option<Duration>,
    wall: Instant,
}

impl CpuTime {
    /// Begins.
    pub fn begin() -> Self {
        let alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
        Self { _alone: alone, start: of_process(), wall: Instant::now() }
    }

    /// The time of all threads together since [`Self::begin`]; where the system does not say, what has passed.
    pub fn elapsed(&self) -> Duration {
        match (self.start, of_process()) {
            (Some(start), Some(now)) => now - start,
            (None, _) | (_, None) => self.wall.elapsed(),
        }
    }
}

/// What all threads have run, in user mode and in the kernel (Linux: proc(5), fields 14 and 15 of `stat`).
fn of_process() -> Option<Duration> {
    const TICKS_OF_A_SECOND: u64 = 100;
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    // The name in parentheses may have anything in it.
    let (_, fields) = stat.rsplit_once(')')?;
    let mut fields = fields.split_whitespace().skip(11).map(str::parse::<u64>);
    let ticks = fields.next()?.ok()? + fields.next()?.ok()?;
    Some(Duration::from_millis(1000 / TICKS_OF_A_SECOND * ticks))
}
