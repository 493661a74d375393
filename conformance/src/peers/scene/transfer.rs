//! Mipmap generation, and the upload and read-back of a picture.

use super::definition::{Scene, Workload};
use super::mesh::WHITE;
use super::texture::bricks;
use crate::oracle::lod::{Filter, Filters, Mipmap};
use crate::oracle::texture::Level;
use crate::peers::client::{Mesh, Vertex};
use crate::peers::frame::{Draw, FrameDescription, NEAREST, Shading, Step, Texture};

/// The scenes.
#[rustfmt::skip]
pub const SCENES: &[Scene] = &[
    Scene { name: "mipmaps", what: "all levels built, then shown", load: Workload::Transfer,
        recipe: mipmaps },
    Scene { name: "upload-read", what: "texels up, a square, pixels down", load: Workload::Transfer,
        recipe: there_and_back },
];

/// Adds a square at window coordinates (x, y) in a picture of `side`, which shows the whole texture.
fn add(mesh: &mut Mesh, side: usize, [x, y]: [usize; 2], size: usize) {
    let first = mesh.vertices.len() as u32;
    for [a, b] in [[0, 0], [1, 0], [1, 1], [0, 1]] {
        let clip = |low: usize, far: usize| ((low + far * size) * 2) as f32 / side as f32 - 1.0;
        mesh.vertices.push(Vertex {
            position: [clip(x, a), clip(y, b), 0.0],
            st: [a as f32, b as f32],
            ..WHITE
        });
    }
    mesh.indices.extend([0, 1, 2, 0, 2, 3].map(|k| first + k));
}

/// Levels 1, 2, … side by side from the lower left on, each texel a pixel.
fn mipmaps(side: usize) -> FrameDescription {
    let texel_by_texel =
        Filters { min: Filter::Nearest, mipmap: Mipmap::Nearest, mag: Filter::Nearest };
    let mut mesh = Mesh::default();
    let (mut x, mut size) = (0, side / 2);
    while size > 0 {
        add(&mut mesh, side, [x, 0], size);
        x += size;
        size /= 2;
    }
    // Level 1 once more above, so that more of the picture shows it.
    add(&mut mesh, side, [0, side / 2], side / 2);
    let draw = Step::Draw(Draw::new(mesh, Shading::Modulate(1)));
    FrameDescription {
        textures: vec![Texture::new(vec![bricks(side)], texel_by_texel)],
        steps: vec![Step::Clear([0.0, 0.0, 0.0, 1.0]), Step::GenerateMipmaps, draw],
    }
}

fn there_and_back(side: usize) -> FrameDescription {
    let mut mesh = Mesh::default();
    add(&mut mesh, side, [0, 0], side);
    let level: Level = bricks(side);
    let draw = Step::Draw(Draw::new(mesh, Shading::Modulate(1)));
    FrameDescription {
        textures: vec![Texture::new(vec![level.clone()], NEAREST)],
        steps: vec![Step::Upload(level), draw, Step::ReadBack],
    }
}
