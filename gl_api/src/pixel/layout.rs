//! Layout of pixel rectangles in client memory (GL 2.1, section 3.6.4).

use crate::base::error::{Result, invalid_operation};
use crate::pixel::client::Pixel;
use crate::pixel::client::element::ClientType;
use crate::pixel::store::PixelStore;
use texunit::pixel;

/// Which parameters of the pixel store apply.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extent {
    /// One row or one image.
    Flat,
    /// Several images: `IMAGE_HEIGHT` and `SKIP_IMAGES` count too (section 3.6.1).
    Volume,
}

/// The order of the bytes of an element in the client's memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ByteOrder {
    /// The processor's.
    Native,
    /// The other one: `GL_UNPACK_SWAP_BYTES`.
    Swapped,
}

impl ByteOrder {
    /// Which byte comes first in memory.
    pub(crate) fn in_memory(self) -> pixel::ByteOrder {
        match (self, cfg!(target_endian = "little")) {
            (Self::Native, true) | (Self::Swapped, false) => pixel::ByteOrder::Little,
            (Self::Swapped, true) | (Self::Native, false) => pixel::ByteOrder::Big,
        }
    }
}

/// The layout of a box of pixels in client memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Layout {
    pub pixel: Pixel,
    /// Pixels in a row, rows, images.
    pub size: [usize; 3],
    /// Byte of the first pixel.
    pub start: usize,
    /// Bytes from a row to the next.
    pub stride: usize,
    /// Bytes from an image to the next.
    pub image_stride: usize,
    /// Bytes that the memory must have.
    pub needed: usize,
    /// The order of an element's bytes; of one byte the processor's.
    pub order: ByteOrder,
    /// The bit layout, if the pixels are bits.
    pub bits: Option<Bits>,
}

/// The layout of the bits of a row (GL 2.1, section 3.6.4, bitmaps).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Bits {
    /// The row's first bit in its first byte.
    pub first: usize,
    order: BitOrder,
}

/// Which bit of a byte comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum BitOrder {
    HighestFirst,
    LowestFirst,
}

impl Bits {
    /// The byte of a column, from the row's first on, and its bit as a shift.
    pub fn place(self, column: usize) -> (usize, u32) {
        let bit = self.first + column;
        let within = (bit % 8) as u32;
        let shift = match self.order {
            BitOrder::HighestFirst => 7 - within,
            BitOrder::LowestFirst => within,
        };
        (bit / 8, shift)
    }

    /// The bit of a column.
    pub fn at(self, row: &[u8], column: usize) -> u8 {
        let (byte, shift) = self.place(column);
        row[byte] >> shift & 1
    }

    /// The bits of up to eight columns from this one on, the first lowest.
    pub fn up_to_eight(self, row: &[u8], column: usize, count: usize) -> u8 {
        let first = self.first + column;
        let byte = |at: usize| row.get(at).copied().unwrap_or(0);
        let (bytes, skipped) = ([byte(first / 8), byte(first / 8 + 1)], first % 8);
        let bits = match self.order {
            BitOrder::HighestFirst => (u16::from_be_bytes(bytes) << skipped).reverse_bits(),
            BitOrder::LowestFirst => u16::from_le_bytes(bytes) >> skipped,
        };
        bits as u8 & (0xFF >> (8 - count))
    }

    /// Sets the bit of a column to the lowest of `value`.
    pub fn put(self, row: &mut [u8], column: usize, value: u8) {
        let (byte, shift) = self.place(column);
        row[byte] = row[byte] & !(1 << shift) | (value & 1) << shift;
    }
}

impl Layout {
    /// GL 2.1, section 3.6.4, equation 3.10.
    ///
    /// # Errors
    /// When it reaches beyond the address space.
    pub fn new(store: &PixelStore, pixel: Pixel, size: [usize; 3], extent: Extent) -> Result<Self> {
        let [width, height, depth] = size;
        let is_bits = pixel.ty == ClientType::Bit;
        // The bytes that so many pixels begin in.
        let span = |pixels: u128| {
            if is_bits { pixels.div_ceil(8) } else { pixels * pixel.bytes() as u128 }
        };
        let per_row = if store.row_length > 0 { store.row_length } else { width };
        // At most 2^31 pixels of 16 bytes, times 2^31 rows, times 2^31 images: no overflow in 128
        // bits.
        let row = span(per_row as u128);
        let stride = if pixel.ty.size() >= store.alignment {
            row
        } else {
            row.next_multiple_of(store.alignment as u128)
        };
        let (image_height, skip_images) = match extent {
            Extent::Flat => (0, 0),
            Extent::Volume => (store.image_height, store.skip_images),
        };
        let per_image = if image_height > 0 { image_height } else { height };
        let image_stride = stride * per_image as u128;
        let start = skip_images as u128 * image_stride
            + store.skip_rows as u128 * stride
            + if is_bits { store.skip_pixels as u128 / 8 } else { span(store.skip_pixels as u128) };
        let bits = is_bits.then_some(Bits {
            first: store.skip_pixels % 8,
            order: if store.lsb_first { BitOrder::LowestFirst } else { BitOrder::HighestFirst },
        });
        let needed = if size.contains(&0) {
            0
        } else {
            start
                + (depth as u128 - 1) * image_stride
                + (height as u128 - 1) * stride
                + span((bits.map_or(0, |bits| bits.first) + width) as u128)
        };
        // A stride beyond that is never used: there is only one row or image.
        let byte = |value: u128| isize::try_from(value.min(needed)).ok().map(isize::cast_unsigned);
        let is_swapped = store.swap_bytes && pixel.ty.size() > 1;
        match (byte(start), byte(stride), byte(image_stride), byte(needed)) {
            (Some(start), Some(stride), Some(image_stride), Some(needed)) => Ok(Self {
                pixel,
                size,
                start,
                stride,
                image_stride,
                needed,
                order: if is_swapped { ByteOrder::Swapped } else { ByteOrder::Native },
                bits,
            }),
            _ => invalid_operation(
                "GL 2.1, section 3.6.4",
                format!(
                    "{width}×{height}×{depth} pixels laid out so take {needed} bytes, more than \
                     there are"
                ),
            ),
        }
    }

    /// Where each row of pixels begins, row by row and image by image.
    pub fn rows(&self) -> impl Iterator<Item = usize> {
        let [_, height, depth] = self.size;
        let (start, stride, image_stride) = (self.start, self.stride, self.image_stride);
        (0..depth)
            .flat_map(move |z| (0..height).map(move |y| start + z * image_stride + y * stride))
    }

    /// Bytes of the pixels of a row.
    pub fn row_bytes(&self) -> usize {
        match self.bits {
            Some(bits) => (bits.first + self.size[0]).div_ceil(8),
            None => self.size[0] * self.pixel.bytes(),
        }
    }

    /// Where `width` pixels from a column of a row of the first image on lie.
    pub fn run(&self, column: usize, row: usize, width: usize) -> Self {
        let start = self.start + row * self.stride;
        let (skipped, bits) = match self.bits {
            Some(bits) => {
                let first = bits.first + column;
                (first / 8, Some(Bits { first: first % 8, ..bits }))
            }
            None => (column * self.pixel.bytes(), None),
        };
        let run = Self { size: [width, 1, 1], start: start + skipped, bits, ..*self };
        Self { needed: run.start + run.row_bytes(), ..run }
    }

    /// Checks that the client's memory is long enough. `alignment` is the pixel store's parameter
    /// (`GL_UNPACK_ALIGNMENT`), named in the message where changing it would help.
    pub fn check_length(&self, has: usize, alignment: &str) -> Result<()> {
        if has >= self.needed {
            return Ok(());
        }
        let tight = self.row_bytes();
        let [width, height, depth] = self.size;
        let packed = tight.saturating_mul(height).saturating_mul(depth);
        let advice = if has >= packed && self.stride > tight && self.start == 0 {
            format!(
                "; its rows of {tight} bytes seem to be tightly packed: call \
                 glPixelStorei({alignment}, 1)"
            )
        } else {
            String::new()
        };
        let each = match self.bits {
            Some(_) => "1 bit".to_owned(),
            None => format!("{} bytes", self.pixel.bytes()),
        };
        let images = if depth == 1 { String::new() } else { format!("×{depth}") };
        invalid_operation(
            "GL 2.1, section 3.6.4",
            format!(
                "{width}×{height}{images} pixels of {each}, rows {} bytes apart, take {} bytes; \
                 the memory has {has}{advice}",
                self.stride, self.needed
            ),
        )
    }
}
