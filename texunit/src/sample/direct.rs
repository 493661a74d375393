//! The kernel of nearest lookups of which all but the coordinates is known with the plan: from coordinates in registers
//! to the components that are used, in registers. Same bits as [`super::uniform`].

#[cfg(test)]
mod tests;

use super::fast::{bytes_of_texel, channel_of_texel};
use super::level_view::LevelView;
use super::uniform_levels::plane_view;
use crate::lanes::math::index;
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s};
use crate::plan::{ChannelSource, DirectNearest, TexelClass, Texture};
use crate::sampler::Filter;

/// Lanes at the corners of the 8×8 pixels of a batch.
const CORNERS: [usize; 4] = [0, 19, 44, 63];

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
        let [r, g, b, a] = nearest.sources;
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
                let channels = texture.format.channels();
                S::outlined(WriteChannels { nearest, channels, words: &words, registers, out });
            }
        }
    }
}

/// Writes a component of texels whose channels are bytes, if it is used.
#[inline(always)]
fn write_bytes(
    registers: &mut [U32s],
    register: Option<usize>,
    source: ChannelSource,
    words: &U32s,
) {
    let Some(register) = register else { return };
    let out = registers[register].as_f32_mut();
    match source {
        ChannelSource::Stored(channel) => bytes_of_texel(channel, words, out),
        ChannelSource::Zero => *out = F32s::ZERO,
        ChannelSource::One => *out = F32s::splat(1.0),
    }
}

/// Writes the components that are used.
struct WriteChannels<'a> {
    nearest: &'a DirectNearest,
    channels: usize,
    words: &'a U32s,
    registers: &'a mut [U32s],
    out: [Option<usize>; 4],
}

impl Kernel for WriteChannels<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { nearest, channels, words, registers, out } = self;
        for (register, source) in out.into_iter().zip(nearest.sources) {
            let Some(register) = register else { continue };
            let out = registers[register].as_f32_mut();
            match source {
                ChannelSource::Stored(channel) => {
                    channel_of_texel::<S>(nearest.class, channels, channel, words, out);
                }
                ChannelSource::Zero => *out = F32s::ZERO,
                ChannelSource::One => *out = F32s::splat(1.0),
            }
        }
    }
}

/// The words of the nearest texels.
#[inline(always)]
fn words<S: Simd>(view: &LevelView<'_>, at: [&F32s; 2]) -> U32s {
    let (s, t) = (view.axis(0), view.axis(1));
    let (u, v) = (s.texel_coordinate::<S>(at[0]), t.texel_coordinate::<S>(at[1]));
    let (last_s, last_t) = ((s.size - 1) as f32, (t.size - 1) as f32);
    let (mut x, mut y) = (U32s::ZERO, U32s::ZERO);
    for lane in 0..LANES {
        // A coordinate may be rounded up to the size.
        (x[lane], y[lane]) = (index(u[lane], last_s), index(v[lane], last_t));
    }
    let level = view.level;
    let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
    let origin = level.origin() as u32;
    if S::SELECTS_FROM_ROWS && bytes == 4 && s.size >= SIDE {
        let left = CORNERS.map(|lane| x[lane]).into_iter().fold(s.size - SIDE, u32::min);
        let bottom = CORNERS.map(|lane| y[lane]).into_iter().fold(t.size - 1, u32::min);
        let (mut outside, mut numbers) = (U32s::ZERO, U32s::ZERO);
        for lane in 0..LANES {
            let (column, row) = (x[lane].wrapping_sub(left), y[lane].wrapping_sub(bottom));
            outside[lane] = column | row;
            numbers[lane] = row.wrapping_mul(SIDE).wrapping_add(column);
        }
        if S::below(&outside, SIDE) {
            let first = (origin + bottom * row + left * bytes) as usize;
            let rows = (t.size - bottom).min(SIDE);
            return S::select_from_rows(&level.texels[first..], row as usize, rows, &numbers);
        }
    }
    let mut offsets = U32s::ZERO;
    for lane in 0..LANES {
        offsets[lane] =
            y[lane].wrapping_mul(row).wrapping_add(x[lane].wrapping_mul(bytes)) + origin;
    }
    S::gather_inline(&level.texels, &offsets)
}
