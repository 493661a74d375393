//! `glBlitFramebuffer`: from framebuffer 1 to framebuffer 2, read through framebuffer 3 where 2 has several samples.

use super::cases::{Case, draw_unseen_textured, pattern, row, sum};
use gl_api::*;

const SIDE: GLsizei = 256;
/// So many that a row of texels, as numbers, is a large allocation.
const WIDE: GLsizei = 8192;

/// Renderbuffer and framebuffer of a number.
fn target(c: &mut Context, number: GLuint, format: GLenum, samples: GLsizei, size: [GLsizei; 2]) {
    let [width, height] = size;
    let point = match format {
        GL_DEPTH24_STENCIL8 => GL_DEPTH_STENCIL_ATTACHMENT,
        _ => GL_COLOR_ATTACHMENT0,
    };
    c.bind_renderbuffer(GL_RENDERBUFFER, number);
    c.renderbuffer_storage_multisample(GL_RENDERBUFFER, samples, format, width, height);
    c.bind_framebuffer(GL_FRAMEBUFFER, number);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, number);
    if point == GL_DEPTH_STENCIL_ATTACHMENT {
        c.draw_buffer(GL_NONE);
        c.read_buffer(GL_NONE);
    }
}

/// The framebuffer that is bound has two colours, or depths, after that.
fn draw(c: &mut Context, size: [GLsizei; 2]) {
    let [width, height] = size;
    c.viewport(0, 0, width, height);
    c.clear_color(0.5, 0.25, 1.0, 1.0);
    c.clear_depth(0.25);
    c.clear_stencil(9);
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    c.rectf(-1.0, -1.0, 0.1, 0.5);
}

/// Both sides; then 2 is drawn to and the window read.
fn sides(c: &mut Context, from: (GLenum, GLsizei), to: (GLenum, GLsizei), size: [GLsizei; 2]) {
    target(c, 2, to.0, to.1, size);
    c.clear_color(0.0, 1.0, 0.0, 0.0);
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    target(c, 1, from.0, from.1, size);
    draw(c, size);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, 0);
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 2);
}

fn blit(c: &mut Context, [width, height]: [GLsizei; 2], mask: GLbitfield) {
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, 1);
    c.blit_framebuffer(0, 0, width, height, 0, 0, width, height, mask, GL_NEAREST);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, 0);
}

/// What framebuffer 2 has.
fn written(c: &mut Context, [width, height]: [GLsizei; 2], pixel: (GLenum, GLenum)) -> Vec<i64> {
    let mut pixels = vec![0; (width * height * 4) as usize];
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, 2);
    c.read_pixels(0, 0, width, height, pixel.0, pixel.1, DataOut::Bytes(&mut pixels));
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, 0);
    vec![sum(&pixels)]
}

const SQUARE: [GLsizei; 2] = [SIDE; 2];
const COLORS: (GLenum, GLenum) = (GL_RGBA, GL_UNSIGNED_BYTE);

fn square(c: &mut Context) -> Vec<i64> {
    written(c, SQUARE, COLORS)
}

/// What framebuffer 2 has, resolved to framebuffer 3.
fn resolved(c: &mut Context) -> Vec<i64> {
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, 2);
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 3);
    let (bit, nearest) = (GL_COLOR_BUFFER_BIT, GL_NEAREST);
    c.blit_framebuffer(0, 0, SIDE, SIDE, 0, 0, SIDE, SIDE, bit, nearest);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, 3);
    let mut pixels = vec![0; (SIDE * SIDE * 4) as usize];
    c.read_pixels(0, 0, SIDE, SIDE, COLORS.0, COLORS.1, DataOut::Bytes(&mut pixels));
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, 0);
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 2);
    vec![sum(&pixels)]
}

pub const CASES: &[Case] = &[
    row((
        "glBlitFramebuffer of wide rows, converted",
        |c| sides(c, (GL_RGBA16F, 0), (GL_RGBA8, 0), [WIDE, 8]),
        |c| blit(c, [WIDE, 8], GL_COLOR_BUFFER_BIT),
        |c| written(c, [WIDE, 8], COLORS),
    )),
    row((
        "glBlitFramebuffer of wide rows, filtered",
        |c| sides(c, (GL_RGBA8, 0), (GL_RGBA8, 0), [WIDE, 8]),
        |c| {
            let (bit, filter) = (GL_COLOR_BUFFER_BIT, GL_LINEAR);
            c.bind_framebuffer(GL_READ_FRAMEBUFFER, 1);
            c.blit_framebuffer(1, 0, WIDE, 8, 0, 0, WIDE, 7, bit, filter);
            c.bind_framebuffer(GL_READ_FRAMEBUFFER, 0);
        },
        |c| written(c, [WIDE, 8], COLORS),
    )),
    row((
        "glBlitFramebuffer of depths and stencils",
        |c| sides(c, (GL_DEPTH24_STENCIL8, 0), (GL_DEPTH24_STENCIL8, 0), [WIDE, 8]),
        |c| blit(c, [WIDE, 8], GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT),
        |c| written(c, [WIDE, 8], (GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8)),
    )),
    row((
        "glBlitFramebuffer of samples",
        |c| {
            target(c, 3, GL_RGBA8, 0, SQUARE);
            sides(c, (GL_RGBA8, 4), (GL_RGBA8, 4), SQUARE);
        },
        |c| blit(c, SQUARE, GL_COLOR_BUFFER_BIT),
        resolved,
    )),
    row((
        "glBlitFramebuffer to several samples",
        |c| {
            target(c, 3, GL_RGBA8, 0, SQUARE);
            sides(c, (GL_RGBA8, 0), (GL_RGBA8, 4), SQUARE);
        },
        |c| blit(c, SQUARE, GL_COLOR_BUFFER_BIT),
        resolved,
    )),
    row((
        "glBlitFramebuffer to a texture that a draw reads",
        |c| {
            let (d2, rgba, ty) = (GL_TEXTURE_2D, GL_RGBA8 as GLint, GL_UNSIGNED_BYTE);
            c.bind_texture(d2, 7);
            c.tex_parameteri(d2, GL_TEXTURE_MIN_FILTER, GL_LINEAR as GLint);
            c.tex_image_2d(d2, 0, rgba, SIDE, SIDE, 0, GL_RGBA, ty, Data::Bytes(pattern(1)));
            sides(c, (GL_RGBA8, 0), (GL_RGBA8, 0), SQUARE);
            c.framebuffer_texture_2d(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, d2, 7, 0);
        },
        |c| {
            c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
            draw_unseen_textured(c, GL_TEXTURE_2D);
            c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 2);
            blit(c, SQUARE, GL_COLOR_BUFFER_BIT);
        },
        square,
    )),
    row((
        "glBlitFramebuffer to a layer of a view",
        |c| {
            let (d2, view) = (GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY);
            let mut names = [0; 6];
            c.gen_textures(6, &mut names);
            c.bind_texture(d2, 5);
            c.tex_storage_2d(d2, 1, GL_RGBA8, SIDE, SIDE);
            c.texture_view(6, view, 5, GL_RGBA8, 0, 1, 0, 1);
            sides(c, (GL_RGBA8, 0), (GL_RGBA8, 0), SQUARE);
            c.framebuffer_texture_layer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, 6, 0, 0);
        },
        |c| blit(c, SQUARE, GL_COLOR_BUFFER_BIT),
        square,
    )),
];
