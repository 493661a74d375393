//! The definition of a scene.

use crate::peers::frame::FrameDescription;
use serde::Serialize;

/// A scene.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    /// The name in tables and for `--only`.
    pub name: &'static str,
    /// A description.
    pub what: &'static str,
    /// The work that takes most of its time.
    pub load: Workload,
    /// The frame, for a width and height in pixels.
    pub recipe: fn(usize) -> FrameDescription,
}

/// The work that takes most of a scene's time, which determines DetGL's performance goal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Workload {
    /// Texture sampling.
    Texture,
    /// Anisotropic texture sampling.
    Anisotropy,
    /// Triangles that are smaller than a block of pixels.
    SmallTriangles,
    /// Arithmetic of shaders.
    Shader,
    /// Programs over a whole picture, with many lookups and transcendental functions.
    Filter,
    /// Memory transfer.
    Transfer,
}

impl Workload {
    /// DetGL's performance goal: its speed as a multiple of llvmpipe's. `None` where memory is the limit.
    pub fn goal(self) -> Option<f64> {
        match self {
            Self::Texture => Some(2.0),
            Self::Anisotropy | Self::SmallTriangles => Some(5.0),
            Self::Shader => Some(1.0),
            Self::Filter => Some(1.7),
            Self::Transfer => None,
        }
    }
}
