//! Draws that only numbers tell apart from the draw before: uniform words, as matrices are, and where vertices
//! come from. What was decided for that one holds for them.

use crate::context::Context;
use crate::context::recorder::again::{Decided, arrays};
use crate::context::recorder::elements::Elements;
use crate::context::recorder::fixed_words::Keys;
use crate::context::recorder::repeat::is_whole;
use crate::draw::repeat::is_plain;
use rasterizer::driver::{Topology, VertexBinding};

impl Decided {
    pub fn new(
        context: &Context,
        topology: Topology,
        vertices: &[VertexBinding],
        keys: Keys,
    ) -> Self {
        Self { at: context.changes.calls, topology, arrays: arrays(vertices).collect(), keys }
    }
}

/// The attributes that a draw reads which is decided as the one before; `None` where it cannot be.
pub(crate) fn attributes(context: &Context) -> Option<u64> {
    let told = &context.recorder.told;
    let decided = told.decided.as_ref()?;
    let may_be_alike = context.changes.state <= decided.at && context.compiling.is_none();
    may_be_alike.then(|| told.attributes_read())
}

/// The uniform words of a draw that is decided as the one before; `None` where it may be decided otherwise.
pub(crate) fn words(
    context: &mut Context,
    topology: Topology,
    vertices: &[VertexBinding],
    elements: &Elements,
) -> Option<Vec<u32>> {
    let decided = context.recorder.told.decided.take()?;
    let is_alike = context.changes.state <= decided.at
        && topology == decided.topology
        // Else there is something to be said.
        && is_whole(topology, elements.counts().0)
        && arrays(vertices).eq(decided.arrays.iter().copied())
        && is_plain(context)
        && !context.queries.discards()
        && !context.recorder.is_full();
    let words = if is_alike { crate::draw::stages::words(context, &decided.keys) } else { None };
    context.recorder.told.decided = Some(decided);
    words
}
