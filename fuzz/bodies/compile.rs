//! Compiles any text as a shader, for the fuzz target `compile` and the tests of hostile shaders.

use gl_api::glsl::{Bindings, FixIts, Options, Stage, compile, link};

/// Compiles a text as either stage, with fix-its applied and without, and links the result.
pub fn compile_and_link(source: &str) {
    for fix_its in [FixIts::Suggest, FixIts::Apply] {
        for stage in [Stage::Vertex, Stage::Fragment] {
            let result = compile(stage, source, &Options { fix_its, ..Options::default() });
            if let Some(shader) = result.shader {
                link(&[&shader], &Bindings::default());
            }
        }
    }
}
