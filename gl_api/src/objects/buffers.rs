//! Buffer objects: GL 2.1, section 2.9.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value, not_negative};
use crate::base::types::*;
use crate::objects::bound::Bound;
use rasterizer::driver::Buffer;

const SECTION: &str = "GL 2.1, section 2.9";

/// The draws that are recorded and not carried out, as buffers see them.
pub(crate) trait WaitingDraws {
    /// Notes that what is recorded holds so many bytes that nothing recorded before it does.
    fn hold(&mut self, bytes: usize);
    /// How many draws were ever recorded.
    fn draws(&self) -> u64;
}

/// A buffer object.
#[derive(Clone, Debug)]
pub(crate) struct BufferObject {
    /// Empty while it is mapped.
    pub buffer: Buffer,
    pub usage: GLenum,
    pub map: Option<Map>,
    /// `GL_BUFFER_ACCESS`, of the last mapping.
    pub access: GLenum,
    /// How many draws there had been when it was last written, if it was ever copied for that.
    rewritten: Option<u64>,
}

/// Fewer bytes are copied as fast as the vertices of a draw are.
const COPIED: usize = 1 << 12;
/// After so many draws a buffer is no longer taken for one that is written between draws.
const FORGOTTEN: u64 = 1 << 10;

impl BufferObject {
    pub(crate) fn new() -> Self {
        Self {
            buffer: Buffer::default(),
            usage: GL_STATIC_DRAW,
            map: None,
            access: GL_READ_WRITE,
            rewritten: None,
        }
    }

    /// Bytes, mapped or not.
    pub fn len(&self) -> usize {
        self.map.as_ref().map_or(self.buffer.bytes().len(), |map| map.bytes.len())
    }

    /// What draws read; empty while it is mapped.
    pub fn buffer(&self) -> &Buffer {
        &self.buffer
    }

    /// Its bytes for writing. Draws that wait keep those that they saw, of which the recorder is told.
    pub fn bytes_mut(&mut self, recorder: &mut impl WaitingDraws) -> &mut [u8] {
        self.all_bytes_mut(recorder)
    }

    fn all_bytes_mut(&mut self, recorder: &mut impl WaitingDraws) -> &mut Vec<u8> {
        let bytes = self.buffer.bytes().len();
        let is_shared = self.buffer.is_shared();
        if is_shared {
            recorder.hold(bytes);
        }
        if self.rewritten.is_some() || is_shared && bytes >= COPIED {
            self.rewritten = Some(recorder.draws());
        }
        self.buffer.bytes_mut()
    }

    /// Whether it is written between draws, so that these had better have copies of what they read.
    pub fn is_rewritten(&self, recorder: &impl WaitingDraws) -> bool {
        self.rewritten.is_some_and(|draws| recorder.draws() - draws < FORGOTTEN)
    }

    /// Takes the bytes out, to be mapped.
    pub(crate) fn take_bytes(&mut self, recorder: &mut impl WaitingDraws) -> Vec<u8> {
        let bytes = std::mem::take(self.all_bytes_mut(recorder));
        self.buffer = Buffer::default();
        bytes
    }

    /// Takes the bytes out if there are so many, and nobody else has them: their memory is there already.
    pub(crate) fn take_as_many(&mut self, size: usize) -> Option<Vec<u8>> {
        let is_free = !self.buffer.is_shared() && self.buffer.bytes().len() == size;
        is_free.then(|| std::mem::take(self.buffer.bytes_mut()))
    }

    /// Ends the mapping; whether there was one.
    pub(crate) fn unmap(&mut self) -> bool {
        let map = self.map.take();
        let is_mapped = map.is_some();
        if let Some(map) = map {
            self.buffer = Buffer::new(map.bytes);
        }
        is_mapped
    }
}

/// A buffer's bytes while the client has them.
#[derive(Clone, Debug)]
pub(crate) struct Map {
    pub bytes: Vec<u8>,
    /// Which of them.
    pub range: std::ops::Range<usize>,
    /// What the client said it would do (`GL_MAP_…_BIT`).
    pub access: GLbitfield,
}

impl Map {
    /// Where the range is; the same pointer each time, good until the bytes are taken back. (One that is made of a
    /// slice would end those before.)
    pub fn pointer(&mut self) -> *mut u8 {
        self.bytes.as_mut_ptr().wrapping_add(self.range.start)
    }
}

/// What a buffer can be bound to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BufferTarget {
    Array,
    ElementArray,
    PixelPack,
    PixelUnpack,
    CopyRead,
    CopyWrite,
    TransformFeedback,
    Uniform,
    Texture,
}

impl BufferTarget {
    pub(crate) const ALL: [Self; 9] = [
        Self::Array,
        Self::ElementArray,
        Self::PixelPack,
        Self::PixelUnpack,
        Self::CopyRead,
        Self::CopyWrite,
        Self::TransformFeedback,
        Self::Uniform,
        Self::Texture,
    ];
}

pub(crate) const BUFFER_TARGET: Table<BufferTarget> = Table {
    section: SECTION,
    rows: &[
        (GL_ARRAY_BUFFER, BufferTarget::Array),
        (GL_ELEMENT_ARRAY_BUFFER, BufferTarget::ElementArray),
        (GL_PIXEL_PACK_BUFFER, BufferTarget::PixelPack),
        (GL_PIXEL_UNPACK_BUFFER, BufferTarget::PixelUnpack),
        (GL_COPY_READ_BUFFER, BufferTarget::CopyRead),
        (GL_COPY_WRITE_BUFFER, BufferTarget::CopyWrite),
        (GL_TRANSFORM_FEEDBACK_BUFFER, BufferTarget::TransformFeedback),
        (GL_UNIFORM_BUFFER, BufferTarget::Uniform),
        (GL_TEXTURE_BUFFER, BufferTarget::Texture),
    ],
};

/// A buffer that the client does not have mapped.
pub(crate) fn unmapped(object: &mut BufferObject) -> Result<&mut BufferObject> {
    match object.map {
        None => Ok(object),
        Some(_) => invalid_operation(SECTION, "the buffer is mapped: call glUnmapBuffer"),
    }
}

/// The byte range of a call on a part of a buffer.
pub(crate) fn range(
    object: &BufferObject,
    offset: GLintptr,
    size: GLsizeiptr,
) -> Result<std::ops::Range<usize>> {
    let length = object.len();
    let offset = not_negative(SECTION, "offset", offset as i64)?;
    let size = not_negative(SECTION, "size", size as i64)?;
    match offset.checked_add(size) {
        Some(end) if end <= length => Ok(offset..end),
        _ => invalid_value(
            SECTION,
            format!("offset = {offset} and size = {size} reach past the buffer's {length} bytes"),
        ),
    }
}

/// A part of a buffer that is bound to a number.
#[derive(Clone, Debug, Default)]
pub(crate) struct BufferRange {
    pub buffer: Bound,
    /// Its first byte.
    pub offset: usize,
    /// Its bytes; all that there are when it is used, if `None`.
    pub size: Option<usize>,
}
