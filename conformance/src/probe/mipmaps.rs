//! Derived mipmap levels, computed by GL and by GLU, read by `glGetTexImage`.

use super::error::ProbeError;
use super::session::Session;
use crate::gl::*;
use crate::oracle::mipmap::Volume;
use gl_api::constants::*;
use gl_api::glu::{gluBuild1DMipmaps, gluBuild2DMipmaps, gluBuild3DMipmaps};

/// A base level to derive a mipmap from.
#[derive(Clone, Copy, Debug)]
pub struct MipmapRequest<'a> {
    /// `GL_TEXTURE_1D`, `GL_TEXTURE_2D` or `GL_TEXTURE_3D`.
    pub target: u32,
    /// The internal format.
    pub internal: u32,
    /// `GL_LUMINANCE` to `GL_RGBA`: the components that GLU gets. The others are as GL makes them of these.
    pub format: u32,
    /// The base level.
    pub image: &'a Volume,
}

impl Session {
    /// Specifies a level of the bound texture.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn volume_level(
        &self,
        target: u32,
        level: usize,
        internal: u32,
        image: &Volume,
    ) -> Result<(), ProbeError> {
        let texels: Vec<f32> = image.texels.as_flattened().iter().map(|&c| c as f32).collect();
        let [w, h, d] = image.size;
        match target {
            GL_TEXTURE_1D => {
                glTexImage1D(target, level, internal, w, 0, GL_RGBA, GL_FLOAT, &texels);
            }
            GL_TEXTURE_3D | GL_TEXTURE_2D_ARRAY => {
                glTexImage3D(target, level, internal, w, h, d, 0, GL_RGBA, GL_FLOAT, &texels);
            }
            _ => glTexImage2D(target, level, internal, w, h, 0, GL_RGBA, GL_FLOAT, &texels),
        }
        self.check("specifying a level")
    }

    /// The levels that GL derives, half of the requests by `GL_GENERATE_MIPMAP` and half by
    /// `glGenerateMipmap`.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn generate_mipmaps(&self, request: &MipmapRequest<'_>) -> Result<(), ProbeError> {
        let MipmapRequest { target, internal, image, format: _ } = *request;
        glBindTexture(target, 1);
        if image.size[0] % 2 == 0 {
            glTexParameteri(target, GL_GENERATE_MIPMAP, 1);
            self.volume_level(target, 0, internal, image)?;
        } else {
            self.volume_level(target, 0, internal, image)?;
            glGenerateMipmap(target);
        }
        self.check("generating mipmaps")
    }

    /// The levels that GLU derives.
    ///
    /// # Errors
    /// When a call sets the error flag or GLU reports an error.
    pub fn glu_mipmaps(&self, request: &MipmapRequest<'_>) -> Result<(), ProbeError> {
        let MipmapRequest { target, internal, image, format } = *request;
        glBindTexture(target, 1);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        let [w, h, d] = image.size;
        let components: &[usize] = match format {
            GL_LUMINANCE => &[0],
            GL_LUMINANCE_ALPHA => &[0, 3],
            GL_RGB => &[0, 1, 2],
            _ => &[0, 1, 2, 3],
        };
        let of = |texel: &[f64; 4], i: &usize| (texel[*i] * 255.0).round() as u8;
        let texels = image.texels.iter();
        let bytes: Vec<u8> =
            texels.flat_map(|texel| components.iter().map(move |i| of(texel, i))).collect();
        let ty = GL_UNSIGNED_BYTE;
        let code = match target {
            GL_TEXTURE_1D => gluBuild1DMipmaps(target, internal, w, format, ty, &bytes),
            GL_TEXTURE_3D => gluBuild3DMipmaps(target, internal, w, h, d, format, ty, &bytes),
            _ => gluBuild2DMipmaps(target, internal, w, h, format, ty, &bytes),
        };
        self.check("building mipmaps")?;
        match code {
            0 => Ok(()),
            code => Err(ProbeError::Gl {
                after: "building mipmaps",
                code,
                message: "an error of GLU's".to_owned(),
            }),
        }
    }

    /// The texels of a level; NaN if its size is not `size`.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn level_texels(
        &self,
        target: u32,
        level: usize,
        size: [usize; 3],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        let count: usize = size.iter().product();
        let mut found = [1i32; 3];
        let names = [GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH];
        for (found, name) in found.iter_mut().zip(names) {
            glGetTexLevelParameteriv(target, level, name, std::slice::from_mut(found));
        }
        if found.map(|n| n.max(1) as usize) != size {
            return Ok(vec![[f64::NAN; 4]; count]);
        }
        let mut texels = vec![[0.0f32; 4]; count];
        glGetTexImage(target, level, GL_RGBA, GL_FLOAT, texels.as_flattened_mut());
        self.check("reading a level")?;
        Ok(texels.into_iter().map(|texel| texel.map(f64::from)).collect())
    }
}
