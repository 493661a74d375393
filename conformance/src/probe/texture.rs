//! Texture objects with the state that the oracles take.

use super::error::ProbeError;
use super::session::Session;
use crate::gl::*;
use crate::oracle::compare::Compare;
use crate::oracle::lod::{Filter, Filters, Mipmap};
use crate::oracle::sample::Sampler;
use crate::oracle::texture::Level;
use crate::oracle::wrap::Wrap;
use gl_api::constants::*;

/// The internal format of RGBA bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// `GL_RGBA8`.
    Linear,
    /// `GL_SRGB8_ALPHA8`.
    Srgb,
}

/// A row of 16-bit depths with a comparison function.
#[derive(Clone, Copy, Debug)]
pub struct DepthTexture<'a> {
    /// `GL_TEXTURE_COMPARE_FUNC`.
    pub compare: Compare,
    /// `GL_TEXTURE_MIN_FILTER` and `GL_TEXTURE_MAG_FILTER`.
    pub filter: Filter,
    /// The texels.
    pub row: &'a [u16],
}

impl Session {
    /// Binds a mipmapped `GL_RGBA8` image with this state to unit 0.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn texture_2d(&self, image: &[Level], sampler: &Sampler) -> Result<(), ProbeError> {
        self.texture_2d_as(Storage::Linear, image, sampler)
    }

    /// Binds a mipmapped image with this state to unit 0.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn texture_2d_as(
        &self,
        storage: Storage,
        image: &[Level],
        sampler: &Sampler,
    ) -> Result<(), ProbeError> {
        glBindTexture(GL_TEXTURE_2D, 1);
        let format = match storage {
            Storage::Linear => GL_RGBA8,
            Storage::Srgb => GL_SRGB8_ALPHA8,
        };
        for (number, level) in image.iter().enumerate() {
            upload(GL_TEXTURE_2D, number, format, level);
        }
        set_sampler(GL_TEXTURE_2D, sampler);
        self.check("specifying a 2D texture")
    }

    /// Binds a mipmapped image with this state to unit 1.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn second_texture_2d(&self, image: &[Level], sampler: &Sampler) -> Result<(), ProbeError> {
        glActiveTexture(GL_TEXTURE1);
        glBindTexture(GL_TEXTURE_2D, 2);
        for (number, level) in image.iter().enumerate() {
            upload(GL_TEXTURE_2D, number, GL_RGBA8, level);
        }
        set_sampler(GL_TEXTURE_2D, sampler);
        glActiveTexture(GL_TEXTURE0);
        self.check("specifying a second 2D texture")
    }

    /// Binds a cube map of these faces, in GL's order, with this state to unit 0.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn texture_cube(&self, faces: &[Level], sampler: &Sampler) -> Result<(), ProbeError> {
        glBindTexture(GL_TEXTURE_CUBE_MAP, 1);
        for (face, level) in (GL_TEXTURE_CUBE_MAP_POSITIVE_X..).zip(faces) {
            upload(face, 0, GL_RGBA8, level);
        }
        set_sampler(GL_TEXTURE_CUBE_MAP, sampler);
        self.check("specifying a cube map")
    }

    /// Binds an array of cube maps with these faces, those of a cube in GL's order, with this
    /// state to unit 0.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn texture_cube_array(&self, faces: &[Level], sampler: &Sampler) -> Result<(), ProbeError> {
        let target = GL_TEXTURE_CUBE_MAP_ARRAY;
        let texels: Vec<u8> =
            faces.iter().flat_map(|face| face.texels.as_flattened()).copied().collect();
        let (side, depth) = (faces[0].width, faces.len());
        let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
        glBindTexture(target, 1);
        glTexImage3D(target, 0, GL_RGBA8, side, side, depth, 0, format, ty, &texels);
        set_sampler(target, sampler);
        self.check("specifying an array of cube maps")
    }

    /// Enables `GL_TEXTURE_CUBE_MAP_SEAMLESS`.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn seamless_cubes(&self) -> Result<(), ProbeError> {
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        self.check("enabling seamless cube maps")
    }

    /// Sets `GL_TEXTURE_MAX_ANISOTROPY_EXT` of the 2D texture that is bound.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn anisotropy(&self, limit: f32) -> Result<(), ProbeError> {
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, limit);
        self.check("setting anisotropy")
    }

    /// Sets a parameter of the bound 2D texture to several enums.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn parameters(&self, parameters: &[(u32, u32)]) -> Result<(), ProbeError> {
        for &(name, value) in parameters {
            glTexParameteri(GL_TEXTURE_2D, name, value);
        }
        self.check("setting parameters of a texture")
    }

    /// Binds a depth texture with comparison to unit 0.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn depth_texture(&self, texture: &DepthTexture<'_>) -> Result<(), ProbeError> {
        let target = GL_TEXTURE_2D;
        glBindTexture(target, 1);
        glTexImage2D(
            target,
            0,
            GL_DEPTH_COMPONENT16,
            texture.row.len(),
            1,
            0,
            GL_DEPTH_COMPONENT,
            GL_UNSIGNED_SHORT,
            texture.row,
        );
        let filter = filter_enum(texture.filter);
        glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
        glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
        glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
        glTexParameteri(target, GL_TEXTURE_COMPARE_FUNC, compare_enum(texture.compare));
        self.check("specifying a depth texture")
    }
}

fn upload(target: u32, number: usize, format: u32, level: &Level) {
    let Level { width, height, texels } = level;
    let texels = texels.as_flattened();
    glTexImage2D(target, number, format, *width, *height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
}

fn set_sampler(target: u32, sampler: &Sampler) {
    let [s, t] = sampler.at.wrap.map(wrap_enum);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, s);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, t);
    glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, &sampler.at.border.map(|c| c as f32));
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, min_filter_enum(sampler.filters));
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter_enum(sampler.filters.mag));
    glTexParameterf(target, GL_TEXTURE_LOD_BIAS, sampler.lod.object_bias);
    glTexParameterf(target, GL_TEXTURE_MIN_LOD, sampler.lod.min_lod);
    glTexParameterf(target, GL_TEXTURE_MAX_LOD, sampler.lod.max_lod);
    glTexParameteri(target, GL_TEXTURE_BASE_LEVEL, sampler.range.base);
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, sampler.range.last);
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, sampler.lod.unit_bias);
}

/// GL's name of a wrap mode.
pub fn wrap_enum(wrap: Wrap) -> u32 {
    match wrap {
        Wrap::Repeat => GL_REPEAT,
        Wrap::Clamp => GL_CLAMP,
        Wrap::ClampToEdge => GL_CLAMP_TO_EDGE,
        Wrap::ClampToBorder => GL_CLAMP_TO_BORDER,
        Wrap::MirroredRepeat => GL_MIRRORED_REPEAT,
        Wrap::MirrorClamp => GL_MIRROR_CLAMP_EXT,
        Wrap::MirrorClampToEdge => GL_MIRROR_CLAMP_TO_EDGE_EXT,
        Wrap::MirrorClampToBorder => GL_MIRROR_CLAMP_TO_BORDER_EXT,
    }
}

/// GL's name of a filter.
pub fn filter_enum(filter: Filter) -> u32 {
    match filter {
        Filter::Nearest => GL_NEAREST,
        Filter::Linear => GL_LINEAR,
    }
}

/// GL's name of a minification filter.
pub fn min_filter_enum(filters: Filters) -> u32 {
    match (filters.min, filters.mipmap) {
        (filter, Mipmap::None) => filter_enum(filter),
        (Filter::Nearest, Mipmap::Nearest) => GL_NEAREST_MIPMAP_NEAREST,
        (Filter::Linear, Mipmap::Nearest) => GL_LINEAR_MIPMAP_NEAREST,
        (Filter::Nearest, Mipmap::Linear) => GL_NEAREST_MIPMAP_LINEAR,
        (Filter::Linear, Mipmap::Linear) => GL_LINEAR_MIPMAP_LINEAR,
    }
}

/// GL's name of a comparison.
pub fn compare_enum(compare: Compare) -> u32 {
    match compare {
        Compare::Never => GL_NEVER,
        Compare::Less => GL_LESS,
        Compare::Equal => GL_EQUAL,
        Compare::LessEqual => GL_LEQUAL,
        Compare::Greater => GL_GREATER,
        Compare::NotEqual => GL_NOTEQUAL,
        Compare::GreaterEqual => GL_GEQUAL,
        Compare::Always => GL_ALWAYS,
    }
}
