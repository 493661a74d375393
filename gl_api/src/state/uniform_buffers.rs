//! Indexed binding points of uniform buffers, and their limits: ARB_uniform_buffer_object.

use crate::base::limits::MAX_UNIFORM_BUFFER_BINDINGS;
use crate::objects::bound::Bound;
use crate::objects::buffers::BufferRange;

pub(crate) const SECTION: &str = "ARB_uniform_buffer_object, section 2.15.3";

/// The buffer ranges at the indexed binding points.
#[derive(Debug)]
pub(crate) struct UniformBuffers {
    pub buffers: [BufferRange; MAX_UNIFORM_BUFFER_BINDINGS],
}

impl Default for UniformBuffers {
    fn default() -> Self {
        Self { buffers: std::array::from_fn(|_| BufferRange::default()) }
    }
}

impl UniformBuffers {
    /// Unbinds a deleted buffer.
    pub fn forget_buffer(&mut self, gone: &Bound) {
        for range in self.buffers.iter_mut().filter(|range| range.buffer == *gone) {
            *range = BufferRange::default();
        }
    }
}
