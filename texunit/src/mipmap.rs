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
//! down the slices and rows, then along the row. Integer, depth and compressed texels have no mean.

mod halve;

use crate::image::{Image, ImageError, Level, Shape};
use crate::lanes::Isa;
use halve::{Cover, Halve};

impl Level {
    /// The next smaller level of a two-dimensional image: half the width and height, rounded
    /// down, at least 1.
    ///
    /// # Errors
    /// When texels of this format have no mean, or there is no memory.
    pub fn halved(&self) -> Result<Self, ImageError> {
        self.halved_as(Shape::D2, Isa::best())
    }

    /// The next smaller level of an image of this shape: filtered axes are halved, rounded down,
    /// at least 1; layers stay. Every instruction set gives the same.
    ///
    /// # Errors
    /// When texels of this format have no mean, or there is no memory.
    pub fn halved_as(&self, shape: Shape, isa: Isa) -> Result<Self, ImageError> {
        let format = self.format;
        if format.is_integer() || format.is_depth() || format.block().is_some() {
            return Err(ImageError::NoMean { format });
        }
        if self.size().contains(&0) {
            return Self::with_size(format, self.size(), self.border);
        }
        let half = shape.halved(self.size());
        let mut smaller = Self::with_size(format, half, self.border)?;
        let [columns, rows, slices] =
            [0, 1, 2].map(|axis| Cover::all(self.size()[axis], half[axis], self.border[axis]));
        isa.run(Halve { from: self, to: &mut smaller, columns, rows, slices });
        Ok(smaller)
    }
}

impl Image {
    /// Makes the levels above `base` of every face from the base level, to a single texel (along
    /// the axes that are halved) or `max`. A rectangle has no more levels.
    ///
    /// # Errors
    /// When a face has no base level, its texels have no mean, or there is no memory; levels made
    /// until then stay.
    pub fn generate_mipmaps(&mut self, base: u32, max: u32) -> Result<(), ImageError> {
        let shape = self.shape();
        let isa = Isa::from_env().unwrap_or(Isa::BASELINE);
        for face in 0..shape.faces() {
            let mut level = base as usize;
            while let Some(larger) = self.level(face, level) {
                let last = shape.halved(larger.size()) == larger.size();
                if last || level as u64 >= u64::from(max) || shape == Shape::Rect {
                    break;
                }
                let smaller = larger.halved_as(shape, isa)?;
                level += 1;
                self.set_level(face, level, smaller)?;
            }
            if self.level(face, base as usize).is_none() {
                return Err(ImageError::Missing { face, level: base as usize });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
