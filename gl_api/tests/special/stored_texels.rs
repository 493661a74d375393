//! `glCopyImageSubData`, `glClearTexImage`, `glClearTexSubImage`, `glClearBufferData`: texels as they are stored.

use super::{context, fine};
use gl_api::*;

/// A texture with storage.
fn texture(c: &mut Context, target: GLenum, internal: GLenum, size: [GLsizei; 3]) -> GLuint {
    let mut name = [0];
    c.gen_textures(1, &mut name);
    c.bind_texture(target, name[0]);
    let [width, height, depth] = size;
    match target {
        GL_TEXTURE_1D => c.tex_storage_1d(target, 1, internal, width),
        GL_TEXTURE_1D_ARRAY => c.tex_storage_2d(target, 1, internal, width, depth),
        GL_TEXTURE_2D | GL_TEXTURE_CUBE_MAP => c.tex_storage_2d(target, 1, internal, width, height),
        _ => c.tex_storage_3d(target, 1, internal, width, height, depth),
    }
    fine(c);
    name[0]
}

/// All texels, bytes of RGBA, of a level that has images along its third axis.
fn texels(c: &mut Context, name: GLuint, size: [GLsizei; 3]) -> Vec<[u8; 4]> {
    let [width, height, depth] = size;
    let count = (width * height * depth) as usize;
    let mut bytes = vec![0; 4 * count];
    let length = bytes.len() as GLsizei;
    let (format, ty, out) = (GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut bytes));
    c.get_texture_sub_image(name, 0, 0, 0, 0, width, height, depth, format, ty, length, out);
    fine(c);
    bytes.chunks_exact(4).map(|texel| [texel[0], texel[1], texel[2], texel[3]]).collect()
}

/// Texel (x, y, z) has the colour (x, y, z, 255).
fn fill(c: &mut Context, target: GLenum, name: GLuint, size: [GLsizei; 3]) {
    for z in 0..size[2] {
        for y in 0..size[1] {
            for x in 0..size[0] {
                let texel = [x as u8, y as u8, z as u8, 255];
                // The layers of a one-dimensional array are its second axis there.
                let (at, one) = match target {
                    GL_TEXTURE_1D_ARRAY => ([x, z, 0], [1, 1, 1]),
                    _ => ([x, y, z], [1, 1, 1]),
                };
                let data = Data::Bytes(&texel);
                let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
                c.clear_tex_sub_image(
                    name, 0, at[0], at[1], at[2], one[0], one[1], one[2], format, ty, data,
                );
            }
        }
    }
    fine(c);
}

#[test]
fn copies_go_between_all_targets() {
    let targets = [
        (GL_TEXTURE_1D, [8, 1, 1]),
        (GL_TEXTURE_1D_ARRAY, [8, 1, 6]),
        (GL_TEXTURE_2D, [8, 8, 1]),
        (GL_TEXTURE_2D_ARRAY, [8, 8, 6]),
        (GL_TEXTURE_3D, [8, 8, 8]),
        (GL_TEXTURE_CUBE_MAP, [8, 8, 6]),
        (GL_TEXTURE_CUBE_MAP_ARRAY, [8, 8, 12]),
    ];
    let mut c = context(4, 4);
    let mut copied = 0;
    for (from_target, from_size) in targets {
        let from = texture(&mut c, from_target, GL_RGBA8, from_size);
        fill(&mut c, from_target, from, from_size);
        for (to_target, to_size) in targets {
            let to = texture(&mut c, to_target, GL_RGBA8, to_size);
            // The upper half of what both have, to the lower half.
            let size = [0, 1, 2].map(|axis: usize| (from_size[axis].min(to_size[axis]) + 1) / 2);
            let at = [0, 1, 2].map(|axis: usize| from_size[axis] - size[axis]);
            c.copy_image_sub_data(
                from,
                from_target,
                0,
                at[0],
                at[1],
                at[2],
                to,
                to_target,
                0,
                0,
                0,
                0,
                size[0],
                size[1],
                size[2],
            );
            fine(&mut c);
            let shape = match to_target {
                GL_TEXTURE_1D_ARRAY => [to_size[0], to_size[2], 1],
                _ => to_size,
            };
            let found = texels(&mut c, to, shape);
            for z in 0..to_size[2] {
                for y in 0..to_size[1] {
                    for x in 0..to_size[0] {
                        let index = (z * to_size[1] + y) * to_size[0] + x;
                        let inside = x < size[0] && y < size[1] && z < size[2];
                        let wanted = match inside {
                            true => [(x + at[0]) as u8, (y + at[1]) as u8, (z + at[2]) as u8, 255],
                            false => [0; 4],
                        };
                        let found = found[index as usize];
                        assert_eq!(
                            found, wanted,
                            "{from_target:#x} to {to_target:#x}: {x} {y} {z}"
                        );
                        copied += usize::from(inside);
                    }
                }
            }
        }
    }
    assert!(copied > 800, "{copied}");
}

#[test]
fn texels_are_taken_for_others_of_their_size_and_blocks_for_texels() {
    let mut c = context(4, 4);
    let floats = texture(&mut c, GL_TEXTURE_2D, GL_R32F, [4, 4, 1]);
    let bytes = texture(&mut c, GL_TEXTURE_2D, GL_RGBA8, [4, 4, 1]);
    let value = Data::Bytes(bytemuck::bytes_of(&1.5_f32));
    c.clear_tex_image(floats, 0, GL_RED, GL_FLOAT, value);
    c.copy_image_sub_data(
        floats,
        GL_TEXTURE_2D,
        0,
        0,
        0,
        0,
        bytes,
        GL_TEXTURE_2D,
        0,
        0,
        0,
        0,
        4,
        4,
        1,
    );
    assert_eq!(texels(&mut c, bytes, [4, 4, 1]), [1.5_f32.to_le_bytes(); 16]);
    // 8×8 texels in blocks of 16 bytes are 2×2 texels of 16 bytes.
    let blocks = texture(&mut c, GL_TEXTURE_2D, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, [8, 8, 1]);
    let words = texture(&mut c, GL_TEXTURE_2D, GL_RGBA32UI, [2, 2, 1]);
    let block: [u8; 16] = std::array::from_fn(|at| at as u8);
    let all = block.repeat(4);
    let (width, height, format) = (8, 8, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT);
    c.bind_texture(GL_TEXTURE_2D, blocks);
    let data = Data::Bytes(&all);
    c.compressed_tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, width, height, format, 64, data);
    c.copy_image_sub_data(
        blocks,
        GL_TEXTURE_2D,
        0,
        4,
        0,
        0,
        words,
        GL_TEXTURE_2D,
        0,
        1,
        0,
        0,
        4,
        8,
        1,
    );
    let mut found = vec![0; 64];
    let (format, ty) = (GL_RGBA_INTEGER, GL_UNSIGNED_INT);
    let out = DataOut::Bytes(&mut found);
    c.get_texture_sub_image(words, 0, 0, 0, 0, 2, 2, 1, format, ty, 64, out);
    fine(&mut c);
    assert_eq!(found, [[0; 16], block, [0; 16], block].concat());
    // And back.
    c.copy_image_sub_data(
        words,
        GL_TEXTURE_2D,
        0,
        0,
        0,
        0,
        blocks,
        GL_TEXTURE_2D,
        0,
        4,
        4,
        0,
        1,
        1,
        1,
    );
    let mut found = vec![0; 64];
    c.get_compressed_texture_sub_image(blocks, 0, 0, 0, 0, 8, 8, 1, 64, DataOut::Bytes(&mut found));
    fine(&mut c);
    assert_eq!(found, [block, block, block, [0; 16]].concat());
    // Texels of another size, and of another kind, are none of these.
    for other in [GL_RGBA16F, GL_RGBA4, GL_DEPTH_COMPONENT24] {
        let other = texture(&mut c, GL_TEXTURE_2D, other, [4, 4, 1]);
        c.copy_image_sub_data(
            floats,
            GL_TEXTURE_2D,
            0,
            0,
            0,
            0,
            other,
            GL_TEXTURE_2D,
            0,
            0,
            0,
            0,
            1,
            1,
            1,
        );
        assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    }
}

#[test]
fn every_sample_is_copied_and_cleared() {
    let mut c = context(4, 4);
    let mut names = [0; 2];
    c.gen_renderbuffers(2, &mut names);
    for name in names {
        c.bind_renderbuffer(GL_RENDERBUFFER, name);
        c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 4, GL_RGBA8, 4, 4);
    }
    let mut framebuffer = [0];
    c.gen_framebuffers(1, &mut framebuffer);
    c.bind_framebuffer(GL_FRAMEBUFFER, framebuffer[0]);
    let (target, attachment) = (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0);
    c.framebuffer_renderbuffer(target, attachment, GL_RENDERBUFFER, names[0]);
    c.clear_color(0.0, 0.0, 0.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    // An edge through the pixels: some have covered samples and others.
    c.begin(GL_TRIANGLES);
    c.vertex_2f(-1.0, -1.0);
    c.vertex_2f(1.0, -1.0);
    c.vertex_2f(-1.0, 0.7);
    c.end();
    let resolved = |c: &mut Context, name: GLuint| {
        let mut bytes = vec![0; 64];
        c.framebuffer_renderbuffer(target, attachment, GL_RENDERBUFFER, name);
        c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
        c.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        c.bind_framebuffer(GL_READ_FRAMEBUFFER, 0);
        let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
        c.read_pixels(0, 0, 4, 4, format, ty, DataOut::Bytes(&mut bytes));
        c.bind_framebuffer(GL_FRAMEBUFFER, framebuffer[0]);
        fine(c);
        bytes
    };
    let drawn = resolved(&mut c, names[0]);
    let mixed = drawn.chunks_exact(4).filter(|texel| ![0, 255].contains(&texel[0])).count();
    assert!(mixed > 0, "{drawn:?}");
    let rows = [names[0], names[1]];
    c.copy_image_sub_data(
        rows[0],
        GL_RENDERBUFFER,
        0,
        0,
        0,
        0,
        rows[1],
        GL_RENDERBUFFER,
        0,
        0,
        0,
        0,
        4,
        4,
        1,
    );
    fine(&mut c);
    assert_eq!(resolved(&mut c, names[1]), drawn);
    // A renderbuffer with one sample has not as many.
    c.bind_renderbuffer(GL_RENDERBUFFER, names[1]);
    c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, 4, 4);
    c.copy_image_sub_data(
        rows[0],
        GL_RENDERBUFFER,
        0,
        0,
        0,
        0,
        rows[1],
        GL_RENDERBUFFER,
        0,
        0,
        0,
        0,
        4,
        4,
        1,
    );
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
}

#[test]
fn a_clear_converts_its_pixel_once_and_keeps_what_draws_saw() {
    let mut c = context(4, 4);
    let name = texture(&mut c, GL_TEXTURE_2D, GL_RGBA8, [4, 4, 1]);
    let pixel = [1.0_f32, 0.5, 0.0];
    let data = Data::Bytes(bytemuck::cast_slice(&pixel));
    c.clear_tex_image(name, 0, GL_RGB, GL_FLOAT, data);
    assert_eq!(texels(&mut c, name, [4, 4, 1]), [[255, 128, 0, 255]; 16]);
    // A recorded draw reads the texels of before.
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    c.enable(GL_TEXTURE_2D);
    c.rectf(-1.0, -1.0, 1.0, 1.0);
    c.clear_tex_sub_image(name, 0, 1, 1, 0, 2, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, Data::Null);
    let mut drawn = vec![0; 64];
    c.read_pixels(0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut drawn));
    assert_eq!(drawn, [255, 128, 0, 255].repeat(16));
    let found = texels(&mut c, name, [4, 4, 1]);
    for (index, texel) in found.into_iter().enumerate() {
        let is_inside = [5, 6, 9, 10].contains(&index);
        assert_eq!(texel, if is_inside { [0; 4] } else { [255, 128, 0, 255] }, "{index}");
    }
}

#[test]
fn buffers_are_filled_in_texels() {
    let mut c = context(4, 4);
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    c.buffer_data(GL_ARRAY_BUFFER, 16, Data::Bytes(&[7; 16]), GL_STATIC_DRAW);
    let bytes = |c: &mut Context| {
        let mut found = [0; 16];
        c.get_buffer_sub_data(GL_ARRAY_BUFFER, 0, 16, DataOut::Bytes(&mut found));
        fine(c);
        found
    };
    let value = [2.0_f32, 0.5];
    let data = Data::Bytes(bytemuck::cast_slice(&value));
    c.clear_buffer_sub_data(GL_ARRAY_BUFFER, GL_RG16, 4, 8, GL_RG, GL_FLOAT, data);
    let mut wanted = [7; 16];
    wanted[4..12].copy_from_slice(&[255, 255, 0, 128, 255, 255, 0, 128]);
    assert_eq!(bytes(&mut c), wanted);
    // While a part is mapped, another can be cleared.
    c.map_buffer_range(GL_ARRAY_BUFFER, 0, 4, GL_MAP_READ_BIT);
    let clear = |c: &mut Context, offset, size| {
        let data = Data::Null;
        let (format, ty) = (GL_RED, GL_UNSIGNED_BYTE);
        c.clear_buffer_sub_data(GL_ARRAY_BUFFER, GL_R8, offset, size, format, ty, data);
        c.get_error()
    };
    assert_eq!(clear(&mut c, 12, 4), GL_NO_ERROR);
    assert_eq!(clear(&mut c, 3, 4), GL_INVALID_OPERATION);
    c.unmap_buffer(GL_ARRAY_BUFFER);
    wanted[12..].fill(0);
    assert_eq!(bytes(&mut c), wanted);
    c.clear_buffer_data(GL_ARRAY_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, Data::Null);
    assert_eq!(bytes(&mut c), [0; 16]);
}
