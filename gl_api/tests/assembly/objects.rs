//! Names, parameters, what can be asked, the attribute stack, display lists.

use super::{PASS, context, drawn, load};
use gl_api::*;

const VERTEX: GLenum = GL_VERTEX_PROGRAM_ARB;
const FRAGMENT: GLenum = GL_FRAGMENT_PROGRAM_ARB;

fn asked(c: &mut Context, target: GLenum, name: GLenum) -> GLint {
    let mut value = [GLint::MIN];
    c.get_assembly_programiv(target, name, &mut value);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{}", enum_name(name));
    value[0]
}

#[test]
fn names_become_programs_when_they_are_bound() {
    let mut c = context();
    let mut names = [0; 3];
    c.gen_programs(3, &mut names);
    assert_eq!(names, [1, 2, 3]);
    assert!(!c.is_assembly_program(2) && !c.is_assembly_program(0));
    c.bind_program(FRAGMENT, 2);
    assert!(c.is_assembly_program(2));
    assert_eq!(asked(&mut c, FRAGMENT, GL_PROGRAM_BINDING_ARB), 2);
    assert_eq!(asked(&mut c, VERTEX, GL_PROGRAM_BINDING_ARB), 0);
    c.bind_program(VERTEX, 2);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    c.delete_programs(3, &[2, 0, 99]);
    assert!(!c.is_assembly_program(2));
    assert_eq!(asked(&mut c, FRAGMENT, GL_PROGRAM_BINDING_ARB), 0);
    c.bind_program(VERTEX, 2);
    assert_eq!(c.get_error(), GL_NO_ERROR);
}

#[test]
fn local_parameters_are_the_programs_and_those_of_the_environment_all_programs_of_a_target() {
    let mut c = context();
    for (name, value) in [(0, 1.0), (1, 2.0)] {
        c.bind_program(FRAGMENT, name);
        load(&mut c, "!!ARBfp1.0\nADD result.color, program.local[1], program.env[1];\nEND");
        c.program_local_parameter_4fv(FRAGMENT, 1, &[value; 4]);
    }
    c.program_env_parameter_4fv(FRAGMENT, 1, &[4.0; 4]);
    c.program_env_parameter_4fv(VERTEX, 1, &[9.0; 4]);
    assert_eq!(drawn(&mut c), [6.0; 4]);
    c.bind_program(FRAGMENT, 0);
    assert_eq!(drawn(&mut c), [5.0; 4]);
    let (mut floats, mut doubles) = ([0.0; 4], [0.0; 4]);
    c.get_program_local_parameterfv(FRAGMENT, 1, &mut floats);
    c.get_program_env_parameterdv(FRAGMENT, 1, &mut doubles);
    assert_eq!((floats, doubles), ([1.0; 4], [4.0; 4]));
    c.get_program_env_parameterfv(VERTEX, 1, &mut floats);
    c.get_program_local_parameterdv(FRAGMENT, 2, &mut doubles);
    assert_eq!((floats, doubles), ([9.0; 4], [0.0; 4]));
}

#[test]
fn several_parameters_are_set_at_once() {
    let mut c = context();
    let numbers: Vec<f32> = (0..12).map(|i| i as f32).collect();
    c.program_env_parameters_4fv(VERTEX, 254, 2, &numbers);
    let mut found = [0.0; 4];
    c.get_program_env_parameterfv(VERTEX, 255, &mut found);
    assert_eq!((c.get_error(), found), (GL_NO_ERROR, [4.0, 5.0, 6.0, 7.0]));
    c.program_env_parameters_4fv(VERTEX, 254, 3, &numbers);
    assert_eq!(c.get_error(), GL_INVALID_VALUE);
}

#[test]
fn what_a_program_takes_is_counted() {
    let text = "!!ARBfp1.0\nATTRIB unused = fragment.position;\nPARAM p[2] = { 1, 2 };\n\
        TEMP a, b;\nTEX a, fragment.texcoord[0], texture[0], 2D;\nADD a, a, 0.5;\nADD a, a, 0.5;\n\
        TEX b, fragment.texcoord[1], texture[1], 2D;\nTEX b, a, texture[2], 2D;\n\
        TEX a, fragment.texcoord[1], texture[3], 2D;\nKIL b;\n\
        MUL result.color, a, b;\nEND";
    let mut c = context();
    assert_eq!(asked(&mut c, FRAGMENT, GL_PROGRAM_LENGTH_ARB), 0);
    load(&mut c, text);
    for (name, value) in [
        (GL_PROGRAM_LENGTH_ARB, text.len() as GLint),
        (GL_PROGRAM_FORMAT_ARB, GL_PROGRAM_FORMAT_ASCII_ARB as GLint),
        (GL_PROGRAM_INSTRUCTIONS_ARB, 8),
        (GL_PROGRAM_ALU_INSTRUCTIONS_ARB, 3),
        (GL_PROGRAM_TEX_INSTRUCTIONS_ARB, 5),
        (GL_PROGRAM_TEX_INDIRECTIONS_ARB, 3),
        (GL_PROGRAM_TEMPORARIES_ARB, 2),
        (GL_PROGRAM_PARAMETERS_ARB, 3),
        (GL_PROGRAM_ATTRIBS_ARB, 3),
        (GL_PROGRAM_ADDRESS_REGISTERS_ARB, 0),
        (GL_PROGRAM_NATIVE_INSTRUCTIONS_ARB, 8),
        (GL_PROGRAM_UNDER_NATIVE_LIMITS_ARB, 1),
        (GL_MAX_PROGRAM_ADDRESS_REGISTERS_ARB, 0),
        (GL_MAX_PROGRAM_ENV_PARAMETERS_ARB, 256),
    ] {
        assert_eq!(asked(&mut c, FRAGMENT, name), value, "{}", enum_name(name));
    }
    let mut written = vec![b'?'; text.len() + 2];
    c.get_program_string(FRAGMENT, GL_PROGRAM_STRING_ARB, written.as_mut_slice().arg());
    assert_eq!(written, format!("{text}??").into_bytes());
    assert_eq!(asked(&mut c, VERTEX, GL_MAX_PROGRAM_ADDRESS_REGISTERS_ARB), 1);
    c.get_assembly_programiv(VERTEX, GL_PROGRAM_TEX_INDIRECTIONS_ARB, &mut [0]);
    assert_eq!(c.get_error(), GL_INVALID_ENUM);
}

#[test]
fn the_current_matrix_is_that_of_the_mode() {
    let mut c = context();
    c.matrix_mode(GL_MATRIX5_ARB);
    c.translatef(1.0, 2.0, 3.0);
    for _ in 1..4 {
        c.push_matrix();
    }
    c.push_matrix();
    assert_eq!(c.get_error(), GL_STACK_OVERFLOW);
    let (mut matrix, mut depth) = ([0.0; 16], [0]);
    c.get_floatv(GL_CURRENT_MATRIX_ARB, &mut matrix);
    assert_eq!(matrix[12..], [1.0, 2.0, 3.0, 1.0]);
    c.get_floatv(GL_TRANSPOSE_CURRENT_MATRIX_ARB, &mut matrix);
    assert_eq!([matrix[3], matrix[7], matrix[11]], [1.0, 2.0, 3.0]);
    c.get_integerv(GL_CURRENT_MATRIX_STACK_DEPTH_ARB, &mut depth);
    assert_eq!(depth, [4]);
    c.matrix_mode(GL_MODELVIEW);
    c.get_floatv(GL_CURRENT_MATRIX_ARB, &mut matrix);
    assert_eq!((c.get_error(), matrix[12]), (GL_NO_ERROR, 0.0));
}

#[test]
fn what_is_enabled_is_of_the_attribute_stack() {
    let mut c = context();
    let all = [VERTEX, FRAGMENT, GL_VERTEX_PROGRAM_TWO_SIDE, GL_VERTEX_PROGRAM_POINT_SIZE];
    c.push_attrib(GL_ENABLE_BIT);
    for cap in all {
        c.enable(cap);
        assert!(c.is_enabled(cap));
    }
    c.pop_attrib();
    assert!(all.iter().all(|cap| !c.is_enabled(*cap)));
}

#[test]
fn lists_keep_texts_bindings_and_parameters() {
    let mut c = context();
    c.new_list(1, GL_COMPILE);
    c.bind_program(FRAGMENT, 5);
    let text = "!!ARBfp1.0\nMOV result.color, program.local[0];\nEND";
    c.program_string(FRAGMENT, GL_PROGRAM_FORMAT_ASCII_ARB, text.len() as GLsizei, text);
    c.program_local_parameter_4f(FRAGMENT, 0, 1.0, 2.0, 3.0, 4.0);
    // Names are made at once.
    let mut name = [0];
    c.gen_programs(1, &mut name);
    c.end_list();
    assert_eq!(name, [1]);
    assert!(!c.is_assembly_program(5));
    load(&mut c, PASS);
    c.call_list(1);
    assert_eq!(drawn(&mut c), [1.0, 2.0, 3.0, 4.0]);
    assert_eq!(asked(&mut c, FRAGMENT, GL_PROGRAM_BINDING_ARB), 5);
}
