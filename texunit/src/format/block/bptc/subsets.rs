//! The tables of BPTC: how 16 texels are divided into subsets (`ARB_texture_compression_bptc`, tables of partitions and of
//! anchors).

/// The texels of the second of two subsets, a bit each.
const SECOND_OF_TWO: [u16; 64] = [
    0xCCCC, 0x8888, 0xEEEE, 0xECC8, 0xC880, 0xFEEC, 0xFEC8, 0xEC80, 0xC800, 0xFFEC, 0xFE80, 0xE800,
    0xFFE8, 0xFF00, 0xFFF0, 0xF000, 0xF710, 0x008E, 0x7100, 0x08CE, 0x008C, 0x7310, 0x3100, 0x8CCE,
    0x088C, 0x3110, 0x6666, 0x366C, 0x17E8, 0x0FF0, 0x718E, 0x399C, 0xAAAA, 0xF0F0, 0x5A5A, 0x33CC,
    0x3C3C, 0x55AA, 0x9696, 0xA55A, 0x73CE, 0x13C8, 0x324C, 0x3BDC, 0x6996, 0xC33C, 0x9966, 0x0660,
    0x0272, 0x04E4, 0x4E40, 0x2720, 0xC936, 0x936C, 0x39C6, 0x639C, 0x9336, 0x9CC6, 0x817E, 0xE718,
    0xCCF0, 0x0FCC, 0x7744, 0xEE22,
];

/// The subset of each texel, of three, two bits each.
const OF_THREE: [u32; 64] = [
    0xAA685050, 0x6A5A5040, 0x5A5A4200, 0x5450A0A8, 0xA5A50000, 0xA0A05050, 0x5555A0A0, 0x5A5A5050,
    0xAA550000, 0xAA555500, 0xAAAA5500, 0x90909090, 0x94949494, 0xA4A4A4A4, 0xA9A59450, 0x2A0A4250,
    0xA5945040, 0x0A425054, 0xA5A5A500, 0x55A0A0A0, 0xA8A85454, 0x6A6A4040, 0xA4A45000, 0x1A1A0500,
    0x0050A4A4, 0xAAA59090, 0x14696914, 0x69691400, 0xA08585A0, 0xAA821414, 0x50A4A450, 0x6A5A0200,
    0xA9A58000, 0x5090A0A8, 0xA8A09050, 0x24242424, 0x00AA5500, 0x24924924, 0x24499224, 0x50A50A50,
    0x500AA550, 0xAAAA4444, 0x66660000, 0xA5A0A5A0, 0x50A050A0, 0x69286928, 0x44AAAA44, 0x66666600,
    0xAA444444, 0x54A854A8, 0x95809580, 0x96969600, 0xA85454A8, 0x80959580, 0xAA141414, 0x96960000,
    0xAAAA1414, 0xA05050A0, 0xA0A5A5A0, 0x96000000, 0x40804080, 0xA9A8A9A8, 0xAAAAAA44, 0x2A4A5254,
];

/// The texels with a shorter index: of the second of two subsets, of the second and of the third of three; a hexadecimal
/// digit each.
const ANCHOR_OF_TWO: &[u8; 64] =
    b"fffffffffffffffff282288f28228822ff6828ff28222ff66268ff22fffff22f";
const ANCHORS_OF_THREE: [&[u8; 64]; 2] = [
    b"33ff83ff88666533338f336a588685ff8f356a8ff3f5ffff3f55585a5a8dfc33",
    b"f883ff38fffffff8f8f3f8f83f6affa8f3faa89a6f8f3668f3ffffffffff3ff8",
];

/// How the texels of a block are divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Subsets {
    One,
    /// In two, by the number of the partition.
    Two(usize),
    /// In three.
    Three(usize),
}

const fn digit(digits: &[u8; 64], at: usize) -> u32 {
    let digit = digits[at & 63];
    (if digit < b'a' { digit - b'0' } else { digit - b'a' + 10 }) as u32
}

impl Subsets {
    /// How many there are.
    pub const fn count(self) -> usize {
        match self {
            Self::One => 1,
            Self::Two(_) => 2,
            Self::Three(_) => 3,
        }
    }

    /// That of a texel.
    pub const fn of(self, at: u32) -> usize {
        match self {
            Self::One => 0,
            Self::Two(partition) => (SECOND_OF_TWO[partition & 63] >> at & 1) as usize,
            Self::Three(partition) => (OF_THREE[partition & 63] >> (2 * at) & 3) as usize,
        }
    }

    /// The texels whose index has a bit less, which is 0; the first is texel 0.
    pub const fn anchors(self) -> [u32; 3] {
        match self {
            Self::One => [0, 16, 16],
            Self::Two(partition) => [0, digit(ANCHOR_OF_TWO, partition), 16],
            Self::Three(partition) => {
                [0, digit(ANCHORS_OF_THREE[0], partition), digit(ANCHORS_OF_THREE[1], partition)]
            }
        }
    }
}

/// The weights of the second end of a line, in 64ths, of indices of 2, 3 and 4 bits.
const WEIGHTS: [&[u32; 16]; 3] = [
    &[0, 21, 43, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
    &[0, 9, 18, 27, 37, 46, 55, 64, 0, 0, 0, 0, 0, 0, 0, 0],
    &[0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64],
];

/// The weight of an index of so many bits.
pub(super) const fn weight(bits: u32, index: u32) -> i32 {
    WEIGHTS[(bits - 2) as usize][(index & 15) as usize] as i32
}

/// The index of a texel; those of `bits` each begin at `from`.
pub(super) fn index(block: u128, from: u32, bits: u32, subsets: Subsets, at: u32) -> u32 {
    let anchors = subsets.anchors();
    let shorter = anchors.iter().filter(|anchor| **anchor < at).count() as u32;
    let own = bits - u32::from(anchors.contains(&at));
    (block >> (from + bits * at - shorter)) as u32 & ((1 << own) - 1)
}
