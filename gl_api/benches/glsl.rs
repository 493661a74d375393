//! How long compile and link take: the lecture's shaders, each well under a millisecond.

use criterion::{Criterion, criterion_group, criterion_main};
use gl_api::glsl::{Bindings, FixIts, Options, Shader, Stage, compile, link};
use std::hint::black_box;

/// The lecture's shaders as printed; the fix-its make them valid.
const SHADERS: [(&str, Stage, &str); 5] = [
    ("textured.vert", Stage::Vertex, include_str!("../tests/lecture/textured.vert")),
    ("textured.frag", Stage::Fragment, include_str!("../tests/lecture/textured.frag")),
    ("environment.frag", Stage::Fragment, include_str!("../tests/lecture/environment.frag")),
    ("projector.vert", Stage::Vertex, include_str!("../tests/lecture/projector.vert")),
    ("projector.frag", Stage::Fragment, include_str!("../tests/lecture/projector.frag")),
];

const VERTEX: &str = "varying vec3 normal;
void main() {
    normal = gl_NormalMatrix * gl_Normal;
    gl_TexCoord[0] = gl_TextureMatrix[0] * gl_MultiTexCoord0;
    gl_Position = ftransform();
}";

const FRAGMENT: &str = "uniform sampler2D image;
varying vec3 normal;
float noise(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453); }
void main() {
    vec3 n = normalize(normal);
    vec3 l = normalize(gl_LightSource[0].position.xyz);
    vec4 texel = texture2D(image, gl_TexCoord[0].st);
    float rings = 0.0;
    for (int i = 0; i < 5; i++) rings += noise(gl_TexCoord[0].st * float(i + 1)) / float(i + 1);
    gl_FragColor = texel * max(dot(n, l), 0.0) * rings + pow(max(n.z, 0.0), 32.0);
}";

fn shader(stage: Stage, source: &str) -> Shader {
    let compiled =
        compile(stage, source, &Options { fix_its: FixIts::Apply, ..Options::default() });
    compiled.shader.expect("it is a fine shader")
}

fn benches(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("compile");
    for (name, stage, source) in SHADERS {
        group.bench_function(name, |bench| {
            bench.iter(|| compile(stage, black_box(source), &Options::default()));
        });
    }
    group.bench_function("lit.frag", |bench| {
        bench.iter(|| shader(Stage::Fragment, black_box(FRAGMENT)));
    });
    group.finish();
    let (vertex, fragment) = (shader(Stage::Vertex, VERTEX), shader(Stage::Fragment, FRAGMENT));
    criterion.bench_function("link/lit", |bench| {
        bench.iter(|| link(black_box(&[&vertex, &fragment]), &Bindings::default()));
    });
}

criterion_group!(glsl, benches);
criterion_main!(glsl);
