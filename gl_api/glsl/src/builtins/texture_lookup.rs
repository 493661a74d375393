//! What a texture lookup function does, as its name says (GLSL 1.30 section 8.7).

/// Where a lookup's level of detail comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LodSource {
    /// From the derivatives within the quad: `texture`.
    Implicit,
    /// From the quad, and the last argument is added: `texture` with a bias.
    Bias,
    /// From an argument: `textureLod`.
    Explicit,
    /// From two arguments, the derivatives: `textureGrad`.
    Gradient,
}

/// Whether the coordinates are divided by their last component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Projection {
    /// No.
    None,
    /// Yes: `textureProj`.
    Divide,
}

/// Whether an argument shifts the texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TexelOffset {
    /// No.
    None,
    /// By a constant number of texels: `textureOffset`.
    Constant,
}

/// A texture lookup.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lookup {
    /// A filtered sample.
    Sample(Projection, LodSource, TexelOffset),
    /// One component of four texels: `textureGather`.
    Gather(TexelOffset),
    /// One texel: `texelFetch`.
    Fetch(TexelOffset),
    /// The size of a level: `textureSize`.
    Size,
    /// How many levels there are: `textureQueryLevels`.
    QueryLevels,
    /// Which level would be sampled: `textureQueryLOD`.
    QueryLod,
}
