//! Draws that only numbers tell apart from the draw before: uniform words, as matrices are, and where vertices
//! come from. What was decided for that one holds for them.

use super::fixed_words::Keys;
use super::repeat::{is_plain, is_whole};
use super::stages;
use super::translate::Elements;
use crate::context::Context;
use rasterizer::driver::{Topology, VertexBinding, VertexSource};

/// What the draw before was decided by.
#[derive(Debug)]
pub(super) struct Decided {
    /// How many calls there had been.
    at: u64,
    topology: Topology,
    /// The attributes that were read from arrays, and how many components of them.
    arrays: Vec<(u8, u8)>,
    keys: Keys,
}

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

fn arrays(vertices: &[VertexBinding]) -> impl Iterator<Item = (u8, u8)> {
    vertices.iter().filter_map(|binding| match binding.source {
        VertexSource::Array { components, .. } => Some((binding.location, components)),
        VertexSource::Constant(_) => None,
    })
}

/// The attributes that a draw reads which is decided as the one before; `None` where it cannot be.
pub(super) fn attributes(context: &Context) -> Option<u64> {
    let told = &context.recorder.told;
    let decided = told.decided.as_ref()?;
    let may_be_alike = context.changes.state <= decided.at && context.compiling.is_none();
    may_be_alike.then(|| told.attributes_read())
}

/// The uniform words of a draw that is decided as the one before; `None` where it may be decided otherwise.
pub(super) fn words(
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
    let words = if is_alike { stages::words(context, &decided.keys) } else { None };
    context.recorder.told.decided = Some(decided);
    words
}
