//! Completeness: whether an image can be sampled with a sampler (GL 2.1, section 3.8.10).

use super::{Image, Level, Shape};
use crate::format::Format;
use crate::sampler::{DepthFilter, Filter, Mipmap, Sampler};
use std::sync::Arc;
use thiserror::Error;

/// The levels a complete image is sampled from, both included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Levels {
    /// The level of the largest texels that are read.
    pub base: u32,
    /// The last of the pyramid, or `base` without mipmaps.
    pub last: u32,
}

/// Why an image cannot be sampled. The message names what to do about it.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Incomplete {
    /// The base level was never given.
    #[error(
        "level {level}{} has no image: give it one with {} (GL_TEXTURE_BASE_LEVEL is {level})",
        face_name(*.shape, *.face), .shape.image_call()
    )]
    NoBase {
        /// The image's shape.
        shape: Shape,
        /// Which face.
        face: usize,
        /// The base level.
        level: u32,
    },
    /// The base level has a side of 0.
    #[error("level {level}{} has a size of 0: give it an image with {}",
        face_name(*.shape, *.face), .shape.image_call())]
    Empty {
        /// The image's shape.
        shape: Shape,
        /// Which face.
        face: usize,
        /// The base level.
        level: u32,
    },
    /// `base_level` is above `max_level` and the filter needs mipmaps.
    #[error(
        "GL_TEXTURE_BASE_LEVEL {base} is above GL_TEXTURE_MAX_LEVEL {max}, so there is no level \
         for the minification filter {filter}"
    )]
    NoLevels {
        /// The base level.
        base: u32,
        /// The largest level.
        max: u32,
        /// GL's name of the minification filter.
        filter: &'static str,
    },
    /// A level of the pyramid was never given.
    #[error(
        "level {level}{} is missing: the minification filter {filter} needs levels {base} to \
         {last}; call glGenerateMipmap, gluBuild2DMipmaps, or set GL_TEXTURE_MIN_FILTER to \
         GL_LINEAR",
        face_name(*.shape, *.face)
    )]
    Missing {
        /// The image's shape.
        shape: Shape,
        /// Which face.
        face: usize,
        /// Which level.
        level: u32,
        /// GL's name of the minification filter.
        filter: &'static str,
        /// First level needed.
        base: u32,
        /// Last level needed.
        last: u32,
    },
    /// A level's size does not follow from the base level's.
    #[error(
        "level {level}{} is {}, but must be {}: each level has half the sides of the one before, \
         rounded down, at least 1{}",
        face_name(*.shape, *.face), sides(*.shape, .got), sides(*.shape, .expected),
        layers_stay(*.shape)
    )]
    WrongSize {
        /// The image's shape.
        shape: Shape,
        /// Which face.
        face: usize,
        /// Which level.
        level: u32,
        /// Its width, height and depth (layers).
        got: [u32; 3],
        /// Those that were needed.
        expected: [u32; 3],
    },
    /// Two levels or faces of which one has a border.
    #[error(
        "level {level}{} and the base level differ in their border: give all levels and faces the \
         same border",
        face_name(*.shape, *.face)
    )]
    MixedBorders {
        /// The image's shape.
        shape: Shape,
        /// Which face.
        face: usize,
        /// Which level.
        level: u32,
    },
    /// Integers, and a filter that takes their mean (EXT_texture_integer, section 3.8.10).
    #[error(
        "its texels are integers, which cannot be filtered: set \
         GL_TEXTURE_MAG_FILTER (is {mag}) to GL_NEAREST and GL_TEXTURE_MIN_FILTER (is {min}) to \
         GL_NEAREST or GL_NEAREST_MIPMAP_NEAREST"
    )]
    FilteredIntegers {
        /// The base level's format.
        format: Format,
        /// GL's name of the magnification filter.
        mag: &'static str,
        /// GL's name of the minification filter.
        min: &'static str,
    },
    /// Depths that are not compared, and a filter that takes their mean.
    #[error(
        "its texels are depths, which are not filtered unless they are compared: set \
         GL_TEXTURE_COMPARE_MODE to GL_COMPARE_REF_TO_TEXTURE, or GL_TEXTURE_MAG_FILTER (is {mag}) to \
         GL_NEAREST and GL_TEXTURE_MIN_FILTER (is {min}) to GL_NEAREST or GL_NEAREST_MIPMAP_NEAREST"
    )]
    FilteredDepths {
        /// GL's name of the magnification filter.
        mag: &'static str,
        /// GL's name of the minification filter.
        min: &'static str,
    },
    /// Two levels or faces are stored differently.
    #[error(
        "level {level}{} and the base level differ in their format: give all levels and faces the \
         same internal format",
        face_name(*.shape, *.face)
    )]
    MixedFormats {
        /// The image's shape.
        shape: Shape,
        /// Which face.
        face: usize,
        /// Which level.
        level: u32,
        /// Its format.
        got: Format,
        /// The base level's format.
        expected: Format,
    },
    /// A cube face that is not a square.
    #[error("level {level}{} is {}×{}, but the faces of a cube map must be square",
        face_name(Shape::Cube, *.face), .got[0], .got[1])]
    NotSquare {
        /// Which face.
        face: usize,
        /// The base level.
        level: u32,
        /// Its width and height.
        got: [u32; 2],
    },
    /// Cube faces of different sizes.
    #[error(
        "level {level}{} is {}×{}, but the face +X is {}×{}: all six faces of a cube map must \
         have the same size",
        face_name(Shape::Cube, *.face), .got[0], .got[1], .expected[0], .expected[1]
    )]
    UnequalFaces {
        /// Which face.
        face: usize,
        /// The base level.
        level: u32,
        /// Its width and height.
        got: [u32; 2],
        /// Those of the first face.
        expected: [u32; 2],
    },
}

fn face_name(shape: Shape, face: usize) -> &'static str {
    const NAMES: [&str; 6] = [
        " of the face +X",
        " of the face -X",
        " of the face +Y",
        " of the face -Y",
        " of the face +Z",
        " of the face -Z",
    ];
    match shape {
        Shape::D1
        | Shape::D2
        | Shape::D3
        | Shape::Rect
        | Shape::D1Array
        | Shape::D2Array
        | Shape::CubeArray => "",
        Shape::Cube => NAMES.get(face).copied().unwrap_or(""),
    }
}

impl Shape {
    /// The call that gives images of this shape.
    pub fn image_call(self) -> &'static str {
        match self {
            Self::D1 => "glTexImage1D",
            Self::D2 | Self::Rect | Self::Cube | Self::D1Array => "glTexImage2D",
            Self::D3 | Self::D2Array | Self::CubeArray => "glTexImage3D",
        }
    }
}

/// Width, height and depth or layers, as far as the shape has them.
fn sides(shape: Shape, [width, height, depth]: &[u32; 3]) -> String {
    match shape {
        Shape::D1 => width.to_string(),
        Shape::D2 | Shape::Rect | Shape::Cube => format!("{width}×{height}"),
        Shape::D3 => format!("{width}×{height}×{depth}"),
        Shape::D1Array => format!("{width} in {depth} layers"),
        Shape::D2Array | Shape::CubeArray => format!("{width}×{height} in {depth} layers"),
    }
}

fn layers_stay(shape: Shape) -> &'static str {
    match shape {
        Shape::D1 | Shape::D2 | Shape::D3 | Shape::Rect | Shape::Cube => "",
        Shape::D1Array | Shape::D2Array | Shape::CubeArray => "; all levels have as many layers",
    }
}

/// GL's name of the sampler's magnification filter.
fn mag_name(sampler: &Sampler) -> &'static str {
    match sampler.mag {
        Filter::Nearest => "GL_NEAREST",
        Filter::Linear => "GL_LINEAR",
    }
}

/// GL's name of the sampler's minification filter.
fn filter_name(sampler: &Sampler) -> &'static str {
    match (sampler.min, sampler.mipmap) {
        (Filter::Nearest, Mipmap::None) => "GL_NEAREST",
        (Filter::Linear, Mipmap::None) => "GL_LINEAR",
        (Filter::Nearest, Mipmap::Nearest) => "GL_NEAREST_MIPMAP_NEAREST",
        (Filter::Linear, Mipmap::Nearest) => "GL_LINEAR_MIPMAP_NEAREST",
        (Filter::Nearest, Mipmap::Linear) => "GL_NEAREST_MIPMAP_LINEAR",
        (Filter::Linear, Mipmap::Linear) => "GL_LINEAR_MIPMAP_LINEAR",
    }
}

impl Image {
    /// The levels this sampler reads, if all of them are there and fit each other (GL 2.1,
    /// section 3.8.10).
    ///
    /// # Errors
    /// Why they do not.
    pub fn completeness(&self, sampler: &Sampler) -> Result<Levels, Incomplete> {
        let base = sampler.base_level;
        let first = self.base(0, base)?;
        if self.shape == Shape::Cube {
            self.check_faces(base, first)?;
        }
        let filter = filter_name(sampler);
        let means = [sampler.min, sampler.mag].contains(&Filter::Linear)
            || sampler.mipmap == Mipmap::Linear;
        if first.format.is_integer() && means {
            let (format, mag, min) = (first.format, mag_name(sampler), filter);
            return Err(Incomplete::FilteredIntegers { format, mag, min });
        }
        if first.format.is_depth() && means && sampler.depth_filter == DepthFilter::Nearest {
            return Err(Incomplete::FilteredDepths { mag: mag_name(sampler), min: filter });
        }
        if sampler.mipmap == Mipmap::None {
            return Ok(Levels { base, last: base });
        }
        if base > sampler.max_level {
            return Err(Incomplete::NoLevels { base, max: sampler.max_level, filter });
        }
        let shape = self.shape;
        let largest = first.size()[..shape.axes()].iter().fold(1, |most, side| most.max(*side));
        let last = (base + largest.ilog2()).min(sampler.max_level);
        for face in 0..shape.faces() {
            let mut expected = first.size();
            for level in base + 1..=last {
                expected = shape.halved(expected);
                let Some(got) = self.level(face, level as usize) else {
                    return Err(Incomplete::Missing { shape, face, level, filter, base, last });
                };
                let size = got.size();
                if size != expected {
                    return Err(Incomplete::WrongSize { shape, face, level, got: size, expected });
                }
                self.check_kind(face, level, got, first)?;
            }
        }
        Ok(Levels { base, last })
    }

    fn base(&self, face: usize, level: u32) -> Result<&Arc<Level>, Incomplete> {
        let shape = self.shape;
        let found = self.level(face, level as usize);
        let found = found.ok_or(Incomplete::NoBase { shape, face, level })?;
        if found.size().contains(&0) {
            return Err(Incomplete::Empty { shape, face, level });
        }
        Ok(found)
    }

    /// Cube completeness: six squares of one size and format.
    fn check_faces(&self, level: u32, first: &Level) -> Result<(), Incomplete> {
        for face in 0..self.shape.faces() {
            let found = self.base(face, level)?;
            let got = [found.width, found.height];
            let expected = [first.width, first.height];
            if got[0] != got[1] {
                return Err(Incomplete::NotSquare { face, level, got });
            }
            if got != expected {
                return Err(Incomplete::UnequalFaces { face, level, got, expected });
            }
            self.check_kind(face, level, found, first)?;
        }
        Ok(())
    }

    /// Levels and faces have the base level's format and border.
    fn check_kind(
        &self,
        face: usize,
        level: u32,
        got: &Level,
        first: &Level,
    ) -> Result<(), Incomplete> {
        let shape = self.shape;
        if got.format != first.format {
            let (got, expected) = (got.format, first.format);
            return Err(Incomplete::MixedFormats { shape, face, level, got, expected });
        }
        if got.border != first.border {
            return Err(Incomplete::MixedBorders { shape, face, level });
        }
        Ok(())
    }
}
