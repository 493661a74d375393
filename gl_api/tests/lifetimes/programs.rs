//! Programs that are deleted while a context uses them: GL 2.1, section 2.15.2.

use super::{color_of, context, fine, integer, quad, shading, sharing};
use gl_api::*;

const RED: &str = "void main() { gl_FragColor = vec4(1.0, 0.0, 0.0, 1.0); }";

fn red(c: &mut Context) -> bool {
    color_of(c, quad) == [255, 0, 0, 255]
}

fn is_flagged(c: &mut Context, program: GLuint) -> bool {
    let mut status = [0];
    c.get_programiv(program, GL_DELETE_STATUS, &mut status);
    fine(c);
    status[0] == 1
}

/// While it is part of the state of any context, it is only flagged.
#[test]
fn a_program_in_use_anywhere_keeps_its_name() {
    let mut a = context();
    let mut b = sharing(&mut a);
    let program = shading::use_program(&mut b, "", RED);
    a.delete_program(program);
    assert!(a.is_program(program) && is_flagged(&mut a, program));
    assert!(red(&mut b));
    assert_eq!(integer(&mut b, GL_CURRENT_PROGRAM), program);
    // Twice is no more than once.
    a.delete_program(program);
    fine(&mut a);
    // It goes when the last context lets go of it.
    a.use_program(program);
    b.use_program(0);
    assert!(b.is_program(program) && red(&mut a));
    a.use_program(0);
    assert!(!a.is_program(program) && !b.is_program(program));
    fine(&mut b);
}

#[test]
fn a_context_that_goes_lets_go_of_its_program() {
    let mut a = context();
    let mut b = sharing(&mut a);
    let program = shading::use_program(&mut b, "", RED);
    let mut shader = [0];
    b.get_attached_shaders(program, 1, &mut [], &mut shader);
    b.delete_shader(shader[0]);
    a.delete_program(program);
    assert!(a.is_program(program) && a.is_shader(shader[0]));
    drop(b);
    assert!(!a.is_program(program) && !a.is_shader(shader[0]));
    fine(&mut a);
}

/// A link that fails leaves it what it was wherever it is in use.
#[test]
fn a_failed_link_leaves_others_what_they_use() {
    let mut a = context();
    let mut b = sharing(&mut a);
    let program = shading::use_program(&mut b, "", RED);
    let mut shader = [0];
    a.get_attached_shaders(program, 1, &mut [], &mut shader);
    a.shader_source(shader[0], 1, Strings(vec!["void main() { undeclared = 1; }"]), &[]);
    a.compile_shader(shader[0]);
    a.link_program(program);
    assert!(red(&mut b));
    b.use_program(0);
    b.use_program(program);
    assert_eq!(b.get_error(), GL_INVALID_OPERATION);
}
