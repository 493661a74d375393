//! Whole pictures that are read straight from where they were drawn are those that are read part by part.

use super::{context, fine, framebuffer, renderbuffer};
use gl_api::*;

const WIDTH: i32 = 150;
const HEIGHT: i32 = 70;

/// How many pixels before the picture are left out in each row, and how long rows are, in pixels.
type Packing = [i32; 2];

/// Something in every tile, from edge to edge; another picture for each number.
fn draw(c: &mut Context, number: u8) {
    c.clear_color(0.25, f32::from(number) / 8.0, 0.5, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    c.enable(GL_DEPTH_TEST);
    c.enable(GL_STENCIL_TEST);
    c.stencil_op(GL_KEEP, GL_KEEP, GL_INCR);
    c.begin(GL_TRIANGLES);
    for (x, y) in [(-1.0, -1.0), (1.0, -0.5), (f32::from(number) / 4.0 - 1.0, 1.0)] {
        c.color_4f(x, y, 0.75, 0.5);
        c.vertex_3f(x, y, x * y);
    }
    c.end();
}

/// A part of the picture, of pixels of `size` bytes, into memory for all of it.
fn read(
    c: &mut Context,
    [y, height]: [i32; 2],
    (format, ty, size): (GLenum, GLenum, i32),
    [skip, row_length]: Packing,
    into: &mut [u8],
) {
    c.pixel_storei(GL_PACK_SKIP_ROWS, y);
    c.pixel_storei(GL_PACK_SKIP_PIXELS, skip);
    c.pixel_storei(GL_PACK_ROW_LENGTH, row_length);
    let end = (y + height - 1) * row_length + skip + WIDTH;
    c.read_pixels(
        0,
        y,
        WIDTH,
        height,
        format,
        ty,
        DataOut::Bytes(&mut into[..(end * size) as usize]),
    );
}

/// Format, type and bytes of a pixel, and what it is read from: the default framebuffer where that is 0.
const ROWS: &[(GLenum, GLenum, i32, GLenum)] = &[
    (GL_RGBA, GL_UNSIGNED_BYTE, 4, 0),
    (GL_BGRA, GL_UNSIGNED_BYTE, 4, 0),
    (GL_RGBA, GL_FLOAT, 16, 0),
    (GL_DEPTH_COMPONENT, GL_FLOAT, 4, 0),
    (GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1, 0),
    (GL_RED, GL_UNSIGNED_BYTE, 1, GL_R8),
    (GL_RG, GL_UNSIGNED_SHORT, 4, GL_RG16),
    (GL_RGBA, GL_UNSIGNED_BYTE, 4, GL_RGBA8),
    (GL_RGBA, GL_HALF_FLOAT, 8, GL_RGBA16F),
    (GL_RGB, GL_FLOAT, 12, GL_RGB32F),
    (GL_RGBA, GL_FLOAT, 16, GL_RGBA32F),
    (GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2, GL_RGB565),
];

#[test]
fn whole_pictures_are_their_parts() {
    for &(format, ty, size, internal) in ROWS {
        for packing in [[0, WIDTH], [0, 200], [9, 163]] {
            let mut c = context(WIDTH as u32, HEIGHT as u32);
            c.pixel_storei(GL_PACK_ALIGNMENT, 1);
            if internal != 0 {
                framebuffer(&mut c);
                renderbuffer(&mut c, GL_COLOR_ATTACHMENT0, internal, WIDTH, HEIGHT);
                renderbuffer(
                    &mut c,
                    GL_DEPTH_STENCIL_ATTACHMENT,
                    GL_DEPTH24_STENCIL8,
                    WIDTH,
                    HEIGHT,
                );
            }
            let pixel = (format, ty, size);
            let bytes = (HEIGHT * packing[1] * size) as usize;
            let mut before = Vec::new();
            for number in 0..3 {
                draw(&mut c, number);
                // What is not written to stays.
                let (mut whole, mut parts) = (vec![0xA5; bytes], vec![0xA5; bytes]);
                read(&mut c, [0, HEIGHT], pixel, packing, &mut whole);
                for y in 0..HEIGHT {
                    read(&mut c, [y, 1], pixel, packing, &mut parts);
                }
                fine(&mut c);
                assert!(whole == parts, "{format:#x} {ty:#x} of {internal:#x}, {packing:?}");
                // And once more, now that its rows are there.
                read(&mut c, [0, HEIGHT], pixel, packing, &mut parts);
                assert!(whole == parts, "{format:#x} {ty:#x} of {internal:#x}, again");
                assert!(whole != before, "{format:#x} {ty:#x} of {internal:#x}, the same picture");
                before = whole;
            }
        }
    }
}

#[test]
fn too_little_memory_is_refused_before_anything_is_written() {
    let mut c = context(WIDTH as u32, HEIGHT as u32);
    draw(&mut c, 1);
    let mut bytes = vec![7; (WIDTH * HEIGHT * 4 - 1) as usize];
    let out = DataOut::Bytes(&mut bytes);
    c.read_pixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, out);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    assert!(bytes.iter().all(|byte| *byte == 7));
}
