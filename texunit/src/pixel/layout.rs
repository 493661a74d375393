//! The layout of a pixel in memory.

use super::NumberEncoding;
use crate::format::{Encoding, Field, Format};
use crate::lanes::{Isa, Kernel, LANES, Simd, U32s};

/// The order of the bytes of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ByteOrder {
    /// The lowest byte first.
    Little,
    /// The highest byte first.
    Big,
}

/// The layout of a pixel in memory: one to four words of one size, and the fields of its numbers. A pixel with words of
/// one or three bytes has one word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelLayout {
    /// Bytes of a word, 1 to 4.
    size: usize,
    words: usize,
    order: ByteOrder,
    fields: [(Field, NumberEncoding); 4],
    count: usize,
}

impl PixelLayout {
    /// Numbers one after the other, each of as many bytes (1, 2 or 4).
    pub fn uniform(count: usize, size: usize, code: NumberEncoding, order: ByteOrder) -> Self {
        let bits = 8 * size as u32;
        // How many numbers share a word: several where the word has their order in memory.
        let shared = match order {
            ByteOrder::Big if size > 1 => 1,
            ByteOrder::Little | ByteOrder::Big if count * size <= 4 => count,
            ByteOrder::Little | ByteOrder::Big if (count * size).is_multiple_of(4) => 4 / size,
            ByteOrder::Little | ByteOrder::Big => 1,
        };
        let field = |index: usize| {
            let (word, place) = (index / shared, index % shared);
            Field { word, shift: place as u32 * bits, bits }
        };
        let fields = [0, 1, 2, 3].map(|index| (field(index), code));
        let order = if shared > 1 { ByteOrder::Little } else { order };
        Self { size: shared * size, words: count.div_ceil(shared), order, fields, count }
    }

    /// Words of `size` bytes with these numbers in them, one to four.
    pub fn packed(
        size: usize,
        words: usize,
        order: ByteOrder,
        numbers: &[(Field, NumberEncoding)],
    ) -> Self {
        let none = (Field { word: 0, shift: 0, bits: 0 }, NumberEncoding::Uint);
        let mut fields = [none; 4];
        for (to, &from) in fields.iter_mut().zip(numbers) {
            *to = from;
        }
        let order = if size == 1 { ByteOrder::Little } else { order };
        Self { size, words, order, fields, count: numbers.len().min(4) }
    }

    /// A texel: its stored channels, and the stencil behind a depth. Colours are as stored, sRGB too
    /// (`EXT_texture_sRGB`). A compressed format has a layout without numbers.
    pub fn of(format: Format) -> Self {
        let info = format.info();
        let code = match info.encoding {
            Encoding::Unorm | Encoding::Srgb => NumberEncoding::Unorm,
            Encoding::Snorm => NumberEncoding::Snorm,
            Encoding::Float if format.is_depth() => NumberEncoding::Depth,
            Encoding::Float => NumberEncoding::Float,
            Encoding::SharedExponent => NumberEncoding::SharedExponent,
            Encoding::Uint => NumberEncoding::Uint,
            Encoding::Sint => NumberEncoding::Sint,
            Encoding::Block(_) | Encoding::SrgbBlock(_) => {
                return Self::packed(4, format.words(), ByteOrder::Little, &[]);
            }
        };
        let channels = format.channels();
        let bits = info.fields[0].bits;
        if info.fields[..channels].iter().map(|field| field.bits).sum::<u32>()
            == 8 * info.bytes as u32
            && info.fields[..channels]
                .iter()
                .all(|field| field.bits == bits && bits.is_multiple_of(8))
        {
            return Self::uniform(channels, bits as usize / 8, code, ByteOrder::Little);
        }
        let channels = info.fields.into_iter().take(channels).map(|field| (field, code));
        let stencil = format.has_stencil().then_some((info.stencil, NumberEncoding::Uint));
        let numbers: Vec<(Field, NumberEncoding)> = channels.chain(stencil).collect();
        Self::packed(info.bytes.min(4), format.words(), ByteOrder::Little, &numbers)
    }

    /// A texel whose sRGB-encoded channels are linear light.
    pub fn of_light(format: Format) -> Self {
        let mut record = Self::of(format);
        for (channel, (_, code)) in record.fields.iter_mut().enumerate().take(format.channels()) {
            if format.is_srgb_channel(channel) {
                *code = NumberEncoding::Srgb;
            }
        }
        record
    }

    /// A texel as its channels are averaged: normalized ones as the integers that they are, sRGB-encoded ones as
    /// linear light.
    pub fn of_means(format: Format) -> Self {
        let mut record = Self::of_light(format);
        for (_, code) in &mut record.fields {
            *code = match *code {
                NumberEncoding::Unorm => NumberEncoding::Uint,
                NumberEncoding::Snorm => NumberEncoding::SnormSteps,
                NumberEncoding::Fixed
                | NumberEncoding::Srgb
                | NumberEncoding::Uint
                | NumberEncoding::Sint => *code,
                NumberEncoding::Float
                | NumberEncoding::Depth
                | NumberEncoding::SharedExponent
                | NumberEncoding::SnormSteps => *code,
            };
        }
        record
    }

    /// The stencil of a texel alone; without numbers where it has none.
    pub fn of_stencil(format: Format) -> Self {
        let stencil = (format.info().stencil, NumberEncoding::Uint);
        let numbers = if format.has_stencil() { &[stencil][..] } else { &[] };
        Self::packed(format.bytes().min(4), format.words(), ByteOrder::Little, numbers)
    }

    /// Bytes of a pixel, 1 to 16.
    pub fn bytes(&self) -> usize {
        self.size * self.words
    }

    /// Where its numbers are, and what they are.
    #[inline(always)]
    pub fn fields(&self) -> &[(Field, NumberEncoding)] {
        &self.fields[..self.count]
    }

    /// The first of numbers that share an exponent.
    #[inline(always)]
    pub(super) fn shared_exponent(&self) -> Option<(Field, NumberEncoding)> {
        let first = self.fields[0];
        (first.1 == NumberEncoding::SharedExponent).then_some(first)
    }

    /// Whether the words lie in memory as another's do.
    pub(super) fn lies_as(&self, other: &Self) -> bool {
        (self.size, self.words, self.order) == (other.size, other.words, other.order)
    }

    /// How many words there are.
    pub(super) fn words(&self) -> usize {
        self.words
    }

    /// All bits of a word.
    pub(super) fn mask(&self) -> u32 {
        u32::MAX >> (32 - 8 * self.size)
    }

    /// The words of up to 64 pixels; those of pixels that are not there stay as they are.
    pub(super) fn load(&self, isa: Isa, bytes: &[u8], words: &mut [U32s; 4]) {
        isa.run(Load { record: self, bytes, words });
    }

    /// The words of up to 64 pixels into memory.
    pub(super) fn store(&self, isa: Isa, words: &mut [U32s; 4], bytes: &mut [u8]) {
        isa.run(Store { record: self, words, bytes });
    }

    /// [`PixelLayout::load`] of whatever words.
    #[inline(never)]
    fn load_any(&self, bytes: &[u8], words: &mut [U32s; 4]) {
        match self.size {
            1 => self.load_sized(bytes, words, |[a]| u32::from(a)),
            2 => self.load_sized(bytes, words, |bytes| u16::from_le_bytes(bytes).into()),
            3 => self.load_sized(bytes, words, |[a, b, c]| u32::from_le_bytes([a, b, c, 0])),
            _ => self.load_sized(bytes, words, u32::from_le_bytes),
        }
        self.put_in_order(words);
    }

    #[inline(always)]
    fn load_sized<const SIZE: usize>(
        &self,
        bytes: &[u8],
        words: &mut [U32s; 4],
        word: impl Fn([u8; SIZE]) -> u32,
    ) {
        let (elements, _) = bytes.as_chunks::<SIZE>();
        // Pixels with words of one or three bytes have one word.
        if self.words == 1 || SIZE % 2 == 1 {
            for (out, &element) in words[0].0.iter_mut().zip(elements) {
                *out = word(element);
            }
            return;
        }
        for (lane, pixel) in elements.chunks_exact(self.words).enumerate().take(LANES) {
            for (out, &element) in words.iter_mut().zip(pixel) {
                out[lane] = word(element);
            }
        }
    }

    /// [`PixelLayout::store`] of whatever words.
    #[inline(never)]
    fn store_any(&self, words: &mut [U32s; 4], bytes: &mut [u8]) {
        self.put_in_order(words);
        match self.size {
            1 => self.store_sized(words, bytes, |[a, _, _, _]| [a]),
            2 => self.store_sized(words, bytes, |[a, b, _, _]| [a, b]),
            3 => self.store_sized(words, bytes, |[a, b, c, _]| [a, b, c]),
            _ => self.store_sized(words, bytes, |bytes| bytes),
        }
    }

    #[inline(always)]
    fn store_sized<const SIZE: usize>(
        &self,
        words: &[U32s; 4],
        bytes: &mut [u8],
        element: impl Fn([u8; 4]) -> [u8; SIZE],
    ) {
        let (elements, _) = bytes.as_chunks_mut::<SIZE>();
        // Pixels with words of one or three bytes have one word.
        if self.words == 1 || SIZE % 2 == 1 {
            for (to, word) in elements.iter_mut().zip(&words[0].0) {
                *to = element(word.to_le_bytes());
            }
            return;
        }
        for (lane, pixel) in elements.chunks_exact_mut(self.words).enumerate().take(LANES) {
            for (to, words) in pixel.iter_mut().zip(words) {
                *to = element(words[lane].to_le_bytes());
            }
        }
    }

    /// Swaps the bytes of big-endian words.
    fn put_in_order(&self, words: &mut [U32s; 4]) {
        if self.order == ByteOrder::Big {
            for word in words.iter_mut().take(self.words).flat_map(|words| &mut words.0) {
                *word = word.swap_bytes() >> (32 - 8 * self.size);
            }
        }
    }
}

/// [`PixelLayout::load`].
pub(super) struct Load<'a> {
    pub record: &'a PixelLayout,
    pub bytes: &'a [u8],
    pub words: &'a mut [U32s; 4],
}

impl Kernel for Load<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { record, bytes, words } = self;
        let done = match (record.size, record.words, record.order) {
            (4, 2, ByteOrder::Little) if S::WIDE => load::<2>(bytes, words),
            (4, 3, ByteOrder::Little) if S::WIDE => load::<3>(bytes, words),
            (4, 4, ByteOrder::Little) if S::WIDE => load::<4>(bytes, words),
            _ => None,
        };
        if done.is_none() {
            record.load_any(bytes, words);
        }
    }
}

/// Words of four bytes, so many a pixel, of 64 pixels; `None` where there are fewer.
#[inline(always)]
fn load<const COUNT: usize>(bytes: &[u8], words: &mut [U32s; 4]) -> Option<()> {
    let (pixels, _) = bytes.as_chunks::<4>().0.as_chunks::<COUNT>();
    let pixels = pixels.first_chunk::<LANES>()?;
    for lane in 0..LANES {
        for index in 0..COUNT {
            words[index][lane] = u32::from_le_bytes(pixels[lane][index]);
        }
    }
    Some(())
}

/// [`PixelLayout::store`].
pub(super) struct Store<'a> {
    pub record: &'a PixelLayout,
    pub words: &'a mut [U32s; 4],
    pub bytes: &'a mut [u8],
}

impl Kernel for Store<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { record, words, bytes } = self;
        let done = match (record.size, record.words, record.order) {
            (4, 2, ByteOrder::Little) if S::WIDE => store::<2>(words, bytes),
            (4, 3, ByteOrder::Little) if S::WIDE => store::<3>(words, bytes),
            (4, 4, ByteOrder::Little) if S::WIDE => store::<4>(words, bytes),
            _ => None,
        };
        if done.is_none() {
            record.store_any(words, bytes);
        }
    }
}

/// Words of four bytes, so many a pixel, of 64 pixels; `None` where there are fewer.
#[inline(always)]
fn store<const COUNT: usize>(words: &[U32s; 4], bytes: &mut [u8]) -> Option<()> {
    let (pixels, _) = bytes.as_chunks_mut::<4>().0.as_chunks_mut::<COUNT>();
    let pixels = pixels.first_chunk_mut::<LANES>()?;
    for lane in 0..LANES {
        for index in 0..COUNT {
            pixels[lane][index] = words[index][lane].to_le_bytes();
        }
    }
    Some(())
}
