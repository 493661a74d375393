//! The threads that a device shades with. `fork` copies the memory of a pool but none of its
//! threads, so that a process that has not made its pool itself makes another.

use super::device::DeviceError;
use parking_lot::Mutex;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::process;
use std::sync::Arc;

/// A number of threads, in whichever process asks for them.
#[derive(Debug)]
pub(super) struct Threads {
    count: usize,
    pool: Mutex<Pool>,
}

/// Threads, and the process that they are of.
#[derive(Debug)]
struct Pool {
    process: u32,
    /// There until it is dropped.
    threads: Option<Arc<ThreadPool>>,
}

impl Pool {
    fn start(count: usize) -> Result<Self, DeviceError> {
        let threads = ThreadPoolBuilder::new()
            .num_threads(count)
            .thread_name(|index| format!("detgl-{index}"))
            .build()
            .map_err(|error| DeviceError::Pool(error.to_string()))?;
        Ok(Self { process: process::id(), threads: Some(Arc::new(threads)) })
    }

    /// The threads, if they are of this process.
    fn here(&self) -> Option<Arc<ThreadPool>> {
        self.threads.clone().filter(|_| self.process == process::id())
    }
}

impl Drop for Pool {
    fn drop(&mut self) {
        // Threads that are not there cannot be told to end, and may have kept their locks.
        if self.process != process::id() {
            std::mem::forget(self.threads.take());
        }
    }
}

impl Threads {
    /// Starts threads; at least one.
    ///
    /// # Errors
    /// When they cannot be started.
    pub fn start(count: usize) -> Result<Self, DeviceError> {
        let count = count.max(1);
        Ok(Self { count, pool: Mutex::new(Pool::start(count)?) })
    }

    /// Runs `f` on them.
    ///
    /// # Errors
    /// When this process has none yet, and they cannot be started.
    pub fn run<R: Send>(&self, f: impl FnOnce() -> R + Send) -> Result<R, DeviceError> {
        let threads = {
            let mut pool = self.pool.lock();
            match pool.here() {
                Some(threads) => threads,
                None => {
                    *pool = Pool::start(self.count)?;
                    pool.here().ok_or_else(|| DeviceError::Pool("none started".into()))?
                }
            }
        };
        Ok(threads.install(f))
    }
}
