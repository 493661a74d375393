//! BPTC of fixed-point colours (`ARB_texture_compression_bptc`, also known as BC7): lines between two colours, for one to
//! three subsets of the texels, in eight modes; and of floats ([`floats`]).

mod encode;
mod floats;
mod subsets;

pub(super) use encode::encode_unorm;
pub(super) use floats::{FloatSign, decode as decode_floats, encode as encode_floats};

use subsets::{Subsets, index, weight};

/// Bits that are below the others of the ends, and the same in all channels of an end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum PBits {
    None,
    /// One for both ends of a subset.
    Shared,
    /// One for each end.
    Each,
}

/// How the bits of a mode are divided.
#[derive(Clone, Copy, Debug)]
struct Mode {
    subsets: u32,
    partition: u32,
    rotation: u32,
    selection: u32,
    color: u32,
    alpha: u32,
    p: PBits,
    index: u32,
    second_index: u32,
}

#[expect(clippy::too_many_arguments, reason = "the columns of the specification's table")]
const fn mode(
    subsets: u32,
    partition: u32,
    rotation: u32,
    selection: u32,
    color: u32,
    alpha: u32,
    p: PBits,
    index: u32,
    second_index: u32,
) -> Mode {
    Mode { subsets, partition, rotation, selection, color, alpha, p, index, second_index }
}

/// By the number of zero bits that a block begins with.
const MODES: [Mode; 8] = [
    mode(3, 4, 0, 0, 4, 0, PBits::Each, 3, 0),
    mode(2, 6, 0, 0, 6, 0, PBits::Shared, 3, 0),
    mode(3, 6, 0, 0, 5, 0, PBits::None, 2, 0),
    mode(2, 6, 0, 0, 7, 0, PBits::Each, 2, 0),
    mode(1, 0, 2, 1, 5, 6, PBits::None, 2, 3),
    mode(1, 0, 2, 0, 7, 8, PBits::None, 2, 2),
    mode(1, 0, 0, 0, 7, 7, PBits::Each, 4, 0),
    mode(2, 6, 0, 0, 5, 5, PBits::Each, 2, 0),
];

/// Takes bits from the lowest on.
struct Bits {
    block: u128,
    at: u32,
}

impl Bits {
    fn take(&mut self, count: u32) -> u32 {
        let bits = (self.block >> self.at) as u32 & ((1 << count) - 1);
        self.at += count;
        bits
    }
}

/// A number of so many bits as one of eight, its highest bits again below.
const fn widened(bits: u32, count: u32) -> u32 {
    bits << (8 - count) | bits >> (2 * count - 8)
}

/// The number between two ends, in 64ths of the second.
pub(super) const fn between([first, second]: [i32; 2], weight: i32) -> i32 {
    ((64 - weight) * first + weight * second + 32) >> 6
}

/// The bytes of a texel, 0 to 15: red, green, blue, alpha. All are 0 where the block has no mode.
pub(super) fn decode_unorm(block: u128, at: u32) -> [u8; 4] {
    let number = block.trailing_zeros();
    let Some(mode) = MODES.get(number as usize) else { return [0; 4] };
    let mut bits = Bits { block, at: number + 1 };
    let partition = bits.take(mode.partition) as usize;
    let subsets = match mode.subsets {
        1 => Subsets::One,
        2 => Subsets::Two(partition),
        _ => Subsets::Three(partition),
    };
    let (rotation, selection) = (bits.take(mode.rotation), bits.take(mode.selection));
    let own = subsets.of(at);
    // By channel: of all ends, those of the texel's subset.
    let mut ends = [[255_u32; 2]; 4];
    let bits_of = |channel: usize| if channel == 3 { mode.alpha } else { mode.color };
    for (channel, own_ends) in ends.iter_mut().enumerate().filter(|(at, _)| bits_of(*at) > 0) {
        for subset in 0..subsets.count() {
            let pair = [bits.take(bits_of(channel)), bits.take(bits_of(channel))];
            if subset == own {
                *own_ends = pair;
            }
        }
    }
    let mut p = [0; 2];
    for subset in 0..subsets.count() {
        let pair = match mode.p {
            PBits::None => [0; 2],
            PBits::Shared => [bits.take(1); 2],
            PBits::Each => [bits.take(1), bits.take(1)],
        };
        if subset == own {
            p = pair;
        }
    }
    for (channel, pair) in ends.iter_mut().enumerate().filter(|(at, _)| bits_of(*at) > 0) {
        for (value, p) in pair.iter_mut().zip(p) {
            *value = match mode.p {
                PBits::None => widened(*value, bits_of(channel)),
                PBits::Shared | PBits::Each => widened(*value << 1 | p, bits_of(channel) + 1),
            };
        }
    }
    let first = index(block, bits.at, mode.index, subsets, at);
    let mut weights = [weight(mode.index, first); 2];
    if mode.second_index > 0 {
        let from = bits.at + 16 * mode.index - mode.subsets;
        let second = index(block, from, mode.second_index, subsets, at);
        weights[1] = weight(mode.second_index, second);
        if selection == 1 {
            weights.swap(0, 1);
        }
    }
    let [colors, alphas] = weights;
    let mut texel = [0, 1, 2, 3].map(|channel| {
        let weight = if channel == 3 { alphas } else { colors };
        between(ends[channel].map(|end| end as i32), weight) as u8
    });
    if rotation > 0 {
        texel.swap(rotation as usize - 1, 3);
    }
    texel
}
