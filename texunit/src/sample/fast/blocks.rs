//! The fast path of compressed textures with a linear filter: texels are decoded in registers.
//!
//! The block of each of the four texels is gathered whole, and all channels that share its codes are decoded
//! in one loop.

use super::quad_position::{pair_offsets, quad_position};
use crate::format::block::{
    CHANNELS, Palette, Signedness, color_sixths, color_weights, explicit, interpolated,
    is_srgb_block, punched,
};
use crate::format::{Block, Format};
use crate::lanes::{F32s, LANES, Simd, U32s};
use crate::sample::interpolate::lerp;
use crate::sample::level_view::LevelView;

/// One of the four texels of each quad.
struct Corner {
    /// Byte offset of the block.
    offset: U32s,
    /// Column plus 4 times row in the block.
    within: U32s,
}

/// For each of the four texels: a half of a block of 16 bytes, or a block of 8.
type Halves = [[U32s; 2]; 4];

/// The weighted mean of 2×2 texels; `false` where the fast path does not apply.
#[inline(always)]
pub fn linear<S: Simd>(
    view: &LevelView<'_>,
    block: Block,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
) -> bool {
    let Some(position) = quad_position::<S>(view, at) else { return false };
    let [s, t] = &position.axes;
    let xs = pair_offsets(s, &position.first[0], position.pairs[0], 1, 0);
    let ys = pair_offsets(t, &position.first[1], position.pairs[1], 1, 0);
    let level = view.level;
    let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
    let corners = [
        corner(&xs[0], &ys[0], bytes, row),
        corner(&xs[1], &ys[0], bytes, row),
        corner(&xs[0], &ys[1], bytes, row),
        corner(&xs[1], &ys[1], bytes, row),
    ];
    let within = [&corners[0].within, &corners[1].within, &corners[2].within, &corners[3].within];
    let quads = BlockQuads { within, weights: [&position.weights[0], &position.weights[1]] };
    let first = halves::<S>(view, &corners, 0);
    let channels = level.format.channels();
    match block {
        Block::Dxt1 => {
            quads.colors::<S>(&first, Palette::ByOrder, level.format, out);
            if channels > 3 {
                quads.mean(&first, &mut out[3], punched);
            }
        }
        Block::Dxt3 | Block::Dxt5 => {
            let second = halves::<S>(view, &corners, 8);
            quads.colors::<S>(&second, Palette::Four, level.format, out);
            if block == Block::Dxt3 {
                quads.mean(&first, &mut out[3], explicit);
            } else {
                quads.mean(&first, &mut out[3], unsigned);
            }
        }
        Block::Rgtc1 => quads.mean(&first, &mut out[0], unsigned),
        Block::Rgtc1Snorm => quads.mean(&first, &mut out[0], signed),
        Block::Rgtc2 => {
            quads.mean(&first, &mut out[0], unsigned);
            quads.mean(&halves::<S>(view, &corners, 8), &mut out[1], unsigned);
        }
        Block::Rgtc2Snorm => {
            quads.mean(&first, &mut out[0], signed);
            quads.mean(&halves::<S>(view, &corners, 8), &mut out[1], signed);
        }
        // They are decoded before, but where there is no memory.
        Block::Bptc | Block::BptcUnsignedFloat | Block::BptcSignedFloat => return false,
    }
    true
}

#[inline(always)]
fn corner(x: &U32s, y: &U32s, bytes: u32, row: u32) -> Corner {
    let mut corner = Corner { offset: U32s::ZERO, within: U32s::ZERO };
    for lane in 0..LANES {
        let (x, y) = (x[lane], y[lane]);
        corner.offset[lane] = (y >> 2).wrapping_mul(row).wrapping_add((x >> 2).wrapping_mul(bytes));
        corner.within[lane] = (x & 3) + 4 * (y & 3);
    }
    corner
}

/// The 8 bytes at `start` of the block of every corner.
#[inline(always)]
fn halves<S: Simd>(view: &LevelView<'_>, corners: &[Corner; 4], start: u32) -> Halves {
    let mut out = [[U32s::ZERO; 2]; 4];
    for (out, corner) in out.iter_mut().zip(corners) {
        let mut offset = U32s::ZERO;
        for lane in 0..LANES {
            offset[lane] = corner.offset[lane].wrapping_add(start);
        }
        *out = S::gather_pairs(&view.level.texels, &offset);
    }
    out
}

// Functions, since a closure that is called more than once may not be inlined into the kernel.

#[inline(always)]
fn unsigned(low: u32, high: u32, at: u32) -> f32 {
    interpolated(low, high, at, Signedness::Unsigned)
}

#[inline(always)]
fn signed(low: u32, high: u32, at: u32) -> f32 {
    interpolated(low, high, at, Signedness::Signed)
}

/// A texel's red, green and blue in sixths of their largest.
#[inline(always)]
fn sixths(low: u32, high: u32, at: u32, palette: Palette) -> [u32; 3] {
    let weights = color_weights(low, high, at, palette);
    [
        color_sixths(low, weights, CHANNELS[0]),
        color_sixths(low, weights, CHANNELS[1]),
        color_sixths(low, weights, CHANNELS[2]),
    ]
}

/// Positions of the four texels in their blocks, and their weights.
struct BlockQuads<'a> {
    within: [&'a U32s; 4],
    weights: [&'a F32s; 2],
}

impl BlockQuads<'_> {
    #[inline(always)]
    fn lerp(&self, [a, b, c, d]: [f32; 4], lane: usize) -> f32 {
        let [alpha, beta] = [self.weights[0][lane], self.weights[1][lane]];
        lerp(lerp(a, b, alpha), lerp(c, d, alpha), beta)
    }

    /// The mean of a channel that `decode` takes from the halves and the place within them.
    #[inline(always)]
    fn mean(&self, halves: &Halves, out: &mut F32s, decode: impl Fn(u32, u32, u32) -> f32) {
        for lane in 0..LANES {
            let mut texels = [0.0; 4];
            for corner in 0..4 {
                let [low, high] = [halves[corner][0][lane], halves[corner][1][lane]];
                texels[corner] = decode(low, high, self.within[corner][lane] & 15);
            }
            out[lane] = self.lerp(texels, lane);
        }
    }

    /// The means of red, green and blue.
    #[inline(always)]
    fn colors<S: Simd>(
        &self,
        halves: &Halves,
        palette: Palette,
        format: Format,
        out: &mut [F32s; 4],
    ) {
        if is_srgb_block(format) {
            return self.linear_light::<S>(halves, palette, out);
        }
        let [red, green, blue, _] = out;
        for lane in 0..LANES {
            let mut texels = [[0.0; 4]; 3];
            for corner in 0..4 {
                let [low, high] = [halves[corner][0][lane], halves[corner][1][lane]];
                let [r, g, b] = sixths(low, high, self.within[corner][lane] & 15, palette);
                texels[0][corner] = CHANNELS[0].fraction(r);
                texels[1][corner] = CHANNELS[1].fraction(g);
                texels[2][corner] = CHANNELS[2].fraction(b);
            }
            red[lane] = self.lerp(texels[0], lane);
            green[lane] = self.lerp(texels[1], lane);
            blue[lane] = self.lerp(texels[2], lane);
        }
    }

    /// The means of sRGB colours, decoded by tables.
    #[inline(always)]
    fn linear_light<S: Simd>(&self, halves: &Halves, palette: Palette, out: &mut [F32s; 4]) {
        let mut linear = [[F32s::ZERO; 4]; 3];
        for corner in 0..4 {
            let [low, high] = &halves[corner];
            let mut parts = [U32s::ZERO; 3];
            for lane in 0..LANES {
                let at = self.within[corner][lane] & 15;
                let [r, g, b] = sixths(low[lane], high[lane], at, palette);
                parts[0][lane] = r;
                parts[1][lane] = g;
                parts[2][lane] = b;
            }
            for channel in 0..3 {
                let table = CHANNELS[channel].linear();
                linear[channel][corner] = S::gather_f32(table, &parts[channel]);
            }
        }
        for (linear, out) in linear.iter().zip(out) {
            for lane in 0..LANES {
                let texels = [linear[0][lane], linear[1][lane], linear[2][lane], linear[3][lane]];
                out[lane] = self.lerp(texels, lane);
            }
        }
    }
}
