//! The memory that pixels are read from: the client's, or a pixel buffer object (`ARB_pixel_buffer_object`, section
//! 3.6.1).

use rasterizer::driver::Buffer;

/// Memory that pixels are read from.
pub(crate) enum Source<'a> {
    Client(&'a [u8]),
    /// A buffer object from an offset on.
    Buffer(Buffer, usize),
}

impl Source<'_> {
    pub fn bytes(&self) -> &[u8] {
        match self {
            Self::Client(bytes) => bytes,
            Self::Buffer(buffer, offset) => buffer.bytes().get(*offset..).unwrap_or_default(),
        }
    }
}
