//! Texel storage: faces and levels, shared by reference, copied when written.

mod blocks;
mod complete;
mod error;
mod fetch;
mod level;
mod limits;
mod memory;
mod shape;

pub use complete::{Incomplete, Levels};
pub use error::ImageError;
pub use level::Level;
pub use limits::{FACES, MAX_LAYERS, MAX_LEVEL_BYTES, MAX_LEVELS, MAX_SIZE, MAX_SIZE_3D, PADDING};
pub use memory::{Memory, TexelSource, copied, zeroed};
pub use shape::Shape;

use std::sync::Arc;

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
    /// When no image of this shape has such a face, level, size or border.
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
    /// When no image of this shape has such a face, level, size or border.
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
        self.shape.check(&texels)?;
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

    /// Copies a level if someone else still reads it, so that [`Self::level_mut`] needs no memory.
    ///
    /// # Errors
    /// If there is no memory for the copy.
    pub fn unshare(&mut self, face: usize, level: usize) -> Result<(), ImageError> {
        let levels = self.levels.get_mut(face).and_then(|levels| levels.get_mut(level));
        if let Some(shared) = levels.and_then(Option::as_mut)
            && Arc::strong_count(shared) > 1
        {
            *shared = Arc::new(shared.copied()?);
        }
        Ok(())
    }

    /// A level to write to, if there is one. Copies it first if someone else still reads it.
    pub fn level_mut(&mut self, face: usize, level: usize) -> Option<&mut Level> {
        self.levels.get_mut(face)?.get_mut(level)?.as_mut().map(Arc::make_mut)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format::Format;

    #[test]
    fn sizes_are_checked_before_memory_is_taken() {
        for (width, height) in [(MAX_SIZE + 1, 1), (1, u32::MAX), (u32::MAX, u32::MAX)] {
            let error = Level::new(Format::Rgba8, width, height).unwrap_err();
            assert_eq!(error, ImageError::TooLarge { width, height, depth: 1 });
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
        assert!(level.texel(3, 0).is_empty());
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
    fn a_border_is_stored_where_it_lies() {
        let border = Shape::D3.border(1);
        let mut level = Level::with_size(Format::Rg8, [2, 1, 1], border).unwrap();
        assert_eq!(level.stored_size(), [4, 3, 3]);
        assert_eq!([level.row_bytes(), level.slice_bytes()], [8, 24]);
        assert_eq!(level.origin(), 24 + 8 + 2);
        let all: Vec<u8> = (0..72).collect();
        level.write_box([-1; 3], [4, 3, 3], &all).unwrap();
        assert_eq!(level.texel(0, 0), [34, 35]);
        assert_eq!(level.texel_at([2, 1, 1]), [70, 71]);
        assert_eq!(level.texel(2, 0), [] as [u8; 0]);
        assert_eq!(level.texel_at([3, 0, 0]), [] as [u8; 0]);
        let outside = level.write_box([-2, 0, 0], [1; 3], &all).unwrap_err();
        assert!(matches!(outside, ImageError::Outside { .. }));
        let wide = Level::with_size(Format::L8, [2, 2, 1], [2, 0, 0]).unwrap_err();
        assert_eq!(wide, ImageError::WrongBorder { border: [2, 0, 0] });
    }

    #[test]
    fn compressed_levels_are_written_in_whole_blocks() {
        let mut level = Level::new(Format::Dxt1Rgb, 10, 6).unwrap();
        assert_eq!([level.row_bytes(), level.slice_bytes()], [24, 48]);
        level.write(4, 0, 6, 4, &[7; 16]).unwrap();
        assert_eq!(level.texel(9, 3), [7; 8]);
        assert_eq!(level.texel(3, 3), [0; 8]);
        for (at, size) in [([2, 0], [4, 4]), ([0, 0], [5, 4]), ([0, 4], [4, 1])] {
            let cut = level.write(at[0], at[1], size[0], size[1], &[0; 64]);
            assert!(matches!(cut, Err(ImageError::CutsBlocks { .. })), "{at:?}");
        }
        level.fill(|[x, _, _]| if x < 4 { [1.0, 0.0, 0.0, 1.0] } else { [0.0, 0.0, 1.0, 1.0] });
        assert_eq!(level.color_at([3, 5, 0]), Some([1.0, 0.0, 0.0, 1.0]));
        level.put(9, 5, [1.0; 4]);
        assert_eq!(level.color_at([9, 5, 0]), Some([1.0; 4]));
        assert_eq!(level.color_at([8, 5, 0]), Some([0.0, 0.0, 1.0, 1.0]));
    }

    #[test]
    fn what_a_level_would_take_is_known_without_taking_it() {
        let bytes = Level::required_bytes;
        assert_eq!(bytes(Format::Rgba8, MAX_SIZE, MAX_SIZE, 1), Some(MAX_LEVEL_BYTES));
        assert_eq!(bytes(Format::Rgba16F, MAX_SIZE, MAX_SIZE, 1), None);
        assert_eq!(bytes(Format::Rgba16F, MAX_SIZE_3D, MAX_SIZE_3D, MAX_SIZE_3D), Some(1 << 30));
        assert_eq!(bytes(Format::Rgba32F, MAX_SIZE_3D, MAX_SIZE_3D, MAX_SIZE_3D), None);
        assert_eq!(bytes(Format::Dxt5, 5, 4, 3), Some(2 * 16 * 3));
        assert_eq!(bytes(Format::A8, u32::MAX, u32::MAX, u32::MAX), None);
    }

    /// The bytes of all levels there are.
    fn bytes_of(image: &Image) -> usize {
        let levels = image.levels.iter().flatten().flatten();
        levels.map(|level| level.texels.len()).sum()
    }

    #[test]
    fn an_image_takes_its_texels_and_at_most_a_third_more() {
        for (format, width, height) in
            [(Format::Rgba8, 256, 256), (Format::Rgb8, 1000, 300), (Format::Rgba32F, 64, 128)]
        {
            let texels = (width * height) as usize * format.bytes();
            let mut image = Image::new(Shape::D2);
            assert_eq!(bytes_of(&image), 0);
            image.set_level(0, 0, Level::new(format, width, height).unwrap()).unwrap();
            assert_eq!(bytes_of(&image), texels + PADDING);
            image.generate_mipmaps(crate::lanes::Isa::best(), 0, 1000).unwrap();
            let levels = image.levels[0].len();
            let third = texels.div_ceil(3) + levels * (PADDING + format.bytes());
            assert!(bytes_of(&image) <= texels + third, "{format:?} {width}x{height}");
            // A sampler reads the same levels, not copies.
            let plan = crate::plan::SamplePlan::new(&image, &crate::sampler::Sampler::default());
            assert!(plan.incomplete().is_none());
            let base = image.level(0, 0).unwrap();
            assert_eq!(Arc::strong_count(base), 2);
        }
    }

    #[test]
    fn a_shape_takes_only_sizes_and_borders_of_its_own() {
        let set = |shape, size, border| {
            Image::new(shape).set_level(0, 0, Level::with_size(Format::L8, size, border).unwrap())
        };
        assert!(set(Shape::D1, [4, 1, 1], [1, 0, 0]).is_ok());
        assert!(matches!(set(Shape::D1, [4, 2, 1], [0; 3]), Err(ImageError::TooLarge { .. })));
        assert!(matches!(set(Shape::D2, [4, 2, 2], [0; 3]), Err(ImageError::TooLarge { .. })));
        assert!(set(Shape::D3, [512, 1, 512], [1; 3]).is_ok());
        assert!(matches!(set(Shape::D3, [513, 1, 1], [0; 3]), Err(ImageError::TooLarge { .. })));
        let wrong = Err(ImageError::WrongBorder { border: [1, 1, 0] });
        assert_eq!(set(Shape::Rect, [4, 4, 1], [1, 1, 0]), wrong);
        assert_eq!(set(Shape::D2Array, [4, 4, 7], [1, 1, 0]), Ok(()));
        assert_eq!(set(Shape::CubeArray, [4, 4, 12], [1, 1, 0]), Ok(()));
        for [width, height, depth] in [[4, 4, 7], [4, 4, 1], [4, 2, 6], [1, 2, 12]] {
            let wrong = Err(ImageError::NotCubes { width, height, depth });
            assert_eq!(set(Shape::CubeArray, [width, height, depth], [0; 3]), wrong);
        }
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
