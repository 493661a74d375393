//! Primitive restart (`NV_primitive_restart`, GL 3.1): an index that ends a primitive and begins
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
    if !context.state.enables.has(Flag::PrimitiveRestart) {
        return Vec::from([Range { start: 0, end: count }]);
    }
    let bytes = &buffer.bytes()[offset..offset + count * ty.size()];
    let mut runs = Vec::new();
    let mut start = 0;
    for (at, index) in bytes.chunks_exact(ty.size()).enumerate() {
        if is_restart(context, IndexType::index(index)) {
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
