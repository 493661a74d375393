//! The names, bindings and contents of buffer objects: GL 2.1, section 2.9.

use crate::base::args::{Data, DataOut, Located, LocatedOut};
use crate::base::constants::*;
use crate::base::error::{
    ErrorCode, GlError, Result, Table, invalid_operation, invalid_value, not_negative,
};
use crate::base::limits;
use crate::base::types::*;
use crate::context::Context;
use crate::context::recorder::Recorder;
use crate::objects::bound::Bound;
use crate::objects::buffers::{BUFFER_TARGET, BufferObject, BufferTarget, range, unmapped};
use crate::objects::name_table::{Sweep, listed};
use bytemuck::allocation::try_zeroed_vec;
use rasterizer::driver::Buffer;

const SECTION: &str = "GL 2.1, section 2.9";
const STORAGE: &str = "ARB_buffer_storage";

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

pub(crate) fn binding(context: &mut Context, target: BufferTarget) -> &mut Bound {
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
        BufferTarget::DrawIndirect => &mut context.state.bindings.draw_indirect_buffer,
    }
}

/// The buffer that is bound to a target.
pub(crate) fn bound(context: &mut Context, target: GLenum) -> Result<Bound> {
    let bound = binding(context, BUFFER_TARGET.decode("target", target)?).clone();
    match context.objects.shared.buffers.bound(&bound) {
        Some(_) => Ok(bound),
        None => invalid_operation(
            SECTION,
            format!("no buffer is bound to {}: call glBindBuffer", enum_name(target)),
        ),
    }
}

/// The buffer of a name (`ARB_direct_state_access`).
///
/// # Errors
/// `GL_INVALID_OPERATION` for a name that no buffer has.
pub(crate) fn named(context: &mut Context, argument: &str, name: GLuint) -> Result<Bound> {
    let buffers = &mut context.objects.shared.buffers;
    match buffers.get(name) {
        Some(_) => Ok(buffers.hold(name)),
        None => invalid_operation(
            "ARB_direct_state_access, section 6.2",
            format!(
                "{argument} = {name} is no buffer: glCreateBuffers makes some, and so does binding a name once"
            ),
        ),
    }
}

/// A buffer that is not mapped, and the recorder whose draws may still read it.
pub(crate) fn writable<'a>(
    context: &'a mut Context,
    buffer: &Bound,
) -> Result<(&'a mut BufferObject, &'a mut Recorder)> {
    let (object, recorder) = with_recorder(context, buffer)?;
    Ok((unmapped(object)?, recorder))
}

/// A buffer, and the recorder whose draws may still read it.
pub(crate) fn with_recorder<'a>(
    context: &'a mut Context,
    buffer: &Bound,
) -> Result<(&'a mut BufferObject, &'a mut Recorder)> {
    match context.objects.shared.buffers.bound_mut(buffer) {
        Some(object) => Ok((object, &mut context.recorder)),
        None => invalid_operation(SECTION, "there is no such buffer: call glBindBuffer"),
    }
}

pub(crate) fn gen_buffers(context: &mut Context, n: GLsizei, buffers: &mut [GLuint]) -> Result<()> {
    context.objects.shared.buffers.reserve(SECTION, n, buffers)
}

pub(crate) fn delete_buffers(context: &mut Context, n: GLsizei, buffers: &[GLuint]) -> Result<()> {
    for &name in listed(SECTION, n, buffers)?.iter().filter(|&&name| name != 0) {
        let gone = context.objects.shared.buffers.hold(name);
        for target in BufferTarget::ALL {
            binding(context, target).forget(&gone);
        }
        context.state.arrays.forget_buffer(&gone);
        context.transform_feedback.forget_buffer(&gone);
        context.uniform_buffers.forget_buffer(&gone);
        drop(gone);
        // Its mapping ends, whoever has it.
        if let Some(object) = context.objects.shared.buffers.get_mut(name) {
            object.unmap();
        }
        context.objects.shared.buffers.remove(name);
    }
    context.objects.shared.sweep(Sweep::Deleted);
    Ok(())
}

pub(crate) fn bind_buffer(context: &mut Context, target: GLenum, buffer: GLuint) -> Result<()> {
    let target = BUFFER_TARGET.decode("target", target)?;
    if context.profile.is_core() {
        context.objects.shared.buffers.check_given("buffer", buffer, "glGenBuffers")?;
    }
    match target {
        BufferTarget::Array | BufferTarget::ElementArray | BufferTarget::DrawIndirect => {}
        BufferTarget::PixelPack
        | BufferTarget::PixelUnpack
        | BufferTarget::CopyRead
        | BufferTarget::CopyWrite
        | BufferTarget::TransformFeedback
        | BufferTarget::Uniform
        | BufferTarget::Texture => context.leave_plain_state(),
    }
    bind(context, target, buffer);
    Ok(())
}

/// Binds a buffer, which is created if it does not exist.
pub(crate) fn bind(context: &mut Context, target: BufferTarget, buffer: GLuint) {
    context.objects.shared.buffers.create(buffer, BufferObject::new);
    *binding(context, target) = context.objects.shared.buffers.hold(buffer);
    // Calls look there for what they are given; draws do not.
    context.state_changes.no_change();
}

pub(crate) fn is_buffer(context: &mut Context, buffer: GLuint) -> Result<bool> {
    Ok(context.objects.shared.buffers.get(buffer).is_some())
}

/// A checked `glBufferData`.
struct BufferDataRequest<'a> {
    object: &'a mut BufferObject,
    recorder: &'a mut Recorder,
    /// The buffer's memory: as many bytes as it is to have.
    bytes: Vec<u8>,
    usage: GLenum,
    /// What they are to be; `None` for zeros, which they are.
    source: Option<&'a [u8]>,
}

impl<'a> BufferDataRequest<'a> {
    fn new(
        (object, recorder): (&'a mut BufferObject, &'a mut Recorder),
        size: GLsizeiptr,
        data: Data<'a>,
        usage: GLenum,
    ) -> Result<Self> {
        let size = not_negative(SECTION, "size", size as i64)?;
        if object.storage.is_some() {
            return invalid_operation(STORAGE, "the buffer's storage is immutable: bind another");
        }
        let usage = USAGE.decode("usage", usage)?;
        if size > limits::MAX_BUFFER_SIZE {
            return Err(no_memory(size));
        }
        let source = match data.locate(0, size) {
            Located::Bytes(source) if source.len() >= size => Some(&source[..size]),
            Located::Bytes(source) => return too_short(size as i64, source.len()),
            Located::Null | Located::Offset(0) => None,
            Located::Offset(_) => {
                return invalid_operation(SECTION, "data is an offset; it must be memory or NULL");
            }
        };
        let zeros = || try_zeroed_vec(size).map_err(|()| no_memory(size));
        let bytes = match source {
            Some(_) => object.take_as_many(size).map_or_else(zeros, Ok)?,
            None => zeros()?,
        };
        Ok(Self { object, recorder, bytes, usage, source })
    }

    fn apply(self) -> &'a mut BufferObject {
        let Self { object, recorder, mut bytes, usage, source } = self;
        let size = bytes.len();
        if let Some(source) = source {
            recorder.copy(source, &mut bytes);
        }
        object.buffer = Buffer::new(bytes);
        object.usage = usage;
        object.map = None;
        object.access = GL_READ_WRITE;
        recorder.hold(size);
        object
    }
}

fn no_memory(size: usize) -> GlError {
    GlError::new(
        ErrorCode::OutOfMemory,
        SECTION,
        format!("size = {size}: there is no memory for so many bytes"),
    )
}

fn too_short<T>(size: i64, has: usize) -> Result<T> {
    invalid_operation(SECTION, format!("size = {size}, but data has {has} bytes"))
}

fn not_memory<T>() -> Result<T> {
    invalid_operation(SECTION, "data is NULL or an offset; it must be memory")
}

pub(crate) fn buffer_data(
    context: &mut Context,
    target: GLenum,
    size: GLsizeiptr,
    data: Data<'_>,
    usage: GLenum,
) -> Result<()> {
    let buffer = bound(context, target)?;
    set_data(context, &buffer, size, data, usage)
}

/// Gives a buffer its bytes.
pub(crate) fn set_data(
    context: &mut Context,
    buffer: &Bound,
    size: GLsizeiptr,
    data: Data<'_>,
    usage: GLenum,
) -> Result<()> {
    BufferDataRequest::new(with_recorder(context, buffer)?, size, data, usage)?.apply();
    context.state_changes.values_only();
    Ok(())
}

pub(crate) fn buffer_sub_data(
    context: &mut Context,
    target: GLenum,
    offset: GLintptr,
    size: GLsizeiptr,
    data: Data<'_>,
) -> Result<()> {
    let buffer = bound(context, target)?;
    replace_data(context, &buffer, (offset, size), data)
}

/// Replaces some bytes of a buffer.
pub(crate) fn replace_data(
    context: &mut Context,
    buffer: &Bound,
    (offset, size): (GLintptr, GLsizeiptr),
    data: Data<'_>,
) -> Result<()> {
    let (object, recorder) = writable(context, buffer)?;
    let range = range(object, offset, size)?;
    if object.storage.is_some_and(|flags| flags & GL_DYNAMIC_STORAGE_BIT == 0) {
        return invalid_operation(
            STORAGE,
            "the buffer's storage is immutable: give glBufferStorage GL_DYNAMIC_STORAGE_BIT",
        );
    }
    match data.locate(0, range.len()) {
        Located::Bytes(source) if source.len() >= range.len() => {
            let to = &mut object.bytes_mut(recorder)?[range.clone()];
            recorder.copy(&source[..to.len()], to);
            object.written(range);
            context.state_changes.values_only();
            Ok(())
        }
        Located::Bytes(source) => too_short(size as i64, source.len()),
        // What an empty vector of C++ gives.
        Located::Null | Located::Offset(_) if range.is_empty() => Ok(()),
        Located::Null | Located::Offset(_) => not_memory(),
    }
}

pub(crate) fn get_buffer_sub_data(
    context: &mut Context,
    target: GLenum,
    offset: GLintptr,
    size: GLsizeiptr,
    data: DataOut<'_>,
) -> Result<()> {
    let buffer = bound(context, target)?;
    read_data(context, &buffer, (offset, size), data)
}

/// Reads some bytes of a buffer.
pub(crate) fn read_data(
    context: &mut Context,
    buffer: &Bound,
    (offset, size): (GLintptr, GLsizeiptr),
    data: DataOut<'_>,
) -> Result<()> {
    let (object, recorder) = with_recorder(context, buffer)?;
    let object = unmapped(object)?;
    let range = range(object, offset, size)?;
    object.take_client_writes(recorder);
    match data.locate(0, range.len()) {
        LocatedOut::Bytes(out) if out.len() >= range.len() => {
            out[..range.len()].copy_from_slice(&object.buffer.bytes()[range]);
            Ok(())
        }
        LocatedOut::Bytes(out) => too_short(size as i64, out.len()),
        LocatedOut::Null | LocatedOut::Offset(_) if range.is_empty() => Ok(()),
        LocatedOut::Null | LocatedOut::Offset(_) => not_memory(),
    }
}

pub(crate) fn buffer_storage(
    context: &mut Context,
    target: GLenum,
    size: GLsizeiptr,
    data: Data<'_>,
    flags: GLbitfield,
) -> Result<()> {
    let buffer = bound(context, target)?;
    set_storage(context, &buffer, size, data, flags)
}

/// Gives a buffer its bytes for good, and says what may be done with them (`ARB_buffer_storage`).
pub(crate) fn set_storage(
    context: &mut Context,
    buffer: &Bound,
    size: GLsizeiptr,
    data: Data<'_>,
    flags: GLbitfield,
) -> Result<()> {
    const ALL: GLbitfield = GL_MAP_READ_BIT
        | GL_MAP_WRITE_BIT
        | GL_MAP_PERSISTENT_BIT
        | GL_MAP_COHERENT_BIT
        | GL_DYNAMIC_STORAGE_BIT
        | GL_CLIENT_STORAGE_BIT;
    let bound = with_recorder(context, buffer)?;
    let has = |bits| flags & bits != 0;
    if size <= 0 {
        return invalid_value(STORAGE, format!("size = {size} must be above 0"));
    }
    let rule = if has(!ALL) {
        "has bits that are none of glBufferStorage's"
    } else if has(GL_MAP_PERSISTENT_BIT) && !has(GL_MAP_READ_BIT | GL_MAP_WRITE_BIT) {
        "has GL_MAP_PERSISTENT_BIT, which needs GL_MAP_READ_BIT or GL_MAP_WRITE_BIT"
    } else if has(GL_MAP_COHERENT_BIT) && !has(GL_MAP_PERSISTENT_BIT) {
        "has GL_MAP_COHERENT_BIT, which needs GL_MAP_PERSISTENT_BIT"
    } else {
        let request = BufferDataRequest::new(bound, size, data, GL_DYNAMIC_DRAW)?;
        let object = request.apply();
        object.storage = Some(flags);
        return Ok(());
    };
    invalid_value(STORAGE, format!("flags = {flags:#x} {rule}"))
}
