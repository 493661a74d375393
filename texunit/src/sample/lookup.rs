//! The arguments of a lookup: points, and the source of the level of detail.

use crate::lanes::F32s;

/// The source of a batch's level of detail.
#[derive(Clone, Copy, Debug)]
pub enum Lod<'a> {
    /// From the differences within each quad of the batch (quad-planar lane order), plus a bias.
    Implicit {
        /// Per lane, added to λ before the clamp.
        bias: Option<&'a F32s>,
    },
    /// This λ, to which the sampler's bias is added.
    Explicit(&'a F32s),
    /// From these derivatives of s, t, r, plus a bias.
    Gradient {
        /// `∂(s, t, r)/∂x`.
        dx: [&'a F32s; 3],
        /// `∂(s, t, r)/∂y`.
        dy: [&'a F32s; 3],
        /// As of [`Lod::Implicit`].
        bias: Option<&'a F32s>,
    },
}

/// The points that 64 lanes sample. Any bits are legal in any lane; NaN counts as 0.
#[derive(Clone, Copy, Debug)]
pub struct Points<'a> {
    /// s, t, r, of which those that the shape has are read: the one after those that are filtered
    /// along is the layer of an array.
    pub coords: [&'a F32s; 3],
    /// The layer of an array of cubes, whose coordinates are a direction; layer 0 where there is
    /// none.
    pub layer: Option<&'a F32s>,
    /// The reference of a depth compare; `None` uses r.
    pub reference: Option<&'a F32s>,
}
