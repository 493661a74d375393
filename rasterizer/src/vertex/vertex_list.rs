//! Which vertices a run of primitives needs, each shaded once where indices allow.

use super::assemble::Primitives;
use crate::desc::{IndexType, Indices, Topology};
use std::ops::Range;
use texunit::lanes::U32s;

/// The source of the vertex numbers of a draw.
pub enum VertexIds<'a> {
    /// Consecutive, from this one.
    Range(u32),
    /// By indices.
    Indexed(&'a Indices),
}

impl VertexIds<'_> {
    /// The vertices of ordinals of the draw.
    fn of(&self, ordinals: &Ordinals) -> Vec<u32> {
        let mut out = Vec::with_capacity(ordinals.len());
        let parts = [0..u32::from(ordinals.zero), ordinals.run.clone()];
        for part in parts {
            match self {
                Self::Range(first) => out.extend(part.map(|ordinal| first.wrapping_add(ordinal))),
                Self::Indexed(indices) => match indices.ty {
                    IndexType::U8 => read(indices, part, &mut out, |[b]| b.into()),
                    IndexType::U16 => {
                        read(indices, part, &mut out, |b| u16::from_le_bytes(b).into())
                    }
                    IndexType::U32 => read(indices, part, &mut out, u32::from_le_bytes),
                },
            }
        }
        out
    }
}

/// Reads indices of `N` bytes; indices past the end of the buffer are 0.
fn read<const N: usize>(
    indices: &Indices,
    ordinals: Range<u32>,
    out: &mut Vec<u32>,
    convert: impl Fn([u8; N]) -> u32,
) {
    let end = out.len() + ordinals.len();
    let first = (ordinals.start as usize).checked_mul(N);
    let first = first.and_then(|at| at.checked_add(indices.offset));
    let bytes = first.and_then(|first| indices.buffer.bytes().get(first..)).unwrap_or_default();
    let vertex = |index: u32| index.wrapping_add_signed(indices.base_vertex);
    let (stored, _) = bytes.as_chunks::<N>();
    out.extend(stored.iter().take(ordinals.len()).map(|&bytes| vertex(convert(bytes))));
    out.resize(end, vertex(0));
}

/// The ordinals that a range of primitives uses: a run, and vertex 0 for a fan or a closing line.
#[derive(Clone)]
pub struct Ordinals {
    run: Range<u32>,
    zero: bool,
}

impl Ordinals {
    /// How many there are.
    fn len(&self) -> usize {
        self.run.len() + usize::from(self.zero)
    }

    /// The position of an ordinal in the list: vertex 0 first, if it is used, then the run.
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
        Topology::LinesAdjacency => plain(4 * start..4 * end),
        Topology::LineStripAdjacency => plain(start..end + 3),
        Topology::TrianglesAdjacency => plain(6 * start..6 * end),
        Topology::TriangleStripAdjacency => {
            plain((2 * start).saturating_sub(2)..(2 * end + 5).min(2 * all.len + 4))
        }
    }
}

/// The vertices that some primitives need, each once where their numbers are dense.
pub struct VertexList {
    ordinals: Ordinals,
    /// The vertices to be shaded.
    pub ids: Vec<u32>,
    /// By ordinal, its index in `ids`; `None` where `ids` has the order of the ordinals.
    local_indices: Option<Vec<u32>>,
    /// Index of the first shaded vertex of the instance.
    pub base: u32,
}

impl VertexList {
    /// The vertices of ordinals of a draw.
    pub fn new(ordinals: Ordinals, ids: &VertexIds<'_>) -> Self {
        let mut wanted = ids.of(&ordinals);
        if let VertexIds::Indexed(_) = ids {
            let low = wanted.iter().copied().min().unwrap_or(0);
            let high = wanted.iter().copied().max().unwrap_or(0);
            if (high - low) as usize <= wanted.len() {
                wanted.iter_mut().for_each(|id| *id -= low);
                let ids = (low..=high).collect();
                return Self { ordinals, ids, local_indices: Some(wanted), base: 0 };
            }
        }
        Self { ordinals, ids: wanted, local_indices: None, base: 0 }
    }

    /// The vertices of ordinals of a draw, one for each ordinal, even where indices repeat.
    pub fn without_sharing(ordinals: Ordinals, ids: &VertexIds<'_>) -> Self {
        let ids = ids.of(&ordinals);
        Self { ordinals, ids, local_indices: None, base: 0 }
    }

    /// A list of shaded vertices, by ordinal.
    pub fn shaded(local_indices: Vec<u32>) -> Self {
        let ordinals = Ordinals { run: 0..local_indices.len() as u32, zero: false };
        Self { ordinals, ids: Vec::new(), local_indices: Some(local_indices), base: 0 }
    }

    /// The same list for another instance: the shaded vertices of instances are consecutive.
    pub fn of_instance(&self, number: u32) -> Self {
        Self {
            ordinals: self.ordinals.clone(),
            ids: Vec::new(),
            local_indices: self.local_indices.clone(),
            base: self.base + number * self.ids.len() as u32,
        }
    }

    /// The indices of the shaded vertices of `3 · len` ordinals from `first` on, none of which is the vertex 0 of a
    /// fan.
    #[inline]
    pub fn triples(&self, first: u32, out: &mut [U32s; 3], len: usize) {
        let at = self.ordinals.position(first);
        let [a, b, c] = out;
        let lanes = a.0.iter_mut().zip(&mut b.0).zip(&mut c.0).take(len);
        match &self.local_indices {
            Some(local_indices) => {
                let (triples, _) = local_indices[at..].as_chunks::<3>();
                for (((a, b), c), &triple) in lanes.zip(triples) {
                    [*a, *b, *c] = triple.map(|at| at + self.base);
                }
            }
            None => {
                for (((a, b), c), at) in lanes.zip((at as u32 + self.base..).step_by(3)) {
                    [*a, *b, *c] = [at, at + 1, at + 2];
                }
            }
        }
    }

    /// The index of the shaded vertex of an ordinal.
    #[inline]
    pub fn local(&self, ordinal: u32) -> u32 {
        let at = self.ordinals.position(ordinal);
        self.local_indices.as_ref().map_or(at as u32, |local_indices| local_indices[at]) + self.base
    }
}
