//! Where vertices come from: every way to say the same triangles gives the same picture; buffers in
//! the client's hands; the errors of each call.

mod bindings;
mod instances;
mod runs;
mod uploads;

use gl_api::*;

const SIZE: GLsizei = 16;

fn context() -> Context {
    let desc = ContextDesc { width: SIZE as u32, height: SIZE as u32, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a device");
    c.clear_color(0.1, 0.2, 0.3, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    c
}

fn picture(c: &mut Context) -> Vec<u8> {
    let mut pixels = vec![0; (SIZE * SIZE * 4) as usize];
    c.read_pixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixels));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    assert!(pixels.chunks(4).any(|pixel| pixel != &pixels[..4]), "nothing was drawn");
    pixels
}

fn integer(c: &mut Context, pname: GLenum) -> GLint {
    let mut value = [0];
    c.get_integerv(pname, &mut value);
    value[0]
}

/// x, y of two triangles.
const CORNERS: [f32; 12] = [-0.9, -0.9, 0.1, -0.9, -0.9, 0.1, 0.9, 0.9, -0.1, 0.9, 0.9, -0.1];

fn program(c: &mut Context, vertex: &str, fragment: &str) -> GLuint {
    let program = c.create_program();
    for (kind, text) in [(GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, fragment)] {
        let shader = c.create_shader(kind);
        c.shader_source(shader, 1, text.arg(), NULL.arg());
        c.compile_shader(shader);
        c.attach_shader(program, shader);
    }
    c.bind_attrib_location(program, 0, "position");
    c.bind_attrib_location(program, 1, "extra");
    c.link_program(program);
    let mut log = String::new();
    c.get_program_info_log(program, 4096, NULL.arg(), TextOut::String(&mut log));
    assert_eq!(log, "");
    c.use_program(program);
    program
}

#[test]
fn every_way_to_say_two_triangles_gives_the_same_picture() {
    type Way = (&'static str, fn(&mut Context));
    let ways: &[Way] = &[
        ("arrays", |c| c.draw_arrays(GL_TRIANGLES, 0, 6)),
        ("elements", |c| {
            let indices = Data::Bytes(&[0, 1, 2, 3, 4, 5]);
            c.draw_elements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, indices);
        }),
        ("several runs", |c| c.multi_draw_arrays(GL_TRIANGLES, &[3, 0], &[3, 3], 2)),
        ("runs of nothing", |c| {
            c.multi_draw_arrays(GL_TRIANGLES, &[3, -1, 0], &[3, 0, 3], 3);
        }),
        ("several runs of indices", |c| {
            let runs: [&[u8]; 2] = [&[5, 3, 4], &[0, 1, 2]];
            let runs = Pointers(runs.map(Data::Bytes).to_vec());
            c.multi_draw_elements(GL_TRIANGLES, &[3, 3], GL_UNSIGNED_BYTE, runs, 2);
        }),
        ("runs of no indices", |c| {
            let runs = [Data::Bytes(&[0, 1, 2]), Data::Offset(99), Data::Bytes(&[4, 5, 6])];
            let (runs, ty) = (Pointers(runs.to_vec()), GL_UNSIGNED_BYTE);
            c.multi_draw_elements_base_vertex(GL_TRIANGLES, &[3, 0, 3], ty, runs, 3, &[0, 9, -1]);
        }),
        ("a base vertex", |c| {
            let indices: Vec<u8> =
                [10u16, 11, 12, 13, 14, 15].iter().flat_map(|i| i.to_ne_bytes()).collect();
            let indices = Data::Bytes(&indices);
            c.draw_elements_base_vertex(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, indices, -10);
        }),
        ("instances", |c| c.draw_arrays_instanced(GL_TRIANGLES, 0, 6, 3)),
        ("restarted fans", |c| {
            c.enable(GL_PRIMITIVE_RESTART);
            c.primitive_restart_index(200);
            assert_eq!(integer(c, GL_PRIMITIVE_RESTART_INDEX), 200);
            let indices = Data::Bytes(&[0, 1, 2, 200, 200, 3, 4, 5, 200]);
            c.draw_elements(GL_TRIANGLE_FAN, 9, GL_UNSIGNED_BYTE, indices);
        }),
        ("elements one by one", |c| {
            c.begin(GL_TRIANGLES);
            for i in 0..6 {
                c.array_element(i);
            }
            c.end();
        }),
        ("restarts by hand", |c| {
            c.enable_client_state(GL_PRIMITIVE_RESTART_NV);
            assert!(c.is_enabled(GL_PRIMITIVE_RESTART_NV));
            assert_eq!(integer(c, GL_PRIMITIVE_RESTART_NV), 1);
            c.primitive_restart_index(77);
            c.begin(GL_TRIANGLE_STRIP);
            for i in [0, 1, 2, 77, 3] {
                c.array_element(i);
            }
            c.array_element(4);
            c.array_element(5);
            c.primitive_restart();
            c.end();
        }),
        ("a buffer that was mapped", |c| {
            c.bind_buffer(GL_ARRAY_BUFFER, 4);
            let size = size_of_val(&CORNERS) as GLsizeiptr;
            c.buffer_data(GL_ARRAY_BUFFER, size, Data::Null, GL_STATIC_DRAW);
            assert!(!c.map_buffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY).is_null());
            let bytes = c.mapped_bytes(GL_ARRAY_BUFFER).expect("is mapped");
            bytes.copy_from_slice(bytemuck::cast_slice(&CORNERS));
            assert!(c.unmap_buffer(GL_ARRAY_BUFFER));
            c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
            c.draw_arrays(GL_TRIANGLES, 0, 6);
        }),
        ("a vertex array object", |c| {
            let mut names = [0; 2];
            c.gen_vertex_arrays(2, &mut names);
            c.bind_vertex_array(names[0]);
            assert!(!c.is_enabled(GL_VERTEX_ARRAY));
            c.enable_client_state(GL_VERTEX_ARRAY);
            c.bind_buffer(GL_ARRAY_BUFFER, 4);
            c.buffer_data(GL_ARRAY_BUFFER, 48, Data::Bytes(&[0; 48]), GL_STATIC_DRAW);
            c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
            c.bind_vertex_array(0);
            assert!(c.is_vertex_array(names[0]) && !c.is_vertex_array(names[1]));
            c.delete_vertex_arrays(2, &names);
            c.draw_arrays(GL_TRIANGLES, 0, 6);
        }),
    ];
    let mut first = None;
    for (name, draw) in ways {
        let mut c = context();
        c.enable_client_state(GL_VERTEX_ARRAY);
        c.vertex_pointer(2, GL_FLOAT, 0, CORNERS.as_slice().arg());
        draw(&mut c);
        let got = picture(&mut c);
        assert!(first.get_or_insert_with(|| got.clone()) == &got, "{name}");
    }
}

/// Half floats (GL 3.0, table 2.5) of every array that takes them are the floats they stand for.
#[test]
fn half_floats_are_their_floats() {
    /// -0.75, 0.5, 1, 0.25 and 0 as bits of half floats.
    const HALF: [(f32, u16); 5] =
        [(-0.75, 0xBA00), (0.5, 0x3800), (1.0, 0x3C00), (0.25, 0x3400), (0.0, 0)];
    let floats: Vec<f32> = [0, 0, 1, 0, 2, 2].map(|at| HALF[at].0).to_vec();
    let shades: Vec<f32> = [2, 3, 4, 4, 1, 2, 3, 2, 1].map(|at| HALF[at].0).to_vec();
    let half = |floats: &[f32]| -> Vec<u16> {
        let bits = |value| HALF.iter().find(|(float, _)| *float == value).map(|(_, bits)| *bits);
        floats.iter().map(|value| bits(*value).expect("a row of HALF")).collect()
    };
    type Arrays = fn(&mut Context, [Data<'_>; 2], GLenum);
    let ways: [Arrays; 2] = [
        |c, [place, shade], ty| {
            c.enable_client_state(GL_VERTEX_ARRAY);
            c.enable_client_state(GL_COLOR_ARRAY);
            c.vertex_pointer(2, ty, 0, place);
            c.color_pointer(3, ty, 0, shade);
        },
        |c, [place, shade], ty| {
            let vertex = "attribute vec2 position; attribute vec3 extra; varying vec3 v;\n\
                void main() { v = extra; gl_Position = vec4(position, 0.0, 1.0); }";
            program(c, vertex, "varying vec3 v; void main() { gl_FragColor = vec4(v, 1.0); }");
            c.enable_vertex_attrib_array(0);
            c.enable_vertex_attrib_array(1);
            c.vertex_attrib_pointer(0, 2, ty, false, 0, place);
            c.vertex_attrib_pointer(1, 3, ty, true, 0, shade);
        },
    ];
    for way in ways {
        let mut c = context();
        way(&mut c, [floats.as_slice().arg(), shades.as_slice().arg()], GL_FLOAT);
        c.draw_arrays(GL_TRIANGLES, 0, 3);
        let expected = picture(&mut c);
        let mut c = context();
        let (places, colors) = (half(&floats), half(&shades));
        way(&mut c, [places.as_slice().arg(), colors.as_slice().arg()], GL_HALF_FLOAT);
        c.draw_arrays(GL_TRIANGLES, 0, 3);
        assert_eq!(picture(&mut c), expected);
    }
}

#[test]
fn interleaved_arrays_are_their_pointers() {
    // Format, floats of texture coordinates, colour and normal before the position, its size.
    let rows: &[(GLenum, usize, usize, usize, usize)] = &[
        (GL_V2F, 0, 0, 0, 2),
        (GL_V3F, 0, 0, 0, 3),
        (GL_C3F_V3F, 0, 3, 0, 3),
        (GL_N3F_V3F, 0, 0, 3, 3),
        (GL_C4F_N3F_V3F, 0, 4, 3, 3),
        (GL_T2F_V3F, 2, 0, 0, 3),
        (GL_T4F_V4F, 4, 0, 0, 4),
        (GL_T2F_C3F_V3F, 2, 3, 0, 3),
        (GL_T2F_N3F_V3F, 2, 0, 3, 3),
        (GL_T2F_C4F_N3F_V3F, 2, 4, 3, 3),
        (GL_T4F_C4F_N3F_V4F, 4, 4, 3, 4),
    ];
    for &(format, tex_coord, color, normal, position) in rows {
        let mut direct = context();
        let mut bytes: Vec<f32> = Vec::new();
        direct.begin(GL_TRIANGLES);
        for (index, corner) in CORNERS.chunks(2).enumerate() {
            let shade = 0.1 + index as f32 / 8.0;
            bytes.extend([shade, 0.5, 0.25, 1.0].iter().take(tex_coord));
            let rgba = [shade, 1.0 - shade, 0.5, 0.75];
            bytes.extend(rgba.iter().take(color));
            bytes.extend([0.0, 0.0, 1.0].iter().take(normal));
            bytes.extend([corner[0], corner[1], 0.0, 1.0].iter().take(position));
            match color {
                0 => {}
                3 => direct.color_3f(rgba[0], rgba[1], rgba[2]),
                _ => direct.color_4f(rgba[0], rgba[1], rgba[2], rgba[3]),
            }
            direct.vertex_2f(corner[0], corner[1]);
        }
        direct.end();
        let mut c = context();
        let others =
            [GL_EDGE_FLAG_ARRAY, GL_INDEX_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY];
        others.iter().for_each(|&array| c.enable_client_state(array));
        c.interleaved_arrays(format, 0, bytes.as_slice().arg());
        c.draw_arrays(GL_TRIANGLES, 0, 6);
        assert!(picture(&mut direct) == picture(&mut c), "{}", enum_name(format));
        assert_eq!(c.is_enabled(GL_COLOR_ARRAY), color > 0);
        assert_eq!(c.is_enabled(GL_NORMAL_ARRAY), normal > 0);
        assert_eq!(c.is_enabled(GL_TEXTURE_COORD_ARRAY), tex_coord > 0);
        assert_eq!(others.map(|array| c.is_enabled(array)), [false; 4]);
    }
}

#[test]
fn integer_attributes_keep_all_their_bits() {
    let vertex = "#version 130\nin vec2 position; in ivec2 extra; flat out ivec2 value;\n\
        void main() { value = extra; gl_Position = vec4(position, 0.0, 1.0); }";
    let fragment = "#version 130\nflat in ivec2 value;\n\
        void main() { bool same = value == ivec2(-2147483647, 16777217);\n\
        gl_FragColor = same ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0); }";
    let mut c = context();
    program(&mut c, vertex, fragment);
    c.enable_vertex_attrib_array(0);
    c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 0, CORNERS.as_slice().arg());
    c.enable_vertex_attrib_array(1);
    let values: Vec<i32> = [-2_147_483_647, 16_777_217].repeat(6);
    c.vertex_attrib_i_pointer(1, 2, GL_INT, 0, values.as_slice().arg());
    c.draw_arrays(GL_TRIANGLES, 0, 6);
    let pixels = picture(&mut c);
    assert!(pixels.chunks(4).any(|pixel| pixel == [0, 255, 0, 255]));
    assert!(!pixels.chunks(4).any(|pixel| pixel == [255, 0, 0, 255]));
}

/// ARB_ES2_compatibility: generic attributes of 16 bits before the point and 16 behind it.
#[test]
fn fixed_point_attributes_are_their_quotients() {
    let vertex = "attribute vec2 position; attribute vec3 extra; varying vec3 value;
        void main() { value = extra; gl_Position = vec4(position, 0.0, 1.0); }";
    let fragment = "varying vec3 value; void main() {
        bool same = value == vec3(-1.5, 32767.0, 1.0 / 65536.0);
        gl_FragColor = same ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0); }";
    let mut c = context();
    program(&mut c, vertex, fragment);
    c.enable_vertex_attrib_array(0);
    c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 0, CORNERS.as_slice().arg());
    c.enable_vertex_attrib_array(1);
    let values: Vec<i32> = [-3 << 15, 32767 << 16, 1].repeat(6);
    // Normalization is of integers.
    for normalized in [false, true] {
        c.vertex_attrib_pointer(1, 3, GL_FIXED, normalized, 0, values.as_slice().arg());
        let mut ty = [0];
        c.get_vertex_attribiv(1, GL_VERTEX_ATTRIB_ARRAY_TYPE, &mut ty);
        assert_eq!(ty[0] as GLenum, GL_FIXED);
        c.draw_arrays(GL_TRIANGLES, 0, 6);
        let pixels = picture(&mut c);
        assert!(pixels.chunks(4).any(|pixel| pixel == [0, 255, 0, 255]));
        assert!(!pixels.chunks(4).any(|pixel| pixel == [255, 0, 0, 255]));
    }
    c.color_pointer(4, GL_FIXED, 0, values.as_slice().arg());
    assert_eq!(c.get_error(), GL_INVALID_ENUM, "colours are of no fixed-point numbers");
}

#[test]
fn mapped_buffers_belong_to_the_client() {
    let mut c = context();
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    c.buffer_data(GL_ARRAY_BUFFER, 8, Data::Bytes(&[1, 2, 3, 4, 5, 6, 7, 8]), GL_STATIC_DRAW);
    assert!(!c.map_buffer_range(GL_ARRAY_BUFFER, 2, 4, GL_MAP_WRITE_BIT).is_null());
    let bytes = c.mapped_bytes(GL_ARRAY_BUFFER).expect("is mapped");
    assert_eq!(bytes, [3, 4, 5, 6]);
    bytes[0] = 30;
    let mut value = [0];
    for (pname, expected) in [
        (GL_BUFFER_MAPPED, 1),
        (GL_BUFFER_SIZE, 8),
        (GL_BUFFER_MAP_OFFSET, 2),
        (GL_BUFFER_MAP_LENGTH, 4),
        (GL_BUFFER_ACCESS, GL_WRITE_ONLY as GLint),
    ] {
        c.get_buffer_parameteriv(GL_ARRAY_BUFFER, pname, &mut value);
        assert_eq!(value[0], expected, "{}", enum_name(pname));
    }
    let mut pointer = [std::ptr::null_mut()];
    c.get_buffer_pointerv(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &mut pointer);
    assert!(!pointer[0].is_null());
    assert!(c.unmap_buffer(GL_ARRAY_BUFFER));
    let mut all = [0; 8];
    c.get_buffer_sub_data(GL_ARRAY_BUFFER, 0, 8, DataOut::Bytes(&mut all));
    assert_eq!(all, [1, 2, 30, 4, 5, 6, 7, 8]);
    c.bind_buffer(GL_COPY_WRITE_BUFFER, 1);
    c.copy_buffer_sub_data(GL_ARRAY_BUFFER, GL_COPY_WRITE_BUFFER, 0, 5, 3);
    c.get_buffer_sub_data(GL_ARRAY_BUFFER, 0, 8, DataOut::Bytes(&mut all));
    assert_eq!(all, [1, 2, 30, 4, 5, 1, 2, 30]);
    assert_eq!(integer(&mut c, GL_COPY_WRITE_BUFFER), 1);
    // New bytes were never mapped (GL 2.1, table 2.7).
    c.buffer_data(GL_ARRAY_BUFFER, 8, Data::Null, GL_STATIC_DRAW);
    c.get_buffer_parameteriv(GL_ARRAY_BUFFER, GL_BUFFER_ACCESS, &mut value);
    assert_eq!(value[0] as GLenum, GL_READ_WRITE);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}
