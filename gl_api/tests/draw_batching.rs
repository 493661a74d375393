//! Batched draws, and draws that reuse the state of the draw before, with writes to what they read in between: picture,
//! pixels that are read on the way, samples passed, errors and messages are those of draws that are each finished
//! before the next call.

#[path = "common/random.rs"]
mod random;
#[path = "common/shading.rs"]
mod shading;
#[path = "common/ways.rs"]
mod ways;

use gl_api::*;
use proptest::prelude::*;
use random::Random;
use ways::{Way, picture};

const SIZE: u32 = 200;
/// Vertices of each buffer: two floats and four bytes.
const VERTICES: usize = 2000;
const STRIDE: usize = 12;
const INDICES: usize = 4000;
const RESTART: u16 = 0xFFFF;

impl Random {
    fn vertex(&mut self) -> [u8; STRIDE] {
        let mut bytes = [0; STRIDE];
        bytes[..4].copy_from_slice(&self.float().to_le_bytes());
        bytes[4..8].copy_from_slice(&self.float().to_le_bytes());
        bytes[8..].fill_with(|| self.below(256) as u8);
        bytes
    }

    /// Indices near one another, or as far apart as possible.
    fn index(&mut self) -> u16 {
        match self.below(40) {
            0 => RESTART,
            1 => VERTICES as u16 - 1,
            2 => VERTICES as u16,
            other => other as u16,
        }
    }
}

const PLAIN: [&str; 2] = [
    "uniform vec2 move; attribute vec2 position; attribute vec4 color; attribute vec2 instance;
     varying vec4 shade; varying vec2 place;
     void main() { shade = color; place = position;
         gl_Position = vec4(position * 0.3 + move + instance, 0.0, 1.0); }",
    "uniform sampler2D image; varying vec4 shade; varying vec2 place;
     void main() { gl_FragColor = shade + 0.5 * texture2D(image, place); }",
];
const NUMBERED: [&str; 2] = [
    "#version 120
     #extension GL_EXT_gpu_shader4 : require
     uniform vec2 move; attribute vec2 position; attribute vec4 color; attribute vec2 instance;
     varying vec4 shade;
     void main() { shade = color * float(gl_VertexID % 7) / 7.0;
         gl_Position = vec4(position * 0.3 + move + instance, 0.0, 1.0); }",
    "#version 120
     #extension GL_EXT_gpu_shader4 : require
     varying vec4 shade;
     void main() { gl_FragColor = shade + vec4(float(gl_PrimitiveID % 5) / 9.0); }",
];
const LOOPING: [&str; 2] = [
    PLAIN[0],
    "uniform vec2 move; varying vec4 shade;
     void main() { gl_FragColor = shade;
         for (int i = 0; i < int(move.x * 9.0); i++) gl_FragColor *= 0.9; }",
];

fn context(random: &mut Random) -> Context {
    let desc = ContextDesc { width: SIZE, height: SIZE, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a device");
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    c.enable(GL_BLEND);
    c.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    let [vertex, fragment] = random.pick(&[PLAIN, PLAIN, NUMBERED, LOOPING]);
    let program = shading::use_program(&mut c, vertex, fragment);
    for (location, name) in ["position", "color", "instance"].into_iter().enumerate() {
        c.bind_attrib_location(program, location as GLuint, name);
    }
    c.link_program(program);
    c.use_program(program);
    let texels: Vec<u8> = (0..512 * 512 * 4).map(|at| (at % 251) as u8).collect();
    let data = Data::Bytes(&texels);
    c.tex_image_2d(
        GL_TEXTURE_2D,
        0,
        GL_RGBA8 as GLint,
        512,
        512,
        0,
        GL_RGBA,
        GL_UNSIGNED_BYTE,
        data,
    );
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR as GLint);
    for buffer in 1..=2 {
        let vertices: Vec<u8> = (0..VERTICES).flat_map(|_| random.vertex()).collect();
        c.bind_buffer(GL_ARRAY_BUFFER, buffer);
        c.buffer_data(GL_ARRAY_BUFFER, vertices.len() as _, Data::Bytes(&vertices), GL_STREAM_DRAW);
    }
    let indices: Vec<u8> = (0..INDICES).flat_map(|_| random.index().to_le_bytes()).collect();
    c.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, 3);
    let data = Data::Bytes(&indices);
    c.buffer_data(GL_ELEMENT_ARRAY_BUFFER, indices.len() as _, data, GL_STREAM_DRAW);
    c.primitive_restart_index(RESTART.into());
    if random.below(2) == 0 {
        c.enable(GL_PRIMITIVE_RESTART);
    }
    if random.below(3) == 0 {
        c.polygon_mode(GL_FRONT_AND_BACK, GL_LINE);
        c.enable(GL_LINE_STIPPLE);
        c.line_stipple(2, 0xA53C);
    }
    arrays(&mut c, 1);
    c
}

/// Reads positions and colours from a buffer.
fn arrays(c: &mut Context, buffer: GLuint) {
    c.bind_buffer(GL_ARRAY_BUFFER, buffer);
    let stride = STRIDE as GLsizei;
    c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, stride, Data::Offset(0));
    c.vertex_attrib_pointer(1, 4, GL_UNSIGNED_BYTE, true, stride, Data::Offset(8));
    c.enable_vertex_attrib_array(0);
    c.enable_vertex_attrib_array(1);
}

fn draw(c: &mut Context, random: &mut Random, modes: &[GLenum]) {
    let mode = random.pick(modes);
    let first = random.pick(&[0, 3, 6, 9, 1990, 1998]);
    let count = random.pick(&[0, 3, 3, 3, 6, 6, 4, 1]);
    let at = Data::Offset(2 * random.below(3900) as usize);
    match random.below(7) {
        0 => {
            c.multi_draw_arrays(mode, &[first, 30, 33, 0], &[count, 3, 3, 6], 4);
        }
        1 => c.draw_elements(mode, count, GL_UNSIGNED_SHORT, at),
        2 => c.draw_elements_base_vertex(mode, 6, GL_UNSIGNED_SHORT, at, 2),
        3 => c.draw_elements_instanced(mode, 9, GL_UNSIGNED_SHORT, at, 3),
        4 => c.draw_arrays_instanced(mode, first, count, 2),
        _ => c.draw_arrays(mode, first, count),
    }
}

fn change(c: &mut Context, random: &mut Random, pixels: &mut Vec<u8>) {
    let vertex = random.vertex();
    let at = (random.below(VERTICES as u64) as usize % 40 * STRIDE) as GLintptr;
    match random.below(18) {
        0 => c.buffer_sub_data(GL_ARRAY_BUFFER, at, STRIDE as _, Data::Bytes(&vertex)),
        1 => {
            let index = random.index().to_le_bytes();
            c.buffer_sub_data(GL_ELEMENT_ARRAY_BUFFER, at / 2 * 2, 2, Data::Bytes(&index));
        }
        2 => {
            c.map_buffer_range(GL_ARRAY_BUFFER, at, STRIDE as _, GL_MAP_WRITE_BIT);
            c.mapped_bytes(GL_ARRAY_BUFFER).expect("mapped").copy_from_slice(&vertex);
            c.unmap_buffer(GL_ARRAY_BUFFER);
        }
        3 => {
            let (x, y) = (random.below(500) as GLint, random.below(500) as GLint);
            let texels = Data::Bytes(&vertex);
            c.tex_sub_image_2d(GL_TEXTURE_2D, 0, x, y, 1, 3, GL_RGBA, GL_UNSIGNED_BYTE, texels);
        }
        4 => arrays(c, random.pick(&[1, 2])),
        5 => {
            let mut program = [0];
            c.get_integerv(GL_CURRENT_PROGRAM, &mut program);
            let place = c.get_uniform_location(program[0] as GLuint, "move");
            c.uniform_2f(place, random.float() * 0.5, random.float() * 0.5);
        }
        6 => {
            c.bind_buffer(GL_ARRAY_BUFFER, 2);
            c.vertex_attrib_pointer(2, 2, GL_FLOAT, false, STRIDE as _, Data::Offset(0));
            c.enable_vertex_attrib_array(2);
            c.vertex_attrib_divisor(2, random.pick(&[1, 2]));
        }
        7 => c.disable_vertex_attrib_array(2),
        8 => {
            let mut pixel = [0; 4 * 16];
            let (x, y) = (random.below(190) as GLint, random.below(190) as GLint);
            let data = DataOut::Bytes(&mut pixel);
            c.read_pixels(x, y, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, data);
            pixels.extend(pixel);
        }
        9 => {
            let (x, y) = (random.below(190) as GLint, random.below(190) as GLint);
            c.copy_tex_sub_image_2d(GL_TEXTURE_2D, 0, 7, 9, x, y, 8, 8);
        }
        10 => c.vertex_attrib_4f(2, random.float() * 0.3, 0.0, 0.0, 1.0),
        11 => {
            c.begin(GL_TRIANGLES);
            (0..3).for_each(|_| c.vertex_attrib_4f(0, random.float(), random.float(), 0.0, 1.0));
            c.end();
        }
        12 => {
            c.new_list(1, random.pick(&[GL_COMPILE, GL_COMPILE_AND_EXECUTE]));
            draw(c, random, &[GL_TRIANGLES, GL_TRIANGLE_STRIP]);
            c.end_list();
        }
        13 => c.call_list(1),
        14..17 => set_maybe(c, random),
        _ => {
            c.enable(GL_SCISSOR_TEST);
            c.scissor(20, 20, random.below(150) as GLsizei, 150);
            c.clear(random.pick(&[0, GL_COLOR_BUFFER_BIT]));
        }
    }
}

/// Sets state to values that it may have already.
fn set_maybe(c: &mut Context, random: &mut Random) {
    let first = random.below(2) == 0;
    let cap = random.pick(&[GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_CLIP_PLANE0]);
    match random.below(5) {
        0 if first => c.enable(cap),
        0 => c.disable(cap),
        1 => c.bind_texture(GL_TEXTURE_2D, random.pick(&[0, 0, 7])),
        2 => {
            let filter = if first { GL_LINEAR } else { GL_NEAREST };
            c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter as GLint);
        }
        3 => {
            let mode = if first { GL_MODULATE } else { GL_REPLACE };
            c.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode as GLint);
        }
        _ => {
            let mut program = [0];
            c.get_integerv(GL_CURRENT_PROGRAM, &mut program);
            let place = c.get_uniform_location(program[0] as GLuint, "move");
            c.uniform_2f(place, if first { 0.25 } else { 0.0 }, 0.1);
        }
    }
}

/// The pixels that were read and the picture, the samples that passed, the error, and the messages.
type Outcome = (Vec<u8>, GLuint, GLenum, Vec<String>);

fn outcome(seed: u64, way: Way) -> Outcome {
    let mut random = Random(seed);
    let c = &mut context(&mut random);
    let modes: &[GLenum] = random.pick(&[
        &[GL_TRIANGLES][..],
        &[GL_POINTS, GL_LINES, GL_TRIANGLES, GL_TRIANGLES, GL_QUADS],
        &[GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_LINE_STRIP, GL_POLYGON],
    ]);
    let (rarely, mut pixels) = (random.pick(&[2, 4, 12]), Vec::new());
    c.begin_query(GL_SAMPLES_PASSED, 1);
    for _ in 0..random.below(60) + 5 {
        if random.below(rarely) == 0 {
            change(c, &mut random, &mut pixels);
        } else {
            draw(c, &mut random, modes);
        }
        way.go_on(c);
    }
    c.end_query(GL_SAMPLES_PASSED);
    let mut passed = [0];
    c.get_query_objectuiv(1, GL_QUERY_RESULT, &mut passed);
    pixels.extend(picture(c, SIZE));
    let messages = c.messages().into_iter().map(|message| message.text).collect();
    (pixels, passed[0], c.get_error(), messages)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn batched_draws_are_as_draws_that_are_finished_one_by_one(seed: u64) {
        let (apart, together) = (outcome(seed, Way::Apart), outcome(seed, Way::Together));
        prop_assert_eq!((&together.1, &together.2), (&apart.1, &apart.2));
        prop_assert_eq!(&together.3, &apart.3);
        prop_assert!(together.0 == apart.0, "the picture differs");
    }
}
