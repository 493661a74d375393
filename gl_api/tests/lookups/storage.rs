//! `ARB_texture_storage`: levels for good, and what is refused.

use super::textures::{Kind, Texels};
use super::{Stage, context, run};
use gl_api::*;

fn parameter(target: GLenum, pname: GLenum) -> i32 {
    let mut value = 0;
    glGetTexParameteriv(target, pname, &mut value);
    value
}

fn width(target: GLenum, level: i32) -> i32 {
    let mut value = 0;
    glGetTexLevelParameteriv(target, level, GL_TEXTURE_WIDTH, &mut value);
    value
}

#[test]
fn every_target_gets_its_levels() {
    let _current = context();
    for (name, (target, levels)) in (1_u32..).zip([
        (GL_TEXTURE_1D, 4),
        (GL_TEXTURE_2D, 4),
        (GL_TEXTURE_3D, 4),
        (GL_TEXTURE_CUBE_MAP, 4),
        (GL_TEXTURE_RECTANGLE, 1),
        (GL_TEXTURE_1D_ARRAY, 4),
        (GL_TEXTURE_2D_ARRAY, 4),
        (GL_TEXTURE_CUBE_MAP_ARRAY, 4),
    ]) {
        glBindTexture(target, name);
        assert_eq!(parameter(target, GL_TEXTURE_IMMUTABLE_FORMAT), 0);
        match target {
            GL_TEXTURE_1D => glTexStorage1D(target, levels, GL_RGBA8, 8),
            GL_TEXTURE_3D | GL_TEXTURE_2D_ARRAY | GL_TEXTURE_CUBE_MAP_ARRAY => {
                glTexStorage3D(target, levels, GL_RGBA8, 8, 8, 6);
            }
            _ => glTexStorage2D(target, levels, GL_RGBA8, 8, 8),
        }
        assert_eq!(glGetError(), GL_NO_ERROR, "{}", enum_name(target));
        assert_eq!(parameter(target, GL_TEXTURE_IMMUTABLE_FORMAT), 1);
        let image =
            if target == GL_TEXTURE_CUBE_MAP { GL_TEXTURE_CUBE_MAP_NEGATIVE_Z } else { target };
        assert_eq!([width(image, 0), width(image, levels - 1)], [8, 8 >> (levels - 1)]);
        glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 8, 8);
        assert_eq!(glGetError(), GL_INVALID_OPERATION);
    }
}

type Call = fn();

/// A 2D texture with storage for good is bound, a 3D one and an array of
/// cubes without, and no 1D one.
const REFUSED: &[(Call, GLenum)] = &[
    (|| glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 4, 4), GL_INVALID_OPERATION),
    (|| glTexStorage1D(GL_TEXTURE_1D, 1, GL_RGBA8, 4), GL_INVALID_OPERATION),
    (|| glTexStorage1D(GL_TEXTURE_2D, 1, GL_RGBA8, 4), GL_INVALID_ENUM),
    (|| glTexStorage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 1, GL_RGBA8, 4, 4), GL_INVALID_ENUM),
    (|| glTexStorage3D(GL_TEXTURE_3D, 1, GL_RGBA, 4, 4, 4), GL_INVALID_ENUM),
    (|| glTexStorage3D(GL_TEXTURE_3D, 1, GL_COMPRESSED_RGB, 4, 4, 4), GL_INVALID_ENUM),
    (|| glTexStorage3D(GL_TEXTURE_3D, 1, 4, 4, 4, 4), GL_INVALID_ENUM),
    (|| glTexStorage3D(GL_TEXTURE_CUBE_MAP_ARRAY, 1, GL_RGBA8, 4, 4, 4), GL_INVALID_VALUE),
    (|| glTexStorage3D(GL_TEXTURE_CUBE_MAP_ARRAY, 1, GL_RGBA8, 4, 2, 6), GL_INVALID_VALUE),
    (|| glTexStorage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 4, 4, 4), GL_INVALID_VALUE),
    (|| glTexStorage3D(GL_TEXTURE_3D, 1, GL_RGBA8, 4, 0, 4), GL_INVALID_VALUE),
    (|| glTexStorage3D(GL_TEXTURE_3D, 4, GL_RGBA8, 4, 4, 4), GL_INVALID_OPERATION),
    (|| glTexStorage3D(GL_TEXTURE_3D, 1, GL_RGBA8, 513, 4, 4), GL_INVALID_VALUE),
    (|| glTexStorage3D(GL_TEXTURE_3D, 1, GL_RGBA32F, 512, 512, 512), GL_OUT_OF_MEMORY),
    (
        || glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL),
        GL_INVALID_OPERATION,
    ),
    (|| glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 2, 2, 0), GL_INVALID_OPERATION),
    (|| glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_IMMUTABLE_FORMAT, 0), GL_INVALID_ENUM),
];

#[test]
fn refusals() {
    let _current = context();
    glBindTexture(GL_TEXTURE_2D, 1);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 4, 4);
    glBindTexture(GL_TEXTURE_3D, 2);
    glBindTexture(GL_TEXTURE_CUBE_MAP_ARRAY, 3);
    for (row, (call, flag)) in REFUSED.iter().enumerate() {
        assert_eq!(glGetError(), GL_NO_ERROR);
        call();
        assert_eq!(glGetError(), *flag, "row {row}");
    }
}

/// Base and largest level are held in what is there, so that a texture of two levels is complete.
#[test]
fn missing_levels_do_not_count() {
    let _current = context();
    let t = GL_TEXTURE_2D;
    let texels = Texels { target: t, size: [8, 8, 1], kind: Kind::Float };
    // `run` binds texture 1; this one takes its place on unit 1.
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(t, 7);
    glTexStorage2D(t, 2, GL_RGBA8, 8, 8);
    glTexSubImage2D(t, 1, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, &[51_u8; 64]);
    glTexParameteri(t, GL_TEXTURE_MAX_LEVEL, 900);
    glTexParameteri(t, GL_TEXTURE_BASE_LEVEL, 500);
    glActiveTexture(GL_TEXTURE0);
    let body = "r = texture2D(s, vec2(0.5));";
    let black = run(Stage::Fragment, "", "sampler2D", body, texels).unwrap();
    assert_eq!(black[3], 0);
    glActiveTexture(GL_TEXTURE1);
    let mut levels = [0; 2];
    glGetTexParameteriv(t, GL_TEXTURE_BASE_LEVEL, &mut levels[..1]);
    // What was given for good bounds it.
    assert_eq!(levels[0], 1);
    glGenerateMipmap(t);
    assert_eq!(glGetError(), GL_NO_ERROR);
    glEnable(t);
    glUseProgram(0);
    glBegin(GL_QUADS);
    for (x, y) in [(-1, -1), (1, -1), (1, 1), (-1, 1)] {
        glVertex2f(x, y);
    }
    glEnd();
    let mut pixel = [0_u8; 4];
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut pixel);
    assert_eq!(pixel, [51; 4]);
}

#[test]
fn proxies_answer() {
    let _current = context();
    for (levels, side, width) in [(1, 8192, 8192), (14, 8192, 8192), (1, 8193, 0)] {
        glTexStorage2D(GL_PROXY_TEXTURE_2D, levels, GL_RGBA8, side, side);
        assert_eq!(glGetError(), GL_NO_ERROR);
        assert_eq!(self::width(GL_PROXY_TEXTURE_2D, 0), width);
    }
}
