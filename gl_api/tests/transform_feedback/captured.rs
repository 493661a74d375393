//! What draws write to buffers, and what the queries count.

use super::{UNTOUCHED, buffer, capturing, context, fine, floats, log, shading, words};
use gl_api::*;

/// Hands on the number of the vertex.
const NUMBER: &str = "#version 130\nflat out int number;\n\
    void main() { number = gl_VertexID; gl_Position = vec4(0.0, 0.0, 0.0, 1.0); }";

/// Every topology falls apart as section 2.6.1 says.
#[test]
fn every_topology_is_captured_as_its_parts() {
    let cases: [(GLenum, GLenum, i32, &[u32]); 13] = [
        (GL_POINTS, GL_POINTS, 3, &[0, 1, 2]),
        (GL_LINES, GL_LINES, 5, &[0, 1, 2, 3]),
        (GL_LINES, GL_LINE_STRIP, 4, &[0, 1, 1, 2, 2, 3]),
        (GL_LINES, GL_LINE_LOOP, 3, &[0, 1, 1, 2, 2, 0]),
        (GL_TRIANGLES, GL_TRIANGLES, 7, &[0, 1, 2, 3, 4, 5]),
        (GL_TRIANGLES, GL_TRIANGLE_STRIP, 5, &[0, 1, 2, 2, 1, 3, 2, 3, 4]),
        (GL_TRIANGLES, GL_TRIANGLE_FAN, 4, &[0, 1, 2, 0, 2, 3]),
        (GL_TRIANGLES, GL_POLYGON, 4, &[0, 1, 2, 0, 2, 3]),
        (GL_TRIANGLES, GL_QUADS, 7, &[0, 1, 3, 1, 2, 3]),
        (GL_TRIANGLES, GL_QUAD_STRIP, 5, &[2, 0, 3, 0, 1, 3]),
        (GL_TRIANGLES, GL_TRIANGLES, 2, &[]),
        (GL_LINES, GL_LINE_LOOP, 1, &[]),
        (GL_TRIANGLES, GL_POLYGON, 2, &[]),
    ];
    for (kind, mode, count, expected) in cases {
        let mut c = context();
        capturing(&mut c, NUMBER, &["number"], GL_INTERLEAVED_ATTRIBS);
        buffer(&mut c, 1, 0, 32);
        c.gen_queries(2, &mut [0; 2]);
        c.begin_query(GL_PRIMITIVES_GENERATED, 1);
        c.begin_query(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 2);
        c.begin_transform_feedback(kind);
        c.draw_arrays(mode, 0, count);
        c.end_transform_feedback();
        c.end_query(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
        c.end_query(GL_PRIMITIVES_GENERATED);
        fine(&mut c);
        let found = words(&mut c, 1, 32);
        let (written, rest) = found.split_at(expected.len());
        assert_eq!(written, expected, "{}", enum_name(mode));
        assert!(rest.iter().all(|word| *word == UNTOUCHED), "{}", enum_name(mode));
        let corners = match kind {
            GL_POINTS => 1,
            GL_LINES => 2,
            _ => 3,
        };
        for query in [1, 2] {
            assert_eq!(result(&mut c, query) as usize, expected.len() / corners);
        }
    }
}

/// By the other convention, the vertex that provokes comes first, also when what was captured is
/// drawn as triangles.
#[test]
fn the_first_vertex_stays_first() {
    let cases: [(GLenum, GLenum, i32, &[u32]); 5] = [
        (GL_LINES, GL_LINE_LOOP, 3, &[0, 1, 1, 2, 2, 0]),
        (GL_TRIANGLES, GL_TRIANGLE_STRIP, 5, &[0, 1, 2, 1, 3, 2, 2, 3, 4]),
        (GL_TRIANGLES, GL_TRIANGLE_FAN, 4, &[1, 2, 0, 2, 3, 0]),
        (GL_TRIANGLES, GL_QUADS, 4, &[0, 1, 2, 0, 2, 3]),
        (GL_TRIANGLES, GL_QUAD_STRIP, 4, &[0, 1, 3, 0, 3, 2]),
    ];
    for (kind, mode, count, expected) in cases {
        let mut c = context();
        c.provoking_vertex(GL_FIRST_VERTEX_CONVENTION);
        capturing(&mut c, NUMBER, &["number"], GL_INTERLEAVED_ATTRIBS);
        buffer(&mut c, 1, 0, 32);
        c.begin_transform_feedback(kind);
        c.draw_arrays(mode, 0, count);
        c.end_transform_feedback();
        fine(&mut c);
        assert_eq!(words(&mut c, 1, 32)[..expected.len()], *expected, "{}", enum_name(mode));
    }
}

fn result(c: &mut Context, id: GLuint) -> GLuint {
    let mut value = [0];
    c.get_query_objectuiv(id, GL_QUERY_RESULT, &mut value);
    fine(c);
    value[0]
}

/// All types, one after the other, exactly: integers as words, floats as they are.
#[test]
fn scalars_of_every_type_are_exact() {
    let vertex = "#version 130\n\
        uniform float zero; out vec3 v; flat out ivec2 i; flat out uint u[2]; out mat2x3 m;\n\
        out float special[4];\n\
        void main() {\n\
          v = vec3(0.1, -2.5, 16777217.0); i = ivec2(-2147483647 - 1, 65537);\n\
          u = uint[2](4294967295u, 305419896u);\n\
          m = mat2x3(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);\n\
          special = float[4](1.0 / zero, -0.0, 1.0e-40, zero / zero);\n\
          gl_PointSize = 7.0; gl_Position = vec4(0.25, 0.5, 0.75, 1.0);\n\
        }";
    let names = ["v", "i", "u", "m", "special", "gl_Position", "gl_PointSize"];
    let expected: Vec<u32> = [0.1, -2.5, 16_777_216.0]
        .map(f32::to_bits)
        .into_iter()
        .chain([0x8000_0000, 65_537, u32::MAX, 0x1234_5678])
        .chain([1.0, 2.0, 3.0, 4.0, 5.0, 6.0].map(f32::to_bits))
        .chain([f32::INFINITY, -0.0, 1.0e-40].map(f32::to_bits))
        .chain([0x7FC0_0000])
        .chain([0.25, 0.5, 0.75, 1.0, 7.0].map(f32::to_bits))
        .collect();
    let mut c = context();
    capturing(&mut c, vertex, &names, GL_INTERLEAVED_ATTRIBS);
    buffer(&mut c, 1, 0, 64);
    c.enable(GL_RASTERIZER_DISCARD);
    c.begin_transform_feedback(GL_POINTS);
    c.draw_arrays(GL_POINTS, 0, 2);
    c.end_transform_feedback();
    let found = words(&mut c, 1, 64);
    assert_eq!(found[..expected.len()], expected);
    assert_eq!(found[expected.len()..2 * expected.len()], expected);
    assert!(found[2 * expected.len()..].iter().all(|word| *word == UNTOUCHED));
}

/// Built-in varyings, whether or not anything reads them, and elements of arrays.
#[test]
fn built_in_varyings_and_elements_are_captured() {
    let vertex = "varying vec2 v[3];\n\
        void main() {\n\
          gl_FrontColor = vec4(0.25, 2.0, -1.0, 0.5); gl_BackColor = vec4(0.5);\n\
          gl_TexCoord[1] = vec4(1.0, 2.0, 3.0, 4.0); gl_FogFragCoord = 9.0;\n\
          v[0] = vec2(0.0); v[1] = vec2(5.0, 6.0); v[2] = vec2(7.0);\n\
          gl_Position = gl_Vertex;\n\
        }";
    let mut c = context();
    let names = ["gl_FrontColor", "gl_TexCoord[1]", "v[1]", "gl_FogFragCoord", "gl_BackColor"];
    capturing(&mut c, vertex, &names, GL_INTERLEAVED_ATTRIBS);
    buffer(&mut c, 1, 0, 15);
    c.begin_transform_feedback(GL_POINTS);
    c.begin(GL_POINTS);
    c.vertex_2f(0.0, 0.0);
    c.end();
    c.end_transform_feedback();
    // Colours are clamped as they leave the vertex stage (GL 3.0, section 2.19).
    let expected = [0.25, 1.0, 0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 9.0, 0.5, 0.5, 0.5, 0.5];
    assert_eq!(floats(&mut c, 1, 15), expected);
    fine(&mut c);
}

/// Each varying into a buffer of its own, behind the offset and within the size of its range.
#[test]
fn separate_buffers_and_their_ranges() {
    let vertex = "#version 130\n#extension GL_ARB_draw_instanced : enable\n\
        flat out int a; flat out ivec2 b;\n\
        void main() { a = gl_VertexID; b = ivec2(gl_VertexID * 10, gl_InstanceID);\n\
        gl_Position = vec4(0.0, 0.0, 0.0, 1.0); }";
    let mut c = context();
    capturing(&mut c, vertex, &["a", "b"], GL_SEPARATE_ATTRIBS);
    buffer(&mut c, 1, 0, 8);
    buffer(&mut c, 2, 1, 16);
    c.bind_buffer_range(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 1, 4, 24);
    c.gen_queries(2, &mut [0; 2]);
    c.begin_query(GL_PRIMITIVES_GENERATED, 1);
    c.begin_query(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 2);
    c.begin_transform_feedback(GL_POINTS);
    // Two instances of two points, then three: six fit into the range.
    c.draw_arrays_instanced(GL_POINTS, 4, 2, 2);
    c.draw_arrays(GL_POINTS, 0, 3);
    c.end_transform_feedback();
    c.end_query(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
    c.end_query(GL_PRIMITIVES_GENERATED);
    fine(&mut c);
    assert_eq!(words(&mut c, 1, 8), [UNTOUCHED, 4, 5, 4, 5, 0, 1, UNTOUCHED]);
    let b = words(&mut c, 2, 16);
    assert_eq!(b[..12], [40, 0, 50, 0, 40, 1, 50, 1, 0, 0, 10, 0]);
    assert!(b[12..].iter().all(|word| *word == UNTOUCHED));
    assert_eq!([result(&mut c, 1), result(&mut c, 2)], [7, 6]);
    let mut value = [0];
    for (name, expected) in [
        (GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, 1),
        (GL_TRANSFORM_FEEDBACK_BUFFER_START, 4),
        (GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, 24),
    ] {
        c.get_integeri_v(name, 0, &mut value);
        assert_eq!(value, [expected], "{}", enum_name(name));
    }
    fine(&mut c);
}

/// `ARB_draw_instanced`: an instance is written whole, with its restarts, before the next one.
#[test]
fn instances_go_around_restarts() {
    let vertex = "#version 130\n#extension GL_ARB_draw_instanced : enable\n\
        flat out ivec2 a; void main() { a = ivec2(gl_VertexID, gl_InstanceID);\n\
        gl_Position = vec4(0.0, 0.0, 0.0, 1.0); }";
    let mut c = context();
    capturing(&mut c, vertex, &["a"], GL_INTERLEAVED_ATTRIBS);
    buffer(&mut c, 1, 0, 12);
    c.enable(GL_PRIMITIVE_RESTART);
    c.primitive_restart_index(99);
    c.begin_transform_feedback(GL_POINTS);
    let indices = Data::Bytes(&[4, 99, 7, 5]);
    c.draw_elements_instanced(GL_POINTS, 4, GL_UNSIGNED_BYTE, indices, 2);
    c.end_transform_feedback();
    fine(&mut c);
    assert_eq!(words(&mut c, 1, 12), [4, 0, 7, 0, 5, 0, 4, 1, 7, 1, 5, 1]);
}

/// Primitives are written whole or not at all.
#[test]
fn a_primitive_that_does_not_fit_is_left_out() {
    for (room, expected) in [(0, 0), (2, 0), (3, 3), (5, 3), (6, 6), (100, 9)] {
        let mut c = context();
        capturing(&mut c, NUMBER, &["number"], GL_INTERLEAVED_ATTRIBS);
        buffer(&mut c, 1, 0, room);
        c.begin_transform_feedback(GL_TRIANGLES);
        c.draw_arrays(GL_TRIANGLES, 0, 9);
        c.end_transform_feedback();
        let found = words(&mut c, 1, room);
        let written: Vec<u32> = (0..expected).collect();
        assert_eq!(found[..expected as usize], written, "{room}");
        assert!(found[expected as usize..].iter().all(|word| *word == UNTOUCHED), "{room}");
        fine(&mut c);
    }
}

/// More vertices than are run at once, by index, with a base: each in its order.
#[test]
fn long_indexed_draws_keep_their_order() {
    let count = 20_001_u32;
    let indices: Vec<u32> = (0..count).map(|at| at * 7919 % 65_521).collect();
    let mut c = context();
    capturing(&mut c, NUMBER, &["number"], GL_INTERLEAVED_ATTRIBS);
    buffer(&mut c, 1, 0, count as usize);
    c.enable(GL_RASTERIZER_DISCARD);
    c.begin_transform_feedback(GL_TRIANGLES);
    c.draw_elements_base_vertex(
        GL_TRIANGLES,
        count as i32,
        GL_UNSIGNED_INT,
        Data::Bytes(bytes(&indices)),
        5,
    );
    c.end_transform_feedback();
    fine(&mut c);
    let expected: Vec<u32> = indices.iter().map(|index| index + 5).collect();
    assert_eq!(words(&mut c, 1, count as usize), expected);
}

fn bytes(words: &[u32]) -> &[u8] {
    bytemuck::cast_slice(words)
}

/// The draw itself goes on, unless the rasterizer is switched off; then clears have no effect either.
#[test]
fn drawing_goes_on_beside_it() {
    let vertex = "varying vec4 place; void main() { place = gl_Vertex; gl_Position = gl_Vertex;\n\
        gl_FrontColor = vec4(0.0, 1.0, 0.0, 1.0); }";
    for (discard, drawn) in [(false, [0, 255, 0, 255]), (true, [0; 4])] {
        let mut c = context();
        capturing(&mut c, vertex, &["place"], GL_INTERLEAVED_ATTRIBS);
        buffer(&mut c, 1, 0, 24);
        if discard {
            c.enable(GL_RASTERIZER_DISCARD);
            c.clear_color(1.0, 0.0, 0.0, 1.0);
            c.clear(GL_COLOR_BUFFER_BIT);
        }
        c.begin_transform_feedback(GL_TRIANGLES);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        c.end_transform_feedback();
        let mut pixel = [0; 4];
        c.read_pixels(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
        assert_eq!(pixel, drawn);
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let expected: Vec<f32> = [0, 1, 2, 0, 2, 3]
            .into_iter()
            .flat_map(|at: usize| [corners[at][0], corners[at][1], 0.0, 1.0])
            .collect();
        assert_eq!(floats(&mut c, 1, 24), expected);
        fine(&mut c);
    }
}

/// What was captured can be drawn, also while the draw that wrote it is not carried out yet.
#[test]
fn captured_vertices_can_be_drawn() {
    let mut c = context();
    let vertex = "varying vec4 place;\n\
        void main() { place = gl_Vertex * vec4(2.0, 2.0, 1.0, 1.0); gl_Position = place; }";
    capturing(&mut c, vertex, &["place"], GL_INTERLEAVED_ATTRIBS);
    buffer(&mut c, 1, 0, 16 * 2);
    c.begin_transform_feedback(GL_TRIANGLES);
    c.begin(GL_TRIANGLES);
    for [x, y] in [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5]] {
        c.vertex_2f(x, y);
    }
    c.end();
    c.end_transform_feedback();
    c.use_program(0);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    c.vertex_pointer(4, GL_FLOAT, 0, Data::Offset(0));
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.draw_arrays(GL_TRIANGLES, 0, 3);
    fine(&mut c);
    for (x, y, white) in [(15, 0, true), (8, 4, true), (4, 8, false), (0, 15, false)] {
        let mut pixel = [0; 4];
        c.read_pixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
        assert_eq!(pixel == [255; 4], white, "{x}, {y}");
    }
}

/// Whatever fills the lanes, each vertex is its own: the reference is the same sum in `f32`.
#[test]
fn every_count_of_vertices_gives_the_same_values() {
    let vertex = "#version 130\nout float sum; void main() {\n\
        float s = 0.0; for (int i = 0; i <= gl_VertexID % 9; i++) s += 0.1 * float(i);\n\
        sum = s; gl_Position = vec4(0.0, 0.0, 0.0, 1.0); }";
    let expected = |at: i32| (0..=at % 9).fold(0.0_f32, |sum, i| sum + 0.1 * i as f32);
    for count in [1, 63, 64, 65, 200] {
        let mut c = context();
        capturing(&mut c, vertex, &["sum"], GL_INTERLEAVED_ATTRIBS);
        buffer(&mut c, 1, 0, 200);
        c.begin_transform_feedback(GL_POINTS);
        c.draw_arrays(GL_POINTS, 0, count);
        c.end_transform_feedback();
        let found = floats(&mut c, 1, count as usize);
        assert_eq!(found, (0..count).map(expected).collect::<Vec<_>>());
        fine(&mut c);
    }
}

/// Interleaved varyings need one buffer alone; one that is deleted while it is written to takes
/// nothing more.
#[test]
fn one_buffer_is_enough_for_interleaved_varyings_and_may_go() {
    let mut c = context();
    capturing(&mut c, NUMBER, &["number", "gl_Position"], GL_INTERLEAVED_ATTRIBS);
    buffer(&mut c, 1, 0, 16);
    c.begin_transform_feedback(GL_POINTS);
    c.delete_buffers(1, &[1]);
    c.gen_queries(1, &mut [0]);
    c.begin_query(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 1);
    c.draw_arrays(GL_POINTS, 0, 3);
    c.end_query(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
    c.end_transform_feedback();
    assert_eq!(result(&mut c, 1), 0);
}

/// What the geometry stage gives each vertex besides: layer, viewport and number of the primitive, whether or not there
/// are such (GLSL 1.50, section 7.1.3; ARB_viewport_array).
#[test]
fn layers_viewports_and_numbers_of_primitives_are_captured() {
    let mut c = context();
    let vertex = "#version 150\nvoid main() { gl_Position = vec4(0.0, 0.0, 0.0, 1.0); }";
    let program = shading::use_program(&mut c, vertex, "");
    let geometry = c.create_shader(GL_GEOMETRY_SHADER);
    let source = "#version 150\n#extension GL_ARB_viewport_array : require\n\
        layout(points) in; layout(points, max_vertices = 2) out;\n\
        void main() {\n\
          for (int i = 0; i < 2; i++) {\n\
            gl_Position = gl_in[0].gl_Position; gl_Layer = -70000 + i; gl_ViewportIndex = 3 * i;\n\
            gl_PrimitiveID = 65537 * gl_PrimitiveIDIn + i; EmitVertex();\n\
          }\n\
        }";
    c.shader_source(geometry, 1, Strings(vec![source]), &[]);
    c.compile_shader(geometry);
    c.attach_shader(program, geometry);
    let names = ["gl_Layer", "gl_PrimitiveID", "gl_ViewportIndex"];
    c.transform_feedback_varyings(program, 3, Names(names.to_vec()), GL_INTERLEAVED_ATTRIBS);
    c.link_program(program);
    assert_eq!(log(&mut c, program), "");
    c.use_program(program);
    for (index, name) in names.into_iter().enumerate() {
        let (mut size, mut ty, mut found) = ([0], [0], String::new());
        let out = TextOut::String(&mut found);
        c.get_transform_feedback_varying(
            program,
            index as GLuint,
            64,
            &mut [],
            &mut size,
            &mut ty,
            out,
        );
        assert_eq!((&*found, size[0], ty[0]), (name, 1, GL_INT));
    }
    buffer(&mut c, 1, 0, 18);
    c.enable(GL_RASTERIZER_DISCARD);
    c.begin_transform_feedback(GL_POINTS);
    c.draw_arrays(GL_POINTS, 0, 3);
    c.end_transform_feedback();
    let of = |n: i32, i: i32| [-70_000 + i, 65_537 * n + i, 3 * i].map(|word| word as u32);
    let expected: Vec<u32> = (0..3).flat_map(|n| (0..2).flat_map(move |i| of(n, i))).collect();
    assert_eq!(words(&mut c, 1, 18), expected);
    // A vertex shader has none of them.
    let other = shading::use_program(&mut c, vertex, "");
    let of_vertex = Names(vec!["gl_PrimitiveID"]);
    c.transform_feedback_varyings(other, 1, of_vertex, GL_INTERLEAVED_ATTRIBS);
    c.link_program(other);
    assert!(log(&mut c, other).contains("cannot capture `gl_PrimitiveID`"));
}

/// Members of arrays of blocks are named with the number of the instance (GL 3.2, section 2.11.4).
#[test]
fn members_of_one_of_several_blocks_are_captured() {
    let mut c = context();
    let vertex = "#version 150\nout Block { vec2 v; flat ivec2 n[3]; } many[3];\n\
        void main() {\n\
          gl_Position = vec4(0.0);\n\
          for (int i = 0; i < 3; i++) {\n\
            many[i].v = vec2(i, 0.5);\n\
            for (int j = 0; j < 3; j++) many[i].n[j] = ivec2(100 * i + j, -1 - i);\n\
          }\n\
        }";
    let names = ["Block[2].v", "Block[1].n[2]", "Block[0].n"];
    let program = capturing(&mut c, vertex, &names, GL_INTERLEAVED_ATTRIBS);
    let (mut size, mut ty, mut name) = ([0], [0], String::new());
    let out = TextOut::String(&mut name);
    c.get_transform_feedback_varying(program, 2, 64, &mut [], &mut size, &mut ty, out);
    assert_eq!((&*name, size[0], ty[0]), ("Block[0].n", 3, GL_INT_VEC2));
    buffer(&mut c, 1, 0, 10);
    c.enable(GL_RASTERIZER_DISCARD);
    c.begin_transform_feedback(GL_POINTS);
    c.draw_arrays(GL_POINTS, 0, 1);
    c.end_transform_feedback();
    let [two, half] = [2.0_f32, 0.5].map(f32::to_bits);
    let rest = [102, -2, 0, -1, 1, -1, 2, -1].map(|word: i32| word as u32);
    assert_eq!(words(&mut c, 1, 10), [&[two, half][..], &rest].concat());
    for wrong in ["Block[3].v", "Block[0].w", "Block[0].v[0]", "many[0].v", "Block.v", "Block.v[1]"]
    {
        let names = Names(vec![wrong]);
        c.transform_feedback_varyings(program, 1, names, GL_INTERLEAVED_ATTRIBS);
        c.link_program(program);
        let log = log(&mut c, program);
        assert!(log.contains("cannot capture"), "{wrong}: {log}");
    }
}

/// Arrays without a size in blocks of arrays of arrays are as long as their largest index needs.
#[test]
fn arrays_in_arrays_of_blocks_get_their_size_from_indices() {
    let mut c = context();
    let vertex = "#version 150\n#extension GL_ARB_arrays_of_arrays : require\n\
        out Block { vec2 a[][2]; } many[2][2];\n\
        void main() { many[1][0].a[2][1] = vec2(3.0, 4.0); gl_Position = vec4(0.0); }";
    let fragment = "#version 150\n#extension GL_ARB_arrays_of_arrays : require\n\
        in Block { vec2 a[][2]; } many[2][2];\n\
        out vec4 color;\n\
        void main() { color = vec4(many[1][0].a[1][1], many[1][0].a[2][1]); }";
    let program = shading::use_program(&mut c, vertex, fragment);
    assert_eq!(log(&mut c, program), "");
    c.draw_arrays(GL_POINTS, 0, 1);
    fine(&mut c);
}
