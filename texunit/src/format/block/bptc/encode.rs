//! Compressing a block: a line through the block's widest direction, of colours and alphas together (mode 6), or apart
//! (mode 5), whichever is nearer. One colour is exact.

use super::subsets::weight;
use super::{between, decode_unorm, widened};
use crate::lanes::math::{clamp, round_even};

/// The two of 16 points that are farthest apart along their widest direction.
pub(super) fn widest_line<const N: usize>(points: &[[i32; N]; 16]) -> [[i32; N]; 2] {
    let mut low = points[0];
    let mut high = points[0];
    for point in points {
        for (channel, &value) in point.iter().enumerate() {
            low[channel] = low[channel].min(value);
            high[channel] = high[channel].max(value);
        }
    }
    let width = |channel: usize| i64::from(high[channel]) - i64::from(low[channel]);
    let widest = (0..N).fold(0, |best, c| if width(c) > width(best) { c } else { best });
    // Each channel turned to rise with the widest.
    let doubled = |point: &[i32; N], c: usize| {
        2 * i64::from(point[c]) - i64::from(low[c]) - i64::from(high[c])
    };
    let axis: [i64; N] = std::array::from_fn(|c| {
        let rise: i128 =
            points.iter().map(|p| i128::from(doubled(p, c)) * i128::from(doubled(p, widest))).sum();
        if rise < 0 { -width(c) } else { width(c) }
    });
    let along = |point: &[i32; N]| -> i128 {
        point.iter().zip(axis).map(|(value, axis)| i128::from(*value) * i128::from(axis)).sum()
    };
    let mut ends = [points[0]; 2];
    for point in points {
        if along(point) < along(&ends[0]) {
            ends[0] = *point;
        }
        if along(point) > along(&ends[1]) {
            ends[1] = *point;
        }
    }
    ends
}

/// The index, below `count`, of the point of a line that is nearest.
pub(super) fn nearest<const N: usize>(
    wanted: &[i32; N],
    count: u32,
    line: impl Fn(u32) -> [i32; N],
) -> u32 {
    let distance = |index: &u32| -> i64 {
        let point = line(*index);
        point.iter().zip(wanted).map(|(a, b)| i64::from(a - b).pow(2)).sum()
    };
    (0..count).min_by_key(distance).unwrap_or(0)
}

/// A byte of a colour from 0 to 1; not a number is 0.
fn byte(color: f32) -> i32 {
    round_even(clamp(color, 0.0, 1.0) * 255.0) as i32
}

/// The block of 16 colours (column plus 4 times row), clamped to 0 to 1.
pub(in crate::format::block) fn encode_unorm(colors: &[[f32; 4]; 16]) -> u128 {
    let bytes = colors.map(|color| color.map(byte));
    if bytes.iter().all(|texel| *texel == bytes[0]) {
        return one_color(bytes[0]);
    }
    let error = |block: &u128| -> i64 {
        let texels = (0_u32..).zip(&bytes);
        texels
            .flat_map(|(at, texel)| decode_unorm(*block, at).into_iter().zip(*texel))
            .map(|(got, wanted)| (i64::from(got) - i64::from(wanted)).pow(2))
            .sum()
    };
    let together = line_of_both(&bytes);
    let apart = lines_apart(&bytes);
    if error(&apart) < error(&together) { apart } else { together }
}

/// The byte that seven bits stand for.
fn whole(bits: i32) -> i32 {
    widened(bits as u32, 7) as i32
}

/// The seven bits that stand for the byte nearest to this one.
fn seven(byte: i32) -> i32 {
    let near = (byte / 2 - 1).max(0)..=(byte / 2 + 1).min(127);
    near.min_by_key(|bits| (whole(*bits) - byte).abs()).unwrap_or(0)
}

/// Ends of seven bits of which the first third is a byte exactly.
fn ends_around(byte: i32) -> [i32; 2] {
    let near = seven(byte);
    let others = [near, (near - 1).max(0), (near + 1).min(127)];
    let pairs = others.into_iter().flat_map(|other| [[near, other], [other, near]]);
    let is_exact = |ends: &[i32; 2]| between(ends.map(whole), weight(2, 1)) == byte;
    pairs.into_iter().find(is_exact).unwrap_or([near; 2])
}

/// Mode 5: the colour lies on the first third of the line between two of seven bits.
fn one_color(color: [i32; 4]) -> u128 {
    let mut block = 1_u128 << 5;
    let mut at = 8;
    for byte in &color[..3] {
        for end in ends_around(*byte) {
            block |= u128::from(end as u32) << at;
            at += 7;
        }
    }
    let alpha = color[3] as u32;
    block |= u128::from(alpha | alpha << 8) << at;
    at += 16;
    // Every index of the colours is 1; the first has one bit.
    block | u128::from(0x2AAA_AAAB_u32) << at
}

/// Mode 6: ends of 7 bits a channel and one below, which all channels of an end share.
fn line_of_both(bytes: &[[i32; 4]; 16]) -> u128 {
    let mut ends = widest_line(bytes).map(|end| {
        let with = |p: i32| end.map(|value| ((value + 1 - p) / 2).clamp(0, 127) << 1 | p);
        let error = |found: &[i32; 4]| -> i32 {
            found.iter().zip(end).map(|(found, value)| (found - value).pow(2)).sum()
        };
        let [even, odd] = [with(0), with(1)];
        if error(&odd) < error(&even) { odd } else { even }
    });
    let line =
        |index: u32| [0, 1, 2, 3].map(|c| between([ends[0][c], ends[1][c]], weight(4, index)));
    let mut indices = bytes.map(|texel| nearest(&texel, 16, line));
    if indices[0] >= 8 {
        ends.swap(0, 1);
        indices = indices.map(|index| 15 - index);
    }
    let mut block = 1_u128 << 6;
    for channel in 0..4 {
        for (end, values) in ends.iter().enumerate() {
            block |= u128::from(values[channel] as u32 >> 1) << (7 + 14 * channel + 7 * end);
        }
    }
    for (end, values) in ends.iter().enumerate() {
        block |= u128::from(values[0] as u32 & 1) << (63 + end);
    }
    for (at, index) in indices.into_iter().enumerate() {
        block |= u128::from(index) << if at == 0 { 65 } else { 64 + 4 * at };
    }
    block
}

/// Mode 5: colours of 7 bits a channel on one line, alphas of 8 bits on another.
fn lines_apart(bytes: &[[i32; 4]; 16]) -> u128 {
    let colors = bytes.map(|[r, g, b, _]| [r, g, b]);
    let alphas = bytes.map(|[.., a]| [a]);
    let mut ends = widest_line(&colors).map(|end| end.map(seven));
    let line = |index: u32| {
        [0, 1, 2].map(|c| between([whole(ends[0][c]), whole(ends[1][c])], weight(2, index)))
    };
    let mut color_indices = colors.map(|texel| nearest(&texel, 4, line));
    if color_indices[0] >= 2 {
        ends.swap(0, 1);
        color_indices = color_indices.map(|index| 3 - index);
    }
    let mut alpha_ends = widest_line(&alphas);
    let line = |index: u32| [between([alpha_ends[0][0], alpha_ends[1][0]], weight(2, index))];
    let mut alpha_indices = alphas.map(|texel| nearest(&texel, 4, line));
    if alpha_indices[0] >= 2 {
        alpha_ends.swap(0, 1);
        alpha_indices = alpha_indices.map(|index| 3 - index);
    }
    let mut block = 1_u128 << 5;
    for channel in 0..3 {
        for (end, values) in ends.iter().enumerate() {
            block |= u128::from(values[channel] as u32) << (8 + 14 * channel + 7 * end);
        }
    }
    for (end, [alpha]) in alpha_ends.into_iter().enumerate() {
        block |= u128::from(alpha as u32) << (50 + 8 * end);
    }
    for (indices, from) in [(color_indices, 66), (alpha_indices, 97)] {
        for (at, index) in indices.into_iter().enumerate() {
            block |= u128::from(index) << if at == 0 { from } else { from + 2 * at - 1 };
        }
    }
    block
}
