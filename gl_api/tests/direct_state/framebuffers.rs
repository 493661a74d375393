//! Framebuffers and renderbuffers by name and bound.

use crate::{Twin, context, flags, integer, run};
use gl_api::*;

const FB: GLenum = GL_FRAMEBUFFER;
const COLOR: GLenum = GL_COLOR_ATTACHMENT0;
const SECOND: GLenum = GL_COLOR_ATTACHMENT1;
const BOTH: GLenum = GL_DEPTH_STENCIL_ATTACHMENT;
const RB: GLenum = GL_RENDERBUFFER;

macro_rules! twins {
    ($($name:ident: $named:expr, $bound:expr;)*) => {
        &[$(Twin { name: stringify!($name), named: $named, bound: $bound }),*]
    };
}

/// Texture 1 has four layers of integers; renderbuffer 1 colours, renderbuffer 2 depths and stencils.
fn images(c: &mut Context) {
    let mut names = [0; 2];
    c.create_textures(GL_TEXTURE_2D_ARRAY, 1, &mut names);
    c.texture_storage_3d(1, 1, GL_RGBA8UI, 8, 8, 4);
    c.create_renderbuffers(2, &mut names);
    assert!(c.is_renderbuffer(names[0]) && c.is_renderbuffer(names[1]));
    c.named_renderbuffer_storage(1, GL_RGBA8, 8, 8);
    c.named_renderbuffer_storage(2, GL_DEPTH24_STENCIL8, 8, 8);
    assert_eq!(flags(c), GL_NO_ERROR, "{:?}", c.messages());
}

/// The pixels of the framebuffer that is read from.
fn pixels(c: &mut Context, format: GLenum, ty: GLenum) -> Vec<u8> {
    let mut bytes = vec![0; 8 * 8 * 4];
    c.read_pixels(0, 0, 8, 8, format, ty, DataOut::Bytes(&mut bytes));
    assert_eq!(flags(c), GL_NO_ERROR, "{:?}", c.messages());
    bytes
}

#[test]
fn attachments_clears_and_copies() {
    let (mut named, mut bound) = (context(), context());
    images(&mut named);
    images(&mut bound);
    let mut name = [0];
    named.create_framebuffers(1, &mut name);
    assert!(named.is_framebuffer(1));
    bound.bind_framebuffer(FB, 1);
    run(
        &mut named,
        1,
        &mut bound,
        twins! {
            empty: |c, f| assert_eq!(c.check_named_framebuffer_status(f, FB), GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT),
                |c| assert_eq!(c.check_framebuffer_status(FB), GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
            color: |c, f| c.named_framebuffer_renderbuffer(f, COLOR, RB, 1), |c| c.framebuffer_renderbuffer(FB, COLOR, RB, 1);
            wrong: |c, f| c.named_framebuffer_renderbuffer(f, GL_BACK, RB, 1), |c| c.framebuffer_renderbuffer(FB, GL_BACK, RB, 1);
            depth: |c, f| c.named_framebuffer_renderbuffer(f, BOTH, RB, 2), |c| c.framebuffer_renderbuffer(FB, BOTH, RB, 2);
            whole: |c, f| c.named_framebuffer_texture(f, SECOND, 1, 0), |c| c.framebuffer_texture(FB, SECOND, 1, 0);
            layers: |c, f| assert_eq!(c.check_named_framebuffer_status(f, FB), GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS),
                |c| assert_eq!(c.check_framebuffer_status(FB), GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS);
            layer: |c, f| c.named_framebuffer_texture_layer(f, SECOND, 1, 0, 2), |c| c.framebuffer_texture_layer(FB, SECOND, 1, 0, 2);
            past: |c, f| c.named_framebuffer_texture_layer(f, SECOND, 1, 0, -1), |c| c.framebuffer_texture_layer(FB, SECOND, 1, 0, -1);
            draws: |c, f| c.named_framebuffer_draw_buffers(f, 2, &[COLOR, SECOND]), |c| c.draw_buffers(2, &[COLOR, SECOND]);
            twice: |c, f| c.named_framebuffer_draw_buffers(f, 2, &[COLOR, COLOR]), |c| c.draw_buffers(2, &[COLOR, COLOR]);
            whole_status: |c, f| assert_eq!(c.check_named_framebuffer_status(f, FB), GL_FRAMEBUFFER_COMPLETE),
                |c| assert_eq!(c.check_framebuffer_status(FB), GL_FRAMEBUFFER_COMPLETE);
            clear_f: |c, f| c.clear_named_framebufferfv(f, GL_COLOR, 0, &[0.25, 0.5, 0.75, 1.0]), |c| c.clear_bufferfv(GL_COLOR, 0, &[0.25, 0.5, 0.75, 1.0]);
            clear_u: |c, f| c.clear_named_framebufferuiv(f, GL_COLOR, 1, &[1, 2, 3, 4]), |c| c.clear_bufferuiv(GL_COLOR, 1, &[1, 2, 3, 4]);
            clear_fi: |c, f| c.clear_named_framebufferfi(f, GL_DEPTH_STENCIL, 0, 0.5, 77), |c| c.clear_bufferfi(GL_DEPTH_STENCIL, 0, 0.5, 77);
            clear_no: |c, f| c.clear_named_framebufferfv(f, GL_STENCIL, 0, &[0.5]), |c| c.clear_bufferfv(GL_STENCIL, 0, &[0.5]);
            clear_far: |c, f| c.clear_named_framebufferiv(f, GL_COLOR, 8, &[0; 4]), |c| c.clear_bufferiv(GL_COLOR, 8, &[0; 4]);
            invalidate: |c, f| c.invalidate_named_framebuffer_data(f, 1, &[GL_COLOR]), |c| c.invalidate_framebuffer(FB, 1, &[GL_COLOR]);
            part: |c, f| c.invalidate_named_framebuffer_sub_data(f, 0, &[], 0, 0, 1, -1), |c| c.invalidate_sub_framebuffer(FB, 0, &[], 0, 0, 1, -1);
            read: |c, f| c.named_framebuffer_read_buffer(f, SECOND), |c| c.read_buffer(SECOND);
            read_no: |c, f| c.named_framebuffer_read_buffer(f, GL_BACK), |c| c.read_buffer(GL_BACK);
        },
    );
    for (attachment, pname) in [
        (COLOR, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME),
        (SECOND, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER),
        (BOTH, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE),
    ] {
        let (mut one, mut other) = ([-1], [-1]);
        named.get_named_framebuffer_attachment_parameteriv(1, attachment, pname, &mut one);
        bound.get_framebuffer_attachment_parameteriv(FB, attachment, pname, &mut other);
        assert_eq!(one, other, "{}", enum_name(pname));
    }
    assert_eq!(integer(&mut named, GL_DRAW_FRAMEBUFFER_BINDING), 0);
    assert_eq!(
        integer(&mut named, GL_READ_BUFFER) as GLenum,
        GL_FRONT,
        "of the default framebuffer"
    );
    named.bind_framebuffer(FB, 1);
    let integers = pixels(&mut named, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE);
    assert_eq!(integers[..4], [1, 2, 3, 4]);
    assert_eq!(integers, pixels(&mut bound, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE));
    for c in [&mut named, &mut bound] {
        c.named_framebuffer_read_buffer(1, COLOR);
    }
    let colors = pixels(&mut named, GL_RGBA, GL_UNSIGNED_BYTE);
    assert_eq!(colors[..4], [64, 128, 191, 255]);
    assert_eq!(colors, pixels(&mut bound, GL_RGBA, GL_UNSIGNED_BYTE));
    let both = pixels(&mut named, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
    assert_eq!(both[0], 77);
    assert_eq!(both, pixels(&mut bound, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8));
}

#[test]
fn blits_read_and_write_what_they_name() {
    let (mut named, mut bound) = (context(), context());
    for c in [&mut named, &mut bound] {
        images(c);
        c.create_framebuffers(1, &mut [0]);
        c.named_framebuffer_renderbuffer(1, COLOR, RB, 1);
        c.clear_named_framebufferfv(1, GL_COLOR, 0, &[1.0, 0.0, 0.5, 1.0]);
        c.clear_named_framebufferfv(0, GL_COLOR, 0, &[0.0, 1.0, 0.0, 1.0]);
    }
    named.blit_named_framebuffer(1, 0, 0, 0, 4, 4, 2, 2, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    bound.bind_framebuffer(GL_READ_FRAMEBUFFER, 1);
    bound.blit_framebuffer(0, 0, 4, 4, 2, 2, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    bound.bind_framebuffer(GL_READ_FRAMEBUFFER, 0);
    let one = pixels(&mut named, GL_RGBA, GL_UNSIGNED_BYTE);
    assert_eq!([&one[..4], &one[252..]], [[0, 255, 0, 255], [255, 0, 128, 255]]);
    assert_eq!(one, pixels(&mut bound, GL_RGBA, GL_UNSIGNED_BYTE));
    // A filter that there is not, and depths with one.
    for (mask, filter) in
        [(GL_COLOR_BUFFER_BIT, GL_RGBA), (GL_DEPTH_BUFFER_BIT, GL_LINEAR), (1, GL_NEAREST)]
    {
        named.blit_named_framebuffer(1, 0, 0, 0, 1, 1, 0, 0, 1, 1, mask, filter);
        bound.blit_framebuffer(0, 0, 1, 1, 0, 0, 1, 1, mask, filter);
        let (one, other) = (flags(&mut named), flags(&mut bound));
        assert_eq!(enum_name(one), enum_name(other));
        assert_ne!(one, GL_NO_ERROR);
    }
}

#[test]
fn draws_go_on_where_they_did_after_a_clear_of_another_framebuffer() {
    let mut c = context();
    images(&mut c);
    c.create_framebuffers(1, &mut [0]);
    c.named_framebuffer_renderbuffer(1, COLOR, RB, 1);
    c.color_4f(1.0, 1.0, 1.0, 1.0);
    c.rectf(-1.0, -1.0, 0.0, 1.0);
    c.clear_named_framebufferfv(1, GL_COLOR, 0, &[1.0, 0.0, 0.0, 1.0]);
    c.rectf(0.0, -1.0, 1.0, 1.0);
    let window = pixels(&mut c, GL_RGBA, GL_UNSIGNED_BYTE);
    assert!(window.iter().all(|byte| *byte == 255));
    c.bind_framebuffer(FB, 1);
    let other = pixels(&mut c, GL_RGBA, GL_UNSIGNED_BYTE);
    assert!(other.chunks(4).all(|pixel| *pixel == [255, 0, 0, 255]));
}

#[test]
fn renderbuffers() {
    let (mut named, mut bound) = (context(), context());
    named.create_renderbuffers(1, &mut [0]);
    bound.bind_renderbuffer(RB, 1);
    run(
        &mut named,
        1,
        &mut bound,
        twins! {
            storage: |c, r| c.named_renderbuffer_storage_multisample(r, 4, GL_RGB8, 5, 6),
                |c| c.renderbuffer_storage_multisample(RB, 4, GL_RGB8, 5, 6);
            format: |c, r| c.named_renderbuffer_storage(r, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 5, 6), |c| c.renderbuffer_storage(RB, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 5, 6);
            size: |c, r| c.named_renderbuffer_storage(r, GL_RGB8, -5, 6), |c| c.renderbuffer_storage(RB, GL_RGB8, -5, 6);
            samples: |c, r| c.named_renderbuffer_storage_multisample(r, 99, GL_RGB8, 5, 6),
                |c| c.renderbuffer_storage_multisample(RB, 99, GL_RGB8, 5, 6);
        },
    );
    for pname in [GL_RENDERBUFFER_WIDTH, GL_RENDERBUFFER_SAMPLES, GL_RENDERBUFFER_INTERNAL_FORMAT] {
        let (mut one, mut other) = ([-1], [-1]);
        named.get_named_renderbuffer_parameteriv(1, pname, &mut one);
        bound.get_renderbuffer_parameteriv(RB, pname, &mut other);
        assert_eq!(one, other);
        assert!(one[0] > 0);
    }
    named.create_framebuffers(1, &mut [0]);
    named.named_framebuffer_renderbuffer(1, COLOR, RB, 1);
    let mut samples = [0];
    named.get_named_framebuffer_parameteriv(1, GL_SAMPLES, &mut samples);
    assert_eq!((samples[0], integer(&mut named, GL_SAMPLES)), (4, 0));
    assert_eq!(integer(&mut named, GL_RENDERBUFFER_BINDING), 0);
}

#[test]
fn the_draw_buffer_is_of_the_framebuffer_that_is_named() {
    let mut c = context();
    images(&mut c);
    c.create_framebuffers(1, &mut [0]);
    c.named_framebuffer_renderbuffer(1, SECOND, RB, 1);
    c.named_framebuffer_draw_buffer(1, SECOND);
    assert_eq!(integer(&mut c, GL_DRAW_BUFFER) as GLenum, GL_FRONT);
    c.bind_framebuffer(FB, 1);
    assert_eq!(integer(&mut c, GL_DRAW_BUFFER) as GLenum, SECOND);
    c.named_framebuffer_draw_buffer(0, GL_NONE);
    assert_eq!(integer(&mut c, GL_DRAW_BUFFER) as GLenum, SECOND);
    c.bind_framebuffer(FB, 0);
    assert_eq!(integer(&mut c, GL_DRAW_BUFFER) as GLenum, GL_NONE);
    assert_eq!(flags(&mut c), GL_NO_ERROR);
}
