//! What is read straight from where it was drawn, whole or in parts, is what the picture's own rows hold.

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

/// What is drawn to: the default framebuffer where the format is 0.
fn target(internal: GLenum, samples: u8) -> Context {
    let surface = SurfaceDesc { samples, ..SurfaceDesc::default() };
    let (width, height) = (WIDTH as u32, HEIGHT as u32);
    let mut c = Context::new(ContextDesc { width, height, surface, ..ContextDesc::default() })
        .expect("a device");
    c.pixel_storei(GL_PACK_ALIGNMENT, 1);
    if internal != 0 {
        framebuffer(&mut c);
        renderbuffer(&mut c, GL_COLOR_ATTACHMENT0, internal, WIDTH, HEIGHT);
        let point = GL_DEPTH_STENCIL_ATTACHMENT;
        renderbuffer(&mut c, point, GL_DEPTH24_STENCIL8, WIDTH, HEIGHT);
    }
    c
}

/// Brings the picture to its own rows, as copies of it do.
fn store(c: &mut Context) {
    c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 1, 1, 0);
    c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 0, 1, 1, 0);
}

#[test]
fn regions_are_cut_from_the_whole() {
    // x, y, width, height: of one pixel, across tiles, at edges and beyond them.
    let regions = [
        [0, 0, 1, 1],
        [77, 13, 1, 1],
        [WIDTH - 1, HEIGHT - 1, 1, 1],
        [63, 63, 2, 2],
        [5, 3, 70, 40],
        [64, 0, 64, 64],
        [61, 60, 89, 10],
        [-3, -2, 20, 9],
        [120, 50, 200, 100],
        [WIDTH, 0, 4, 4],
    ];
    for (&(format, ty, size, internal), samples) in
        ROWS.iter().map(|row| (row, 0)).chain(ROWS[..5].iter().map(|row| (row, 4)))
    {
        let mut c = target(internal, samples);
        for number in 0..3 {
            draw(&mut c, number);
            if number == 2 {
                store(&mut c);
            }
            let pixels = |width: i32, height: i32| vec![0xA5; (width * height * size) as usize];
            let mut parts = regions.map(|[_, _, width, height]| pixels(width, height));
            for ([x, y, width, height], part) in regions.into_iter().zip(&mut parts) {
                c.read_pixels(x, y, width, height, format, ty, DataOut::Bytes(part));
            }
            store(&mut c);
            let mut whole = pixels(WIDTH, HEIGHT);
            c.read_pixels(0, 0, WIDTH, HEIGHT, format, ty, DataOut::Bytes(&mut whole));
            fine(&mut c);
            for ([x, y, width, height], part) in regions.into_iter().zip(&parts) {
                for (at, pixel) in part.chunks(size as usize).enumerate() {
                    let (x, y) = (x + at as i32 % width, y + at as i32 / width);
                    let inside = (0..WIDTH).contains(&x) && (0..HEIGHT).contains(&y);
                    let at = ((y * WIDTH + x) * size) as usize;
                    let want = if inside { &whole[at..][..pixel.len()] } else { &[0xA5; 16] };
                    let what = format!("{format:#x} {ty:#x} of {internal:#x}");
                    assert_eq!(
                        pixel,
                        &want[..pixel.len()],
                        "{what} at {x}, {y} of {width}×{height}"
                    );
                }
            }
        }
    }
}

/// A buffer object may be longer than what is read into it.
#[test]
fn what_lies_behind_a_picture_stays() {
    let mut c = target(0, 0);
    draw(&mut c, 1);
    let (picture, all) = ((WIDTH * HEIGHT * 4) as usize, (WIDTH * 200 * 4) as usize);
    let mut bytes = vec![7; all];
    c.read_pixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut bytes));
    assert!(bytes[picture..].iter().all(|byte| *byte == 7));
    let mut name = [0];
    c.gen_buffers(1, &mut name);
    c.bind_buffer(GL_PIXEL_PACK_BUFFER, name[0]);
    c.buffer_data(GL_PIXEL_PACK_BUFFER, all as isize, Data::Bytes(&vec![7; all]), GL_STREAM_READ);
    c.read_pixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Offset(0));
    let mut back = vec![0; all];
    c.get_buffer_sub_data(GL_PIXEL_PACK_BUFFER, 0, all as isize, DataOut::Bytes(&mut back));
    fine(&mut c);
    assert!(back == bytes);
}

/// Rows may begin before the ones before them end, and the last one stays.
#[test]
fn rows_that_overlap_are_put_in_order() {
    for format in [GL_RGBA, GL_BGRA] {
        let mut c = target(0, 0);
        draw(&mut c, 1);
        let mut whole = vec![0; (WIDTH * HEIGHT * 4) as usize];
        c.read_pixels(0, 0, WIDTH, HEIGHT, format, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut whole));
        let mut want = vec![0; ((HEIGHT - 1) * 10 + WIDTH) as usize * 4];
        for (y, row) in whole.chunks((WIDTH * 4) as usize).enumerate() {
            want[y * 40..][..row.len()].copy_from_slice(row);
        }
        c.pixel_storei(GL_PACK_ROW_LENGTH, 10);
        let mut out = vec![0; want.len()];
        c.read_pixels(0, 0, WIDTH, HEIGHT, format, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut out));
        fine(&mut c);
        assert!(out == want, "{format:#x}");
    }
}

#[test]
fn whole_pictures_are_their_parts() {
    for &(format, ty, size, internal) in ROWS {
        for packing in [[0, WIDTH], [0, 200], [9, 163]] {
            let mut c = target(internal, 0);
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
                store(&mut c);
                parts.fill(0xA5);
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
