//! How many samplers a program may use, and which may share a unit (GL 2.1, section 2.15.3).

use super::{context, drawn, program};
use gl_api::*;

const VERTEX: &str = "void main() { gl_Position = gl_Vertex; }";

fn sum_of(count: u32) -> String {
    format!(
        "uniform sampler2D s[{count}];
void main() {{ vec4 r = vec4(0.0); for (int i = 0; i < {count}; ++i) r += texture2D(s[i], vec2(0.5));
gl_FragColor = r; }}"
    )
}

#[test]
fn a_stage_has_sixteen_samplers() {
    let _current = context();
    assert!(program(VERTEX, &sum_of(16)).is_ok());
    let log = program(VERTEX, &sum_of(17)).expect_err("17 are too many");
    assert!(log.contains("17 samplers; a stage has 16"), "{log}");
}

#[test]
fn every_unit_can_be_sampled() {
    let _current = context();
    let fragment = "uniform sampler2D s; void main() { gl_FragColor = texture2D(s, vec2(0.5)); }";
    let program = program(VERTEX, fragment).unwrap();
    glUseProgram(program);
    for unit in 0..32_u8 {
        glActiveTexture(GL_TEXTURE0 + u32::from(unit));
        glBindTexture(GL_TEXTURE_2D, 1 + u32::from(unit));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[unit; 4]);
    }
    for unit in 0..32_u8 {
        glUniform1i(glGetUniformLocation(program, "s"), unit);
        assert_eq!(drawn(program), [unit; 4]);
    }
    glUniform1i(glGetUniformLocation(program, "s"), 32);
    assert_eq!(glGetError(), GL_INVALID_VALUE);
    glActiveTexture(GL_TEXTURE0 + 32);
    assert_eq!(glGetError(), GL_INVALID_ENUM);
    // A unit that is for images alone has no coordinates.
    for call in [
        || glEnable(GL_TEXTURE_2D),
        || {
            glMatrixMode(GL_TEXTURE);
            glLoadIdentity();
        },
        || glGetFloatv(GL_CURRENT_TEXTURE_COORDS, &mut [0.0; 4]),
        || glGetFloatv(GL_TEXTURE_MATRIX, &mut [0.0; 16]),
    ] {
        call();
        assert_eq!(glGetError(), GL_INVALID_OPERATION);
    }
}

#[test]
fn a_unit_has_samplers_of_one_type() {
    let _current = context();
    let fragment = "uniform sampler2D flatOne; uniform samplerCube cubic;
void main() { gl_FragColor = texture2D(flatOne, vec2(0.5)) + textureCube(cubic, vec3(1.0)); }";
    let program = program(VERTEX, fragment).unwrap();
    drawn(program);
    assert_eq!(glGetError(), GL_INVALID_OPERATION);
    glUniform1i(glGetUniformLocation(program, "cubic"), 1);
    drawn(program);
    assert_eq!(glGetError(), GL_NO_ERROR);
}

#[test]
fn integer_and_float_samplers_are_of_different_types() {
    let _current = context();
    let fragment = "#version 130
uniform sampler2D a; uniform isampler2D b;
void main() { gl_FragColor = texture(a, vec2(0.5)) + vec4(texture(b, vec2(0.5))); }";
    let program = program(VERTEX, fragment).unwrap();
    drawn(program);
    assert_eq!(glGetError(), GL_INVALID_OPERATION);
}
