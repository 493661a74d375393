//! Samplers: the textures they take and the texels they give (GLSL 1.30 section 4.1.7).

use super::Scalar;

/// The shape of the textures that a sampler takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Dim {
    /// `sampler1D`.
    D1,
    /// `sampler2D`.
    D2,
    /// `sampler3D`.
    D3,
    /// `samplerCube`.
    Cube,
    /// `sampler2DRect`.
    Rect,
    /// `sampler1DArray`.
    D1Array,
    /// `sampler2DArray`.
    D2Array,
    /// `samplerCubeArray`.
    CubeArray,
    /// `sampler2DMS`.
    D2Multisample,
    /// `sampler2DMSArray`.
    D2MultisampleArray,
    /// `samplerBuffer`.
    Buffer,
    /// `samplerExternalOES`.
    External,
}

impl Dim {
    /// The number of coordinates of a texel, with the layer.
    pub fn coords(self) -> usize {
        match self {
            Self::D1 | Self::Buffer => 1,
            Self::D2 | Self::Rect | Self::D1Array | Self::D2Multisample | Self::External => 2,
            Self::D3 | Self::Cube | Self::D2Array | Self::D2MultisampleArray => 3,
            Self::CubeArray => 4,
        }
    }
}

/// Whether a sampler compares with a reference (`sampler2DShadow`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Comparison {
    /// It gives the texel.
    No,
    /// It gives the result of the comparison.
    Yes,
}

/// A sampler type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sampler {
    /// The shape of its textures.
    pub dim: Dim,
    /// The scalar type of their texels.
    pub scalar: Scalar,
    /// Whether it compares.
    pub comparison: Comparison,
}

/// The result of a lookup that compares with a depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ComparisonResult {
    /// Four components as `GL_DEPTH_TEXTURE_MODE` arranges them: functions such as `shadow2D`.
    DepthTextureMode,
    /// One number, whatever the mode is: the functions of GLSL 1.30.
    Scalar,
    /// No comparison, whatever the sampler state is: assembly programs without `SHADOW` targets.
    Ignored,
}
