//! Compressed levels: decoding a row of texels, compressing a whole level.

use super::Level;
use crate::format::block::{decoded_bytes, decoded_format};
use crate::format::convert::words_of;
use crate::lanes::{F32s, Isa, Kernel, LANES, Simd, U32s};

/// Bytes of a colour of four `f32`.
const COLOR: usize = 16;

impl Level {
    /// The stored channels of the texel at `at` and of those after it in its row, up to 64; others are anything.
    /// Only those that the format has are written.
    ///
    /// # Panics
    /// When there is no such texel.
    pub fn channels_of_row_span(&self, isa: Isa, at: [u32; 3], out: &mut [F32s; 4]) {
        isa.run(FetchRowSpan { level: self, at, out });
    }

    /// The texels of a level that is decoded whole, in a format without blocks; `None` of others, and where there is no
    /// memory.
    pub(crate) fn decoded(&self) -> Option<Self> {
        let format = decoded_format(self.format)?;
        let mut level = Self::with_size(format, self.size(), [0; 3]).ok()?;
        let (bytes, row) = (format.bytes(), level.row_bytes());
        if level.row_bytes() == 0 || self.texels.is_blank() {
            return Some(level);
        }
        let rows = level.texels.chunks_exact_mut(row).enumerate();
        for (number, texels) in rows {
            let (y, z) = (number as u32 % self.height, number as u32 / self.height);
            for (x, texel) in (0..).zip(texels.chunks_exact_mut(bytes).take(self.width as usize)) {
                let words = words_of(self.format, self.texel_at([x, y as i32, z as i32]));
                let within = x as u32 % 4 + 4 * (y % 4);
                let decoded = decoded_bytes(self.format, words, within);
                texel.copy_from_slice(&decoded[..bytes]);
            }
        }
        Some(level)
    }

    /// [`Level::fill`] of a level without border from colours of four `f32` each, tightly packed, as many as it has
    /// texels: rows upward, then slices.
    pub fn compress(&mut self, colors: &[u8]) {
        let [width, height, _] = self.size().map(|side| side as usize);
        let (texels, _) = colors.as_chunks::<COLOR>();
        self.fill(|at| {
            let [x, y, z] = at.map(|at| at as usize);
            color(&texels[(z * height + y) * width + x])
        });
    }
}

fn color(bytes: &[u8; COLOR]) -> [f32; 4] {
    let (channels, _) = bytes.as_chunks::<4>();
    [0, 1, 2, 3].map(|channel| f32::from_le_bytes(channels[channel]))
}

struct FetchRowSpan<'a> {
    level: &'a Level,
    at: [u32; 3],
    out: &'a mut [F32s; 4],
}

impl Kernel for FetchRowSpan<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { level, at: [x, y, z], out } = self;
        let [s, t, r] = level.border;
        let last = level.width - 1;
        let mut column = U32s::ZERO;
        for lane in 0..LANES {
            let at = x + lane as u32;
            column[lane] = if at < last { at } else { last } + s;
        }
        level.fetch_stored::<S>([&column, &U32s::splat(y + t), &U32s::splat(z + r)], out);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format::Format;

    /// A colour of each texel.
    fn noise([x, y, z]: [i32; 3]) -> [f32; 4] {
        let seed = (x + 31 * y + 1021 * z) as u32;
        [1, 2, 3, 4].map(|c| {
            (seed.wrapping_mul(0x9E37_79B9_u32.wrapping_mul(c)) >> 20) as f32 / 3000.0 - 0.1
        })
    }

    #[test]
    fn a_level_is_compressed_as_texel_by_texel_and_read_so() {
        for format in Format::ALL.into_iter().filter(|format| format.block().is_some()) {
            for size in [[70, 5, 1], [4, 4, 3], [3, 1, 1], [128, 2, 1]] {
                let mut want = Level::with_size(format, size, [0; 3]).unwrap();
                want.fill(noise);
                let [width, height, depth] = size.map(|side| side as i32);
                let places = (0..depth)
                    .flat_map(|z| (0..height).map(move |y| [y, z]))
                    .flat_map(|[y, z]| (0..width).map(move |x| [x, y, z]));
                let colors: Vec<u8> =
                    places.flat_map(noise).flat_map(|channel| channel.to_le_bytes()).collect();
                let mut level = Level::with_size(format, size, [0; 3]).unwrap();
                level.compress(&colors);
                assert_eq!(level, want, "{format:?} {size:?}");
                for isa in Isa::available() {
                    let mut out = [F32s::ZERO; 4];
                    for x in (0..width).step_by(LANES) {
                        let (y, z) = (height - 1, depth - 1);
                        level.channels_of_row_span(isa, [x, y, z].map(|at| at as u32), &mut out);
                        for (x, lane) in (x..width).zip(0..LANES) {
                            let want = level.channels_at([x, y, z]).unwrap();
                            for (got, want) in out.iter().zip(want).take(format.channels()) {
                                assert_eq!(got[lane].to_bits(), want.to_bits(), "{format:?}");
                            }
                        }
                    }
                }
            }
        }
    }
}
