//! The scenes: rows of a table, each a recipe for a picture of any size.

mod geometry;
mod mesh;
mod sampling;
mod shaders;
mod shadow;
mod texture;
mod transfer;

use super::recipe::Recipe;
use serde::Serialize;

/// A scene.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    /// For tables and `--only`.
    pub name: &'static str,
    /// In words.
    pub what: &'static str,
    /// What its time goes to.
    pub load: Load,
    /// How to draw it at so many pixels across and up.
    pub recipe: fn(usize) -> Recipe,
}

/// What a scene's time goes to, and so how fast DetGL means to be at it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Load {
    /// Texels.
    Texture,
    /// The texels of an anisotropic filter.
    Anisotropy,
    /// Triangles that are smaller than a block of pixels.
    SmallTriangles,
    /// Arithmetic.
    Shader,
    /// Memory.
    Transfer,
}

impl Load {
    /// How many times as fast as llvmpipe DetGL means to be; none where memory is the limit.
    pub fn goal(self) -> Option<f64> {
        match self {
            Self::Texture => Some(2.0),
            Self::Anisotropy | Self::SmallTriangles => Some(5.0),
            Self::Shader => Some(1.0),
            Self::Transfer => None,
        }
    }
}

/// All scenes, the simplest first.
pub fn scenes() -> impl Iterator<Item = &'static Scene> + Clone {
    [sampling::SCENES, shaders::SCENES, geometry::SCENES, shadow::SCENES, transfer::SCENES]
        .into_iter()
        .flatten()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::peers::render::render;

    const SIDE: usize = 16;

    #[test]
    fn every_scene_covers_the_picture() {
        for scene in scenes() {
            let truth = render(&(scene.recipe)(SIDE), SIDE);
            let counts =
                |k: usize| [k % SIDE, k / SIDE].iter().all(|c| c.is_multiple_of(truth.every));
            let drawn: Vec<_> = (0..SIDE * SIDE).filter(|&k| counts(k)).collect();
            let covered = drawn.iter().all(|&k| truth.pixels[k][3] > 0);
            assert!(covered, "{}", scene.name);
            let varies = drawn.iter().any(|&k| truth.pixels[k] != truth.pixels[0]);
            assert!(varies || scene.name == "clear", "{} is one colour", scene.name);
        }
    }
}
