//! Generic attributes: every type of call, integers, their order in lists.

use super::*;

#[test]
fn generic_attributes_take_every_type() {
    let mut c = context();
    let mut expect = |set: fn(&mut Context), value: [f32; 4]| {
        set(&mut c);
        let mut found = [0.0; 4];
        c.get_vertex_attribfv(3, GL_CURRENT_VERTEX_ATTRIB, &mut found);
        assert_eq!(found, value);
        no_error(&mut c);
    };
    expect(|c| c.vertex_attrib_1s(3, -2), [-2.0, 0.0, 0.0, 1.0]);
    expect(|c| c.vertex_attrib_2dv(3, &[0.5, 4.0]), [0.5, 4.0, 0.0, 1.0]);
    expect(|c| c.vertex_attrib_3f(3, 1.0, 2.0, 3.0), [1.0, 2.0, 3.0, 1.0]);
    expect(|c| c.vertex_attrib_4sv(3, &[1, -1, 2, 3]), [1.0, -1.0, 2.0, 3.0]);
    expect(|c| c.vertex_attrib_4bv(3, &[-128, 1, 2, 3]), [-128.0, 1.0, 2.0, 3.0]);
    expect(|c| c.vertex_attrib_4uiv(3, &[1 << 31, 1, 2, 3]), [2_147_483_648.0, 1.0, 2.0, 3.0]);
    expect(|c| c.vertex_attrib_4nub(3, 255, 0, 51, 255), [1.0, 0.0, 0.2, 1.0]);
    expect(|c| c.vertex_attrib_4nsv(3, &[i16::MIN, i16::MAX, 0, 0]), {
        let zero = (1.0_f64 / 65535.0) as f32;
        [-1.0, 1.0, zero, zero]
    });
    expect(|c| c.vertex_attrib_4nuiv(3, &[u32::MAX, 0, 0, 0]), [1.0, 0.0, 0.0, 0.0]);
}

#[test]
fn integer_attributes_are_read_back_exactly() {
    let mut c = context();
    c.vertex_attrib_i_4i(5, -7, i32::MAX, 0, 1);
    let (mut signed, mut unsigned, mut double) = ([0; 4], [0; 4], [0.0; 4]);
    c.get_vertex_attrib_i_iv(5, GL_CURRENT_VERTEX_ATTRIB, &mut signed);
    assert_eq!(signed, [-7, i32::MAX, 0, 1]);
    c.get_vertex_attrib_i_uiv(5, GL_CURRENT_VERTEX_ATTRIB, &mut unsigned);
    assert_eq!(unsigned[0], (-7_i32) as u32);
    c.get_vertex_attrib_i_iv(5, GL_VERTEX_ATTRIB_ARRAY_SIZE, &mut signed);
    assert_eq!(signed[0], 4);
    c.vertex_attrib_2d(5, 0.25, 2.0);
    c.get_vertex_attribdv(5, GL_CURRENT_VERTEX_ATTRIB, &mut double);
    assert_eq!(double, [0.25, 2.0, 0.0, 1.0]);
    no_error(&mut c);
}

#[test]
fn generic_attributes_keep_their_order_in_lists() {
    let mut c = context();
    let vertex = "attribute vec4 paint; void main() {
        gl_Position = gl_Vertex; gl_FrontColor = paint; }";
    let program = made(&mut c, &[vertex], &[]);
    c.bind_attrib_location(program, 3, "paint");
    assert!(links(&mut c, program));
    c.use_program(program);
    c.new_list(1, GL_COMPILE);
    c.begin(GL_TRIANGLES);
    c.vertex_attrib_4nubv(3, &[0, 255, 0, 255]);
    for corner in [[-4, -4, 0, 1], [4, -4, 0, 1], [0, 4, 0, 1]] {
        c.vertex_attrib_4iv(0, &corner);
    }
    c.vertex_attrib_4nusv(3, &[u16::MAX, 0, 0, u16::MAX]);
    c.end();
    c.end_list();
    c.call_list(1);
    let mut pixel = [0; 4];
    c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!(pixel, [0, 255, 0, 255]);
    no_error(&mut c);
}

/// `gl_VertexID` and `gl_InstanceID` are active attributes without a location where they are read (GL 3.3, section 2.11.3;
/// OpenGL ES 3.0, section 2.12.4).
#[test]
fn numbers_of_vertices_and_instances_are_active_attributes() {
    let es = ContextDesc { api: Api::Es2, ..ContextDesc::default() };
    for (mut c, version) in [(context(), "150"), (Context::new(es).expect("a device"), "300 es")] {
        let body = |sum: &str| {
            format!(
                "#version {version}\nin vec4 a;\nvoid main() {{ gl_Position = a + vec4({sum}); }}"
            )
        };
        let fragment = format!(
            "#version {version}\nprecision highp float;\nout vec4 color;\nvoid main() {{ color = vec4(1.0); }}"
        );
        let both = linked(&mut c, &[&body("gl_VertexID + gl_InstanceID")], &[&fragment]);
        let mut found = attributes(&mut c, both);
        found.sort();
        let of = |name: &str, ty| (name.to_owned(), ty);
        let expected =
            [of("a", GL_FLOAT_VEC4), of("gl_InstanceID", GL_INT), of("gl_VertexID", GL_INT)];
        assert_eq!(found, expected);
        let longest = "gl_InstanceID".len() as GLint + 1;
        assert_eq!(asked(&mut c, both, GL_ACTIVE_ATTRIBUTE_MAX_LENGTH), longest);
        for name in ["gl_VertexID", "gl_InstanceID"] {
            assert_eq!(c.get_attrib_location(both, name), -1);
        }
        let none = linked(&mut c, &[&body("1.0")], &[&fragment]);
        assert_eq!(attributes(&mut c, none), [of("a", GL_FLOAT_VEC4)]);
        no_error(&mut c);
    }
}
