//! The vertices that 64 invocations of a geometry program emit, each into a strip of its own.

use super::mask::{Mask, blend};
use crate::ir::{GeometryInterface, MAX_GEOMETRY_VERTICES};
use texunit::lanes::{LANES, U32s};

/// Words of a set of an invocation's vertices.
const SET: usize = MAX_GEOMETRY_VERTICES as usize / 64;

/// What is emitted.
#[derive(Debug, Default)]
pub struct Emission {
    /// Scalars of a vertex.
    words: usize,
    /// The most vertices of a lane.
    most: u32,
    /// By vertex and scalar.
    values: Vec<U32s>,
    /// By lane: how many vertices.
    counts: Counts,
    /// By lane: the vertices before which a strip ends.
    ends: Vec<[u64; SET]>,
}

#[derive(Debug)]
struct Counts([u32; LANES]);

impl Default for Counts {
    fn default() -> Self {
        Self([0; LANES])
    }
}

impl Emission {
    /// Makes room for the vertices of a program.
    pub(super) fn begin(&mut self, interface: &GeometryInterface) {
        (self.words, self.most) = (interface.outputs.len(), interface.max_vertices);
        // A run overwrites what it reads again.
        let count = self.words * self.most as usize;
        if self.values.len() < count {
            self.values.resize(count, U32s::ZERO);
        }
    }

    /// Nothing is emitted.
    pub(super) fn clear(&mut self) {
        self.counts.0 = [0; LANES];
        self.ends.clear();
        self.ends.resize(LANES, [0; SET]);
    }

    /// Appends a vertex in the lanes that execute; `word` gives its scalars.
    pub(super) fn emit<'a>(&mut self, exec: &Mask, word: impl Fn(usize) -> &'a U32s) {
        if exec.is_empty() {
            return;
        }
        let (counts, lanes) = (&mut self.counts.0, &exec.lanes);
        let vertex = |count: u32| count as usize * self.words;
        match common(counts, lanes) {
            // Vertices of the same number lie side by side.
            Some(count) if count < self.most => {
                let to = &mut self.values[vertex(count)..][..self.words];
                for (at, to) in to.iter_mut().enumerate() {
                    let (from, old) = (word(at), *to);
                    blend(to, lanes, from, &old);
                }
            }
            Some(_) => return,
            None => {
                for at in 0..self.words {
                    let from = word(at);
                    for lane in 0..LANES {
                        if lanes[lane] != 0 && counts[lane] < self.most {
                            self.values[vertex(counts[lane]) + at][lane] = from[lane];
                        }
                    }
                }
            }
        }
        for lane in 0..LANES {
            counts[lane] = (counts[lane] + (lanes[lane] & 1)).min(self.most);
        }
    }

    /// Ends the strips of the lanes that execute.
    pub(super) fn end_primitive(&mut self, exec: &Mask) {
        if exec.is_empty() {
            return;
        }
        for (lane, ends) in self.ends.iter_mut().enumerate() {
            let count = self.counts.0[lane] as usize;
            if exec.lanes[lane] != 0 && count < 64 * SET {
                ends[count / 64] |= 1 << (count % 64);
            }
        }
    }

    /// How many vertices a lane has emitted.
    pub fn count(&self, lane: usize) -> u32 {
        self.counts.0[lane]
    }

    /// Whether a vertex of a lane begins a strip.
    pub fn begins_strip(&self, lane: usize, vertex: u32) -> bool {
        vertex == 0 || self.ends[lane][vertex as usize / 64] >> (vertex % 64) & 1 != 0
    }

    /// The bits of a scalar of a vertex, in every lane.
    pub fn values(&self, vertex: u32, word: usize) -> &U32s {
        &self.values[vertex as usize * self.words + word]
    }
}

/// The count that all these lanes have, if it is one; of no lanes, 0.
fn common(counts: &[u32; LANES], lanes: &U32s) -> Option<u32> {
    let (mut low, mut high) = (u32::MAX, 0);
    for lane in 0..LANES {
        low = low.min(counts[lane] | !lanes[lane]);
        high = high.max(counts[lane] & lanes[lane]);
    }
    (low >= high).then_some(high)
}
