//! State of the uniform blocks of a linked program: ARB_uniform_buffer_object, section 2.15.3.

use crate::base::types::*;
use crate::objects::buffers::BufferRange;
use rasterizer::driver::{Buffer, Version};

/// A uniform block, and the buffer range from which its words were last filled.
#[derive(Clone, Debug, Default)]
pub(crate) struct BlockState {
    /// `GL_UNIFORM_BLOCK_BINDING`.
    pub binding: GLuint,
    /// Offset and size, and the buffer's version if there is a buffer; `None` before the first draw.
    pub source: Option<(usize, Option<usize>, Option<Version>)>,
}

impl BlockState {
    /// The blocks of a program that was just linked.
    pub fn of(program: &glsl::Program) -> Vec<Self> {
        let state = |block: &glsl::UniformBlock| Self { binding: block.binding, source: None };
        program.blocks.iter().map(state).collect()
    }

    /// Whether the words were filled from this range, and the buffer has not changed since.
    pub(crate) fn is_of(&self, range: &BufferRange, buffer: Option<&Buffer>) -> bool {
        self.source.as_ref().is_some_and(|(offset, size, version)| {
            let same = match (version, buffer) {
                (Some(version), Some(buffer)) => version.is_of(buffer),
                (None, None) => true,
                (Some(_), None) | (None, Some(_)) => false,
            };
            (*offset, *size) == (range.offset, range.size) && same
        })
    }
}
