//! `gl_SkipComponents` and `gl_NextBuffer` among the captured names, and queries of vertex streams
//! (`ARB_transform_feedback3`).

use super::*;

const VERTEX: &str = "#version 130
    in float a;
    out vec2 pair; out float one;
    void main() { pair = vec2(a, a + 0.5); one = -a; gl_PointSize = 8.0 * a; gl_Position = vec4(a, 0.0, 0.0, 1.0); }";

/// Captures three points whose `a` is 1, 2, 3, into the buffers that are bound, and counts them by query 7.
fn capture(c: &mut Context, names: &[&str]) -> GLuint {
    let program = capturing(c, VERTEX, names, GL_INTERLEAVED_ATTRIBS);
    let at = c.get_attrib_location(program, "a") as GLuint;
    let values = [1.0_f32, 2.0, 3.0];
    let memory = Data::Bytes(bytemuck::cast_slice(&values));
    c.vertex_attrib_pointer(at, 1, GL_FLOAT, false, 0, memory);
    c.enable_vertex_attrib_array(at);
    c.begin_transform_feedback(GL_POINTS);
    c.begin_query_indexed(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 0, 7);
    c.draw_arrays(GL_POINTS, 0, 3);
    c.end_query_indexed(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 0);
    c.end_transform_feedback();
    fine(c);
    program
}

#[test]
fn gaps_keep_what_the_buffer_has_and_the_rest_goes_to_the_next_one() {
    let mut c = context();
    buffer(&mut c, 1, 0, 15);
    buffer(&mut c, 2, 1, 3);
    let names = ["pair", "gl_SkipComponents2", "one", "gl_NextBuffer", "gl_PointSize"];
    let program = capture(&mut c, &names);
    let first = words(&mut c, 1, 15);
    let float = |value: f32| value.to_bits();
    let of = |a: f32| [float(a), float(a + 0.5), UNTOUCHED, UNTOUCHED, float(-a)];
    assert_eq!(first, [of(1.0), of(2.0), of(3.0)].concat());
    assert_eq!(floats(&mut c, 2, 3), [8.0, 16.0, 24.0]);
    // The names are answered in their order.
    let mut found = Vec::new();
    for index in 0..5 {
        let (mut name, mut length, mut size, mut ty) = (vec![0; 64], [0], [0], [0]);
        let out = TextOut::Bytes(&mut name);
        let (length_out, size_out, ty_out) = (&mut length, &mut size, &mut ty);
        c.get_transform_feedback_varying(program, index, 64, length_out, size_out, ty_out, out);
        name.truncate(length[0] as usize);
        found.push((String::from_utf8(name).expect("text"), size[0], ty[0]));
    }
    let wanted = [
        ("pair", 1, GL_FLOAT_VEC2),
        ("gl_SkipComponents2", 2, GL_NONE),
        ("one", 1, GL_FLOAT),
        ("gl_NextBuffer", 0, GL_NONE),
        ("gl_PointSize", 1, GL_FLOAT),
    ];
    assert_eq!(found, wanted.map(|(name, size, ty)| (name.to_owned(), size, ty)));
}

#[test]
fn a_buffer_without_components_needs_no_binding() {
    let mut c = context();
    buffer(&mut c, 1, 0, 6);
    buffer(&mut c, 3, 2, 3);
    capture(&mut c, &["pair", "gl_NextBuffer", "gl_NextBuffer", "one"]);
    assert_eq!(floats(&mut c, 1, 6), [1.0, 1.5, 2.0, 2.5, 3.0, 3.5]);
    assert_eq!(floats(&mut c, 3, 3), [-1.0, -2.0, -3.0]);
    let mut count = [0];
    c.get_query_objectiv(7, GL_QUERY_RESULT, &mut count);
    assert_eq!(count, [3]);
    // Drawn again as the only stream there is.
    c.draw_transform_feedback_stream(GL_POINTS, 0, 0);
    fine(&mut c);
    c.draw_transform_feedback_stream(GL_POINTS, 0, 1);
    assert_eq!(c.get_error(), GL_INVALID_VALUE);
}
