//! Buffer objects: GL 2.1, section 2.9.

use super::bound::Bound;
use super::{Sweep, listed};
use crate::constants::*;
use crate::context::{Context, limits};
use crate::draw::Recorder;
use crate::entry::{Data, DataOut, Located, LocatedOut};
use crate::error::{
    ErrorCode, GlError, Result, Table, invalid_operation, invalid_value, not_negative,
};
use crate::types::*;
use bytemuck::allocation::try_zeroed_vec;
use rasterizer::driver::Buffer;

const SECTION: &str = "GL 2.1, section 2.9";

/// A buffer object.
#[derive(Clone, Debug)]
pub(crate) struct BufferObject {
    /// Empty while it is mapped.
    buffer: Buffer,
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
    fn new() -> Self {
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
    pub fn bytes_mut(&mut self, recorder: &mut Recorder) -> &mut [u8] {
        self.all_bytes_mut(recorder)
    }

    fn all_bytes_mut(&mut self, recorder: &mut Recorder) -> &mut Vec<u8> {
        let bytes = self.buffer.bytes().len();
        let is_shared = self.buffer.is_shared();
        if is_shared {
            recorder.hold(bytes);
        }
        if self.rewritten.is_some() || is_shared && bytes >= COPIED {
            self.rewritten = Some(recorder.draws);
        }
        self.buffer.bytes_mut()
    }

    /// Whether it is written between draws, so that these had better have copies of what they read.
    pub fn is_rewritten(&self, recorder: &Recorder) -> bool {
        self.rewritten.is_some_and(|draws| recorder.draws - draws < FORGOTTEN)
    }

    /// Takes the bytes out, to be mapped.
    pub(super) fn take_bytes(&mut self, recorder: &mut Recorder) -> Vec<u8> {
        let bytes = std::mem::take(self.all_bytes_mut(recorder));
        self.buffer = Buffer::default();
        bytes
    }

    /// Takes the bytes out if there are so many, and nobody else has them: their memory is there already.
    fn take_as_many(&mut self, size: usize) -> Option<Vec<u8>> {
        let is_free = !self.buffer.is_shared() && self.buffer.bytes().len() == size;
        is_free.then(|| std::mem::take(self.buffer.bytes_mut()))
    }

    /// Ends the mapping; whether there was one.
    pub(super) fn unmap(&mut self) -> bool {
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
    const ALL: [Self; 9] = [
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

/// Kept for queries; it changes nothing.
const USAGE: Table<GLenum> = Table {
    section: "GL 2.1, table 2.6",
    rows: &[
        (GL_STREAM_DRAW, GL_STREAM_DRAW),
        (GL_STREAM_READ, GL_STREAM_READ),
        (GL_STREAM_COPY, GL_STREAM_COPY),
        (GL_STATIC_DRAW, GL_STATIC_DRAW),
        (GL_STATIC_READ, GL_STATIC_READ),
        (GL_STATIC_COPY, GL_STATIC_COPY),
        (GL_DYNAMIC_DRAW, GL_DYNAMIC_DRAW),
        (GL_DYNAMIC_READ, GL_DYNAMIC_READ),
        (GL_DYNAMIC_COPY, GL_DYNAMIC_COPY),
    ],
};

pub(super) fn binding(context: &mut Context, target: BufferTarget) -> &mut Bound {
    match target {
        BufferTarget::Array => &mut context.state.bindings.array_buffer,
        BufferTarget::ElementArray => &mut context.state.bindings.element_array_buffer,
        BufferTarget::PixelPack => &mut context.state.bindings.pixel_pack_buffer,
        BufferTarget::PixelUnpack => &mut context.state.bindings.pixel_unpack_buffer,
        BufferTarget::CopyRead => &mut context.state.bindings.copy_read_buffer,
        BufferTarget::CopyWrite => &mut context.state.bindings.copy_write_buffer,
        BufferTarget::TransformFeedback => &mut context.state.bindings.transform_feedback_buffer,
        BufferTarget::Uniform => &mut context.state.bindings.uniform_buffer,
        BufferTarget::Texture => &mut context.state.bindings.texture_buffer,
    }
}

/// The buffer that is bound to a target.
pub(super) fn bound(context: &mut Context, target: GLenum) -> Result<&mut BufferObject> {
    Ok(with_recorder(context, target)?.0)
}

/// The buffer that is bound to a target and not mapped, and what is told of writes to it.
pub(super) fn writable(
    context: &mut Context,
    target: GLenum,
) -> Result<(&mut BufferObject, &mut Recorder)> {
    let (object, recorder) = with_recorder(context, target)?;
    Ok((unmapped(object)?, recorder))
}

pub(super) fn with_recorder(
    context: &mut Context,
    target: GLenum,
) -> Result<(&mut BufferObject, &mut Recorder)> {
    let bound = binding(context, BUFFER_TARGET.decode("target", target)?).clone();
    match context.objects.buffers.bound_mut(&bound) {
        Some(object) => Ok((object, &mut context.recorder)),
        None => invalid_operation(
            SECTION,
            format!("no buffer is bound to {}: call glBindBuffer", enum_name(target)),
        ),
    }
}

pub(crate) fn gen_buffers(context: &mut Context, n: GLsizei, buffers: &mut [GLuint]) -> Result<()> {
    context.objects.buffers.reserve(SECTION, n, buffers)
}

pub(crate) fn delete_buffers(context: &mut Context, n: GLsizei, buffers: &[GLuint]) -> Result<()> {
    for &name in listed(SECTION, n, buffers)?.iter().filter(|&&name| name != 0) {
        let gone = context.objects.buffers.hold(name);
        for target in BufferTarget::ALL {
            binding(context, target).forget(&gone);
        }
        context.state.arrays.forget_buffer(&gone);
        context.transform_feedback.forget_buffer(&gone);
        context.uniform_buffers.forget_buffer(&gone);
        drop(gone);
        // Its mapping ends, whoever has it.
        if let Some(object) = context.objects.buffers.get_mut(name) {
            object.unmap();
        }
        context.objects.buffers.remove(name);
    }
    context.objects.sweep(Sweep::Deleted);
    Ok(())
}

pub(crate) fn bind_buffer(context: &mut Context, target: GLenum, buffer: GLuint) -> Result<()> {
    let target = BUFFER_TARGET.decode("target", target)?;
    context.objects.buffers.create(buffer, BufferObject::new);
    *binding(context, target) = context.objects.buffers.hold(buffer);
    match target {
        // Calls look there for what they are given.
        BufferTarget::Array | BufferTarget::ElementArray => context.changes.nothing(),
        BufferTarget::PixelPack
        | BufferTarget::PixelUnpack
        | BufferTarget::CopyRead
        | BufferTarget::CopyWrite
        | BufferTarget::TransformFeedback
        | BufferTarget::Uniform
        | BufferTarget::Texture => {}
    }
    Ok(())
}

pub(crate) fn is_buffer(context: &mut Context, buffer: GLuint) -> Result<bool> {
    Ok(context.objects.buffers.get(buffer).is_some())
}

pub(crate) fn buffer_data(
    context: &mut Context,
    target: GLenum,
    size: GLsizeiptr,
    data: Data<'_>,
    usage: GLenum,
) -> Result<()> {
    let device = context.recorder.device();
    let object = bound(context, target)?;
    let size = not_negative(SECTION, "size", size as i64)?;
    let usage = USAGE.decode("usage", usage)?;
    let no_memory = || {
        GlError::new(
            ErrorCode::OutOfMemory,
            SECTION,
            format!("size = {size}: there is no memory for so many bytes"),
        )
    };
    if size > limits::MAX_BUFFER_SIZE {
        return Err(no_memory());
    }
    let zeros = || try_zeroed_vec(size).map_err(|()| no_memory());
    let bytes = match data.locate(0, size) {
        Located::Bytes(source) => match source.get(..size) {
            Some(source) => {
                let mut bytes = object.take_as_many(size).map_or_else(zeros, Ok)?;
                device.copy(source, &mut bytes);
                bytes
            }
            None => {
                return invalid_operation(
                    SECTION,
                    format!("size = {size}, but data has {} bytes", source.len()),
                );
            }
        },
        Located::Null | Located::Offset(0) => zeros()?,
        Located::Offset(_) => {
            return invalid_operation(SECTION, "data is an offset; it must be memory or NULL");
        }
    };
    object.buffer = Buffer::new(bytes);
    object.usage = usage;
    object.map = None;
    object.access = GL_READ_WRITE;
    context.recorder.hold(size);
    Ok(())
}

/// A buffer that the client does not have mapped.
pub(super) fn unmapped(object: &mut BufferObject) -> Result<&mut BufferObject> {
    match object.map {
        None => Ok(object),
        Some(_) => invalid_operation(SECTION, "the buffer is mapped: call glUnmapBuffer"),
    }
}

/// The byte range of a call on a part of a buffer.
pub(super) fn range(
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

pub(crate) fn buffer_sub_data(
    context: &mut Context,
    target: GLenum,
    offset: GLintptr,
    size: GLsizeiptr,
    data: Data<'_>,
) -> Result<()> {
    let (object, recorder) = writable(context, target)?;
    let range = range(object, offset, size)?;
    match data.locate(0, range.len()) {
        Located::Bytes(source) if source.len() >= range.len() => {
            let to = &mut object.bytes_mut(recorder)[range];
            recorder.copy(&source[..to.len()], to);
            Ok(())
        }
        Located::Bytes(source) => invalid_operation(
            SECTION,
            format!("size = {size}, but data has {} bytes", source.len()),
        ),
        // What an empty vector of C++ gives.
        Located::Null | Located::Offset(_) if range.is_empty() => Ok(()),
        Located::Null | Located::Offset(_) => {
            invalid_operation(SECTION, "data is NULL or an offset; it must be memory")
        }
    }
}

pub(crate) fn get_buffer_sub_data(
    context: &mut Context,
    target: GLenum,
    offset: GLintptr,
    size: GLsizeiptr,
    data: DataOut<'_>,
) -> Result<()> {
    let object = unmapped(bound(context, target)?)?;
    let range = range(object, offset, size)?;
    match data.locate(0, range.len()) {
        LocatedOut::Bytes(out) if out.len() >= range.len() => {
            out[..range.len()].copy_from_slice(&object.buffer.bytes()[range]);
            Ok(())
        }
        LocatedOut::Bytes(out) => {
            invalid_operation(SECTION, format!("size = {size}, but data has {} bytes", out.len()))
        }
        LocatedOut::Null | LocatedOut::Offset(_) if range.is_empty() => Ok(()),
        LocatedOut::Null | LocatedOut::Offset(_) => {
            invalid_operation(SECTION, "data is NULL or an offset; it must be memory")
        }
    }
}
