//! GLSL 1.50 and 3.30: which shaders the contexts of GL 3.3 accept, and which programs link.

use gl_api::glsl::{ContextLanguage, Options, Shader, Stage, compile};
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
    (Core33, Vertex, "#version 120\nvoid main() { gl_Position = gl_Vertex; }"),
    (Core33, Vertex, "#version 150 core\nin vec4 a;\nvoid main() { gl_Position = a; }"),
    (Core33, Fragment, "#version 330\nvoid main() { gl_FragColor = vec4(1.0); }"),
    (
        Core33,
        Fragment,
        "#version 330\nuniform sampler2D t;\nvoid main() { gl_FragColor = texture2D(t, vec2(0.5)); }",
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
