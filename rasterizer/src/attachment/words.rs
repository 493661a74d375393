//! How a texel lies in the words of an attachment.
//!
//! A colour is the bytes of its texel, 1 to 4 words. A depth is one word: the integer of D16 or
//! D24, or the bits of D32F. (Depth is never negative, so the bits of two floats compare as the
//! floats do.) A stencil is a word of its own after that of its depth, in the lowest byte.

use super::depth_format::DepthFormat;
use texunit::format::{Encoding, Format};

/// A mask for each word of a texel.
pub type WordMask = [u32; 4];

/// Whether levels of this format have an attachment layout: every format but compressed ones,
/// shared exponents, and depths of 32-bit integers.
pub(crate) fn is_attachable(format: Format) -> bool {
    if format.is_depth() {
        return DepthFormat::of(format).is_some();
    }
    match format.info().encoding {
        Encoding::Unorm
        | Encoding::Snorm
        | Encoding::Srgb
        | Encoding::Float
        | Encoding::Uint
        | Encoding::Sint => true,
        Encoding::SharedExponent | Encoding::Block(_) | Encoding::SrgbBlock(_) => false,
    }
}

/// Words of a texel in the attachment layout.
pub fn attachment_words(format: Format) -> usize {
    if format.is_depth() { 1 + usize::from(format.has_stencil()) } else { format.words() }
}

/// The bits of a colour texel that hold the components of `mask` (red, green, blue, alpha).
/// Luminance and intensity are red (GL 2.1, table 3.15).
pub fn component_bits(format: Format, mask: [bool; 4]) -> WordMask {
    let mut bits = [0; 4];
    for (field, &source) in format.info().fields.iter().zip(format.base().sources()) {
        if mask[source] {
            bits[field.word] |= field.mask() << field.shift;
        }
    }
    bits
}

/// Every bit of a colour texel that holds something.
pub fn all_bits(format: Format) -> WordMask {
    component_bits(format, [true; 4])
}

/// A texel's bytes as its words in the attachment layout.
#[inline]
pub fn words_of(format: Format, texel: &[u8]) -> [u32; 4] {
    let mut bytes = [0; 16];
    bytes[..texel.len()].copy_from_slice(texel);
    let word =
        |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
    match format {
        Format::D24S8 => [word(0) >> 8, word(0) & 0xFF, 0, 0],
        Format::D32FS8 => [word(0), word(4) & 0xFF, 0, 0],
        _ => [word(0), word(4), word(8), word(12)],
    }
}

/// Words of the attachment layout as a texel's bytes.
#[inline]
pub fn texel_of(format: Format, words: [u32; 4], texel: &mut [u8]) {
    let words = match format {
        Format::D24S8 => [words[0] << 8 | words[1] & 0xFF, 0, 0, 0],
        _ => words,
    };
    for (bytes, word) in texel.chunks_mut(4).zip(words) {
        let size = bytes.len();
        bytes.copy_from_slice(&word.to_le_bytes()[..size]);
    }
}
