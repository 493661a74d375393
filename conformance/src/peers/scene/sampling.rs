//! Clear, and textures through the fixed function: every filter face on and in perspective, two
//! units, layers.

use super::definition::{Scene, Workload};
use super::mesh::{face_on, floor, plane, square};
use super::texture::{bricks, light, pyramid, veil};
use crate::oracle::lod::Filters;
use crate::peers::frame::{
    BILINEAR, Draw, FrameDescription, NEAREST, Output, Shading, Step, TRILINEAR, Texture,
};
use crate::reference::map::Homography;

/// Texels across and up of every texture here.
const TEXELS: usize = 1024;

/// The scenes.
#[rustfmt::skip]
pub const SCENES: &[Scene] = &[
    Scene { name: "clear", what: "colour and depth, cleared", load: Workload::Transfer,
        recipe: |_| FrameDescription { textures: Vec::new(), steps: vec![Step::Clear([0.2, 0.4, 0.6, 1.0])] } },
    Scene { name: "nearest", what: "0.7 texels a pixel", load: Workload::Texture,
        recipe: |side| facing(NEAREST, 1.0, face_on(side, TEXELS, [0.7, 0.7])) },
    Scene { name: "nearest-floor", what: "a floor at 70°", load: Workload::Texture,
        recipe: |side| tilted(NEAREST, 1.0, floor(side, TEXELS, 0.7, 70.0)) },
    Scene { name: "bilinear", what: "0.7 texels a pixel", load: Workload::Texture,
        recipe: |side| facing(BILINEAR, 1.0, face_on(side, TEXELS, [0.7, 0.7])) },
    Scene { name: "bilinear-floor", what: "a floor at 70°", load: Workload::Texture,
        recipe: |side| tilted(BILINEAR, 1.0, floor(side, TEXELS, 0.7, 70.0)) },
    Scene { name: "trilinear", what: "1.7 texels a pixel", load: Workload::Texture,
        recipe: |side| facing(TRILINEAR, 1.0, face_on(side, TEXELS, [1.7, 1.7])) },
    Scene { name: "trilinear-floor", what: "a floor at 70°", load: Workload::Texture,
        recipe: |side| tilted(TRILINEAR, 1.0, floor(side, TEXELS, 1.0, 70.0)) },
    Scene { name: "anisotropic", what: "16×, stretched 8:1", load: Workload::Anisotropy,
        recipe: |side| facing(TRILINEAR, 16.0, face_on(side, TEXELS, [1.2, 9.6])) },
    Scene { name: "anisotropic-floor", what: "16×, a floor at 80°", load: Workload::Anisotropy,
        recipe: |side| tilted(TRILINEAR, 16.0, floor(side, TEXELS, 1.0, 80.0)) },
    Scene { name: "two-units", what: "trilinear times bilinear", load: Workload::Texture,
        recipe: two_units },
    Scene { name: "eight-layers", what: "8 bilinear layers, blended", load: Workload::Texture,
        recipe: layers },
];

fn facing(filters: Filters, anisotropy: f64, map: Homography) -> FrameDescription {
    FrameDescription {
        textures: vec![Texture::new(pyramid(bricks(TEXELS)), filters).anisotropic(anisotropy)],
        steps: vec![Step::Draw(Draw::new(square(&map), Shading::Modulate(1)))],
    }
}

fn tilted(filters: Filters, anisotropy: f64, map: Homography) -> FrameDescription {
    let (mesh, projection) = plane(&map);
    let draw = Draw::new(mesh, Shading::Modulate(1)).projection(projection);
    FrameDescription {
        textures: vec![Texture::new(pyramid(bricks(TEXELS)), filters).anisotropic(anisotropy)],
        steps: vec![Step::Draw(draw)],
    }
}

fn two_units(side: usize) -> FrameDescription {
    let (mesh, projection) = plane(&floor(side, TEXELS, 1.0, 50.0));
    let draw = Draw::new(mesh, Shading::Modulate(2)).projection(projection);
    FrameDescription {
        textures: vec![
            Texture::new(pyramid(bricks(TEXELS)), TRILINEAR),
            Texture::new(vec![light(128)], BILINEAR),
        ],
        steps: vec![Step::Draw(draw)],
    }
}

fn layers(side: usize) -> FrameDescription {
    let layer = |k: usize| {
        let scale = 0.25 + 0.11 * k as f64;
        let mesh = square(&face_on(side, TEXELS, [scale, scale]));
        Step::Draw(Draw::new(mesh, Shading::Modulate(1)).output(Output::Blend))
    };
    FrameDescription {
        textures: vec![Texture::new(vec![veil(TEXELS)], BILINEAR)],
        steps: std::iter::once(Step::Clear([0.1, 0.1, 0.2, 1.0]))
            .chain((0..8).map(layer))
            .collect(),
    }
}
