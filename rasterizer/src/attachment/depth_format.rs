//! How depth is stored in an attachment (GL 2.1, section 2.14.9).

use texunit::format::Format;
use texunit::lanes::{F32s, LANES, U32s};

/// The word of depth 1 in 16 bits.
pub const LARGEST_16: f64 = 65535.0;

/// The word of depth 1 in 24 bits.
pub const LARGEST_24: f64 = 16_777_215.0;

/// Added to what is less than 2^32, this rounds it to an integer, which is then in the lowest bits.
const TO_INTEGER: f64 = 4_503_599_627_370_496.0;

/// A depth in [0, 1] as the nearest word. `f64` holds the product exactly, so there is one rounding.
/// (The largest words are odd, so the only depth halfway between two words is 0.5.)
#[inline(always)]
pub fn depth_word(depth: f32, largest: f64) -> u32 {
    (f64::from(depth) * largest + TO_INTEGER).to_bits() as u32
}

/// [`DepthFormat::word`] over lanes.
#[inline(always)]
pub fn depth_words(format: DepthFormat, depth: &F32s, out: &mut U32s) {
    match format {
        DepthFormat::D16 => quantize(depth, LARGEST_16, out),
        DepthFormat::D24 => quantize(depth, LARGEST_24, out),
        DepthFormat::D32F => *out = *depth.as_u32(),
    }
}

#[inline(always)]
fn quantize(depth: &F32s, largest: f64, out: &mut U32s) {
    for lane in 0..LANES {
        out[lane] = depth_word(depth[lane], largest);
    }
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
            Self::D16 => depth_word(depth, LARGEST_16),
            Self::D24 => depth_word(depth, LARGEST_24),
            Self::D32F => depth.to_bits(),
        }
    }
}
