//! What a link makes of the names: what can be asked of it, and why it fails.

use super::{capturing, context, fine, log, shading};
use gl_api::*;

const VERTEX: &str = "#version 130\nout vec3 v; flat out uvec2 u[3]; out mat4 m; out vec4 big[40];\n\
    out float unused;\n\
    void main() { v = vec3(1.0); u[0] = uvec2(1u); m = mat4(1.0); big[0] = vec4(0.0);\n\
    gl_Position = vec4(0.0); }";

#[test]
fn what_is_captured_can_be_asked_for() {
    let mut c = context();
    let names = ["v", "u", "u[1]", "m", "gl_Position", "unused"];
    let program = capturing(&mut c, VERTEX, &names, GL_INTERLEAVED_ATTRIBS);
    let mut value = [0];
    for (name, expected) in [
        (GL_TRANSFORM_FEEDBACK_BUFFER_MODE, GL_INTERLEAVED_ATTRIBS as i32),
        (GL_TRANSFORM_FEEDBACK_VARYINGS, 6),
        (GL_TRANSFORM_FEEDBACK_VARYING_MAX_LENGTH, "gl_Position".len() as i32 + 1),
    ] {
        c.get_programiv(program, name, &mut value);
        assert_eq!(value, [expected], "{}", enum_name(name));
    }
    let expected = [
        ("v", 1, GL_FLOAT_VEC3),
        ("u", 3, GL_UNSIGNED_INT_VEC2),
        ("u[1]", 1, GL_UNSIGNED_INT_VEC2),
        ("m", 1, GL_FLOAT_MAT4),
        ("gl_Position", 1, GL_FLOAT_VEC4),
        ("unused", 1, GL_FLOAT),
    ];
    for (index, (name, elements, kind)) in (0..).zip(expected) {
        let (mut length, mut size, mut ty, mut text) = ([0], [0], [0], [0; 32]);
        c.get_transform_feedback_varying(
            program,
            index,
            32,
            &mut length,
            &mut size,
            &mut ty,
            TextOut::Bytes(&mut text),
        );
        assert_eq!(&text[..length[0] as usize], name.as_bytes());
        assert_eq!((size, ty), ([elements], [kind]), "{name}");
    }
    // A later request holds from the next link on.
    c.transform_feedback_varyings(program, 1, Names(vec!["v"]), GL_SEPARATE_ATTRIBS);
    c.get_programiv(program, GL_TRANSFORM_FEEDBACK_VARYINGS, &mut value);
    assert_eq!(value, [6]);
    c.link_program(program);
    c.get_programiv(program, GL_TRANSFORM_FEEDBACK_VARYINGS, &mut value);
    assert_eq!(value, [1]);
    fine(&mut c);
}

#[test]
fn what_cannot_be_captured_fails_the_link() {
    let cases: [(&[&str], GLenum, &str); 9] = [
        (&["nothing"], GL_INTERLEAVED_ATTRIBS, "`nothing`: the vertex shader has no such output"),
        (&["gl_FragColor"], GL_INTERLEAVED_ATTRIBS, "no such output"),
        (&["v", "v"], GL_INTERLEAVED_ATTRIBS, "captures `v` twice"),
        (&["v[0]"], GL_INTERLEAVED_ATTRIBS, "`v[0]`: it is no array"),
        (&["u[3]"], GL_INTERLEAVED_ATTRIBS, "`u[3]`: the array has 3 elements"),
        (&["u[x]"], GL_INTERLEAVED_ATTRIBS, "no such output"),
        (&["big"], GL_INTERLEAVED_ATTRIBS, "captures 160 components for a buffer, at most 128"),
        (&["v", "big"], GL_SEPARATE_ATTRIBS, "captures 160 components for a buffer, at most 128"),
        (&[""], GL_INTERLEAVED_ATTRIBS, "no such output"),
    ];
    for (names, mode, why) in cases {
        let mut c = context();
        let program = shading::use_program(&mut c, VERTEX, "");
        c.transform_feedback_varyings(program, names.len() as i32, Names(names.to_vec()), mode);
        c.link_program(program);
        let mut status = [1];
        c.get_programiv(program, GL_LINK_STATUS, &mut status);
        let log = log(&mut c, program);
        assert_eq!(status, [0], "{names:?}");
        assert!(log.contains(why), "{names:?}: {log}");
    }
    // Without a vertex shader there is nothing to capture.
    let mut c = context();
    let program = shading::use_program(&mut c, "", "void main() { gl_FragColor = vec4(1.0); }");
    let names = Names(vec!["gl_Position"]);
    c.transform_feedback_varyings(program, 1, names, GL_INTERLEAVED_ATTRIBS);
    c.link_program(program);
    assert!(log(&mut c, program).contains("there is no vertex shader"));
}

/// Capturing changes nothing in the picture.
#[test]
fn the_picture_is_the_same_with_and_without() {
    let vertex = "varying vec4 place; varying float extra;\n\
        void main() { place = gl_Vertex; extra = 3.0; gl_Position = gl_Vertex; }";
    let fragment = "varying vec4 place; void main() { gl_FragColor = place * 0.5 + 0.5; }";
    let picture = |names: &[&str]| {
        let mut c = context();
        let program = shading::use_program(&mut c, vertex, fragment);
        let count = names.len() as i32;
        c.transform_feedback_varyings(program, count, Names(names.to_vec()), GL_SEPARATE_ATTRIBS);
        c.link_program(program);
        c.use_program(program);
        c.rectf(-0.7, -0.9, 0.8, 0.6);
        let mut pixels = vec![0; 16 * 16 * 4];
        c.read_pixels(0, 0, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixels));
        fine(&mut c);
        pixels
    };
    let plain = picture(&[]);
    assert!(plain.iter().any(|byte| *byte != 0));
    assert_eq!(picture(&["extra", "place", "gl_Position"]), plain);
}
