//! Counting what passes the depth and stencil tests (GL 2.1, section 4.1.7). A sum does not depend
//! on the order of its parts, so the count is the same for every number of threads.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Counts the samples of draws. Cloning gives another handle to the same count.
#[derive(Clone, Debug, Default)]
pub struct Counter(Arc<AtomicU64>);

/// Two handles of one count are equal.
impl PartialEq for Counter {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Counter {
    /// A count of 0.
    pub fn new() -> Self {
        Self::default()
    }

    /// How many samples the draws passed that were submitted so far.
    pub fn samples(&self) -> u64 {
        self.0.load(Ordering::Relaxed)
    }

    pub(crate) fn add(&self, mask: u64) {
        self.0.fetch_add(mask.count_ones().into(), Ordering::Relaxed);
    }
}
