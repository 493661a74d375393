//! Parts of levels, read back by the texture's name (`ARB_get_texture_sub_image`).

use super::context;
use gl_api::*;

const RED: GLenum = GL_RED;
const BYTE: GLenum = GL_UNSIGNED_BYTE;

/// A texture of one byte a texel that says where it is: `x + 10 y + 50 z`.
fn numbered([width, height, depth]: [u8; 3]) -> Vec<u8> {
    let (w, h) = (width, height);
    let rows = (0..depth).flat_map(|z| (0..h).map(move |y| 10 * y + 50 * z));
    rows.flat_map(|row| (0..w).map(move |x| row + x)).collect()
}

/// The bytes of a box of texture 1.
#[track_caller]
fn part(offset: [i32; 3], size: [i32; 3]) -> Vec<u8> {
    let mut bytes = vec![0; size.iter().product::<i32>() as usize];
    let ([x, y, z], [w, h, d], count) = (offset, size, bytes.len());
    glGetTextureSubImage(1, 0, x, y, z, w, h, d, RED, BYTE, count, &mut bytes);
    assert_eq!(glGetError(), GL_NO_ERROR);
    bytes
}

#[test]
fn a_box_of_every_kind_of_texture_is_read() {
    let _current = context();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for target in [GL_TEXTURE_3D, GL_TEXTURE_2D_ARRAY] {
        glBindTexture(target, 1);
        glTexImage3D(target, 0, GL_R8, 4, 3, 2, 0, RED, BYTE, &numbered([4, 3, 2]));
        assert_eq!(part([1, 1, 0], [2, 2, 2]), [11, 12, 21, 22, 61, 62, 71, 72]);
        assert_eq!(part([3, 2, 1], [1, 1, 1]), [73]);
        assert_eq!(part([0, 0, 2], [4, 3, 0]), []);
        glDeleteTextures(1, &1);
    }
    for target in [GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_1D_ARRAY] {
        glBindTexture(target, 1);
        glTexImage2D(target, 0, GL_R8, 4, 3, 0, RED, BYTE, &numbered([4, 3, 1]));
        assert_eq!(part([2, 1, 0], [2, 2, 1]), [12, 13, 22, 23]);
        glDeleteTextures(1, &1);
    }
    glBindTexture(GL_TEXTURE_1D, 1);
    glTexImage1D(GL_TEXTURE_1D, 0, GL_R8, 4, 0, RED, BYTE, &numbered([4, 1, 1]));
    assert_eq!(part([1, 0, 0], [3, 1, 1]), [1, 2, 3]);
    glDeleteTextures(1, &1);
    // The faces of a cube are its images; it must have all of them.
    glBindTexture(GL_TEXTURE_CUBE_MAP, 1);
    let face = |number: u32| {
        let texels: Vec<u8> = (0..4).map(|at| (10 * number + at) as u8).collect();
        let target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + number;
        glTexImage2D(target, 0, GL_R8, 2, 2, 0, RED, BYTE, &texels);
    };
    (0..5).for_each(face);
    let mut bytes = [0_u8; 8];
    glGetTextureSubImage(1, 0, 0, 0, 0, 2, 2, 2, RED, BYTE, 8, &mut bytes);
    assert_eq!(glGetError(), GL_INVALID_OPERATION);
    face(5);
    assert_eq!(part([1, 0, 1], [1, 2, 3]), [11, 13, 21, 23, 31, 33]);
    glDeleteTextures(1, &1);
    // A level without an image has no texels, and none can be read.
    glBindTexture(GL_TEXTURE_2D, 1);
    assert_eq!(part([0; 3], [0; 3]), []);
    glDeleteTextures(1, &1);
    // A border lies outside.
    glBindTexture(GL_TEXTURE_2D, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, 6, 4, 1, RED, BYTE, &numbered([6, 4, 1]));
    assert_eq!(part([0, 0, 0], [2, 1, 1]), [11, 12]);
    assert_eq!(part([3, 1, 0], [1, 1, 1]), [24]);
}

#[test]
fn rows_lie_as_the_pixel_store_says() {
    let _current = context();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glBindTexture(GL_TEXTURE_2D, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, 4, 3, 0, RED, BYTE, &numbered([4, 3, 1]));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ROW_LENGTH, 4);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 1);
    let mut bytes = [99_u8; 8];
    glGetTextureSubImage(1, 0, 2, 1, 0, 2, 2, 1, RED, BYTE, 7, &mut bytes);
    assert_eq!(bytes, [99, 12, 13, 99, 99, 22, 23, 99]);
    // Into a buffer object, and with other components.
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 1);
    glBufferData(GL_PIXEL_PACK_BUFFER, 12, NULL, GL_STREAM_READ);
    glGetTextureSubImage(1, 0, 3, 2, 0, 1, 1, 1, GL_RGBA, GL_UNSIGNED_SHORT, 8, BUFFER_OFFSET(4));
    let mut words = [0_u16; 6];
    glGetBufferSubData(GL_PIXEL_PACK_BUFFER, 0, 12, &mut words);
    assert_eq!(words, [0, 0, 23 * 257, 0, 0, 65535]);
    assert_eq!(glGetError(), GL_NO_ERROR);
}

#[test]
fn blocks_are_read_whole() {
    let _current = context();
    glBindTexture(GL_TEXTURE_2D, 1);
    // Three by two blocks, the last ones cut by the edge.
    let blocks: Vec<u8> = (0..48).collect();
    let format = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
    glCompressedTexImage2D(GL_TEXTURE_2D, 0, format, 10, 8, 0, 48, &blocks);
    let mut read = [0_u8; 16];
    glGetCompressedTextureSubImage(1, 0, 4, 4, 0, 6, 4, 1, 16, &mut read);
    assert_eq!(glGetError(), GL_NO_ERROR);
    assert_eq!(read[..], blocks[32..48]);
    // As texels they are decoded: what glGetTexImage says of the same place.
    let (mut all, mut some) = ([[0_u8; 4]; 80], [[0_u8; 4]; 2]);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, BYTE, all.as_flattened_mut());
    glGetTextureSubImage(1, 0, 5, 3, 0, 1, 2, 1, GL_RGBA, BYTE, 8, some.as_flattened_mut());
    assert_eq!(glGetError(), GL_NO_ERROR);
    assert_eq!(some, [all[35], all[45]]);
}
