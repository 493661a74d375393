//! Hostile sources, which could hang, overflow or exhaust the compiler: each ends soon, with a message.

#[path = "../../fuzz/bodies/draw.rs"]
mod any_shader;
#[path = "../../fuzz/bodies/compile.rs"]
mod any_text;
#[path = "common/cpu_time.rs"]
mod cpu_time;

use any_shader::link_and_run;
use any_text::compile_and_link;
use cpu_time::CpuTime;
use gl_api::glsl::{Bindings, Compiled, Options, Stage, compile, link};
use proptest::prelude::*;

use std::time::Duration;

const BLOCKS: &str = "#extension GL_ARB_uniform_buffer_object : enable\n";
const ARRAYS: &str = "#version 120\n#extension GL_ARB_arrays_of_arrays : enable\n";

fn compiled(source: &str) -> Compiled {
    let start = CpuTime::begin();
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
    // Each has four of the one before.
    let arrays = |levels: usize| {
        let mut source = "const float[] a0 = float[](1.0);\n".to_owned();
        for level in 1..levels {
            let (inner, open) = (format!("a{}", level - 1), "[]".repeat(level + 1));
            let all = [&*inner; 4].join(", ");
            source.push_str(&format!("const float{open} a{level} = float{open}({all});\n"));
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
        ("uniform blocks", BLOCKS.to_owned() + &open("uniform B {")),
        ("members", format!("{BLOCKS}uniform B {{ {} }};", "float f;".repeat(MILLION / 4))),
        ("layouts", BLOCKS.to_owned() + &open("layout(std140) ")),
        ("hashes", open("#")),
        ("stray", open("\u{1F600}")),
        ("open comment", open("/*")),
        ("dimensions", format!("{ARRAYS}float a{};", open("[1]"))),
        ("dimensions constructed", format!("{ARRAYS}float a = float{}(1.0);", open("[1]"))),
        ("arrays of arrays", ARRAYS.to_owned() + &arrays(40)),
        ("an index into large arrays", format!("{ARRAYS}float a[][60000]; float b = a[4000][0];")),
    ];
    let reject = |name: &str, source: &str| {
        let result = compiled(source);
        assert!(result.shader.is_none(), "{name} is accepted");
        assert!(result.log.contains("error: "), "{name}: {}", result.log);
        assert!(result.log.len() < 20_000, "{name}: {}", result.log.len());
    };
    std::thread::scope(|scope| {
        for half in table.chunks(table.len().div_ceil(2)) {
            scope.spawn(move || half.iter().for_each(|(name, source)| reject(name, source)));
        }
    });
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

/// Neither positions in a long line nor many declarations of one name take quadratic time.
#[test]
fn in_one_line_and_by_one_name() {
    let lines = format!("void main() {{ int x; {} }}", "x = __LINE__; ".repeat(50_000));
    let prototypes = "float f(float a); ".repeat(50_000) + "void main() {}";
    let overload = |number: u32| {
        let ty =
            |digit: u32| ["float", "vec2", "vec3", "vec4"][(number >> (2 * digit) & 3) as usize];
        let types: Vec<&str> = (0..7).map(ty).collect();
        format!("float f({});", types.join(", "))
    };
    let overloads = (0..1 << 14).map(overload).collect::<String>() + "void main() {}";
    let members: String = (0..20_000).map(|number| format!("float a{number};")).collect();
    let structure = format!("struct S {{ {members} }}; void main() {{}}");
    for source in [lines, prototypes, overloads, structure] {
        let compiled = compiled(&source);
        assert!(compiled.shader.is_some(), "{}", compiled.log);
    }
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
    let members: String = (0..16_000).map(|i| format!("float u{i};\n")).collect();
    let uses: String = (0..16_000).map(|i| format!("f += u{i};\n")).collect();
    let block = format!(
        "{BLOCKS}uniform B {{ {members} }};\n\
         void main() {{ float f; {uses} gl_FragColor = vec4(f); }}"
    );
    let tree = (1..12).fold("struct S0 { float a; };\n".to_owned(), |all, level| {
        all + &format!("struct S{level} {{ S{0} a; S{0} b; }};\n", level - 1)
    });
    let tree = format!(
        "{BLOCKS}{tree} uniform B {{ S11 s; S11 t; }};\n\
         void main() {{ gl_FragColor = vec4(s.a.b{}); }}",
        ".a".repeat(10)
    );
    for (name, source, links) in [
        ("members", block, true),
        ("tree of members", tree, true),
        ("calls", calls, false),
        ("sums", sums, true),
        ("blocks", blocks, true),
        ("many", many, true),
    ] {
        let result = compiled(&source);
        let shader = result.shader.unwrap_or_else(|| panic!("{name}: {}", result.log));
        let start = CpuTime::begin();
        let linked = link(&[&shader], &Bindings::default());
        assert!(start.elapsed() < Duration::from_secs(5), "{name}");
        assert_eq!(linked.program.is_some(), links, "{name}: {}", linked.log);
    }
}

/// Fragments of shaders, to be combined at random.
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
    "#extension GL_ARB_arrays_of_arrays : enable\n",
];

proptest! {
    #[test]
    fn random_text(text in any::<String>()) {
        compiled(&text);
    }

    #[test]
    fn random_pieces(pieces in prop::collection::vec(prop::sample::select(PIECES), 0..60)) {
        let source: String = pieces.concat();
        compile_and_link(&source);
    }
}

/// Valid shaders that use most of the language.
const VALID: [&str; 4] = [
    "#version 120
struct Light { vec3 toward; float power[2]; };
uniform Light lights[2]; uniform sampler2D image; uniform int count;
varying vec2 place;
const float weights[3] = float[3](0.25, 0.5, 0.25);
float lit(in Light light, inout vec3 n) { n = normalize(n); return max(dot(n, light.toward), 0.0); }
void main() {
    vec3 n = vec3(place, 1.0);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < count; i++) {
        if (i > 5) break; else if (i == 2) continue;
        sum.xyz[i] += lit(lights[i], n) * weights[i] * lights[i].power[1];
    }
    while (sum.w < 4.0) { sum.w++; if (place.x > 0.5) discard; }
    gl_FragColor = texture2D(image, place * mat2(1.0, 2.0, 3.0, 4.0)) + sum;
}",
    "#version 130
#define TWICE(a) ((a) + (a))
#if __VERSION__ > 120 && defined(TWICE)
flat in uvec2 which; in vec4 v; out vec4 color;
#endif
uint hash(uint x) { x ^= x >> 16u; x *= 0x7feb352du; return x % 97u; }
int chosen(int i) { switch (i) { case 0: return 1; case 1: break; default: i <<= 2; } return ~i & 7; }
void main() {
    int n = 0; do { n += TWICE(chosen(n)); } while (n < 20);
    mat3x2 m = mat3x2(v.xyz, v.yzw); bvec2 b = lessThan(m[0], m[n]);
    color = any(b) ? vec4(hash(which.x), n, m[1]) : mix(v, v.wzyx, noise1(v.xy));
    color.zx[n & 1] = isnan(v.x) ? 1.0 : sinh(v.y);
}",
    "varying vec4 gl_TexCoord[2];
void f(out float a, const int i) { float t[4]; t[i] = 3.0; a = t[i - 1] + t[3]; }
void main() {
    float a; f(a, int(gl_FragCoord.x));
    vec4 l = gl_LightSource[0].diffuse * gl_FrontMaterial.ambient + gl_Fog.color;
    gl_FragData[0] = a > 1.0 && !(a < 2.0 || a == 3.0) ? l : gl_TexCoord[1];
    gl_FragData[1].rgb = dFdx(l.rgb) * gl_TextureMatrix[0][1].xyz;
}",
    "#version 120
#extension GL_ARB_arrays_of_arrays : enable
struct S { vec2[2] v[3]; }; uniform S s[2][1]; uniform int i; varying vec4[2] place[2];
const float t[][2] = float[][](float[](1.0, 2.0), float[2](3.0, 4.0));
float[2][2] f(inout vec2 a[3][2]) { a[i][1].x = t[1][i]; return t; }
void main() {
    S one[1] = s[i]; float[] g[2] = f(one[0].v); vec4 late[][2]; late[1][0] = place[1][i];
    gl_FragColor = one[0].v[2][1].xyxy * g[1][0] + late[1][0] * float(g.length() + g[0].length());
}",
];

/// Replacements of a token, besides tokens of other shaders.
const STRANGE: [&str; 16] = [
    "",
    "0",
    "-1",
    "1e38",
    "0u",
    "int",
    "vec4",
    "}",
    "{",
    ")",
    "(",
    ";",
    "inout",
    "while (true)",
    "\n#define f f(\n",
    "[99999999]",
];

/// The words, numbers and other characters of a source, and the blanks between them.
fn pieces(source: &str) -> Vec<&str> {
    let mut all = Vec::new();
    let mut rest = source;
    while let Some(first) = rest.chars().next() {
        let word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
        let len = match rest.find(|c| !word(c)) {
            Some(0) => first.len_utf8(),
            Some(len) => len,
            None => rest.len(),
        };
        let (piece, more) = rest.split_at(len);
        all.push(piece);
        rest = more;
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn mutated_shaders(
        which in 0..VALID.len(),
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u16>(), 0..5u8), 1..4),
    ) {
        let mut all = pieces(VALID[which]);
        for (place, number, kind) in edits {
            let at = place.index(all.len());
            let other = usize::from(number);
            match kind {
                0 => all[at] = STRANGE[other % STRANGE.len()],
                1 => all.insert(at, all[other % all.len()]),
                2 => {
                    let len = all.len();
                    all.swap(at, other % len);
                }
                3 => {
                    let donor = pieces(VALID[(which + 1) % VALID.len()]);
                    all[at] = donor[other % donor.len()];
                }
                _ => {
                    all.remove(at);
                    all.push(" ");
                }
            }
        }
        let source = all.concat();
        link_and_run(&source);
    }
}

#[test]
fn the_shaders_to_mutate_are_valid() {
    for source in VALID {
        let shader = compiled(source);
        let shader = shader.shader.unwrap_or_else(|| panic!("{}", shader.log));
        let _ = link(&[&shader], &Bindings::default());
    }
}
