//! Formats, filters and parameters of textures.

use crate::{Use, draw, row, sampled, texture};
use gl_api::*;

const BYTES: (GLenum, GLenum, GLenum) = (GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE);

/// Two texels: one dark, one light.
const TWO: [u8; 8] = [10, 10, 10, 10, 200, 200, 200, 200];

pub const USES: &[Use] = &[
    ("EXT_texture_filter_anisotropic", |c| {
        texture(c, GL_LINEAR);
        row(c, BYTES, 2, &TWO);
        let mut most = [0.0];
        c.get_floatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &mut most);
        assert!(most[0] >= 2.0);
        c.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 2.0);
        let mut set = [0.0];
        c.get_tex_parameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, &mut set);
        assert_eq!(set, [2.0]);
        assert_eq!(sampled(c), [105; 4]);
    }),
    ("EXT_texture_format_BGRA8888", |c| {
        texture(c, GL_NEAREST);
        row(c, (GL_BGRA_EXT, GL_BGRA_EXT, GL_UNSIGNED_BYTE), 1, &[1, 2, 3, 4]);
        assert_eq!(sampled(c), [3, 2, 1, 4]);
        let (texel, ty) = (Data::Bytes(&[5, 6, 7, 8]), GL_UNSIGNED_BYTE);
        c.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_BGRA_EXT, ty, texel);
        assert_eq!(sampled(c), [7, 6, 5, 8]);
    }),
    // Mirrored once about 0, clamped from ±1 on.
    ("EXT_texture_mirror_clamp_to_edge", |c| {
        texture(c, GL_NEAREST);
        row(c, BYTES, 2, &TWO);
        let mode = GL_MIRROR_CLAMP_TO_EDGE_EXT as GLint;
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, mode);
        for (s, wanted) in [(-0.25, 10), (-0.75, 200), (-3.25, 200), (0.25, 10), (2.25, 200)] {
            let color = format!("texture(image, vec2({s:?}, 0.5))");
            assert_eq!(draw(c, &color), [wanted; 4], "{s}");
        }
    }),
    // 188 is 128.2 255ths.
    ("EXT_texture_sRGB_decode", |c| {
        texture(c, GL_NEAREST);
        row(c, (GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE), 1, &[188; 4]);
        assert_eq!(sampled(c), [128, 128, 128, 188]);
        let pname = GL_TEXTURE_SRGB_DECODE_EXT;
        c.tex_parameteri(GL_TEXTURE_2D, pname, GL_SKIP_DECODE_EXT as GLint);
        assert_eq!(sampled(c), [188; 4]);
        c.tex_parameteri(GL_TEXTURE_2D, pname, GL_DECODE_EXT as GLint);
        assert_eq!(sampled(c), [128, 128, 128, 188]);
    }),
    ("EXT_unpack_subimage", |c| {
        texture(c, GL_NEAREST);
        let parameters = [
            (GL_UNPACK_ROW_LENGTH_EXT, 2),
            (GL_UNPACK_SKIP_PIXELS_EXT, 1),
            (GL_UNPACK_SKIP_ROWS_EXT, 1),
        ];
        for (pname, value) in parameters {
            c.pixel_storei(pname, value);
        }
        let texels: Vec<u8> = (0..16).collect();
        row(c, BYTES, 1, &texels);
        assert_eq!(sampled(c), [12, 13, 14, 15]);
    }),
    // Half-way between the two.
    ("OES_texture_float_linear", |c| {
        texture(c, GL_LINEAR);
        let texels: Vec<u8> =
            [0.25_f32, 0.75].iter().flat_map(|texel| texel.to_le_bytes()).collect();
        row(c, (GL_R32F, GL_RED, GL_FLOAT), 2, &texels);
        assert_eq!(sampled(c), [128, 0, 0, 255]);
    }),
    ("OES_texture_half_float_linear", |c| {
        texture(c, GL_LINEAR);
        let texels: Vec<u8> =
            [0x3400_u16, 0x3A00].iter().flat_map(|texel| texel.to_le_bytes()).collect();
        row(c, (GL_LUMINANCE, GL_LUMINANCE, GL_HALF_FLOAT_OES), 2, &texels);
        assert_eq!(sampled(c), [128, 128, 128, 255]);
    }),
    // Three texels: with a mipmap, and repeated.
    ("OES_texture_npot", |c| {
        texture(c, GL_NEAREST);
        row(c, BYTES, 3, &[[10; 4], [20; 4], [30; 4]].concat());
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT as GLint);
        assert_eq!(draw(c, "texture(image, vec2(-0.5 / 3.0, 0.5))"), [30; 4]);
        assert_eq!(draw(c, "texture(image, vec2(4.5 / 3.0, 0.5))"), [20; 4]);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST as GLint);
        c.generate_mipmap(GL_TEXTURE_2D);
        // The level of one texel is their mean.
        assert_eq!(draw(c, "textureLod(image, vec2(0.5), 1.0)"), [20; 4]);
    }),
];
