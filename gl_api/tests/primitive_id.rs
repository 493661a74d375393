//! `gl_PrimitiveID` (`EXT_gpu_shader4`): the number of the primitive within the draw, whatever vertices
//! primitives share, however they are clipped, and however many there are.

#[path = "common/shading.rs"]
mod shading;

use gl_api::*;

const SIZE: i32 = 16;

/// A program that draws the number as a colour: 8 bits in each of red, green, blue.
fn context() -> Context {
    let desc = ContextDesc { width: SIZE as u32, height: SIZE as u32, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a device");
    let fragment = "#version 120\n#extension GL_EXT_gpu_shader4 : require\n\
        void main() {\n\
          unsigned int n = unsigned int(gl_PrimitiveID);\n\
          uvec3 bytes = uvec3(n & 255u, n >> 8 & 255u, n >> 16 & 255u);\n\
          gl_FragColor = vec4(vec3(bytes) / 255.0, 1.0);\n\
        }";
    shading::use_program(&mut c, "void main() { gl_Position = gl_Vertex; }", fragment);
    c
}

/// The number at a pixel; `None` where nothing was drawn.
fn number(c: &mut Context, x: i32, y: i32) -> Option<u32> {
    let mut p = [0; 4];
    c.read_pixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut p));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    (p[3] != 0).then(|| u32::from_le_bytes([p[0], p[1], p[2], 0]))
}

/// Window coordinates as normalized ones.
fn at(pixel: f32) -> f32 {
    pixel / (SIZE as f32 / 2.0) - 1.0
}

/// Corners of cells of 4 × 4 pixels, row by row.
fn grid() -> Vec<[f32; 2]> {
    (0..25).map(|i| [at((i % 5 * 4) as f32), at((i / 5 * 4) as f32)]).collect()
}

/// A grid by index, all vertices shared: two triangles, or one quadrilateral, a cell.
#[test]
fn shared_vertices_have_the_number_of_each_primitive() {
    for (mode, halves) in [(GL_TRIANGLES, 2), (GL_QUADS, 1)] {
        let mut c = context();
        let corners = grid();
        let mut indices: Vec<u32> = Vec::new();
        for cell in 0..16_u32 {
            let [a, b] = [cell / 4 * 5 + cell % 4, cell / 4 * 5 + cell % 4 + 1];
            // The diagonal goes up to the right.
            match halves {
                2 => indices.extend([a, b, b + 5, a, b + 5, a + 5]),
                _ => indices.extend([a, b, b + 5, a + 5]),
            }
        }
        c.enable_client_state(GL_VERTEX_ARRAY);
        c.vertex_pointer(2, GL_FLOAT, 0, corners.as_flattened().arg());
        let count = indices.len() as i32;
        let data = Data::Bytes(bytemuck::cast_slice(&indices));
        c.draw_elements(mode, count, GL_UNSIGNED_INT, data);
        for cell in 0..16 {
            let (x, y) = (cell % 4 * 4, cell / 4 * 4);
            let expected = [cell * halves, cell * halves + halves - 1].map(|n| Some(n as u32));
            assert_eq!([number(&mut c, x + 2, y + 1), number(&mut c, x + 1, y + 2)], expected);
        }
    }
}

/// A strip of four cells along the bottom.
fn band(mode: GLenum) -> Context {
    let mut c = context();
    c.begin(mode);
    for i in 0..5 {
        c.vertex_2f(at((i * 4) as f32), at(0.0));
        c.vertex_2f(at((i * 4) as f32), at(4.0));
    }
    c.end();
    c
}

/// Strips, fans and loops: each primitive ends at a vertex of its own.
#[test]
fn strips_fans_and_loops_count_on() {
    // A band of triangles, two a cell.
    let mut c = band(GL_TRIANGLE_STRIP);
    for cell in 0..4 {
        assert_eq!(number(&mut c, cell * 4, 1), Some(cell as u32 * 2));
        assert_eq!(number(&mut c, cell * 4 + 3, 2), Some(cell as u32 * 2 + 1));
    }
    // The same as quadrilaterals.
    let mut c = band(GL_QUAD_STRIP);
    for cell in 0..4 {
        assert_eq!(number(&mut c, cell * 4, 1), Some(cell as u32));
        assert_eq!(number(&mut c, cell * 4 + 3, 2), Some(cell as u32));
    }
    // Around a square: the closing line is the last one.
    let mut c = context();
    c.begin(GL_LINE_LOOP);
    for [x, y] in [[2.5, 2.5], [12.5, 2.5], [12.5, 12.5], [2.5, 12.5]] {
        c.vertex_2f(at(x), at(y));
    }
    c.end();
    for ((x, y), expected) in [((7, 2), 0), ((12, 7), 1), ((7, 12), 2), ((2, 7), 3)] {
        assert_eq!(number(&mut c, x, y), Some(expected));
    }
    // A fan around the middle of the window's bottom, and a polygon, which is one primitive.
    for (mode, expected) in [(GL_TRIANGLE_FAN, [0, 1, 2]), (GL_POLYGON, [0; 3])] {
        let mut c = context();
        c.begin(mode);
        for [x, y] in [[8.0, 0.0], [16.0, 0.0], [16.0, 16.0], [0.0, 16.0], [0.0, 0.0]] {
            c.vertex_2f(at(x), at(y));
        }
        c.end();
        let found = [(14, 2), (8, 12), (2, 2)].map(|(x, y)| number(&mut c, x, y));
        assert_eq!(found, expected.map(Some), "{}", enum_name(mode));
    }
}

/// More than 16 bits hold, in each instance anew; clipping and polygon modes change no number.
#[test]
fn large_numbers_clipped_triangles_and_instances() {
    let mut c = context();
    let count = 70_000;
    let mut points = vec![[5.0_f32, 5.0]; count];
    points[count - 1] = [at(8.5), at(8.5)];
    points[65_536] = [at(1.5), at(1.5)];
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.vertex_pointer(2, GL_FLOAT, 0, points.as_flattened().arg());
    c.draw_arrays_instanced(GL_POINTS, 0, count as i32, 2);
    assert_eq!(number(&mut c, 8, 8), Some(69_999));
    assert_eq!(number(&mut c, 1, 1), Some(65_536));
    assert_eq!(number(&mut c, 4, 4), None);
    let mut c = context();
    c.polygon_mode(GL_FRONT_AND_BACK, GL_LINE);
    c.begin(GL_TRIANGLES);
    for triangle in 0..2 {
        for [x, y] in [[-9.0, -3.5], [20.5, 3.5], [2.5, 30.5]] {
            c.vertex_2f(at(x), at(y + triangle as f32 * 4.0));
        }
    }
    c.end();
    let mut found: Vec<u32> = Vec::new();
    for y in 0..SIZE {
        found.extend((0..SIZE).filter_map(|x| number(&mut c, x, y)));
    }
    found.sort_unstable();
    found.dedup();
    assert_eq!(found, [0, 1]);
}

/// Without the extension the name is free.
#[test]
fn the_name_needs_the_extension() {
    let mut c = context();
    let shader = c.create_shader(GL_FRAGMENT_SHADER);
    let text = "#version 130\nvoid main() { gl_FragColor = vec4(gl_PrimitiveID); }";
    c.shader_source(shader, 1, Strings(vec![text]), &[]);
    c.compile_shader(shader);
    let (mut log, mut length) = (vec![0; 4096], [0]);
    c.get_shader_info_log(shader, 4096, &mut length, TextOut::Bytes(&mut log));
    let log = String::from_utf8_lossy(&log[..length[0] as usize]).into_owned();
    assert!(log.contains("#extension GL_EXT_gpu_shader4 : enable"), "{log}");
}
