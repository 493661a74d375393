//! What the calls on vertex array objects refuse, and what such an object does.

use gl_api::*;

/// What comes before, a call, the flag it must set, and words that its message must have.
type Case = (fn(&mut Context), fn(&mut Context), GLenum, &'static str);

/// Most rows need nothing.
fn nothing(_: &mut Context) {}

/// Vertex array object 1, and no buffer for its arrays.
fn object_without_buffer(c: &mut Context) {
    c.gen_vertex_arrays(1, &mut [0]);
    c.bind_vertex_array(1);
    c.bind_buffer(GL_ARRAY_BUFFER, 0);
}

const CASES: &[Case] = &[
    (
        nothing,
        |c| c.bind_vertex_array(77),
        GL_INVALID_OPERATION,
        "array = 77 must be a name that glGenVertexArrays gave",
    ),
    (
        object_without_buffer,
        |c| c.vertex_pointer(2, GL_FLOAT, 0, Data::Bytes(&[0; 24])),
        GL_INVALID_OPERATION,
        "pointer is memory, but vertex array object 1 is bound, which reads buffer objects only: \
         bind a buffer to GL_ARRAY_BUFFER, or call glBindVertexArray(0)",
    ),
    (
        object_without_buffer,
        |c| c.interleaved_arrays(GL_C3F_V3F, 0, Data::Bytes(&[0; 24])),
        GL_INVALID_OPERATION,
        "pointer is memory, but vertex array object 1 is bound",
    ),
    (
        nothing,
        |c| c.gen_vertex_arrays(-1, &mut []),
        GL_INVALID_VALUE,
        "n = -1 must not be negative",
    ),
    (nothing, |c| c.delete_vertex_arrays(-1, &[]), GL_INVALID_VALUE, "n = -1 must not be negative"),
];

/// Runs the rows.
pub fn run() {
    for (row, (prepare, call, flag, words)) in CASES.iter().enumerate() {
        let mut c = super::context();
        prepare(&mut c);
        super::row(&mut c, format!("vertex arrays {row}"), call, *flag, words);
    }
}
