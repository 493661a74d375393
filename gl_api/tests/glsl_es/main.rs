//! GLSL ES 1.00 and 3.00 in contexts of OpenGL ES: which shaders are accepted, by section of the specification.

mod limits;
mod links;
mod rows_100;
mod rows_300;

use gl_api::glsl::{ContextLanguage, Options, Stage, Strictness, compile};
use rows_100::{EXTENDED_100, ROWS_100};
use rows_300::ROWS_300;
use std::fmt::Write as _;

use Stage::{Fragment, Vertex};

/// Whether a shader is accepted.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Expected {
    /// It is.
    Accepted,
    /// It is not.
    Refused,
}

use Expected::{Accepted, Refused};

/// The section, the stage, what is expected, and the shader behind its first lines.
pub type Row = (&'static str, Stage, Expected, &'static str);

/// The first lines of a shader of GLSL ES 3.00.
const HEADER_300: &str = "#version 300 es\nprecision mediump float;\n";
/// Those of one of GLSL ES 1.00.
const HEADER_100: &str = "precision mediump float;\n";

fn check(header: &str, rows: &[Row], wrong: &mut String) {
    let options = Options { context: ContextLanguage::Es30, ..Options::default() };
    for (section, stage, expected, body) in rows {
        let compiled = compile(*stage, &format!("{header}{body}\n"), &options);
        if compiled.shader.is_some() != (*expected == Accepted) {
            let what = if *expected == Accepted { "refused" } else { "accepted" };
            let _ = writeln!(wrong, "{section}: {what}: {body}\n{}", compiled.log);
        }
    }
}

#[test]
fn shaders_are_accepted_as_the_specification_says() {
    let mut wrong = String::new();
    check(HEADER_300, ROWS_300, &mut wrong);
    check(HEADER_100, ROWS_100, &mut wrong);
    check("#version 100\n#line 1\nprecision mediump float;\n", ROWS_100, &mut wrong);
    for (extension, row) in EXTENDED_100 {
        let header = format!("#extension {extension} : require\n{HEADER_100}");
        check(&header, &[*row], &mut wrong);
        check(HEADER_100, &[(extension, row.1, Refused, row.3)], &mut wrong);
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// Defaults of precision: none of floats in the fragment stage (section 4.5.4), and only within their scope.
#[test]
fn floats_of_the_fragment_stage_need_a_precision() {
    let mut wrong = String::new();
    for header in ["", "#version 300 es\n"] {
        let rows: &[Row] = &[
            ("4.5.4", Fragment, Refused, "uniform float a;\nvoid main() {}"),
            ("4.5.4", Fragment, Refused, "void main() { vec2 a; }"),
            ("4.5.4", Fragment, Refused, "struct S { float a; };\nvoid main() {}"),
            ("4.5.4", Fragment, Accepted, "struct S { lowp float a; };\nvoid main() {}"),
            ("4.5.4", Fragment, Refused, "float f() { return 1.0; }\nvoid main() {}"),
            ("4.5.4", Fragment, Refused, "void main() { { precision lowp float; } float a; }"),
            ("4.5.4", Fragment, Accepted, "uniform lowp float a;\nvoid main() { int i = 1; }"),
            ("4.5.4", Vertex, Accepted, "uniform float a;\nvoid main() { gl_Position = vec4(a); }"),
        ];
        check(header, rows, &mut wrong);
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// `#version 300 es` stands first; other versions are OpenGL's.
#[test]
fn versions_of_opengl_es() {
    let mut wrong = String::new();
    let rows: &[Row] = &[
        ("3.3", Vertex, Accepted, "#version 100\nvoid main() {}"),
        ("3.3", Vertex, Accepted, "#version 300 es\nvoid main() {}"),
        ("3.3", Vertex, Refused, "#version 300\nvoid main() {}"),
        ("3.3", Vertex, Refused, "#version 100 es\nvoid main() {}"),
        ("3.3", Vertex, Refused, "#version 0100\nvoid main() {}"),
        ("9", Vertex, Refused, ""),
        ("9", Vertex, Refused, "#version 300 es\n// Nothing but a comment\n#define A 1"),
        ("9", Vertex, Accepted, "#version 300 es\nint a;"),
        ("3.3", Vertex, Refused, "#version 310 es\nvoid main() {}"),
        ("3.3", Vertex, Refused, "#version 330\nvoid main() {}"),
        ("3.3", Vertex, Refused, "precision highp float;\n#version 300 es\nvoid main() {}"),
        ("3.3", Vertex, Refused, "#version 300 es core\nvoid main() {}"),
    ];
    check("", rows, &mut wrong);
    assert!(wrong.is_empty(), "{wrong}");
}

/// A name of GLSL ES 3.00 has at most 1024 characters (section 3.8); the other versions set no limit.
#[test]
fn lengths_of_names() {
    let mut wrong = String::new();
    let name = |length| "n".repeat(length);
    for declared in
        ["int NAME;", "struct S { int NAME; };", "struct NAME { int a; };", "void NAME() {}"]
    {
        for (version, length, expected) in [
            ("#version 300 es\n", 1024, Accepted),
            ("#version 300 es\n", 1025, Refused),
            ("", 1025, Accepted),
        ] {
            let text = format!("{}\nvoid main() {{}}", declared.replace("NAME", &name(length)));
            let options = Options { context: ContextLanguage::Es30, ..Options::default() };
            let compiled = compile(Vertex, &format!("{version}{text}"), &options);
            if compiled.shader.is_some() != (expected == Accepted) {
                let _ = writeln!(wrong, "{version}{declared}, {length}: {}", compiled.log);
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// Without `GL_EXT_draw_buffers` there is one colour by the text, and all that there are in drivers.
#[test]
fn colours_beyond_the_first_are_accepted_with_a_warning() {
    let compiled = |header: &str, index: u32, strictness| {
        let options = Options { context: ContextLanguage::Es30, strictness, ..Options::default() };
        let body =
            format!("{header}{HEADER_100}void main() {{ gl_FragData[{index}] = vec4(1.0); }}");
        compile(Fragment, &body, &options)
    };
    let with = "#extension GL_EXT_draw_buffers : require\n";
    for strictness in [Strictness::Lenient, Strictness::Strict] {
        assert_eq!(compiled("", 0, strictness).log, "");
        let found = compiled(with, 7, strictness);
        assert!(found.shader.is_some() && found.log.is_empty(), "{}", found.log);
        assert!(compiled(with, 8, strictness).shader.is_none());
        assert!(compiled("", 8, strictness).shader.is_none());
        let found = compiled("", 7, strictness);
        assert_eq!(found.shader.is_some(), strictness == Strictness::Lenient, "{}", found.log);
        assert!(found.log.contains("#extension GL_EXT_draw_buffers"), "{}", found.log);
    }
}
