//! Draws that only numbers tell apart from the draw before: uniform words, as matrices are, and where vertices
//! come from. What was decided for that one holds for them.

use crate::context::recorder::fixed_words::Keys;
use rasterizer::driver::{Topology, VertexBinding, VertexSource};

/// What the draw before was decided by.
#[derive(Debug)]
pub(crate) struct Decided {
    /// How many calls there had been.
    pub at: u64,
    pub topology: Topology,
    /// The attributes that were read from arrays, and how many components of them.
    pub arrays: Vec<(u8, u8)>,
    pub keys: Keys,
}

impl Decided {}

pub(crate) fn arrays(vertices: &[VertexBinding]) -> impl Iterator<Item = (u8, u8)> {
    vertices.iter().filter_map(|binding| match binding.source {
        VertexSource::Array { components, .. } => Some((binding.location, components)),
        VertexSource::Constant(_) => None,
    })
}
