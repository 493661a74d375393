//! Texel storage: faces and levels, shared by reference, copied when written.

mod complete;

pub use complete::{Incomplete, Levels};

use crate::format::{Format, convert};
use std::sync::Arc;
use thiserror::Error;

/// The largest width and height of a level. Byte offsets then fit the 31 bits a gather takes.
pub const MAX_SIZE: u32 = 16_384;
/// How many levels an image of [`MAX_SIZE`] has: 16384 to 1.
pub const MAX_LEVELS: usize = MAX_SIZE.ilog2() as usize + 1;

/// Bytes after the last texel, so that a four-byte gather of it stays inside.
const PADDING: usize = 3;

/// The shape of an image, and of the coordinates that address it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shape {
    /// Two coordinates, one face.
    D2,
    /// A direction, six faces in the order +X, -X, +Y, -Y, +Z, -Z.
    Cube,
}

impl Shape {
    /// How many faces an image of this shape has.
    pub const fn faces(self) -> usize {
        match self {
            Self::D2 => 1,
            Self::Cube => 6,
        }
    }
}

/// Why texels could not be stored or reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum ImageError {
    /// A side above [`MAX_SIZE`].
    #[error("a level of {width}×{height} texels is larger than {MAX_SIZE} on a side")]
    TooLarge {
        /// Texels in a row.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// The allocation failed.
    #[error("there is no memory for {bytes} bytes of texels")]
    OutOfMemory {
        /// Bytes asked for.
        bytes: usize,
    },
    /// A slice of texels is shorter than its rectangle.
    #[error("{width}×{height} texels take {needed} bytes, the slice has {got}")]
    TooShort {
        /// Texels in a row.
        width: u32,
        /// Rows.
        height: u32,
        /// Bytes that were needed.
        needed: usize,
        /// Bytes that were given.
        got: usize,
    },
    /// A rectangle reaches outside its level.
    #[error(
        "the rectangle at ({x}, {y}) of {width}×{height} texels reaches outside its level of \
         {level_width}×{level_height}"
    )]
    Outside {
        /// Left.
        x: u32,
        /// Lowest row.
        y: u32,
        /// Texels in a row of the rectangle.
        width: u32,
        /// Rows of the rectangle.
        height: u32,
        /// Texels in a row of the level.
        level_width: u32,
        /// Rows of the level.
        level_height: u32,
    },
    /// A face or level number that no image of this shape has.
    #[error(
        "there is no face {face}, level {level}: faces are below {faces}, levels below {MAX_LEVELS}"
    )]
    NoSuchLevel {
        /// Face asked for.
        face: usize,
        /// Level asked for.
        level: usize,
        /// Faces of the shape.
        faces: usize,
    },
    /// A level that is needed was never given.
    #[error("face {face} has no level {level}")]
    Missing {
        /// Face asked for.
        face: usize,
        /// Level asked for.
        level: usize,
    },
}

/// One face of one level. Rows run from t = 0 up, tightly packed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Level {
    /// How its texels are stored.
    pub format: Format,
    /// Texels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The texels, and then three bytes of padding so that a four-byte gather of the last texel
    /// stays inside.
    pub texels: Vec<u8>,
}

impl Level {
    /// A level whose bytes are all 0.
    ///
    /// # Errors
    /// When a side is larger than [`MAX_SIZE`] or there is no memory.
    pub fn new(format: Format, width: u32, height: u32) -> Result<Self, ImageError> {
        if width > MAX_SIZE || height > MAX_SIZE {
            return Err(ImageError::TooLarge { width, height });
        }
        // At most 2^14 · 2^14 · 4 bytes: no overflow, and inside the 31 bits of a gather.
        let bytes = width as usize * height as usize * format.bytes() + PADDING;
        let mut texels = Vec::new();
        texels.try_reserve_exact(bytes).map_err(|_| ImageError::OutOfMemory { bytes })?;
        texels.resize(bytes, 0);
        Ok(Self { format, width, height, texels })
    }

    /// A level of these texels, rows from t = 0 up, tightly packed. Bytes beyond are ignored.
    ///
    /// # Errors
    /// As [`Level::new`], and when `texels` is too short.
    pub fn from_texels(
        format: Format,
        width: u32,
        height: u32,
        texels: &[u8],
    ) -> Result<Self, ImageError> {
        let mut level = Self::new(format, width, height)?;
        level.write(0, 0, width, height, texels)?;
        Ok(level)
    }

    /// Bytes of a row.
    pub fn row_bytes(&self) -> usize {
        self.width as usize * self.format.bytes()
    }

    /// The bytes of one texel, or none outside the level.
    pub fn texel(&self, x: u32, y: u32) -> &[u8] {
        if x >= self.width || y >= self.height {
            return &[];
        }
        let bytes = self.format.bytes();
        let at = y as usize * self.row_bytes() + x as usize * bytes;
        &self.texels[at..at + bytes]
    }

    /// Writes one colour, converted as [`convert::encode`] does. Outside the level: nothing.
    pub fn put(&mut self, x: u32, y: u32, rgba: [f32; 4]) {
        if x < self.width && y < self.height {
            let bytes = self.format.bytes();
            let at = y as usize * self.row_bytes() + x as usize * bytes;
            let texel = convert::encode(self.format, rgba);
            self.texels[at..at + bytes].copy_from_slice(&texel[..bytes]);
        }
    }

    /// Writes a rectangle of texels in this level's format, rows upward, tightly packed.
    ///
    /// # Errors
    /// When the rectangle reaches outside or `texels` is too short; nothing is written then.
    pub fn write(
        &mut self,
        x: u32,
        y: u32,
        width: u32,
        height: u32,
        texels: &[u8],
    ) -> Result<(), ImageError> {
        let inside =
            |at: u32, size: u32, limit: u32| at.checked_add(size).is_some_and(|end| end <= limit);
        if !inside(x, width, self.width) || !inside(y, height, self.height) {
            let (level_width, level_height) = (self.width, self.height);
            return Err(ImageError::Outside { x, y, width, height, level_width, level_height });
        }
        let bytes = self.format.bytes();
        let run = width as usize * bytes;
        let needed = run * height as usize;
        if texels.len() < needed {
            return Err(ImageError::TooShort { width, height, needed, got: texels.len() });
        }
        let row_bytes = self.row_bytes();
        for row in 0..height as usize {
            let at = (y as usize + row) * row_bytes + x as usize * bytes;
            self.texels[at..at + run].copy_from_slice(&texels[row * run..(row + 1) * run]);
        }
        Ok(())
    }
}

/// Faces × levels, each of which may be missing, as GL lets them be specified one by one.
/// Cloning shares the levels.
#[derive(Clone, Debug)]
pub struct Image {
    shape: Shape,
    /// `levels[face][level]`.
    levels: Vec<Vec<Option<Arc<Level>>>>,
}

impl Image {
    /// An image without levels.
    pub fn new(shape: Shape) -> Self {
        Self { shape, levels: vec![Vec::new(); shape.faces()] }
    }

    /// Its shape.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// A level, if there is one.
    pub fn level(&self, face: usize, level: usize) -> Option<&Arc<Level>> {
        self.levels.get(face)?.get(level)?.as_ref()
    }

    /// Gives a level, in place of what was there.
    ///
    /// # Errors
    /// When no image of this shape has such a face or level.
    pub fn set_level(
        &mut self,
        face: usize,
        level: usize,
        texels: Level,
    ) -> Result<(), ImageError> {
        self.set_shared(face, level, Arc::new(texels))
    }

    /// Gives a level that may be shared with other images.
    ///
    /// # Errors
    /// When no image of this shape has such a face or level.
    pub fn set_shared(
        &mut self,
        face: usize,
        level: usize,
        texels: Arc<Level>,
    ) -> Result<(), ImageError> {
        let faces = self.shape.faces();
        if face >= faces || level >= MAX_LEVELS {
            return Err(ImageError::NoSuchLevel { face, level, faces });
        }
        let levels = &mut self.levels[face];
        if levels.len() <= level {
            levels.resize(level + 1, None);
        }
        levels[level] = Some(texels);
        Ok(())
    }

    /// Takes a level away, if there is one.
    pub fn remove(&mut self, face: usize, level: usize) -> Option<Arc<Level>> {
        self.levels.get_mut(face)?.get_mut(level)?.take()
    }

    /// A level to write to, if there is one. Copies it first if someone else still reads it.
    pub fn level_mut(&mut self, face: usize, level: usize) -> Option<&mut Level> {
        self.levels.get_mut(face)?.get_mut(level)?.as_mut().map(Arc::make_mut)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_checked_before_memory_is_taken() {
        for (width, height) in [(MAX_SIZE + 1, 1), (1, u32::MAX), (u32::MAX, u32::MAX)] {
            let error = Level::new(Format::Rgba8, width, height).unwrap_err();
            assert_eq!(error, ImageError::TooLarge { width, height });
        }
        assert_eq!(Level::new(Format::Rgb8, 0, 7).unwrap().texels.len(), PADDING);
    }

    #[test]
    fn a_rectangle_lands_where_it_belongs_or_nowhere() {
        let mut level = Level::new(Format::Rg8, 3, 3).unwrap();
        level.write(1, 1, 2, 2, &[1, 2, 3, 4, 5, 6, 7, 8]).unwrap();
        assert_eq!(level.texel(2, 1), [3, 4]);
        assert_eq!(level.texel(1, 2), [5, 6]);
        assert_eq!(level.texel(0, 0), [0, 0]);
        assert_eq!(level.texel(3, 0), []);
        let before = level.clone();
        assert!(matches!(level.write(2, 0, 2, 1, &[0; 4]), Err(ImageError::Outside { .. })));
        assert!(matches!(level.write(u32::MAX, 0, 2, 1, &[0; 4]), Err(ImageError::Outside { .. })));
        assert!(matches!(
            level.write(0, 0, 2, 2, &[0; 7]),
            Err(ImageError::TooShort { needed: 8, got: 7, .. })
        ));
        assert_eq!(level, before);
    }

    #[test]
    fn writing_copies_what_another_image_still_reads() {
        let mut image = Image::new(Shape::D2);
        image.set_level(0, 2, Level::new(Format::L8, 1, 1).unwrap()).unwrap();
        let earlier = image.clone();
        image.level_mut(0, 2).unwrap().put(0, 0, [1.0; 4]);
        assert_eq!(earlier.level(0, 2).unwrap().texel(0, 0), [0]);
        assert_eq!(image.level(0, 2).unwrap().texel(0, 0), [255]);
        assert!(image.level(0, 0).is_none() && image.level(1, 0).is_none());
        assert!(image.remove(0, 2).is_some() && image.level(0, 2).is_none());
        let level = Level::new(Format::L8, 1, 1).unwrap();
        assert!(image.set_level(1, 0, level.clone()).is_err());
        assert!(image.set_level(0, MAX_LEVELS, level).is_err());
    }
}
