//! Textures whose texels are the bytes of a buffer object: `glTexBuffer`, `glTexBufferRange`
//! (`ARB_texture_buffer_object`, `ARB_texture_buffer_object_rgb32`, `ARB_texture_buffer_range`; GL
//! 3.1, section 3.8.4).
//!
//! A draw makes a row of texels of the bytes that the buffer has then, and keeps it until somebody
//! asks to write to the buffer.

use crate::base::constants::*;
use crate::base::limits;
use crate::base::types::*;
use crate::objects::bound::Bound;
use rasterizer::driver::Version;
use std::ops::Range;
use std::sync::Arc;
use texunit::format::Format;
use texunit::plan::SamplePlan;

/// Where the texels of a buffer texture come from.
#[derive(Debug)]
pub(crate) struct DataStore {
    /// The internal format that was asked for.
    pub internal: GLenum,
    pub format: Format,
    /// The buffer, if there is one: the texture keeps it when it is deleted.
    pub buffer: Bound,
    /// The bytes of the buffer that are texels, unless all are.
    pub range: Option<Range<usize>>,
    /// How the texels of these bytes are fetched.
    pub plan: Option<(Version, Arc<SamplePlan>)>,
}

impl DataStore {
    /// Why there are no texels, if so.
    pub fn incomplete_reason(&self) -> Option<String> {
        (self.buffer.name() == 0).then(|| "it has no buffer: give it one with glTexBuffer".into())
    }

    /// How many texels so many bytes are.
    pub fn texels(&self, bytes: usize) -> u32 {
        let most = limits::MAX_TEXTURE_BUFFER_SIZE;
        u32::try_from(bytes / self.format.bytes()).map_or(most, |texels| texels.min(most))
    }
}

impl Default for DataStore {
    /// As a new texture has it (`ARB_texture_buffer_object`, section 6.2).
    fn default() -> Self {
        let (internal, format) = (GL_LUMINANCE8, Format::L8);
        Self { internal, format, buffer: Bound::default(), range: None, plan: None }
    }
}

impl DataStore {
    /// Which bytes of a buffer are texels.
    pub fn range_of(&self, length: usize) -> Range<usize> {
        match &self.range {
            None => 0..length,
            Some(range) => range.start.min(length)..range.end.min(length),
        }
    }
}
