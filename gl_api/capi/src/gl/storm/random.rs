//! Random numbers, mostly such as calls accept.

use gl_api::GLenum;
use gl_api::constants::*;
use std::cell::Cell;

#[derive(Debug)]
pub(super) struct Random(pub(super) Cell<u64>);

impl Random {
    pub(super) fn below(&self, limit: u64) -> u64 {
        let mut z = self.0.get().wrapping_add(0x9E37_79B9_7F4A_7C15);
        self.0.set(z);
        z = (z ^ z >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z ^ z >> 31) % limit
    }

    pub(super) fn pick<T: Copy>(&self, from: &[T]) -> T {
        from[self.below(from.len() as u64) as usize]
    }
}

pub(super) const HOSTILE: &[i64] = &[0x7FFF_FFFF, 0x4000_0001, 1 << 24, -1, -0x8000_0000];

pub(super) const FORMATS: &[(GLenum, usize)] = &[
    (GL_RED, 1),
    (GL_ALPHA, 1),
    (GL_LUMINANCE, 1),
    (GL_DEPTH_COMPONENT, 1),
    (GL_STENCIL_INDEX, 1),
    (GL_LUMINANCE_ALPHA, 2),
    (GL_RG, 2),
    (GL_RGB, 3),
    (GL_BGR, 3),
    (GL_RGBA, 4),
    (GL_BGRA, 4),
];
/// Types: bytes of a component, or of the whole pixel.
pub(super) const TYPES: &[(GLenum, usize, bool)] = &[
    (GL_UNSIGNED_BYTE, 1, false),
    (GL_BYTE, 1, false),
    (GL_UNSIGNED_SHORT, 2, false),
    (GL_SHORT, 2, false),
    (GL_UNSIGNED_INT, 4, false),
    (GL_INT, 4, false),
    (GL_FLOAT, 4, false),
    (GL_HALF_FLOAT, 2, false),
    (GL_UNSIGNED_BYTE_3_3_2, 1, true),
    (GL_UNSIGNED_SHORT_5_6_5, 2, true),
    (GL_UNSIGNED_SHORT_4_4_4_4, 2, true),
    (GL_UNSIGNED_INT_8_8_8_8, 4, true),
    (GL_UNSIGNED_INT_2_10_10_10_REV, 4, true),
];
pub(super) const TARGETS: &[GLenum] = &[
    GL_TEXTURE_2D,
    GL_TEXTURE_1D,
    GL_TEXTURE_3D,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_CUBE_MAP_POSITIVE_X,
    GL_TEXTURE_RECTANGLE,
    GL_TEXTURE_ENV,
    GL_TEXTURE_FILTER_CONTROL,
    GL_ARRAY_BUFFER,
    GL_ELEMENT_ARRAY_BUFFER,
    GL_FRAMEBUFFER,
    GL_RENDERBUFFER,
    GL_MAP1_VERTEX_3,
    GL_MAP1_COLOR_4,
    GL_MAP2_VERTEX_3,
    GL_MAP2_TEXTURE_COORD_2,
    GL_VERTEX_PROGRAM_ARB,
    GL_FRAGMENT_PROGRAM_ARB,
    GL_SAMPLES_PASSED,
    GL_POINT_SPRITE,
    GL_UNIFORM_BUFFER,
    GL_TRANSFORM_FEEDBACK_BUFFER,
    GL_FOG_HINT,
    GL_PROXY_TEXTURE_2D,
    GL_TEXTURE_BUFFER,
    GL_TEXTURE_2D_ARRAY,
];
/// Where names of state and parameters lie.
pub(super) const NAMES: &[(GLenum, GLenum)] = &[
    (0x0B00, 0x0DFF),
    (0x1200, 0x1203),
    (0x1600, 0x1603),
    (0x2200, 0x2203),
    (0x2500, 0x2503),
    (0x2800, 0x2803),
    (0x8000, 0x8FFF),
    (0x9000, 0x91FF),
    (0x1000, 0x1005),
    (0x0A00, 0x0A03),
    (0x2300, 0x2305),
];

/// A number for a parameter that is none of a length.
pub(super) fn number(random: &Random, name: &str, ty: &str) -> i64 {
    match (name, ty) {
        ("format", "GLenum") => random.pick(FORMATS).0.into(),
        ("ty" | "type_", "GLenum") => random.pick(TYPES).0.into(),
        ("target", "GLenum") => random.pick(TARGETS).into(),
        ("pname" | "name" | "param" | "value", "GLenum") => {
            let (first, last) = random.pick(NAMES);
            (u64::from(first) + random.below(u64::from(last - first) + 1)) as i64
        }
        (_, "GLenum") => match random.below(3) {
            0 => random.below(10) as i64,
            1 => random.pick(TARGETS).into(),
            _ => random
                .pick(&[
                    GL_LIGHT0,
                    GL_FRONT,
                    GL_COLOR,
                    GL_DEPTH,
                    GL_STENCIL,
                    GL_S,
                    GL_FLOAT,
                    GL_RGBA8,
                    GL_RGBA,
                    GL_PIXEL_MAP_R_TO_R,
                    GL_VERTEX_SHADER,
                    GL_BACK,
                    GL_STATIC_DRAW,
                    GL_UNSIGNED_INT,
                    GL_UNSIGNED_SHORT,
                    GL_UNSIGNED_BYTE,
                    GL_DONT_CARE,
                    GL_COLOR_ATTACHMENT0,
                    GL_TEXTURE,
                    GL_BUFFER,
                    GL_PROGRAM,
                ])
                .into(),
        },
        (_, "GLuint") => random.below(4) as i64,
        ("level" | "border" | "base" | "xoffset" | "yoffset" | "zoffset", _) => {
            random.below(8) as i64 / 7
        }
        ("location", _) => random.below(5) as i64 - 1,
        ("internal_format" | "internalformat", _) => {
            random.pick(&[GL_RGBA8, GL_RGBA, GL_R8, GL_DEPTH_COMPONENT24]).into()
        }
        ("order" | "uorder" | "vorder", _) => random.below(4) as i64,
        ("stride" | "ustride" | "vstride", _) => random.below(9) as i64,
        _ => random.below(5) as i64,
    }
}
