//! Which vertices a run of primitives needs, each shaded once where indices allow.

use crate::driver::{Indices, Topology};
use crate::primitive::Primitives;
use std::ops::Range;

/// Where a draw's vertex numbers come from.
pub enum Ids<'a> {
    /// Consecutive, from this one.
    Range(u32),
    /// By indices.
    Indexed(&'a Indices),
}

impl Ids<'_> {
    /// The vertex of an ordinal of the draw.
    pub fn get(&self, ordinal: u32) -> u32 {
        match self {
            Self::Range(first) => first.wrapping_add(ordinal),
            Self::Indexed(indices) => {
                let (size, ordinal) = (indices.ty.size(), ordinal as usize);
                let at = ordinal.checked_mul(size).and_then(|at| at.checked_add(indices.offset));
                let bytes = at.and_then(|at| indices.buffer.bytes().get(at..at.checked_add(size)?));
                let index = bytes.map_or(0, |bytes| {
                    bytes.iter().rev().fold(0, |word, &byte| word << 8 | u32::from(byte))
                });
                index.wrapping_add_signed(indices.base_vertex)
            }
        }
    }
}

/// The ordinals that a range of primitives uses: a run, and vertex 0 for a fan or a closing line.
pub struct Ordinals {
    run: Range<u32>,
    zero: bool,
}

impl Ordinals {
    pub fn iter(&self) -> impl Iterator<Item = u32> {
        self.zero.then_some(0).into_iter().chain(self.run.clone())
    }

    /// Where an ordinal stands in [`Ordinals::iter`].
    fn position(&self, ordinal: u32) -> usize {
        if self.zero && ordinal == 0 {
            0
        } else {
            (ordinal - self.run.start) as usize + usize::from(self.zero)
        }
    }
}

/// The ordinals of the primitives in `range`.
pub fn ordinals(topology: Topology, all: &Primitives, range: &Range<u32>) -> Ordinals {
    let (start, end) = (range.start, range.end);
    let plain = |run| Ordinals { run, zero: false };
    match topology {
        Topology::Points => plain(start..end),
        Topology::Lines => plain(2 * start..2 * end),
        Topology::LineStrip => plain(start..end + 1),
        Topology::LineLoop if end == all.len => Ordinals { run: start..end, zero: true },
        Topology::LineLoop => plain(start..end + 1),
        Topology::Triangles => plain(3 * start..3 * end),
        Topology::TriangleStrip => plain(start..end + 2),
        Topology::TriangleFan | Topology::Polygon => {
            Ordinals { run: start + 1..end + 2, zero: true }
        }
        Topology::Quads => plain(start / 2 * 4..end.div_ceil(2) * 4),
        Topology::QuadStrip => plain(start / 2 * 2..end.div_ceil(2) * 2 + 2),
    }
}

/// The vertices to be shaded, each once where their numbers are dense.
pub struct Unique {
    /// The vertices, if they are a run that the draw's indices point into; else they are as wanted.
    pub ids: Option<Vec<u32>>,
    /// The first of that run.
    first: u32,
}

impl Unique {
    /// The vertices of a chunk's ordinals.
    pub fn of(wanted: &[u32], ids: &Ids<'_>) -> Self {
        if let Ids::Indexed(_) = ids {
            let low = wanted.iter().copied().min().unwrap_or(0);
            let high = wanted.iter().copied().max().unwrap_or(0);
            if (high - low) as usize <= wanted.len() {
                return Self { ids: Some((low..=high).collect()), first: low };
            }
        }
        Self { ids: None, first: 0 }
    }

    /// Where among the shaded ones the vertex of an ordinal is.
    pub fn local(&self, ordinals: &Ordinals, wanted: &[u32], ordinal: u32) -> u32 {
        let at = ordinals.position(ordinal);
        match self.ids {
            Some(_) => wanted[at] - self.first,
            None => at as u32,
        }
    }
}
