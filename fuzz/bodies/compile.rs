//! Compiles any text as a shader, for the fuzz target `compile` and the tests of hostile shaders.

use gl_api::glsl::{Bindings, Options, Repairs, Stage, compile, link};

/// Compiles a text as either stage, with repairs and without, and links the result.
pub fn compile_and_link(source: &str) {
    for repairs in [Repairs::Off, Repairs::On] {
        for stage in [Stage::Vertex, Stage::Fragment] {
            let result = compile(stage, source, &Options { repairs });
            if let Some(shader) = result.shader {
                link(&[&shader], &Bindings::default());
            }
        }
    }
}
