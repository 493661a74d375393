//! The kernel of nearest lookups of which all but the coordinates is known with the plan: from coordinates in registers
//! to the components that are used, in registers. Same bits as [`super::uniform`].

#[cfg(test)]
mod tests;

use super::fast::{byte_offsets, bytes_of_texel, channel_of_texel, nearest_along};
use super::level_view::LevelView;
use super::scratch::{AxisTexels, KEPT_AXES, KeptAxes};
use super::uniform_levels::plane_view;
use crate::format::convert::byte_channel;
use crate::format::{Component, Format};
use crate::image::Level;
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
    /// Whether the texels along s and t are computed.
    pub axes: [AxisTexels; 2],
    pub kept: &'a mut KeptAxes,
    /// The registers of the components that are used.
    pub out: [Option<usize>; 4],
}

impl Kernel for DirectLookup<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { texture, nearest, registers, coords, axes, kept, out } = self;
        let view = plane_view(texture, Filter::Nearest, nearest.level);
        let [s, t] = coords;
        let texels = [
            texels_along::<S>(&view, 0, registers[s].as_f32(), axes[0], kept),
            texels_along::<S>(&view, 1, registers[t].as_f32(), axes[1], kept),
        ];
        let [r, g, b, a] = nearest.components;
        if nearest.class == TexelClass::Bytes
            && view.level.format.bytes() == 4
            && let Some(square) = TexelSquare::new::<S>(view.level, &texels)
        {
            square.write::<S>(registers, out[0], r);
            square.write::<S>(registers, out[1], g);
            square.write::<S>(registers, out[2], b);
            square.write::<S>(registers, out[3], a);
            return;
        }
        let words = words::<S>(view.level, &texels);
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

/// The nearest texels along an axis.
#[inline(always)]
fn texels_along<S: Simd>(
    view: &LevelView<'_>,
    axis: usize,
    at: &F32s,
    texels: AxisTexels,
    kept: &mut KeptAxes,
) -> U32s {
    match texels {
        AxisTexels::Compute => nearest_along::<S>(view, axis, at),
        AxisTexels::Keep(number) => {
            let kept = &mut kept.0[usize::from(number) % KEPT_AXES];
            *kept = nearest_along::<S>(view, axis, at);
            *kept
        }
        AxisTexels::Reuse(number) => kept.0[usize::from(number) % KEPT_AXES],
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

/// A square of texels that has the nearest texels of all lanes: magnified lookups read few.
struct TexelSquare {
    words: [u32; SQUARE_TEXELS],
    /// By lane: its texel.
    numbers: U32s,
}

/// Texels along a side of it.
const SQUARE_SIDE: u32 = 4;

const SQUARE_TEXELS: usize = (SQUARE_SIDE * SQUARE_SIDE) as usize;

impl TexelSquare {
    /// `None` where lanes read texels farther apart, or the level is narrower.
    #[inline(always)]
    fn new<S: Simd>(level: &Level, [x, y]: &[U32s; 2]) -> Option<Self> {
        if level.width < SQUARE_SIDE {
            return None;
        }
        let [left, bottom] = first_texel(level, [x, y], SQUARE_SIDE);
        let (mut outside, mut numbers) = (U32s::ZERO, U32s::ZERO);
        for lane in 0..LANES {
            let (column, row) = (x[lane].wrapping_sub(left), y[lane].wrapping_sub(bottom));
            outside[lane] = column | row;
            numbers[lane] = row.wrapping_mul(SQUARE_SIDE).wrapping_add(column);
        }
        if !S::below(&outside, SQUARE_SIDE) {
            return None;
        }
        let mut words = [0; SQUARE_TEXELS];
        for (row, words) in words.chunks_exact_mut(SQUARE_SIDE as usize).enumerate() {
            let row = (bottom + row as u32).min(level.height - 1);
            let first = level.origin() + row as usize * level.row_bytes() + 4 * left as usize;
            let bytes = &level.texels[first..][..4 * words.len()];
            bytemuck::cast_slice_mut::<u32, u8>(words).copy_from_slice(bytes);
        }
        Some(Self { words: words.map(u32::from_le), numbers })
    }

    /// Writes a component, if it is used.
    #[inline(always)]
    fn write<S: Simd>(
        &self,
        registers: &mut [U32s],
        register: Option<usize>,
        component: Component,
    ) {
        let Some(register) = register else { return };
        let out = registers[register].as_f32_mut();
        match component {
            Component::Stored(channel) => {
                let mut fractions = [0.0; SQUARE_TEXELS];
                for (fraction, word) in fractions.iter_mut().zip(&self.words) {
                    *fraction = byte_channel(*word, channel);
                }
                *out = S::select_from_sixteen(&fractions, &self.numbers);
            }
            Component::Zero => *out = F32s::ZERO,
            Component::One => *out = F32s::splat(1.0),
        }
    }
}

/// Column and row of the first texel of a square that may have the texels of all lanes.
#[inline(always)]
fn first_texel(level: &Level, [x, y]: [&U32s; 2], side: u32) -> [u32; 2] {
    let left = CORNERS.map(|lane| x[lane]).into_iter().fold(level.width - side, u32::min);
    let bottom = CORNERS.map(|lane| y[lane]).into_iter().fold(level.height - 1, u32::min);
    [left, bottom]
}

/// The words of the nearest texels.
#[inline(always)]
fn words<S: Simd>(level: &Level, texels: &[U32s; 2]) -> U32s {
    let [x, y] = texels;
    if S::SELECTS_FROM_ROWS && level.format.bytes() == 4 && level.width >= SIDE {
        let [left, bottom] = first_texel(level, [x, y], SIDE);
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
    S::gather_inline(&level.texels, &byte_offsets(level, texels))
}
