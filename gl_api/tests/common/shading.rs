//! Programs of one text a stage.

use gl_api::*;

/// A program of these sources, in use; the fixed function has the stage whose source is empty.
#[track_caller]
pub fn use_program(c: &mut Context, vertex: &str, fragment: &str) -> GLuint {
    use_stages(c, &[(GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, fragment)])
}

/// A program of these stages and sources, in use; there is no shader of a source that is empty.
#[track_caller]
pub fn use_stages(c: &mut Context, stages: &[(GLenum, &str)]) -> GLuint {
    let program = c.create_program();
    for &(stage, source) in stages {
        if !source.is_empty() {
            let shader = c.create_shader(stage);
            c.shader_source(shader, 1, Strings(vec![source]), &[]);
            c.compile_shader(shader);
            c.attach_shader(program, shader);
        }
    }
    c.link_program(program);
    c.use_program(program);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    program
}
