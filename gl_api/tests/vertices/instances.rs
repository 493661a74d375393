//! Several instances of what is drawn.

use super::{CORNERS, context, picture, program};
use gl_api::*;

#[test]
fn instances_have_their_number_and_their_own_attributes() {
    let vertex = "#version 130\n#extension GL_ARB_draw_instanced : enable\n\
        in vec2 position; in float extra; out vec3 color;\n\
        void main() { color = vec3(float(gl_InstanceID) / 2.0, extra, 0.0);\n\
        gl_Position = vec4(position + vec2(float(gl_InstanceID), 0.0), 0.0, 1.0); }";
    let fragment = "#version 130\nin vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }";
    let mut c = context();
    program(&mut c, vertex, fragment);
    // A strip a pixel wide at the left of each half, four instances with two elements.
    let corners = [-1.0f32, -1.0, -0.5, -1.0, -1.0, 1.0, -0.5, 1.0];
    c.enable_vertex_attrib_array(0);
    c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 0, corners.as_slice().arg());
    c.enable_vertex_attrib_array(1);
    c.vertex_attrib_pointer(1, 1, GL_FLOAT, false, 0, [0.2f32, 1.0].as_slice().arg());
    c.vertex_attrib_divisor(1, 1);
    c.draw_arrays_instanced(GL_TRIANGLE_STRIP, 0, 4, 2);
    let pixels = picture(&mut c);
    assert_eq!(&pixels[4..8], [0, 51, 0, 255]);
    assert_eq!(&pixels[9 * 4..10 * 4], [128, 255, 0, 255]);
    let mut divisor = [0];
    c.get_vertex_attribiv(1, GL_VERTEX_ATTRIB_ARRAY_DIVISOR, &mut divisor);
    assert_eq!(divisor[0], 1);
    // Two instances an element.
    c.vertex_attrib_divisor(1, 2);
    c.draw_elements_instanced(
        GL_TRIANGLE_STRIP,
        4,
        GL_UNSIGNED_BYTE,
        Data::Bytes(&[0, 1, 2, 3]),
        2,
    );
    assert_eq!(&picture(&mut c)[9 * 4..10 * 4], [128, 51, 0, 255]);
}

/// `ARB_draw_instanced`: an instance is drawn whole, with its restarts, before the next one.
#[test]
fn instances_go_around_restarts() {
    let vertex = "#version 130\n#extension GL_ARB_draw_instanced : enable\n\
        in vec2 position; in float extra; flat out vec3 color;\n\
        void main() { color = vec3(float(gl_InstanceID), float(gl_VertexID) / 5.0, extra);\n\
        gl_Position = vec4(position, 0.0, 1.0); }";
    let fragment = "#version 130\nflat in vec3 color; void main() {\n\
        if (color.xy == vec2(1.0)) discard; gl_FragColor = vec4(color, 1.0); }";
    let mut c = context();
    program(&mut c, vertex, fragment);
    // The same triangle twice: without the last one of all, the first of the last instance stays.
    c.enable_vertex_attrib_array(0);
    c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 0, CORNERS[..6].repeat(2).as_slice().arg());
    c.enable_vertex_attrib_array(1);
    c.vertex_attrib_pointer(1, 1, GL_FLOAT, false, 0, [0.2f32, 1.0].as_slice().arg());
    c.vertex_attrib_divisor(1, 1);
    c.enable(GL_PRIMITIVE_RESTART);
    c.primitive_restart_index(99);
    let indices = Data::Bytes(&[0, 1, 2, 99, 3, 4, 5]);
    c.draw_elements_instanced(GL_TRIANGLE_STRIP, 7, GL_UNSIGNED_BYTE, indices, 2);
    assert_eq!(picture(&mut c)[(2 * 16 + 2) * 4..][..4], [255, 102, 255, 255]);
}
