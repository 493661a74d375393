//! Draws between which textures, samplers, uniform blocks, the contents of buffers, vertex array objects, programs or the
//! framebuffer are exchanged: the picture, the errors and the messages are those of draws that are each carried out before
//! the next call.

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

const SIZE: u32 = 64;

const VERTEX: &str = "#version 330 compatibility
    layout(location = 0) in vec4 position; layout(location = 1) in vec4 shade;
    layout(std140) uniform Place { vec4 move; vec4 tint; };
    out vec4 color; out vec2 place;
    void main() { color = shade * tint; place = position.xy * 3.0;
        gl_Position = vec4(position.xy * 0.6 + move.xy, 0.0, 1.0); }";
const IMAGES: &str = "#version 330 compatibility
    uniform sampler2D image; uniform sampler2D other; in vec4 color; in vec2 place; out vec4 pixel;
    void main() { pixel = mix(color, texture(image, place) + 0.5 * texture(other, place.yx), 0.75); }";
const WORDS: &str = "#version 330 compatibility
    uniform samplerBuffer words; in vec4 color; in vec2 place; out vec4 pixel;
    void main() { pixel = 0.25 * color + texelFetch(words, int(place.x * 3.0 + 8.0)); }";

/// Names, which are given in order.
const IMAGES_PROGRAM: GLuint = 1;
const WORDS_PROGRAM: GLuint = 4;
/// The unit of `other` and of `words`.
const SECOND: GLint = 1;
const THIRD: GLint = 2;
/// A texture that is drawn to.
const TARGET: GLuint = 3;
const FRAMEBUFFER: GLuint = 1;
const VERTICES: GLuint = 1;
const MORE_VERTICES: GLuint = 2;
const BLOCKS: GLuint = 3;
const TEXELS: GLuint = 4;

fn bytes(random: &mut Random, count: usize) -> Vec<u8> {
    (0..count).map(|_| random.below(256) as u8).collect()
}

fn floats(random: &mut Random, count: usize) -> Vec<f32> {
    (0..count).map(|_| random.float()).collect()
}

fn program(c: &mut Context, fragment: &str, units: &[(&str, GLint)]) -> GLuint {
    let program = shading::use_program(c, VERTEX, fragment);
    for (name, unit) in units {
        let place = c.get_uniform_location(program, name);
        c.uniform_1i(place, *unit);
    }
    let block = c.get_uniform_block_index(program, "Place");
    c.uniform_block_binding(program, block, 1);
    program
}

fn context(random: &mut Random) -> Context {
    let desc = ContextDesc { width: SIZE, height: SIZE, ..ContextDesc::default() };
    let mut context = Context::new(desc).expect("a device");
    let c = &mut context;
    c.clear(GL_COLOR_BUFFER_BIT);
    let words = [program(c, IMAGES, &[("other", SECOND)]), program(c, WORDS, &[("words", THIRD)])];
    assert_eq!(words, [IMAGES_PROGRAM, WORDS_PROGRAM]);
    for texture in 1..=TARGET {
        c.bind_texture(GL_TEXTURE_2D, texture);
        let (texels, side) = (bytes(random, 32 * 32 * 4), if texture == TARGET { 32 } else { 8 });
        let format = GL_RGBA as GLint;
        let data = Data::Bytes(&texels);
        c.tex_image_2d(GL_TEXTURE_2D, 0, format, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    }
    c.bind_framebuffer(GL_FRAMEBUFFER, FRAMEBUFFER);
    let (point, level) = (GL_COLOR_ATTACHMENT0, 0);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, TARGET, level);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    c.gen_samplers(1, &mut [0]);
    c.sampler_parameteri(1, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    c.sampler_parameteri(1, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT as GLint);
    for (buffer, count) in [(VERTICES, 480), (MORE_VERTICES, 480), (BLOCKS, 256), (TEXELS, 64)] {
        c.bind_buffer(GL_ARRAY_BUFFER, buffer);
        let data = floats(random, count);
        let data = bytemuck::cast_slice(&data);
        c.buffer_data(GL_ARRAY_BUFFER, data.len() as _, Data::Bytes(data), GL_STREAM_DRAW);
    }
    c.active_texture(GL_TEXTURE0 + THIRD as GLenum);
    c.bind_texture(GL_TEXTURE_BUFFER, 9);
    c.tex_buffer(GL_TEXTURE_BUFFER, GL_RGBA8, TEXELS);
    c.active_texture(GL_TEXTURE0);
    c.gen_vertex_arrays(2, &mut [0; 2]);
    for (array, buffer) in [(1, VERTICES), (2, MORE_VERTICES), (0, VERTICES)] {
        c.bind_vertex_array(array);
        c.bind_buffer(GL_ARRAY_BUFFER, buffer);
        c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 32, Data::Offset(0));
        c.enable_vertex_attrib_array(0);
        if array != 0 {
            c.vertex_attrib_pointer(1, 4, GL_FLOAT, false, 32, Data::Offset(16));
            c.enable_vertex_attrib_array(1);
        }
    }
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 1, BLOCKS);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    context
}

fn textures(c: &mut Context, random: &mut Random, framebuffer: &mut GLuint) {
    match random.below(8) {
        0 => c.active_texture(GL_TEXTURE0 + random.below(3) as GLenum),
        1 => c.bind_sampler(random.below(2) as GLuint, random.pick(&[0, 1])),
        2 => c.bind_texture(GL_TEXTURE_BUFFER, random.pick(&[0, 9])),
        3 => {
            let wrap = random.pick(&[GL_REPEAT, GL_CLAMP_TO_EDGE]) as GLint;
            c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
        }
        4 => {
            let texel = bytes(random, 4);
            let (x, y) = (random.below(8) as GLint, random.below(8) as GLint);
            let data = Data::Bytes(&texel);
            c.tex_sub_image_2d(GL_TEXTURE_2D, 0, x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, data);
        }
        _ => {
            // What a texture holds that is drawn to and sampled is undefined.
            let last = if *framebuffer == 0 { TARGET } else { TARGET - 1 };
            c.bind_texture(GL_TEXTURE_2D, random.below(u64::from(last) + 1) as GLuint);
        }
    }
}

fn blocks(c: &mut Context, random: &mut Random, _: &mut GLuint) {
    match random.below(5) {
        0 => c.bind_buffer_base(GL_UNIFORM_BUFFER, 1, random.pick(&[BLOCKS, VERTICES, 0])),
        1 => c.bind_buffer(GL_UNIFORM_BUFFER, random.pick(&[BLOCKS, TEXELS])),
        _ => {
            let offset = 256 * random.below(4) as GLintptr;
            c.bind_buffer_range(GL_UNIFORM_BUFFER, 1, BLOCKS, offset, 32);
        }
    }
}

fn contents(c: &mut Context, random: &mut Random, _: &mut GLuint) {
    let buffer = random.pick(&[VERTICES, MORE_VERTICES, BLOCKS, TEXELS]);
    c.bind_buffer(GL_COPY_WRITE_BUFFER, buffer);
    let data = floats(random, 64);
    let data: &[u8] = bytemuck::cast_slice(&data);
    match random.below(4) {
        0 => {
            let size = random.pick(&[256, 128, 64]);
            c.buffer_data(GL_COPY_WRITE_BUFFER, size as _, Data::Bytes(data), GL_STREAM_DRAW);
        }
        1 => {
            c.map_buffer_range(GL_COPY_WRITE_BUFFER, 0, 32, GL_MAP_WRITE_BIT);
            if let Some(mapped) = c.mapped_bytes(GL_COPY_WRITE_BUFFER) {
                mapped.copy_from_slice(&data[..32]);
            }
            // Draws that read a mapped buffer are errors.
            if random.below(4) > 0 {
                c.unmap_buffer(GL_COPY_WRITE_BUFFER);
            }
        }
        _ => {
            let at = 4 * random.below(16) as GLintptr;
            c.buffer_sub_data(GL_COPY_WRITE_BUFFER, at, 16, Data::Bytes(data));
        }
    }
}

fn arrays(c: &mut Context, random: &mut Random, _: &mut GLuint) {
    match random.below(6) {
        0 => c.enable_vertex_attrib_array(1),
        1 => c.disable_vertex_attrib_array(1),
        2 => c.vertex_attrib_4f(1, random.float(), 0.5, 0.5, 1.0),
        _ => c.bind_vertex_array(random.below(3) as GLuint),
    }
}

fn programs(c: &mut Context, random: &mut Random, _: &mut GLuint) {
    c.use_program(random.pick(&[0, IMAGES_PROGRAM, IMAGES_PROGRAM, WORDS_PROGRAM]));
}

fn framebuffer(c: &mut Context, random: &mut Random, framebuffer: &mut GLuint) {
    match random.below(5) {
        0 => c.viewport(0, 0, 20 + random.below(40) as GLsizei, 40),
        1 => c.enable(random.pick(&[GL_BLEND, GL_SCISSOR_TEST, GL_TEXTURE_2D])),
        2 => c.disable(random.pick(&[GL_BLEND, GL_SCISSOR_TEST, GL_TEXTURE_2D])),
        _ => {
            *framebuffer = random.pick(&[0, FRAMEBUFFER]);
            if *framebuffer != 0 {
                for unit in (0..3).rev() {
                    c.active_texture(GL_TEXTURE0 + unit);
                    c.bind_texture(GL_TEXTURE_2D, 1);
                }
            }
            c.bind_framebuffer(GL_FRAMEBUFFER, *framebuffer);
        }
    }
}

type Outcome = (Vec<u8>, Vec<u8>, GLenum, Vec<String>);

fn outcome(seed: u64, way: Way) -> Outcome {
    let mut random = Random(seed);
    let c = &mut context(&mut random);
    type Change = fn(&mut Context, &mut Random, &mut GLuint);
    let changes = random.pick(&[
        &[textures as Change, blocks, contents, arrays, programs, framebuffer][..],
        &[textures, blocks],
        &[textures, programs, arrays],
        &[contents, blocks, arrays],
        &[textures, framebuffer],
        &[contents, programs],
    ]);
    c.scissor(5, 5, 40, 30);
    let bound = &mut 0;
    programs(c, &mut random, bound);
    for _ in 0..random.below(60) + 5 {
        match random.below(9) {
            0..4 => c.draw_arrays(GL_TRIANGLES, random.pick(&[0, 3, 30]), random.pick(&[3, 3, 6])),
            _ => random.pick(changes)(c, &mut random, bound),
        }
        way.go_on(c);
    }
    c.unmap_buffer(GL_COPY_WRITE_BUFFER);
    c.bind_framebuffer(GL_FRAMEBUFFER, FRAMEBUFFER);
    let drawn_to = picture(c, 32);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    let shown = picture(c, SIZE);
    let messages = c.messages().into_iter().map(|message| message.text).collect();
    (shown, drawn_to, c.get_error(), messages)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn what_is_bound_anew_is_drawn_as_what_is_drawn_alone(seed: u64) {
        let (apart, together) = (outcome(seed, Way::Apart), outcome(seed, Way::Together));
        prop_assert_eq!(&together.2, &apart.2);
        prop_assert_eq!(&together.3, &apart.3);
        prop_assert!(together.0 == apart.0, "the picture differs");
        prop_assert!(together.1 == apart.1, "the picture in the texture differs");
    }
}
