//! Textures of every shape, whose texels hold their own column, row, slice (layer, face) and level.

use gl_api::*;

/// What texels are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Bytes: place / 255.
    Float,
    /// `-(place + SHIFT)` in 32 bits.
    Int,
    /// `place + 2^31` in 32 bits.
    Uint,
    /// [`depth`] of the place.
    Depth,
}

/// What is added to integers, so that they need all their bits.
pub const SHIFT: i64 = 0x7000_0000;

/// A texture: target, size of the base level (layers last), what its texels are.
#[derive(Clone, Copy, Debug)]
pub struct Texels {
    pub target: GLenum,
    pub size: [i32; 3],
    pub kind: Kind,
}

/// The depth of a texel: no two places have the same.
pub fn depth([x, y, z, level]: [i32; 4]) -> f32 {
    (1 + x + 16 * y + 256 * z + 4096 * level) as f32 / 65_536.0
}

impl Texels {
    /// The size of a level.
    pub fn level_size(&self, level: i32) -> [i32; 3] {
        let half = |side: i32| (side >> level).max(1);
        let [width, height, depth] = self.size;
        match self.target {
            GL_TEXTURE_3D => [half(width), half(height), half(depth)],
            GL_TEXTURE_1D_ARRAY | GL_TEXTURE_2D_ARRAY | GL_TEXTURE_CUBE_MAP_ARRAY => {
                [half(width), half(height), depth]
            }
            _ => [half(width), half(height), 1],
        }
    }

    fn pixels(&self, level: i32, slices: std::ops::Range<i32>) -> Vec<u8> {
        let [width, height, _] = self.level_size(level);
        let mut bytes = Vec::new();
        for z in slices {
            for y in 0..height {
                for x in 0..width {
                    let place = [x, y, z, level];
                    match self.kind {
                        Kind::Float => bytes.extend(place.map(|c| c as u8)),
                        Kind::Int => bytes.extend(
                            place.iter().flat_map(|&c| (-(c + SHIFT as i32)).to_ne_bytes()),
                        ),
                        Kind::Uint => bytes.extend(
                            place.iter().flat_map(|&c| (c as u32 + (1 << 31)).to_ne_bytes()),
                        ),
                        Kind::Depth => bytes.extend(depth(place).to_ne_bytes()),
                    }
                }
            }
        }
        bytes
    }

    /// Makes it anew as texture 1 of unit 0, all levels there, with nearest filters.
    pub fn bind(self) {
        let Self { target, size, kind } = self;
        glDeleteTextures(1, &1);
        glBindTexture(target, 1);
        let filter =
            if target == GL_TEXTURE_RECTANGLE { GL_NEAREST } else { GL_NEAREST_MIPMAP_NEAREST };
        glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
        glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        for wrap in [GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R] {
            glTexParameteri(target, wrap, GL_CLAMP_TO_EDGE);
        }
        let (internal, format, ty) = match kind {
            Kind::Float => (GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE),
            Kind::Int => (GL_RGBA32I, GL_RGBA_INTEGER, GL_INT),
            Kind::Uint => (GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT),
            Kind::Depth => (GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT),
        };
        if kind == Kind::Depth {
            glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
            glTexParameteri(target, GL_TEXTURE_COMPARE_FUNC, GL_EQUAL);
        }
        let sides: &[i32] = if target == GL_TEXTURE_3D { &size } else { &size[..2] };
        let largest = sides.iter().copied().max().unwrap_or(1);
        let levels = if target == GL_TEXTURE_RECTANGLE { 1 } else { largest.ilog2() as i32 + 1 };
        for level in 0..levels {
            let [width, height, depth] = self.level_size(level);
            match target {
                GL_TEXTURE_1D => {
                    let pixels = self.pixels(level, 0..1);
                    glTexImage1D(target, level, internal, width, 0, format, ty, &pixels);
                }
                GL_TEXTURE_3D | GL_TEXTURE_2D_ARRAY | GL_TEXTURE_CUBE_MAP_ARRAY => {
                    let pixels = self.pixels(level, 0..depth);
                    let border = 0;
                    glTexImage3D(
                        target, level, internal, width, height, depth, border, format, ty, &pixels,
                    );
                }
                GL_TEXTURE_1D_ARRAY => {
                    let pixels = self.pixels(level, 0..depth);
                    glTexImage2D(target, level, internal, width, depth, 0, format, ty, &pixels);
                }
                GL_TEXTURE_CUBE_MAP => {
                    for face in 0..6 {
                        let pixels = self.pixels(level, face..face + 1);
                        let face = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face as u32;
                        glTexImage2D(face, level, internal, width, height, 0, format, ty, &pixels);
                    }
                }
                _ => {
                    let pixels = self.pixels(level, 0..1);
                    glTexImage2D(target, level, internal, width, height, 0, format, ty, &pixels);
                }
            }
        }
        assert_eq!(glGetError(), GL_NO_ERROR, "{self:?}");
    }
}
