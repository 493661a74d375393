//! Texture slots and texture accesses.

use super::types::{Texture, Ty, Value};

/// The kind of texture that a slot takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TextureDecl {
    /// The shape of the coordinates.
    pub shape: texunit::image::Shape,
    /// Whether samples are compared against a reference (`sampler2DShadow`).
    pub compare: bool,
    /// The type of the components of a sample: `f32`, or the integers of an integer texture (`isampler2D`: `i32`,
    /// `usampler2D`: `u32`). The samples of a texture of another type are its bits.
    pub texels: Ty,
}

impl TextureDecl {
    /// A slot for textures that do not compare and have colours, not integers.
    pub const fn color(shape: texunit::image::Shape) -> Self {
        Self { shape, compare: false, texels: Ty::F32 }
    }
}

/// The level of detail of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Lod {
    /// From the quad's differences, plus a bias. In the vertex stage: the base level plus the bias.
    Implicit {
        /// Added to λ before the clamp.
        bias: Option<Value>,
    },
    /// This λ.
    Explicit(Value),
    /// From the derivatives of the shape's coordinates, plus a bias.
    Gradient {
        /// `∂(s, t, r)/∂x`.
        dx: [Value; 3],
        /// `∂(s, t, r)/∂y`.
        dy: [Value; 3],
        /// Added to λ before the clamp.
        bias: Option<Value>,
    },
}

/// The operation of a texture access (GLSL 1.30, section 8.7).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Access {
    /// `texture` and its kin, with texels added to the coordinates on each level.
    Filter {
        /// Along s, t, r.
        offset: [i32; 3],
    },
    /// `textureGather`: the first component of each of the four texels that a linear filter of the base level would weigh,
    /// of textures with two axes. Its λ is implicit, without a bias, and does not matter. No compare.
    Gather {
        /// Texels added along s, t.
        offset: [i32; 2],
    },
    /// `texelFetch`: coordinates and the level (an explicit λ) are `i32`. No compare.
    Fetch {
        /// Added to the coordinates.
        offset: [i32; 3],
    },
    /// `textureSize`: width, height and depth (or layers, after the sides that are filtered along)
    /// of a level (an explicit λ, `i32`), and the number of levels (`textureQueryLevels`), as `i32`. Coordinates do not
    /// matter. No compare.
    Size,
    /// `textureQueryLOD` of the fragment stage: the level that a lookup without explicit λ reads,
    /// with a fraction where it mixes two, and λ before it is held in the sampler's range, as `f32`.
    /// No compare.
    Lod,
}

impl Access {
    /// A filtered sample without offset.
    pub const FILTER: Self = Self::Filter { offset: [0; 3] };
}

/// One texture access.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Sample {
    /// Which texture.
    pub texture: Texture,
    /// The operation.
    pub access: Access,
    /// s, t, r; coordinates that the shape lacks are a constant zero.
    pub coords: [Value; 3],
    /// The layer of an array of cubes, whose coordinates are a direction.
    pub layer: Option<Value>,
    /// The reference for depth compare, when the slot compares.
    pub reference: Option<Value>,
    /// The source of the level of detail.
    pub lod: Lod,
}
