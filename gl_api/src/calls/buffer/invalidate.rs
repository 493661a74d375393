//! `glInvalidateBufferData` and `glInvalidateBufferSubData` (`ARB_invalidate_subdata`, section 2.9.X): bytes that may be
//! forgotten. They are kept, so that what is read of them is the same on every machine.

use crate::base::error::{Result, invalid_operation, invalid_value};
use crate::base::types::*;
use crate::context::Context;
use crate::objects::buffers::range;
use std::ops::Range;

const SECTION: &str = "ARB_invalidate_subdata, section 2.9.X";

/// Checks that bytes of a buffer, or all, can be forgotten: none of them is mapped, but persistently.
fn check(context: &Context, buffer: GLuint, part: Option<(GLintptr, GLsizeiptr)>) -> Result<()> {
    let Some(object) = context.objects.shared.buffers.get(buffer).filter(|_| buffer != 0) else {
        return invalid_value(SECTION, format!("buffer = {buffer} is no buffer"));
    };
    let forgotten = match part {
        None => 0..object.len(),
        Some((offset, size)) => range(object, offset, size)?,
    };
    let overlaps = |mapped: &Range<usize>| {
        part.is_none() || forgotten.start < mapped.end && mapped.start < forgotten.end
    };
    let map = object.map.as_ref().filter(|map| !map.is_persistent());
    match map.map(|map| map.range.clone()).filter(overlaps) {
        None => Ok(()),
        Some(mapped) => invalid_operation(
            SECTION,
            format!(
                "bytes {forgotten:?} are invalidated, and {mapped:?} are mapped: call glUnmapBuffer"
            ),
        ),
    }
}

pub(crate) fn invalidate_buffer_data(context: &mut Context, buffer: GLuint) -> Result<()> {
    check(context, buffer, None)
}

pub(crate) fn invalidate_buffer_sub_data(
    context: &mut Context,
    buffer: GLuint,
    offset: GLintptr,
    length: GLsizeiptr,
) -> Result<()> {
    check(context, buffer, Some((offset, length)))
}
