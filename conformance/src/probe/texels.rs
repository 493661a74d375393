//! Rows of texels in any internal format, specified as floats and read by `glGetTexImage`.

use super::error::ProbeError;
use super::session::Session;
use crate::gl::*;
use crate::oracle::format::Sign;
use gl_api::constants::*;

/// The texels of a 2D texture with one row.
#[derive(Clone, Copy, Debug)]
pub struct TexelRow<'a> {
    /// The internal format.
    pub internal: u32,
    /// Whether texels are depths, given as R.
    pub is_depth: bool,
    /// R, G, B, A.
    pub texels: &'a [[f32; 4]],
}

impl Session {
    /// Binds a row of texels to unit 0, with nearest filters.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn texel_row(&self, row: &TexelRow<'_>) -> Result<(), ProbeError> {
        let TexelRow { internal, is_depth, texels } = *row;
        glBindTexture(GL_TEXTURE_2D, 1);
        let width = texels.len();
        if is_depth {
            let depths: Vec<f32> = texels.iter().map(|texel| texel[0]).collect();
            let format = GL_DEPTH_COMPONENT;
            glTexImage2D(GL_TEXTURE_2D, 0, internal, width, 1, 0, format, GL_FLOAT, &depths);
        } else {
            let texels = texels.as_flattened();
            glTexImage2D(GL_TEXTURE_2D, 0, internal, width, 1, 0, GL_RGBA, GL_FLOAT, texels);
        }
        self.read_single_texels();
        self.check("specifying a row of texels")
    }

    /// The unfiltered texels of unit 0.
    fn read_single_texels(&self) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    }

    /// The row as `glGetTexImage` returns it; depth as (D, 0, 0, 1).
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn query_texel_row(&self, row: &TexelRow<'_>) -> Result<Vec<[f64; 4]>, ProbeError> {
        let mut values = vec![[0.0f32; 4]; row.texels.len()];
        if row.is_depth {
            let mut depths = vec![0.0f32; row.texels.len()];
            glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &mut depths);
            for (value, depth) in values.iter_mut().zip(depths) {
                *value = [depth, 0.0, 0.0, 1.0];
            }
        } else {
            glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, values.as_flattened_mut());
        }
        self.check("reading a row of texels")?;
        Ok(values.into_iter().map(|value| value.map(f64::from)).collect())
    }

    /// Binds compressed texels to unit 0, with nearest filters.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn compressed_texture(
        &self,
        internal: u32,
        [width, height]: [usize; 2],
        blocks: &[u8],
    ) -> Result<(), ProbeError> {
        glBindTexture(GL_TEXTURE_2D, 1);
        let bytes = blocks.len();
        glCompressedTexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, bytes, blocks);
        self.read_single_texels();
        self.check("specifying a compressed texture")
    }

    /// Stores a row of integers in an integer format and reads it by `glGetTexImage`.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn integer_row(
        &self,
        internal: u32,
        sign: Sign,
        texels: &[[i64; 4]],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        let ty = match sign {
            Sign::Signed => GL_INT,
            Sign::Unsigned => GL_UNSIGNED_INT,
        };
        // Both types keep the bits.
        let mut words: Vec<u32> = texels.as_flattened().iter().map(|&c| c as u32).collect();
        glBindTexture(GL_TEXTURE_2D, 1);
        let width = texels.len();
        glTexImage2D(GL_TEXTURE_2D, 0, internal, width, 1, 0, GL_RGBA_INTEGER, ty, &words);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA_INTEGER, ty, &mut words);
        self.check("storing integers")?;
        let number = |word: u32| match sign {
            Sign::Signed => f64::from(word as i32),
            Sign::Unsigned => f64::from(word),
        };
        Ok(words.chunks_exact(4).map(|p| [0, 1, 2, 3].map(|i| number(p[i]))).collect())
    }
}
