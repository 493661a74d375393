//! BPTC of floats (`ARB_texture_compression_bptc`, also known as BC6H): lines between two colours of half floats, for one
//! or two subsets of the texels, in fourteen modes.

use super::between;
use super::subsets::{Subsets, index, weight};
use crate::format::small_float;
use crate::lanes::math::clamp;

/// Whether the half floats have a sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::format::block) enum FloatSign {
    Unsigned,
    Signed,
}

/// What the ends but the first are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ends {
    Whole,
    /// What is added to the first.
    Deltas,
}

/// Bits of an end, in the order of the block.
#[derive(Clone, Copy, Debug)]
struct Field {
    channel: u8,
    /// 0 and 1 are those of the first subset.
    end: u8,
    /// The lowest of the bits.
    low: u8,
    count: u8,
    /// Whether the highest comes first.
    reversed: bool,
}

const MOST_FIELDS: usize = 24;

/// How the bits of a mode are divided.
struct Mode {
    /// The bits that a block of it begins with.
    code: u8,
    ends: Ends,
    subsets: u8,
    /// Bits of the first end, and of the others by channel.
    first: u32,
    others: [u32; 3],
    fields: [Field; MOST_FIELDS],
    field_count: usize,
}

/// A mode with the fields of its ends as the specification writes them: the channel, the end (`w` is the first), the bits.
const fn mode(
    code: u8,
    ends: Ends,
    subsets: u8,
    first: u32,
    others: [u32; 3],
    fields: &str,
) -> Mode {
    const NONE: Field = Field { channel: 0, end: 0, low: 0, count: 0, reversed: false };
    let text = fields.as_bytes();
    let (mut all, mut count, mut at) = ([NONE; MOST_FIELDS], 0, 0);
    while at < text.len() {
        let channel = match text[at] {
            b'r' => 0,
            b'g' => 1,
            _ => 2,
        };
        let end = text[at + 1] - b'w';
        at += 2;
        let mut numbers = [0_u8; 2];
        let mut number = 0;
        while at < text.len() && text[at] != b' ' {
            if text[at] == b'-' {
                number = 1;
            } else {
                numbers[number] = numbers[number] * 10 + (text[at] - b'0');
            }
            at += 1;
        }
        at += 1;
        let [from, to] = if number == 0 { [numbers[0]; 2] } else { numbers };
        let reversed = to > from;
        let (low, high) = if reversed { (from, to) } else { (to, from) };
        all[count] = Field { channel, end, low, count: high - low + 1, reversed };
        count += 1;
    }
    Mode { code, ends, subsets, first, others, fields: all, field_count: count }
}

#[rustfmt::skip]
static MODES: [Mode; 14] = [
    mode(0b00000, Ends::Deltas, 2, 10, [5, 5, 5],
        "gy4 by4 bz4 rw9-0 gw9-0 bw9-0 rx4-0 gz4 gy3-0 gx4-0 bz0 gz3-0 bx4-0 bz1 by3-0 ry4-0 bz2 rz4-0 bz3"),
    mode(0b00001, Ends::Deltas, 2, 7, [6, 6, 6],
        "gy5 gz4 gz5 rw6-0 bz0 bz1 by4 gw6-0 by5 bz2 gy4 bw6-0 bz3 bz5 bz4 rx5-0 gy3-0 gx5-0 gz3-0 bx5-0 by3-0 ry5-0 rz5-0"),
    mode(0b00010, Ends::Deltas, 2, 11, [5, 4, 4],
        "rw9-0 gw9-0 bw9-0 rx4-0 rw10 gy3-0 gx3-0 gw10 bz0 gz3-0 bx3-0 bw10 bz1 by3-0 ry4-0 bz2 rz4-0 bz3"),
    mode(0b00011, Ends::Whole, 1, 10, [10, 10, 10],
        "rw9-0 gw9-0 bw9-0 rx9-0 gx9-0 bx9-0"),
    mode(0b00110, Ends::Deltas, 2, 11, [4, 5, 4],
        "rw9-0 gw9-0 bw9-0 rx3-0 rw10 gz4 gy3-0 gx4-0 gw10 gz3-0 bx3-0 bw10 bz1 by3-0 ry3-0 bz0 bz2 rz3-0 gy4 bz3"),
    mode(0b00111, Ends::Deltas, 1, 11, [9, 9, 9],
        "rw9-0 gw9-0 bw9-0 rx8-0 rw10 gx8-0 gw10 bx8-0 bw10"),
    mode(0b01010, Ends::Deltas, 2, 11, [4, 4, 5],
        "rw9-0 gw9-0 bw9-0 rx3-0 rw10 by4 gy3-0 gx3-0 gw10 bz0 gz3-0 bx4-0 bw10 by3-0 ry3-0 bz1 bz2 rz3-0 bz4 bz3"),
    mode(0b01011, Ends::Deltas, 1, 12, [8, 8, 8],
        "rw9-0 gw9-0 bw9-0 rx7-0 rw10-11 gx7-0 gw10-11 bx7-0 bw10-11"),
    mode(0b01110, Ends::Deltas, 2, 9, [5, 5, 5],
        "rw8-0 by4 gw8-0 gy4 bw8-0 bz4 rx4-0 gz4 gy3-0 gx4-0 bz0 gz3-0 bx4-0 bz1 by3-0 ry4-0 bz2 rz4-0 bz3"),
    mode(0b01111, Ends::Deltas, 1, 16, [4, 4, 4],
        "rw9-0 gw9-0 bw9-0 rx3-0 rw10-15 gx3-0 gw10-15 bx3-0 bw10-15"),
    mode(0b10010, Ends::Deltas, 2, 8, [6, 5, 5],
        "rw7-0 gz4 by4 gw7-0 bz2 gy4 bw7-0 bz3 bz4 rx5-0 gy3-0 gx4-0 bz0 gz3-0 bx4-0 bz1 by3-0 ry5-0 rz5-0"),
    mode(0b10110, Ends::Deltas, 2, 8, [5, 6, 5],
        "rw7-0 bz0 by4 gw7-0 gy5 gy4 bw7-0 gz5 bz4 rx4-0 gz4 gy3-0 gx5-0 gz3-0 bx4-0 bz1 by3-0 ry4-0 bz2 rz4-0 bz3"),
    mode(0b11010, Ends::Deltas, 2, 8, [5, 5, 6],
        "rw7-0 bz1 by4 gw7-0 by5 gy4 bw7-0 bz5 bz4 rx4-0 gz4 gy3-0 gx4-0 bz0 gz3-0 bx5-0 by3-0 ry4-0 bz2 rz4-0 bz3"),
    mode(0b11110, Ends::Whole, 2, 6, [6, 6, 6],
        "rw5-0 gz4 bz0 bz1 by4 gw5-0 gy5 by5 bz2 gy4 bw5-0 gz5 bz3 bz5 bz4 rx5-0 gy3-0 gx5-0 gz3-0 bx5-0 by3-0 ry5-0 rz5-0"),
];

/// The mode of a block, and how many bits say it; `None` of a code that stands for none.
fn mode_of(block: u128) -> Option<(&'static Mode, u32)> {
    let count = if block & 3 < 2 { 2 } else { 5 };
    let code = (block & ((1 << count) - 1)) as u8;
    let found = MODES.iter().find(|mode| mode.code == code && (code < 2) == (count == 2));
    found.map(|mode| (mode, count))
}

/// Bits as a number with a sign.
const fn signed(bits: u32, count: u32) -> i32 {
    ((bits << (32 - count)) as i32) >> (32 - count)
}

/// The number of 16 or 17 bits that an end of so many bits stands for.
const fn unquantized(end: i32, count: u32, sign: FloatSign) -> i32 {
    match sign {
        FloatSign::Unsigned => {
            if count >= 15 || end == 0 {
                end
            } else if end == (1 << count) - 1 {
                0xFFFF
            } else {
                ((end << 16) + 0x8000) >> count
            }
        }
        FloatSign::Signed => {
            let size = end.abs();
            let number = if count >= 16 || size == 0 {
                size
            } else if size >= (1 << (count - 1)) - 1 {
                0x7FFF
            } else {
                ((size << 15) + 0x4000) >> (count - 1)
            };
            if end < 0 { -number } else { number }
        }
    }
}

/// The bits of the half float that a number between two ends stands for.
const fn finished(number: i32, sign: FloatSign) -> u32 {
    match sign {
        FloatSign::Unsigned => ((number * 31) >> 6) as u32,
        FloatSign::Signed if number < 0 => 0x8000 | ((-number * 31) >> 5) as u32,
        FloatSign::Signed => ((number * 31) >> 5) as u32,
    }
}

/// The half floats of a texel, 0 to 15: red, green, blue. All are 0 where the block has no mode.
pub(in crate::format::block) fn decode(block: u128, at: u32, sign: FloatSign) -> [u32; 3] {
    let Some((mode, mut next)) = mode_of(block) else { return [0; 3] };
    let mut ends = [[0_u32; 3]; 4];
    for field in &mode.fields[..mode.field_count] {
        for bit in 0..field.count {
            let place = if field.reversed { field.count - 1 - bit } else { bit };
            let value = (block >> (next + u32::from(bit))) as u32 & 1;
            let end = &mut ends[usize::from(field.end)][usize::from(field.channel)];
            *end |= value << (field.low + place);
        }
        next += u32::from(field.count);
    }
    let subsets = match mode.subsets {
        1 => Subsets::One,
        _ => {
            let partition = (block >> next) as usize & 31;
            next += 5;
            Subsets::Two(partition)
        }
    };
    let bits = if mode.subsets == 1 { 4 } else { 3 };
    let weight = weight(bits, index(block, next, bits, subsets, at));
    let own = 2 * subsets.of(at);
    [0, 1, 2].map(|channel| {
        let first = ends[0][channel];
        let pair = [own, own + 1].map(|end| {
            let whole = match (end, mode.ends) {
                (0, _) | (_, Ends::Whole) => ends[end][channel],
                (_, Ends::Deltas) => {
                    let delta = signed(ends[end][channel], mode.others[channel]);
                    first.wrapping_add(delta as u32) & ((1 << mode.first) - 1)
                }
            };
            let end = match sign {
                FloatSign::Unsigned => whole as i32,
                FloatSign::Signed => signed(whole, mode.first),
            };
            unquantized(end, mode.first, sign)
        });
        finished(between(pair, weight), sign)
    })
}

/// Bits of an end of the mode that is encoded.
const END_BITS: u32 = 10;

/// The number that is decoded to the half float nearest to a colour.
fn number_of(color: f32, sign: FloatSign) -> i32 {
    const MOST: f32 = 65_504.0;
    let least = if sign == FloatSign::Signed { -MOST } else { 0.0 };
    let color = if color.is_nan() { 0.0 } else { color };
    let half = small_float::encode_half(clamp(color, least, MOST)) as i32;
    let (size, shift) = (half & 0x7FFF, if sign == FloatSign::Signed { 5 } else { 6 });
    // The middle of the numbers that are decoded to it.
    let number = ((size << shift) + (1 << (shift - 1))) / 31;
    if half & 0x8000 != 0 { -number } else { number }
}

/// The end that stands for the number nearest to this one.
fn quantized(number: i32, sign: FloatSign) -> i32 {
    let (low, high, near) = match sign {
        FloatSign::Unsigned => (0, (1 << END_BITS) - 1, number >> 6),
        FloatSign::Signed => (-511, 511, number >> 6),
    };
    let error = |end: &i32| (unquantized(*end, END_BITS, sign) - number).abs();
    (near - 1..=near + 1).map(|end| end.clamp(low, high)).min_by_key(error).unwrap_or(0)
}

/// The block of 16 colours (column plus 4 times row): one line between two ends of 10 bits. Not a number is 0.
pub(in crate::format::block) fn encode(colors: &[[f32; 4]; 16], sign: FloatSign) -> u128 {
    let numbers = colors.map(|color| [0, 1, 2].map(|channel| number_of(color[channel], sign)));
    let ends = super::encode::widest_line(&numbers);
    let mut ends = ends.map(|end| end.map(|number| quantized(number, sign)));
    let line = |ends: &[[i32; 3]; 2], index: u32| {
        [0, 1, 2].map(|channel| {
            let pair = [0, 1].map(|end| unquantized(ends[end][channel], END_BITS, sign));
            between(pair, weight(4, index))
        })
    };
    let mut indices = numbers.map(|wanted| super::encode::nearest(&wanted, 16, |i| line(&ends, i)));
    // The first index has no highest bit.
    if indices[0] >= 8 {
        ends.swap(0, 1);
        indices = indices.map(|index| 15 - index);
    }
    let mut block = 0b00011_u128;
    for (number, end) in ends.as_flattened().iter().enumerate() {
        block |= u128::from(*end as u32 & ((1 << END_BITS) - 1)) << (5 + 10 * number);
    }
    for (at, index) in indices.into_iter().enumerate() {
        block |= u128::from(index) << if at == 0 { 65 } else { 64 + 4 * at };
    }
    block
}
