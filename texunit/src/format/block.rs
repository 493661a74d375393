//! Blocks of 4×4 texels: S3TC (`EXT_texture_compression_s3tc`, `EXT_texture_sRGB`), RGTC
//! (`ARB_texture_compression_rgtc`) and BPTC (`ARB_texture_compression_bptc`).
//!
//! Texels stay compressed; a fetch decodes the one it needs. Every decoded value is a fraction of
//! small integers, so it is computed as such and divided once: the nearest `f32` to the
//! specification's formula (`quotient`). sRGB blocks are decoded first and made linear afterwards, by tables
//! over all fractions that there are.

mod bptc;
mod encode;
mod interpolated;
mod quotient;

pub use encode::encode;
pub(crate) use interpolated::{Signedness, decode as interpolated};

use quotient::{quotient, reciprocal};

pub(crate) use super::properties::is_srgb_block;
use super::words::{expand, words_of};
use super::{Block, Encoding, Format, small_float, srgb};
use crate::lanes::{F32s, LANES, Simd, U32s};
use bptc::FloatSign;

impl Block {
    /// How a channel is written, and the first word of its part of the block.
    #[inline(always)]
    const fn channel_code(self, channel: usize) -> (ChannelCode, usize) {
        use Signedness::{Signed, Unsigned};
        match (self, channel) {
            (Self::Dxt1, 3) => (ChannelCode::Punched, 0),
            (Self::Dxt1, _) => (ChannelCode::Color(CHANNELS[channel], Palette::ByOrder), 0),
            (Self::Dxt3, 3) => (ChannelCode::Explicit, 0),
            (Self::Dxt5, 3) => (ChannelCode::Interpolated(Unsigned), 0),
            (Self::Dxt3 | Self::Dxt5, _) => {
                (ChannelCode::Color(CHANNELS[channel], Palette::Four), 2)
            }
            (Self::Rgtc1 | Self::Rgtc2, _) => {
                (ChannelCode::Interpolated(Unsigned), 2 * (channel & 1))
            }
            (Self::Rgtc1Snorm | Self::Rgtc2Snorm, _) => {
                (ChannelCode::Interpolated(Signed), 2 * (channel & 1))
            }
            (Self::Bptc | Self::BptcUnsignedFloat | Self::BptcSignedFloat, _) => {
                (ChannelCode::OfWholeTexels, 0)
            }
        }
    }
}

/// How a channel's part of a block is written.
#[derive(Clone, Copy)]
enum ChannelCode {
    /// Of a colour on the line between two of 16 bits.
    Color(ColorChannel, Palette),
    /// 0 at the transparent black of DXT1, else 1.
    Punched,
    /// 4 bits a texel.
    Explicit,
    /// On the line between two bytes.
    Interpolated(Signedness),
    /// In bits of the whole block: all channels are decoded together.
    OfWholeTexels,
}

/// Which codes the two bits of a texel stand for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Palette {
    /// Four where the first colour is the larger number, else three and black.
    ByOrder,
    /// Four.
    Four,
}

/// A channel of the 16 bits of a colour.
#[derive(Clone, Copy)]
pub(crate) struct ColorChannel {
    shift: u32,
    largest: u32,
}

pub(crate) const CHANNELS: [ColorChannel; 3] = [
    ColorChannel { shift: 11, largest: 31 },
    ColorChannel { shift: 5, largest: 63 },
    ColorChannel { shift: 0, largest: 31 },
];

impl ColorChannel {
    /// From sixths of the largest to a number.
    #[inline(always)]
    pub fn fraction(self, sixths: u32) -> f32 {
        const FIVE: [f32; 2] = reciprocal(SIXTHS * 31);
        const SIX: [f32; 2] = reciprocal(SIXTHS * 63);
        quotient(sixths as i32 as f32, if self.largest == 31 { FIVE } else { SIX })
    }

    /// Linear light of sixths of the largest, in a table.
    pub fn linear(self) -> &'static [f32] {
        if self.largest == 31 { &LINEAR_5 } else { &LINEAR_6 }
    }
}

/// What the fractions of a colour are counted in: sixths serve halves and thirds.
const SIXTHS: u32 = 6;

/// Linear light of the sRGB values `k / 186` (five bits) and `k / 378` (six).
static LINEAR_5: [f32; 187] = linear_table();
static LINEAR_6: [f32; 379] = linear_table();

const fn linear_table<const N: usize>() -> [f32; N] {
    let mut table = [0.0; N];
    let mut k = 0;
    while k < N {
        table[k] = srgb::linear(k as f64 / (N - 1) as f64) as f32;
        k += 1;
    }
    table
}

/// The weights of the first and second colour in sixths, a hexadecimal digit per code.
const FOUR: [u32; 2] = [0x2406, 0x4260];
const THREE: [u32; 2] = [0x0306, 0x0360];

/// The weights of the two colours in a texel, in sixths. `ends` are the colours, `codes` the 16 pairs
/// of bits.
#[inline(always)]
pub(crate) fn color_weights(ends: u32, codes: u32, at: u32, palette: Palette) -> [u32; 2] {
    let four = (ends & 0xFFFF > ends >> 16) | (palette == Palette::Four);
    let digit = 4 * (codes >> (2 * at) & 3);
    [
        (if four { FOUR[0] } else { THREE[0] }) >> digit & 15,
        (if four { FOUR[1] } else { THREE[1] }) >> digit & 15,
    ]
}

/// A texel's colour channel in sixths of its largest.
#[inline(always)]
pub(crate) fn color_sixths(ends: u32, [a, b]: [u32; 2], of: ColorChannel) -> u32 {
    a * (ends >> of.shift & of.largest) + b * (ends >> 16 >> of.shift & of.largest)
}

/// 0 at the transparent black, else 1.
#[inline(always)]
pub(crate) fn punched(ends: u32, codes: u32, at: u32) -> f32 {
    let three = ends & 0xFFFF <= ends >> 16;
    if three & (codes >> (2 * at) & 3 == 3) { 0.0 } else { 1.0 }
}

/// The 4 bits of a texel, over 15.
#[inline(always)]
pub(crate) fn explicit(low: u32, high: u32, at: u32) -> f32 {
    const WHOLE: [f32; 2] = reciprocal(15);
    let word = if at < 8 { low } else { high };
    quotient((word >> (4 * (at & 7)) & 15) as i32 as f32, WHOLE)
}

/// One stored channel of 64 texels. `words` are the block's, `within` is the texel in it: its
/// column plus 4 times its row, 0 to 15. 0 if the format is not compressed.
#[inline(always)]
pub fn decode_channel<S: Simd>(
    format: Format,
    channel: usize,
    words: &[U32s; 4],
    within: &U32s,
) -> F32s {
    let mut out = F32s::ZERO;
    let Some(block) = format.block() else { return out };
    let (code, first) = block.channel_code(channel);
    let (low, high) = (&words[first], &words[first + 1]);
    match code {
        ChannelCode::Color(of, palette) => {
            let mut sixths = U32s::ZERO;
            for lane in 0..LANES {
                let weights = color_weights(low[lane], high[lane], within[lane] & 15, palette);
                sixths[lane] = color_sixths(low[lane], weights, of);
            }
            if is_srgb_block(format) {
                return S::gather_f32(of.linear(), &sixths);
            }
            for lane in 0..LANES {
                out[lane] = of.fraction(sixths[lane]);
            }
        }
        ChannelCode::Punched => {
            for lane in 0..LANES {
                out[lane] = punched(low[lane], high[lane], within[lane] & 15);
            }
        }
        ChannelCode::Explicit => {
            for lane in 0..LANES {
                out[lane] = explicit(low[lane], high[lane], within[lane] & 15);
            }
        }
        ChannelCode::Interpolated(signedness) => {
            for lane in 0..LANES {
                out[lane] = interpolated(low[lane], high[lane], within[lane] & 15, signedness);
            }
        }
        ChannelCode::OfWholeTexels => {
            for lane in 0..LANES {
                let block = [0, 1, 2, 3].map(|word| words[word][lane]);
                out[lane] = whole_texel(format, block, within[lane] & 15)[channel];
            }
        }
    }
    out
}

/// The stored channels of 64 texels: see [`decode_channel`]. Only those of `out` are written.
#[inline(always)]
pub fn decode_lanes<S: Simd>(
    format: Format,
    words: &[U32s; 4],
    within: &U32s,
    out: &mut [F32s; 4],
) {
    if is_decoded_whole(format) {
        for lane in 0..LANES {
            let block = [0, 1, 2, 3].map(|word| words[word][lane]);
            let texel = whole_texel(format, block, within[lane] & 15);
            for (out, channel) in out.iter_mut().zip(texel).take(format.channels()) {
                out[lane] = channel;
            }
        }
        return;
    }
    for (channel, out) in out.iter_mut().enumerate().take(format.channels()) {
        *out = decode_channel::<S>(format, channel, words, within);
    }
}

/// Whether all channels of a texel are decoded together, which takes long: levels of such formats are decoded before they
/// are sampled.
pub(crate) const fn is_decoded_whole(format: Format) -> bool {
    match format.block() {
        Some(block) => block.is_bptc(),
        None => false,
    }
}

/// The format with the colours of texels of a format that is decoded whole.
pub(crate) const fn decoded_format(format: Format) -> Option<Format> {
    match format.info().encoding {
        Encoding::Block(Block::Bptc) => Some(Format::Rgba8),
        Encoding::SrgbBlock(Block::Bptc) => Some(Format::Srgb8A8),
        Encoding::Block(Block::BptcUnsignedFloat | Block::BptcSignedFloat) => Some(Format::Rgb16F),
        Encoding::Block(
            Block::Dxt1
            | Block::Dxt3
            | Block::Dxt5
            | Block::Rgtc1
            | Block::Rgtc1Snorm
            | Block::Rgtc2
            | Block::Rgtc2Snorm,
        )
        | Encoding::SrgbBlock(_)
        | Encoding::Unorm
        | Encoding::Snorm
        | Encoding::Srgb
        | Encoding::Float
        | Encoding::SharedExponent
        | Encoding::Uint
        | Encoding::Sint => None,
    }
}

/// The bits of a block, the lowest first.
fn bits_of(words: [u32; 4]) -> u128 {
    words.iter().rev().fold(0, |bits, word| bits << 32 | u128::from(*word))
}

/// The texel of a block in [`decoded_format`]: its bytes, little end first.
pub(crate) fn decoded_bytes(format: Format, words: [u32; 4], at: u32) -> [u8; 6] {
    let mut bytes = [0; 6];
    let block = bits_of(words);
    let sign = match format.block() {
        Some(Block::BptcUnsignedFloat) => FloatSign::Unsigned,
        Some(Block::BptcSignedFloat) => FloatSign::Signed,
        _ => {
            bytes[..4].copy_from_slice(&bptc::decode_unorm(block, at));
            return bytes;
        }
    };
    for (to, half) in bytes.chunks_exact_mut(2).zip(bptc::decode_floats(block, at, sign)) {
        to.copy_from_slice(&(half as u16).to_le_bytes());
    }
    bytes
}

/// The stored channels of a texel of a format that is decoded whole.
fn whole_texel(format: Format, words: [u32; 4], at: u32) -> [f32; 4] {
    const BYTE: [f32; 2] = reciprocal(255);
    let bytes = decoded_bytes(format, words, at);
    if format.block() == Some(Block::Bptc) {
        return [0, 1, 2, 3].map(|channel| match format.is_srgb_channel(channel) {
            true => srgb::DECODE[usize::from(bytes[channel])],
            false => quotient(f32::from(bytes[channel]), BYTE),
        });
    }
    let half = |at: usize| u32::from(bytes[at]) | u32::from(bytes[at + 1]) << 8;
    let [red, green, blue] = [0, 2, 4].map(|at| small_float::decode_half(half(at)));
    [red, green, blue, 0.0]
}

/// The stored channels of one texel of a block; unused ones 0.
pub(crate) fn decode_channels(format: Format, words: [u32; 4], within: u32) -> [f32; 4] {
    let mut out = [0.0; 4];
    let Some(block) = format.block() else { return out };
    let at = within & 15;
    if is_decoded_whole(format) {
        return whole_texel(format, words, at);
    }
    for (channel, out) in out.iter_mut().enumerate().take(format.channels()) {
        let (code, first) = block.channel_code(channel);
        let (low, high) = (words[first], words[first + 1]);
        *out = match code {
            ChannelCode::Color(of, palette) => {
                let sixths = color_sixths(low, color_weights(low, high, at, palette), of);
                if is_srgb_block(format) {
                    of.linear()[sixths as usize]
                } else {
                    of.fraction(sixths)
                }
            }
            ChannelCode::Punched => punched(low, high, at),
            ChannelCode::Explicit => explicit(low, high, at),
            ChannelCode::Interpolated(signedness) => interpolated(low, high, at, signedness),
            ChannelCode::OfWholeTexels => whole_texel(format, words, at)[channel],
        };
    }
    out
}

/// The colour of one texel of a block (0 to 15: column plus 4 times row), as a sample returns it.
pub fn decode(format: Format, block: &[u8], within: u32) -> [f32; 4] {
    let words = words_of(format, block);
    expand(format.base(), decode_channels(format, words, within))
}

#[cfg(test)]
mod tests;
