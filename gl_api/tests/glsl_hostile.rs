//! Sources that want to hang, overflow or exhaust the compiler: each ends soon, with a message.

use gl_api::glsl::{Bindings, Compiled, Options, Repairs, Stage, compile, link};
use proptest::prelude::*;
use std::time::{Duration, Instant};

fn compiled(source: &str) -> Compiled {
    let start = Instant::now();
    let result = compile(Stage::Fragment, source, &Options::default());
    assert!(start.elapsed() < Duration::from_secs(5), "{:?}", start.elapsed());
    result
}

#[test]
fn rejected_soon() {
    const MILLION: usize = 1_000_000;
    let open = |s: &str| s.repeat(MILLION);
    let main = |body: String| format!("void main() {{ {body} }}");
    let define = |levels: usize| {
        let mut source = "#define M0 1.0 + 1.0\n".to_owned();
        for level in 1..levels {
            source.push_str(&format!("#define M{level} M{0} + M{0}\n", level - 1));
        }
        source + &format!("float f = M{};\n", levels - 1)
    };
    let structures = |levels: usize| {
        let mut source = "struct S0 { float a; };\n".to_owned();
        for level in 1..levels {
            let inner = level - 1;
            source.push_str(&format!("struct S{level} {{ S{inner} a; S{inner} b; }};\n"));
        }
        source
    };
    let table = [
        ("parentheses", main(format!("float f = {}1.0{};", open("("), open(")")))),
        ("open parentheses", main(open("("))),
        ("minuses", main(format!("float f = {}1.0;", open("- ")))),
        ("braces", open("{")),
        ("blocks", format!("void main() {}", open("{"))),
        ("indices", main(open("a["))),
        ("calls", main(open("f("))),
        ("sums", main(format!("float f = 1.0{};", open(" + 1.0")))),
        ("choices", main(format!("float f = {}1.0;", open("true ? 1.0 : ")))),
        ("fields", main(format!("gl_FragColor{};", open(".x")))),
        ("ifs", main(open("if (true) "))),
        ("else ifs", main(format!("if (true) ; {}", open("else if (true) ; ")))),
        ("identifiers", open("a ")),
        ("names", main((0..100_000).map(|i| format!("v{i};")).collect())),
        ("macro bomb", define(40)),
        ("macro calls", format!("#define F(a) a\nfloat f = {};", open("F("))),
        ("conditionals", open("#if 1\n")),
        ("conditions", format!("#if {}1", open("("))),
        ("structures", structures(40)),
        ("hashes", open("#")),
        ("stray", open("\u{1F600}")),
        ("open comment", open("/*")),
    ];
    for (name, source) in table {
        let result = compiled(&source);
        assert!(result.shader.is_none(), "{name} is accepted");
        assert!(result.log.contains("error: "), "{name}: {}", result.log);
        assert!(result.log.len() < 20_000, "{name}: {}", result.log.len());
    }
}

#[test]
fn long_but_fine() {
    let mut source = "uniform float u;\nvoid main() {\n    float f = u;\n".to_owned();
    for _ in 0..5_000 {
        source.push_str("    f = f * u + 1.0;\n");
    }
    source.push_str("    gl_FragColor = vec4(f);\n}\n");
    let shader = compiled(&source).shader.expect("it is a fine shader");
    let linked = link(&[&shader], &Bindings::default());
    assert!(linked.program.is_some(), "{}", linked.log);
}

#[test]
fn deep_but_bounded() {
    let mut calls = "float f0(float a) { return a; }\n".to_owned();
    for level in 1..1_500 {
        calls.push_str(&format!("float f{level}(float a) {{ return f{}(a); }}\n", level - 1));
    }
    calls.push_str("void main() { gl_FragColor = vec4(f1499(1.0)); }\n");
    let mut sums = "uniform float u;\nfloat f0(float a) { return a; }\n".to_owned();
    for level in 1..4 {
        let sum = " + u".repeat(300);
        sums.push_str(&format!("float f{level}(float a) {{ return f{}(a){sum}; }}\n", level - 1));
    }
    sums.push_str("void main() { gl_FragColor = vec4(f3(1.0)); }\n");
    let blocks = format!("void main() {{ {}{} }}", "{".repeat(250), "}".repeat(250));
    let uniforms: String = (0..20_000).map(|i| format!("uniform float u{i};\n")).collect();
    let uses: String = (0..20_000).map(|i| format!("f += u{i};\n")).collect();
    let many = format!("{uniforms}void main() {{ float f; {uses} gl_FragColor = vec4(f); }}");
    for (name, source, links) in [
        ("calls", calls, false),
        ("sums", sums, true),
        ("blocks", blocks, true),
        ("many", many, true),
    ] {
        let result = compiled(&source);
        let shader = result.shader.unwrap_or_else(|| panic!("{name}: {}", result.log));
        let start = Instant::now();
        let linked = link(&[&shader], &Bindings::default());
        assert!(start.elapsed() < Duration::from_secs(5), "{name}");
        assert_eq!(linked.program.is_some(), links, "{name}: {}", linked.log);
    }
}

/// Bits of shaders, to be put together at random.
const PIECES: &[&str] = &[
    "void main() {",
    "}",
    "{",
    "(",
    ")",
    ";",
    "vec4",
    " a",
    " b",
    "=",
    "1.0",
    "2",
    "+",
    "*",
    "[",
    "]",
    ".xy",
    "if",
    "for",
    "while",
    "return",
    "uniform ",
    "varying ",
    "struct S {",
    "float ",
    "int ",
    "gl_FragColor",
    "texture2D",
    "sampler2D ",
    "const ",
    "?",
    ":",
    ",",
    "\n",
    "#define A a\n",
    "A",
    "#if 1\n",
    "#endif\n",
    "mat3",
    "in ",
    "out ",
    "void f() {",
    "f()",
    "switch",
    "case 1:",
    "break;",
    "discard;",
    "++",
    "&&",
    "#version 130\n",
    "u",
    "%",
    "<<",
    "1u",
    "true",
    "S ",
    "[2]",
    "[]",
];

proptest! {
    #[test]
    fn random_text(text in any::<String>()) {
        compiled(&text);
    }

    #[test]
    fn random_pieces(pieces in prop::collection::vec(prop::sample::select(PIECES), 0..60)) {
        let source: String = pieces.concat();
        for repairs in [Repairs::Off, Repairs::On] {
            for stage in [Stage::Vertex, Stage::Fragment] {
                let result = compile(stage, &source, &Options { repairs });
                if let Some(shader) = result.shader {
                    link(&[&shader], &Bindings::default());
                }
            }
        }
    }
}
