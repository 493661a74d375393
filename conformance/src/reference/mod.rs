//! Slow reference samplers in `f64`: what a pixel *should* be, whatever filter a driver has.
//!
//! The lectures ask for the mean of the texture over the pixel's area. [`area`] integrates it
//! exactly, [`supersample`] by N×N points; [`map`] says which point of the texture a point of the
//! picture is, and [`flip`] how different two pictures look.

pub mod area;
pub mod flip;
pub mod map;
pub mod supersample;

/// What lies between the texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reconstruction {
    /// Each texel is a square of its colour.
    Box,
    /// Texels are joined by bilinear interpolation between their centres.
    Bilinear,
}
