//! Hostile shaders and images in contexts of OpenGL ES: each is refused with a message, or its draw ends, soon.

#[path = "../../fuzz/bodies/blocks.rs"]
mod blocks;
#[path = "../../fuzz/bodies/context.rs"]
mod context;
#[path = "common/cpu_time.rs"]
mod cpu_time;
#[path = "../../fuzz/bodies/es_shader.rs"]
mod es_shader;
#[path = "../../fuzz/bodies/random.rs"]
mod random;

use context::{context_of, still_works};
use cpu_time::CpuTime;
use es_shader::Fate;
use gl_api::Api;
use random::Random;
use std::time::{Duration, Instant};

#[test]
fn shaders_of_the_grammar_are_drawn_or_refused_with_a_reason() {
    let start = Instant::now();
    let mut c = context_of(Api::Es2);
    let (mut drawn, mut all) = (0, 0);
    for seed in 0..300 {
        let source = es_shader::shader(&mut Random::new(seed, &[]));
        drawn += u32::from(es_shader::draw(&mut c, &source) == Fate::Drawn);
        all += 1;
        // A slow machine tries fewer.
        if start.elapsed() > Duration::from_secs(20) {
            break;
        }
    }
    // Most fit: the others are the grammar's strange statements.
    assert!(drawn * 4 > all * 3, "{drawn} of {all} are drawn");
    still_works(&mut c);
}

/// Blocks of random bytes, of every format; one in four images has a length that does not fit.
#[test]
fn blocks_of_any_bytes_are_texels() {
    let mut c = context_of(Api::Es2);
    blocks::prepare(&mut c);
    let mut random = Random::new(7, &[]);
    for number in 0..400 {
        let [width, height] = [0; 2].map(|_| (random.next() % 23) as usize);
        let which = number % blocks::FORMATS.len();
        let size = width.div_ceil(4) * height.div_ceil(4) * blocks::FORMATS[which].1;
        let size = if number % 4 == 0 { size + number % 3 } else { size };
        let head = [which as u8, width as u8, height as u8];
        let bytes: Vec<u8> =
            head.into_iter().chain((0..size).map(|_| random.next() as u8)).collect();
        blocks::sample(&mut c, &bytes);
    }
    still_works(&mut c);
}

#[test]
fn hostile_shaders_end_soon() {
    const MANY: usize = 200_000;
    let es = |body: &str| {
        format!(
            "#version 300 es\nprecision highp float; in vec4 v; uniform int n; out vec4 color;\n\
             void main() {{ {body} }}"
        )
    };
    let old = |body: &str| {
        format!("precision mediump float; varying vec4 v; uniform int n;\nvoid main() {{ {body} }}")
    };
    let zero = "int z = n;";
    let table = [
        ("an endless loop", es("while (true) {} color = v;"), Fate::Drawn),
        (
            "an endless loop of 1.00",
            old("for (int i = 0; i >= 0; i++) {} gl_FragColor = v;"),
            Fate::Drawn,
        ),
        (
            "nested loops",
            es(
                "float s = 0.0; for (int i = 0; i < 100000; i++) for (int j = 0; j < 100000; j++) s += v.x; color = vec4(s);",
            ),
            Fate::Drawn,
        ),
        (
            "a division by zero",
            es(&format!("{zero} color = vec4(1 / z, 1 % z, -2147483648 / (z - 1), 1);")),
            Fate::Drawn,
        ),
        (
            "an index out of range",
            es(&format!(
                "{zero} float a[3]; a[z - 1000000] = 1.0; color = vec4(a[z + 2147483647]);"
            )),
            Fate::Drawn,
        ),
        (
            "a shift by any number",
            es(&format!("{zero} color = vec4(1 << (z - 1), 1 >> (z + 99), ~z << 32, 1u << 31u);")),
            Fate::Drawn,
        ),
        (
            "numbers that are none",
            es(
                "color = vec4(sqrt(-1.0 - v.x), inversesqrt(v.x - v.x), log(-v.x), pow(-v.x, 0.5));",
            ),
            Fate::Drawn,
        ),
        (
            "precisions",
            format!("#version 300 es\n{}void main() {{}}", "precision lowp float;".repeat(MANY)),
            Fate::Drawn,
        ),
        (
            "recursion",
            "#version 300 es\nfloat f() { return f(); } void main() { f(); }".to_owned(),
            Fate::Refused,
        ),
        (
            "no precision",
            "#version 300 es\nout vec4 c; float f; void main() { c = vec4(f); }".to_owned(),
            Fate::Refused,
        ),
        (
            "a version that is not there",
            "#version 310 es\nvoid main() {}".to_owned(),
            Fate::Refused,
        ),
        (
            "a late version",
            format!("{}#version 300 es\nvoid main() {{}}", "\n".repeat(MANY)),
            Fate::Refused,
        ),
        ("braces", es(&"{".repeat(MANY)), Fate::Refused),
        (
            "parentheses",
            es(&format!("color = {}v{};", "(".repeat(MANY), ")".repeat(MANY))),
            Fate::Refused,
        ),
        ("a large array", es("float a[100000000]; color = vec4(a[0]);"), Fate::Refused),
        ("no text", String::new(), Fate::Refused),
    ];
    for (name, source, fate) in table {
        let start = CpuTime::begin();
        let mut c = context_of(Api::Es2);
        assert_eq!(es_shader::draw(&mut c, &source), fate, "{name}");
        still_works(&mut c);
        assert!(start.elapsed() < Duration::from_secs(10), "{name}: {:?}", start.elapsed());
    }
}
