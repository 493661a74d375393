//! Bad input at GL's door: random calls with random arguments, and the extremes one by one. Nothing
//! panics, nothing hangs, and the context goes on working.

#[path = "../../fuzz/bodies/calls.rs"]
mod calls;
#[path = "../../fuzz/bodies/context.rs"]
mod context;
#[path = "../../fuzz/bodies/random.rs"]
mod random;
#[path = "common/shading.rs"]
mod shading;

use calls::make_calls;
use context::{context_of, still_works};
use gl_api::*;
use random::Random;
use std::time::{Duration, Instant};

fn context() -> Context {
    context_of(Api::Compatibility)
}

#[test]
fn random_calls_never_panic_and_leave_a_context_that_works() {
    let start = Instant::now();
    for seed in 0..40 {
        let mut c = context();
        make_calls(&mut c, &mut Random::new(seed, &[]), 600);
        still_works(&mut c);
        // A slow machine tries fewer.
        if start.elapsed() > Duration::from_secs(20) {
            break;
        }
    }
}

#[test]
fn random_calls_on_contexts_of_core_and_es_leave_them_working() {
    let start = Instant::now();
    for seed in 100..140 {
        let mut c = context_of(if seed % 2 == 0 { Api::Core } else { Api::Es2 });
        make_calls(&mut c, &mut Random::new(seed, &[]), 600);
        still_works(&mut c);
        if start.elapsed() > Duration::from_secs(20) {
            break;
        }
    }
}

#[test]
fn the_same_random_calls_give_the_same_picture_twice() {
    let picture = || {
        let mut c = context();
        make_calls(&mut c, &mut Random::new(99, &[]), 1500);
        c.end();
        c.bind_framebuffer(GL_FRAMEBUFFER, 0);
        c.pixel_storei(GL_PACK_ALIGNMENT, 1);
        let mut out = vec![0_u8; 40 * 30 * 4];
        c.read_pixels(0, 0, 40, 30, GL_RGBA, GL_UNSIGNED_BYTE, (&mut out).arg());
        out
    };
    assert!(picture() == picture());
}

#[test]
fn extremes_are_refused_or_cut_one_by_one() {
    let mut c = context();
    // A billion pixels and no area at all, and coordinates that are no numbers.
    c.enable(GL_TEXTURE_2D);
    for scale in [1e3, 1e9, 1e30, f32::INFINITY, f32::NAN, 0.0] {
        c.begin(GL_TRIANGLES);
        for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (0.0, 1.0)] {
            c.tex_coord_2f(x * scale, y * scale);
            c.vertex_3f(x * scale, y * scale, 0.0);
        }
        c.end();
    }
    assert_eq!(c.get_error(), GL_NO_ERROR);
    // Sizes.
    for (width, height) in [(i32::MAX, i32::MAX), (8193, 1), (-1, 4), (4, i32::MIN)] {
        c.tex_image_2d(
            GL_TEXTURE_2D,
            0,
            GL_RGBA8 as i32,
            width,
            height,
            0,
            GL_RGBA,
            GL_UNSIGNED_BYTE,
            Null.arg(),
        );
        assert_eq!(c.get_error(), GL_INVALID_VALUE, "{width}×{height}");
    }
    // A slice that is one byte short: 3·5 bytes a row, padded to 16, but the last.
    c.messages();
    c.tex_image_2d(
        GL_TEXTURE_2D,
        0,
        GL_RGB8 as i32,
        5,
        2,
        0,
        GL_RGB,
        GL_UNSIGNED_BYTE,
        (&[0u8; 30]).arg(),
    );
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    let text: String = c.messages().iter().map(ToString::to_string).collect();
    assert!(text.contains("31") && text.contains("GL_UNPACK_ALIGNMENT"), "{text}");
    // A shader of a million parentheses.
    let shader = c.create_shader(GL_FRAGMENT_SHADER);
    let source = format!("void main() {{ gl_FragColor = vec4({}1.0", "(".repeat(1_000_000));
    c.shader_source(shader, 1, source.as_str().arg(), Null.arg());
    c.compile_shader(shader);
    let mut status = [1];
    c.get_shaderiv(shader, GL_COMPILE_STATUS, &mut status);
    assert_eq!(status, [0]);
    still_works(&mut c);
}

/// A draw of a triangle, and something new of 4 MiB that nothing but it needs once the next is made.
type Greedy = (&'static str, Waits, fn(&mut Context, bytes: &[u8], number: GLuint));

/// How long the draws of a row wait.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Waits {
    /// Until what they hold is much.
    WhileLittle,
    /// They are carried out before what they need is written to.
    Never,
    /// They hold no more than the few bytes that they read.
    Always,
}

const GREEDY: &[Greedy] = &[
    ("textures that are deleted", Waits::WhileLittle, |c, bytes, number| {
        c.bind_texture(GL_TEXTURE_2D, number);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
        let (format, ty, data) = (GL_RGBA, GL_UNSIGNED_BYTE, Data::Bytes(bytes));
        c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA as GLint, 1024, 1024, 0, format, ty, data);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        c.delete_textures(1, &[number]);
    }),
    ("one texture that changes", Waits::Never, |c, bytes, number| {
        c.bind_texture(GL_TEXTURE_2D, 1);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
        let (format, ty, data) = (GL_RGBA, GL_UNSIGNED_BYTE, Data::Bytes(bytes));
        if number == 1 {
            c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA as GLint, 1024, 1024, 0, format, ty, data);
        } else {
            c.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 1, 1, format, ty, data);
        }
        c.rectf(-1.0, -1.0, 1.0, 1.0);
    }),
    ("arrays", Waits::WhileLittle, |c, bytes, _| {
        c.enable_client_state(GL_VERTEX_ARRAY);
        c.vertex_pointer(3, GL_FLOAT, 0, Data::Bytes(bytes));
        c.draw_arrays(GL_TRIANGLES, 0, 3);
    }),
    ("a buffer that is made anew", Waits::WhileLittle, |c, bytes, _| {
        buffer(c, bytes);
        draw_from_buffer(c);
    }),
    ("a buffer that changes", Waits::Always, |c, bytes, number| {
        if number == 1 {
            buffer(c, bytes);
        } else {
            c.buffer_sub_data(GL_ARRAY_BUFFER, 0, 4, Data::Bytes(bytes));
        }
        draw_from_buffer(c);
    }),
    ("a buffer that another is copied to", Waits::Always, |c, bytes, number| {
        if number == 1 {
            buffer(c, bytes);
            c.bind_buffer(GL_COPY_READ_BUFFER, 2);
            c.buffer_data(GL_COPY_READ_BUFFER, 16, Data::Bytes(bytes), GL_STREAM_COPY);
        } else {
            c.copy_buffer_sub_data(GL_COPY_READ_BUFFER, GL_ARRAY_BUFFER, 0, 0, 16);
        }
        draw_from_buffer(c);
    }),
    ("a buffer that is copied within", Waits::Always, |c, bytes, number| {
        if number == 1 {
            buffer(c, bytes);
        } else {
            c.copy_buffer_sub_data(GL_ARRAY_BUFFER, GL_ARRAY_BUFFER, 0, 64, 16);
        }
        draw_from_buffer(c);
    }),
    ("a buffer that a texture is packed into", Waits::Always, |c, bytes, number| {
        if number == 1 {
            buffer(c, bytes);
            c.bind_buffer(GL_PIXEL_PACK_BUFFER, 1);
            let (format, ty, data) = (GL_RGBA, GL_UNSIGNED_BYTE, Data::Bytes(bytes));
            c.bind_texture(GL_TEXTURE_2D, 1);
            c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA as GLint, 2, 2, 0, format, ty, data);
        } else {
            let out = DataOut::Offset(0);
            c.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, out);
        }
        draw_from_buffer(c);
    }),
    ("a buffer that pixels are packed into", Waits::Always, |c, bytes, number| {
        if number == 1 {
            buffer(c, bytes);
            c.bind_buffer(GL_PIXEL_PACK_BUFFER, 1);
            // What is read is not what is drawn to, which would carry the draws out.
            c.bind_renderbuffer(GL_RENDERBUFFER, 1);
            c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, 2, 2);
            c.bind_framebuffer(GL_READ_FRAMEBUFFER, 1);
            let (target, at) = (GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0);
            c.framebuffer_renderbuffer(target, at, GL_RENDERBUFFER, 1);
            c.read_buffer(GL_COLOR_ATTACHMENT0);
        } else {
            c.read_pixels(0, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Offset(0));
        }
        draw_from_buffer(c);
    }),
    ("a buffer that a draw is captured into", Waits::Always, |c, bytes, number| {
        if number == 1 {
            buffer(c, bytes);
            let vertex = "void main() { gl_Position = gl_Vertex; }";
            let program = shading::use_program(c, vertex, "");
            let mode = GL_INTERLEAVED_ATTRIBS;
            c.transform_feedback_varyings(program, 1, Names(vec!["gl_Position"]), mode);
            c.link_program(program);
            c.use_program(program);
            let (offset, size) = (64, 64);
            c.bind_buffer_range(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 1, offset, size);
        }
        c.begin_transform_feedback(GL_TRIANGLES);
        draw_from_buffer(c);
        c.end_transform_feedback();
    }),
];

/// Buffer 1, of these bytes.
fn buffer(c: &mut Context, bytes: &[u8]) {
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    let size = bytes.len() as GLsizeiptr;
    c.buffer_data(GL_ARRAY_BUFFER, size, Data::Bytes(bytes), GL_STREAM_DRAW);
}

fn draw_from_buffer(c: &mut Context) {
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.vertex_pointer(3, GL_FLOAT, 0, Data::Offset(0));
    c.draw_arrays(GL_TRIANGLES, 0, 3);
}

/// What waits to be drawn keeps what it needs, but not without end.
#[test]
fn draws_that_hold_much_memory_do_not_wait() {
    let bytes = vec![0; 1 << 22];
    for (what, how_long, draw) in GREEDY {
        let desc = ContextDesc { width: 8, height: 8, ..ContextDesc::default() };
        let mut c = Context::new(desc).expect("a device");
        c.enable(GL_TEXTURE_2D);
        let waits = |c: &mut Context, fence: GLsync| {
            let (mut length, mut status) = ([0], [0]);
            c.get_synciv(fence, GL_SYNC_STATUS, 1, &mut length, &mut status);
            status[0] as GLenum == GL_UNSIGNALED
        };
        draw(&mut c, &bytes, 1);
        let fence = c.fence_sync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        for number in 2..8 {
            draw(&mut c, &bytes, number);
        }
        let after_little = waits(&mut c, fence);
        for number in 8..20 {
            draw(&mut c, &bytes, number);
        }
        let found = match (after_little, waits(&mut c, fence)) {
            (true, false) => Waits::WhileLittle,
            (false, _) => Waits::Never,
            (true, true) => Waits::Always,
        };
        assert_eq!(found, *how_long, "{what}: after 28 MiB, and after 76");
        assert_eq!(c.get_error(), GL_NO_ERROR, "{what}: {:?}", c.messages());
    }
}
