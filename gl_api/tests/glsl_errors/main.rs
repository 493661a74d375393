//! Invalid shaders and their logs.

mod rules;
mod shaders;

use gl_api::glsl::{Bindings, Compiled, FixIts, Linked, Options, Stage, Strictness, compile, link};
use rules::{CHANGED, DEVIATIONS, LINKED, REFUSED, UNLINKED, WARNED};
use shaders::{DIRECTIVES, FRAGMENT, VERTEX};
use std::fmt::Write as _;

/// The logs of a table, whose shaders must all be rejected.
fn report(stage: Stage, table: &[(&str, &str)]) -> String {
    let (mut report, mut accepted) = (String::new(), Vec::new());
    for (name, source) in table {
        let compiled = compile(stage, source, &Options::default());
        if compiled.shader.is_some() {
            accepted.push(name);
        }
        assert!(compiled.log.is_ascii(), "{name}");
        let _ = writeln!(report, "== {name}\n{}", compiled.log.trim_end());
    }
    assert!(accepted.is_empty(), "accepted: {accepted:?}");
    report
}

#[test]
fn logs() {
    insta::assert_snapshot!(report(Stage::Fragment, FRAGMENT));
}

#[test]
fn directive_logs() {
    insta::assert_snapshot!(report(Stage::Fragment, DIRECTIVES));
}

#[test]
fn vertex_logs() {
    insta::assert_snapshot!(report(Stage::Vertex, VERTEX));
}

/// Compiles the shaders of a table: each has the expected outcome, and its log contains the words.
fn check_logs(table: &[(Stage, &str, &str)], expected: fn(&Compiled) -> bool) {
    let mut wrong = String::new();
    for (stage, source, words) in table {
        let compiled = compile(*stage, source, &Options::default());
        if !expected(&compiled) || !compiled.log.contains(words) {
            let _ = writeln!(wrong, "{source:?}\nexpected {words:?}:\n{}", compiled.log);
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn refused() {
    check_logs(REFUSED, |compiled| compiled.shader.is_none());
}

#[test]
fn warned() {
    check_logs(WARNED, |compiled| compiled.shader.is_some());
}

/// What all drivers accept is accepted with a warning that names the version, and refused by a strict compiler.
#[test]
fn deviations() {
    check_logs(DEVIATIONS, |compiled| {
        compiled.shader.is_some() && !compiled.log.contains(": error: ")
    });
    for (stage, source, words) in DEVIATIONS {
        let options = Options { strictness: Strictness::Strict, ..Options::default() };
        let compiled = compile(*stage, source, &options);
        assert!(compiled.shader.is_none(), "{source:?}");
        assert!(compiled.log.contains(&format!("error: {words}")), "{source:?}: {}", compiled.log);
    }
    let source = "#version 130\n#define P(a, b) a ## b\nvoid main() { int P(x, 1) = 1; }";
    let compiled = compile(Stage::Fragment, source, &Options::default());
    assert!(compiled.shader.is_some() && compiled.log.is_empty(), "{}", compiled.log);
}

#[test]
fn changed() {
    for (fine, refused, body, words) in CHANGED {
        let compiled = |version: &str| {
            let source = format!("#version {version}\n{body}");
            compile(Stage::Fragment, &source, &Options::default())
        };
        let (fine, refused) = (compiled(fine), compiled(refused));
        assert!(fine.shader.is_some(), "{body}: {}", fine.log);
        assert!(refused.shader.is_none() && refused.log.contains(words), "{body}: {}", refused.log);
    }
}

#[test]
fn there_are_many() {
    assert!(FRAGMENT.len() + DIRECTIVES.len() + VERTEX.len() + PAIRS.len() >= 150);
}

/// Pairs of a vertex and a fragment shader that do not link.
const PAIRS: &[(&str, &str, &str)] = &[
    (
        "types differ",
        "varying vec2 v; void main() { v = vec2(1.0); gl_Position = vec4(v, v); }",
        "varying vec3 v; void main() { gl_FragColor = vec4(v, 1.0); }",
    ),
    (
        "not written",
        "void main() { gl_Position = vec4(1.0); }",
        "varying vec3 v; void main() { gl_FragColor = vec4(v, 1.0); }",
    ),
    (
        "uniform differs",
        "uniform vec4 u; void main() { gl_Position = u; }",
        "uniform float u; void main() { gl_FragColor = vec4(u); }",
    ),
    ("no main", "void f() {}", "void main() { gl_FragColor = vec4(1.0); }"),
    (
        "never defined",
        "void f(); void main() { f(); gl_Position = vec4(1.0); }",
        "void main() { gl_FragColor = vec4(1.0); }",
    ),
    (
        "too many attributes",
        "attribute mat4 a, b, c, d, e; void main() { gl_Position = (a + b + c + d + e)[0]; }",
        "void main() { gl_FragColor = vec4(1.0); }",
    ),
    (
        "too many operations",
        "void a(inout vec4 v) { v = v * v + v; v *= v; } void b(inout vec4 v) { a(v); a(v); a(v); a(v); a(v); a(v); a(v); a(v); a(v); a(v); } void c(inout vec4 v) { b(v); b(v); b(v); b(v); b(v); b(v); b(v); b(v); b(v); b(v); } void d(inout vec4 v) { c(v); c(v); c(v); c(v); c(v); c(v); c(v); c(v); c(v); c(v); } void e(inout vec4 v) { d(v); d(v); d(v); d(v); d(v); d(v); d(v); d(v); d(v); d(v); } void main() { gl_Position = vec4(1.0); e(gl_Position); }",
        "void main() { gl_FragColor = vec4(1.0); }",
    ),
];

/// Links a vertex and a fragment shader, which must compile.
fn linked(vertex: &str, fragment: &str) -> Linked {
    let shaders = [(Stage::Vertex, vertex), (Stage::Fragment, fragment)].map(|(stage, source)| {
        let compiled = compile(stage, source, &Options::default());
        compiled.shader.unwrap_or_else(|| panic!("{source:?}: {}", compiled.log))
    });
    link(&[&shaders[0], &shaders[1]], &Bindings::default())
}

#[test]
fn what_links() {
    for (vertex, fragment) in LINKED {
        let linked = linked(vertex, fragment);
        assert!(linked.program.is_some(), "{vertex:?}, {fragment:?}: {}", linked.log);
    }
}

#[test]
fn what_does_not_link() {
    for (vertex, fragment, words) in UNLINKED {
        let linked = linked(vertex, fragment);
        assert!(linked.program.is_none(), "{vertex:?}, {fragment:?} links");
        assert!(linked.log.contains(words), "{words:?}: {}", linked.log);
    }
}

#[test]
fn link_logs() {
    let mut report = String::new();
    for (name, vertex, fragment) in PAIRS {
        let linked = linked(vertex, fragment);
        assert!(linked.program.is_none(), "{name} links");
        let _ = writeln!(report, "== {name}\n{}", linked.log.trim_end());
    }
    insta::assert_snapshot!(report);
}

/// Independent errors on separate lines, from every phase of the compiler.
#[test]
fn independent_mistakes_are_all_reported_up_to_twenty() {
    const LINES: [&str; 9] = [
        "float a = true;",
        "b = 1.0;",
        "vec2 c = vec2(1.0, 2.0, 3.0);",
        "float d = 1.0 + ;",
        "float e = sin(vec2(1.0);",
        "u = 1.0;",
        "float f = $1;",
        "if (1) discard;",
        "unknown(1.0);",
    ];
    let compiled = |lines: Vec<&str>| {
        let body = lines.join("\n");
        let source = format!("uniform float u;\nvoid main() {{\n{body}\n}}");
        compile(Stage::Fragment, &source, &Options::default()).log
    };
    let log = compiled(LINES.to_vec());
    for (line, text) in (3..).zip(LINES) {
        assert!(log.contains(&format!("0:{line}(")), "{text}\n{log}");
    }
    let log = compiled(LINES.repeat(5));
    assert_eq!(log.matches(": error: ").count(), 20, "{log}");
    assert!(log.contains("too many errors, giving up after 20"), "{log}");
}

#[test]
fn repairs_are_listed() {
    let source =
        "uniform vec4 color;\nvoid main() {\n    float f = 1\n    gl_FragColor = colour * f;\n}";
    let compiled =
        compile(Stage::Fragment, source, &Options { fix_its: FixIts::Apply, ..Options::default() });
    assert!(compiled.shader.is_some(), "{}", compiled.log);
    insta::assert_snapshot!(compiled.log);
}
