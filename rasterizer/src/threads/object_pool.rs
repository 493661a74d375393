//! What threads work with, kept from one piece of work to the next.

use parking_lot::Mutex;

/// As many of the values that nobody gives back by itself are kept.
const KEPT: usize = 64;

/// Values that nobody uses now.
#[derive(Debug, Default)]
pub struct Pool<T>(Mutex<Vec<T>>);

impl<T: Default> Pool<T> {
    /// One of them, or a new one.
    pub fn lend(&self) -> Lent<'_, T> {
        Lent { value: self.0.lock().pop(), home: self }
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

    #[test]
    fn what_is_lent_comes_back_and_is_lent_again() {
        let pool = Pool::<Vec<u8>>::default();
        drop(pool.lend());
        assert!(pool.0.lock().is_empty(), "nobody asked for it");
        pool.lend().get().push(1);
        let (mut first, mut second) = (pool.lend(), pool.lend());
        assert_eq!((first.get().len(), second.get().len()), (1, 0));
        drop((first, second));
        assert_eq!(pool.0.into_inner().len(), 2);
    }
}
