//! What is drawn to, and what is read from it.

use crate::{Use, draw, paint, pixel, renderbuffer, row, sampled, texture};
use gl_api::*;

const COLOR: GLenum = GL_COLOR_ATTACHMENT0;

/// The first pixel, as floats.
fn floats(c: &mut Context) -> [f32; 4] {
    let mut bytes = [0; 16];
    c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, DataOut::Bytes(&mut bytes));
    [0, 4, 8, 12].map(|at| f32::from_le_bytes([0, 1, 2, 3].map(|byte| bytes[at + byte])))
}

/// A parameter of the bound renderbuffer.
fn bits(c: &mut Context, pname: GLenum) -> GLint {
    let mut value = [0];
    c.get_renderbuffer_parameteriv(GL_RENDERBUFFER, pname, &mut value);
    value[0]
}

pub const USES: &[Use] = &[
    ("EXT_color_buffer_float", |c| {
        renderbuffer(c, GL_RGBA32F, COLOR);
        paint(c, "vec4(2.5, -1.0, 1e-30, 3e30)");
        assert_eq!(floats(c), [2.5, -1.0, 1e-30, 3e30]);
        renderbuffer(c, GL_R11F_G11F_B10F, COLOR);
        paint(c, "vec4(2.5, 0.25, 4.0, 1.0)");
        assert_eq!(floats(c), [2.5, 0.25, 4.0, 1.0]);
    }),
    ("EXT_discard_framebuffer", |c| {
        c.invalidate_framebuffer(GL_FRAMEBUFFER, 2, &[GL_COLOR_EXT, GL_DEPTH_EXT]);
        assert_eq!(draw(c, "vec4(0.2)"), [51; 4]);
        renderbuffer(c, GL_RGBA8, COLOR);
        c.invalidate_framebuffer(GL_FRAMEBUFFER, 1, &[COLOR]);
        assert_eq!(draw(c, "vec4(0.4)"), [102; 4]);
    }),
    ("EXT_float_blend", |c| {
        renderbuffer(c, GL_RGBA32F, COLOR);
        c.enable(GL_BLEND);
        c.blend_func(GL_ONE, GL_ONE);
        paint(c, "vec4(2.5, -1.0, 0.0, 1.0)");
        paint(c, "vec4(2.5, 0.5, 0.25, 1.0)");
        assert_eq!(floats(c), [5.0, -0.5, 0.25, 2.0]);
    }),
    ("EXT_read_format_bgra", |c| {
        draw(c, "vec4(0.2, 0.4, 0.6, 0.8)");
        let mut pixel = [0; 4];
        c.read_pixels(0, 0, 1, 1, GL_BGRA_EXT, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
        assert_eq!(pixel, [153, 102, 51, 204]);
    }),
    // 0.5 is encoded as 187.5 255ths.
    ("EXT_sRGB_write_control", |c| {
        renderbuffer(c, GL_SRGB8_ALPHA8, COLOR);
        assert!(c.is_enabled(GL_FRAMEBUFFER_SRGB_EXT));
        assert_eq!(draw(c, "vec4(0.5)"), [188, 188, 188, 128]);
        c.disable(GL_FRAMEBUFFER_SRGB_EXT);
        assert_eq!(draw(c, "vec4(0.5)"), [128; 4]);
    }),
    ("OES_depth24", |c| {
        renderbuffer(c, GL_DEPTH_COMPONENT24_OES, GL_DEPTH_ATTACHMENT);
        assert_eq!(bits(c, GL_RENDERBUFFER_DEPTH_SIZE), 24);
    }),
    ("OES_fbo_render_mipmap", |c| {
        let name = texture(c, GL_NEAREST);
        let filter = GL_NEAREST_MIPMAP_NEAREST as GLint;
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        for (level, side) in [(0, 4), (1, 2), (2, 1)] {
            let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
            c.tex_image_2d(
                GL_TEXTURE_2D,
                level,
                GL_RGBA as i32,
                side,
                side,
                0,
                format,
                ty,
                Data::Null,
            );
        }
        let mut framebuffer = [0];
        c.gen_framebuffers(1, &mut framebuffer);
        c.bind_framebuffer(GL_FRAMEBUFFER, framebuffer[0]);
        c.framebuffer_texture_2d(GL_FRAMEBUFFER, COLOR, GL_TEXTURE_2D, name, 1);
        c.bind_texture(GL_TEXTURE_2D, 0);
        assert_eq!(draw(c, "vec4(0.6)"), [153; 4]);
        c.bind_framebuffer(GL_FRAMEBUFFER, 0);
        c.bind_texture(GL_TEXTURE_2D, name);
        assert_eq!(draw(c, "textureLod(image, vec2(0.5), 1.0)"), [153; 4]);
        assert_eq!(draw(c, "textureLod(image, vec2(0.5), 0.0)"), [0; 4]);
    }),
    ("OES_packed_depth_stencil", |c| {
        renderbuffer(c, GL_DEPTH24_STENCIL8_OES, GL_DEPTH_ATTACHMENT);
        let sizes = [GL_RENDERBUFFER_DEPTH_SIZE, GL_RENDERBUFFER_STENCIL_SIZE];
        assert_eq!(sizes.map(|pname| bits(c, pname)), [24, 8]);
    }),
    ("OES_rgb8_rgba8", |c| {
        renderbuffer(c, GL_RGB8_OES, COLOR);
        assert_eq!(draw(c, "vec4(0.2, 0.4, 0.6, 0.8)"), [51, 102, 153, 255]);
        renderbuffer(c, GL_RGBA8_OES, COLOR);
        assert_eq!(draw(c, "vec4(0.2, 0.4, 0.6, 0.8)"), [51, 102, 153, 204]);
    }),
    ("EXT_texture_rg", |c| {
        texture(c, GL_NEAREST);
        row(c, (GL_RED_EXT, GL_RED_EXT, GL_UNSIGNED_BYTE), 1, &[9]);
        assert_eq!(sampled(c), [9, 0, 0, 255]);
        row(c, (GL_RG_EXT, GL_RG_EXT, GL_UNSIGNED_BYTE), 1, &[1, 2]);
        assert_eq!(sampled(c), [1, 2, 0, 255]);
        renderbuffer(c, GL_RG8_EXT, COLOR);
        draw(c, "vec4(0.2, 0.4, 0.6, 0.8)");
        assert_eq!(pixel(c, 0, 0), [51, 102, 0, 255]);
    }),
];
