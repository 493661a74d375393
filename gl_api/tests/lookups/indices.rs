//! Pixels that are indices: bytes, wider words and bits, through shift, offset and the pixel maps into
//! textures and onto the window, and where indices are refused.

use super::context;
use bytemuck::cast_slice;
use gl_api::*;

/// Four colours to be found by index.
const COLORS: [[u8; 4]; 4] = [[10, 20, 30, 40], [50, 60, 70, 80], [90, 100, 110, 120], [255; 4]];

/// Maps of these colours.
fn set_maps() {
    let maps = [GL_PIXEL_MAP_I_TO_R, GL_PIXEL_MAP_I_TO_G, GL_PIXEL_MAP_I_TO_B, GL_PIXEL_MAP_I_TO_A];
    for (component, map) in maps.into_iter().enumerate() {
        let column = COLORS.map(|color| f32::from(color[component]) / 255.0);
        glPixelMapfv(map, 4, &column);
    }
}

/// The colours of a level of a texture.
fn texels<const N: usize>() -> [[u8; 4]; N] {
    let mut bytes = vec![0_u8; 4 * N];
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut bytes[..]);
    assert_eq!(glGetError(), GL_NO_ERROR);
    std::array::from_fn(|i| bytes[4 * i..][..4].try_into().unwrap())
}

#[test]
fn every_type_of_index_finds_its_colour() {
    let _current = context();
    set_maps();
    let t = GL_TEXTURE_2D;
    let upload = |ty, pixels: &[u8]| {
        glTexImage2D(t, 0, GL_RGBA8, 4, 1, 0, GL_COLOR_INDEX, ty, pixels);
        assert_eq!(texels(), [COLORS[3], COLORS[1], COLORS[2], COLORS[0]], "{}", enum_name(ty));
    };
    upload(GL_UNSIGNED_BYTE, cast_slice(&[3_u8, 1, 2, 0]));
    upload(GL_BYTE, cast_slice(&[3_i8, 1, 2, 0]));
    upload(GL_UNSIGNED_SHORT, cast_slice(&[3_u16, 1, 2, 0]));
    upload(GL_SHORT, cast_slice(&[3_i16, 1, 2, 0]));
    upload(GL_UNSIGNED_INT, cast_slice(&[3_u32, 1, 2, 0]));
    upload(GL_INT, cast_slice(&[3_i32, 1, 2, 0]));
    upload(GL_FLOAT, cast_slice(&[3.0_f32, 1.0, 2.0, 0.0]));
    // Of an index, as many bits count as the map has entries for.
    upload(GL_UNSIGNED_BYTE, cast_slice(&[255_u8, 129, 66, 64]));
    upload(GL_BYTE, cast_slice(&[-1_i8, -3, -2, -4]));
}

#[test]
fn indices_are_shifted_and_offset_and_colours_are_left_alone() {
    let _current = context();
    set_maps();
    // Steps of colours, which do not apply.
    glPixelTransferf(GL_RED_SCALE, 0.0);
    glPixelTransferf(GL_GREEN_BIAS, 1.0);
    glPixelTransferi(GL_MAP_COLOR, 1);
    let upload = |indices: &[u8; 2]| {
        let (format, ty) = (GL_COLOR_INDEX, GL_UNSIGNED_BYTE);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 1, 0, format, ty, indices);
        glPushAttrib(GL_PIXEL_MODE_BIT);
        glPixelTransferf(GL_RED_SCALE, 1.0);
        glPixelTransferf(GL_GREEN_BIAS, 0.0);
        glPixelTransferi(GL_MAP_COLOR, 0);
        let found = texels::<2>();
        glPopAttrib();
        found
    };
    assert_eq!(upload(&[0, 2]), [COLORS[0], COLORS[2]]);
    glPixelTransferi(GL_INDEX_SHIFT, 1);
    glPixelTransferi(GL_INDEX_OFFSET, 1);
    assert_eq!(upload(&[0, 1]), [COLORS[1], COLORS[3]]);
    glPixelTransferi(GL_INDEX_SHIFT, -4);
    glPixelTransferi(GL_INDEX_OFFSET, -1);
    assert_eq!(upload(&[0x1F, 0x37]), [COLORS[0], COLORS[2]]);
    // Beyond any word.
    glPixelTransferi(GL_INDEX_SHIFT, i32::MAX);
    glPixelTransferi(GL_INDEX_OFFSET, 2);
    assert_eq!(upload(&[1, 255]), [COLORS[2]; 2]);
}

#[test]
fn bits_are_indices_as_the_pixel_store_has_them() {
    let _current = context();
    set_maps();
    let upload = |width: i32, height: i32, bits: &[u8]| {
        let (format, ty) = (GL_COLOR_INDEX, GL_BITMAP);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, format, ty, bits);
    };
    let of = |indices: [usize; 10]| indices.map(|index| COLORS[index]);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    upload(10, 1, &[0b1010_0001, 0b1000_0000]);
    assert_eq!(texels::<10>(), of([1, 0, 1, 0, 0, 0, 0, 1, 1, 0]));
    glPixelStorei(GL_UNPACK_LSB_FIRST, 1);
    upload(10, 1, &[0b1010_0001, 0b0000_0010]);
    assert_eq!(texels::<10>(), of([1, 0, 0, 0, 0, 1, 0, 1, 0, 1]));
    glPixelStorei(GL_UNPACK_LSB_FIRST, 0);
    // Two rows of five from column 6 of rows of 20, each of them four bytes long.
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 20);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 6);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);
    let rows = [9, 9, 9, 9, 0b10, 0b1010_0000, 9, 9, 0b01, 0b0110_0000];
    upload(5, 2, &rows);
    assert_eq!(texels::<10>(), of([1, 0, 1, 0, 1, 0, 1, 0, 1, 1]));
    upload(5, 2, &rows[..9]);
    assert_eq!(glGetError(), GL_INVALID_OPERATION);
}

#[test]
fn indices_and_bits_are_drawn() {
    let _current = context();
    set_maps();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glWindowPos2i(0, 0);
    let pixels = || {
        let mut out = [0_u8; 16];
        glReadPixels(0, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, &mut out);
        let rgb = |i: usize| [out[4 * i], out[4 * i + 1], out[4 * i + 2]];
        [0, 1, 2, 3].map(rgb)
    };
    let of = |indices: [usize; 4]| indices.map(|i| [COLORS[i][0], COLORS[i][1], COLORS[i][2]]);
    glDrawPixels(2, 2, GL_COLOR_INDEX, GL_UNSIGNED_SHORT, &[3_u16, 2, 1, 0]);
    assert_eq!(pixels(), of([3, 2, 1, 0]));
    glDrawPixels(2, 2, GL_COLOR_INDEX, GL_BITMAP, &[0b0100_0000_u8, 0b1000_0000]);
    assert_eq!(pixels(), of([0, 1, 1, 0]));
    // A list keeps the pixels.
    glNewList(1, GL_COMPILE);
    glDrawPixels(2, 2, GL_COLOR_INDEX, GL_BITMAP, &[0b1100_0000_u8, 0]);
    glEndList();
    glCallList(1);
    assert_eq!(pixels(), of([1, 1, 0, 0]));
    assert_eq!(glGetError(), GL_NO_ERROR);
}

#[test]
fn stencils_of_the_window_are_shifted_looked_up_and_taken_apart_to_bits() {
    let _current = context();
    let stencil = GL_STENCIL_INDEX;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glWindowPos2i(0, 0);
    let read = || {
        let mut out = [9_u8; 4];
        glReadPixels(0, 0, 2, 2, stencil, GL_UNSIGNED_BYTE, &mut out);
        out
    };
    glPixelTransferi(GL_INDEX_SHIFT, 4);
    glPixelTransferi(GL_INDEX_OFFSET, 3);
    glDrawPixels(2, 2, stencil, GL_UNSIGNED_BYTE, &[0_u8, 1, 15, 16]);
    glPixelTransferi(GL_INDEX_SHIFT, 0);
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    // The buffer has eight bits.
    assert_eq!(read(), [3, 19, 243, 3]);
    glPixelMapfv(GL_PIXEL_MAP_S_TO_S, 4, &[7.0_f32, 8.0, 9.0, 10.0]);
    glPixelTransferi(GL_MAP_STENCIL, 1);
    assert_eq!(read(), [10, 10, 10, 10]);
    glDrawPixels(2, 2, stencil, GL_BITMAP, &[0b0100_0000_u8, 0b1000_0000]);
    glPixelTransferi(GL_MAP_STENCIL, 0);
    assert_eq!(read(), [7, 8, 8, 7]);
    // Copies take the same steps.
    glPixelTransferi(GL_INDEX_OFFSET, 1);
    glPixelTransferi(GL_INDEX_SHIFT, 1);
    glCopyPixels(0, 0, 2, 2, stencil);
    glPixelTransferi(GL_INDEX_SHIFT, 0);
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    assert_eq!(read(), [15, 17, 17, 15]);
    let mut bits = [0xFF_u8; 2];
    glDrawPixels(2, 2, stencil, GL_UNSIGNED_BYTE, &[7_u8, 8, 8, 7]);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 1);
    glReadPixels(0, 0, 2, 2, stencil, GL_BITMAP, &mut bits);
    assert_eq!(bits, [0b1101_1111, 0b1011_1111]);
    assert_eq!(glGetError(), GL_NO_ERROR);
}

type Call = fn();

const REFUSED: &[(Call, GLenum)] = &[
    (
        || glReadPixels(0, 0, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, &mut [0_u8]),
        GL_INVALID_OPERATION,
    ),
    (|| glReadPixels(0, 0, 1, 1, GL_RGBA, GL_BITMAP, &mut [0_u8; 4]), GL_INVALID_ENUM),
    (
        || glGetTexImage(GL_TEXTURE_2D, 0, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, &mut [0_u8]),
        GL_INVALID_ENUM,
    ),
    (|| upload(GL_RGBA8, GL_RGBA, GL_BITMAP), GL_INVALID_ENUM),
    (|| upload(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_BITMAP), GL_INVALID_ENUM),
    (|| upload(GL_RGBA8UI, GL_RGBA_INTEGER, GL_BITMAP), GL_INVALID_ENUM),
    (|| upload(GL_RGBA8, GL_COLOR_INDEX, GL_UNSIGNED_BYTE_3_3_2), GL_INVALID_OPERATION),
    (|| upload(GL_RGBA8, GL_STENCIL_INDEX, GL_BITMAP), GL_INVALID_OPERATION),
    (|| upload(GL_RGBA8UI, GL_COLOR_INDEX, GL_UNSIGNED_BYTE), GL_INVALID_OPERATION),
    (|| upload(GL_DEPTH_COMPONENT24, GL_COLOR_INDEX, GL_UNSIGNED_BYTE), GL_INVALID_OPERATION),
    (|| glDrawPixels(1, 1, GL_RGBA, GL_BITMAP, &[0_u8; 4]), GL_INVALID_ENUM),
    (|| glDrawPixels(1, 1, GL_RGBA_INTEGER, GL_FLOAT, &[0.0_f32; 4]), GL_INVALID_OPERATION),
];

fn upload(internal: GLenum, format: GLenum, ty: GLenum) {
    glTexImage2D(GL_TEXTURE_2D, 0, internal, 1, 1, 0, format, ty, &[0_u8; 16]);
}

#[test]
fn refusals() {
    let _current = context();
    for (row, (call, flag)) in REFUSED.iter().enumerate() {
        call();
        assert_eq!(glGetError(), *flag, "row {row}");
    }
}
