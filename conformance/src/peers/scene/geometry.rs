//! Many small triangles, and a landscape that is lit and fogged.

use super::definition::{Scene, Workload};
use super::mesh::{WHITE, grid, single};
use crate::oracle::matrix::Matrix;
use crate::oracle::vertex::{Light, Surface};
use crate::peers::client::Vertex;
use crate::peers::frame::{Draw, FrameDescription, Lighting, Output, Shading, Step};
use crate::rng::Rng;

/// The scenes.
#[rustfmt::skip]
pub const SCENES: &[Scene] = &[
    Scene { name: "small-triangles", what: "200,000 coloured triangles", load: Workload::SmallTriangles,
        recipe: |_| small_triangles() },
    Scene { name: "lit-fogged-mesh", what: "a landscape of 51,200 triangles, two lights, fog",
        load: Workload::Shader, recipe: |_| landscape() },
];

fn small_triangles() -> FrameDescription {
    let mut rng = Rng::named("small triangles");
    let [columns, rows] = [400, 250];
    let mesh = grid(columns, rows, |[s, t]| {
        let mut jitter = |n: usize| f64::from(rng.real(-0.25, 0.25)) * 2.1 / n as f64;
        let (x, y) = (2.1 * s - 1.05 + jitter(columns), 2.1 * t - 1.05 + jitter(rows));
        let wave = |c: f64| 0.5 + 0.5 * (c * 25.0).sin();
        Vertex {
            position: single([x, y, 0.5 * jitter(4)]),
            color: single([wave(x + y), wave(x - 2.0 * y), wave(x * y), 1.0]),
            ..WHITE
        }
    });
    let draw = Draw::new(mesh, Shading::Modulate(0)).output(Output::DepthTest);
    FrameDescription { textures: Vec::new(), steps: vec![Step::Clear([0.0; 4]), Step::Draw(draw)] }
}

/// Above the ground, looking down at 45°.
pub fn from_above() -> Matrix {
    let c = std::f64::consts::FRAC_1_SQRT_2;
    [[1.0, 0.0, 0.0, 0.0], [0.0, c, c, -1.0], [0.0, -c, c, -2.2], [0.0, 0.0, 0.0, 1.0]]
}

/// A perspective whose half height at distance 1 is `half`.
pub fn perspective(half: f64, near: f64, far: f64) -> Matrix {
    let depth = near - far;
    [
        [1.0 / half, 0.0, 0.0, 0.0],
        [0.0, 1.0 / half, 0.0, 0.0],
        [0.0, 0.0, (near + far) / depth, 2.0 * near * far / depth],
        [0.0, 0.0, -1.0, 0.0],
    ]
}

static LIGHTS: [Light; 2] = [
    light([0.9, 0.85, 0.7, 1.0], [0.4, 0.8, 0.5, 0.0]),
    light([0.2, 0.3, 0.5, 1.0], [-1.5, 0.5, 0.0, 1.0]),
];

const fn light(color: [f64; 4], position: [f64; 4]) -> Light {
    Light {
        ambient: [0.0, 0.0, 0.0, 1.0],
        diffuse: color,
        specular: color,
        position,
        spot_direction: [0.0, 0.0, -1.0],
        spot_exponent: 0.0,
        spot_cutoff: 180.0,
        attenuation: [1.0, 0.0, 0.0],
    }
}

static LIGHTING: Lighting = Lighting {
    lights: &LIGHTS,
    surface: Surface {
        ambient: [0.3, 0.4, 0.2, 1.0],
        diffuse: [0.5, 0.7, 0.3, 1.0],
        specular: [0.4, 0.4, 0.4, 1.0],
        emission: [0.0, 0.0, 0.0, 1.0],
        shininess: 20.0,
        scene_ambient: [0.3, 0.3, 0.3, 1.0],
        local_viewer: false,
    },
    density: 0.22,
    fog: [0.7, 0.75, 0.85, 1.0],
};

fn landscape() -> FrameDescription {
    let mesh = grid(160, 160, |[s, t]| {
        let [x, y] = [(s - 0.5) * 8.0, t * 6.0 - 0.5];
        let (a, b) = (3.0 * x + y, 2.0 * y - x);
        let height = 0.05 * (a.sin() + b.cos());
        let by_x = 0.05 * (3.0 * a.cos() + b.sin());
        let by_y = 0.05 * (a.cos() - 2.0 * b.sin());
        Vertex { position: single([x, y, height]), normal: single([-by_x, -by_y, 1.0]), ..WHITE }
    });
    let draw = Draw::new(mesh, Shading::Lit(&LIGHTING))
        .model_view(from_above())
        .projection(perspective(0.4, 0.5, 20.0))
        .output(Output::DepthTest);
    FrameDescription { textures: Vec::new(), steps: vec![Step::Clear([0.0; 4]), Step::Draw(draw)] }
}
