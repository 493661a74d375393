//! From the samples of a pixel to one (`EXT_framebuffer_multisample`, section 4.3.2): colours are
//! their mean; depth, stencil and integers are those of the first sample.

use super::encode::{decode_color, encode_color};
use super::plane::{BLOCKS, WordPlane};
use super::words::attachment_words;
use std::ops::Range;
use texunit::format::Format;
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
    for block in rows.start * 8..rows.end * 8 {
        let texels = isa.run(Mean { format, samples: &samples, block });
        for (plane, words) in out.iter_mut().zip(texels) {
            plane[block] = words;
        }
    }
    out.into_iter().map(WordPlane::of).collect()
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
