//! The kernel of nearest lookups of which all but the coordinates is known with the plan: from coordinates in registers
//! to the components that are used, in registers. Same bits as [`super::uniform`].

#[cfg(test)]
mod tests;

use super::fast::{bytes_of_texel, channel_of_texel, nearest_along};
use super::scratch::{AxisTexels, KEPT_AXES, KeptAxes, TexelSpan};
use super::wrap::Axis;
use crate::format::convert::byte_channel;
use crate::format::{Component, Format};
use crate::kernels::LookupKernel;
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s, lane_x, lane_y};
use crate::plan::{DirectNearest, TexelClass, Texture};

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
        let Self { texture, nearest, registers, coords: [s, t], axes, kept, out } = self;
        let columns = span::<S>(texture, nearest, 0, registers[s].as_f32(), axes[0], kept);
        let rows = span::<S>(texture, nearest, 1, registers[t].as_f32(), axes[1], kept);
        let texels: &[u8] = &texture.levels[0][nearest.level].texels;
        let [r, g, b, a] = nearest.components;
        let is_bytes = nearest.class == TexelClass::Bytes && nearest.bytes[0] == 4;
        let has_square = columns.last.max(rows.last) < SQUARE_SIDE
            && columns.first + SQUARE_SIDE <= nearest.size[0];
        if is_bytes && has_square {
            LookupKernel::DirectSquare.note();
            let square = TexelSquare::new(texels, nearest, &columns, &rows);
            square.write::<S>(registers, out[0], r);
            square.write::<S>(registers, out[1], g);
            square.write::<S>(registers, out[2], b);
            square.write::<S>(registers, out[3], a);
            return;
        }
        let words = words::<S>(texels, nearest, &columns, &rows);
        match nearest.class {
            // Not in a loop, out of which the channels that are not used would be moved.
            TexelClass::Bytes => {
                LookupKernel::DirectWords.note();
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
                LookupKernel::DirectChannels.note();
                S::outlined(WriteChannels { nearest, format, words, registers, out });
            }
        }
    }
}

/// The nearest texels along an axis.
#[inline(always)]
fn span<S: Simd>(
    texture: &Texture,
    nearest: &DirectNearest,
    axis: usize,
    at: &F32s,
    texels: AxisTexels,
    kept: &mut KeptAxes,
) -> TexelSpan {
    let along = Axis {
        wrap: texture.wrap[axis],
        size: nearest.size[axis],
        border: nearest.border[axis],
        scale: nearest.scale[axis],
    };
    match texels {
        AxisTexels::Compute => computed_span::<S>(along, at),
        AxisTexels::Keep(number) => {
            let kept = &mut kept.0[usize::from(number) % KEPT_AXES];
            *kept = computed_span::<S>(along, at);
            *kept
        }
        AxisTexels::Reuse(number) => kept.0[usize::from(number) % KEPT_AXES],
    }
}

#[inline(always)]
fn computed_span<S: Simd>(along: Axis, at: &F32s) -> TexelSpan {
    let mut texels = nearest_along::<S>(along, at);
    let [a, b, c, d] = CORNERS;
    let first = texels[a].min(texels[b]).min(texels[c]).min(texels[d]);
    for lane in 0..LANES {
        texels[lane] = texels[lane].wrapping_sub(first);
    }
    TexelSpan { last: S::largest(&texels), texels, first }
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

/// A square of texels that has those of all lanes: magnified lookups read few.
struct TexelSquare {
    /// Row by row, little-endian.
    words: [[u32; SQUARE_SIDE as usize]; SQUARE_SIDE as usize],
    /// By lane: its texel.
    numbers: U32s,
}

/// Texels along a side of it.
const SQUARE_SIDE: u32 = 4;

const SQUARE_TEXELS: usize = (SQUARE_SIDE * SQUARE_SIDE) as usize;

impl TexelSquare {
    /// The one at the first column and row, with four columns.
    #[inline(always)]
    fn new(texels: &[u8], nearest: &DirectNearest, columns: &TexelSpan, rows: &TexelSpan) -> Self {
        let mut numbers = U32s::ZERO;
        for lane in 0..LANES {
            numbers[lane] = rows.texels[lane] * SQUARE_SIDE + columns.texels[lane];
        }
        let first = nearest.origin + 4 * columns.first;
        let mut words = [[0; SQUARE_SIDE as usize]; SQUARE_SIDE as usize];
        for (row, words) in words.iter_mut().enumerate() {
            // Rows beyond the last are in no lane.
            let row = (rows.first + row as u32).min(nearest.size[1] - 1);
            let at = (first + row * nearest.bytes[1]) as usize;
            let bytes: &[u8; 4 * SQUARE_SIDE as usize] = texels[at..].first_chunk().expect("a row");
            *words = bytemuck::cast(*bytes);
        }
        Self { words, numbers }
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
                for (fraction, word) in fractions.iter_mut().zip(self.words.as_flattened()) {
                    *fraction = byte_channel(u32::from_le(*word), channel);
                }
                *out = S::select_from_sixteen(&fractions, &self.numbers);
            }
            Component::Zero => *out = F32s::ZERO,
            Component::One => *out = F32s::splat(1.0),
        }
    }
}

/// The words of the nearest texels.
#[inline(always)]
fn words<S: Simd>(
    texels: &[u8],
    nearest: &DirectNearest,
    columns: &TexelSpan,
    rows: &TexelSpan,
) -> U32s {
    let ([width, height], [bytes, row_bytes]) = (nearest.size, nearest.bytes);
    let mut numbers = U32s::ZERO;
    if S::SELECTS_FROM_ROWS && bytes == 4 && width >= SIDE {
        // At the end of a row the eight columns begin before the first one.
        let left = columns.first.min(width - SIDE);
        let before = columns.first - left;
        if columns.last.saturating_add(before) < SIDE && rows.last < SIDE {
            for lane in 0..LANES {
                numbers[lane] = rows.texels[lane] * SIDE + columns.texels[lane] + before;
            }
            let first = (nearest.origin + rows.first * row_bytes + 4 * left) as usize;
            let count = (height - rows.first).min(SIDE);
            return S::select_from_rows(&texels[first..], row_bytes as usize, count, &numbers);
        }
    }
    let first = nearest.origin + rows.first * row_bytes + columns.first * bytes;
    for lane in 0..LANES {
        let [column, row] = [columns.texels[lane], rows.texels[lane]];
        numbers[lane] = first
            .wrapping_add(row.wrapping_mul(row_bytes))
            .wrapping_add(column.wrapping_mul(bytes));
    }
    S::gather_inline(texels, &numbers)
}
