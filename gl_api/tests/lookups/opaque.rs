//! Textures whose alpha is 1 everywhere: from their second draw on it is left out, and it shows again as soon as one
//! texel has another.

use super::program;
use gl_api::*;

/// Pixels across and up: whole blocks, and parts of some.
const SIDE: usize = 44;
/// Texels of the base level.
const TEXELS: usize = 16;
const TRANSPARENT: [u8; 4] = [10, 20, 30, 0];

/// The picture of the texture that is bound: all of it, turned, so that pixels are means of texels.
fn picture(program: u32) -> Vec<[u8; 4]> {
    glUseProgram(program);
    glBegin(GL_QUADS);
    for (x, y, s, t) in [(-1, -1, 0.1, 0.0), (1, -1, 1.0, 0.1), (1, 1, 0.9, 1.0), (-1, 1, 0.0, 0.9)]
    {
        glTexCoord2f(s, t);
        glVertex2f(x, y);
    }
    glEnd();
    let mut bytes = [0_u8; SIDE * SIDE * 4];
    glReadPixels(0, 0, SIDE as i32, SIDE as i32, GL_RGBA, GL_UNSIGNED_BYTE, &mut bytes[..]);
    bytes.as_chunks::<4>().0.to_vec()
}

/// A level of colours whose alpha is 1.
fn opaque(side: usize) -> Vec<u8> {
    (0..side * side).flat_map(|i| [40 * (i % 6) as u8, 30 * (i % 7) as u8, 200, 255]).collect()
}

/// A new texture with two levels of them.
fn texture(internal: GLenum) {
    let mut name = 0;
    glGenTextures(1, &mut name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1);
    for level in 0..2 {
        let side = TEXELS >> level;
        let texels = opaque(side);
        let (side, ty) = (side as i32, GL_UNSIGNED_BYTE);
        glTexImage2D(GL_TEXTURE_2D, level, internal, side, side, 0, GL_RGBA, ty, &texels);
    }
}

/// One texel of a level gets an alpha of 0.
fn put(level: i32) {
    glTexSubImage2D(GL_TEXTURE_2D, level, 3, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &TRANSPARENT);
}

/// What makes some alpha other than 1.
const CHANGES: [(&str, fn()); 6] = [
    ("a texel of the base level", || put(0)),
    ("a texel of the other level", || {
        put(1);
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 0.5);
    }),
    ("a copy of the framebuffer", || {
        glClearColor(1.0, 0.0, 0.0, 0.5);
        glClear(GL_COLOR_BUFFER_BIT);
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 2, 2, 0, 0, 7, 7);
    }),
    ("a framebuffer that it is attached to", || {
        let (mut framebuffer, mut name) = (0, 0);
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &mut name);
        glGenFramebuffers(1, &mut framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        let (target, attachment) = (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0);
        glFramebufferTexture2D(target, attachment, GL_TEXTURE_2D, name as u32, 0);
        glClearColor(0.0, 1.0, 0.0, 0.25);
        glClear(GL_COLOR_BUFFER_BIT);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }),
    ("another image", || {
        let texels = TRANSPARENT.repeat(TEXELS * TEXELS);
        let (side, ty) = (TEXELS as i32, GL_UNSIGNED_BYTE);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, ty, &texels);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    }),
    ("the border", || {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
        glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[1.0_f32, 1.0, 1.0, 0.0]);
    }),
];

#[test]
fn alpha_that_is_1_in_every_texel_is_left_out_until_one_has_another() {
    let side = SIDE as u32;
    let desc = ContextDesc { width: side, height: side, ..ContextDesc::default() };
    let _current = Context::new(desc).expect("a device").make_current();
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    // Texels that are the colour, in the fixed function, and texels that are computed with.
    let computed = program(
        "varying vec2 at; void main() { at = gl_MultiTexCoord0.st; gl_Position = gl_Vertex; }",
        "uniform sampler2D s; varying vec2 at;
         void main() { vec4 c = texture2D(s, at); gl_FragColor = c * c + 0.001 * sin(c.r); }",
    )
    .expect("a program");
    for internal in [GL_RGBA8, GL_SRGB8_ALPHA8] {
        for (change, make) in CHANGES {
            for program in [0, computed] {
                texture(internal);
                let first = picture(program);
                assert!(first.iter().all(|pixel| pixel[3] == 255), "{change}");
                for again in 0..3 {
                    assert!(picture(program) == first, "{change}, once more: {again}");
                }
                make();
                let changed = picture(program);
                assert!(changed.iter().any(|pixel| pixel[3] < 255), "{change} does not show");
                assert!(picture(program) == changed, "{change}, drawn twice");
                assert_eq!(glGetError(), GL_NO_ERROR, "{change}");
            }
        }
    }
}
