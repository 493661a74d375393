//! The thread pool: the calling thread, and the worker threads that its device has besides.
//!
//! The calling thread works too. Handing everything to workers and waiting would wake two threads for the smallest
//! draw, and would put what a client has just written into the cache of another processor.

use parking_lot::Mutex;
use std::hint::spin_loop;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A thread takes this fraction (one over it) of its share of the work that is left.
const PIECES_PER_SHARE: usize = 4;

/// Iterations for which the caller polls its workers before it sleeps: waking it takes longer than they mostly need.
const SPINS: usize = 2000;

/// The threads that share work.
#[derive(Clone, Debug)]
pub struct ThreadPool {
    /// The threads besides the caller.
    workers: Option<Arc<rayon::ThreadPool>>,
}

impl ThreadPool {
    /// Only the calling thread.
    pub const CALLER_ONLY: Self = Self { workers: None };

    /// The calling thread and all threads of a pool.
    pub fn with_workers(workers: Arc<rayon::ThreadPool>) -> Self {
        Self { workers: Some(workers) }
    }

    /// The calling thread and a number of workers, for tests.
    #[cfg(test)]
    pub fn of_workers(workers: usize) -> Self {
        let pool = |count| rayon::ThreadPoolBuilder::new().num_threads(count).build().ok();
        Self { workers: Some(workers).filter(|&count| count > 0).and_then(pool).map(Arc::new) }
    }

    /// Runs `each` over all of `work`, in chunks of neighbours, which read the same memory. A chunk shrinks with what
    /// is left, down to `least` items, which are not worth another thread. Each thread makes one value with `own` and
    /// keeps it until no work is left.
    pub fn for_each_chunk<T, I: Send>(
        &self,
        work: &mut [I],
        least: usize,
        own: impl Fn() -> T + Sync,
        each: impl Fn(&mut T, &mut [I]) + Sync,
    ) {
        let threads = 1 + self.workers.as_ref().map_or(0, |pool| pool.current_num_threads());
        let workers = threads.min(work.len().div_ceil(least)).saturating_sub(1);
        let left = Mutex::new(work);
        let next = || {
            let mut left = left.lock();
            let count = left.len().min(least.max(left.len() / (PIECES_PER_SHARE * threads)));
            left.split_off_mut(..count).filter(|piece| !piece.is_empty())
        };
        let work_until_done = || {
            let mut own = own();
            while let Some(piece) = next() {
                each(&mut own, piece);
            }
        };
        let done = AtomicUsize::new(0);
        match &self.workers {
            Some(pool) if workers > 0 => pool.in_place_scope(|scope| {
                for _ in 0..workers {
                    scope.spawn(|_| {
                        work_until_done();
                        done.fetch_add(1, Ordering::Release);
                    });
                }
                work_until_done();
                for _ in 0..SPINS {
                    if done.load(Ordering::Acquire) == workers {
                        break;
                    }
                    spin_loop();
                }
            }),
            Some(_) | None => work_until_done(),
        }
    }

    /// The results of `of` over all items, in their order. A thread takes at least `least` items at a time.
    pub fn map<I: Copy + Send, R: Send>(
        &self,
        all: impl Iterator<Item = I>,
        least: usize,
        of: impl Fn(I) -> R + Sync,
    ) -> Vec<R> {
        let mut all: Vec<(I, Option<R>)> = all.map(|each| (each, None)).collect();
        self.for_each_chunk(
            &mut all,
            least,
            || (),
            |(), piece| piece.iter_mut().for_each(|(each, result)| *result = Some(of(*each))),
        );
        all.into_iter().filter_map(|(_, result)| result).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg_attr(target_family = "wasm", ignore = "there are no threads there")]
    fn every_piece_is_worked_on_once_by_however_many_threads() {
        for workers in [0, 1, 4] {
            let thread_pool = ThreadPool::of_workers(workers);
            for (count, least) in [(0, 1), (1, 4), (7, 4), (1000, 1), (1000, 3)] {
                let (mut work, takers) = (vec![0; count], AtomicUsize::new(0));
                let own = || takers.fetch_add(1, Ordering::Relaxed);
                thread_pool.for_each_chunk(&mut work, least, own, |_, piece| {
                    assert!(piece.len() <= least.max(count / PIECES_PER_SHARE));
                    piece.iter_mut().for_each(|times| *times += 1);
                });
                assert_eq!(work, vec![1; count], "{workers} workers");
                assert!(takers.into_inner() <= 1 + workers);
            }
        }
    }

    /// A piece of work may be shared again, on whichever thread it is.
    #[test]
    #[cfg_attr(target_family = "wasm", ignore = "there are no threads there")]
    fn pieces_share_pieces_of_theirs() {
        for workers in [0, 1, 3] {
            let thread_pool = ThreadPool::of_workers(workers);
            let sums = thread_pool.map(0..40, 1, |of| {
                thread_pool.map(0..of, 1, |each| each).into_iter().sum::<u32>()
            });
            let want: Vec<u32> = (0..40).map(|of: u32| (0..of).sum()).collect();
            assert_eq!(sums, want, "{workers} workers");
        }
    }
}
