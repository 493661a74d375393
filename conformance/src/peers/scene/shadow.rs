//! A shadow map: the light's depths first, then the picture.

use super::definition::{Scene, Workload};
use super::geometry::{from_above, perspective};
use super::mesh::{WHITE, grid, single};
use crate::oracle::matrix::{self, Matrix};
use crate::peers::client::{Mesh, Vertex};
use crate::peers::frame::{
    Draw, FrameDescription, NEAREST, Output, Program, Shading, Step, Texels, Texture,
};

/// The scenes.
#[rustfmt::skip]
pub const SCENES: &[Scene] = &[
    Scene { name: "shadow-map", what: "plates above a floor, out of the picture",
        load: Workload::Texture, recipe: |_| shadow_map() },
];

static PROGRAM: Program = Program {
    fragment: "
uniform sampler2DShadow unit0;
varying vec3 object;
void main() {
    vec3 seen = (gl_TextureMatrix[0] * vec4(object, 1.0)).xyz;
    float lit = shadow2D(unit0, seen).r;
    gl_FragColor = vec4(gl_Color.rgb * (0.3 + 0.7 * lit), 1.0);
}
",
    formula: |f| {
        let [x, y, z] = f.object;
        let [s, t, r, _] = matrix::apply(&f.texture_matrix, [x, y, z, 1.0]);
        let lit = (f.shadow)([s, t, r]);
        let shaded = |c: usize| f.color[c] * (0.3 + 0.7 * lit);
        [shaded(0), shaded(1), shaded(2), 1.0]
    },
};

/// The light's projection: a parallel projection along (-0.2, 0.1, -1), 11 units wide.
fn light() -> Matrix {
    let scale = 1.0 / 5.5;
    [
        [scale, 0.0, -0.2 * scale, 0.013],
        [0.0, scale, 0.1 * scale, -0.31],
        [0.0, 0.0, -0.25, 0.3],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

/// From the light's clip coordinates to texture coordinates and depth, with an offset towards the
/// light, so that the floor is not in its own shadow.
fn biased(m: &Matrix) -> Matrix {
    let row = |r: usize, offset: f64| -> [f64; 4] {
        std::array::from_fn(|c| 0.5 * m[r][c] + (0.5 + offset) * m[3][c])
    };
    [row(0, 0.0), row(1, 0.0), row(2, -0.002), m[3]]
}

fn shadow_map() -> FrameDescription {
    let floor = grid(16, 16, |[s, t]| Vertex {
        position: single([(s - 0.5) * 8.0, t * 6.0 - 0.5, 0.0]),
        color: single([0.5 + 0.5 * s, 0.6 + 0.3 * t, 0.7 - 0.4 * s * t, 1.0]),
        ..WHITE
    });
    let mut casters = floor.clone();
    for k in 0..24 {
        let [i, j] = [k % 6, k / 6].map(f64::from);
        // Above the eye, which looks down: only their shadows are visible.
        plate(&mut casters, [i * 1.2 - 3.6 + 0.3 * j, j * 1.4 - 0.2, 3.0], 0.3 + 0.02 * i);
    }
    let light = light();
    let draw = Draw::new(floor, Shading::Program(&PROGRAM))
        .model_view(from_above())
        .projection(perspective(0.4, 0.5, 20.0))
        .texture_matrix(biased(&light))
        .output(Output::DepthTest);
    let caster =
        Draw::new(casters, Shading::Modulate(0)).projection(light).output(Output::DepthTest);
    FrameDescription {
        textures: vec![Texture { texels: Texels::ShadowMap, filters: NEAREST, anisotropy: 1.0 }],
        steps: vec![Step::ShadowMap(caster), Step::Clear([0.0; 4]), Step::Draw(draw)],
    }
}

/// Adds a square, turned by 33°.
fn plate(mesh: &mut Mesh, [x, y, z]: [f64; 3], half: f64) {
    let first = mesh.vertices.len() as u32;
    let (sin, cos) = 33f64.to_radians().sin_cos();
    for [a, b] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
        let (dx, dy) = (half * (cos * a - sin * b), half * (sin * a + cos * b));
        mesh.vertices.push(Vertex { position: single([x + dx, y + dy, z]), ..WHITE });
    }
    mesh.indices.extend([0, 1, 2, 0, 2, 3].map(|k| first + k));
}
