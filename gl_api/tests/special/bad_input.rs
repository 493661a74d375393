//! Bad input that is no wrong argument: other threads, offsets past a buffer's end, buffers that
//! are mapped, a texture that is drawn to and sampled at once.

use super::{ALL, context, draw, fine, pixel};
use gl_api::*;

#[test]
fn calls_on_a_thread_without_a_context_do_nothing() {
    let current = context(4, 4).make_current();
    glClearColor(1, 0, 0, 1);
    std::thread::spawn(|| {
        // This thread has no context: nothing reaches the other one's.
        glClearColor(0, 1, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_TRIANGLES);
        assert_eq!(glGetError(), GL_NO_ERROR);
        assert_eq!(glGetUniformLocation(1, "a"), -1);
        assert_eq!(glGetString(GL_VENDOR), "");
        let mut value: GLint = 77;
        glGetIntegerv(GL_VIEWPORT, &mut value);
        assert_eq!(value, 77);
    })
    .join()
    .expect("no panic");
    glClear(GL_COLOR_BUFFER_BIT);
    let mut context = current.release().expect("it was current");
    assert_eq!(pixel(&mut context, 0, 0), [255, 0, 0, 255]);
    // A context moves to another thread whole.
    std::thread::spawn(move || {
        let _current = context.make_current();
        let mut pixel = [0_u8; 4];
        glReadPixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut pixel);
        assert_eq!((pixel, glGetError()), ([255, 0, 0, 255], GL_NO_ERROR));
    })
    .join()
    .expect("no panic");
}

/// Buffer 1 with the corners of the window, bound to both targets.
fn buffered() -> Context {
    let mut c = context(4, 4);
    for target in [GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER] {
        c.bind_buffer(target, 1);
    }
    c.buffer_data(GL_ARRAY_BUFFER, 48, ALL.as_flattened().arg(), GL_STATIC_DRAW);
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.vertex_pointer(3, GL_FLOAT, 0, Data::Offset(0));
    fine(&mut c);
    c
}

/// Where no index is read, it does not matter from where.
#[test]
fn a_draw_of_no_indices_reads_none() {
    let mut c = buffered();
    let (mode, ty, far) = (GL_TRIANGLES, GL_UNSIGNED_SHORT, Data::Offset(1 << 20));
    c.draw_elements(mode, 0, ty, far);
    c.draw_range_elements(mode, 0, 3, 0, ty, far);
    c.draw_elements_instanced(mode, 3, ty, far, 0);
    fine(&mut c);
    c.draw_elements_instanced(mode, 3, ty, far, 1);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
}

#[test]
fn offsets_past_the_end_of_a_buffer_draw_nothing_or_zeros() {
    let refused = |c: &mut Context, what: &str| {
        let messages = c.messages();
        assert_eq!(c.get_error(), GL_INVALID_OPERATION, "{what}: {messages:?}");
        assert_eq!(pixel(c, 1, 1), [0; 4], "{what}");
    };
    let mut c = buffered();
    c.draw_arrays(GL_QUADS, 1, 4);
    refused(&mut c, "one vertex too far");
    c.vertex_pointer(3, GL_FLOAT, 0, Data::Offset(usize::MAX - 3));
    c.draw_arrays(GL_QUADS, 0, 4);
    refused(&mut c, "an offset near the end of the address space");
    c.vertex_pointer(3, GL_FLOAT, 0, Data::Offset(0));
    c.draw_elements(GL_QUADS, 4, GL_UNSIGNED_INT, Data::Offset(36));
    refused(&mut c, "indices past the end");
    c.draw_elements(GL_QUADS, 4, GL_UNSIGNED_INT, Data::Offset(usize::MAX - 1));
    refused(&mut c, "indices near the end of the address space");
    // Indices of vertices that the buffer does not have read zeros: nothing to see.
    c.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, Data::Offset(0));
    fine(&mut c);
    assert_eq!(pixel(&mut c, 1, 1), [0; 4]);
    // Another attribute's array that is too short reads zeros.
    c.enable_client_state(GL_COLOR_ARRAY);
    for offset in [1 << 30, usize::MAX - 3] {
        c.color_pointer(4, GL_FLOAT, 0, Data::Offset(offset));
        c.draw_arrays(GL_QUADS, 0, 4);
        fine(&mut c);
        assert_eq!(pixel(&mut c, 1, 1), [0; 4]);
    }
    c.disable_client_state(GL_COLOR_ARRAY);
    c.draw_arrays(GL_QUADS, 0, 4);
    assert_eq!(pixel(&mut c, 1, 1), [255; 4]);
}

#[test]
fn a_buffer_that_is_mapped_is_not_read() {
    let mut c = buffered();
    let pointer = c.map_buffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
    assert!(!pointer.is_null());
    c.draw_arrays(GL_QUADS, 0, 4);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    c.draw_elements(GL_QUADS, 4, GL_UNSIGNED_BYTE, Data::Offset(0));
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    c.buffer_sub_data(GL_ARRAY_BUFFER, 0, 4, Data::Bytes(&[0; 4]));
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    c.get_buffer_sub_data(GL_ARRAY_BUFFER, 0, 4, DataOut::Bytes(&mut [0; 4]));
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    assert_eq!(pixel(&mut c, 1, 1), [0; 4]);
    assert!(c.unmap_buffer(GL_ARRAY_BUFFER));
    c.draw_arrays(GL_QUADS, 0, 4);
    assert_eq!(pixel(&mut c, 1, 1), [255; 4]);
    // Deleting it while it is mapped unmaps it.
    c.map_buffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
    c.delete_buffers(1, &[1]);
    c.draw_arrays(GL_QUADS, 0, 4);
    c.get_error();
    assert_eq!(pixel(&mut c, 1, 1), [255; 4]);
}

/// A texture that is sampled while it is drawn to gives what it held before the pass, on every
/// run.
#[test]
fn a_texture_that_feeds_back_to_itself_has_a_defined_picture() {
    let picture = || {
        let mut c = context(4, 4);
        c.bind_texture(GL_TEXTURE_2D, 1);
        let texels: Vec<u8> = (0..64).map(|byte| byte * 4).collect();
        let (rgba, byte) = (GL_RGBA, GL_UNSIGNED_BYTE);
        c.tex_image_2d(
            GL_TEXTURE_2D,
            0,
            GL_RGBA8 as i32,
            4,
            4,
            0,
            rgba,
            byte,
            Data::Bytes(&texels),
        );
        for name in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
            c.tex_parameteri(GL_TEXTURE_2D, name, GL_NEAREST as i32);
        }
        c.enable(GL_TEXTURE_2D);
        c.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE as i32);
        c.bind_framebuffer(GL_FRAMEBUFFER, 1);
        let point = GL_COLOR_ATTACHMENT0;
        c.framebuffer_texture_2d(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, 1, 0);
        // Turned by half: each pixel reads another one's texel.
        c.begin(GL_QUADS);
        for [x, y, _] in ALL {
            c.tex_coord_2f((1.0 - x) / 2.0, (1.0 - y) / 2.0);
            c.vertex_2f(x, y);
        }
        c.end();
        let mut out = [0; 64];
        c.read_pixels(0, 0, 4, 4, rgba, byte, DataOut::Bytes(&mut out));
        fine(&mut c);
        (texels, out)
    };
    let (texels, out) = picture();
    let turned: Vec<u8> = texels.chunks(4).rev().flatten().copied().collect();
    assert_eq!(out.to_vec(), turned);
    assert_eq!(picture().1, out);
}

#[test]
fn calls_between_begin_and_end_leave_the_primitive_alone() {
    let mut c = context(4, 4);
    c.begin(GL_QUADS);
    for [x, y, z] in ALL {
        c.vertex_3f(x, y, z);
        c.clear(GL_COLOR_BUFFER_BIT);
        c.bind_texture(GL_TEXTURE_2D, 1);
        c.draw_arrays(GL_TRIANGLES, 0, 3);
    }
    c.end();
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    assert_eq!(pixel(&mut c, 1, 1), [255; 4]);
    draw(&mut c, GL_POINTS, &[]);
    fine(&mut c);
}
