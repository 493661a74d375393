//! Which shaders of GLSL ES link: what the stages declare must agree, and there are limits.

use gl_api::glsl::{Bindings, ContextLanguage, Options, Shader, Stage, compile, link};
use std::fmt::Write as _;

/// Whether a pair of shaders links; if not, words of the log.
enum Expected {
    Links,
    Fails(&'static str),
}

use Expected::{Fails, Links};

/// The globals and statements of the vertex shader, those of the fragment shader.
struct Pair(&'static str, &'static str, &'static str, &'static str, Expected);

const ROWS_300: &[Pair] = &[
    // What passes between the stages
    Pair("smooth out float x;", "x = 1.0;", "centroid in float x;", "o *= x;", Links),
    Pair("centroid out float x;", "x = 1.0;", "in float x;", "o *= x;", Links),
    Pair("flat out float x;", "x = 1.0;", "in float x;", "o *= x;", Fails("flat")),
    Pair("out S x;", "x.a = 1.0;", "in S x;", "o *= x.a;", Links),
    // Precisions of members
    Pair("uniform S u;", "p *= u.a;", "uniform S u;", "", Fails("members of uniform `u`")),
    Pair("uniform T u;", "p *= u.s[0].a;", "uniform T u;", "", Fails("members of uniform `u`")),
    Pair("uniform R u;", "p *= u.a;", "uniform R u;", "o *= u.a;", Links),
    Pair("uniform B { float a; };", "p *= a;", "uniform B { float a; };", "", Fails("block `B`")),
    Pair("uniform B { S s; } b;", "", "uniform B { S s; } b;", "", Fails("block `B`")),
    Pair("uniform B { lowp float a; };", "", "uniform B { lowp float a; };", "o *= a;", Links),
    // Names of uniforms and blocks
    Pair("uniform B { lowp int a; } b;", "", "uniform lowp int B;", "", Fails("`B`")),
    // Locations of attributes
    Pair(
        "layout(location = 0) in mat2 a; layout(location = 1) in vec4 b;",
        "p *= a[0].x * b;",
        "",
        "",
        Fails("`b`"),
    ),
    Pair(
        "layout(location = 0) in mat2 a; layout(location = 2) in vec4 b;",
        "p *= a[0].x * b;",
        "",
        "",
        Links,
    ),
    // Limits
    Pair("uniform vec4 u[4096];", "for (int i = 0; i < 4096; i++) p += u[i];", "", "", Links),
    Pair(
        "uniform vec4 u[4097];",
        "for (int i = 0; i < 4097; i++) p += u[i];",
        "",
        "",
        Fails("16388"),
    ),
    Pair(
        "out vec3 x[16]; out float y[16];",
        "for (int i = 0; i < 16; i++) { x[i] = vec3(1.0); y[i] = 1.0; }",
        "in vec3 x[16]; in float y[16];",
        "for (int i = 0; i < 16; i++) o.xyz += x[i] * y[i];",
        Links,
    ),
    Pair(
        "out vec3 x[17];",
        "for (int i = 0; i < 17; i++) x[i] = vec3(1.0);",
        "in vec3 x[17];",
        "for (int i = 0; i < 17; i++) o.xyz += x[i];",
        Fails("do not fit"),
    ),
];

fn linked(vertex: &str, fragment: &str) -> Result<(), String> {
    linked_with(vertex, fragment, &Bindings::default())
}

fn linked_with(vertex: &str, fragment: &str, bindings: &Bindings) -> Result<(), String> {
    let options = Options { context: ContextLanguage::Es30, ..Options::default() };
    let shader = |stage, source: &str| -> Shader {
        let compiled = compile(stage, source, &options);
        compiled.shader.unwrap_or_else(|| panic!("{source}\n{}", compiled.log))
    };
    let shaders = [shader(Stage::Vertex, vertex), shader(Stage::Fragment, fragment)];
    let linked = link(&shaders.iter().collect::<Vec<_>>(), bindings);
    linked.program.map(drop).ok_or(linked.log)
}

/// Reports a link that went another way.
fn check(pair: [&str; 2], expected: &Expected, wrong: &mut String) {
    match (linked(pair[0], pair[1]), expected) {
        (Ok(()), Links) => {}
        (Err(log), Fails(words)) if log.contains(words) => {}
        (Ok(()), Fails(_)) => {
            let _ = writeln!(wrong, "links: {pair:#?}");
        }
        (Err(log), Links | Fails(_)) => {
            let _ = writeln!(wrong, "{pair:#?}\n{log}");
        }
    }
}

#[test]
fn programs_of_es_300() {
    let mut wrong = String::new();
    // `S` and `T` have other precisions in the fragment shader, where `mediump` is the default.
    let structures = "struct S { float a; }; struct T { S s[2]; }; struct R { lowp float a; };";
    for Pair(vertex, in_vertex, fragment, in_fragment, expected) in ROWS_300 {
        let vertex = format!(
            "#version 300 es\n{structures} {vertex}\nvoid main() {{ vec4 p = vec4(1.0); {in_vertex} gl_Position = p; }}"
        );
        let fragment = format!(
            "#version 300 es\nprecision mediump float; {structures} {fragment}\nout vec4 color;\n\
             void main() {{ vec4 o = vec4(1.0); {in_fragment} color = o; }}"
        );
        check([&vertex, &fragment], expected, &mut wrong);
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn programs_of_es_100() {
    let rows = [
        // A varying that is declared and not written is undefined.
        ("varying float x; void main() {}", "varying lowp float x;", "x", Links),
        ("void main() {}", "varying lowp float x;", "x", Fails("`x`")),
        // Precisions count where both shaders use the uniform.
        (
            "struct S { highp float a; }; uniform S u; void main() { gl_Position *= u.a; }",
            "struct S { lowp float a; }; uniform S u;",
            "u.a",
            Fails("members of uniform `u`"),
        ),
        (
            "struct S { highp float a; }; uniform S u; void main() {}",
            "struct S { lowp float a; }; uniform S u;",
            "u.a",
            Links,
        ),
    ];
    let mut wrong = String::new();
    for (vertex, globals, value, expected) in rows {
        let fragment = format!("{globals} void main() {{ gl_FragColor = vec4({value}); }}");
        check([vertex, &fragment], &expected, &mut wrong);
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// The declarations of attributes, what is bound, whether a shader of GLSL ES 3.00 links.
type BoundRow = (&'static str, &'static [(&'static str, u8)], Expected);

/// Several attributes at the same location: OpenGL ES has them only of shaders of GLSL ES 1.00 (3.0, section 2.11.5).
#[test]
fn attributes_at_the_same_location() {
    let rows: &[BoundRow] = &[
        ("in vec4 a; in vec4 b;", &[("a", 3), ("b", 4)], Links),
        ("in vec4 a; in vec4 b;", &[("a", 3), ("b", 3)], Fails("`b`, 3,")),
        ("in mat3 a; in vec4 b;", &[("a", 2), ("b", 4)], Fails("`b`, 4,")),
        ("in mat3 a; in vec4 b;", &[("a", 2), ("b", 5)], Links),
        ("layout(location = 3) in vec4 a; in vec4 b;", &[("a", 5), ("b", 5)], Links),
        ("layout(location = 3) in vec4 a; in vec4 b;", &[("b", 3)], Fails("`b`, 3,")),
    ];
    let mut wrong = String::new();
    for (declarations, bound, expected) in rows {
        let mut bindings = Bindings::default();
        bindings.attributes.extend(bound.iter().map(|&(name, at)| (name.to_owned(), at)));
        let body = "void main() { gl_Position = vec4(float(a[0])) + b; }";
        let linked = linked_with(
            &format!("#version 300 es\n{declarations}\n{body}"),
            "#version 300 es\nvoid main() {}",
            &bindings,
        );
        let fits = match (&linked, expected) {
            (Ok(()), Links) => true,
            (Err(log), Fails(words)) => log.contains(words),
            (Ok(()), Fails(_)) | (Err(_), Links) => false,
        };
        if !fits {
            let _ = writeln!(wrong, "{declarations} {bound:?}: {linked:?}");
        }
        if !declarations.contains("layout") {
            let old = format!("{}\n{body}", declarations.replace("in ", "attribute "));
            if let Err(log) = linked_with(&old, "void main() {}", &bindings) {
                let _ = writeln!(wrong, "{old}: {log}");
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}
