//! Buffer objects (GL 2.1, section 2.9), their mapped ranges (`ARB_map_buffer_range`), and ranges at indexed binding
//! points (GL 3.0, section 2.15; ARB_uniform_buffer_object, section 2.15.3.2).

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value, not_negative};
use crate::base::memory::{copied, out_of_memory};
use crate::base::types::*;
use crate::objects::bound::Bound;
use rasterizer::driver::Buffer;

const SECTION: &str = "GL 2.1, section 2.9";

/// Recorded draws that are not yet submitted, which may use a buffer's bytes.
pub(crate) trait WaitingDraws {
    /// Counts bytes that only the recorded draws still use.
    fn hold(&mut self, bytes: usize);
    /// The number of draws recorded so far.
    fn draws(&self) -> u64;
}

/// A buffer object.
#[derive(Clone, Debug)]
pub(crate) struct BufferObject {
    /// Empty while it is mapped, but persistently: then, what the client has written up to the last call that reads it.
    pub buffer: Buffer,
    /// The flags of immutable storage (`ARB_buffer_storage`).
    pub storage: Option<GLbitfield>,
    pub usage: GLenum,
    pub map: Option<Map>,
    /// `GL_BUFFER_ACCESS`, of the last mapping.
    pub access: GLenum,
    /// The number of draws at its last write, if it ever had to be copied for a write.
    rewritten: Option<u64>,
}

/// Copying fewer bytes costs no more than copying the vertices of a draw.
const COPIED: usize = 1 << 12;
/// After so many draws without a write, a buffer no longer counts as written between draws.
const FORGOTTEN: u64 = 1 << 10;

impl BufferObject {
    pub(crate) fn new() -> Self {
        Self {
            buffer: Buffer::default(),
            storage: None,
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

    /// Whether calls that use its bytes are refused, as the client has them.
    pub fn is_mapped_alone(&self) -> bool {
        self.map.as_ref().is_some_and(|map| !map.is_persistent())
    }

    /// Takes over what the client has written to a persistent mapping.
    pub fn take_client_writes(&mut self, recorder: &mut impl WaitingDraws) {
        let Some(map) = self.map.take() else { return };
        if map.is_persistent() && map.access & GL_MAP_WRITE_BIT != 0 {
            let range = map.range.clone();
            if map.bytes[range.clone()] != self.buffer.bytes()[range.clone()] {
                self.all_bytes_mut(recorder)[range.clone()].copy_from_slice(&map.bytes[range]);
            }
        }
        self.map = Some(map);
    }

    /// Lets `write` change a range of its bytes. Recorded draws keep the old bytes, which are counted; a persistent mapping
    /// has the new ones.
    ///
    /// # Errors
    /// If recorded draws keep the old bytes, and there is no memory for the new ones.
    pub fn write(
        &mut self,
        recorder: &mut impl WaitingDraws,
        range: std::ops::Range<usize>,
        write: impl FnOnce(&mut [u8]),
    ) -> Result<()> {
        write(&mut self.bytes_mut(recorder)?[range.clone()]);
        self.written(range);
        Ok(())
    }

    /// Its bytes for writing; [`Self::written`] follows.
    ///
    /// # Errors
    /// As [`Self::write`].
    pub fn bytes_mut(&mut self, recorder: &mut impl WaitingDraws) -> Result<&mut [u8]> {
        self.take_client_writes(recorder);
        Ok(self.unshared_bytes(recorder)?)
    }

    /// Its bytes, which recorded draws do not have.
    fn unshared_bytes(&mut self, recorder: &mut impl WaitingDraws) -> Result<&mut Vec<u8>> {
        self.note_sharing(recorder);
        self.buffer.unshare().map_err(out_of_memory(SECTION, "a copy of the buffer"))?;
        Ok(self.buffer.bytes_mut())
    }

    /// Gives a persistent mapping what was written.
    pub fn written(&mut self, range: std::ops::Range<usize>) {
        if let Some(map) = &mut self.map {
            map.bytes[range.clone()].copy_from_slice(&self.buffer.bytes()[range]);
        }
    }

    fn all_bytes_mut(&mut self, recorder: &mut impl WaitingDraws) -> &mut Vec<u8> {
        self.note_sharing(recorder);
        self.buffer.bytes_mut()
    }

    /// Takes note that recorded draws may keep the bytes that are about to be written.
    fn note_sharing(&mut self, recorder: &mut impl WaitingDraws) {
        let bytes = self.buffer.bytes().len();
        let is_shared = self.buffer.is_shared();
        if is_shared {
            recorder.hold(bytes);
        }
        if self.rewritten.is_some() || is_shared && bytes >= COPIED {
            self.rewritten = Some(recorder.draws());
        }
    }

    /// Whether it is often written between draws: draws should copy the vertices that they read.
    pub fn is_rewritten(&self, recorder: &impl WaitingDraws) -> bool {
        // A context that shares it may have drawn more than this one.
        self.rewritten.is_some_and(|draws| recorder.draws().saturating_sub(draws) < FORGOTTEN)
    }

    /// The bytes for a mapping with these flags: a copy for a persistent one.
    pub(crate) fn bytes_to_map(
        &mut self,
        recorder: &mut impl WaitingDraws,
        access: GLbitfield,
    ) -> Result<Vec<u8>> {
        if access & GL_MAP_PERSISTENT_BIT == 0 {
            let bytes = std::mem::take(self.unshared_bytes(recorder)?);
            self.buffer = Buffer::default();
            return Ok(bytes);
        }
        copied(self.buffer.bytes()).map_err(out_of_memory(SECTION, "a copy of the buffer"))
    }

    /// Takes the bytes if there are so many and nothing else uses them, to reuse their memory.
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
    /// The mapped range.
    pub range: std::ops::Range<usize>,
    /// The access flags of the mapping (`GL_MAP_…_BIT`).
    pub access: GLbitfield,
}

impl Map {
    /// Whether calls may use the buffer meanwhile.
    pub fn is_persistent(&self) -> bool {
        self.access & GL_MAP_PERSISTENT_BIT != 0
    }

    /// The start of the range. The pointer is valid until the buffer is unmapped. (A pointer derived from a slice would
    /// invalidate earlier ones.)
    pub fn pointer(&mut self) -> *mut u8 {
        self.bytes.as_mut_ptr().wrapping_add(self.range.start)
    }
}

/// The targets to which a buffer can be bound.
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
    DrawIndirect,
}

impl BufferTarget {
    pub(crate) const ALL: [Self; 10] = [
        Self::Array,
        Self::ElementArray,
        Self::PixelPack,
        Self::PixelUnpack,
        Self::CopyRead,
        Self::CopyWrite,
        Self::TransformFeedback,
        Self::Uniform,
        Self::Texture,
        Self::DrawIndirect,
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
        (GL_DRAW_INDIRECT_BUFFER, BufferTarget::DrawIndirect),
    ],
};

/// The buffer, if it is not mapped.
pub(crate) fn unmapped(object: &mut BufferObject) -> Result<&mut BufferObject> {
    match object.is_mapped_alone() {
        false => Ok(object),
        true => invalid_operation(SECTION, "the buffer is mapped: call glUnmapBuffer"),
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

/// The range of a buffer that is bound to an indexed binding point.
#[derive(Clone, Debug, Default)]
pub(crate) struct BufferRange {
    pub buffer: Bound,
    /// Its first byte.
    pub offset: usize,
    /// Its size in bytes; `None` is up to the buffer's end at the time of use.
    pub size: Option<usize>,
}
