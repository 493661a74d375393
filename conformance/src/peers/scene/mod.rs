//! The scenes: rows of a table, each with the frame for any size.

mod cube;
mod definition;
mod filters;
mod geometry;
mod mesh;
mod sampling;
mod shaders;
mod shadow;
mod texture;
mod transfer;

pub use definition::{Scene, Workload};

/// All scenes, the simplest first.
pub fn scenes() -> impl Iterator<Item = &'static Scene> + Clone {
    [
        sampling::SCENES,
        shaders::SCENES,
        filters::SCENES,
        geometry::SCENES,
        cube::SCENES,
        shadow::SCENES,
        transfer::SCENES,
    ]
    .into_iter()
    .flatten()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::peers::reference::render;

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
