//! Slices of values by vertex.

/// The rest of a slice with `each` values for every vertex, which is split into batches. (`chunks_mut` has no
/// stride of zero.)
pub struct VertexSlices<'a, T> {
    pub rest: &'a mut [T],
    pub each: usize,
}

impl<'a, T> VertexSlices<'a, T> {
    /// The values of the next `count` vertices.
    pub fn next(&mut self, count: usize) -> &'a mut [T] {
        let (piece, rest) = std::mem::take(&mut self.rest).split_at_mut(count * self.each);
        self.rest = rest;
        piece
    }
}
