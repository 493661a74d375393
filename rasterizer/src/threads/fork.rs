//! The worker threads of a device, across `fork`.
//!
//! `fork` copies the memory of a pool but none of its threads. A process that did not start the pool itself starts
//! another one.

use super::thread_pool::ThreadPool;
use parking_lot::Mutex;
use rayon::{ThreadPoolBuildError, ThreadPoolBuilder};
use std::error::Error;
use std::sync::Arc;
use std::{io, process};
use texunit::lanes::FloatEnv;

/// A number of worker threads, started again in a forked process.
#[derive(Debug)]
pub struct ForkAwarePool {
    workers: usize,
    /// `None` without workers, or where the system has no threads: the caller does the work.
    pool: Mutex<Option<Pool>>,
}

/// Worker threads and the process that started them.
#[derive(Debug)]
struct Pool {
    process: u32,
    /// `None` only while it is dropped.
    threads: Option<Arc<rayon::ThreadPool>>,
}

impl Pool {
    fn start(count: usize) -> Result<Option<Self>, ThreadPoolBuildError> {
        if count == 0 {
            return Ok(None);
        }
        let started = ThreadPoolBuilder::new()
            .num_threads(count)
            .thread_name(|index| format!("detgl-{index}"))
            // Threads begin with the floating-point state of the one that starts them, or with the system's.
            .start_handler(|_| FloatEnv::enter_for_good())
            .build();
        match started {
            Ok(threads) => {
                Ok(Some(Self { process: process::id(), threads: Some(Arc::new(threads)) }))
            }
            Err(error) if is_unsupported(&error) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Whether this process started the threads.
    fn is_of_this_process(&self) -> bool {
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
        // The threads do not exist in this process: they cannot end, and may hold locks.
        if !self.is_of_this_process() {
            std::mem::forget(self.threads.take());
        }
    }
}

impl ForkAwarePool {
    /// Starts workers: `count` threads less the caller.
    ///
    /// # Errors
    /// When the threads cannot be started on a system that has threads.
    pub fn start(count: usize) -> Result<Self, ThreadPoolBuildError> {
        let workers = count.saturating_sub(1);
        Ok(Self { workers, pool: Mutex::new(Pool::start(workers)?) })
    }

    /// The thread pool of this process.
    ///
    /// # Errors
    /// When this process has no workers yet and they cannot be started.
    pub fn thread_pool(&self) -> Result<ThreadPool, ThreadPoolBuildError> {
        let mut pool = self.pool.lock();
        if pool.as_ref().is_some_and(|pool| !pool.is_of_this_process()) {
            *pool = Pool::start(self.workers)?;
        }
        let threads = pool.as_ref().and_then(|pool| pool.threads.clone());
        Ok(threads.map_or(ThreadPool::CALLER_ONLY, ThreadPool::with_workers))
    }
}
