//! Draws of the fixed function: texture environments, the depth test, overdraw.

use super::error::ProbeError;
use super::picture::{CELLS, cell_corners, cell_values};
use super::session::Session;
use super::texture::compare_enum;
use crate::gl::*;
use crate::oracle::compare::Compare;
use crate::oracle::env::{Base, Mode};
use gl_api::constants::*;

/// The inputs of a cell: the primary colour and the RGBA texel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedCell {
    /// `glColor4f`.
    pub color: [f32; 4],
    /// The texel, as given to `glTexImage2D`.
    pub texel: [u8; 4],
}

impl Session {
    /// The colour of each cell under a texture environment, rounded to bytes.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn fixed_cells(
        &self,
        mode: Mode,
        base: Base,
        constant: [f32; 4],
        cells: &[FixedCell],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        let mut values = Vec::with_capacity(cells.len());
        glEnable(GL_TEXTURE_2D);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode_enum(mode));
        glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &constant);
        glBindTexture(GL_TEXTURE_2D, 1);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        for chunk in cells.chunks(CELLS * CELLS) {
            let mut texels: Vec<u8> = chunk.iter().flat_map(|cell| cell.texel).collect();
            texels.resize(CELLS * CELLS * 4, 0);
            glTexImage2D(
                GL_TEXTURE_2D,
                0,
                base_enum(base),
                CELLS,
                CELLS,
                0,
                GL_RGBA,
                GL_UNSIGNED_BYTE,
                &texels,
            );
            self.check("specifying a texture")?;
            glClear(GL_COLOR_BUFFER_BIT);
            glBegin(GL_QUADS);
            for (k, FixedCell { color: [r, g, b, a], .. }) in chunk.iter().enumerate() {
                let centre = |n: usize| (n as f32 + 0.5) / CELLS as f32;
                glColor4f(*r, *g, *b, *a);
                glTexCoord2f(centre(k % CELLS), centre(k / CELLS));
                for [x, y] in cell_corners(k) {
                    glVertex2f(x, y);
                }
            }
            glEnd();
            let picture = self.read_components()?;
            values.extend(cell_values(&picture).take(chunk.len()));
        }
        Ok(values)
    }

    /// For each pair of depths (incoming, stored), 1 in red if the incoming fragment was drawn, else 0.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn depth_tested(
        &self,
        compare: Compare,
        depths: &[[f32; 2]],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        let mut values = Vec::with_capacity(depths.len());
        glEnable(GL_DEPTH_TEST);
        for chunk in depths.chunks(CELLS * CELLS) {
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            glDepthFunc(GL_ALWAYS);
            glColor4f(0, 0, 0, 0);
            flat_quads(chunk.iter().map(|pair| pair[1]));
            glDepthFunc(compare_enum(compare));
            glColor4f(1, 0, 0, 0);
            flat_quads(chunk.iter().map(|pair| pair[0]));
            let picture = self.read_components()?;
            values.extend(cell_values(&picture).take(chunk.len()));
        }
        Ok(values)
    }

    /// The number of triangles that draw each pixel, in red. Corners are in normalized device
    /// coordinates.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn overdraw(&self, corners: &[[f32; 2]]) -> Result<Vec<[f64; 4]>, ProbeError> {
        glClear(GL_COLOR_BUFFER_BIT);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        glColor4f(1.0 / 255.0, 0, 0, 0);
        glBegin(GL_TRIANGLES);
        for &[x, y] in corners {
            glVertex2f(x, y);
        }
        glEnd();
        let picture = self.read()?;
        Ok(picture.into_iter().map(|[times, ..]| [f64::from(times), 0.0, 0.0, 0.0]).collect())
    }
}

/// Draws a quad over each cell, at the depth that the iterator returns.
fn flat_quads(depths: impl Iterator<Item = f32>) {
    glBegin(GL_QUADS);
    for (k, z) in depths.enumerate() {
        for [x, y] in cell_corners(k) {
            glVertex3f(x, y, z);
        }
    }
    glEnd();
}

fn mode_enum(mode: Mode) -> u32 {
    match mode {
        Mode::Replace => GL_REPLACE,
        Mode::Modulate => GL_MODULATE,
        Mode::Decal => GL_DECAL,
        Mode::Blend => GL_BLEND,
        Mode::Add => GL_ADD,
    }
}

fn base_enum(base: Base) -> u32 {
    match base {
        Base::Alpha => GL_ALPHA8,
        Base::Luminance => GL_LUMINANCE8,
        Base::LuminanceAlpha => GL_LUMINANCE8_ALPHA8,
        Base::Red => GL_R8,
        Base::Rg => GL_RG8,
        Base::Intensity => GL_INTENSITY8,
        Base::Rgb => GL_RGB8,
        Base::Rgba => GL_RGBA8,
    }
}
