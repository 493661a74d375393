//! GLSL: a texture, a normal map, a mirroring sphere, wood.

use super::definition::{Scene, Workload};
use super::mesh::{face_on, floor, grid, plane, single, square};
use super::texture::{bricks, bumps, pyramid, surroundings};
use crate::peers::client::Vertex;
use crate::peers::frame::{
    BILINEAR, Draw, Fragment, FrameDescription, Program, Shading, Step, TRILINEAR, Texture,
};
use std::f64::consts::TAU;

/// The scenes.
#[rustfmt::skip]
pub const SCENES: &[Scene] = &[
    Scene { name: "glsl-texture", what: "texture2D times colour", load: Workload::Texture,
        recipe: texture },
    Scene { name: "normal-map", what: "diffuse and specular of a normal map", load: Workload::Shader,
        recipe: normal_map },
    Scene { name: "environment", what: "a mirroring sphere", load: Workload::Shader,
        recipe: environment },
    Scene { name: "wood", what: "rings bent by 5 octaves of noise", load: Workload::Shader,
        recipe: wood },
];

fn texture(side: usize) -> FrameDescription {
    static PROGRAM: Program = Program {
        fragment: "
uniform sampler2D unit0;
void main() { gl_FragColor = texture2D(unit0, gl_TexCoord[0].st) * gl_Color; }
",
        formula: |f| {
            let texel = (f.texture)(0, f.st);
            std::array::from_fn(|c| texel[c] * f.color[c])
        },
    };
    let (mesh, projection) = plane(&floor(side, 1024, 1.0, 60.0));
    FrameDescription {
        textures: vec![Texture::new(pyramid(bricks(1024)), TRILINEAR)],
        steps: vec![Step::Draw(Draw::new(mesh, Shading::Program(&PROGRAM)).projection(projection))],
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = dot(v, v).sqrt();
    v.map(|c| c / length)
}

fn normal_map(side: usize) -> FrameDescription {
    static PROGRAM: Program = Program {
        fragment: "
uniform sampler2D unit0, unit1;
varying vec3 object;
void main() {
    vec3 n = normalize(texture2D(unit1, gl_TexCoord[0].st).xyz * 2.0 - 1.0);
    vec3 l = normalize(vec3(0.5, 0.6, 0.5) - object);
    vec3 e = normalize(vec3(0.0, -0.5, 1.0) - object);
    float diffuse = max(dot(n, l), 0.0);
    float specular = pow(max(dot(n, normalize(l + e)), 0.0), 32.0);
    vec3 color = texture2D(unit0, gl_TexCoord[0].st).rgb;
    gl_FragColor = vec4(color * (0.2 + 0.8 * diffuse) + 0.4 * specular, 1.0);
}
",
        formula: |f| {
            let texel = (f.texture)(1, f.st);
            let n = unit([0, 1, 2].map(|c| texel[c] * 2.0 - 1.0));
            let from = |p: [f64; 3]| unit([0, 1, 2].map(|c| p[c] - f.object[c]));
            let (l, e) = (from([0.5, 0.6, 0.5]), from([0.0, -0.5, 1.0]));
            let diffuse = dot(n, l).max(0.0);
            let half = unit([0, 1, 2].map(|c| l[c] + e[c]));
            let specular = dot(n, half).max(0.0).powi(32);
            let color = (f.texture)(0, f.st);
            let lit = |c: usize| color[c] * (0.2 + 0.8 * diffuse) + 0.4 * specular;
            [lit(0), lit(1), lit(2), 1.0]
        },
    };
    let (mesh, projection) = plane(&floor(side, side, 1.0, 40.0));
    FrameDescription {
        textures: vec![
            Texture::new(pyramid(bricks(512)), TRILINEAR),
            Texture::new(pyramid(bumps(512)), TRILINEAR),
        ],
        steps: vec![Step::Draw(Draw::new(mesh, Shading::Program(&PROGRAM)).projection(projection))],
    }
}

/// The front of a sphere that reaches beyond the picture, seen from 2 units away.
fn environment(_side: usize) -> FrameDescription {
    static PROGRAM: Program = Program {
        fragment: "
uniform sampler2D unit0;
varying vec3 normal;
varying vec3 object;
void main() {
    vec3 r = reflect(normalize(vec3(object.xy, -2.0)), normalize(normal));
    float m = 2.0 * sqrt(r.x * r.x + r.y * r.y + (r.z + 1.0) * (r.z + 1.0));
    gl_FragColor = texture2D(unit0, r.xy / m + 0.5);
}
",
        formula: |f| {
            let (n, i) = (unit(f.normal), unit([f.object[0], f.object[1], -2.0]));
            let r = [0, 1, 2].map(|c| i[c] - 2.0 * dot(n, i) * n[c]);
            let m = 2.0 * (r[0] * r[0] + r[1] * r[1] + (r[2] + 1.0).powi(2)).sqrt();
            (f.texture)(0, [r[0] / m + 0.5, r[1] / m + 0.5])
        },
    };
    const RADIUS: f64 = 1.6;
    let mesh = grid(64, 64, |p| {
        let [x, y] = p.map(|c| 2.1 * c - 1.05);
        let z = (RADIUS * RADIUS - x * x - y * y).sqrt();
        Vertex {
            position: single([x, y, -0.5 * z]),
            normal: single([x, y, z].map(|c| c / RADIUS)),
            ..super::mesh::WHITE
        }
    });
    FrameDescription {
        textures: vec![Texture::new(vec![surroundings(512)], BILINEAR)],
        steps: vec![Step::Draw(Draw::new(mesh, Shading::Program(&PROGRAM)))],
    }
}

fn wood(side: usize) -> FrameDescription {
    static PROGRAM: Program = Program {
        fragment: "
float scramble(float x) { return mod((34.0 * x + 10.0) * x, 289.0); }
float hash(vec2 p) {
    p = mod(p, 289.0);
    return scramble(scramble(p.x) + p.y) / 289.0;
}
float noise(vec2 p) {
    vec2 i = floor(p);
    vec2 f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(hash(i), hash(i + vec2(1.0, 0.0)), f.x),
               mix(hash(i + vec2(0.0, 1.0)), hash(i + vec2(1.0, 1.0)), f.x), f.y);
}
void main() {
    vec2 p = gl_TexCoord[0].st;
    float sum = 0.0;
    float weight = 0.5;
    vec2 q = p * 3.0;
    for (int octave = 0; octave < 5; octave++) {
        sum += weight * noise(q);
        q *= 2.0;
        weight *= 0.5;
    }
    float ring = 0.5 + 0.5 * sin((length(p) * 6.0 + sum) * 6.283185307);
    gl_FragColor = vec4(mix(vec3(0.4, 0.2, 0.07), vec3(0.75, 0.5, 0.25), ring), 1.0);
}
",
        formula: wood_color,
    };
    let mesh = square(&face_on(side, side, [4.0, 4.0]));
    FrameDescription {
        textures: Vec::new(),
        steps: vec![Step::Draw(Draw::new(mesh, Shading::Program(&PROGRAM)))],
    }
}

fn wood_color(f: &Fragment<'_>) -> [f64; 4] {
    let scramble = |x: f64| ((34.0 * x + 10.0) * x).rem_euclid(289.0);
    let hash =
        |x: f64, y: f64| scramble(scramble(x.rem_euclid(289.0)) + y.rem_euclid(289.0)) / 289.0;
    let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
    let noise = |p: [f64; 2]| {
        let [x, y] = p.map(f64::floor);
        let [s, t] = p.map(|c| c - c.floor()).map(|c| c * c * (3.0 - 2.0 * c));
        let row = |y: f64| mix(hash(x, y), hash(x + 1.0, y), s);
        mix(row(y), row(y + 1.0), t)
    };
    let octave = |k: i32| 0.5f64.powi(k + 1) * noise(f.st.map(|c| c * 3.0 * 2f64.powi(k)));
    let sum: f64 = (0..5).map(octave).sum();
    let ring = 0.5 + 0.5 * ((f.st[0].hypot(f.st[1]) * 6.0 + sum) * TAU).sin();
    [mix(0.4, 0.75, ring), mix(0.2, 0.5, ring), mix(0.07, 0.25, ring), 1.0]
}
