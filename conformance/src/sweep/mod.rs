//! Extreme cases: sweeps over a parameter up to values where arithmetic loses its precision, each with
//! a stated bound on the error.
//!
//! A sweep measures lines of points: at each value of its parameter the largest error over some
//! cases. It says where arithmetic breaks and what is promised there: where mathematics leaves a result
//! undefined, DetGL defines one. [`judge`] fails a sweep that could show nothing: too few points,
//! too few cases left by its filters, results that do not change with the parameter, or a bound
//! far above what is measured.

mod blend;
mod coverage;
mod definition;
mod depth;
mod drawn;
mod fixed;
mod footprints;
mod functions;
mod interpolation;
mod iterated;
mod judge;
mod lookups;
mod matrix;
mod procedural;
mod series;
mod shaded;
mod stored;
mod texture;
mod vectors;

pub use definition::{Sweep, SweepOutcome};
pub use judge::{FEWEST_POINTS, SLACK};
pub use series::{Point, Series};

/// Every sweep.
pub const SWEEPS: &[Sweep] = &[
    interpolation::W_RATIO,
    interpolation::TILT,
    interpolation::NEAR_PLANE,
    interpolation::FAR_VERTICES,
    coverage::SIZE_OF_TRIANGLES,
    coverage::SLIVERS,
    coverage::ANGLES,
    coverage::NO_NUMBERS,
    coverage::SAMPLES,
    coverage::VIEWPORT,
    texture::REPEAT,
    texture::Q_THROUGH_ZERO,
    texture::ANISOTROPY,
    texture::LAMBDA,
    texture::CUBE_EDGE,
    texture::DENORMALS,
    depth::PRECISION,
    blend::LAYERS,
    matrix::CONDITION,
    vectors::NORMALIZE,
    vectors::LENGTH,
    vectors::DISTANCE,
    vectors::REFLECT,
    vectors::FACEFORWARD,
    vectors::REFRACT,
    functions::MOD,
    functions::FRACT,
    functions::POW,
    functions::HIGHLIGHT,
    functions::EXP2,
    functions::LOG2,
    functions::SMOOTHSTEP,
    functions::MIX,
    functions::ATAN,
    functions::SIN_COS,
    functions::ACOS,
    functions::ROOTS,
    lookups::CUBE_DIRECTIONS,
    lookups::CUBE_TIES,
    lookups::REPEATS,
    lookups::TEXTURE_MATRIX,
    lookups::INFINITE_TEXEL,
    footprints::EXPLICIT,
    footprints::IMPLICIT,
    footprints::BIAS,
    footprints::CLAMPS,
    fixed::THIN_FOG,
    fixed::DENSE_FOG,
    fixed::NORMAL_SCALE,
    fixed::SHININESS,
    depth::REVERSED,
    depth::RANGE,
    depth::OFFSET,
    depth::COPLANAR,
    depth::SHADOW,
    blend::WIDE_LAYERS,
    blend::ACCUMULATION,
    stored::SRGB,
    stored::HALF,
    stored::PACKED,
    stored::SHARED,
    stored::ENERGY,
    procedural::NOISE,
    procedural::TURBULENCE,
    procedural::WOOD,
    procedural::NORMAL_MEAN,
    iterated::DIFFUSION,
    iterated::REACTION,
    iterated::BOUNCES,
];
