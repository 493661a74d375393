//! Uniform blocks and the buffers that they are read from: ARB_uniform_buffer_object.
//!
//! A block's members have words among those of the program's uniforms, so shaders read them as any
//! uniform. Before a draw [`unpack`] writes the words of those blocks whose buffer, or what is in
//! it, is another than before.

use crate::base::limits::MAX_UNIFORM_BUFFER_BINDINGS;
use crate::objects::bound::Bound;
use crate::objects::indexed_buffers::BufferRange;

pub(crate) const SECTION: &str = "ARB_uniform_buffer_object, section 2.15.3";

/// What is bound to the numbers that blocks name.
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
    /// A buffer is no more.
    pub fn forget_buffer(&mut self, gone: &Bound) {
        for range in self.buffers.iter_mut().filter(|range| range.buffer == *gone) {
            *range = BufferRange::default();
        }
    }
}
