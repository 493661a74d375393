//! Pixels in client memory as GLU sees them: numbers in the type's own steps, so that their mean
//! is taken before anything is converted.

use crate::base::constants::*;
use crate::base::types::GLenum;
pub use crate::pixel::layout::ByteOrder;
use crate::pixel::packed::{PACKED, Packed};
use texunit::pixel::{NumberEncoding, NumberTransform, PixelLayout};
#[cfg(test)]
use texunit::{lanes::Isa, pixel::boxes};

/// How a pixel's components are stored (GL 2.1 tables 3.5 and 3.8 to 3.11).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// `GL_UNSIGNED_BYTE`.
    U8,
    /// `GL_BYTE`.
    I8,
    /// `GL_UNSIGNED_SHORT`.
    U16,
    /// `GL_SHORT`.
    I16,
    /// `GL_UNSIGNED_INT`.
    U32,
    /// `GL_INT`.
    I32,
    /// `GL_FLOAT`.
    F32,
    /// All components of a pixel in one number.
    Packed(Packed),
}

impl Storage {
    /// The storage that a `type` names; `None` for a type that GLU does not scale.
    pub fn of(type_: GLenum) -> Option<Self> {
        Some(match type_ {
            GL_UNSIGNED_BYTE => Self::U8,
            GL_BYTE => Self::I8,
            GL_UNSIGNED_SHORT => Self::U16,
            GL_SHORT => Self::I16,
            GL_UNSIGNED_INT => Self::U32,
            GL_INT => Self::I32,
            GL_FLOAT => Self::F32,
            packed => Self::Packed(PACKED.iter().find(|(name, _)| *name == packed)?.1),
        })
    }

    /// Whether pixels of `count` components can be stored so (GL 2.1 table 3.8).
    pub fn holds(self, count: usize) -> bool {
        match self {
            Self::Packed(packed) => packed.bits.len() == count,
            Self::U8 | Self::I8 | Self::U16 | Self::I16 | Self::U32 | Self::I32 | Self::F32 => true,
        }
    }

    /// Bytes of one element: of a component, or of a whole packed pixel.
    fn bytes(self) -> usize {
        match self {
            Self::U8 | Self::I8 => 1,
            Self::U16 | Self::I16 => 2,
            Self::U32 | Self::I32 | Self::F32 => 4,
            Self::Packed(packed) => usize::from(packed.bytes),
        }
    }

    /// Elements of a pixel.
    fn elements(self, count: usize) -> usize {
        match self {
            Self::Packed(_) => 1,
            Self::U8 | Self::I8 | Self::U16 | Self::I16 | Self::U32 | Self::I32 | Self::F32 => {
                count
            }
        }
    }

    /// The smallest and largest step of a component; the largest stands for 1.0.
    fn range(self, component: usize) -> (f64, f64) {
        match self {
            Self::U8 => (0.0, 255.0),
            Self::I8 => (-128.0, 127.0),
            Self::U16 => (0.0, 65_535.0),
            Self::I16 => (-32_768.0, 32_767.0),
            Self::U32 => (0.0, f64::from(u32::MAX)),
            Self::I32 => (f64::from(i32::MIN), f64::from(i32::MAX)),
            Self::F32 => (f64::from(f32::MIN), 1.0),
            Self::Packed(packed) => (0.0, f64::from(packed.field(component).mask())),
        }
    }

    /// What takes each component of a pixel to the nearest step, halves up.
    pub fn steps(self) -> [NumberTransform; 4] {
        [0, 1, 2, 3].map(|component| match (self, self.range(component)) {
            (Self::F32, _) => NumberTransform::Float,
            (_, (low, high)) => NumberTransform::Whole { low, high },
        })
    }

    /// What makes each component in steps of `self` one in steps of `other`, before it is rounded.
    pub fn to(self, other: Self) -> [NumberTransform; 4] {
        [0, 1, 2, 3].map(|component| {
            let [over, times] = [self, other].map(|storage| storage.range(component).1);
            NumberTransform::Ratio { over, times }
        })
    }
}

/// How many components a pixel of `format` has; `None` for a format that GLU does not scale.
pub fn components(format: GLenum) -> Option<usize> {
    Some(match format {
        GL_RED | GL_GREEN | GL_BLUE | GL_ALPHA | GL_LUMINANCE | GL_DEPTH_COMPONENT => 1,
        GL_COLOR_INDEX | GL_STENCIL_INDEX => 1,
        GL_LUMINANCE_ALPHA | GL_RG => 2,
        GL_RGB | GL_BGR => 3,
        GL_RGBA | GL_BGRA => 4,
        _ => return None,
    })
}

/// What the numbers of pixels stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meaning {
    /// Fractions of the largest step.
    Fractions,
    /// The same numbers in every type.
    Indices,
}

impl Meaning {
    /// Those of a format.
    pub fn of(format: GLenum) -> Self {
        match format {
            GL_COLOR_INDEX | GL_STENCIL_INDEX => Self::Indices,
            _ => Self::Fractions,
        }
    }
}

/// Where the rows of an image are in client memory: half of the `glPixelStore` state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Store {
    /// Rows begin at a multiple of this many bytes: 1, 2, 4 or 8.
    pub alignment: usize,
    /// Pixels in a row of memory; 0 for the image's own width.
    pub row_length: usize,
    /// Rows before the first.
    pub skip_rows: usize,
    /// Pixels before the first of each row.
    pub skip_pixels: usize,
    /// Rows in a slice of memory; 0 for the image's own height.
    pub image_height: usize,
    /// Slices before the first.
    pub skip_images: usize,
    /// The order of an element's bytes.
    pub order: ByteOrder,
}

/// Rows without gaps.
pub const TIGHT: Store = Store {
    alignment: 1,
    row_length: 0,
    skip_rows: 0,
    skip_pixels: 0,
    image_height: 0,
    skip_images: 0,
    order: ByteOrder::Native,
};

/// An image in client memory (GL 2.1 section 3.6.4).
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// Pixels in a row, rows in a slice, slices.
    pub size: [usize; 3],
    /// Components of a pixel.
    pub count: usize,
    /// How they are stored.
    pub storage: Storage,
    /// Where the rows are.
    pub store: Store,
}

/// A slice that ends before its image does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooShort {
    /// The bytes the image takes.
    pub needed: usize,
}

impl Layout {
    /// An image without gaps.
    pub fn tight(size: [usize; 3], count: usize, storage: Storage) -> Self {
        Self { size, count, storage, store: TIGHT }
    }

    /// Bytes of the pixels of a row.
    pub fn row_bytes(&self) -> usize {
        self.size[0] * self.pixel()
    }

    fn pixel(&self) -> usize {
        self.storage.bytes() * self.storage.elements(self.count)
    }

    fn stride(&self) -> usize {
        let length = if self.store.row_length == 0 { self.size[0] } else { self.store.row_length };
        length.saturating_mul(self.pixel()).saturating_add(self.store.alignment - 1)
            & !(self.store.alignment - 1)
    }

    /// Where row `y` of slice `z` begins.
    pub fn row(&self, y: usize, z: usize) -> usize {
        let Store { image_height, skip_images, skip_rows, skip_pixels, .. } = self.store;
        let rows = if image_height == 0 { self.size[1] } else { image_height };
        let rows = skip_images.saturating_add(z).saturating_mul(rows);
        let row = rows.saturating_add(skip_rows).saturating_add(y);
        let skipped = skip_pixels.saturating_mul(self.pixel());
        row.saturating_mul(self.stride()).saturating_add(skipped)
    }

    /// Where each row begins.
    pub fn rows(&self) -> impl Iterator<Item = usize> {
        let [_, height, depth] = self.size;
        (0..depth).flat_map(move |z| (0..height).map(move |y| self.row(y, z)))
    }

    /// How many bytes the image takes, counted from the start of the slice.
    pub fn needed(&self) -> usize {
        let [width, height, depth] = self.size;
        if height == 0 || depth == 0 {
            return 0;
        }
        self.row(height - 1, depth - 1).saturating_add(width.saturating_mul(self.pixel()))
    }

    /// The image without gaps, in the same storage.
    ///
    /// # Errors
    /// When `bytes` ends before the image does.
    pub fn texels(&self, bytes: &[u8]) -> Result<Vec<u8>, TooShort> {
        self.check(bytes)?;
        let row = self.row_bytes();
        let mut texels = Vec::with_capacity(self.size[1] * self.size[2] * row);
        self.rows().for_each(|at| texels.extend_from_slice(&bytes[at..][..row]));
        Ok(texels)
    }

    /// Checks that there are as many bytes as the image takes.
    ///
    /// # Errors
    /// When there are fewer.
    pub fn check(&self, bytes: &[u8]) -> Result<(), TooShort> {
        let needed = self.needed();
        if bytes.len() < needed { Err(TooShort { needed }) } else { Ok(()) }
    }

    /// Where its components lie in a pixel, as the numbers of their steps.
    pub fn record(&self) -> PixelLayout {
        let (size, order) = (self.storage.bytes(), self.store.order.in_memory());
        let uniform = |code| PixelLayout::uniform(self.count, size, code, order);
        match self.storage {
            Storage::U8 | Storage::U16 | Storage::U32 => uniform(NumberEncoding::Uint),
            Storage::I8 | Storage::I16 | Storage::I32 => uniform(NumberEncoding::Sint),
            Storage::F32 => uniform(NumberEncoding::Float),
            Storage::Packed(packed) => {
                let fields =
                    [0, 1, 2, 3].map(|component| (packed.field(component), NumberEncoding::Uint));
                PixelLayout::packed(size, 1, order, &fields[..self.count])
            }
        }
    }
}

/// An image as numbers: slices and rows from first to last.
#[cfg(test)]
#[derive(Clone, Debug, PartialEq)]
pub struct Components {
    /// Pixels in a row, rows in a slice, slices.
    pub size: [usize; 3],
    /// Components of a pixel, 1 to 4.
    pub count: usize,
    /// In steps of the storage: 0 to 255 for a byte.
    pub values: Vec<f64>,
}

#[cfg(test)]
impl Layout {
    /// The image as numbers.
    pub fn read(&self, bytes: &[u8]) -> Result<Components, TooShort> {
        self.check(bytes)?;
        let (mut values, mut planes) = (Vec::new(), [const { Vec::new() }; 4]);
        planes.iter_mut().for_each(|plane| plane.resize(self.size[0], 0.0));
        for at in self.rows() {
            let row = &bytes[at..][..self.row_bytes()];
            boxes::read_row(Isa::best(), &self.record(), row, &mut planes);
            let numbers = |x: usize| planes[..self.count].iter().map(move |plane| plane[x]);
            values.extend((0..self.size[0]).flat_map(numbers));
        }
        Ok(Components { size: self.size, count: self.count, values })
    }

    /// Writes numbers that are steps of the storage.
    pub fn write(&self, image: &Components, bytes: &mut [u8]) -> Result<(), TooShort> {
        self.check(bytes)?;
        let rows = image.values.chunks_exact(self.size[0] * self.count);
        for (at, row) in self.rows().zip(rows) {
            let out = &mut bytes[at..][..self.row_bytes()];
            let plane = |number: usize| row.iter().copied().skip(number).step_by(self.count);
            let planes = [0, 1, 2, 3].map(|number| plane(number).collect());
            boxes::write_row(Isa::best(), &self.record(), &[], &planes, out);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use texunit::lanes::F64s;
    use texunit::pixel;

    #[test]
    fn rows_follow_alignment_row_length_and_skips() {
        let mut layout = Layout::tight([3, 2, 1], 3, Storage::U8);
        assert_eq!(layout.needed(), 18);
        layout.store.alignment = 4;
        assert_eq!(layout.needed(), 12 + 9);
        layout.store = Store { row_length: 5, skip_rows: 1, skip_pixels: 2, ..layout.store };
        assert_eq!(layout.needed(), 2 * 16 + 6 + 9);
        let bytes: Vec<u8> = (0..47).collect();
        let image = layout.read(&bytes).unwrap();
        assert_eq!(image.values[0], 22.0);
        assert_eq!(image.values[9], 38.0);
        assert_eq!(layout.read(&bytes[1..]), Err(TooShort { needed: 47 }));
        layout.store.row_length = usize::MAX;
        assert_eq!(layout.read(&bytes), Err(TooShort { needed: usize::MAX }));
    }

    #[test]
    fn slices_follow_image_height_and_skip_images() {
        let mut layout = Layout::tight([2, 2, 2], 1, Storage::U8);
        assert_eq!(layout.needed(), 8);
        layout.store = Store { image_height: 3, skip_images: 1, ..layout.store };
        assert_eq!(layout.needed(), 6 + 6 + 4);
        let bytes: Vec<u8> = (0..16).collect();
        let image = layout.read(&bytes).unwrap();
        assert_eq!(image.values, [6, 7, 8, 9, 12, 13, 14, 15].map(f64::from));
        let mut back = vec![0; 16];
        layout.write(&image, &mut back).unwrap();
        assert_eq!(back[6..10], bytes[6..10]);
        assert_eq!(back[12..], bytes[12..]);
    }

    #[test]
    fn the_lectures_451_pixel_rows_need_padding_at_the_default_alignment() {
        let mut layout = Layout::tight([451, 300, 1], 3, Storage::U8);
        layout.store.alignment = 4;
        assert_eq!(layout.needed(), 299 * 1356 + 1353);
    }

    #[test]
    fn packed_fields_are_where_table_3_9_draws_them() {
        for (type_, word, fields) in [
            (GL_UNSIGNED_SHORT_5_6_5, 0x8401u32, vec![16.0, 32.0, 1.0]),
            (GL_UNSIGNED_SHORT_5_6_5_REV, 0x8401, vec![1.0, 32.0, 16.0]),
            (GL_UNSIGNED_SHORT_1_5_5_5_REV, 0x8001, vec![1.0, 0.0, 0.0, 1.0]),
            (GL_UNSIGNED_INT_10_10_10_2, 0x0040_0003, vec![1.0, 0.0, 0.0, 3.0]),
        ] {
            let storage = Storage::of(type_).unwrap();
            let layout = Layout::tight([1, 1, 1], fields.len(), storage);
            let bytes = &word.to_ne_bytes()[..layout.needed()];
            let image = layout.read(bytes).unwrap();
            assert_eq!(image.values, fields);
            let mut back = vec![0; bytes.len()];
            layout.write(&image, &mut back).unwrap();
            assert_eq!(back, bytes);
        }
    }

    #[test]
    fn every_type_comes_back_as_it_was() {
        // None of which is part of a NaN.
        let bytes: Vec<u8> = (0..96u8).map(|n| n.wrapping_mul(37) & 0xBF).collect();
        for type_ in [GL_UNSIGNED_BYTE, GL_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_FLOAT] {
            for order in [ByteOrder::Native, ByteOrder::Swapped] {
                let storage = Storage::of(type_).unwrap();
                let mut layout = Layout::tight([3, 2, 1], 4, storage);
                layout.store.order = order;
                let mut back = vec![0; layout.needed()];
                layout.write(&layout.read(&bytes).unwrap(), &mut back).unwrap();
                assert_eq!(back, bytes[..layout.needed()], "{type_:#x}");
            }
        }
    }

    #[test]
    fn conversion_keeps_the_ends_of_the_range() {
        let small = Storage::of(GL_UNSIGNED_SHORT_5_6_5).unwrap();
        let changed = |changes: [NumberTransform; 4], value: f64| {
            let mut out = F64s::ZERO;
            pixel::transform(Isa::best(), changes[0], &F64s::splat(value), &mut out);
            out[0]
        };
        let round = |storage: Storage, value| changed(storage.steps(), value);
        let convert = |from: Storage, to: Storage, value| round(to, changed(from.to(to), value));
        assert_eq!(convert(Storage::U8, small, 255.0), 31.0);
        assert_eq!(convert(Storage::U8, Storage::F32, 255.0), 1.0);
        assert_eq!(convert(Storage::F32, Storage::I8, -2.0), -128.0);
        assert_eq!(round(Storage::F32, f64::from(f32::MAX)), f64::from(f32::MAX));
        for (value, step) in [(-0.6, 0.0), (1.5, 2.0), (2.49, 2.0), (f64::NAN, 0.0), (1e300, 255.0)]
        {
            assert_eq!(round(Storage::U8, value), step);
        }
        for (value, step) in [(-1.5, -1.0), (-1.6, -2.0), (f64::NAN, -32_768.0), (1e300, 32_767.0)]
        {
            assert_eq!(round(Storage::I16, value), step);
        }
    }
}
