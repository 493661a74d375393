//! From the samples of a pixel to one (`EXT_framebuffer_multisample`, section 4.3.2): colours are
//! their mean; depth, stencil and integers are those of the first sample.

use super::encode::{decode_color, encode_color};
use super::mask::are_equal;
use super::plane::{BLOCKS, BlockTexels, WordPlane};
use super::words::attachment_words;
use std::ops::Range;
use texunit::format::{Encoding, Format};
use texunit::lanes::{F32s, Isa, Kernel, LANES, Simd, U32s};

/// The planes of a tile of one sample, where these rows of blocks are right.
pub fn resolve_tile(
    isa: Isa,
    format: Format,
    samples: u8,
    planes: &[WordPlane],
    rows: Range<usize>,
) -> Vec<WordPlane> {
    let words = attachment_words(format);
    let samples: Vec<&[WordPlane]> = planes.chunks(words).take(usize::from(samples)).collect();
    let Some((first, rest)) = samples.split_first() else { return Vec::new() };
    let same = |plane: &WordPlane, word: usize| {
        plane
            .cleared_word()
            .is_some_and(|word_of_all| first[word].cleared_word() == Some(word_of_all))
    };
    let is_clear = rest.iter().all(|s| s.iter().enumerate().all(|(word, p)| same(p, word)));
    if format.is_depth() || format.is_integer() || is_clear {
        return first.to_vec();
    }
    let mut out = vec![vec![U32s::ZERO; BLOCKS]; words];
    let keeps_equal = mean_keeps_equal(format);
    for block in rows.start * 8..rows.end * 8 {
        if keeps_equal && isa.run(IsEqual { samples: &samples, block }) {
            for (out, plane) in out.iter_mut().zip(*first) {
                out[block] = plane.block(block);
            }
            continue;
        }
        let texels = isa.run(Mean { format, samples: &samples, block });
        for (plane, words) in out.iter_mut().zip(texels) {
            plane[block] = words;
        }
    }
    out.into_iter().map(WordPlane::of).collect()
}

/// Whether the mean of equal samples is their word, because the rounding of a sum is less than a step of the format:
/// components of at most 16 bits in [0, 1], not encoded as sRGB.
fn mean_keeps_equal(format: Format) -> bool {
    let is_narrow = |channel: usize| format.field(channel).mask() <= 0xFFFF;
    format.info().encoding == Encoding::Unorm && (0..format.channels()).all(is_narrow)
}

/// Whether all samples of a block hold equal words.
struct IsEqual<'a> {
    samples: &'a [&'a [WordPlane]],
    block: usize,
}

impl Kernel for IsEqual<'_> {
    type Output = bool;
    #[inline(always)]
    fn run<S: Simd>(self) -> bool {
        let Self { samples, block } = self;
        let Some((first, rest)) = samples.split_first() else { return true };
        first.iter().enumerate().all(|(word, plane)| {
            rest.iter().all(|sample| match (plane.texels(block), sample[word].texels(block)) {
                (BlockTexels::Words(a), BlockTexels::Words(b)) => are_equal::<S>(a, b),
                (BlockTexels::Uniform(a), BlockTexels::Uniform(b)) => a == b,
                (
                    BlockTexels::Words(_) | BlockTexels::Uniform(_) | BlockTexels::Depth(_),
                    BlockTexels::Words(_) | BlockTexels::Uniform(_) | BlockTexels::Depth(_),
                ) => false,
            })
        })
    }
}

/// The mean of the samples of a block.
struct Mean<'a> {
    format: Format,
    samples: &'a [&'a [WordPlane]],
    block: usize,
}

impl Kernel for Mean<'_> {
    type Output = [U32s; 4];
    #[inline(always)]
    fn run<S: Simd>(self) -> [U32s; 4] {
        let Self { format, samples, block } = self;
        let mut sum = [F32s::ZERO; 4];
        for sample in samples {
            let mut words = [U32s::ZERO; 4];
            for (word, plane) in words.iter_mut().zip(*sample) {
                *word = plane.block(block);
            }
            let color = decode_color::<S>(format, words.each_ref());
            for channel in 0..4 {
                for lane in 0..LANES {
                    sum[channel][lane] += color[channel][lane];
                }
            }
        }
        let count = samples.len() as f32;
        for channel in &mut sum {
            for lane in 0..LANES {
                channel[lane] /= count;
            }
        }
        let mut texels = [U32s::ZERO; 4];
        encode_color::<S>(format, sum.each_ref(), &mut texels);
        texels
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use texunit::lanes::Baseline;

    #[test]
    fn the_mean_of_equal_samples_is_their_word() {
        let formats = Format::ALL
            .iter()
            .copied()
            .filter(|&format| super::super::is_attachable(format) && mean_keeps_equal(format));
        let mut count = 0;
        for format in formats {
            count += 1;
            for base in (0..0x1_0000_u32).step_by(LANES) {
                // Every value of every component of at most 16 bits, in each of a texel's words.
                let words = U32s::from_fn(|lane| (base + lane as u32) * 0x1_0001);
                let used = |word: usize| {
                    (0..format.channels())
                        .map(|channel| format.field(channel))
                        .filter(|field| field.word == word)
                        .fold(0, |all, field| all | field.mask() << field.shift)
                };
                let plane = |word| {
                    let words = U32s::from_fn(|lane| words[lane] & used(word));
                    WordPlane::of(vec![words; BLOCKS])
                };
                let sample: Vec<WordPlane> = (0..attachment_words(format)).map(plane).collect();
                let samples = vec![&sample[..]; 4];
                let texels = Mean { format, samples: &samples, block: 0 }.run::<Baseline>();
                for (plane, texels) in sample.iter().zip(texels) {
                    assert_eq!(plane.block(0).0, texels.0, "{format:?}");
                }
            }
        }
        assert!(count >= 8, "only {count} formats");
    }
}
