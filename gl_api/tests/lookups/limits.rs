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

/// A texture of one texel at each of the first units, red as the unit's number times ten.
fn numbered_units(count: u8) {
    for unit in 0..count {
        glActiveTexture(GL_TEXTURE0 + u32::from(unit));
        glBindTexture(GL_TEXTURE_2D, 1 + u32::from(unit));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        let texel = [10 * unit, 0, 0, 255];
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texel);
    }
}

/// Of an array of structures, the samplers count that an index can choose, not what is beside them.
#[test]
fn samplers_in_structures_are_chosen_by_index() {
    let _current = context();
    numbered_units(8);
    let look = "texture2D(l[k].t, vec2(0.5))";
    // Declarations, the lookup, and the names of the samplers by k.
    let rows: [(&str, &str, &[&str]); 4] = [
        (
            "struct L { vec4 c; sampler2D t; float f; }; uniform L l[3];",
            look,
            &["l[0].t", "l[1].t", "l[2].t"],
        ),
        (
            "struct L { mat4 c[4]; sampler2D t; }; uniform L l[4];",
            "l[k].c[0][0] + texture2D(l[k].t, vec2(0.5))",
            &["l[0].t", "l[1].t", "l[2].t", "l[3].t"],
        ),
        (
            "struct L { float f; sampler2D t[2]; }; uniform L l[3];",
            "texture2D(l[k / 2].t[k - k / 2 * 2], vec2(0.5))",
            &["l[0].t[0]", "l[0].t[1]", "l[1].t[0]", "l[1].t[1]", "l[2].t[0]", "l[2].t[1]"],
        ),
        (
            "struct L { sampler2D a; float f; sampler2D t; }; struct M { float f; L l[2]; }; \
             uniform M m[2];",
            "texture2D(m[k].l[1].t, vec2(0.5)) + 0.0 * texture2D(m[0].l[k].a, vec2(0.5))",
            &["m[0].l[1].t", "m[1].l[1].t"],
        ),
    ];
    for (declarations, lookup, names) in rows {
        let uniform =
            format!("{declarations} uniform int k; void main() {{ gl_FragColor = {lookup}; }}");
        let program = program(VERTEX, &uniform).unwrap_or_else(|log| panic!("{log}"));
        glUseProgram(program);
        for (unit, name) in (1..).zip(names) {
            glUniform1i(glGetUniformLocation(program, *name), unit);
        }
        for k in 0..names.len() as u8 {
            glUniform1i(glGetUniformLocation(program, "k"), i32::from(k));
            assert_eq!(drawn(program), [10 * (k + 1), 0, 0, 255], "{declarations} {k}");
        }
        assert_eq!(glGetError(), GL_NO_ERROR);
    }
    // By the variable of a loop, as programs with several lights do.
    let fragment = "struct L { vec4 c; sampler2D t; float f; }; uniform L l[3];
void main() { vec4 r = vec4(0.0); for (int k = 0; k < 3; ++k) r += texture2D(l[k].t, vec2(0.5));
gl_FragColor = r; }";
    let program = program(VERTEX, fragment).unwrap_or_else(|log| panic!("{log}"));
    glUseProgram(program);
    for (unit, name) in (1..).zip(["l[0].t", "l[1].t", "l[2].t"]) {
        glUniform1i(glGetUniformLocation(program, name), unit);
    }
    assert_eq!(drawn(program), [60, 0, 0, 255]);
}

#[test]
fn more_samplers_than_can_be_chosen_from_are_refused_by_number() {
    let _current = context();
    let fragment = "struct L { sampler2D t[6]; }; uniform L l[6]; uniform int k;
void main() { gl_FragColor = texture2D(l[k].t[k], vec2(0.5)); }";
    let log = program(VERTEX, fragment).expect_err("36 are too many");
    assert!(log.contains("one of 36 samplers, indexed by what is not constant"), "{log}");
}

#[test]
fn every_unit_can_be_sampled() {
    let _current = context();
    let fragment = "uniform sampler2D s; void main() { gl_FragColor = texture2D(s, vec2(0.5)); }";
    let program = program(VERTEX, fragment).unwrap();
    glUseProgram(program);
    for unit in 0..48_u8 {
        glActiveTexture(GL_TEXTURE0 + u32::from(unit));
        glBindTexture(GL_TEXTURE_2D, 1 + u32::from(unit));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[unit; 4]);
    }
    for unit in 0..48_u8 {
        glUniform1i(glGetUniformLocation(program, "s"), unit);
        assert_eq!(drawn(program), [unit; 4]);
    }
    glUniform1i(glGetUniformLocation(program, "s"), 48);
    assert_eq!(glGetError(), GL_INVALID_VALUE);
    glActiveTexture(GL_TEXTURE0 + 48);
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
