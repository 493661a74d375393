//! What threads work with, kept from one piece of work to the next.

use parking_lot::Mutex;

/// As many of the values that nobody gives back by itself are kept.
const KEPT: usize = 64;
/// Into so many pieces goes a thread's share of what is left.
const PARTS: usize = 4;

/// Values that nobody uses now.
#[derive(Debug, Default)]
pub struct Pool<T>(Mutex<Vec<T>>);

impl<T: Default> Pool<T> {
    /// One of them, or a new one.
    pub fn lend(&self) -> Lent<'_, T> {
        Lent { value: self.0.lock().pop(), home: self }
    }

    /// Does all of some work, in parallel on the threads of the pool that this is called on. Each thread has one
    /// value for as long as there is work, so that none goes from processor to processor; and it takes neighbours,
    /// which read the same memory: many while there are many left, and in the end at most `least`, which are not
    /// worth another thread.
    pub fn share<I>(&self, work: &mut [I], least: usize, each: impl Fn(&mut T, &mut [I]) + Sync)
    where
        T: Send,
        I: Send,
    {
        let threads = rayon::current_num_threads();
        let helpers = threads.min(work.len().div_ceil(least)).saturating_sub(1);
        let left = Mutex::new(work);
        let next = || {
            let mut left = left.lock();
            let count = left.len().min(least.max(left.len() / (PARTS * threads)));
            left.split_off_mut(..count).filter(|piece| !piece.is_empty())
        };
        let take_part = || {
            let mut lent = self.lend();
            while let Some(piece) = next() {
                each(lent.get(), piece);
            }
        };
        if helpers == 0 {
            return take_part();
        }
        rayon::scope(|scope| {
            for _ in 0..helpers {
                scope.spawn(|_| take_part());
            }
            take_part();
        });
    }

    /// One of them for as long as anybody likes, or a new one.
    pub fn take(&self) -> T {
        self.0.lock().pop().unwrap_or_default()
    }

    /// Keeps a value for others, unless there are enough.
    pub fn give(&self, value: T) {
        let mut all = self.0.lock();
        if all.len() < KEPT {
            all.push(value);
        }
    }
}

/// A value that goes back to its pool.
pub struct Lent<'a, T: Default> {
    /// Made when it is first asked for.
    value: Option<T>,
    home: &'a Pool<T>,
}

impl<T: Default> Lent<'_, T> {
    /// The value.
    pub fn get(&mut self) -> &mut T {
        self.value.get_or_insert_default()
    }
}

impl<T: Default> Drop for Lent<'_, T> {
    fn drop(&mut self) {
        self.home.0.lock().extend(self.value.take());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rayon::ThreadPoolBuilder;

    #[test]
    #[cfg_attr(target_family = "wasm", ignore = "there are no threads there")]
    fn every_piece_is_worked_on_once_by_however_many_threads() {
        for threads in [1, 2, 5] {
            let rayon = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            for (count, least) in [(0, 1), (1, 4), (7, 4), (1000, 1), (1000, 3)] {
                let pool = Pool::<usize>::default();
                let mut work = vec![0; count];
                rayon.install(|| {
                    pool.share(&mut work, least, |own, piece| {
                        assert!(piece.len() <= least.max(count / PARTS));
                        *own += piece.len();
                        piece.iter_mut().for_each(|times| *times += 1);
                    });
                });
                assert_eq!(work, vec![1; count], "{threads} threads");
                let lent = pool.0.into_inner();
                assert!(lent.len() <= threads);
                assert_eq!(lent.iter().sum::<usize>(), count);
            }
        }
    }
}
