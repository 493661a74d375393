//! Indexed binding points of uniform buffers, and their limits: ARB_uniform_buffer_object.

use crate::base::constants::*;
use crate::base::limits::{
    MAX_UNIFORM_BLOCK_SIZE, MAX_UNIFORM_BLOCKS, MAX_UNIFORM_BUFFER_BINDINGS,
    MAX_UNIFORM_COMPONENTS, UNIFORM_BUFFER_OFFSET_ALIGNMENT,
};
use crate::base::types::*;
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

/// The limits that `glGet` reports. There is no geometry stage.
pub(crate) fn limit(pname: GLenum) -> Option<i32> {
    let blocks = MAX_UNIFORM_BLOCKS as i32;
    let of_blocks = blocks * (MAX_UNIFORM_BLOCK_SIZE / 4) as i32;
    Some(match pname {
        GL_MAX_VERTEX_UNIFORM_BLOCKS | GL_MAX_FRAGMENT_UNIFORM_BLOCKS => blocks,
        GL_MAX_GEOMETRY_UNIFORM_BLOCKS | GL_MAX_COMBINED_GEOMETRY_UNIFORM_COMPONENTS => 0,
        GL_MAX_COMBINED_UNIFORM_BLOCKS => 2 * blocks,
        GL_MAX_UNIFORM_BUFFER_BINDINGS => MAX_UNIFORM_BUFFER_BINDINGS as i32,
        GL_MAX_UNIFORM_BLOCK_SIZE => MAX_UNIFORM_BLOCK_SIZE as i32,
        GL_MAX_COMBINED_VERTEX_UNIFORM_COMPONENTS | GL_MAX_COMBINED_FRAGMENT_UNIFORM_COMPONENTS => {
            MAX_UNIFORM_COMPONENTS + of_blocks
        }
        GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT => UNIFORM_BUFFER_OFFSET_ALIGNMENT as i32,
        _ => return None,
    })
}
