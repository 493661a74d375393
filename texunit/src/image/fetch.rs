//! Loads 64 texels of a level of any format: the general path, to which every fast path is bit-equal.

use super::Level;
use crate::format::{Encoding, Field, block, convert};
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s};

impl Level {
    /// The stored channels of 64 texels. `at` are x, y, z counted from the corner of what is
    /// stored, so that a border is texel 0, and below [`Level::stored_size`]. Only the stored
    /// channels of `out` are written.
    ///
    /// # Panics
    /// When an index is so large that its texel lies outside the level's bytes.
    #[inline(always)]
    pub fn fetch_lanes<S: Simd>(&self, at: [&U32s; 3], out: &mut [F32s; 4]) {
        let (words, within) = self.gather::<S>(at);
        if self.format.block().is_some() {
            block::decode_lanes::<S>(self.format, &words, &within, out);
        } else {
            convert::decode_lanes::<S>(self.format, &words[..self.format.words()], out);
        }
    }

    /// The words of 64 texels, or of the blocks they are in, and where in its block each is
    /// (0 without blocks). Words that a texel does not have are 0. `at` as in
    /// [`Level::fetch_lanes`].
    ///
    /// # Panics
    /// As [`Level::fetch_lanes`].
    #[inline(always)]
    pub fn gather<S: Simd>(&self, [x, y, z]: [&U32s; 3]) -> ([U32s; 4], U32s) {
        let bytes = self.format.bytes() as u32;
        let (row, slice) = (self.row_bytes() as u32, self.slice_bytes() as u32);
        let shift = self.format.block_side().trailing_zeros();
        let mut within = U32s::ZERO;
        let mut offsets = U32s::ZERO;
        // Below `MAX_LEVEL_BYTES`, so without overflow, for every texel there is.
        for lane in 0..LANES {
            let column = (x[lane] >> shift).wrapping_mul(bytes);
            let line = (y[lane] >> shift).wrapping_mul(row);
            offsets[lane] = z[lane].wrapping_mul(slice).wrapping_add(line).wrapping_add(column);
        }
        if shift > 0 {
            for lane in 0..LANES {
                within[lane] = (x[lane] & 3) + 4 * (y[lane] & 3);
            }
        }
        let (mut words, count) = ([U32s::ZERO; 4], self.format.words());
        for pair in words[..count].chunks_mut(2) {
            match pair {
                [low, high] => [*low, *high] = self.texels.gather_pairs::<S>(&offsets),
                rest => rest.fill(self.texels.gather::<S>(&offsets)),
            }
            for lane in 0..LANES {
                offsets[lane] = offsets[lane].wrapping_add(8);
            }
        }
        (words, within)
    }
}

impl Level {
    /// The stored channels of 64 texels; those of integer formats are their bits. `at` as in [`Level::fetch_lanes`].
    /// Outlined: the code of all formats is large.
    ///
    /// # Panics
    /// As [`Level::fetch_lanes`].
    #[inline(always)]
    pub(crate) fn fetch_stored<S: Simd>(&self, at: [&U32s; 3], out: &mut [F32s; 4]) {
        S::outlined(FetchStored { level: self, at, out });
    }
}

struct FetchStored<'a> {
    level: &'a Level,
    at: [&'a U32s; 3],
    out: &'a mut [F32s; 4],
}

impl Kernel for FetchStored<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { level, at, out } = self;
        if !level.format.is_integer() {
            return level.fetch_lanes::<S>(at, out);
        }
        let info = level.format.info();
        let (words, _) = level.gather::<S>(at);
        for (channel, out) in out.iter_mut().enumerate().take(level.format.channels()) {
            let Field { word, shift, bits } = info.fields[channel];
            // To the top, and back with the sign or zeros.
            let (up, down) = (32 - bits - shift, 32 - bits);
            let out = out.as_u32_mut();
            for lane in 0..LANES {
                let top = words[word][lane] << up;
                out[lane] = if info.encoding == Encoding::Sint {
                    (top as i32 >> down) as u32
                } else {
                    top >> down
                };
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format::Format;
    use crate::image::Shape;
    use crate::lanes::Isa;

    struct Fetch<'a>(&'a Level, [&'a U32s; 3]);
    impl Kernel for Fetch<'_> {
        type Output = [F32s; 4];
        #[inline(always)]
        fn run<S: Simd>(self) -> [F32s; 4] {
            let mut out = [F32s::ZERO; 4];
            self.0.fetch_lanes::<S>(self.1, &mut out);
            out
        }
    }

    #[test]
    fn every_texel_of_every_format_is_fetched_as_it_is_read() {
        for format in Format::ALL {
            let border = if format.block().is_some() { 0 } else { 1 };
            let border = Shape::D3.border(border);
            let mut level = Level::with_size(format, [7, 5, 3], border).unwrap();
            for (i, byte) in level.texels.iter_mut().enumerate() {
                *byte = (i as u32).wrapping_mul(0x9E37_79B9).to_be_bytes()[0];
            }
            let [w, h, d] = level.stored_size();
            for first in (0..w * h * d).step_by(LANES) {
                let place = |lane: usize| {
                    let i = (first + lane as u32).min(w * h * d - 1);
                    [i % w, i / w % h, i / (w * h)]
                };
                let at = [0, 1, 2].map(|axis| U32s::from_fn(|lane| place(lane)[axis]));
                for isa in Isa::available() {
                    let got = isa.run(Fetch(&level, [&at[0], &at[1], &at[2]]));
                    for (c, got) in got.iter().enumerate().take(format.channels()) {
                        for lane in 0..LANES {
                            let from = [0, 1, 2].map(|a| place(lane)[a] as i32 - border[a] as i32);
                            let want = level.channels_at(from).unwrap()[c];
                            assert_eq!(got[lane].to_bits(), want.to_bits(), "{format:?}");
                        }
                    }
                }
            }
        }
    }
}
