//! Pixels with four samples (GL 3.2, sections 3.3.1, 4.1.3 and 4.3.2; ARB_texture_multisample).

use super::painter::inside;
use crate::mutation::{Mutation, Variant};

/// Samples of a pixel.
pub const SAMPLES: usize = 4;

/// Where they lie in the pixel: the positions that DetGL reports, in sixteenths.
pub const POSITIONS: [[f64; 2]; SAMPLES] = [[6.0, 2.0], [14.0, 6.0], [2.0, 10.0], [10.0, 14.0]];

/// The place of a sample of a pixel.
pub fn sample_position([x, y]: [usize; 2], sample: usize, variant: Variant) -> [f64; 2] {
    let [dx, dy] = if variant.has(Mutation::SamplesAtCentre) {
        [8.0, 8.0]
    } else if variant.has(Mutation::SamplesUpsideDown) {
        [POSITIONS[sample][0], 16.0 - POSITIONS[sample][1]]
    } else {
        POSITIONS[sample]
    };
    [x as f64 + dx / 16.0, y as f64 + dy / 16.0]
}

/// The last triangle that covers the sample, counted from 1, or 0; `None` where one's edge passes it.
pub fn shown(
    triangles: &[[[f64; 2]; 3]],
    pixel: [usize; 2],
    sample: usize,
    variant: Variant,
) -> Option<usize> {
    let at = sample_position(pixel, sample, variant);
    let mut shown = 0;
    for (number, corners) in (1..).zip(triangles) {
        if inside(*corners, at)? {
            shown = number;
        }
    }
    Some(shown)
}

/// Whether a mask lets a sample be written.
pub fn masked(mask: u32, sample: usize, variant: Variant) -> bool {
    let bit = if variant.has(Mutation::SampleMaskReversed) { SAMPLES - 1 - sample } else { sample };
    mask >> bit & 1 == 1 || variant.has(Mutation::SampleMaskIgnored)
}

/// The colour that a pixel's samples are resolved to.
pub fn resolved(samples: [[f64; 4]; SAMPLES], variant: Variant) -> [f64; 4] {
    if variant.has(Mutation::ResolveOfOneSample) {
        return samples[0];
    }
    std::array::from_fn(|i| samples.iter().map(|sample| sample[i]).sum::<f64>() / SAMPLES as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_through_a_pixel_by_hand() {
        // Left of x = 1/2: samples 0 and 2.
        let left = [[0.5, -9.0], [0.5, 9.0], [-9.0, 0.0]];
        let shown = [0, 1, 2, 3].map(|sample| shown(&[left], [0, 0], sample, Variant::CORRECT));
        assert_eq!(shown, [Some(1), Some(0), Some(1), Some(0)]);
    }

    #[test]
    fn a_resolve_is_the_mean() {
        let samples = [[0.0; 4], [1.0; 4], [2.0; 4], [5.0; 4]];
        assert_eq!(resolved(samples, Variant::CORRECT), [2.0; 4]);
    }
}
