//! Mipmaps of every shape whose levels have one grey each, and textures of integers and depths.

use super::error::ProbeError;
use super::session::Session;
use super::target::target_enum;
use super::texture::{compare_enum, filter_enum};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::compare::Compare;
use crate::oracle::pyramid::Shape;
use crate::oracle::target::{Target, Texture};
use gl_api::constants::*;

/// The grey of level `l` is `GREY · l / 255`.
pub const GREY: usize = 16;

fn shape_enum(shape: Shape) -> u32 {
    match shape {
        Shape::D1 => GL_TEXTURE_1D,
        Shape::D2 => GL_TEXTURE_2D,
        Shape::D3 => GL_TEXTURE_3D,
        Shape::Cube => GL_TEXTURE_CUBE_MAP,
        Shape::D1Array => GL_TEXTURE_1D_ARRAY,
        Shape::D2Array => GL_TEXTURE_2D_ARRAY,
    }
}

/// A row of texels of four integers.
#[derive(Clone, Copy, Debug)]
pub struct IntegerRow<'a> {
    /// The internal format.
    pub internal: u32,
    /// Whether they are signed; the bits of texels and border are those of `i32` then.
    pub signed: bool,
    /// R, G, B, A.
    pub texels: &'a [[u32; 4]],
    /// `GL_TEXTURE_BORDER_COLOR`.
    pub border: [u32; 4],
}

impl Session {
    /// Binds a mipmap of this shape, filtered between levels, to unit 0; each level is one grey.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn grey_levels(&self, shape: Shape, size: [usize; 3]) -> Result<(), ProbeError> {
        let target = shape_enum(shape);
        glBindTexture(target, 1);
        for level in 0..shape.levels(size) {
            let [w, h, d] = shape.level(size, level, Variant::CORRECT);
            let texels = vec![(GREY * level) as u8; w * h * d];
            let (internal, format, ty) = (GL_LUMINANCE8, GL_LUMINANCE, GL_UNSIGNED_BYTE);
            match shape {
                Shape::D1 => glTexImage1D(target, level, internal, w, 0, format, ty, &texels[..]),
                Shape::D2 | Shape::D1Array => {
                    glTexImage2D(target, level, internal, w, h, 0, format, ty, &texels[..]);
                }
                Shape::Cube => {
                    for face in 0..6 {
                        let face = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
                        glTexImage2D(face, level, internal, w, h, 0, format, ty, &texels[..]);
                    }
                }
                Shape::D3 | Shape::D2Array => {
                    glTexImage3D(target, level, internal, w, h, d, 0, format, ty, &texels[..]);
                }
            }
        }
        glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        self.check("specifying a mipmap of greys")
    }

    /// Binds a row of integers with a border colour to unit 0, with nearest filters.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn integer_texture(&self, row: &IntegerRow<'_>) -> Result<(), ProbeError> {
        let target = GL_TEXTURE_2D;
        let (width, texels) = (row.texels.len(), row.texels.as_flattened());
        let ty = if row.signed { GL_INT } else { GL_UNSIGNED_INT };
        glBindTexture(target, 1);
        glTexImage2D(target, 0, row.internal, width, 1, 0, GL_RGBA_INTEGER, ty, texels);
        for pname in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
            glTexParameteri(target, pname, GL_NEAREST);
        }
        glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
        if row.signed {
            glTexParameterIiv(target, GL_TEXTURE_BORDER_COLOR, &row.border.map(|c| c as i32));
        } else {
            glTexParameterIuiv(target, GL_TEXTURE_BORDER_COLOR, &row.border);
        }
        self.check("specifying a row of integers")
    }

    /// Binds depths, the first components of an array's texels, to unit 0 to be compared with;
    /// `mode` is `GL_DEPTH_TEXTURE_MODE`.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn depth_array(
        &self,
        texture: &Texture,
        compare: Compare,
        mode: u32,
    ) -> Result<(), ProbeError> {
        let target = target_enum(texture.target);
        let depths: Vec<f32> = texture.texels.texels.iter().map(|texel| texel[0] as f32).collect();
        let [w, h, d] = texture.texels.size;
        let (internal, format, ty) = (GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
        glBindTexture(target, 1);
        match texture.target {
            Target::D1 => glTexImage1D(target, 0, internal, w, 0, format, ty, &depths),
            Target::D2 | Target::Rect | Target::D1Array => {
                glTexImage2D(target, 0, internal, w, h, 0, format, ty, &depths);
            }
            Target::D3 | Target::D2Array => {
                glTexImage3D(target, 0, internal, w, h, d, 0, format, ty, &depths);
            }
        }
        let filter = filter_enum(texture.filter);
        for (pname, value) in [
            (GL_TEXTURE_MIN_FILTER, filter),
            (GL_TEXTURE_MAG_FILTER, filter),
            (GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE),
            (GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE),
            (GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE),
            (GL_TEXTURE_COMPARE_FUNC, compare_enum(compare)),
            (GL_DEPTH_TEXTURE_MODE, mode),
        ] {
            glTexParameteri(target, pname, value);
        }
        self.check("specifying an array of depths")
    }
}
