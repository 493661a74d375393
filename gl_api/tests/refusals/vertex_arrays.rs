//! What the calls on vertex array objects refuse, and what such an object does.

use gl_api::*;

/// The preparation, the call, the error flag that it must set, and words that its message must have.
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

/// Which arrays are enabled, and where the vertices begin.
fn interleaved(c: &mut Context) -> ([bool; 4], i32) {
    let arrays = [GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_EDGE_FLAG_ARRAY, GL_TEXTURE_COORD_ARRAY];
    let mut stride = [0];
    c.get_integerv(GL_VERTEX_ARRAY_STRIDE, &mut stride);
    (arrays.map(|array| c.is_enabled(array)), stride[0])
}

#[test]
fn interleaved_arrays_are_set_whole_or_not_at_all() {
    // Without memory they all are, as each pointer may be.
    let mut c = super::context();
    for null in [Data::Null, Data::Offset(0)] {
        c.interleaved_arrays(GL_V3F, 0, null);
        c.enable_client_state(GL_EDGE_FLAG_ARRAY);
        c.interleaved_arrays(GL_T2F_C4UB_V3F, 0, null);
        assert_eq!(interleaved(&mut c), ([true, true, false, true], 24));
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    }
    // Memory, where a buffer is bound, and an offset, where none is.
    let mut c = super::context();
    c.enable_client_state(GL_EDGE_FLAG_ARRAY);
    c.interleaved_arrays(GL_T2F_C4UB_V3F, 0, Data::Offset(8));
    assert_eq!(interleaved(&mut c), ([false, false, true, false], 0));
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    c.interleaved_arrays(GL_T2F_C4UB_V3F, 0, Data::Bytes(&[0; 240]));
    assert_eq!(interleaved(&mut c), ([false, false, true, false], 0));
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
}
