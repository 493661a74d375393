//! Mip generation: each level is the box-filtered half of the one before.
//!
//! A texel of the smaller level is the mean of exactly the area it covers: two texels along an
//! even side, three along an odd one, the outer two in part (a side of `2n + 1` becomes `n`; texel
//! `i` covers `i(2n+1)/n` to `(i+1)(2n+1)/n`, so the weights over `2n + 1` are `n - i`, `n`, `i + 1`).
//! A border is filtered along itself, and its corners stay (GL 2.1, section 3.8.8: derived levels
//! have the border width of the base).
//!
//! Weights are integers. Normalized channels are summed as the integers that they are, exactly,
//! and rounded half up; floats and the linear light of sRGB colours are summed in `f64`, first
//! down the slices and rows, then along the row. Compressed texels are averaged as colours and
//! compressed again. Integers have no mean, and neither has stencil.

mod halve;

use crate::format::Format;
use crate::image::{Image, ImageError, Level, Shape};
use crate::lanes::Isa;
use halve::{AxisTaps, Halve};

impl Format {
    /// Whether texels can be averaged: integers and stencil cannot.
    pub const fn has_mean(self) -> bool {
        !self.is_integer() && !self.has_stencil()
    }
}

impl Level {
    /// The next smaller level of an image of this shape: filtered axes are halved, rounded down,
    /// at least 1; layers stay. Every instruction set gives the same.
    ///
    /// # Errors
    /// When texels of this format have no mean, or there is no memory.
    pub fn halved(&self, shape: Shape, isa: Isa) -> Result<Self, ImageError> {
        let format = self.format;
        if !format.has_mean() {
            return Err(ImageError::NoMean { format });
        }
        if format.block().is_some() {
            return self.halved_blocks(shape, isa);
        }
        if self.size().contains(&0) {
            return Self::with_size(format, self.size(), self.border);
        }
        let half = shape.halved(self.size());
        let mut smaller = Self::with_size(format, half, self.border)?;
        let [columns, rows, slices] =
            [0, 1, 2].map(|axis| AxisTaps::all(self.size()[axis], half[axis], self.border[axis]));
        isa.run(Halve { from: self, to: &mut smaller, columns, rows, slices });
        Ok(smaller)
    }

    /// Decodes, halves in linear light, and compresses.
    fn halved_blocks(&self, shape: Shape, isa: Isa) -> Result<Self, ImageError> {
        self.as_format(Format::Rgba32F)?.halved(shape, isa)?.as_format(self.format)
    }

    /// The colours of a level without a border in another format.
    fn as_format(&self, format: Format) -> Result<Self, ImageError> {
        let mut other = Self::with_size(format, self.size(), [0; 3])?;
        other.fill(|at| self.color_at(at).unwrap_or_default());
        Ok(other)
    }
}

impl Image {
    /// Makes the levels above `base` of every face from the base level, to a single texel (along
    /// the axes that are halved) or `max`. A rectangle has no more levels. Every instruction set makes
    /// the same.
    ///
    /// # Errors
    /// When a face has no base level, its texels have no mean, or there is no memory; levels made
    /// until then stay.
    pub fn generate_mipmaps(&mut self, isa: Isa, base: u32, max: u32) -> Result<(), ImageError> {
        (0..self.shape().faces())
            .try_for_each(|face| self.generate_face_mipmaps(isa, face, base, max))
    }

    /// [`Image::generate_mipmaps`] of one face.
    ///
    /// # Errors
    /// As that.
    pub fn generate_face_mipmaps(
        &mut self,
        isa: Isa,
        face: usize,
        base: u32,
        max: u32,
    ) -> Result<(), ImageError> {
        let shape = self.shape();
        let mut level = base as usize;
        let Some(base) = self.level(face, level) else {
            return Err(ImageError::Missing { face, level });
        };
        let format = base.format;
        let is_last = |level: usize, larger: &Level| {
            let same = shape.halved(larger.size()) == larger.size();
            shape == Shape::Rect || same || level as u64 >= u64::from(max)
        };
        if format.block().is_some() {
            // Of colours that were not compressed in between: what is lost does not add up.
            let mut larger = base.as_format(Format::Rgba32F)?;
            while !is_last(level, &larger) {
                larger = larger.halved(shape, isa)?;
                level += 1;
                self.set_level(face, level, larger.as_format(format)?)?;
            }
            return Ok(());
        }
        let mut larger = base;
        while !is_last(level, larger) {
            let smaller = larger.halved(shape, isa)?;
            level += 1;
            self.set_level(face, level, smaller)?;
            let Some(next) = self.level(face, level) else { break };
            larger = next;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
