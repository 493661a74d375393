//! The samples of a draw's pixels: where each lies, and which of them a fragment keeps (GL 2.1,
//! sections 3.2.1 and 4.1.3).
//!
//! A fragment is shaded once, at the centre of its pixel (what is `centroid`: at the centroid of its
//! covered samples), if any sample is covered; or at each covered sample (`ARB_sample_shading`). Its depth is
//! that of the plane at each sample; each sample is tested and written by itself.

use crate::desc::{
    AlphaToCoverage, AlphaToOne, MultisampleState, SampleCoverage, SampleRule, SampleShading,
};
use crate::ir::{Input, Output};
use crate::shader::Program;
use crate::sizes::{MAX_SAMPLES, SUBPIXEL};
use std::ops::{Deref, DerefMut};
use texunit::lanes::{F32s, Isa, Kernel, LANES, Simd, U32s};

/// The lanes that are covered, by sample.
#[derive(Clone, Copy, Debug, Default)]
pub struct SampleMasks {
    /// 0 for samples that there are not.
    lanes: [u64; MAX_SAMPLES],
    count: usize,
}

impl SampleMasks {
    /// No lane of `count` samples, at most [`MAX_SAMPLES`].
    pub fn none(count: usize) -> Self {
        Self { lanes: [0; MAX_SAMPLES], count: count.min(MAX_SAMPLES) }
    }

    /// These lanes of the only sample.
    #[inline]
    pub fn one(lanes: u64) -> Self {
        Self { lanes: [lanes, 0, 0, 0], count: 1 }
    }

    /// The lanes of which any sample is covered.
    /// A single sample is read as one word: a vector load of words that were just stored one by one waits for the
    /// store buffer.
    #[inline]
    pub fn any(&self) -> u64 {
        match self.count {
            0 | 1 => self.lanes[0],
            _ => self.lanes.iter().fold(0, |all, mask| all | mask),
        }
    }

    /// Becomes those lanes of `masks` that are among `lanes`, of every sample.
    #[inline]
    pub fn set(&mut self, masks: &Self, lanes: u64) {
        *self = match masks.count {
            0 | 1 => Self { lanes: [masks.lanes[0] & lanes, 0, 0, 0], count: masks.count },
            count => Self { lanes: masks.lanes.map(|mask| mask & lanes), count },
        };
    }

    /// Whether any lane of a sample is in both.
    #[inline]
    pub fn intersects(&self, other: &Self) -> bool {
        match self.count {
            0 | 1 => self.lanes[0] & other.lanes[0] != 0,
            _ => self.lanes.iter().zip(&other.lanes).any(|(a, b)| a & b != 0),
        }
    }

    /// The lanes of one sample.
    pub fn only(&self, sample: usize) -> Self {
        let mut only = Self::none(self.count);
        only[sample] = self[sample];
        only
    }

    /// With those lanes of `masks` that are among `lanes`.
    #[must_use]
    pub fn or(mut self, masks: &Self, lanes: u64) -> Self {
        for (to, from) in self.iter_mut().zip(masks.iter()) {
            *to |= from & lanes;
        }
        self
    }
}

impl Deref for SampleMasks {
    type Target = [u64];
    #[inline]
    fn deref(&self) -> &[u64] {
        &self.lanes[..self.count]
    }
}

impl DerefMut for SampleMasks {
    #[inline]
    fn deref_mut(&mut self) -> &mut [u64] {
        &mut self.lanes[..self.count]
    }
}

/// The positions for a requested number of samples: of one, two or four, the next larger; at most four.
fn positions_of(count: u8) -> &'static [[i32; 2]] {
    match count {
        0 | 1 => &CENTER,
        2 => &TWO,
        3.. => &FOUR,
    }
}

/// The number of samples for a requested number: 1, 2 or 4.
pub fn possible_samples(asked: u8) -> u8 {
    positions_of(asked).len() as u8
}

/// The sample positions for a number of samples, each in a cell of its own, in pixels from the pixel's lower left
/// corner.
pub fn sample_positions(count: u8) -> Vec<[f32; 2]> {
    positions_of(count)
        .iter()
        .map(|position| position.map(|v| 0.5 + v as f32 / SUBPIXEL as f32))
        .collect()
}

/// Two samples, from the pixel's centre, in subpixels.
const TWO: [[i32; 2]; 2] = [[64, 64], [-64, -64]];
/// Four: one in each row and each column of quarters of the pixel.
const FOUR: [[i32; 2]; 4] = [[-32, -96], [96, -32], [-96, 32], [32, 96]];

/// The centre of the pixel.
const CENTER: [[i32; 2]; 1] = [[0, 0]];

/// How a draw treats the samples of its pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Samples {
    /// How many there are: 1, 2 or 4.
    pub count: usize,
    /// Where each lies, from the pixel's centre, in subpixels; empty where all are covered, and
    /// have the depth, that the centre has.
    positions: &'static [[i32; 2]],
    /// The samples that coverage value and mask keep, bit by sample.
    kept: u8,
    /// The program output whose alpha determines how many samples are kept.
    pub alpha: Option<usize>,
    /// Whether the alpha that is written is 1.
    pub alpha_to_one: AlphaToOne,
    /// The program output that says which samples are kept, bit by sample.
    pub mask: Option<usize>,
    /// How often fragments are shaded.
    pub shading: SampleShading,
}

impl Samples {
    /// The samples of attachments that have `count` each, as a fragment program takes them.
    pub fn new(count: u8, state: &MultisampleState, fragment: &Program) -> Self {
        let alpha = fragment.output(Output::Color { target: 0, component: 3 });
        let each = positions_of(count);
        let count = each.len();
        if count == 1 {
            let alpha_to_one = AlphaToOne::Off;
            return Self {
                count,
                positions: &[],
                kept: 1,
                alpha: None,
                alpha_to_one,
                mask: None,
                shading: SampleShading::Once,
            };
        }
        let positions = match state.rule {
            SampleRule::Center => &[],
            SampleRule::Each => each,
        };
        Self {
            count,
            positions,
            kept: kept_by(state.coverage, count) & state.mask as u8,
            alpha: match state.alpha_to_coverage {
                AlphaToCoverage::On => alpha,
                AlphaToCoverage::Off => None,
            },
            alpha_to_one: state.alpha_to_one,
            mask: fragment.output(Output::SampleMask).filter(|_| !positions.is_empty()),
            shading: match positions {
                [] => SampleShading::Once,
                [..] if reads_sample(fragment) => SampleShading::Each,
                [..] => state.shading,
            },
        }
    }

    /// Where coverage is computed, from the pixel's centre, in subpixels: at every sample, or once
    /// for all.
    pub fn positions(&self) -> &'static [[i32; 2]] {
        if self.positions.is_empty() { &CENTER } else { self.positions }
    }

    /// Whether coverage is computed for each sample.
    pub fn is_each(&self) -> bool {
        !self.positions.is_empty()
    }

    /// Whether the samples of a fragment get its colour and nothing else is decided for each: not whether it is kept, its
    /// alpha, or where it is shaded.
    pub fn share_colors(&self) -> bool {
        !self.is_shaded_each()
            && self.alpha.is_none()
            && self.mask.is_none()
            && self.alpha_to_one == AlphaToOne::Off
    }

    /// Whether a fragment is shaded at each covered sample.
    pub fn is_shaded_each(&self) -> bool {
        self.shading == SampleShading::Each
    }

    /// Where a sample lies in its pixel, from the lower left corner; the centre where values are those of the centre.
    pub fn position(&self, sample: usize) -> [f32; 2] {
        self.offset(sample).map_or([0.5; 2], |offset| offset.map(|v| 0.5 + v))
    }

    /// Whether coverage value and mask keep a sample.
    pub fn keeps(&self, sample: usize) -> bool {
        self.kept >> sample & 1 == 1
    }

    /// Whether coverage value and mask keep every sample.
    pub fn keeps_all(&self) -> bool {
        (0..self.count).all(|sample| self.keeps(sample))
    }

    /// Removes what coverage value and mask do not keep, and the lanes that are not `inside`.
    #[inline]
    pub fn keep(&self, masks: &mut SampleMasks, inside: u64) {
        for (sample, mask) in masks.iter_mut().enumerate() {
            *mask &= if self.keeps(sample) { inside } else { 0 };
        }
    }

    /// From a pixel's centre to a sample, in pixels; `None` where values are those of the centre.
    pub fn offset(&self, sample: usize) -> Option<[f32; 2]> {
        self.positions.get(sample).map(|position| position.map(|v| v as f32 / SUBPIXEL as f32))
    }

    /// How far the centroid of each lane's covered samples lies from the pixel's centre, across and
    /// up in pixels; 0 where all or none are covered.
    #[inline(always)]
    pub fn centroids(&self, masks: &SampleMasks) -> [F32s; 2] {
        let mut sums = [F32s::ZERO; 2];
        let mut counts = F32s::ZERO;
        for (position, &mask) in self.positions.iter().zip(masks.iter()) {
            let position = position.map(|v| v as f32 / SUBPIXEL as f32);
            for lane in 0..LANES {
                let covered = (mask >> lane & 1) as f32;
                counts[lane] += covered;
                sums[0][lane] += covered * position[0];
                sums[1][lane] += covered * position[1];
            }
        }
        for sum in &mut sums {
            for lane in 0..LANES {
                let count = if counts[lane] > 0.0 { counts[lane] } else { 1.0 };
                sum[lane] /= count;
            }
        }
        sums
    }

    /// The samples that each lane's mask leaves, bit by sample.
    pub fn mask_by_program(&self, words: &U32s, masks: &mut SampleMasks) {
        for (sample, mask) in masks.iter_mut().enumerate() {
            let kept =
                |lanes: u64, lane: usize| lanes | u64::from(words[lane] >> sample & 1) << lane;
            *mask &= (0..LANES).fold(0, kept);
        }
    }

    /// The samples that each lane's alpha leaves: the nearest number to `alpha` times all of them.
    pub fn mask_by_alpha(&self, isa: Isa, alpha: &F32s, masks: &mut SampleMasks) {
        for (sample, mask) in masks.iter_mut().enumerate() {
            let least = (sample as f32 + 0.5) / self.count as f32;
            *mask &= isa.run(AlphaAtLeast { alpha, least });
        }
    }
}

/// Whether a program asks for the sample that is shaded.
fn reads_sample(fragment: &Program) -> bool {
    let mut inputs = fragment.inputs().iter();
    inputs.any(|input| matches!(input, Input::SampleId | Input::SamplePosition(_)))
}

/// The samples that the state's coverage leaves, bit by sample.
fn kept_by(coverage: Option<SampleCoverage>, count: usize) -> u8 {
    let all = (1_u8 << count) - 1;
    let first = |part: f32| {
        let count = (part.clamp(0.0, 1.0) * count as f32).round() as u32;
        ((1_u32 << count) - 1) as u8
    };
    match coverage {
        None => all,
        Some(SampleCoverage::Part(part)) => first(part),
        Some(SampleCoverage::AllBut(part)) => all & !first(part),
    }
}

/// A plane, given at a pixel's centre with its steps, moved to a sample.
#[inline(always)]
pub fn moved([corner, a, b]: [f32; 3], offset: Option<[f32; 2]>) -> [f32; 3] {
    match offset {
        Some([x, y]) => [corner + (x * a + y * b), a, b],
        None => [corner, a, b],
    }
}

/// The lanes whose alpha is not below `least`.
struct AlphaAtLeast<'a> {
    alpha: &'a F32s,
    least: f32,
}

impl Kernel for AlphaAtLeast<'_> {
    type Output = u64;
    #[inline(always)]
    fn run<S: Simd>(self) -> u64 {
        let mut passed = U32s::ZERO;
        for lane in 0..LANES {
            passed[lane] = u32::from(self.alpha[lane] >= self.least);
        }
        S::nonzero(&passed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coverage_leaves_the_nearest_number_of_samples() {
        for (coverage, left) in [
            (None, 0b1111),
            (Some(SampleCoverage::Part(0.0)), 0),
            (Some(SampleCoverage::Part(0.25)), 0b1),
            (Some(SampleCoverage::Part(0.5)), 0b11),
            (Some(SampleCoverage::Part(1.0)), 0b1111),
            (Some(SampleCoverage::AllBut(0.25)), 0b1110),
            (Some(SampleCoverage::AllBut(1.0)), 0),
            (Some(SampleCoverage::Part(f32::NAN)), 0),
        ] {
            assert_eq!(kept_by(coverage, 4), left, "{coverage:?}");
        }
    }

    #[test]
    fn samples_lie_in_rows_and_columns_of_their_own() {
        for axis in 0..2 {
            let mut quarters = FOUR.map(|position| (position[axis] + 128) / 64);
            quarters.sort_unstable();
            assert_eq!(quarters, [0, 1, 2, 3]);
        }
    }
}
