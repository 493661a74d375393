//! Compressing a block: a range fit.
//!
//! The ends of a line are the texels farthest apart along the block's widest direction; each texel
//! then takes the nearest of the values that the decoder makes from those ends. Deterministic and
//! quick, exact for a block of one colour that the format holds, and no match for an offline
//! compressor.

use super::bptc::{self, FloatSign};
use super::interpolated::{self, Signedness};
use super::{CHANNELS, ChannelCode, Palette, SIXTHS, color_sixths, color_weights, is_srgb_block};
use crate::format::words::bytes_of;
use crate::format::{Block, Format, srgb};
use crate::lanes::math::{clamp, round_even};

/// The block of 16 colours (column plus 4 times row), in its first [`Format::bytes`] bytes. All 0
/// if the format is not compressed. Below an alpha of 1/2 a texel of DXT1 is transparent.
pub fn encode(format: Format, texels: &[[f32; 4]; 16]) -> [u8; 16] {
    let mut words = [0_u32; 4];
    let Some(block) = format.block() else { return [0; 16] };
    let whole = match block {
        Block::Bptc if is_srgb_block(format) => Some(bptc::encode_unorm(&texels.map(|texel| {
            let [r, g, b] = [0, 1, 2].map(|c| f32::from(srgb::encode(texel[c])) / 255.0);
            [r, g, b, texel[3]]
        }))),
        Block::Bptc => Some(bptc::encode_unorm(texels)),
        Block::BptcUnsignedFloat => Some(bptc::encode_floats(texels, FloatSign::Unsigned)),
        Block::BptcSignedFloat => Some(bptc::encode_floats(texels, FloatSign::Signed)),
        Block::Dxt1
        | Block::Dxt3
        | Block::Dxt5
        | Block::Rgtc1
        | Block::Rgtc1Snorm
        | Block::Rgtc2
        | Block::Rgtc2Snorm => None,
    };
    if let Some(block) = whole {
        return block.to_le_bytes();
    }
    let sources = format.base().sources();
    let mut has_colors = None;
    for (channel, &source) in sources.iter().enumerate() {
        let values = texels.map(|texel| texel[source]);
        let (code, first) = block.channel_code(channel);
        match code {
            ChannelCode::Color(_, palette) => has_colors = Some((palette, first)),
            // Among the colours' codes; encoded above.
            ChannelCode::Punched | ChannelCode::OfWholeTexels => {}
            ChannelCode::Explicit => {
                for (at, value) in values.into_iter().enumerate() {
                    words[first + at / 8] |= to_integer(value, 15.0) << (4 * (at % 8));
                }
            }
            ChannelCode::Interpolated(signedness) => {
                [words[first], words[first + 1]] = fit_values(values, signedness);
            }
        }
    }
    if let Some((palette, first)) = has_colors {
        let transparent = match palette {
            Palette::ByOrder if sources.len() == 4 => {
                texels.map(|texel| texel[3].is_nan() || texel[3] < 0.5)
            }
            Palette::ByOrder | Palette::Four => [false; 16],
        };
        let colors = texels.map(|[r, g, b, _]| {
            [r, g, b].map(|c| {
                if is_srgb_block(format) {
                    f32::from(srgb::encode(c)) / 255.0
                } else {
                    clamp(c, 0.0, 1.0)
                }
            })
        });
        [words[first], words[first + 1]] = fit_colors(&colors, &transparent, palette);
    }
    bytes_of(words)
}

/// The nearest of 0 to `largest`; clamps, NaN gives 0.
fn to_integer(x: f32, largest: f32) -> u32 {
    round_even(clamp(x, 0.0, 1.0) * largest) as u32
}

/// The two ends and the codes of a line of colours.
fn fit_colors(colors: &[[f32; 3]; 16], transparent: &[bool; 16], palette: Palette) -> [u32; 2] {
    let opaque = || colors.iter().zip(transparent).filter(|&(_, &hidden)| !hidden).map(|(c, _)| *c);
    let [low, high] = opaque().fold([[1.0_f32; 3], [0.0; 3]], |[low, high], color| {
        [0, 1].map(|end| {
            [0, 1, 2].map(|c| if end == 0 { low[c].min(color[c]) } else { high[c].max(color[c]) })
        })
    });
    // The direction from the least to the greatest, each channel turned to rise with the widest.
    let width = [0, 1, 2].map(|c| high[c] - low[c]);
    let widest = (0..3).fold(0, |best, c| if width[c] > width[best] { c } else { best });
    let middle = [0, 1, 2].map(|c| (low[c] + high[c]) / 2.0);
    let axis = [0, 1, 2].map(|c| {
        let rise: f32 = opaque().map(|x| (x[c] - middle[c]) * (x[widest] - middle[widest])).sum();
        if rise < 0.0 { -width[c] } else { width[c] }
    });
    let along = |x: [f32; 3]| (x[0] * axis[0] + x[1] * axis[1] + x[2] * axis[2], x);
    let first = opaque().map(along).reduce(|a, b| if b.0 < a.0 { b } else { a });
    let last = opaque().map(along).reduce(|a, b| if b.0 > a.0 { b } else { a });
    let pack = |color: Option<(f32, [f32; 3])>| {
        let color = color.map_or([0.0; 3], |(_, color)| color);
        CHANNELS.iter().zip(color).fold(0, |bits, (channel, value)| {
            bits | to_integer(value, channel.largest as f32) << channel.shift
        })
    };
    let (a, b) = (pack(first), pack(last));
    // The order chooses the palette: four colours where the first is larger.
    let three = palette == Palette::ByOrder && transparent.contains(&true);
    let (smaller, larger) = if a < b { (a, b) } else { (b, a) };
    let ends = if three { smaller | larger << 16 } else { larger | smaller << 16 };
    // Black of the three-colour palette is transparent where alpha is stored: never take it.
    let usable = if ends & 0xFFFF > ends >> 16 || palette == Palette::Four { 4 } else { 3 };
    // The nearest so far, and how far it is.
    let (mut nearest, mut least) = ([0; 16], [f32::INFINITY; 16]);
    for code in 0..usable {
        let weights = color_weights(ends, code, 0, palette);
        let of = CHANNELS.map(|channel| {
            let sixths = color_sixths(ends, weights, channel);
            sixths as f32 / (SIXTHS * channel.largest) as f32
        });
        for at in 0..16 {
            let [r, g, b] = [0, 1, 2].map(|c| (of[c] - colors[at][c]) * (of[c] - colors[at][c]));
            let distance = r + g + b;
            let is_nearer = distance < least[at];
            nearest[at] = if is_nearer { code } else { nearest[at] };
            least[at] = if is_nearer { distance } else { least[at] };
        }
    }
    let codes = (0..16)
        .fold(0, |codes, at| codes | if transparent[at] { 3 } else { nearest[at] } << (2 * at));
    [ends, codes]
}

/// The two ends and the codes of a line of values.
fn fit_values(values: [f32; 16], signedness: Signedness) -> [u32; 2] {
    let [smallest, largest] = signedness.range().map(|end| end as f32);
    let values = values.map(|x| {
        let number = if x.is_nan() { 0.0 } else { x };
        clamp(number, smallest / largest, 1.0)
    });
    let byte = |x: f32| (round_even(x * largest) as i32 & 0xFF) as u32;
    let low = values.into_iter().fold(1.0, f32::min);
    let high = values.into_iter().fold(smallest / largest, f32::max);
    // The larger first: eight values; or both alike, where code 0 is exact.
    let first = byte(high) | byte(low) << 8;
    let palette = std::array::from_fn::<_, 8, _>(|code| {
        interpolated::decode(first | (code as u32) << 16, 0, 0, signedness)
    });
    let mut bits = u64::from(first);
    for (at, value) in values.into_iter().enumerate() {
        let code = nearest(&palette, |of| (of - value).abs());
        bits |= u64::from(code) << (16 + 3 * at);
    }
    [bits as u32, (bits >> 32) as u32]
}

/// The code of what has the smallest distance; the first of equals.
fn nearest<T>(palette: &[T], distance: impl Fn(&T) -> f32) -> u32 {
    let Some((first, rest)) = palette.split_first() else { return 0 };
    let first = (distance(first), 0);
    let (_, code) = (1..).zip(rest).fold(first, |best, (code, of)| {
        let current = distance(of);
        if current < best.0 { (current, code) } else { best }
    });
    code
}
