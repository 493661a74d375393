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

/// How many instances of so many runs are drawn: all, unless a draw for each run of each instance would not end. The rule is
/// that of the driver for vertices (`docs/shader-compilation.md`): 16 instances are drawn whatever the runs are, for these
/// lie in memory.
pub(crate) fn instances_drawn(instances: u32, runs: usize) -> u32 {
    const HELD_INSTANCES: u32 = 16;
    const MAX_DRAWS: u64 = 1 << 22;
    const DRAWS_OF_ENDLESS: u32 = 1 << 16;
    let draws = u64::from(instances).saturating_mul(runs as u64);
    if runs <= 1 || instances <= HELD_INSTANCES || draws <= MAX_DRAWS {
        return instances;
    }
    (DRAWS_OF_ENDLESS / u32::try_from(runs).unwrap_or(u32::MAX)).max(1)
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
