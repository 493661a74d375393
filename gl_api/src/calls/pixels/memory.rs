//! The memory that pixels come from and go to: the client's, or a pixel buffer object
//! (`ARB_pixel_buffer_object`, section 3.6.1).

use crate::base::args::{Data, DataOut, Located, LocatedOut};
use crate::base::error::{Result, invalid_operation};
use crate::base::types::GLuint;
use crate::calls::buffer::map::take_client_writes;
use crate::context::Context;
use crate::objects::bound::Bound;
use crate::pixel::layout::Layout;
use crate::pixel::memory::Source;
use crate::pixel::store::PixelStore;

const SECTION: &str = "ARB_pixel_buffer_object, section 3.6.1";

/// What a call's `pixels` are read from, or `None` for a null pointer.
pub(crate) fn source<'a>(
    context: &Context,
    pixels: Data<'a>,
    needed: usize,
) -> Result<Option<Source<'a>>> {
    let bound = &context.state.bindings.pixel_unpack_buffer;
    let name = bound.name();
    not_mapped(context, bound)?;
    match (context.objects.shared.buffers.bound(bound), pixels.locate(name, needed)) {
        (None, Located::Null | Located::Offset(0)) => Ok(None),
        (None, Located::Bytes(bytes)) => Ok(Some(Source::Client(bytes))),
        (None, Located::Offset(offset)) => no_buffer(offset, "GL_PIXEL_UNPACK_BUFFER"),
        (Some(_), Located::Bytes(_)) => slice_and_buffer("GL_PIXEL_UNPACK_BUFFER"),
        (Some(object), Located::Null) => Ok(Some(Source::Buffer(object.buffer().clone(), 0))),
        (Some(object), Located::Offset(offset)) => {
            if needed > 0 {
                let length = object.buffer().bytes().len();
                check_offset(offset, length, name, "GL_PIXEL_UNPACK_BUFFER")?;
            }
            Ok(Some(Source::Buffer(object.buffer().clone(), offset)))
        }
    }
}

/// The client's pixels, with enough bytes for the layout, or `None` for a null pointer; `call` is
/// named where they may not lie as they are read.
pub(crate) fn pixel_source<'a>(
    context: &mut Context,
    call: &'static str,
    layout: &Layout,
    pixels: Data<'a>,
) -> Result<Option<Source<'a>>> {
    take_client_writes(context);
    // How long a pointer's memory is, nobody knows.
    let unknown = matches!(pixels, Data::Client(_));
    let source = source(context, pixels, layout.needed)?;
    if unknown && matches!(source, Some(Source::Client(_))) {
        check_alignment(context, call, layout);
    }
    if let Some(source) = &source {
        layout.check_length(source.bytes().len(), "GL_UNPACK_ALIGNMENT")?;
        if let Source::Buffer(_, offset) = source {
            check_multiple(layout, *offset)?;
        }
    }
    Ok(source)
}

/// Warns where rows are padded because nobody has said otherwise: the commonest reason of skewed
/// pictures, and of reading past the client's memory.
fn check_alignment(context: &mut Context, call: &'static str, layout: &Layout) {
    let unpack = &context.state.unpack;
    let (tight, stride, [_, height, depth]) = (layout.row_bytes(), layout.stride, layout.size);
    let default = PixelStore::default().alignment;
    if unpack.alignment != default
        || unpack.row_length != 0
        || height.saturating_mul(depth) < 2
        || stride == tight
    {
        return;
    }
    context.debug.warn(format!(
        "{call}: rows of {tight} bytes are read {stride} apart, as GL_UNPACK_ALIGNMENT is \
         {default}: if they are packed, call glPixelStorei(GL_UNPACK_ALIGNMENT, 1)"
    ));
}

/// Lets `write` write `needed` bytes to where a call's `pixels` are.
pub(crate) fn write_bytes(
    context: &mut Context,
    pixels: DataOut<'_>,
    needed: usize,
    write: impl FnOnce(&mut [u8]),
) -> Result<()> {
    let bound = &context.state.bindings.pixel_pack_buffer;
    let name = bound.name();
    not_mapped(context, bound)?;
    match (context.objects.shared.buffers.bound_mut(bound), pixels.locate(name, needed)) {
        (_, LocatedOut::Null | LocatedOut::Offset(0)) if needed == 0 => Ok(()),
        (Some(_), LocatedOut::Offset(_)) if needed == 0 => Ok(()),
        (None, LocatedOut::Bytes(bytes)) => {
            check_length(bytes.len(), needed)?;
            write(bytes);
            Ok(())
        }
        (None, LocatedOut::Null | LocatedOut::Offset(0)) => invalid_operation(
            SECTION,
            format!("pixels must not be NULL: {needed} bytes are needed"),
        ),
        (None, LocatedOut::Offset(offset)) => no_buffer(offset, "GL_PIXEL_PACK_BUFFER"),
        (Some(_), LocatedOut::Bytes(_)) => slice_and_buffer("GL_PIXEL_PACK_BUFFER"),
        (Some(object), out @ (LocatedOut::Null | LocatedOut::Offset(_))) => {
            let offset = if let LocatedOut::Offset(offset) = out { offset } else { 0 };
            let length = object.buffer().bytes().len();
            check_offset(offset, length, name, "GL_PIXEL_PACK_BUFFER")?;
            check_length(length - offset, needed)?;
            object.write(&mut context.recorder, offset..length, write)
        }
    }
}

/// Lets `write` write pixels of this layout to where a call's `pixels` are.
pub(crate) fn write_pixels(
    context: &mut Context,
    layout: &Layout,
    pixels: DataOut<'_>,
    write: impl FnOnce(&mut [u8]),
) -> Result<()> {
    match &pixels {
        DataOut::Bytes(bytes) => layout.check_length(bytes.len(), "GL_PACK_ALIGNMENT")?,
        DataOut::Offset(offset) => check_multiple(layout, *offset)?,
        DataOut::Client(pointer) if context.state.bindings.pixel_pack_buffer.name() != 0 => {
            check_multiple(layout, pointer.offset())?;
        }
        DataOut::Null | DataOut::Client(_) => {}
    }
    write_bytes(context, pixels, layout.needed, write)
}

/// Refuses a buffer that the client has mapped.
fn not_mapped(context: &Context, bound: &Bound) -> Result<()> {
    match context.objects.shared.buffers.bound(bound) {
        Some(object) if object.is_mapped_alone() => invalid_operation(
            SECTION,
            format!("buffer {} is bound for pixels and mapped: call glUnmapBuffer", bound.name()),
        ),
        Some(_) | None => Ok(()),
    }
}

fn check_length(has: usize, needed: usize) -> Result<()> {
    if has >= needed {
        return Ok(());
    }
    invalid_operation(SECTION, format!("{needed} bytes are needed; there are {has}"))
}

fn check_offset(offset: usize, length: usize, buffer: GLuint, target: &str) -> Result<()> {
    if offset <= length {
        return Ok(());
    }
    invalid_operation(
        SECTION,
        format!(
            "pixels = offset {offset} lies behind the {length} bytes of buffer {buffer}: while it \
             is bound to {target}, pixels is an offset; if it is memory, call \
             glBindBuffer({target}, 0)"
        ),
    )
}

fn check_multiple(layout: &Layout, offset: usize) -> Result<()> {
    let size = layout.pixel.ty.size();
    if offset.is_multiple_of(size) {
        return Ok(());
    }
    invalid_operation(
        SECTION,
        format!("pixels = offset {offset} must be a multiple of the type's {size} bytes"),
    )
}

fn no_buffer<T>(offset: usize, target: &str) -> Result<T> {
    invalid_operation(
        SECTION,
        format!("pixels = offset {offset}, but no buffer is bound to {target}"),
    )
}

fn slice_and_buffer<T>(target: &str) -> Result<T> {
    invalid_operation(
        SECTION,
        format!("pixels is memory, but a buffer is bound to {target}: pass an offset into it"),
    )
}
