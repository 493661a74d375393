//! Extreme cases: sweeps over a parameter up to values where arithmetic loses its precision, each with
//! a stated bound on the error.
//!
//! A sweep measures lines of (parameter, error). Where mathematics leaves a result undefined, DetGL
//! defines one, and the sweep's description states it.

mod blend;
mod coverage;
mod definition;
mod depth;
mod interpolation;
mod matrix;
mod texture;

pub use definition::{Sweep, SweepOutcome};

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
    texture::REPEAT,
    texture::Q_THROUGH_ZERO,
    texture::ANISOTROPY,
    texture::LAMBDA,
    texture::CUBE_EDGE,
    texture::DENORMALS,
    depth::PRECISION,
    blend::LAYERS,
    matrix::CONDITION,
];
