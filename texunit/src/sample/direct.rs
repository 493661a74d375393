//! The kernel of nearest lookups of which all but the coordinates is known with the plan: from coordinates in registers
//! to the components that are used, in registers. Same bits as [`super::uniform`].

#[cfg(test)]
mod tests;

use super::fast::{byte_offsets, bytes_of_texel, channel_of_texel, nearest_texels};
use super::level_view::LevelView;
use super::uniform_levels::plane_view;
use crate::format::{Component, Format};
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s, lane_x, lane_y};
use crate::plan::{DirectNearest, TexelClass, Texture};
use crate::sampler::Filter;

/// Lanes at the corners of the 8×8 pixels of a batch.
const CORNERS: [usize; 4] = [0, 19, 44, 63];
const _: () = {
    let mut at = 0;
    while at < CORNERS.len() {
        let lane = CORNERS[at];
        assert!(lane_x(lane) == at % 2 * 7 && lane_y(lane) == at / 2 * 7);
        at += 1;
    }
};

/// Texels along a side of the square whose texels are read as rows.
const SIDE: u32 = 8;

/// One lookup of 64 lanes.
pub(crate) struct DirectLookup<'a> {
    pub texture: &'a Texture,
    pub nearest: &'a DirectNearest,
    pub registers: &'a mut [U32s],
    /// The registers of s and t.
    pub coords: [usize; 2],
    /// The registers of the components that are used.
    pub out: [Option<usize>; 4],
}

impl Kernel for DirectLookup<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { texture, nearest, registers, coords: [s, t], out } = self;
        let view = plane_view(texture, Filter::Nearest, nearest.level);
        let words = words::<S>(&view, [registers[s].as_f32(), registers[t].as_f32()]);
        let [r, g, b, a] = nearest.components;
        match nearest.class {
            // Not in a loop, out of which the channels that are not used would be moved.
            TexelClass::Bytes => {
                write_bytes(registers, out[0], r, &words);
                write_bytes(registers, out[1], g, &words);
                write_bytes(registers, out[2], b, &words);
                write_bytes(registers, out[3], a, &words);
            }
            TexelClass::Srgb
            | TexelClass::Halves
            | TexelClass::Floats
            | TexelClass::Depth { .. } => {
                let (format, words) = (texture.format, &words);
                S::outlined(WriteChannels { nearest, format, words, registers, out });
            }
        }
    }
}

/// Writes a component of texels whose channels are bytes, if it is used.
#[inline(always)]
fn write_bytes(
    registers: &mut [U32s],
    register: Option<usize>,
    component: Component,
    words: &U32s,
) {
    let Some(register) = register else { return };
    let out = registers[register].as_f32_mut();
    match component {
        Component::Stored(channel) => bytes_of_texel(channel, words, out),
        Component::Zero => *out = F32s::ZERO,
        Component::One => *out = F32s::splat(1.0),
    }
}

/// Writes the components that are used.
struct WriteChannels<'a> {
    nearest: &'a DirectNearest,
    format: Format,
    words: &'a U32s,
    registers: &'a mut [U32s],
    out: [Option<usize>; 4],
}

impl Kernel for WriteChannels<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { nearest, format, words, registers, out } = self;
        for (register, component) in out.into_iter().zip(nearest.components) {
            let Some(register) = register else { continue };
            let out = registers[register].as_f32_mut();
            match component {
                Component::Stored(channel) => {
                    channel_of_texel::<S>((nearest.class, format), channel, words, out);
                }
                Component::Zero => *out = F32s::ZERO,
                Component::One => *out = F32s::splat(1.0),
            }
        }
    }
}

/// The words of the nearest texels.
#[inline(always)]
fn words<S: Simd>(view: &LevelView<'_>, at: [&F32s; 2]) -> U32s {
    let texels = nearest_texels::<S>(view, at);
    let ([x, y], level) = (&texels, view.level);
    if S::SELECTS_FROM_ROWS && level.format.bytes() == 4 && level.width >= SIDE {
        let left = CORNERS.map(|lane| x[lane]).into_iter().fold(level.width - SIDE, u32::min);
        let bottom = CORNERS.map(|lane| y[lane]).into_iter().fold(level.height - 1, u32::min);
        let (mut outside, mut numbers) = (U32s::ZERO, U32s::ZERO);
        for lane in 0..LANES {
            let (column, row) = (x[lane].wrapping_sub(left), y[lane].wrapping_sub(bottom));
            outside[lane] = column | row;
            numbers[lane] = row.wrapping_mul(SIDE).wrapping_add(column);
        }
        if S::below(&outside, SIDE) {
            let apart = level.row_bytes();
            let first = level.origin() + bottom as usize * apart + 4 * left as usize;
            let rows = (level.height - bottom).min(SIDE);
            return S::select_from_rows(&level.texels[first..], apart, rows, &numbers);
        }
    }
    S::gather_inline(&level.texels, &byte_offsets(level, &texels))
}
