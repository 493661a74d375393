//! What recorded draws hold: a client that draws and never flushes does not fill the memory. Each case asks for gigabytes
//! in all, of objects that are gone or other ones already.

mod allocator;

use allocator::{Counting, peak_of};
use gl_api::*;

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Recorded commands hold 64 MB, and what the command after them brings (`MAX_HELD`); the rest is scratch.
const MOST: usize = 160 << 20;
/// The bytes of an object, and how many there are: two gigabytes.
const BYTES: usize = 16 << 20;
const COUNT: usize = 128;

fn context() -> Context {
    let desc = ContextDesc { width: 16, height: 16, ..ContextDesc::default() };
    Context::new(desc).expect("a context")
}

/// A triangle that covers nothing: to draw it takes no time.
fn triangle(c: &mut Context) {
    c.begin(GL_TRIANGLES);
    for _ in 0..3 {
        c.vertex_2f(0.0, 0.0);
    }
    c.end();
}

fn client_arrays(c: &mut Context) {
    let vertices = vec![0; BYTES];
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.vertex_pointer(2, GL_FLOAT, 0, Data::Bytes(&vertices));
    for _ in 0..COUNT {
        c.draw_elements(
            GL_TRIANGLES,
            3,
            GL_UNSIGNED_INT,
            Data::Bytes(&[0, 0, 0, 0, 255, 255, 31, 0, 0, 0, 0, 0]),
        );
    }
}

fn respecified_buffer(c: &mut Context) {
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    c.enable_client_state(GL_VERTEX_ARRAY);
    for _ in 0..COUNT {
        c.buffer_data(GL_ARRAY_BUFFER, BYTES as GLsizeiptr, Data::Null, GL_STREAM_DRAW);
        c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
        c.draw_arrays(GL_TRIANGLES, 0, 3);
    }
}

fn written_buffer(c: &mut Context) {
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    c.buffer_data(GL_ARRAY_BUFFER, BYTES as GLsizeiptr, Data::Null, GL_STREAM_DRAW);
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
    for at in 0..COUNT {
        c.buffer_sub_data(GL_ARRAY_BUFFER, 4 * at as GLintptr, 4, Data::Bytes(&[0; 4]));
        c.draw_arrays(GL_TRIANGLES, 0, (BYTES / 8) as GLsizei);
    }
}

fn image(c: &mut Context) {
    let (format, side) = (GL_RGBA8 as GLint, 2048);
    c.tex_image_2d(GL_TEXTURE_2D, 0, format, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, Data::Null);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
}

fn respecified_texture(c: &mut Context) {
    c.bind_texture(GL_TEXTURE_2D, 1);
    c.enable(GL_TEXTURE_2D);
    for _ in 0..COUNT {
        image(c);
        triangle(c);
    }
}

fn deleted_textures(c: &mut Context) {
    c.enable(GL_TEXTURE_2D);
    for _ in 0..COUNT {
        c.bind_texture(GL_TEXTURE_2D, 1);
        image(c);
        triangle(c);
        c.delete_textures(1, &[1]);
    }
}

/// Draws to a renderbuffer, which is gone afterwards.
fn deleted_attachments(c: &mut Context) {
    for _ in 0..COUNT {
        c.bind_renderbuffer(GL_RENDERBUFFER, 1);
        c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, 2048, 2048);
        c.bind_framebuffer(GL_FRAMEBUFFER, 1);
        let (target, point) = (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0);
        c.framebuffer_renderbuffer(target, point, GL_RENDERBUFFER, 1);
        triangle(c);
        c.delete_renderbuffers(1, &[1]);
        c.delete_framebuffers(1, &[1]);
    }
}

/// The same of one framebuffer, whose attachment is specified anew.
fn respecified_attachment(c: &mut Context) {
    c.bind_renderbuffer(GL_RENDERBUFFER, 1);
    c.bind_framebuffer(GL_FRAMEBUFFER, 1);
    for at in 0..COUNT {
        c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, 2048 - at as GLsizei % 2, 2048);
        let (target, point) = (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0);
        c.framebuffer_renderbuffer(target, point, GL_RENDERBUFFER, 1);
        triangle(c);
    }
}

fn respecified_uniform_buffer(c: &mut Context) {
    let stages = [
        (GL_VERTEX_SHADER, "#version 140\nvoid main() { gl_Position = vec4(0.0); }"),
        (
            GL_FRAGMENT_SHADER,
            "#version 140\nlayout(std140) uniform B { vec4 color; }; void main() { gl_FragColor = color; }",
        ),
    ];
    let program = c.create_program();
    for (stage, source) in stages {
        let shader = c.create_shader(stage);
        c.shader_source(shader, 1, Strings(vec![source]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
    }
    c.link_program(program);
    c.use_program(program);
    for _ in 0..COUNT {
        c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, 1);
        c.buffer_data(GL_UNIFORM_BUFFER, BYTES as GLsizeiptr, Data::Null, GL_STREAM_DRAW);
        c.draw_arrays(GL_TRIANGLES, 0, 3);
    }
}

fn pixels(c: &mut Context) {
    let pixels = vec![0; BYTES];
    c.raster_pos_2f(-1.0, -1.0);
    c.pixel_zoom(0.001, 0.001);
    for _ in 0..COUNT {
        c.draw_pixels(2048, 2048, GL_RGBA, GL_UNSIGNED_BYTE, Data::Bytes(&pixels));
    }
}

/// Fences that were deleted, and not waited for: 48 bytes each would be 200 MB.
fn fences(c: &mut Context) {
    triangle(c);
    for _ in 0..4 << 20 {
        let fence = c.fence_sync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        c.delete_sync(fence);
    }
}

/// A name, and what draws without a flush.
type Case = (&'static str, fn(&mut Context));

const CASES: &[Case] = &[
    ("client arrays", client_arrays),
    ("a buffer that is specified anew", respecified_buffer),
    ("a buffer that is written", written_buffer),
    ("a texture that is specified anew", respecified_texture),
    ("textures that are deleted", deleted_textures),
    ("attachments that are deleted", deleted_attachments),
    ("an attachment that is specified anew", respecified_attachment),
    ("a uniform buffer that is specified anew", respecified_uniform_buffer),
    ("pixels", pixels),
    ("fences", fences),
];

/// The numbers between the control points of a map are the client's, and are not copied.
fn map_of_a_large_stride() {
    const STRIDE: usize = 1 << 20;
    let points = vec![0.5_f32; 7 * STRIDE + 3];
    let mut c = context();
    let peak = peak_of(|| c.map1f(GL_MAP1_VERTEX_3, 0.0, 1.0, STRIDE as GLint, 8, &points));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    assert!(peak < 1 << 16, "{peak} bytes");
}

/// One test, as the allocator is the process's.
#[test]
fn recorded_draws_hold_so_much_and_no_more() {
    map_of_a_large_stride();
    for (name, case) in CASES {
        let mut c = context();
        let peak = peak_of(|| case(&mut c));
        println!("{name}: {} MB", peak >> 20);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{name}: {:?}", c.messages());
        assert!(peak < MOST, "{name}: {} MB", peak >> 20);
    }
}
