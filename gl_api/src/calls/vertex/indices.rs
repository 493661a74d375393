//! Where the indices of a draw are read from, and whether they fit into the arrays: GL 2.1, section 2.8.

use crate::base::args::{Data, Located};
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, not_negative};
use crate::base::memory::{copied, out_of_memory};
use crate::base::types::*;
use crate::calls::vertex::draws::SECTION;
use crate::context::Context;
use crate::draw::vertex_range::small_range;
use crate::objects::buffers::BufferObject;
use rasterizer::driver::{Buffer, IndexType};

pub(crate) const INDEX_TYPE: Table<IndexType> = Table {
    section: SECTION,
    rows: &[
        (GL_UNSIGNED_BYTE, IndexType::U8),
        (GL_UNSIGNED_SHORT, IndexType::U16),
        (GL_UNSIGNED_INT, IndexType::U32),
    ],
};

/// Where the indices of a draw are: memory of so many bytes, or an offset into the bound buffer.
///
/// # Errors
/// If they are not all there.
fn located_indices<'a>(
    context: &Context,
    indices: Data<'a>,
    count: usize,
    needed: usize,
) -> Result<Located<'a>> {
    let bound = &context.state.bindings.element_array_buffer;
    let name = bound.name();
    let object = context.objects.shared.buffers.bound(bound);
    if object.is_some_and(BufferObject::is_mapped_alone) {
        return invalid_operation(
            SECTION,
            format!(
                "buffer {name} is bound to GL_ELEMENT_ARRAY_BUFFER and mapped: call glUnmapBuffer"
            ),
        );
    }
    // No index needs no memory, wherever that is.
    if needed == 0 {
        return Ok(Located::Null);
    }
    let offset = match (indices.locate(name, needed), object) {
        (Located::Bytes(bytes), None) => match bytes.get(..needed) {
            Some(bytes) => return Ok(Located::Bytes(bytes)),
            None => {
                return invalid_operation(
                    SECTION,
                    format!(
                        "count = {count} indices take {needed} bytes, the memory has {}",
                        bytes.len()
                    ),
                );
            }
        },
        (Located::Offset(offset), Some(_)) => offset,
        (Located::Null, Some(_)) => 0,
        (Located::Bytes(_), Some(_)) => {
            return invalid_operation(
                SECTION,
                format!(
                    "indices is memory, but buffer {name} is bound to GL_ELEMENT_ARRAY_BUFFER: \
                     pass BUFFER_OFFSET(n), or bind buffer 0"
                ),
            );
        }
        (Located::Offset(_) | Located::Null, None) => {
            return invalid_operation(
                SECTION,
                "indices is NULL or an offset, but no buffer is bound to GL_ELEMENT_ARRAY_BUFFER",
            );
        }
    };
    let has = object.map_or(0, |object| object.buffer().bytes().len());
    if offset.checked_add(needed).is_none_or(|end| end > has) {
        return invalid_operation(
            SECTION,
            format!(
                "count = {count} indices from byte {offset} reach past the buffer's {has} bytes"
            ),
        );
    }
    Ok(Located::Offset(offset))
}

/// The bytes of indices, and where they begin.
pub(crate) fn index_buffer(
    context: &Context,
    indices: Data<'_>,
    count: usize,
    needed: usize,
) -> Result<(Buffer, usize)> {
    let offset = match located_indices(context, indices, count, needed)? {
        Located::Bytes(bytes) => {
            let bytes = copied(bytes).map_err(out_of_memory(SECTION, "a copy of the indices"))?;
            return Ok((Buffer::new(bytes), 0));
        }
        Located::Null => return Ok((Buffer::default(), 0)),
        Located::Offset(offset) => offset,
    };
    let object = context.objects.shared.buffers.bound(&context.state.bindings.element_array_buffer);
    let buffer = object.map(|object| object.buffer().clone()).unwrap_or_default();
    let is_rewritten = object.is_some_and(|object| object.is_rewritten(&context.recorder));
    let part = is_rewritten.then(|| small_range(&buffer, offset..offset + needed)).flatten();
    Ok(part.map_or((buffer, offset), |part| (part, 0)))
}

/// Checks the indices of a draw, which is not drawn yet.
pub(crate) fn check_indices(
    context: &Context,
    indices: Data<'_>,
    count: GLsizei,
    ty: IndexType,
) -> Result<()> {
    let count = not_negative(SECTION, "count", count.into())?;
    located_indices(context, indices, count, count.saturating_mul(ty.size())).map(|_| ())
}
