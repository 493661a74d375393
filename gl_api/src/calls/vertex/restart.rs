//! Primitive restart (`NV_primitive_restart`, GL 3.1; OpenGL ES 3.0, section 2.9.1): an index that ends a primitive and begins
//! the next. An indexed draw becomes a draw of each run between such indices.

use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::context::Context;
use crate::state::enable::Flag;
use rasterizer::driver::{Buffer, IndexType};
use std::ops::Range;

/// Whether an index restarts.
pub(crate) fn is_restart(context: &Context, index: u32) -> bool {
    context.state.enables.has(Flag::PrimitiveRestart) && index == context.state.restart_index
}

/// The runs of indices, as their numbers in the draw; all of them, where nothing restarts.
pub(crate) fn runs(
    context: &Context,
    buffer: &Buffer,
    offset: usize,
    ty: IndexType,
    count: usize,
) -> Vec<Range<usize>> {
    let enables = &context.state.enables;
    // The largest index of the type restarts whatever glPrimitiveRestartIndex has.
    let restart = if enables.has(Flag::PrimitiveRestartFixedIndex) {
        u32::MAX >> (32 - 8 * ty.size())
    } else if enables.has(Flag::PrimitiveRestart) {
        context.state.restart_index
    } else {
        return Vec::from([Range { start: 0, end: count }]);
    };
    let bytes = &buffer.bytes()[offset..offset + count * ty.size()];
    let mut runs = Vec::new();
    let mut start = 0;
    for (at, index) in bytes.chunks_exact(ty.size()).enumerate() {
        if IndexType::index(index) == restart {
            runs.push(start..at);
            start = at + 1;
        }
    }
    runs.push(start..count);
    runs.retain(|run| !run.is_empty());
    runs
}

pub(crate) fn primitive_restart_index(context: &mut Context, index: GLuint) -> Result<()> {
    context.state.restart_index = index;
    Ok(())
}

pub(crate) fn primitive_restart(context: &mut Context) -> Result<()> {
    if !crate::calls::vertex::immediate::restart(context)? {
        return invalid_operation(
            "NV_primitive_restart",
            "must be called between glBegin and glEnd",
        );
    }
    Ok(())
}
