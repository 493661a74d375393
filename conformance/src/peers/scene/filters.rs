//! Filters as emulators, players and games run them over a whole picture: one fragment program each, many lookups at
//! computed coordinates, many transcendental functions, loops.

/// `texel` in GLSL.
macro_rules! with_texels {
    ($body:literal) => {
        concat!(
            "
uniform sampler2D unit0;
vec3 texel(float x, float y) {
    vec2 cell = floor(gl_TexCoord[0].st * 256.0);
    return texture2D(unit0, (cell + vec2(x + 0.5, y + 0.5)) / 256.0).rgb;
}
",
            $body
        )
    };
}

mod display;
mod taps;

use super::definition::{Scene, Workload};
use super::mesh::square;
use super::texture::bricks;
use crate::peers::frame::{
    BILINEAR, Draw, Fragment, FrameDescription, NEAREST, Program, Shading, Step, Texture,
};
use crate::reference::map::Homography;
use display::{COMPOSITE, DITHER, LENS, PALETTE, TUBE};
use taps::{BLUR, CUBIC, EDGES, GLOW, MEDIAN, SHARPEN};

/// The scenes.
#[rustfmt::skip]
pub const SCENES: &[Scene] = &[
    Scene { name: "filter-blur", what: "9 taps of a blur in linear light", load: Workload::Filter,
        recipe: |_| filter(&BLUR) },
    Scene { name: "filter-cubic", what: "16 taps of a Catmull-Rom filter", load: Workload::Filter,
        recipe: |_| filter(&CUBIC) },
    Scene { name: "filter-crt", what: "scan lines and a mask of a tube", load: Workload::Filter,
        recipe: |_| filter(&TUBE) },
    Scene { name: "filter-ntsc", what: "17 taps that decode a composite signal", load: Workload::Filter,
        recipe: |_| filter(&COMPOSITE) },
    Scene { name: "filter-edges", what: "13 taps of an edge-directed scaler", load: Workload::Filter,
        recipe: |_| filter(&EDGES) },
    Scene { name: "filter-median", what: "the median of 3×3 texels", load: Workload::Filter,
        recipe: |_| filter(&MEDIAN) },
    Scene { name: "filter-march", what: "rays marched through a lattice of balls", load: Workload::Filter,
        recipe: |_| filter(&MARCH) },
    Scene { name: "filter-dither", what: "4 levels, dithered in order", load: Workload::Filter,
        recipe: |_| filter(&DITHER) },
    Scene { name: "filter-glow", what: "13 taps of what is bright", load: Workload::Filter,
        recipe: |_| filter(&GLOW) },
    Scene { name: "filter-sharpen", what: "5 taps, sharpened by their contrast", load: Workload::Filter,
        recipe: |_| filter(&SHARPEN) },
    Scene { name: "filter-lens", what: "a lens with coloured edges", load: Workload::Filter,
        recipe: |_| bilinear(&LENS) },
    Scene { name: "filter-palette", what: "the nearest of 16 colours", load: Workload::Filter,
        recipe: |_| filter(&PALETTE) },
];

/// Texels along a side of the picture that is filtered.
const SIDE: f64 = 256.0;

/// The whole picture under a program, texels nearest.
fn filter(program: &'static Program) -> FrameDescription {
    whole(program, Texture::new(vec![bricks(SIDE as usize)], NEAREST))
}

/// The whole picture under a program, texels bilinear.
fn bilinear(program: &'static Program) -> FrameDescription {
    whole(program, Texture::new(vec![bricks(SIDE as usize)], BILINEAR))
}

fn whole(program: &'static Program, texture: Texture) -> FrameDescription {
    let mesh = square(&Homography([[0.5, 0.0, 0.5], [0.0, 0.5, 0.5], [0.0, 0.0, 1.0]]));
    FrameDescription {
        textures: vec![texture],
        steps: vec![Step::Draw(Draw::new(mesh, Shading::Program(program)))],
    }
}

type Color = [f64; 3];

/// The texel so many columns and rows from the one at (s, t).
fn texel(f: &Fragment<'_>, [x, y]: [f64; 2]) -> Color {
    let cell = f.st.map(|c| (c * SIDE).floor());
    let [r, g, b, _] = (f.texture)(0, [(cell[0] + x + 0.5) / SIDE, (cell[1] + y + 0.5) / SIDE]);
    [r, g, b]
}

fn each(f: impl Fn(usize) -> f64) -> Color {
    std::array::from_fn(f)
}

fn opaque([r, g, b]: Color) -> [f64; 4] {
    [r, g, b, 1.0].map(|c| c.clamp(0.0, 1.0))
}

fn dot(a: Color, b: Color) -> f64 {
    (0..3).map(|c| a[c] * b[c]).sum()
}

fn mix(a: f64, b: f64, t: f64) -> f64 {
    a * (1.0 - t) + b * t
}

fn smoothstep(low: f64, high: f64, x: f64) -> f64 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

static MARCH: Program = Program {
    fragment: "
uniform sampler2D unit0;
void main() {
    vec3 way = normalize(vec3(gl_TexCoord[0].st * 2.0 - 1.0, 1.5));
    vec3 from = vec3(0.3, 0.9, -3.0);
    float far = 0.0;
    for (int k = 0; k < 64; k++) {
        vec3 p = from + far * way;
        float d = length(mod(p, 2.0) - 1.0) - 0.45;
        if (d < 0.001 || far > 24.0) break;
        far += d;
    }
    vec3 p = mod(from + far * way, 2.0) - 1.0;
    vec3 color = texture2D(unit0, gl_TexCoord[0].st).rgb;
    float light = 0.5 + 0.5 * dot(p, vec3(0.3, 0.6, -0.6)) / 0.45;
    gl_FragColor = vec4(mix(color, vec3(light), exp(-0.12 * far)), 1.0);
}
",
    formula: |f| {
        let way = [f.st[0] * 2.0 - 1.0, f.st[1] * 2.0 - 1.0, 1.5];
        let length = dot(way, way).sqrt();
        let from = [0.3, 0.9, -3.0];
        let at = |far: f64| each(|c| (from[c] + far * way[c] / length).rem_euclid(2.0) - 1.0);
        let mut far = 0.0;
        for _ in 0..64 {
            let p = at(far);
            let d = dot(p, p).sqrt() - 0.45;
            if d < 0.001 || far > 24.0 {
                break;
            }
            far += d;
        }
        let light = 0.5 + 0.5 * dot(at(far), [0.3, 0.6, -0.6]) / 0.45;
        let color = (f.texture)(0, f.st);
        opaque(each(|c| mix(color[c], light, (-0.12 * far).exp())))
    },
};
