//! Texture views of storage that is not of colours in rows: blocks, volumes, rectangles, depths, samples.

use super::views::{framebuffer, name};
use super::{context, fine, pixel};
use gl_api::*;

/// Blocks, volumes, rectangles and depths are viewed too.
#[test]
fn other_kinds_of_storage_have_views() {
    let mut c = context(4, 4);
    let [blocks, volume, rectangle, depth] = [1, 2, 3, 4].map(|_| name(&mut c));
    c.bind_texture(GL_TEXTURE_2D_ARRAY, blocks);
    let dxt = GL_COMPRESSED_RGBA_S3TC_DXT5_EXT;
    c.tex_storage_3d(GL_TEXTURE_2D_ARRAY, 1, dxt, 8, 8, 2);
    let view = name(&mut c);
    let srgb = GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT;
    c.texture_view(view, GL_TEXTURE_2D, blocks, srgb, 0, 1, 1, 1);
    let bytes: Vec<u8> = (0..64).collect();
    c.compressed_texture_sub_image_2d(view, 0, 0, 0, 8, 8, srgb, 64, Data::Bytes(&bytes));
    let mut all = [0; 128];
    c.get_compressed_texture_image(blocks, 0, 128, DataOut::Bytes(&mut all));
    fine(&mut c);
    assert_eq!((&all[..64], &all[64..]), (&[0; 64][..], &bytes[..]));

    c.bind_texture(GL_TEXTURE_3D, volume);
    c.tex_storage_3d(GL_TEXTURE_3D, 3, GL_R8, 4, 4, 4);
    let view = name(&mut c);
    c.texture_view(view, GL_TEXTURE_3D, volume, GL_R8UI, 1, 2, 0, 1);
    let (format, ty, bytes) = (GL_RED_INTEGER, GL_UNSIGNED_BYTE, [1, 2, 3, 4, 5, 6, 7, 8]);
    c.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    c.pixel_storei(GL_PACK_ALIGNMENT, 1);
    c.texture_sub_image_3d(view, 0, 0, 0, 0, 2, 2, 2, format, ty, Data::Bytes(&bytes));
    let mut found = [0; 8];
    c.get_texture_image(volume, 1, GL_RED, ty, 8, DataOut::Bytes(&mut found));
    fine(&mut c);
    assert_eq!(found, bytes);

    c.bind_texture(GL_TEXTURE_RECTANGLE, rectangle);
    c.tex_storage_2d(GL_TEXTURE_RECTANGLE, 1, GL_RG8, 2, 1);
    let view = name(&mut c);
    c.texture_view(view, GL_TEXTURE_RECTANGLE, rectangle, GL_R16UI, 0, 1, 0, 1);
    let bytes = 0x0201u16.to_ne_bytes().repeat(2);
    let ty = GL_UNSIGNED_SHORT;
    c.texture_sub_image_2d(view, 0, 0, 0, 2, 1, GL_RED_INTEGER, ty, Data::Bytes(&bytes));
    let mut found = [0; 4];
    let out = DataOut::Bytes(&mut found);
    c.get_texture_image(rectangle, 0, GL_RG, GL_UNSIGNED_BYTE, 4, out);
    fine(&mut c);
    assert_eq!(found, [1, 2, 1, 2]);

    c.bind_texture(GL_TEXTURE_2D_ARRAY, depth);
    c.tex_storage_3d(GL_TEXTURE_2D_ARRAY, 1, GL_DEPTH24_STENCIL8, 4, 4, 3);
    let view = name(&mut c);
    c.texture_view(view, GL_TEXTURE_2D, depth, GL_DEPTH24_STENCIL8, 0, 1, 2, 1);
    framebuffer(&mut c);
    let (to, at) = (GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT);
    c.framebuffer_texture_2d(to, at, GL_TEXTURE_2D, view, 0);
    c.draw_buffer(GL_NONE);
    c.read_buffer(GL_NONE);
    c.clear_depth(0.25);
    c.clear_stencil(7);
    c.clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    let mut found = [0u8; 4 * 3 * 16];
    let (length, out) = (found.len() as GLsizei, DataOut::Bytes(&mut found));
    c.get_texture_image(depth, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, length, out);
    fine(&mut c);
    let words: Vec<u32> =
        found.chunks_exact(4).map(|b| u32::from_ne_bytes([b[0], b[1], b[2], b[3]])).collect();
    assert_eq!((words[0], words[31]), (0, 0));
    assert!(words[32..].iter().all(|word| *word == (0x40_0000 << 8 | 7)), "{:X}", words[32]);
}

/// Samples of a layer are drawn to through a view and resolved from the array.
#[test]
fn samples_are_shared() {
    let mut c = context(4, 4);
    let (array, one) = (GL_TEXTURE_2D_MULTISAMPLE_ARRAY, GL_TEXTURE_2D_MULTISAMPLE);
    let [origin, view] = [name(&mut c), name(&mut c)];
    c.bind_texture(array, origin);
    c.tex_storage_3d_multisample(array, 4, GL_RGBA8, 4, 4, 3, true);
    c.texture_view(view, one, origin, GL_RGBA8, 0, 1, 1, 1);
    fine(&mut c);
    framebuffer(&mut c);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, one, view, 0);
    c.clear_color(0.0, 0.0, 0.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    // The left half of the second column of pixels has half of its samples.
    c.color_3f(1.0, 1.0, 1.0);
    c.rectf(-1.0, -1.0, -0.25, 1.0);
    fine(&mut c);
    for (layer, expected) in [(0, [0; 3]), (1, [255, 128, 0]), (2, [0; 3])] {
        framebuffer(&mut c);
        let at = GL_COLOR_ATTACHMENT0;
        c.framebuffer_texture_layer(GL_READ_FRAMEBUFFER, at, origin, 0, layer);
        c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
        c.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        c.bind_framebuffer(GL_FRAMEBUFFER, 0);
        fine(&mut c);
        let found = [0, 1, 2].map(|x| pixel(&mut c, x, 1)[0]);
        assert_eq!(found, expected, "{layer}");
    }
}
