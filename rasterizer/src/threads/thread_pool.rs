//! Who does a piece of work: the thread that asks for it, and those that its device has besides.
//!
//! The asking thread works too. To hand everything to other threads and wait would wake two for the smallest draw,
//! and put what a client has just written into another processor's reach; and a system that finds one processor idle
//! and two threads on another takes some milliseconds to notice.

use parking_lot::Mutex;
use rayon::ThreadPool;
use std::hint::spin_loop;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Into so many pieces goes a thread's share of what is left.
const PARTS: usize = 4;

/// So often the one that asks looks whether the others are done before it sleeps till then: they often are about to be,
/// and it takes longer to be woken.
const TURNS: usize = 2000;

/// The threads that share work.
#[derive(Clone, Debug)]
pub struct Crew {
    /// Those besides the one that asks.
    helpers: Option<Arc<ThreadPool>>,
}

impl Crew {
    /// Nobody but the one that asks.
    pub const ALONE: Self = Self { helpers: None };

    /// The one that asks and all of a pool.
    pub fn with(helpers: Arc<ThreadPool>) -> Self {
        Self { helpers: Some(helpers) }
    }

    /// The one that asks and so many more, for tests.
    #[cfg(test)]
    pub fn of(helpers: usize) -> Self {
        let pool = |count| rayon::ThreadPoolBuilder::new().num_threads(count).build().ok();
        Self { helpers: Some(helpers).filter(|&count| count > 0).and_then(pool).map(Arc::new) }
    }

    /// Does all of some work. Each thread has one value of its own for as long as there is work, so that none goes
    /// from processor to processor; and it takes neighbours, which read the same memory: many while there are many
    /// left, and in the end at most `least`, which are not worth another thread.
    pub fn share<T, I: Send>(
        &self,
        work: &mut [I],
        least: usize,
        own: impl Fn() -> T + Sync,
        each: impl Fn(&mut T, &mut [I]) + Sync,
    ) {
        let threads = 1 + self.helpers.as_ref().map_or(0, |pool| pool.current_num_threads());
        let helpers = threads.min(work.len().div_ceil(least)).saturating_sub(1);
        let left = Mutex::new(work);
        let next = || {
            let mut left = left.lock();
            let count = left.len().min(least.max(left.len() / (PARTS * threads)));
            left.split_off_mut(..count).filter(|piece| !piece.is_empty())
        };
        let take_part = || {
            let mut own = own();
            while let Some(piece) = next() {
                each(&mut own, piece);
            }
        };
        let done = AtomicUsize::new(0);
        match &self.helpers {
            Some(pool) if helpers > 0 => pool.in_place_scope(|scope| {
                for _ in 0..helpers {
                    scope.spawn(|_| {
                        take_part();
                        done.fetch_add(1, Ordering::Release);
                    });
                }
                take_part();
                for _ in 0..TURNS {
                    if done.load(Ordering::Acquire) == helpers {
                        break;
                    }
                    spin_loop();
                }
            }),
            Some(_) | None => take_part(),
        }
    }

    /// What comes of each, in their order. A thread takes at least so many.
    pub fn map<I: Copy + Send, R: Send>(
        &self,
        all: impl Iterator<Item = I>,
        least: usize,
        of: impl Fn(I) -> R + Sync,
    ) -> Vec<R> {
        let mut all: Vec<(I, Option<R>)> = all.map(|each| (each, None)).collect();
        self.share(
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
        for helpers in [0, 1, 4] {
            let crew = Crew::of(helpers);
            for (count, least) in [(0, 1), (1, 4), (7, 4), (1000, 1), (1000, 3)] {
                let (mut work, takers) = (vec![0; count], AtomicUsize::new(0));
                let own = || takers.fetch_add(1, Ordering::Relaxed);
                crew.share(&mut work, least, own, |_, piece| {
                    assert!(piece.len() <= least.max(count / PARTS));
                    piece.iter_mut().for_each(|times| *times += 1);
                });
                assert_eq!(work, vec![1; count], "{helpers} helpers");
                assert!(takers.into_inner() <= 1 + helpers);
            }
        }
    }

    /// A piece of work may be shared again, on whichever thread it is.
    #[test]
    #[cfg_attr(target_family = "wasm", ignore = "there are no threads there")]
    fn pieces_share_pieces_of_theirs() {
        for helpers in [0, 1, 3] {
            let crew = Crew::of(helpers);
            let sums =
                crew.map(0..40, 1, |of| crew.map(0..of, 1, |each| each).into_iter().sum::<u32>());
            let want: Vec<u32> = (0..40).map(|of: u32| (0..of).sum()).collect();
            assert_eq!(sums, want, "{helpers} helpers");
        }
    }
}
