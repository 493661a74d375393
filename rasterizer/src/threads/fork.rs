//! The threads that a device shades with besides the one that asks. `fork` copies the memory of a pool but none of its
//! threads, so that a process that has not made its pool itself makes another.

use super::thread_pool::Crew;
use parking_lot::Mutex;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use std::error::Error;
use std::sync::Arc;
use std::{io, process};

/// A number of threads, in whichever process asks for them.
#[derive(Debug)]
pub struct Threads {
    helpers: usize,
    /// None where there is to be none, or the system has none: whoever asks does the work.
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
    fn start(count: usize) -> Result<Option<Self>, ThreadPoolBuildError> {
        if count == 0 {
            return Ok(None);
        }
        let started = ThreadPoolBuilder::new()
            .num_threads(count)
            .thread_name(|index| format!("detgl-{index}"))
            .build();
        match started {
            Ok(threads) => {
                Ok(Some(Self { process: process::id(), threads: Some(Arc::new(threads)) }))
            }
            Err(error) if is_unsupported(&error) => Ok(None),
            Err(error) => Err(error),
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
    /// Starts threads: as many as are to work, less the one that asks.
    ///
    /// # Errors
    /// When they cannot be started, although the system has some.
    pub fn start(count: usize) -> Result<Self, ThreadPoolBuildError> {
        let helpers = count.saturating_sub(1);
        Ok(Self { helpers, pool: Mutex::new(Pool::start(helpers)?) })
    }

    /// Who shares work that is asked for now.
    ///
    /// # Errors
    /// When this process has no threads yet, and they cannot be started.
    pub fn crew(&self) -> Result<Crew, ThreadPoolBuildError> {
        let mut pool = self.pool.lock();
        if pool.as_ref().is_some_and(|pool| !pool.is_here()) {
            *pool = Pool::start(self.helpers)?;
        }
        let threads = pool.as_ref().and_then(|pool| pool.threads.clone());
        Ok(threads.map_or(Crew::ALONE, Crew::with))
    }
}
