//! The limits that a shader reads are those that `glGet` answers.

use gl_api::glsl::{ContextLanguage, Options, Stage, compile};
use gl_api::*;

/// A constant of GLSL ES 3.00, what `glGet` has it as, and how many of that are one of the constant
/// (GLSL ES 3.00 section 7.3, OpenGL ES 3.0 tables 6.32 to 6.35).
const CONSTANTS: [(&str, GLenum, GLint); 11] = [
    ("gl_MaxVertexAttribs", GL_MAX_VERTEX_ATTRIBS, 1),
    ("gl_MaxVertexUniformVectors", GL_MAX_VERTEX_UNIFORM_VECTORS, 1),
    ("gl_MaxFragmentUniformVectors", GL_MAX_FRAGMENT_UNIFORM_VECTORS, 1),
    ("gl_MaxVertexOutputVectors", GL_MAX_VERTEX_OUTPUT_COMPONENTS, 4),
    ("gl_MaxFragmentInputVectors", GL_MAX_FRAGMENT_INPUT_COMPONENTS, 4),
    ("gl_MaxTextureImageUnits", GL_MAX_TEXTURE_IMAGE_UNITS, 1),
    ("gl_MaxVertexTextureImageUnits", GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS, 1),
    ("gl_MaxCombinedTextureImageUnits", GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, 1),
    ("gl_MaxDrawBuffers", GL_MAX_DRAW_BUFFERS, 1),
    ("gl_MinProgramTexelOffset", GL_MIN_PROGRAM_TEXEL_OFFSET, 1),
    ("gl_MaxProgramTexelOffset", GL_MAX_PROGRAM_TEXEL_OFFSET, 1),
];

#[test]
fn constants_are_what_gl_get_answers() {
    let version = Version::new(3, 0);
    let desc = ContextDesc { api: Api::Es2, version, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a device");
    let options = Options { context: ContextLanguage::Es30, ..Options::default() };
    for (name, pname, each) in CONSTANTS {
        let mut value = [GLint::MIN];
        c.get_integerv(pname, &mut value);
        // The size 0 of an array is an error.
        let text = format!(
            "#version 300 es\nint a[{name} == {} ? 1 : 0];\nvoid main() {{}}\n",
            value[0] / each
        );
        let compiled = compile(Stage::Vertex, &text, &options);
        assert!(compiled.shader.is_some(), "{name}: {text}\n{}", compiled.log);
    }
    assert_eq!(c.get_error(), GL_NO_ERROR);
}
