//! Wrong shaders and what the log says of them.

use gl_api::glsl::{Bindings, Options, Repairs, Stage, compile, link};
use std::fmt::Write as _;

/// Fragment shaders, each with a mistake.
const FRAGMENT: &[(&str, &str)] = &[
    ("misspelt variable", "uniform vec4 color;\nvoid main() { gl_FragColor = colour; }"),
    (
        "misspelt function",
        "uniform sampler2D t;\nvoid main() { gl_FragColor = textur2D(t, vec2(0.5)); }",
    ),
    ("misspelt type", "vce4 c;\nvoid main() {}"),
    ("misspelt keyword", "unifrom vec4 c;\nvoid main() {}"),
    ("int where float", "void main() { float f = 1; gl_FragColor = vec4(f); }"),
    ("int times float", "void main() { gl_FragColor = vec4(2 * 1.5); }"),
    ("missing semicolon", "void main() {\n    float f = 1.0\n    gl_FragColor = vec4(f);\n}"),
    ("missing brace", "void main() {\n    gl_FragColor = vec4(1.0);\n"),
    ("vec4 to vec3", "void main() { vec3 v = vec4(1.0); }"),
    ("too few components", "void main() { gl_FragColor = vec4(1.0, 2.0); }"),
    ("too many components", "void main() { gl_FragColor = vec4(vec4(1.0), 2.0); }"),
    ("swizzle out of range", "void main() { vec2 v; gl_FragColor = v.xyzz; }"),
    ("swizzle of two sets", "void main() { vec4 v; gl_FragColor = v.xyba; }"),
    ("swizzle written twice", "void main() { gl_FragColor.xx = vec2(1.0); }"),
    ("write a uniform", "uniform float f;\nvoid main() { f = 1.0; }"),
    ("write a varying", "varying vec2 v;\nvoid main() { v.x = 1.0; }"),
    ("write a constant", "const float f = 1.0;\nvoid main() { f += 1.0; }"),
    ("write a value", "void main() { 1.0 = 2.0; }"),
    ("constant without value", "const float f;\nvoid main() {}"),
    ("not constant", "uniform float u;\nconst float f = u;\nvoid main() {}"),
    ("array too short", "void main() { float a[2]; a[2] = 1.0; }"),
    ("array size negative", "float a[-1];\nvoid main() {}"),
    ("array gigantic", "float a[1000000];\nvoid main() {}"),
    ("array indexed by float", "void main() { float a[2]; a[1.0] = 1.0; }"),
    ("twice declared", "void main() { float a; float a; }"),
    ("twice defined", "void f() {}\nvoid f() {}\nvoid main() {}"),
    ("recursion", "float f(float a) { return f(a); }\nvoid main() { f(1.0); }"),
    ("no value returned", "float f() { return; }\nvoid main() {}"),
    ("wrong arguments", "void main() { gl_FragColor = vec4(dot(1.0, vec2(1.0))); }"),
    ("condition no bool", "void main() { if (1) discard; }"),
    ("break outside", "void main() { break; }"),
    ("sampler local", "void main() { sampler2D s; }"),
    ("attribute in fragment", "attribute vec4 a;\nvoid main() {}"),
    ("reserved name", "float gl_Mine;\nvoid main() {}"),
    ("reserved word", "void main() { double d; }"),
    ("unknown member", "struct S { float near; };\nvoid main() { S s; s.naer = 1.0; }"),
    ("1D texture", "uniform sampler1D t;\nvoid main() { gl_FragColor = texture1D(t, 0.5); }"),
    (
        "cube with 2D coordinates",
        "uniform samplerCube t;\nvoid main() { gl_FragColor = textureCube(t, vec2(0.5)); }",
    ),
    ("uint in 110", "void main() { uint n; }"),
    ("in of 130 in 110", "in vec2 v;\nvoid main() { gl_FragColor = vec4(v, v); }"),
    ("switch in 110", "void main() { switch (1) { } }"),
    ("remainder in 120", "#version 120\nvoid main() { int i = 7 % 2; }"),
    ("integers smooth", "#version 130\nin ivec2 v;\nvoid main() {}"),
    ("version unknown", "#version 330\nvoid main() {}"),
    ("version late", "float f;\n#version 120\nvoid main() {}"),
    ("macro arguments", "#define F(a, b) a\nfloat f = F(1.0);\nvoid main() {}"),
    ("error directive", "#error not today\nvoid main() {}"),
    ("endif missing", "#ifdef A\nvoid main() {}"),
    ("undefined in if", "#if A > 1\n#endif\nvoid main() {}"),
    ("unknown directive", "#inclde \"a\"\nvoid main() {}"),
    ("extension unknown", "#extension GL_MINE : require\nvoid main() {}"),
    ("line directive", "#line 100\nvoid main() { x = 1; }"),
    (
        "three mistakes",
        "void main() {\n    a = 1.0;\n    float f = true;\n    vec2 v = vec2(1.0, 2.0, 3.0);\n}",
    ),
    ("not ASCII", "void main() { float f = 1.0; /* \u{fc} */ f = \u{fc}; }"),
    ("comment open", "void main() {} /* to the end"),
    ("both outputs", "void main() { gl_FragColor = vec4(1.0); gl_FragData[0] = vec4(1.0); }"),
    (
        "matrix by vector",
        "#version 120\nuniform mat4 m;\nuniform vec3 v;\nvoid main() { gl_FragColor = m * v; }",
    ),
];

#[test]
fn logs() {
    let mut report = String::new();
    for (name, source) in FRAGMENT {
        let compiled = compile(Stage::Fragment, source, &Options::default());
        assert!(compiled.shader.is_none(), "{name} is accepted");
        assert!(compiled.log.is_ascii(), "{name}");
        let _ = writeln!(report, "== {name}\n{}", compiled.log.trim_end());
    }
    insta::assert_snapshot!(report);
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

#[test]
fn link_logs() {
    let mut report = String::new();
    for (name, vertex, fragment) in PAIRS {
        let shaders =
            [(Stage::Vertex, vertex), (Stage::Fragment, fragment)].map(|(stage, source)| {
                let compiled = compile(stage, source, &Options::default());
                compiled.shader.unwrap_or_else(|| panic!("{name}: {}", compiled.log))
            });
        let linked = link(&[&shaders[0], &shaders[1]], &Bindings::default());
        assert!(linked.program.is_none(), "{name} links");
        let _ = writeln!(report, "== {name}\n{}", linked.log.trim_end());
    }
    insta::assert_snapshot!(report);
}

#[test]
fn repairs_are_listed() {
    let source =
        "uniform vec4 color;\nvoid main() {\n    float f = 1\n    gl_FragColor = colour * f;\n}";
    let compiled = compile(Stage::Fragment, source, &Options { repairs: Repairs::On });
    assert!(compiled.shader.is_some(), "{}", compiled.log);
    insta::assert_snapshot!(compiled.log);
}
