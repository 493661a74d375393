//! Blocks of BPTC by the text of `ARB_texture_compression_bptc`: bit by bit, all of a block's ends first.

use crate::mutation::{Mutation, Variant};

/// The columns of the table of modes of fixed-point blocks: subsets, bits of the partition, of the rotation, of the index
/// selection, of a colour channel, of alpha; whether there is a P bit for each end, for each subset; bits of an index, of a
/// second one.
const MODES: [[u32; 10]; 8] = [
    [3, 4, 0, 0, 4, 0, 1, 0, 3, 0],
    [2, 6, 0, 0, 6, 0, 0, 1, 3, 0],
    [3, 6, 0, 0, 5, 0, 0, 0, 2, 0],
    [2, 6, 0, 0, 7, 0, 1, 0, 2, 0],
    [1, 0, 2, 1, 5, 6, 0, 0, 2, 3],
    [1, 0, 2, 0, 7, 8, 0, 0, 2, 2],
    [1, 0, 0, 0, 7, 7, 1, 0, 4, 0],
    [2, 6, 0, 0, 5, 5, 1, 0, 2, 0],
];

/// The subset of each texel, of two.
const TWO: [&str; 64] = [
    "0011001100110011",
    "0001000100010001",
    "0111011101110111",
    "0001001100110111",
    "0000000100010011",
    "0011011101111111",
    "0001001101111111",
    "0000000100110111",
    "0000000000010011",
    "0011011111111111",
    "0000000101111111",
    "0000000000010111",
    "0001011111111111",
    "0000000011111111",
    "0000111111111111",
    "0000000000001111",
    "0000100011101111",
    "0111000100000000",
    "0000000010001110",
    "0111001100010000",
    "0011000100000000",
    "0000100011001110",
    "0000000010001100",
    "0111001100110001",
    "0011000100010000",
    "0000100010001100",
    "0110011001100110",
    "0011011001101100",
    "0001011111101000",
    "0000111111110000",
    "0111000110001110",
    "0011100110011100",
    "0101010101010101",
    "0000111100001111",
    "0101101001011010",
    "0011001111001100",
    "0011110000111100",
    "0101010110101010",
    "0110100101101001",
    "0101101010100101",
    "0111001111001110",
    "0001001111001000",
    "0011001001001100",
    "0011101111011100",
    "0110100110010110",
    "0011110011000011",
    "0110011010011001",
    "0000011001100000",
    "0100111001000000",
    "0010011100100000",
    "0000001001110010",
    "0000010011100100",
    "0110110010010011",
    "0011011011001001",
    "0110001110011100",
    "0011100111000110",
    "0110110011001001",
    "0110001100111001",
    "0111111010000001",
    "0001100011100111",
    "0000111100110011",
    "0011001111110000",
    "0010001011101110",
    "0100010001110111",
];

/// Of three.
const THREE: [&str; 64] = [
    "0011001102212222",
    "0001001122112221",
    "0000200122112211",
    "0222002200110111",
    "0000000011221122",
    "0011001100220022",
    "0022002211111111",
    "0011001122112211",
    "0000000011112222",
    "0000111111112222",
    "0000111122222222",
    "0012001200120012",
    "0112011201120112",
    "0122012201220122",
    "0011011211221222",
    "0011200122002220",
    "0001001101121122",
    "0111001120012200",
    "0000112211221122",
    "0022002200221111",
    "0111011102220222",
    "0001000122212221",
    "0000001101220122",
    "0000110022102210",
    "0122012200110000",
    "0012001211222222",
    "0110122112210110",
    "0000011012211221",
    "0022110211020022",
    "0110011020022222",
    "0011012201220011",
    "0000200022112221",
    "0000000211221222",
    "0222002200120011",
    "0011001200220222",
    "0120012001200120",
    "0000111122220000",
    "0120120120120120",
    "0120201212010120",
    "0011220011220011",
    "0011112222000011",
    "0101010122222222",
    "0000000021212121",
    "0022112200221122",
    "0022001100220011",
    "0220122102201221",
    "0101222222220101",
    "0000212121212121",
    "0101010101012222",
    "0222011102220111",
    "0002111200021112",
    "0000211221122112",
    "0222011101110222",
    "0002111211120002",
    "0110011001102222",
    "0000000021122112",
    "0110011022222222",
    "0022001100110022",
    "0022112211220022",
    "0000000000002112",
    "0002000100020001",
    "0222122202221222",
    "0101222222222222",
    "0111201122012220",
];

/// The texels whose index is a bit shorter, a hexadecimal digit for each partition: of the second subset of two, of the second
/// and the third of three.
const ANCHORS: [&str; 3] = [
    "fffffffffffffffff282288f28228822ff6828ff28222ff66268ff22fffff22f",
    "33ff83ff88666533338f336a588685ff8f356a8ff3f5ffff3f55585a5a8dfc33",
    "f883ff38fffffff8f8f3f8f83f6affa8f3faa89a6f8f3668f3ffffffffff3ff8",
];

/// Modes of floats: the bits that say it (the highest first), whether ends are differences, subsets, bits of the first end, of
/// the others by channel; the bits of the ends in order.
type FloatMode = (&'static str, bool, u32, u32, [u32; 3], &'static str);

#[rustfmt::skip]
const FLOAT_MODES: [FloatMode; 14] = [
    ("00", true, 2, 10, [5, 5, 5], "gy4 by4 bz4 rw9-0 gw9-0 bw9-0 rx4-0 gz4 gy3-0 gx4-0 bz0 gz3-0 bx4-0 bz1 by3-0 ry4-0 bz2 rz4-0 bz3"),
    ("01", true, 2, 7, [6, 6, 6], "gy5 gz4 gz5 rw6-0 bz0 bz1 by4 gw6-0 by5 bz2 gy4 bw6-0 bz3 bz5 bz4 rx5-0 gy3-0 gx5-0 gz3-0 bx5-0 by3-0 ry5-0 rz5-0"),
    ("00010", true, 2, 11, [5, 4, 4], "rw9-0 gw9-0 bw9-0 rx4-0 rw10 gy3-0 gx3-0 gw10 bz0 gz3-0 bx3-0 bw10 bz1 by3-0 ry4-0 bz2 rz4-0 bz3"),
    ("00011", false, 1, 10, [10, 10, 10], "rw9-0 gw9-0 bw9-0 rx9-0 gx9-0 bx9-0"),
    ("00110", true, 2, 11, [4, 5, 4], "rw9-0 gw9-0 bw9-0 rx3-0 rw10 gz4 gy3-0 gx4-0 gw10 gz3-0 bx3-0 bw10 bz1 by3-0 ry3-0 bz0 bz2 rz3-0 gy4 bz3"),
    ("00111", true, 1, 11, [9, 9, 9], "rw9-0 gw9-0 bw9-0 rx8-0 rw10 gx8-0 gw10 bx8-0 bw10"),
    ("01010", true, 2, 11, [4, 4, 5], "rw9-0 gw9-0 bw9-0 rx3-0 rw10 by4 gy3-0 gx3-0 gw10 bz0 gz3-0 bx4-0 bw10 by3-0 ry3-0 bz1 bz2 rz3-0 bz4 bz3"),
    ("01011", true, 1, 12, [8, 8, 8], "rw9-0 gw9-0 bw9-0 rx7-0 rw10-11 gx7-0 gw10-11 bx7-0 bw10-11"),
    ("01110", true, 2, 9, [5, 5, 5], "rw8-0 by4 gw8-0 gy4 bw8-0 bz4 rx4-0 gz4 gy3-0 gx4-0 bz0 gz3-0 bx4-0 bz1 by3-0 ry4-0 bz2 rz4-0 bz3"),
    ("01111", true, 1, 16, [4, 4, 4], "rw9-0 gw9-0 bw9-0 rx3-0 rw10-15 gx3-0 gw10-15 bx3-0 bw10-15"),
    ("10010", true, 2, 8, [6, 5, 5], "rw7-0 gz4 by4 gw7-0 bz2 gy4 bw7-0 bz3 bz4 rx5-0 gy3-0 gx4-0 bz0 gz3-0 bx4-0 bz1 by3-0 ry5-0 rz5-0"),
    ("10110", true, 2, 8, [5, 6, 5], "rw7-0 bz0 by4 gw7-0 gy5 gy4 bw7-0 gz5 bz4 rx4-0 gz4 gy3-0 gx5-0 gz3-0 bx4-0 bz1 by3-0 ry4-0 bz2 rz4-0 bz3"),
    ("11010", true, 2, 8, [5, 5, 6], "rw7-0 bz1 by4 gw7-0 by5 gy4 bw7-0 bz5 bz4 rx4-0 gz4 gy3-0 gx4-0 bz0 gz3-0 bx5-0 by3-0 ry4-0 bz2 rz4-0 bz3"),
    ("11110", false, 2, 6, [6, 6, 6], "rw5-0 gz4 bz0 bz1 by4 gw5-0 gy5 by5 bz2 gy4 bw5-0 gz5 bz3 bz5 bz4 rx5-0 gy3-0 gx5-0 gz3-0 bx5-0 by3-0 ry5-0 rz5-0"),
];

const WEIGHTS: [&[i64]; 3] = [
    &[0, 21, 43, 64],
    &[0, 9, 18, 27, 37, 46, 55, 64],
    &[0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64],
];

/// The bits of a block in order.
struct Reader {
    bits: Vec<u8>,
    at: usize,
}

impl Reader {
    fn new(block: &[u8]) -> Self {
        let bits = block.iter().flat_map(|byte| (0..8).map(move |bit| byte >> bit & 1)).collect();
        Self { bits, at: 0 }
    }

    /// Reads a number of `count` bits. Bits beyond the block are 0: readers with a planted mistake read them.
    fn take(&mut self, count: u32) -> i64 {
        let bits = self.at..self.at + count as usize;
        self.at = bits.end;
        let bit = |at: usize| self.bits.get(at).map_or(0, |bit| i64::from(*bit));
        bits.rev().fold(0, |number, at| 2 * number + bit(at))
    }

    /// The indices of 16 texels.
    fn indices(&mut self, bits: u32, anchors: &[usize], variant: Variant) -> Vec<i64> {
        let shorter = |at: usize| anchors.contains(&at) && !variant.has(Mutation::BptcLongAnchors);
        let take = |at: usize| self.take(bits - u32::from(shorter(at)));
        (0..16).map(take).collect()
    }
}

fn subset(subsets: u32, partition: i64, at: usize) -> usize {
    let digits = match subsets {
        1 => return 0,
        2 => TWO[partition as usize],
        _ => THREE[partition as usize],
    };
    usize::from(digits.as_bytes()[at] - b'0')
}

fn anchors(subsets: u32, partition: i64) -> Vec<usize> {
    let digit = |table: usize| {
        let digit = char::from(ANCHORS[table].as_bytes()[partition as usize]).to_digit(16);
        digit.expect("hexadecimal") as usize
    };
    match subsets {
        1 => vec![0],
        2 => vec![0, digit(0)],
        _ => vec![0, digit(1), digit(2)],
    }
}

fn between(a: i64, b: i64, weight: i64) -> i64 {
    ((64 - weight) * a + weight * b + 32) >> 6
}

/// R, G, B and A of texel `at` of a block of bytes, sRGB-encoded or not.
pub fn decode(block: &[u8], at: usize, variant: Variant) -> [f64; 4] {
    let mut reader = Reader::new(block);
    let Some(number) = (0..8).position(|_| reader.take(1) == 1) else { return [0.0; 4] };
    let [subsets, partition, rotation, selection, color, alpha, each, shared, index, second] =
        MODES[number];
    let partition = reader.take(partition);
    let (rotation, selection) = (reader.take(rotation), reader.take(selection));
    let mut ends = vec![[0_i64; 4]; 2 * subsets as usize];
    for channel in 0..4 {
        for end in &mut ends {
            end[channel] = reader.take(if channel == 3 { alpha } else { color });
        }
    }
    let mut p: Vec<i64> = Vec::new();
    for end in 0..ends.len() {
        p.push(match (each, shared) {
            (1, _) => reader.take(1),
            (_, 1) if end % 2 == 0 => reader.take(1),
            (_, 1) => p[end - 1],
            (_, _) => 0,
        });
    }
    for (end, p) in ends.iter_mut().zip(&p) {
        for (channel, value) in end.iter_mut().enumerate() {
            let bits = if channel == 3 { alpha } else { color };
            let (number, bits) = match each + shared {
                _ if bits == 0 => (255, 8),
                0 => (*value, bits),
                _ if variant.has(Mutation::BptcWithoutPBits) => (2 * *value, bits + 1),
                _ => (2 * *value + p, bits + 1),
            };
            *value = number << (8 - bits) | number >> (2 * bits - 8);
        }
    }
    let first = reader.indices(index, &anchors(subsets, partition), variant)[at];
    let mut weights = [WEIGHTS[index as usize - 2][first as usize]; 2];
    if second > 0 {
        let index = reader.indices(second, &[0], variant)[at];
        weights[1] = WEIGHTS[second as usize - 2][index as usize];
        if selection == 1 {
            weights.reverse();
        }
    }
    let own = 2 * subset(subsets, partition, at);
    let mut texel: [i64; 4] = std::array::from_fn(|channel| {
        let weight = weights[usize::from(channel == 3)];
        between(ends[own][channel], ends[own + 1][channel], weight)
    });
    if rotation > 0 && !variant.has(Mutation::BptcWithoutRotation) {
        texel.swap(rotation as usize - 1, 3);
    }
    texel.map(|value| value as f64 / 255.0)
}

/// Whether half floats have a sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// They are not below 0.
    Unsigned,
    /// They have one.
    Signed,
}

/// A number with a sign of so many bits.
fn signed(number: i64, bits: u32) -> i64 {
    let number = number.rem_euclid(1 << bits);
    if number >= 1 << (bits - 1) { number - (1 << bits) } else { number }
}

/// R, G, B and A of texel `at` of a block of half floats.
pub fn decode_floats(block: &[u8], at: usize, sign: Sign, variant: Variant) -> [f64; 4] {
    let is_signed = sign == Sign::Signed;
    let mut reader = Reader::new(block);
    let code = |count: usize| -> String {
        reader.bits[..count].iter().rev().map(|bit| char::from(b'0' + bit)).collect()
    };
    let code = if reader.bits[1] == 0 { code(2) } else { code(5) };
    let found = FLOAT_MODES.iter().find(|mode| mode.0 == code);
    let Some(&(_, is_difference, subsets, first, others, fields)) = found else {
        return [0.0, 0.0, 0.0, 1.0];
    };
    reader.at = code.len();
    let mut ends = [[0_i64; 3]; 4];
    for field in fields.split(' ') {
        let channel = "rgb".find(&field[..1]).expect("a channel");
        let end = "wxyz".find(&field[1..2]).expect("an end");
        let (from, to) = field[2..].split_once('-').unwrap_or((&field[2..], &field[2..]));
        let [from, to]: [i64; 2] = [from, to].map(|bit| bit.parse().expect("a number"));
        // What is written first is the highest; where the order is turned, it comes first.
        let places: Vec<i64> =
            if from >= to { (to..=from).collect() } else { (from..=to).rev().collect() };
        for place in places {
            ends[end][channel] |= reader.take(1) << place;
        }
    }
    let partition = if subsets == 2 { reader.take(5) } else { 0 };
    let bits = if subsets == 2 { 3 } else { 4 };
    let index = reader.indices(bits, &anchors(subsets, partition), variant)[at];
    let weight = WEIGHTS[bits as usize - 2][index as usize];
    let own = 2 * subset(subsets, partition, at);
    let unquantized = |end: i64| -> i64 {
        let (size, bits) = if is_signed { (end.abs(), first - 1) } else { (end, first) };
        let most = if is_signed { 0x7FFF } else { 0xFFFF };
        let number = match size {
            _ if bits >= 15 => size,
            0 => 0,
            _ if size >= (1 << bits) - 1 => most,
            _ if is_signed => ((size << 15) + 0x4000) >> bits,
            _ => ((size << 16) + 0x8000) >> bits,
        };
        if end < 0 { -number } else { number }
    };
    let channel = |channel: usize| -> f64 {
        let pair = [own, own + 1].map(|end| {
            let whole = match end {
                0 => ends[0][channel],
                _ if is_difference && !variant.has(Mutation::BptcWholeEnds) => {
                    ends[0][channel] + signed(ends[end][channel], others[channel])
                }
                _ => ends[end][channel],
            };
            let whole = whole.rem_euclid(1 << first);
            unquantized(if is_signed { signed(whole, first) } else { whole })
        });
        let number = between(pair[0], pair[1], weight);
        let half = (number.abs() * 31) >> if is_signed { 5 } else { 6 };
        let (exponent, mantissa) = ((half >> 10) as i32, (half & 0x3FF) as f64);
        let size = match exponent {
            0 => mantissa * 2f64.powi(-24),
            _ => (1.0 + mantissa / 1024.0) * 2f64.powi(exponent - 15),
        };
        if number < 0 { -size } else { size }
    };
    [channel(0), channel(1), channel(2), 1.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_line_of_bytes_by_hand() {
        // Mode 6, all ends 0 but the second red, 127 and a P bit; index 15 in texel 1, else 0.
        let bits = 1_u128 << 6 | 127 << 14 | 1 << 64 | 15 << 68;
        let block = bits.to_le_bytes();
        assert_eq!(decode(&block, 0, Variant::CORRECT), [0.0; 4]);
        let [one, p] = [1.0, 1.0 / 255.0];
        assert_eq!(decode(&block, 1, Variant::CORRECT), [one, p, p, p]);
        assert_eq!(decode(&[0; 16], 1, Variant::CORRECT), [0.0; 4]);
    }

    #[test]
    fn floats_by_hand() {
        // Mode 3, ends of 10 bits: the largest, and 0; index 15 in texel 1.
        let bits = 3_u128 | 1023 << 35 | 15 << 68;
        let block = bits.to_le_bytes();
        let of = |at, sign| decode_floats(&block, at, sign, Variant::CORRECT);
        assert_eq!(of(0, Sign::Unsigned), [0.0, 0.0, 0.0, 1.0]);
        assert_eq!(of(1, Sign::Unsigned), [65504.0, 0.0, 0.0, 1.0]);
        // With a sign it is -1 of 511.
        assert!(of(1, Sign::Signed)[0] < 0.0);
    }
}
