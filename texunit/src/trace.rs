//! The record of how one lane was sampled: plain data.
//!
//! [`SamplePlan::trace`](crate::plan::SamplePlan::trace) runs the general kernel with a recorder. Sampling runs the same
//! code without one, so a trace cannot differ from what was drawn.

use crate::sampler::{Compare, Filter};

/// A step of a sample, in the order of GL 2.1, section 3.8. Levels count from the base level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SampleStep {
    /// The face that a direction meets, and where on it (section 3.8.6, table 3.19).
    Face {
        /// 0 to 5: +X, -X, +Y, -Y, +Z, -Z.
        face: u32,
        /// `s`, `t` on the face, 0 to 1.
        st: [f32; 2],
    },
    /// The layer of an array texture: the nearest, held in range.
    Layer(u32),
    /// λ has no effect.
    Fixed {
        /// The filter of every sample.
        filter: Filter,
        /// The level of every sample.
        level: u32,
        /// Why λ is not computed.
        why: &'static str,
    },
    /// The derivatives of `s, t, r` in units of the coordinate; on a cube, of those on the face.
    Derivatives {
        /// `∂(s, t, r)/∂x`; 0 beyond the axes that the shape has.
        dx: [f32; 3],
        /// `∂(s, t, r)/∂y`.
        dy: [f32; 3],
        /// Texels of the base level per unit of each coordinate.
        scale: [f32; 3],
    },
    /// An isotropic footprint (equation 3.20): `ρ² = max(|∂u/∂x|², |∂u/∂y|²)`, `λ = log2 ρ`.
    Isotropic {
        /// ρ².
        rho_squared: f32,
        /// λ before the bias.
        lambda: f32,
    },
    /// An anisotropic footprint (EXT_texture_filter_anisotropic).
    Anisotropic {
        /// The square of the longer axis, in texels.
        major_squared: f32,
        /// The square of the shorter axis.
        minor_squared: f32,
        /// How many probes lie along the longer axis.
        probes: u32,
        /// From one probe to the next, in units of the coordinate.
        step: [f32; 3],
        /// λ of each probe before the bias.
        lambda: f32,
    },
    /// An anisotropic footprint that is read row by row, or column by column
    /// (EXT_texture_filter_anisotropic).
    Scan {
        /// The square of the longer axis, in texels.
        major_squared: f32,
        /// The square of the shorter axis.
        minor_squared: f32,
        /// The axis along which one texel follows the other: 0 for s (columns), 1 for t (rows).
        along: usize,
        /// Texels across per texel along.
        slope: f32,
        /// λ before the bias.
        lambda: f32,
    },
    /// λ as the shader gave it.
    Explicit(f32),
    /// The bias added and the result held in the sampler's range (equations 3.18 and 3.19).
    Lambda {
        /// Before.
        base: f32,
        /// The bias of sampler and unit.
        bias: f32,
        /// The shader's.
        shader_bias: f32,
        /// `TEXTURE_MIN_LOD`, `TEXTURE_MAX_LOD`.
        range: [f32; 2],
        /// After.
        lambda: f32,
    },
    /// What λ chooses (section 3.8.8, equation 3.25; section 3.8.9).
    Levels {
        /// Up to this λ the sample is magnified (`c`).
        magnified_to: f32,
        /// The filter.
        filter: Filter,
        /// The level, and the second where two are mixed.
        levels: [u32; 2],
        /// The weight of the second.
        weight: f32,
    },
    /// A probe of an anisotropic footprint begins.
    Probe {
        /// Which, from 0 on.
        number: u32,
        /// Of how many.
        of: u32,
        /// Its `s, t, r`.
        at: [f32; 3],
    },
    /// One level begins.
    Level {
        /// The face, of a cube.
        face: u32,
        /// Which.
        level: u32,
        /// Its width, height and depth.
        size: [u32; 3],
        /// The filter on it.
        filter: Filter,
    },
    /// The rows or columns of a level, which come next.
    Rows {
        /// How many there are.
        rows: u32,
        /// How much of them lies within the footprint, in texels.
        length: f32,
    },
    /// A row or column, whose two texels come next.
    Row {
        /// Which, from 0 on.
        number: u32,
        /// The weights of its texels in the level's mean.
        weights: [f32; 2],
    },
    /// A texel that is read (section 3.8.8).
    Texel {
        /// Of which face.
        face: u32,
        /// Its column, row and slice among the stored ones, the border's included.
        at: [u32; 3],
        /// What stands for it.
        source: TexelSource,
        /// Its stored channels.
        value: [f32; 4],
        /// The comparison (section 3.8.14): operator, reference, and 1 or 0.
        compare: Option<(Compare, f32, f32)>,
    },
    /// The coordinate in texels, wrapped, of a nearest filter: the texel is its floor.
    Nearest {
        /// `u, v, w`.
        u: [f32; 3],
    },
    /// The coordinates in texels, wrapped, of a linear filter, whose texels come next
    /// (equation 3.24): for each slice and row the lower and the upper.
    Linear {
        /// `u, v, w`.
        u: [f32; 3],
        /// `α, β, γ`: the fractions of `u - 1/2, v - 1/2, w - 1/2`.
        weights: [f32; 3],
        /// Along how many axes.
        axes: usize,
    },
    /// What the level gives, in stored channels.
    Filtered([f32; 4]),
    /// Two levels mixed: `a + (b - a) · weight` (equation 3.27).
    Mixed([f32; 4]),
    /// The mean of the probes up to this one.
    Mean([f32; 4]),
}

/// What stands for a texel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TexelSource {
    /// The texel itself.
    Stored,
    /// The border colour, as it lies outside (section 3.8.7).
    Border,
    /// Beyond the corner of a cube there is none: the mean of the other three stands for it
    /// (ARB_seamless_cube_map).
    Corner,
}

/// How one lane was sampled.
#[derive(Clone, Debug, PartialEq)]
pub struct SampleTrace {
    /// The coordinates.
    pub coords: [f32; 3],
    /// In order.
    pub steps: Vec<SampleStep>,
    /// Red, green, blue, alpha as the sample gives them: expanded from the stored channels
    /// (section 3.8.13), swizzled. Of integer textures bits.
    pub result: [f32; 4],
}
