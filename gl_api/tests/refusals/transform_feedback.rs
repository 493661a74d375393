//! What the calls of transform feedback refuse (GL 3.0, section 2.15).

use super::row;
use gl_api::*;

/// The preparation, the call, the error flag that it must set, and words that its message must have.
type Case = (fn(&mut Context), fn(&mut Context), GLenum, &'static str);

const TARGET: GLenum = GL_TRANSFORM_FEEDBACK_BUFFER;

/// With program 1, which captures two varyings in buffers of their own, and buffers 1 and 2.
fn ready() -> Context {
    let mut c = super::context();
    let program = c.create_program();
    let shader = c.create_shader(GL_VERTEX_SHADER);
    let vertex = "varying vec2 a; varying vec2 b;\n\
        void main() { a = vec2(1.0); b = vec2(2.0); gl_Position = vec4(0.0); }";
    c.shader_source(shader, 1, Strings(vec![vertex]), &[]);
    c.compile_shader(shader);
    c.attach_shader(program, shader);
    c.transform_feedback_varyings(program, 2, Names(vec!["a", "b"]), GL_SEPARATE_ATTRIBS);
    c.link_program(program);
    c.use_program(program);
    for name in [1, 2] {
        c.bind_buffer_base(TARGET, name - 1, name);
        c.buffer_data(TARGET, 64, Data::Null, GL_DYNAMIC_READ);
    }
    assert_eq!((program, c.get_error()), (1, GL_NO_ERROR), "{:?}", c.messages());
    c
}

fn nothing(_: &mut Context) {}

fn active(c: &mut Context) {
    c.begin_transform_feedback(GL_POINTS);
}

fn varying(c: &mut Context, program: GLuint, index: GLuint) {
    let (mut length, mut size, mut ty, mut text) = ([0], [0], [0], [0; 8]);
    let name = TextOut::Bytes(&mut text);
    c.get_transform_feedback_varying(program, index, 8, &mut length, &mut size, &mut ty, name);
}

fn begin(c: &mut Context) {
    c.begin_transform_feedback(GL_POINTS);
}

fn point(c: &mut Context) {
    c.draw_arrays(GL_POINTS, 0, 2);
}

/// Object 1 is bound.
fn object(c: &mut Context) {
    c.gen_transform_feedbacks(1, &mut [0]);
    c.bind_transform_feedback(GL_TRANSFORM_FEEDBACK, 1);
    for name in [1, 2] {
        c.bind_buffer_base(TARGET, name - 1, name);
    }
}

/// Object 1 captures, and is paused.
fn paused(c: &mut Context) {
    object(c);
    active(c);
    c.pause_transform_feedback();
}

const ROWS: &[Case] = &[
    (nothing, |c| c.gen_transform_feedbacks(-1, &mut []), GL_INVALID_VALUE, "n = -1"),
    (nothing, |c| c.delete_transform_feedbacks(-1, &[]), GL_INVALID_VALUE, "n = -1"),
    (
        paused,
        |c| c.delete_transform_feedbacks(1, &[1]),
        GL_INVALID_OPERATION,
        "call glEndTransformFeedback",
    ),
    (nothing, |c| c.bind_transform_feedback(TARGET, 0), GL_INVALID_ENUM, "target"),
    (
        nothing,
        |c| c.bind_transform_feedback(GL_TRANSFORM_FEEDBACK, 7),
        GL_INVALID_OPERATION,
        "glGenTransformFeedbacks",
    ),
    (
        active,
        |c| c.bind_transform_feedback(GL_TRANSFORM_FEEDBACK, 0),
        GL_INVALID_OPERATION,
        "glPauseTransformFeedback",
    ),
    (nothing, |c| c.pause_transform_feedback(), GL_INVALID_OPERATION, "glBeginTransformFeedback"),
    (paused, |c| c.pause_transform_feedback(), GL_INVALID_OPERATION, "paused already"),
    (
        active,
        |c| c.resume_transform_feedback(),
        GL_INVALID_OPERATION,
        "glPauseTransformFeedback is missing",
    ),
    (
        |c| {
            paused(c);
            c.use_program(0);
        },
        |c| c.resume_transform_feedback(),
        GL_INVALID_OPERATION,
        "program 1 was",
    ),
    (paused, |c| c.link_program(1), GL_INVALID_OPERATION, "call glEndTransformFeedback first"),
    (paused, begin, GL_INVALID_OPERATION, "glEndTransformFeedback is missing"),
    (nothing, |c| c.draw_transform_feedback(GL_POINTS, 7), GL_INVALID_VALUE, "id = 7"),
    (object, |c| c.draw_transform_feedback(GL_POINTS, 1), GL_INVALID_OPERATION, "captured nothing"),
    (nothing, |c| c.begin_transform_feedback(GL_TRIANGLE_STRIP), GL_INVALID_ENUM, "must be"),
    (
        nothing,
        |c| c.end_transform_feedback(),
        GL_INVALID_OPERATION,
        "glBeginTransformFeedback is missing",
    ),
    (|c| c.use_program(0), begin, GL_INVALID_OPERATION, "call glUseProgram"),
    (
        |c| c.bind_buffer_base(TARGET, 1, 0),
        begin,
        GL_INVALID_OPERATION,
        "no buffer is bound to index 1",
    ),
    (|c| c.delete_buffers(1, &[1]), begin, GL_INVALID_OPERATION, "no buffer is bound to index 0"),
    (
        |c| {
            c.transform_feedback_varyings(1, 0, Names(vec![]), GL_SEPARATE_ATTRIBS);
            c.link_program(1);
        },
        begin,
        GL_INVALID_OPERATION,
        "captures nothing",
    ),
    (
        nothing,
        |c| c.bind_buffer_base(GL_ARRAY_BUFFER, 0, 1),
        GL_INVALID_ENUM,
        "GL_TRANSFORM_FEEDBACK_BUFFER",
    ),
    (nothing, |c| c.bind_buffer_base(TARGET, 4, 1), GL_INVALID_VALUE, "index = 4 must be below"),
    (nothing, |c| c.bind_buffer_range(TARGET, 0, 1, 2, 4), GL_INVALID_VALUE, "offset = 2 must be"),
    (
        nothing,
        |c| c.bind_buffer_range(TARGET, 0, 1, -4, 4),
        GL_INVALID_VALUE,
        "offset = -4 must be",
    ),
    (
        nothing,
        |c| c.bind_buffer_range(TARGET, 0, 1, 0, 0),
        GL_INVALID_VALUE,
        "size = 0 must be at least 4",
    ),
    (nothing, |c| c.bind_buffer_range(TARGET, 0, 1, 0, 6), GL_INVALID_VALUE, "size = 6 must be"),
    (
        nothing,
        |c| c.bind_buffer_offset_ext(GL_UNIFORM_BUFFER, 0, 1, 0),
        GL_INVALID_ENUM,
        "target = GL_UNIFORM_BUFFER must be GL_TRANSFORM_FEEDBACK_BUFFER",
    ),
    (
        nothing,
        |c| c.bind_buffer_offset_ext(TARGET, 0, 1, 3),
        GL_INVALID_VALUE,
        "offset = 3 must be",
    ),
    (
        nothing,
        |c| c.transform_feedback_varyings(1, 1, Names(vec!["a"]), GL_POINTS),
        GL_INVALID_ENUM,
        "must be GL_INTERLEAVED_ATTRIBS or GL_SEPARATE_ATTRIBS",
    ),
    (
        nothing,
        |c| c.transform_feedback_varyings(1, 5, Names(vec!["a"; 5]), GL_SEPARATE_ATTRIBS),
        GL_INVALID_VALUE,
        "at most 4 buffers",
    ),
    (
        nothing,
        |c| c.transform_feedback_varyings(1, -1, Names(vec![]), GL_SEPARATE_ATTRIBS),
        GL_INVALID_VALUE,
        "count = -1",
    ),
    (
        nothing,
        |c| c.transform_feedback_varyings(1, 2, Names(vec!["a"]), GL_INTERLEAVED_ATTRIBS),
        GL_INVALID_OPERATION,
        "there are 1 names",
    ),
    (
        nothing,
        |c| c.transform_feedback_varyings(99, 0, Names(vec![]), GL_INTERLEAVED_ATTRIBS),
        GL_INVALID_VALUE,
        "99 is no program",
    ),
    (
        nothing,
        |c| varying(c, 1, 2),
        GL_INVALID_VALUE,
        "must be below GL_TRANSFORM_FEEDBACK_VARYINGS, 2",
    ),
    (nothing, |c| varying(c, 99, 0), GL_INVALID_VALUE, "99 is no program"),
    (
        nothing,
        |c| c.get_integeri_v(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, 4, &mut [0]),
        GL_INVALID_VALUE,
        "index = 4 must be below 4",
    ),
    (active, begin, GL_INVALID_OPERATION, "glEndTransformFeedback is missing"),
    (active, |c| c.bind_buffer_base(TARGET, 0, 2), GL_INVALID_OPERATION, "is active"),
    (active, |c| c.bind_buffer_range(TARGET, 0, 2, 0, 4), GL_INVALID_OPERATION, "is active"),
    (active, |c| c.bind_buffer_offset_ext(TARGET, 0, 2, 0), GL_INVALID_OPERATION, "is active"),
    (active, |c| c.use_program(0), GL_INVALID_OPERATION, "call glEndTransformFeedback first"),
    (active, |c| c.link_program(1), GL_INVALID_OPERATION, "call glEndTransformFeedback first"),
    (
        active,
        |c| c.draw_arrays(GL_LINES, 0, 2),
        GL_INVALID_OPERATION,
        "mode draws lines, but glBeginTransformFeedback was called for points",
    ),
    (
        |c| {
            active(c);
            c.bind_buffer(GL_ARRAY_BUFFER, 1);
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 4, GL_MAP_READ_BIT);
        },
        point,
        GL_INVALID_OPERATION,
        "buffer 1 is mapped",
    ),
];

/// Runs the rows.
pub fn run() {
    for (number, (prepare, call, flag, words)) in ROWS.iter().enumerate() {
        let mut c = ready();
        prepare(&mut c);
        row(&mut c, format!("transform feedback {number}"), call, *flag, words);
    }
}
