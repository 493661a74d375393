//! Pools of reusable objects: scratch memory that outlives a piece of work.

use parking_lot::Mutex;

/// The most values that [`ObjectPool::give`] keeps.
const MAX_KEPT: usize = 64;

/// Values that are not in use.
#[derive(Debug, Default)]
pub struct ObjectPool<T>(Mutex<Vec<T>>);

impl<T: Default> ObjectPool<T> {
    /// One of the values, or a new one; it returns when the handle is dropped.
    pub fn borrow(&self) -> PooledObject<'_, T> {
        PooledObject { value: self.0.lock().pop(), home: self }
    }

    /// Takes one of the values, or a new one, for good.
    pub fn take(&self) -> T {
        self.0.lock().pop().unwrap_or_default()
    }

    /// Keeps a value for others, up to [`MAX_KEPT`] of them.
    pub fn give(&self, value: T) {
        let mut all = self.0.lock();
        if all.len() < MAX_KEPT {
            all.push(value);
        }
    }
}

/// A value that returns to its pool when it is dropped.
pub struct PooledObject<'a, T: Default> {
    /// Created at the first [`Self::get`].
    value: Option<T>,
    home: &'a ObjectPool<T>,
}

impl<T: Default> PooledObject<'_, T> {
    /// The value.
    pub fn get(&mut self) -> &mut T {
        self.value.get_or_insert_default()
    }
}

impl<T: Default> Drop for PooledObject<'_, T> {
    fn drop(&mut self) {
        self.home.0.lock().extend(self.value.take());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dropped_object_returns_and_is_borrowed_again() {
        let pool = ObjectPool::<Vec<u8>>::default();
        drop(pool.borrow());
        assert!(pool.0.lock().is_empty(), "nobody asked for it");
        pool.borrow().get().push(1);
        let (mut first, mut second) = (pool.borrow(), pool.borrow());
        assert_eq!((first.get().len(), second.get().len()), (1, 0));
        drop((first, second));
        assert_eq!(pool.0.into_inner().len(), 2);
    }
}
