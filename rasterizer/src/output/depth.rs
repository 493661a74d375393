//! The depth test (GL 2.1, section 4.1.6), on the words that the attachment holds.

use super::mask::expand_mask;
use crate::driver::DepthWrite;
use texunit::format::Format;
use texunit::lanes::{F32s, Kernel, LANES, Simd, U32s};
use texunit::sampler::Compare;

/// The word of depth 1 in 16 bits.
const LARGEST_16: f64 = 65535.0;
/// The word of depth 1 in 24 bits.
const LARGEST_24: f64 = 16_777_215.0;

/// Added to what is less than 2^32, this rounds it to an integer, which is then in the lowest bits.
const TO_INTEGER: f64 = 4_503_599_627_370_496.0;

/// A depth in [0, 1] as the nearest word. `f64` holds the product exactly, so there is one rounding.
/// (The largest words are odd, so the only depth halfway between two words is 0.5.)
#[inline(always)]
fn unorm(depth: f32, largest: f64) -> u32 {
    (f64::from(depth) * largest + TO_INTEGER).to_bits() as u32
}

/// How depth is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthFormat {
    /// 16 bits.
    D16,
    /// 24 bits.
    D24,
    /// `f32`.
    D32F,
}

impl DepthFormat {
    /// The depth format of an attachment, if it is one.
    pub fn of(format: Format) -> Option<Self> {
        let row = Self::FORMATS.iter().find(|(stored, _)| *stored == format);
        row.map(|&(_, depth)| depth)
    }

    /// What can be tested and written; other depth formats are only sampled.
    const FORMATS: [(Format, Self); 5] = [
        (Format::D16, Self::D16),
        (Format::D24, Self::D24),
        (Format::D32F, Self::D32F),
        (Format::D24S8, Self::D24),
        (Format::D32FS8, Self::D32F),
    ];

    /// A difference that depths of two polygons keep, whatever they are; `None` where it depends on
    /// the value. One word is too little: a window depth has been rounded to `f32` before.
    pub fn resolution(self) -> Option<f64> {
        match self {
            Self::D16 => Some(2.0 / 65536.0),
            Self::D24 => Some(2.0 / 16_777_216.0),
            Self::D32F => None,
        }
    }

    /// The depth that a word stands for.
    pub fn depth(self, word: u32) -> f32 {
        match self {
            Self::D16 => (f64::from(word) / LARGEST_16) as f32,
            Self::D24 => (f64::from(word) / LARGEST_24) as f32,
            Self::D32F => f32::from_bits(word),
        }
    }

    /// The word of a depth in [0, 1].
    #[inline(always)]
    pub fn word(self, depth: f32) -> u32 {
        match self {
            Self::D16 => unorm(depth, LARGEST_16),
            Self::D24 => unorm(depth, LARGEST_24),
            Self::D32F => depth.to_bits(),
        }
    }
}

/// What a draw does with depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DepthPlan {
    /// How it is stored.
    pub format: DepthFormat,
    /// `new OP stored` must hold.
    pub test: Compare,
    /// Whether passing fragments write.
    pub write: DepthWrite,
}

/// Tests and writes 64 fragments; gives those that passed.
pub struct DepthTest<'a> {
    /// What is done.
    pub plan: DepthPlan,
    /// The depth of each, in [0, 1].
    pub depth: &'a F32s,
    /// The attachment's words.
    pub stored: &'a mut U32s,
    /// Which fragments there are.
    pub mask: u64,
}

impl Kernel for DepthTest<'_> {
    type Output = u64;
    #[inline(always)]
    fn run<S: Simd>(self) -> u64 {
        let Self { plan, depth, stored, mask } = self;
        let mut new = U32s::ZERO;
        match plan.format {
            DepthFormat::D16 => quantize(depth, LARGEST_16, &mut new),
            DepthFormat::D24 => quantize(depth, LARGEST_24, &mut new),
            DepthFormat::D32F => new = *depth.as_u32(),
        }
        let covered = expand_mask(mask);
        let mut pass = U32s::ZERO;
        match plan.test {
            Compare::Never => {}
            Compare::Less => compare(&mut pass, &new, stored, |a, b| a < b),
            Compare::Equal => compare(&mut pass, &new, stored, |a, b| a == b),
            Compare::LessEqual => compare(&mut pass, &new, stored, |a, b| a <= b),
            Compare::Greater => compare(&mut pass, &new, stored, |a, b| a > b),
            Compare::NotEqual => compare(&mut pass, &new, stored, |a, b| a != b),
            Compare::GreaterEqual => compare(&mut pass, &new, stored, |a, b| a >= b),
            Compare::Always => pass = U32s::splat(!0),
        }
        for lane in 0..LANES {
            pass[lane] &= covered[lane];
        }
        if plan.write == DepthWrite::On {
            for lane in 0..LANES {
                stored[lane] = (new[lane] & pass[lane]) | (stored[lane] & !pass[lane]);
            }
        }
        S::nonzero(&pass)
    }
}

/// All ones in the lanes where `holds`.
#[inline(always)]
fn compare(pass: &mut U32s, new: &U32s, stored: &U32s, holds: impl Fn(u32, u32) -> bool) {
    for lane in 0..LANES {
        pass[lane] = if holds(new[lane], stored[lane]) { !0 } else { 0 };
    }
}

/// [`DepthFormat::word`] over lanes.
#[inline(always)]
fn quantize(depth: &F32s, largest: f64, out: &mut U32s) {
    for lane in 0..LANES {
        out[lane] = unorm(depth[lane], largest);
    }
}
