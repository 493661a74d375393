//! GLSL 1.50 and 3.30: which shaders the contexts of GL 3.3 accept, and which programs link.

use gl_api::glsl::{Bindings, ContextLanguage, Options, Shader, Stage, compile, link};
use std::fmt::Write as _;

use ContextLanguage::{Compatibility31, Compatibility33, Core33};
use Stage::{Fragment, Vertex};

/// Compiles for a context.
fn compiled(context: ContextLanguage, stage: Stage, source: &str) -> Result<Shader, String> {
    let compiled = compile(stage, source, &Options { context, ..Options::default() });
    compiled.shader.ok_or(compiled.log)
}

/// Shaders that a context accepts.
const ACCEPTED: &[(ContextLanguage, Stage, &str)] = &[
    (
        Compatibility33,
        Vertex,
        "#version 150 compatibility\nvoid main() { gl_Position = ftransform(); }",
    ),
    (
        Compatibility33,
        Vertex,
        "#version 150\n#extension GL_ARB_compatibility : enable\nvoid main() { gl_Position = gl_Vertex; }",
    ),
    (Compatibility33, Vertex, "#version 140\nvoid main() { gl_Position = gl_Vertex; }"),
    (Compatibility33, Vertex, "#version 110\nvoid main() { gl_Position = gl_Vertex; }"),
    (Core33, Vertex, "#version 150 core\nin vec4 a;\nvoid main() { gl_Position = a; }"),
    (Core33, Fragment, "#version 330\nvoid main() { gl_FragColor = vec4(1.0); }"),
    (
        Core33,
        Fragment,
        "#version 330\nuniform sampler2D t;\nvoid main() { gl_FragColor = texture2D(t, vec2(0.5)); }",
    ),
    // Blocks of inputs, outputs and uniforms
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; flat int b; noperspective float c[2]; } x;\nvoid main() { x.a = vec4(1.0); x.b = 1; x.c[1] = 2.0; }",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { out vec4 a; };\nuniform B { vec4 c; } u[2];\nvoid main() { a = u[1].c; }",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; } x[3];\nvoid main() { for (int i = 0; i < x.length(); i++) x[i].a = vec4(i); }",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout gl_PerVertex { vec4 gl_Position; float gl_ClipDistance[4]; };\nvoid main() { gl_Position = vec4(gl_ClipDistance.length()); }",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nstruct S { vec4 a; };\nin vec4 v[2];\nout S s;\nvoid main() { s.a = v[1]; }",
    ),
    (
        Core33,
        Fragment,
        "#version 330\nlayout(location = 0, index = 1) out vec4 r;\nvoid main() { r = vec4(1.0); }",
    ),
    (
        Core33,
        Fragment,
        "#version 150\nlayout(ORIGIN_upper_left) in vec4 gl_FragCoord;\nvoid main() { gl_FragColor = gl_FragCoord; }",
    ),
    (Core33, Fragment, "#version 100\nvoid main() { gl_FragColor = vec4(1.0); }"),
];

#[test]
fn accepted() {
    let mut wrong = String::new();
    for &(context, stage, source) in ACCEPTED {
        if let Err(log) = compiled(context, stage, source) {
            let _ = writeln!(wrong, "{context:?}: {source}\n{log}");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// Shaders that a context refuses, and words of the log.
const REFUSED: &[(ContextLanguage, Stage, &str, &str)] = &[
    (Compatibility31, Vertex, "#version 150\nvoid main() {}", "GLSL version 150 is not supported"),
    (
        Core33,
        Vertex,
        "#version 130\nvoid main() {}",
        "this context knows the versions 140, 150, 330",
    ),
    (
        Core33,
        Vertex,
        "#version 150 compatibility\nvoid main() {}",
        "this context has no compatibility profile",
    ),
    (Core33, Vertex, "#version 330 es\nvoid main() {}", "`es` is no profile"),
    (Core33, Vertex, "#version 140 core\nvoid main() {}", "unexpected `core` after the version"),
    (
        Core33,
        Vertex,
        "#version 330 core core\nvoid main() {}",
        "unexpected `core` after the version",
    ),
    (Core33, Vertex, "#version 140\nvoid main() { gl_Position = gl_Vertex; }", "`gl_Vertex`"),
    (
        Compatibility33,
        Vertex,
        "#version 150\nvoid main() { gl_Position = gl_Vertex; }",
        "`gl_Vertex`",
    ),
    (
        Compatibility33,
        Vertex,
        "#version 330 core\nvoid main() { gl_Position = ftransform(); }",
        "`ftransform`",
    ),
    (
        Core33,
        Vertex,
        "#version 150\n#extension GL_ARB_compatibility : require\nvoid main() {}",
        "extension `GL_ARB_compatibility` is not supported",
    ),
    // Blocks
    (
        Core33,
        Vertex,
        "#version 140\nout B { vec4 a; };\nvoid main() {}",
        "blocks of inputs and outputs are not in GLSL 1.40",
    ),
    (
        Core33,
        Vertex,
        "#version 140\nuniform B { vec4 a; } b;\nvoid main() {}",
        "a block has no name behind it in GLSL 1.40",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nin B { vec4 a; };\nvoid main() {}",
        "the vertex stage has no blocks of inputs",
    ),
    (
        Core33,
        Fragment,
        "#version 150\nout B { vec4 a; };\nvoid main() {}",
        "the fragment stage has no blocks of outputs",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nflat out B { vec4 a; };\nvoid main() {}",
        "stands `in` or `out` alone",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { uniform vec4 a; };\nvoid main() {}",
        "a second word that says what the variable is for",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a = vec4(1.0); };\nvoid main() {}",
        "takes no value",
    ),
    (Core33, Vertex, "#version 150\nout B { sampler2D s; };\nvoid main() {}", "must be a uniform"),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; } x;\nvoid main() { a = vec4(1.0); }",
        "`a` is not declared",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; } x;\nvoid main() { x.b = vec4(1.0); }",
        "has no member `b`",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; } x[2];\nvoid main() { x.a = vec4(1.0); }",
        "an index is missing",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; } x;\nvoid main() { x[0].a = vec4(1.0); }",
        "no array of them",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; } x;\nvoid main() { x; }",
        "its members have values",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nvec4 B;\nout B { vec4 a; } x;\nvoid main() {}",
        "`B` is declared already",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nuniform B { vec4 a; } u[2];\nuniform int i;\nvoid main() { gl_Position = u[i].a; }",
        "constant expressions only",
    ),
    (Core33, Vertex, "#version 150\nuniform B { vec4 a; } u[];\nvoid main() {}", "needs a size"),
    (
        Core33,
        Vertex,
        "#version 150\nout gl_PerVertex { vec4 gl_Position; };\nvoid main() { gl_PointSize = 1.0; }",
        "is not in the redeclared `gl_PerVertex`",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout gl_PerVertex { vec4 t; };\nvoid main() {}",
        "no member of `gl_PerVertex`",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout gl_PerVertex { vec4 gl_Position; } x;\nvoid main() {}",
        "has no name behind it",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nvoid f() { gl_PointSize = 1.0; }\nout gl_PerVertex { vec4 gl_Position; };\nvoid main() {}",
        "is used before `gl_PerVertex` is redeclared",
    ),
    (
        Core33,
        Fragment,
        "#version 330\nlayout(index = 1) out vec4 r;\nvoid main() { r = vec4(1.0); }",
        "an index stands beside a location",
    ),
    (
        Core33,
        Fragment,
        "#version 330\nlayout(location = 0, index = 2) out vec4 r;\nvoid main() { r = vec4(1.0); }",
        "an index is 0 or 1",
    ),
    (
        Core33,
        Fragment,
        "#version 150\nlayout(origin_upper_left) in vec4 gl_FragCoord;\nin vec4 gl_FragCoord;\nvoid main() {}",
        "another layout in the declaration before",
    ),
];

#[test]
fn refused() {
    let mut wrong = String::new();
    for &(context, stage, source, words) in REFUSED {
        match compiled(context, stage, source) {
            Err(log) if log.contains(words) => {}
            Err(log) => _ = writeln!(wrong, "{context:?}: {source}\nexpected {words:?}:\n{log}"),
            Ok(_) => _ = writeln!(wrong, "{context:?}: {source}\nis accepted"),
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// Vertex and fragment shaders of version 150, and words of the log of their link; no words: they link.
const PAIRS: &[(&str, &str, &str)] = &[
    (
        "out B { vec4 a; flat int b; } x;\nvoid main() { x.a = vec4(1.0); x.b = 2; gl_Position = x.a; }",
        "in B { vec4 a; flat int b; } y;\nout vec4 r;\nvoid main() { r = y.a * y.b; }",
        "",
    ),
    (
        "out B { vec4 a; };\nvoid main() { a = gl_Position = vec4(1.0); }",
        "in B { vec4 a; } y;\nout vec4 r;\nvoid main() { r = y.a; }",
        "",
    ),
    (
        "struct S { vec4 a; float b[2]; };\nout S s;\nvoid main() { s.b[1] = 1.0; gl_Position = vec4(1.0); }",
        "struct S { vec4 a; float b[2]; };\nin S s;\nout vec4 r;\nvoid main() { r = s.a * s.b[1]; }",
        "",
    ),
    (
        "out B { vec4 a; vec4 b; };\nvoid main() { a = b = gl_Position = vec4(1.0); }",
        "in B { vec4 b; vec4 a; };\nout vec4 r;\nvoid main() { r = a; }",
        "the block `B` has other members",
    ),
    (
        "out B { vec4 a; };\nvoid main() { a = gl_Position = vec4(1.0); }",
        "in B { vec4 a; } y[1];\nout vec4 r;\nvoid main() { r = y[0].a; }",
        "the block `B` is an array of instances in one stage only",
    ),
    (
        "out B { vec4 a; };\nvoid main() { a = gl_Position = vec4(1.0); }",
        "in vec4 a;\nout vec4 r;\nvoid main() { r = a; }",
        "reads `a`, which no vertex shader writes",
    ),
    (
        "uniform B { vec4 a; };\nvoid main() { gl_Position = a; }",
        "uniform B { vec4 a; } u;\nout vec4 r;\nvoid main() { r = u.a; }",
        "another layout in another shader",
    ),
    (
        "out B { float f[]; } x;\nvoid main() { x.f[1] = 1.0; gl_Position = vec4(1.0); }",
        "in B { float f[]; } x;\nout vec4 r;\nvoid main() { r = vec4(x.f[2]); }",
        "is float[2] in the vertex shader and float[3] in the fragment shader",
    ),
];

#[test]
fn pairs() {
    let mut wrong = String::new();
    for (vertex, fragment, words) in PAIRS {
        let shaders = [(Vertex, vertex), (Fragment, fragment)].map(|(stage, source)| {
            compiled(Core33, stage, &format!("#version 150\n{source}"))
                .unwrap_or_else(|log| panic!("{source}\n{log}"))
        });
        let linked = link(&[&shaders[0], &shaders[1]], &Bindings::default());
        if linked.program.is_some() != words.is_empty() || !linked.log.contains(words) {
            let _ = writeln!(wrong, "{vertex}\n{fragment}\nexpected {words:?}:\n{}", linked.log);
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// The instances of an array of uniform blocks are blocks; their members are listed once.
#[test]
fn instances_of_uniform_blocks() {
    let source = "#version 150\nuniform B { vec4 a; float b; } u[2];\nvoid main() { gl_Position = u[1].a * u[0].b; }";
    let shader = compiled(Core33, Vertex, source).unwrap_or_else(|log| panic!("{log}"));
    let program = link(&[&shader], &Bindings::default()).program.expect("it links");
    let blocks: Vec<&str> = program.blocks.iter().map(|block| &*block.name).collect();
    let members: Vec<&str> = program.members.iter().map(|member| &*member.name).collect();
    assert_eq!((blocks, members), (vec!["B[0]", "B[1]"], vec!["B.a", "B.b"]));
    assert_eq!(program.blocks[1].word, program.blocks[0].word.map(|word| word + 5));
}
