//! The anisotropic filter of two-dimensional images: a scan over the rows of the footprint.
//!
//! EXT_texture_filter_anisotropic leaves the scheme open. Its usual one, several filtered samples
//! in a row, reads most texels twice and more. This one walks the rows that the footprint crosses
//! (columns, if its major axis is closer to s) and takes from each one pair of neighbours, so that
//! every texel is read once and the sum along the footprint is the exact one of whole texels.
//!
//! With the derivatives in texels of the base level, the footprint has the second moments
//! `C = J·Jᵀ` (over 12), of eigenvalues `σ₁² ≥ σ₂²`. A sample is filtered for a width of
//! `m² = max(σ₂², σ₁²/A²)`, where `A` is `TEXTURE_MAX_ANISOTROPY`; what the footprint is longer than
//! wide, `κ (C - σ₂² I)` with `κ = (σ₁² - m²) / (σ₁² - σ₂²)`, the rows make up for. With the moments
//! `a²` of that along the axis with the larger one, and `c` between both axes:
//!
//! A round footprint is filtered as by the isotropic filter ([`round_lanes`]). Of others:
//!
//! - *Length.* On a level whose texels are `x` of the base's, `L = √(1 + a²/x²)` rows, at most
//!   [`fixed_point::MAX_ROWS`], each weighted by how much of it lies within `L/2` of the sample. Towards
//!   round footprints `L` becomes 1, and these weights those of a bilinear filter.
//! - *Slope.* From row to row the position moves by `c / (max(m², 1) + a²)`.
//! - *Across.* The two texels around the position weigh `1 - w` and `w` with `w = b + (1 - 2b)·α` of the
//!   place's fraction `α`: `b = 7/16 slope² min(m², 1)` evens the weights out where the rows are
//!   crossed at an angle, as the pair is then narrower, measured across the footprint, than a pair
//!   of a level should be. (Where pixels are nearer to one another than texels, no step may show.)
//! - *Level.* `λ = ½ log2(m² + ε (1 - 9/16 m²))` with the elongation `ε = 1 - m²/σ₁²`: a pair of
//!   texels is as wide as 3/2 of them, so a long footprint takes levels a little finer than a round
//!   one, for which `λ = log2 σ₁`.
//!
//! `conformance/src/oracle/anisotropy.rs` has the same in `f64`. Addresses and weights are integers
//! ([`rows`]), and of formats of bytes so are the sums: exact, whatever the order.

mod fixed_point;
mod footprint;
mod level;
mod round;
mod rows;

pub use footprint::{LaneFootprint, RowScan, footprint};
pub use level::level;
pub use round::{is_round, round_lanes};
