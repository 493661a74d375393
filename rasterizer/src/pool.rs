//! What threads work with, kept from one piece of work to the next.

use parking_lot::Mutex;

/// Values that nobody uses now.
#[derive(Debug, Default)]
pub struct Pool<T>(Mutex<Vec<T>>);

impl<T: Default> Pool<T> {
    /// One of them, or a new one.
    pub fn lend(&self) -> Lent<'_, T> {
        Lent { value: self.0.lock().pop(), home: self }
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
