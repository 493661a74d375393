//! The threads that a device shades with. `fork` copies the memory of a pool but none of its
//! threads, so that a process that has not made its pool itself makes another.

use super::device::DeviceError;
use parking_lot::Mutex;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use std::error::Error;
use std::sync::Arc;
use std::{io, process};

/// A number of threads, in whichever process asks for them.
#[derive(Debug)]
pub(super) struct Threads {
    count: usize,
    /// None where the system has no threads: whoever asks does the work.
    pool: Mutex<Option<Pool>>,
}

/// Threads, and the process that they are of.
#[derive(Debug)]
struct Pool {
    process: u32,
    /// There until it is dropped.
    threads: Option<Arc<ThreadPool>>,
}

impl Pool {
    fn start(count: usize) -> Result<Option<Self>, DeviceError> {
        let started = ThreadPoolBuilder::new()
            .num_threads(count)
            .thread_name(|index| format!("detgl-{index}"))
            .build();
        match started {
            Ok(threads) => {
                Ok(Some(Self { process: process::id(), threads: Some(Arc::new(threads)) }))
            }
            Err(error) if is_unsupported(&error) => Ok(None),
            Err(error) => Err(DeviceError::Pool(error.to_string())),
        }
    }

    /// Whether the threads are of this process.
    fn is_here(&self) -> bool {
        self.process == process::id()
    }
}

/// Whether the system has no threads, as WebAssembly's.
fn is_unsupported(error: &ThreadPoolBuildError) -> bool {
    let cause = error.source().and_then(|cause| cause.downcast_ref::<io::Error>());
    cause.is_some_and(|cause| cause.kind() == io::ErrorKind::Unsupported)
}

impl Drop for Pool {
    fn drop(&mut self) {
        // Threads that are not there cannot be told to end, and may have kept their locks.
        if !self.is_here() {
            std::mem::forget(self.threads.take());
        }
    }
}

impl Threads {
    /// Starts threads; at least one.
    ///
    /// # Errors
    /// When they cannot be started, although the system has some.
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
            if pool.as_ref().is_some_and(|pool| !pool.is_here()) {
                *pool = Pool::start(self.count)?;
            }
            pool.as_ref().and_then(|pool| pool.threads.clone())
        };
        Ok(match threads {
            Some(threads) => threads.install(f),
            None => f(),
        })
    }
}
