//! Cube maps: through texture generation on many small bodies, and a mirror in a shader.

use super::definition::{Scene, Workload};
use super::geometry::perspective;
use super::mesh::{WHITE, grid, single};
use super::texture::{bricks, pyramid};
use crate::oracle::matrix::Matrix;
use crate::oracle::texture::Level;
use crate::peers::client::{Mesh, Vertex};
use crate::peers::frame::{
    BILINEAR, Draw, FrameDescription, Output, Program, Shading, Step, TRILINEAR, Texture,
};
use std::f64::consts::TAU;

/// The scenes.
#[rustfmt::skip]
pub const SCENES: &[Scene] = &[
    Scene { name: "cube-capsules", what: "12 capsules, a trilinear cube map by texture generation",
        load: Workload::Texture, recipe: |_| capsules() },
    Scene { name: "cube-mirror", what: "a ball that mirrors a bilinear cube map", load: Workload::Texture,
        recipe: |_| mirror() },
];

/// Six different faces, with their levels.
fn faces(side: usize) -> Vec<Vec<Level>> {
    let tints = [
        [255, 160, 120],
        [120, 255, 160],
        [160, 120, 255],
        [255, 255, 90],
        [90, 255, 255],
        [255, 90, 255],
    ];
    let tinted = |tint: [u8; 3]| {
        let mut level = bricks(side);
        for texel in &mut level.texels {
            for (c, tint) in texel.iter_mut().zip(tint) {
                *c = (u16::from(*c) * u16::from(tint) / 255) as u8;
            }
        }
        pyramid(level)
    };
    tints.into_iter().map(tinted).collect()
}

/// A capsule along z, of this radius, whose middle is a cylinder of length 2 `half`.
fn capsule(radius: f64, half: f64) -> Mesh {
    grid(28, 16, |[s, t]| {
        let (sin, cos) = (TAU * s).sin_cos();
        // From pole to pole.
        let (up, out) = (TAU / 2.0 * (t - 0.5)).sin_cos();
        let middle = if t < 0.5 { -half } else { half };
        let position = [radius * out * cos, radius * out * sin, radius * up + middle];
        let light = 0.6 + 0.4 * out * cos;
        Vertex { position: single(position), color: single([light, light, light, 1.0]), ..WHITE }
    })
}

/// Turned by `angle` about x and moved.
fn placed(angle: f64, [x, y, z]: [f64; 3]) -> Matrix {
    let (s, c) = angle.sin_cos();
    [[1.0, 0.0, 0.0, x], [0.0, c, -s, y], [0.0, s, c, z], [0.0, 0.0, 0.0, 1.0]]
}

fn capsules() -> FrameDescription {
    let draw = |k: usize| {
        let [i, j] = [k % 4, k / 4].map(|n| n as f64);
        let size = 1.0 + 0.08 * i + 0.06 * j;
        let at = [(i - 1.5) * 2.0, (j - 1.0) * 2.6, -6.0 - 0.3 * i];
        let draw = Draw::new(capsule(0.7 * size, 0.8 * size), Shading::CubeMapped)
            .model_view(placed(0.9 + 0.41 * k as f64, at))
            .projection(perspective(0.65, 1.0, 20.0))
            .output(Output::DepthTest);
        Step::Draw(draw)
    };
    let steps = std::iter::once(Step::Clear([0.3, 0.5, 0.7, 1.0])).chain((0..12).map(draw));
    FrameDescription {
        textures: vec![Texture::cube(faces(128), TRILINEAR)],
        steps: steps.collect(),
    }
}

static MIRROR: Program = Program {
    fragment: "
uniform samplerCube unit0;
varying vec3 normal;
void main() {
    vec3 r = reflect(vec3(0.0, 0.0, -1.0), normalize(normal));
    gl_FragColor = textureCube(unit0, r) * gl_Color;
}
",
    formula: |f| {
        let length = f.normal.iter().map(|c| c * c).sum::<f64>().sqrt();
        let n = f.normal.map(|c| c / length);
        // r = i - 2 (n · i) n
        let r = [0, 1, 2].map(|c| 2.0 * n[2] * n[c] - if c == 2 { 1.0 } else { 0.0 });
        let texel = (f.cube)(r);
        std::array::from_fn(|c| texel[c] * f.color[c])
    },
};

fn mirror() -> FrameDescription {
    let ball = grid(96, 64, |[s, t]| {
        let (sin, cos) = (TAU * s).sin_cos();
        let (up, out) = (TAU / 2.0 * (t - 0.5)).sin_cos();
        let normal = [out * cos, up, out * sin];
        Vertex { position: single(normal.map(|c| 0.95 * c)), normal: single(normal), ..WHITE }
    });
    let draw = Draw::new(ball, Shading::Program(&MIRROR)).output(Output::DepthTest);
    FrameDescription {
        textures: vec![Texture::cube(faces(256), BILINEAR)],
        steps: vec![Step::Clear([0.3, 0.5, 0.7, 1.0]), Step::Draw(draw)],
    }
}
