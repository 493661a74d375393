//! Slow reference samplers in `f64`: the colour that a pixel should have, independent of the filters of GL.
//!
//! The lectures ask for the mean of the texture over the pixel's area. [`area`] integrates it
//! exactly, [`supersample`] by N×N points; [`map`] maps points of the picture to points of the
//! texture, and [`flip`] measures how different two pictures look.

pub mod area;
pub mod flip;
pub mod map;
pub mod supersample;

/// How a continuous image is reconstructed from texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reconstruction {
    /// Each texel is a square of its colour.
    Box,
    /// Texels are joined by bilinear interpolation between their centres.
    Bilinear,
}
