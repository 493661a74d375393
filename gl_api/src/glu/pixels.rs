//! Pixels in client memory as GLU sees them: numbers in the type's own steps, so that their mean
//! is taken before anything is converted.

use crate::constants::*;
pub use crate::texture::layout::ByteOrder;
use crate::texture::packed::{PACKED, Packed};
use crate::types::GLenum;

/// An image as numbers: slices and rows from first to last, `count` components a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Components {
    /// Pixels in a row, rows in a slice, slices.
    pub size: [usize; 3],
    /// Components of a pixel, 1 to 4.
    pub count: usize,
    /// `width * height * depth * count` numbers in steps of the storage: 0 to 255 for a byte.
    pub values: Vec<f64>,
}

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

    /// The nearest step, halves up. NaN gives the smallest of an integer type.
    pub fn round(self, component: usize, value: f64) -> f64 {
        if self == Self::F32 {
            return f64::from(value as f32);
        }
        let (low, high) = self.range(component);
        if low == 0.0 {
            // As below: what is negative, or no number, becomes 0.
            return f64::from(((value + 0.5) as u32).min(high as u32));
        }
        (value + 0.5).floor().max(low).min(high)
    }

    /// A number in steps of `self` as one in steps of `other`.
    pub fn convert(self, other: Self, component: usize, value: f64) -> f64 {
        if self == other {
            return value;
        }
        let unit = value / self.range(component).1;
        other.round(component, unit * other.range(component).1)
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

/// Whether pixels of a format are indices, which are the same numbers in every type.
pub fn are_indices(format: GLenum) -> bool {
    matches!(format, GL_COLOR_INDEX | GL_STENCIL_INDEX)
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

    fn pixel(&self) -> usize {
        self.storage.bytes() * self.storage.elements(self.count)
    }

    fn stride(&self) -> usize {
        let length = if self.store.row_length == 0 { self.size[0] } else { self.store.row_length };
        length.saturating_mul(self.pixel()).saturating_add(self.store.alignment - 1)
            & !(self.store.alignment - 1)
    }

    /// Where row `y` of slice `z` begins.
    fn row(&self, y: usize, z: usize) -> usize {
        let Store { image_height, skip_images, skip_rows, skip_pixels, .. } = self.store;
        let rows = if image_height == 0 { self.size[1] } else { image_height };
        let rows = skip_images.saturating_add(z).saturating_mul(rows);
        let row = rows.saturating_add(skip_rows).saturating_add(y);
        let skipped = skip_pixels.saturating_mul(self.pixel());
        row.saturating_mul(self.stride()).saturating_add(skipped)
    }

    /// Where each row begins.
    fn rows(&self) -> impl Iterator<Item = usize> {
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
        let row = self.size[0] * self.pixel();
        let mut texels = Vec::with_capacity(self.size[1] * self.size[2] * row);
        self.rows().for_each(|at| texels.extend_from_slice(&bytes[at..][..row]));
        Ok(texels)
    }

    fn check(&self, bytes: &[u8]) -> Result<(), TooShort> {
        let needed = self.needed();
        if bytes.len() < needed { Err(TooShort { needed }) } else { Ok(()) }
    }

    /// The image as numbers.
    ///
    /// # Errors
    /// When `bytes` ends before the image does.
    pub fn read(&self, bytes: &[u8]) -> Result<Components, TooShort> {
        self.check(bytes)?;
        let mut values = Vec::with_capacity(self.size.iter().product::<usize>() * self.count);
        for at in self.rows() {
            let row = &bytes[at..][..self.size[0] * self.pixel()];
            if self.storage == Storage::U8 {
                values.extend(row.iter().map(|&byte| f64::from(byte)));
                continue;
            }
            for element in row.chunks_exact(self.storage.bytes()) {
                self.read_element(element, &mut values);
            }
        }
        Ok(Components { size: self.size, count: self.count, values })
    }

    fn read_element(&self, element: &[u8], values: &mut Vec<f64>) {
        let mut raw = [0; 4];
        raw[..element.len()].copy_from_slice(element);
        if self.store.order == ByteOrder::Swapped {
            raw[..element.len()].reverse();
        }
        let [a, b, c, d] = raw;
        let word = match element.len() {
            1 => u32::from(a),
            2 => u32::from(u16::from_ne_bytes([a, b])),
            _ => u32::from_ne_bytes([a, b, c, d]),
        };
        match self.storage {
            Storage::U8 | Storage::U16 | Storage::U32 => values.push(f64::from(word)),
            Storage::I8 => values.push(f64::from(word as u8 as i8)),
            Storage::I16 => values.push(f64::from(word as u16 as i16)),
            Storage::I32 => values.push(f64::from(word as i32)),
            Storage::F32 => values.push(f64::from(f32::from_bits(word))),
            Storage::Packed(packed) => values.extend(
                (0..self.count).map(|component| f64::from(packed.field(component).of(word))),
            ),
        }
    }

    /// Writes numbers that are steps of the storage; bytes between the rows stay as they are.
    ///
    /// # Errors
    /// When `bytes` ends before the image does; nothing is written.
    pub fn write(&self, image: &Components, bytes: &mut [u8]) -> Result<(), TooShort> {
        self.check(bytes)?;
        let (size, elements) = (self.storage.bytes(), self.storage.elements(self.count));
        let width = self.size[0];
        for (at, row) in self.rows().zip(image.values.chunks_exact((width * self.count).max(1))) {
            let out = &mut bytes[at..][..width * self.pixel()];
            if self.storage == Storage::U8 {
                out.iter_mut().zip(row).for_each(|(out, value)| *out = *value as u32 as u8);
                continue;
            }
            let values = row.chunks_exact(self.count / elements);
            for (element, values) in out.chunks_exact_mut(size).zip(values) {
                let word = self.word(values);
                match size {
                    1 => element[0] = word as u8,
                    2 => element.copy_from_slice(&(word as u16).to_ne_bytes()),
                    _ => element.copy_from_slice(&word.to_ne_bytes()),
                }
                if self.store.order == ByteOrder::Swapped {
                    element.reverse();
                }
            }
        }
        Ok(())
    }

    /// The bits of one element.
    fn word(&self, values: &[f64]) -> u32 {
        match self.storage {
            Storage::U8 | Storage::U16 | Storage::U32 => values[0] as u32,
            Storage::I8 | Storage::I16 | Storage::I32 => values[0] as i32 as u32,
            Storage::F32 => (values[0] as f32).to_bits(),
            Storage::Packed(packed) => values
                .iter()
                .enumerate()
                .fold(0, |word, (at, &value)| word | (value as u32) << packed.field(at).shift),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let bytes: Vec<u8> = (0..96u8).map(|n| n.wrapping_mul(37)).collect();
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
        assert_eq!(Storage::U8.convert(small, 0, 255.0), 31.0);
        assert_eq!(Storage::U8.convert(Storage::F32, 0, 255.0), 1.0);
        assert_eq!(Storage::F32.convert(Storage::I8, 0, -2.0), -128.0);
        assert_eq!(Storage::F32.round(0, f64::from(f32::MAX)), f64::from(f32::MAX));
    }
}
