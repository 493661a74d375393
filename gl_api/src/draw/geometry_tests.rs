//! Draws with geometry shaders.

use crate::base::args::{Data, DataOut, Names, Strings};
use crate::base::constants::*;
use crate::base::types::*;
use crate::context::{Context, ContextDesc};

const SIZE: i32 = 8;

const VERTEX: &str = "#version 150 compatibility\nout vec4 color; void main() { gl_Position = gl_Vertex; color = \
                      gl_Color; }";
const FRAGMENT: &str =
    "#version 150 compatibility\nin vec4 shade; void main() { gl_FragColor = shade; }";
/// A square of a third of the picture around each point.
const SQUARES: &str = "#version 150 compatibility\n\
    layout(points) in; layout(triangle_strip, max_vertices = 4) out;\n\
    in vec4 color[]; out vec4 shade; uniform float half_side;\n\
    void main() { for (int i = 0; i < 4; i++) {\n\
      gl_Position = gl_in[0].gl_Position + vec4(half_side * vec2(i % 2 * 2 - 1, i / 2 * 2 - 1), 0.0, 0.0);\n\
      shade = color[0]; EmitVertex(); } }";

fn context() -> Context {
    let side = SIZE as u32;
    let desc = ContextDesc { width: side, height: side, ..ContextDesc::default() };
    Context::new(desc).expect("a device")
}

fn fine(c: &mut Context) {
    let error = c.get_error();
    assert_eq!(error, GL_NO_ERROR, "{:?}", c.messages());
}

fn program(c: &mut Context, geometry: &str, fragment: &str, captured: &[&str]) -> GLuint {
    let program = c.create_program();
    let stages = [
        (GL_VERTEX_SHADER, VERTEX),
        (GL_GEOMETRY_SHADER, geometry),
        (GL_FRAGMENT_SHADER, fragment),
    ];
    for (stage, source) in stages {
        let shader = c.create_shader(stage);
        c.shader_source(shader, 1, Strings(vec![source]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
    }
    if !captured.is_empty() {
        let count = captured.len() as i32;
        let names = Names(captured.to_vec());
        c.transform_feedback_varyings(program, count, names, GL_INTERLEAVED_ATTRIBS);
    }
    c.link_program(program);
    c.use_program(program);
    fine(c);
    program
}

fn pixel(c: &mut Context, x: i32, y: i32) -> [u8; 4] {
    let mut p = [0; 4];
    c.read_pixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut p));
    fine(c);
    p
}

#[test]
fn a_point_becomes_a_square() {
    let mut c = context();
    let name = program(&mut c, SQUARES, FRAGMENT, &[]);
    let place = c.get_uniform_location(name, "half_side");
    c.uniform_1f(place, 0.5);
    c.begin(GL_POINTS);
    c.color_3f(1.0, 0.0, 0.0);
    c.vertex_2f(-0.5, -0.5);
    c.color_3f(0.0, 1.0, 0.0);
    c.vertex_2f(0.5, 0.5);
    c.end();
    assert_eq!(pixel(&mut c, 1, 1), [255, 0, 0, 255]);
    assert_eq!(pixel(&mut c, 6, 6), [0, 255, 0, 255]);
    assert_eq!(pixel(&mut c, 6, 1), [0; 4]);
    let mut value = [0];
    for (pname, want) in [
        (GL_GEOMETRY_VERTICES_OUT, 4),
        (GL_GEOMETRY_INPUT_TYPE, GL_POINTS),
        (GL_GEOMETRY_OUTPUT_TYPE, GL_TRIANGLE_STRIP),
    ] {
        c.get_programiv(name, pname, &mut value);
        assert_eq!(value, [want as i32]);
    }
    fine(&mut c);
    // A mode that makes other primitives.
    for mode in [GL_TRIANGLES, GL_LINES, GL_LINES_ADJACENCY, GL_QUADS] {
        c.draw_arrays(mode, 0, 12);
        assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    }
    let last = format!("{:?}", c.messages().last());
    assert!(last.contains("GL_QUADS does not make") && last.contains("are points"), "{last}");
}

#[test]
fn a_program_without_a_geometry_shader_has_no_such_properties() {
    let mut c = context();
    let name = c.create_program();
    c.get_programiv(name, GL_GEOMETRY_VERTICES_OUT, &mut [0]);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
}

/// GL 3.2, section 2.6.1: without a geometry shader, adjacent vertices are not drawn.
#[test]
fn primitives_with_adjacency_are_drawn_without_it() {
    let mut c = context();
    c.color_3f(0.0, 0.0, 1.0);
    let full = [[-1.0_f32, -1.0], [3.0, -1.0], [-1.0, 3.0]];
    for modes in [GL_TRIANGLES_ADJACENCY, GL_TRIANGLE_STRIP_ADJACENCY] {
        c.clear(GL_COLOR_BUFFER_BIT);
        c.begin(modes);
        for [x, y] in full {
            c.vertex_2f(x, y);
            c.vertex_2f(9.0, 9.0);
        }
        c.end();
        assert_eq!(pixel(&mut c, 7, 7), [0, 0, 255, 255]);
    }
    c.clear(GL_COLOR_BUFFER_BIT);
    c.begin(GL_LINE_STRIP_ADJACENCY);
    for x in [-1.0, 0.0, 0.5, 1.0] {
        c.vertex_2f(x, 0.1);
    }
    c.end();
    let drawn = [1, 4, 5, 7].map(|x| pixel(&mut c, x, 4)[2]);
    assert_eq!(drawn, [0, 255, 255, 0]);
}

#[test]
fn primitives_go_to_the_layers_that_the_shader_says() {
    let mut c = context();
    c.bind_texture(GL_TEXTURE_2D_ARRAY, 1);
    let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
    let internal = GL_RGBA8 as i32;
    c.tex_image_3d(GL_TEXTURE_2D_ARRAY, 0, internal, SIZE, SIZE, 4, 0, format, ty, Data::Null);
    c.bind_framebuffer(GL_FRAMEBUFFER, 1);
    c.framebuffer_texture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, 1, 0);
    let source = SQUARES
        .replace("shade = color[0];", "shade = color[0]; gl_Layer = 3 - gl_PrimitiveIDIn;")
        .replace("half_side", "1.0")
        .replace("uniform float 1.0;", "");
    program(&mut c, &source, FRAGMENT, &[]);
    c.clear_color(0.0, 0.0, 1.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.begin(GL_POINTS);
    for level in 1..=3 {
        c.color_3ub(level * 10, 0, 0);
        c.vertex_2f(0.0, 0.0);
    }
    c.end();
    let mut texels = [0; 4 * 64 * 4];
    c.get_tex_image(GL_TEXTURE_2D_ARRAY, 0, format, ty, DataOut::Bytes(&mut texels));
    fine(&mut c);
    let layers: Vec<&[u8]> = texels.chunks(256).map(|layer| &layer[132..136]).collect();
    let want: [&[u8]; 4] =
        [&[0, 0, 255, 255], &[30, 0, 0, 255], &[20, 0, 0, 255], &[10, 0, 0, 255]];
    assert_eq!(layers, want);
}

#[test]
fn fragments_have_the_number_that_was_emitted() {
    let mut c = context();
    let source = SQUARES
        .replace(
            "shade = color[0];",
            "shade = color[0]; gl_PrimitiveID = 65541 + gl_PrimitiveIDIn;",
        )
        .replace("half_side", "1.0")
        .replace("uniform float 1.0;", "");
    let fragment = "#version 150 compatibility\n\
        void main() { gl_FragColor = vec4(gl_PrimitiveID - 65536, 0, 0, 255) / 255.0; }";
    program(&mut c, &source, fragment, &[]);
    c.draw_arrays(GL_POINTS, 0, 3);
    assert_eq!(pixel(&mut c, 4, 4), [7, 0, 0, 255]);
}

#[test]
fn what_is_emitted_is_captured_and_counted() {
    let mut c = context();
    let source = "#version 150 compatibility\n\
        layout(points) in; layout(line_strip, max_vertices = 3) out;\n\
        in vec4 color[]; out vec4 shade; out float number;\n\
        void main() { for (int i = 0; i < 3; i++) {\n\
          gl_Position = gl_in[0].gl_Position; shade = color[0]; \
          number = float(10 * gl_PrimitiveIDIn + i); EmitVertex(); } }";
    let fragment = "#version 150 compatibility\nin vec4 shade; in float number;\n\
        void main() { gl_FragColor = shade + number; }";
    program(&mut c, source, fragment, &["number"]);
    c.bind_buffer(GL_TRANSFORM_FEEDBACK_BUFFER, 1);
    c.buffer_data(GL_TRANSFORM_FEEDBACK_BUFFER, 400, Data::Null, GL_STATIC_READ);
    c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 1);
    for captures in [true, false] {
        c.begin_query(GL_PRIMITIVES_GENERATED, 1);
        c.begin_query(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 2);
        if captures {
            c.begin_transform_feedback(GL_LINES);
        }
        c.draw_arrays(GL_POINTS, 0, 70);
        c.draw_arrays(GL_POINTS, 0, 2);
        if captures {
            c.end_transform_feedback();
        }
        c.end_query(GL_PRIMITIVES_GENERATED);
        c.end_query(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
        let counts = [1, 2].map(|query| {
            let mut count = [0];
            c.get_query_objectuiv(query, GL_QUERY_RESULT, &mut count);
            count[0]
        });
        // 400 bytes are 50 lines.
        assert_eq!(counts, [144, if captures { 50 } else { 0 }]);
    }
    let mut bytes = [0; 400];
    c.get_buffer_sub_data(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 400, DataOut::Bytes(&mut bytes));
    fine(&mut c);
    let (numbers, _) = bytes.as_chunks::<4>();
    for (at, number) in numbers.iter().enumerate() {
        let want = at / 4 * 10 + [0, 1, 1, 2][at % 4];
        assert_eq!(f32::from_le_bytes(*number), want as f32, "{at}");
    }
    c.begin_transform_feedback(GL_POINTS);
    c.draw_arrays(GL_POINTS, 0, 1);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
}

#[test]
fn a_geometry_shader_that_does_not_end_is_stopped() {
    let mut c = context();
    let source =
        SQUARES.replace("for (int i = 0; i < 4; i++)", "for (int i = 0; i >= 0; i = i + 1 & 1)");
    program(&mut c, &source, FRAGMENT, &[]);
    c.draw_arrays(GL_POINTS, 0, 100);
    assert_eq!(pixel(&mut c, 4, 4), [0; 4]);
    assert!(format!("{:?}", c.messages()).contains("a shader ran so long"));
}
