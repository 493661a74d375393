//! Counts of primitives for the queries that are active.

use crate::context::Context;
use crate::objects::queries::{GENERATED, WRITTEN};

impl Context {
    /// Counts primitives of a draw, and those of them that transform feedback wrote.
    pub(crate) fn count_primitives(&mut self, generated: u64, written: u64) {
        for (place, count) in [(GENERATED, generated), (WRITTEN, written)] {
            if let Some(query) = self.objects.queries.get_mut(self.queries.names[place]) {
                query.primitives = query.primitives.saturating_add(count);
            }
        }
    }
}
