//! Textures of every target but cubes.

use super::error::ProbeError;
use super::session::Session;
use super::texture::{filter_enum, wrap_enum};
use crate::gl::*;
use crate::oracle::target::{Target, Texture};
use gl_api::constants::*;

pub(super) fn target_enum(target: Target) -> u32 {
    match target {
        Target::D1 => GL_TEXTURE_1D,
        Target::D2 => GL_TEXTURE_2D,
        Target::D3 => GL_TEXTURE_3D,
        Target::Rect => GL_TEXTURE_RECTANGLE,
        Target::D1Array => GL_TEXTURE_1D_ARRAY,
        Target::D2Array => GL_TEXTURE_2D_ARRAY,
    }
}

impl Session {
    /// Binds a texture of floats to unit 0.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn target_texture(&self, texture: &Texture) -> Result<(), ProbeError> {
        let target = target_enum(texture.target);
        let texels: Vec<f32> =
            texture.texels.texels.as_flattened().iter().map(|&c| c as f32).collect();
        let ([w, h, d], border) = (texture.texels.size, texture.border);
        let (internal, format, ty) = (GL_RGBA32F, GL_RGBA, GL_FLOAT);
        glBindTexture(target, 1);
        match texture.target {
            Target::D1 => glTexImage1D(target, 0, internal, w, border, format, ty, &texels),
            Target::D2 | Target::Rect | Target::D1Array => {
                glTexImage2D(target, 0, internal, w, h, border, format, ty, &texels);
            }
            Target::D3 | Target::D2Array => {
                glTexImage3D(target, 0, internal, w, h, d, border, format, ty, &texels);
            }
        }
        let names = [GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R];
        for (name, wrap) in names.into_iter().zip(texture.wrap).take(texture.target.axes()) {
            glTexParameteri(target, name, wrap_enum(wrap));
        }
        let filter = filter_enum(texture.filter);
        glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
        glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
        let color = texture.border_color.map(|c| c as f32);
        glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, &color);
        self.check("specifying a texture of some shape")
    }
}
