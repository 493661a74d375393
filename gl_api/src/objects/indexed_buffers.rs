//! Buffers that are bound to numbers: `glBindBufferRange`, `glBindBufferBase` (GL 3.0, section
//! 2.15; ARB_uniform_buffer_object, section 2.15.3.2).

use crate::objects::bound::Bound;

/// A part of a buffer that is bound to a number.
#[derive(Clone, Debug, Default)]
pub(crate) struct BufferRange {
    pub buffer: Bound,
    /// Its first byte.
    pub offset: usize,
    /// Its bytes; all that there are when it is used, if `None`.
    pub size: Option<usize>,
}
