//! Mipmaps of every shape: `glGenerateMipmap`, `GL_GENERATE_MIPMAP` and GLU's, against the mean over
//! each texel's area in `f64`.

use super::{context, program};
use gl_api::glu::{gluBuild3DMipmapLevels, gluBuild3DMipmaps};
use gl_api::*;

/// Target, size of the base level (layers last).
const SHAPES: &[(GLenum, [usize; 3])] = &[
    (GL_TEXTURE_1D, [13, 1, 1]),
    (GL_TEXTURE_2D, [7, 5, 1]),
    (GL_TEXTURE_2D, [1, 6, 1]),
    (GL_TEXTURE_3D, [5, 3, 6]),
    (GL_TEXTURE_3D, [1, 1, 7]),
    (GL_TEXTURE_CUBE_MAP, [5, 5, 1]),
    (GL_TEXTURE_CUBE_MAP, [6, 6, 1]),
    (GL_TEXTURE_CUBE_MAP, [7, 7, 1]),
    (GL_TEXTURE_CUBE_MAP, [12, 12, 1]),
    (GL_TEXTURE_CUBE_MAP, [37, 37, 1]),
    (GL_TEXTURE_1D_ARRAY, [9, 1, 3]),
    (GL_TEXTURE_2D_ARRAY, [6, 7, 3]),
    (GL_TEXTURE_CUBE_MAP_ARRAY, [5, 5, 12]),
];

fn axes(target: GLenum) -> usize {
    match target {
        GL_TEXTURE_1D | GL_TEXTURE_1D_ARRAY => 1,
        GL_TEXTURE_3D => 3,
        _ => 2,
    }
}

fn faces(target: GLenum) -> std::ops::Range<GLenum> {
    match target {
        GL_TEXTURE_CUBE_MAP => GL_TEXTURE_CUBE_MAP_POSITIVE_X..GL_TEXTURE_CUBE_MAP_POSITIVE_X + 6,
        _ => target..target + 1,
    }
}

fn halved(target: GLenum, mut size: [usize; 3]) -> [usize; 3] {
    for side in &mut size[..axes(target)] {
        *side = (*side / 2).max(1);
    }
    size
}

fn upload(image: GLenum, [w, h, d]: [usize; 3], bytes: &[u8]) {
    let (internal, format, ty) = (GL_LUMINANCE8, GL_LUMINANCE, GL_UNSIGNED_BYTE);
    match image {
        GL_TEXTURE_1D => glTexImage1D(image, 0, internal, w as i32, 0, format, ty, bytes),
        GL_TEXTURE_3D | GL_TEXTURE_2D_ARRAY | GL_TEXTURE_CUBE_MAP_ARRAY => {
            let (w, h, d) = (w as i32, h as i32, d as i32);
            glTexImage3D(image, 0, internal, w, h, d, 0, format, ty, bytes);
        }
        _ => {
            let h = if image == GL_TEXTURE_1D_ARRAY { d } else { h };
            glTexImage2D(image, 0, internal, w as i32, h as i32, 0, format, ty, bytes);
        }
    }
}

fn read(image: GLenum, level: i32, size: [usize; 3]) -> Vec<u8> {
    let mut bytes = vec![0; size.iter().product()];
    glGetTexImage(image, level, GL_LUMINANCE, GL_UNSIGNED_BYTE, &mut bytes);
    assert_eq!(glGetError(), GL_NO_ERROR);
    bytes
}

/// How much of texel `x` of `size` lies in texel `i` of `half`.
fn overlap(size: usize, half: usize, i: usize, x: usize) -> f64 {
    let scale = size as f64 / half as f64;
    let (low, high) = (i as f64 * scale, (i + 1) as f64 * scale);
    (high.min(x as f64 + 1.0) - low.max(x as f64)).max(0.0)
}

/// The mean over the area of each texel, unrounded.
fn mean(from: &[u8], size: [usize; 3], half: [usize; 3]) -> Vec<f64> {
    let mut out = Vec::new();
    for k in 0..half[2] {
        for j in 0..half[1] {
            for i in 0..half[0] {
                let (mut sum, mut total) = (0.0, 0.0);
                for (at, &value) in from.iter().enumerate() {
                    let [x, y, z] = [at % size[0], at / size[0] % size[1], at / size[0] / size[1]];
                    let weight = overlap(size[0], half[0], i, x)
                        * overlap(size[1], half[1], j, y)
                        * overlap(size[2], half[2], k, z);
                    sum += weight * f64::from(value);
                    total += weight;
                }
                out.push(sum / total);
            }
        }
    }
    out
}

fn noise(count: usize, seed: u32) -> Vec<u8> {
    let mix = |i: usize| ((i as u32 + seed).wrapping_mul(0x9E37_79B9) >> 23) as u8;
    (0..count).map(mix).collect()
}

#[test]
fn every_shape_is_halved_by_area() {
    let _current = context();
    for (name, &(target, size)) in (1_u32..).zip(SHAPES) {
        for automatic in [false, true] {
            glBindTexture(target, 2 * name + u32::from(automatic));
            glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
            glPixelStorei(GL_PACK_ALIGNMENT, 1);
            glTexParameteri(target, GL_GENERATE_MIPMAP, automatic);
            for image in faces(target) {
                upload(image, size, &noise(size.iter().product(), image));
            }
            if !automatic {
                glGenerateMipmap(target);
            }
            for image in faces(target) {
                let (mut larger, mut bytes) = (size, noise(size.iter().product(), image));
                for level in 1.. {
                    let half = halved(target, larger);
                    if half == larger {
                        break;
                    }
                    let got = read(image, level, half);
                    for (got, want) in got.iter().zip(mean(&bytes, larger, half)) {
                        let off = (f64::from(*got) - want).abs();
                        assert!(off <= 0.5 + 1e-9, "{target:#x} {level}: {got} {want}");
                    }
                    (larger, bytes) = (half, got);
                }
            }
        }
    }
}

#[test]
fn depth_srgb_and_blocks_have_mipmaps_integers_and_stencil_have_none() {
    let _current = context();
    let t = GL_TEXTURE_2D;
    glBindTexture(t, 1);
    let (depth, short) = (GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT);
    glTexImage2D(t, 0, GL_DEPTH_COMPONENT16, 2, 2, 0, depth, short, &[0_u16, 1000, 3000, 61]);
    glGenerateMipmap(t);
    let mut texel = [0_u16; 2];
    glGetTexImage(t, 1, depth, short, &mut texel);
    assert_eq!(texel[0], 1015);
    // Half the light of white is 188 in sRGB.
    let (l, byte) = (GL_LUMINANCE, GL_UNSIGNED_BYTE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(t, 0, GL_SLUMINANCE8, 2, 1, 0, l, byte, &[0_u8, 255]);
    glGenerateMipmap(t);
    let mut texel = [0_u8; 4];
    glGetTexImage(t, 1, l, byte, &mut texel);
    assert_eq!(texel[0], 188);
    let red = [[255_u8, 0, 0, 255]; 64];
    let dxt = GL_COMPRESSED_RGBA_S3TC_DXT1_EXT;
    glTexImage2D(t, 0, dxt, 8, 8, 0, GL_RGBA, byte, bytemuck(&red));
    glGenerateMipmap(t);
    assert_eq!(glGetError(), GL_NO_ERROR);
    let (mut is_compressed, mut texel) = (0, [0_u8; 4]);
    glGetTexLevelParameteriv(t, 3, GL_TEXTURE_COMPRESSED, &mut is_compressed);
    glGetTexImage(t, 3, GL_RGBA, byte, &mut texel);
    assert_eq!((is_compressed, texel), (1, red[0]));
    for (internal, format, ty) in [
        (GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE),
        (GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8),
    ] {
        glTexImage2D(t, 0, internal, 2, 2, 0, format, ty, &[0_u32; 4]);
        assert_eq!(glGetError(), GL_NO_ERROR);
        glGenerateMipmap(t);
        assert_eq!(glGetError(), GL_INVALID_OPERATION);
        glTexParameteri(t, GL_GENERATE_MIPMAP, 1);
        glTexImage2D(t, 0, internal, 2, 2, 0, format, ty, &[0_u32; 4]);
        assert_eq!(glGetError(), GL_NO_ERROR);
        glTexParameteri(t, GL_GENERATE_MIPMAP, 0);
    }
}

fn bytemuck(texels: &[[u8; 4]]) -> &[u8] {
    texels.as_flattened()
}

#[test]
fn glu_builds_volumes() {
    let _current = context();
    let t = GL_TEXTURE_3D;
    glBindTexture(t, 1);
    let (l, byte) = (GL_LUMINANCE, GL_UNSIGNED_BYTE);
    // 3×2×4 is scaled to 4×2×4; slices lie 5 rows apart, after one that is skipped.
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 5);
    glPixelStorei(GL_UNPACK_SKIP_IMAGES, 1);
    let mut bytes = vec![255_u8; 15];
    for z in 0..4 {
        bytes.extend([20 * z; 6]);
        bytes.extend([255; 9]);
    }
    assert_eq!(gluBuild3DMipmaps(t, GL_LUMINANCE8, 3, 2, 4, l, byte, &bytes), 0);
    assert_eq!(glGetError(), GL_NO_ERROR);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    assert_eq!(read(t, 0, [4, 2, 4])[..9], [0, 0, 0, 0, 0, 0, 0, 0, 20]);
    assert_eq!(read(t, 1, [2, 1, 2]), [10, 10, 50, 50]);
    assert_eq!(read(t, 2, [1, 1, 1]), [30]);
    let mut height = 0;
    glGetIntegerv(GL_UNPACK_IMAGE_HEIGHT, &mut height);
    assert_eq!(height, 5);
    let levels = gluBuild3DMipmapLevels(t, GL_LUMINANCE8, 4, 2, 4, l, byte, 1, 0, 2, &bytes);
    assert_eq!(levels, glu::GLU_INVALID_VALUE);
    assert_eq!(gluBuild3DMipmaps(t, GL_LUMINANCE8, 0, 2, 4, l, byte, &bytes), 100_901);
}

/// The axes of s, t and the middle of each face, in the order of GL's names (GL 2.1, table 3.19).
const CUBE: [[[f32; 3]; 3]; 6] = [
    [[0.0, 0.0, -1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]],
    [[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [-1.0, 0.0, 0.0]],
    [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]],
    [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, -1.0, 0.0]],
    [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]],
    [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]],
];

/// Each texel of each level of cube maps that are no power of two, as a lookup at its centre finds it, is the mean of
/// the texels that it covers in the level above.
#[test]
fn lookups_find_the_levels_of_cube_maps_of_any_size() {
    const ROOM: i32 = 16;
    let _current = context();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let fragment = "#version 130
        uniform samplerCube s; uniform mat3 face; uniform float side, level;
        void main() {
            vec3 direction = face * vec3(2.0 * gl_FragCoord.xy / side - 1.0, 1.0);
            gl_FragColor = textureLod(s, direction, level);
        }";
    let program = program("void main() { gl_Position = gl_Vertex; }", fragment).unwrap();
    glUseProgram(program);
    let uniform = |name: &str| glGetUniformLocation(program, name);
    glBindRenderbuffer(GL_RENDERBUFFER, 1);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, ROOM, ROOM);
    glBindFramebuffer(GL_FRAMEBUFFER, 1);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 1);
    glViewport(0, 0, ROOM, ROOM);
    let t = GL_TEXTURE_CUBE_MAP;
    for size in [3, 5, 6, 7, 12, 13] {
        glDeleteTextures(1, &1);
        glBindTexture(t, 1);
        glTexParameteri(t, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
        glTexParameteri(t, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        for image in faces(t) {
            upload(image, [size, size, 1], &noise(size * size, image));
        }
        glGenerateMipmap(t);
        for (image, axes) in faces(t).zip(CUBE) {
            glUniformMatrix3fv(uniform("face"), 1, false, axes.as_flattened());
            let (mut above, mut level) = (([size, size, 1], noise(size * size, image)), 1);
            while above.0[0] > 1 {
                let side = above.0[0] / 2;
                let half = [side, side, 1];
                glUniform1f(uniform("side"), side as f32);
                glUniform1f(uniform("level"), level as f32);
                glRectf(-1, -1, 1, 1);
                let mut pixels = vec![[0_u8; 4]; side * side];
                let (w, ty) = (side as i32, GL_UNSIGNED_BYTE);
                glReadPixels(0, 0, w, w, GL_RGBA, ty, pixels.as_flattened_mut());
                let found: Vec<u8> = pixels.iter().map(|pixel| pixel[0]).collect();
                for (at, want) in mean(&above.1, above.0, half).into_iter().enumerate() {
                    let off = (f64::from(found[at]) - want).abs();
                    assert!(off <= 0.5 + 1e-9, "{size}, level {level} of {image:#x}: {at}");
                }
                (above, level) = ((half, found), level + 1);
            }
        }
        assert_eq!(glGetError(), GL_NO_ERROR);
    }
}
