//! Pixel maps and the other steps of pixel transfer, on the way into textures.

use super::context;
use gl_api::*;

fn through(pixel: [u8; 4]) -> [u8; 4] {
    let t = GL_TEXTURE_1D;
    glTexImage1D(t, 0, GL_RGBA8, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    glPixelTransferi(GL_MAP_COLOR, 0);
    let mut out = [0_u8; 4];
    glGetTexImage(t, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut out);
    assert_eq!(glGetError(), GL_NO_ERROR);
    glPixelTransferi(GL_MAP_COLOR, 1);
    out
}

#[test]
fn colours_are_looked_up_by_the_nearest_entry() {
    let _current = context();
    glPixelTransferi(GL_MAP_COLOR, 1);
    // One entry of 0 each.
    assert_eq!(through([9, 99, 200, 255]), [0; 4]);
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 2, &[1.0_f32, 0.0]);
    glPixelMapusv(GL_PIXEL_MAP_G_TO_G, 3, &[0_u16, 65_535, 0]);
    glPixelMapuiv(GL_PIXEL_MAP_B_TO_B, 5, &[0_u32, 1 << 31, 0, 0, u32::MAX]);
    glPixelMapfv(GL_PIXEL_MAP_A_TO_A, 1, &[7.0_f32]);
    assert_eq!(through([127, 128, 64, 0]), [255, 255, 128, 255]);
    assert_eq!(through([128, 63, 255, 0]), [0, 0, 255, 255]);
    // Scale and bias come first.
    glPixelTransferf(GL_RED_BIAS, 1.0);
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[0_u8; 4]);
    glPixelTransferf(GL_RED_BIAS, 0.0);
    // On the way out nothing is looked up (GL 2.1, section 6.1.4).
    let mut out = [0_u8; 4];
    glGetTexImage(GL_TEXTURE_1D, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut out);
    assert_eq!(out[0], 0);
}

#[test]
fn tables_read_back_in_every_type() {
    let _current = context();
    glPixelMapfv(GL_PIXEL_MAP_A_TO_A, 3, &[0.0_f32, 0.5, 2.0]);
    let (mut floats, mut ints, mut shorts) = ([9.0_f32; 3], [9_u32; 3], [9_u16; 3]);
    glGetPixelMapfv(GL_PIXEL_MAP_A_TO_A, &mut floats);
    glGetPixelMapuiv(GL_PIXEL_MAP_A_TO_A, &mut ints);
    glGetPixelMapusv(GL_PIXEL_MAP_A_TO_A, &mut shorts);
    assert_eq!(floats, [0.0, 0.5, 1.0]);
    assert_eq!(ints, [0, 1 << 31, u32::MAX]);
    assert_eq!(shorts, [0, 32_768, 65_535]);
    glPixelMapuiv(GL_PIXEL_MAP_I_TO_I, 4, &[3_u32, 2, 1, 77]);
    glGetPixelMapuiv(GL_PIXEL_MAP_I_TO_I, &mut [0_u32; 4]);
    for (pname, want) in [
        (GL_PIXEL_MAP_I_TO_I_SIZE, 4),
        (GL_PIXEL_MAP_A_TO_A_SIZE, 3),
        (GL_PIXEL_MAP_R_TO_R_SIZE, 1),
        (GL_MAX_PIXEL_MAP_TABLE, 256),
        (GL_MAP_COLOR, 0),
        (GL_INDEX_SHIFT, 0),
    ] {
        let mut value = -1;
        glGetIntegerv(pname, &mut value);
        assert_eq!(value, want, "{}", enum_name(pname));
    }
    assert_eq!(glGetError(), GL_NO_ERROR);
}

#[test]
fn depths_are_scaled_and_stencils_shifted_and_looked_up() {
    let _current = context();
    let t = GL_TEXTURE_2D;
    let (format, ty) = (GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
    glPixelTransferf(GL_DEPTH_SCALE, 0.5);
    glPixelTransferi(GL_INDEX_SHIFT, 2);
    glPixelTransferi(GL_INDEX_OFFSET, 1);
    glTexImage2D(t, 0, GL_DEPTH24_STENCIL8, 1, 1, 0, format, ty, &[0xFFFF_FE05_u32]);
    glPixelTransferf(GL_DEPTH_SCALE, 1.0);
    glPixelTransferi(GL_INDEX_SHIFT, 0);
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    let mut word = [0_u32];
    glGetTexImage(t, 0, format, ty, &mut word);
    assert_eq!(word, [0x7FFF_FF15]);
    glPixelMapfv(GL_PIXEL_MAP_S_TO_S, 4, &[10.0_f32, 11.0, 12.0, 13.0]);
    glPixelTransferi(GL_MAP_STENCIL, 1);
    glTexImage2D(t, 0, GL_DEPTH24_STENCIL8, 1, 1, 0, format, ty, &word);
    glGetTexImage(t, 0, format, ty, &mut word);
    assert_eq!(word, [0x7FFF_FF0B]);
    assert_eq!(glGetError(), GL_NO_ERROR);
}

type Call = fn();

const REFUSED: &[(Call, GLenum)] = &[
    (|| glPixelMapfv(GL_RGBA, 1, &[0.0_f32]), GL_INVALID_ENUM),
    (|| glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 0, &[0.0_f32]), GL_INVALID_VALUE),
    (|| glPixelMapfv(GL_PIXEL_MAP_R_TO_R, -1, &[0.0_f32]), GL_INVALID_VALUE),
    (|| glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 257, &[0.0_f32; 257]), GL_INVALID_VALUE),
    (|| glPixelMapusv(GL_PIXEL_MAP_I_TO_R, 3, &[0_u16; 3]), GL_INVALID_VALUE),
    (|| glPixelMapuiv(GL_PIXEL_MAP_S_TO_S, 6, &[0_u32; 6]), GL_INVALID_VALUE),
    (|| glPixelMapuiv(GL_PIXEL_MAP_R_TO_R, 6, &[0_u32; 5]), GL_INVALID_OPERATION),
    (|| glGetPixelMapfv(GL_MAP_COLOR, &mut [0.0_f32]), GL_INVALID_ENUM),
    (|| glPixelTransferf(GL_PIXEL_MAP_R_TO_R, 0.0), GL_INVALID_ENUM),
];

#[test]
fn refusals() {
    let _current = context();
    for (row, (call, flag)) in REFUSED.iter().enumerate() {
        call();
        assert_eq!(glGetError(), *flag, "row {row}");
    }
}
