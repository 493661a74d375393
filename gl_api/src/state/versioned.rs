//! State with a version, so that values derived from it are recomputed only after changes.

use std::ops::{Deref, DerefMut};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// A value with a version number. Values with equal versions are equal, across all contexts. A clone, as on the attribute
/// stack, is one with the original until either is changed.
#[derive(Clone, Debug)]
pub(crate) struct Versioned<T> {
    value: Arc<T>,
    version: u64,
}

impl<T> Versioned<T> {
    pub fn new(value: T) -> Self {
        Self { value: Arc::new(value), version: next_version() }
    }

    /// Never 0.
    pub fn version(&self) -> u64 {
        self.version
    }
}

impl<T> Deref for Versioned<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.value
    }
}

impl<T: Clone> DerefMut for Versioned<T> {
    fn deref_mut(&mut self) -> &mut T {
        self.version = next_version();
        Arc::make_mut(&mut self.value)
    }
}

fn next_version() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(1);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_version_is_of_one_value() {
        let mut a = Versioned::new(1);
        let before = a.clone();
        assert_eq!((a.version(), *before), (before.version(), 1));
        *a = 2;
        let changed = a.version();
        assert_ne!(changed, before.version());
        // Back, and changed once more: another value, another number.
        a = before;
        *a = 3;
        assert_ne!(a.version(), changed);
    }
}
