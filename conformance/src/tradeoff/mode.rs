//! The ways to sample a texture.

use gl_api::constants::*;

/// How the colour of a pixel is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// A filter of GL's: the name, the minification filter and the largest anisotropy.
    Filter(&'static str, u32, u32),
    /// The mean of N×N bilinear samples in a pixel.
    Supersampled(usize),
    /// The integral itself, in `f64`, rounded to bytes.
    ExactArea,
}

impl Mode {
    /// All, the simplest first.
    pub const ALL: [Self; 14] = [
        Self::Filter("nearest", GL_NEAREST, 1),
        Self::Filter("bilinear", GL_LINEAR, 1),
        Self::Filter("nearest-mip-nearest", GL_NEAREST_MIPMAP_NEAREST, 1),
        Self::Filter("linear-mip-nearest", GL_LINEAR_MIPMAP_NEAREST, 1),
        Self::Filter("nearest-mip-linear", GL_NEAREST_MIPMAP_LINEAR, 1),
        Self::Filter("trilinear", GL_LINEAR_MIPMAP_LINEAR, 1),
        Self::Filter("anisotropic-2", GL_LINEAR_MIPMAP_LINEAR, 2),
        Self::Filter("anisotropic-4", GL_LINEAR_MIPMAP_LINEAR, 4),
        Self::Filter("anisotropic-8", GL_LINEAR_MIPMAP_LINEAR, 8),
        Self::Filter("anisotropic-16", GL_LINEAR_MIPMAP_LINEAR, 16),
        Self::Supersampled(2),
        Self::Supersampled(4),
        Self::Supersampled(8),
        Self::ExactArea,
    ];

    /// The name in tables and file names.
    pub fn name(self) -> String {
        match self {
            Self::Filter(name, ..) => name.to_owned(),
            Self::Supersampled(n) => format!("supersampled-{n}x{n}"),
            Self::ExactArea => "exact-area".to_owned(),
        }
    }

    /// The line of the plot that this mode is a point of.
    pub fn family(self) -> &'static str {
        match self {
            Self::Filter("nearest", ..) => "nearest",
            Self::Filter("bilinear", ..) | Self::Supersampled(_) => {
                "bilinear, supersampled 2², 4², 8²"
            }
            Self::Filter(name, ..) if name.starts_with("anisotropic") => {
                "trilinear, anisotropic 2, 4, 8, 16"
            }
            Self::Filter("trilinear", ..) => "trilinear, anisotropic 2, 4, 8, 16",
            Self::Filter(name, ..) => name,
            Self::ExactArea => "exact area (f64)",
        }
    }
}
