//! The buffer range and format of a buffer texture (GL 3.1, section 3.8.4). A draw makes a sample plan of the buffer's
//! bytes, which is kept until the buffer is written.

use crate::base::constants::*;
use crate::base::limits;
use crate::base::types::*;
use crate::objects::bound::Bound;
use rasterizer::driver::Version;
use std::ops::Range;
use std::sync::Arc;
use texunit::format::Format;
use texunit::plan::SamplePlan;

/// The data store of a buffer texture.
#[derive(Debug)]
pub(crate) struct DataStore {
    /// The internal format that was asked for.
    pub internal: GLenum,
    pub format: Format,
    /// The buffer, if there is one; the texture keeps a deleted one alive.
    pub buffer: Bound,
    /// The range in bytes; `None` is the whole buffer.
    pub range: Option<Range<usize>>,
    /// The sample plan of these bytes, and their version.
    pub plan: Option<(Version, Arc<SamplePlan>)>,
}

impl DataStore {
    /// The reason why there are no texels, if so.
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
    /// The initial state (`ARB_texture_buffer_object`, section 6.2).
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
