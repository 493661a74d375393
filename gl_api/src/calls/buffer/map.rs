//! Mapping buffers, copies between them, and their queries: GL 2.1, section 2.9, `ARB_map_buffer_range`,
//! `ARB_copy_buffer`.
//!
//! The bytes of a mapped buffer are taken out of it, so that a draw that was recorded earlier keeps what
//! it saw and nothing else can read them; calls that would are refused.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::buffer::data::{binding, bound, with_recorder, writable};
use crate::context::Context;
use crate::objects::bound::Bound;
use crate::objects::buffers::{BUFFER_TARGET, BufferObject, Map, range, unmapped};
use std::ops::Range;

const SECTION: &str = "GL 2.1, section 2.9";
const RANGE: &str = "ARB_map_buffer_range";

const ACCESS: Table<GLbitfield> = Table {
    section: SECTION,
    rows: &[
        (GL_READ_ONLY, GL_MAP_READ_BIT),
        (GL_WRITE_ONLY, GL_MAP_WRITE_BIT),
        (GL_READ_WRITE, GL_MAP_READ_BIT | GL_MAP_WRITE_BIT),
    ],
};

/// A checked `glMapBuffer` or `glMapBufferRange`.
struct MapRequest<'a> {
    object: &'a mut BufferObject,
    /// All bytes of the buffer.
    bytes: Vec<u8>,
    range: Range<usize>,
    access: GLbitfield,
}

impl MapRequest<'_> {
    fn apply(self) -> *mut GLvoid {
        let Self { object, bytes, range, access } = self;
        let both = access & (GL_MAP_READ_BIT | GL_MAP_WRITE_BIT);
        object.access = ACCESS.encode(both);
        object.map.insert(Map { bytes, range, access }).pointer().cast()
    }
}

pub(crate) fn map_buffer(
    context: &mut Context,
    target: GLenum,
    access: GLenum,
) -> Result<*mut GLvoid> {
    let buffer = bound(context, target)?;
    map_all(context, &buffer, access)
}

/// Maps all bytes of a buffer.
pub(crate) fn map_all(
    context: &mut Context,
    buffer: &Bound,
    access: GLenum,
) -> Result<*mut GLvoid> {
    let (object, recorder) = with_recorder(context, buffer)?;
    let access = ACCESS.decode("access", access)?;
    let object = never_mapped(object)?;
    check_storage(object, access)?;
    let range = 0..object.len();
    if range.is_empty() {
        return invalid_operation(SECTION, "the buffer has no bytes: call glBufferData first");
    }
    let bytes = object.bytes_to_map(recorder, access)?;
    let pointer = MapRequest { object, bytes, range, access }.apply();
    context.state_changes.values_only();
    Ok(pointer)
}

/// The rule that a combination of access flags breaks.
fn broken_rule(access: GLbitfield) -> Option<&'static str> {
    const UNDEFINED: GLbitfield =
        GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT | GL_MAP_UNSYNCHRONIZED_BIT;
    let has = |bits| access & bits != 0;
    if !has(GL_MAP_READ_BIT | GL_MAP_WRITE_BIT) {
        Some("must have GL_MAP_READ_BIT or GL_MAP_WRITE_BIT")
    } else if has(GL_MAP_READ_BIT) && has(UNDEFINED) {
        Some(
            "reads what it lets be undefined: GL_MAP_READ_BIT goes with no INVALIDATE or \
              UNSYNCHRONIZED bit",
        )
    } else if has(GL_MAP_FLUSH_EXPLICIT_BIT) && !has(GL_MAP_WRITE_BIT) {
        Some("has GL_MAP_FLUSH_EXPLICIT_BIT, which needs GL_MAP_WRITE_BIT")
    } else {
        None
    }
}

/// The buffer, if it has no mapping of any sort.
fn never_mapped(object: &mut BufferObject) -> Result<&mut BufferObject> {
    match object.map {
        None => Ok(object),
        Some(_) => invalid_operation(SECTION, "the buffer is mapped: call glUnmapBuffer"),
    }
}

/// Refuses accesses that the flags of immutable storage do not have; other buffers are not mapped persistently.
fn check_storage(object: &BufferObject, access: GLbitfield) -> Result<()> {
    const ASKED: GLbitfield =
        GL_MAP_READ_BIT | GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    let allowed = object.storage.unwrap_or(GL_MAP_READ_BIT | GL_MAP_WRITE_BIT);
    match access & ASKED & !allowed {
        0 => Ok(()),
        missing => invalid_operation(
            "ARB_buffer_storage",
            format!("access has {missing:#x}, which the flags of glBufferStorage lack"),
        ),
    }
}

pub(crate) fn map_buffer_range(
    context: &mut Context,
    target: GLenum,
    offset: GLintptr,
    length: GLsizeiptr,
    access: GLbitfield,
) -> Result<*mut GLvoid> {
    let buffer = bound(context, target)?;
    map_range(context, &buffer, (offset, length), access)
}

/// Maps some bytes of a buffer.
pub(crate) fn map_range(
    context: &mut Context,
    buffer: &Bound,
    (offset, length): (GLintptr, GLsizeiptr),
    access: GLbitfield,
) -> Result<*mut GLvoid> {
    const ALL: GLbitfield = GL_MAP_READ_BIT
        | GL_MAP_WRITE_BIT
        | GL_MAP_INVALIDATE_RANGE_BIT
        | GL_MAP_INVALIDATE_BUFFER_BIT
        | GL_MAP_FLUSH_EXPLICIT_BIT
        | GL_MAP_UNSYNCHRONIZED_BIT
        | GL_MAP_PERSISTENT_BIT
        | GL_MAP_COHERENT_BIT;
    let (object, recorder) = with_recorder(context, buffer)?;
    let range = range(object, offset, length)?;
    if access & !ALL != 0 {
        return invalid_value(
            RANGE,
            format!("access = {access:#x} has bits that are none of GL_MAP_..._BIT"),
        );
    }
    let object = never_mapped(object)?;
    if let Some(rule) = broken_rule(access) {
        return invalid_operation(RANGE, format!("access = {access:#x} {rule}"));
    }
    check_storage(object, access)?;
    if range.is_empty() {
        return invalid_operation(RANGE, "length = 0 must be above 0");
    }
    let bytes = object.bytes_to_map(recorder, access)?;
    let pointer = MapRequest { object, bytes, range, access }.apply();
    if access & GL_MAP_PERSISTENT_BIT != 0 {
        context.objects.shared.mapped_persistently(buffer.name());
    }
    context.state_changes.values_only();
    Ok(pointer)
}

pub(crate) fn flush_mapped_buffer_range(
    context: &mut Context,
    target: GLenum,
    offset: GLintptr,
    length: GLsizeiptr,
) -> Result<()> {
    let buffer = bound(context, target)?;
    flush_range(context, &buffer, (offset, length))
}

/// Says that mapped bytes of a buffer were written.
pub(crate) fn flush_range(
    context: &mut Context,
    buffer: &Bound,
    (offset, length): (GLintptr, GLsizeiptr),
) -> Result<()> {
    let (object, _) = with_recorder(context, buffer)?;
    let Some(map) = &object.map else {
        return invalid_operation(RANGE, "the buffer is not mapped: call glMapBufferRange");
    };
    if map.access & GL_MAP_FLUSH_EXPLICIT_BIT == 0 {
        return invalid_operation(
            RANGE,
            "the buffer was mapped without GL_MAP_FLUSH_EXPLICIT_BIT: add it to the access of \
             glMapBufferRange, or leave out the call",
        );
    }
    let mapped = map.range.len();
    if range(object, offset, length)?.end > mapped {
        return invalid_value(
            RANGE,
            format!("offset = {offset} and length = {length} reach past the {mapped} mapped bytes"),
        );
    }
    context.state_changes.values_only();
    Ok(())
}

pub(crate) fn unmap_buffer(context: &mut Context, target: GLenum) -> Result<bool> {
    let buffer = bound(context, target)?;
    unmap(context, &buffer)
}

/// Ends the mapping of a buffer.
pub(crate) fn unmap(context: &mut Context, buffer: &Bound) -> Result<bool> {
    match with_recorder(context, buffer)?.0.unmap() {
        true => {
            context.state_changes.values_only();
            Ok(true)
        }
        false => invalid_operation(
            SECTION,
            "the buffer is not mapped: it never was, or glBufferData has ended it",
        ),
    }
}

impl Context {
    /// The bytes of a mapped buffer, for clients that do not want to work with the pointer that
    /// `glMapBuffer` gives. `None` if nothing is bound to the target or it is not mapped.
    pub fn mapped_bytes(&mut self, target: GLenum) -> Option<&mut [u8]> {
        let bound = binding(self, BUFFER_TARGET.get(target)?).clone();
        let map = self.objects.shared.buffers.bound_mut(&bound)?.map.as_mut()?;
        Some(&mut map.bytes[map.range.clone()])
    }
}

pub(crate) fn copy_buffer_sub_data(
    context: &mut Context,
    read_target: GLenum,
    write_target: GLenum,
    read_offset: GLintptr,
    write_offset: GLintptr,
    size: GLsizeiptr,
) -> Result<()> {
    let (from, to) = (bound(context, read_target)?, bound(context, write_target)?);
    copy(context, (&from, &to), (read_offset, write_offset), size)
}

/// Copies bytes from one buffer to another, or within one.
pub(crate) fn copy(
    context: &mut Context,
    (read, write): (&Bound, &Bound),
    (read_offset, write_offset): (GLintptr, GLintptr),
    size: GLsizeiptr,
) -> Result<()> {
    let (source, recorder) = with_recorder(context, read)?;
    let source = unmapped(source)?;
    source.take_client_writes(recorder);
    let from = range(source, read_offset, size)?;
    let source = source.buffer().clone();
    let same = read == write;
    let (target, recorder) = writable(context, write)?;
    let to = range(target, write_offset, size)?;
    if same && from.start < to.end && to.start < from.end {
        return invalid_value(
            "ARB_copy_buffer",
            format!("bytes {from:?} and {to:?} of the same buffer must not overlap"),
        );
    }
    if same {
        // Nothing but draws shares what is written to.
        drop(source);
        target.bytes_mut(recorder)?.copy_within(from, to.start);
    } else {
        target.bytes_mut(recorder)?[to.clone()].copy_from_slice(&source.bytes()[from]);
    }
    target.written(to);
    Ok(())
}

/// Takes over what clients have written to persistent mappings. The next draw is none that can be appended to the last
/// one.
pub(crate) fn take_client_writes(context: &mut Context) {
    if context.objects.shared.take_client_writes(&mut context.recorder) {
        context.recorder.emitted.last_draw = None;
    }
}

pub(crate) fn get_buffer_pointerv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [*mut GLvoid],
) -> Result<()> {
    check_pointer(pname)?;
    let buffer = bound(context, target)?;
    pointer(context, &buffer, params)
}

/// Refuses every `pname` of `glGetBufferPointerv` but the one that there is.
pub(crate) fn check_pointer(pname: GLenum) -> Result<()> {
    const POINTER: Table<()> =
        Table { section: "GL 2.1, section 6.1.13", rows: &[(GL_BUFFER_MAP_POINTER, ())] };
    POINTER.decode("pname", pname)
}

/// Reads where the mapped bytes of a buffer are.
pub(crate) fn pointer(
    context: &mut Context,
    buffer: &Bound,
    params: &mut [*mut GLvoid],
) -> Result<()> {
    let (object, _) = with_recorder(context, buffer)?;
    let pointer = match &mut object.map {
        Some(map) => map.pointer().cast(),
        None => std::ptr::null_mut(),
    };
    put(params, &[pointer])
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Size,
    Usage,
    Access,
    AccessFlags,
    Mapped,
    MapOffset,
    MapLength,
    ImmutableStorage,
    StorageFlags,
}

/// What is known of a buffer.
pub(crate) fn parameter(context: &mut Context, buffer: &Bound, pname: GLenum) -> Result<GLint64> {
    const PROPERTY: Table<Property> = Table {
        section: "GL 2.1, section 6.1.13",
        rows: &[
            (GL_BUFFER_SIZE, Property::Size),
            (GL_BUFFER_USAGE, Property::Usage),
            (GL_BUFFER_ACCESS, Property::Access),
            (GL_BUFFER_ACCESS_FLAGS, Property::AccessFlags),
            (GL_BUFFER_MAPPED, Property::Mapped),
            (GL_BUFFER_MAP_OFFSET, Property::MapOffset),
            (GL_BUFFER_MAP_LENGTH, Property::MapLength),
            (GL_BUFFER_IMMUTABLE_STORAGE, Property::ImmutableStorage),
            (GL_BUFFER_STORAGE_FLAGS, Property::StorageFlags),
        ],
    };
    let (object, _) = with_recorder(context, buffer)?;
    let map = object.map.as_ref();
    Ok(match PROPERTY.decode("pname", pname)? {
        Property::Size => object.len() as GLint64,
        Property::Usage => object.usage.into(),
        Property::Access => object.access.into(),
        Property::AccessFlags => map.map_or(0, |map| map.access.into()),
        Property::Mapped => map.is_some().into(),
        Property::MapOffset => map.map_or(0, |map| map.range.start as GLint64),
        Property::MapLength => map.map_or(0, |map| map.range.len() as GLint64),
        Property::ImmutableStorage => object.storage.is_some().into(),
        Property::StorageFlags => object.storage.unwrap_or(0).into(),
    })
}

/// Of sizes that an integer cannot hold, the largest one.
pub(crate) fn get_buffer_parameteriv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let buffer = bound(context, target)?;
    let value = parameter(context, &buffer, pname)?;
    put(params, &[value.min(GLint::MAX.into()) as GLint])
}

pub(crate) fn get_buffer_parameteri64v(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLint64],
) -> Result<()> {
    let buffer = bound(context, target)?;
    let value = parameter(context, &buffer, pname)?;
    put(params, &[value])
}
