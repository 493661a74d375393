//! The sRGB transfer function, as tables made at compile time from exact arithmetic.
//!
//! EXT_texture_sRGB, section 3.8.x: with `c` the byte over 255,
//! `linear = c / 12.92` up to `c = 0.04045`, else `((c + 0.055) / 1.055)^2.4`.
//! `x^2.4` is `x² · (x^(1/5))²`, and the fifth root comes from Newton's iteration in `f64`, so that
//! no platform's `pow` takes part.

use crate::lanes::math::clamp;
use crate::lanes::{F32s, LANES, Simd, U32s};

/// Linear light of each sRGB byte, the nearest `f32`.
pub static DECODE: [f32; 256] = {
    let mut table = [0.0; 256];
    let mut byte = 0;
    while byte < 256 {
        table[byte] = linear(byte as f64 / 255.0) as f32;
        byte += 1;
    }
    table
};

/// `THRESHOLDS[k]` is the least `f32` whose encoding is nearer to `k + 1` than to `k`: the linear
/// light of `(k + 1/2) / 255`, rounded up.
const THRESHOLDS: [f32; 255] = {
    let mut table = [0.0; 255];
    let mut k = 0;
    while k < 255 {
        let exact = linear((k as f64 + 0.5) / 255.0);
        let nearest = exact as f32;
        table[k] = if (nearest as f64) < exact { nearest.next_up() } else { nearest };
        k += 1;
    }
    table
};

/// 2^-13, below the first threshold.
const LEAST: f32 = 1.0 / 8192.0;
/// The last `f32` before 1, above the last threshold.
const MOST: f32 = 1.0_f32.next_down();
/// Bits of a float that tell it from others of its row.
const LOW: u32 = 16;
const LOW_MASK: u32 = (1 << LOW) - 1;
const ROWS: usize = ((1.0_f32.to_bits() - LEAST.to_bits()) >> LOW) as usize;

/// A row is 2^16 neighbouring floats, which have one byte or two. Above the low bits is the first one's byte,
/// in the low bits what has to be added to those of a float so that the sum carries from the threshold on.
static STEPS: [u32; ROWS] = {
    let mut table = [0; ROWS];
    let (mut row, mut byte) = (0, 0);
    while row < ROWS {
        let first = LEAST.to_bits() + ((row as u32) << LOW);
        let last = first + LOW_MASK;
        while byte < 255 && THRESHOLDS[byte].to_bits() <= first {
            byte += 1;
        }
        table[row] = (byte as u32) << LOW;
        if byte < 255 && THRESHOLDS[byte].to_bits() <= last {
            table[row] += last + 1 - THRESHOLDS[byte].to_bits();
            assert!(
                byte == 254 || THRESHOLDS[byte + 1].to_bits() > last,
                "two thresholds in a row"
            );
        }
        row += 1;
    }
    table
};

/// The offset of `x` in the table: its bits, clamped to those of the rows, less those of the first. NaN has offset 0.
#[inline(always)]
fn offset(x: f32) -> u32 {
    clamp(x, LEAST, MOST).to_bits() - LEAST.to_bits()
}

/// The byte of a float in a row.
#[inline(always)]
fn byte(step: u32, offset: u32) -> u32 {
    (step + (offset & LOW_MASK)) >> LOW
}

/// The sRGB byte nearest to linear light `x` on the encoded scale. Clamps; NaN gives 0.
#[inline(always)]
pub fn encode(x: f32) -> u8 {
    let offset = offset(x);
    byte(STEPS[(offset >> LOW) as usize], offset) as u8
}

/// [`encode`] of 64.
#[inline(always)]
pub(super) fn encode_lanes<S: Simd>(values: &F32s) -> U32s {
    let (mut offsets, mut rows) = (U32s::ZERO, U32s::ZERO);
    for lane in 0..LANES {
        offsets[lane] = offset(values[lane]);
        rows[lane] = offsets[lane] >> LOW;
    }
    let steps = S::gather_f32(bytemuck::cast_slice(&STEPS), &rows);
    let mut bytes = U32s::ZERO;
    for lane in 0..LANES {
        bytes[lane] = byte(steps.as_u32()[lane], offsets[lane]);
    }
    bytes
}

/// Linear light of an sRGB value in 0 to 1.
pub(super) const fn linear(c: f64) -> f64 {
    if c <= 0.04045 {
        c / 12.92
    } else {
        let x = (c + 0.055) / 1.055;
        let root = fifth_root(x);
        x * x * (root * root)
    }
}

/// `x^(1/5)` for `x` in 0.05 to 1, where 12 of Newton's steps from 1 reach the last bit.
const fn fifth_root(x: f64) -> f64 {
    let mut root = 1.0;
    let mut step = 0;
    while step < 12 {
        let fourth = root * root * root * root;
        root -= (root - x / fourth) / 5.0;
        step += 1;
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_the_formula() {
        for (byte, &got) in DECODE.iter().enumerate() {
            let c = byte as f64 / 255.0;
            let want = if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
            assert_eq!(got, want as f32, "byte {byte}");
        }
    }

    #[test]
    fn every_byte_survives_a_round_trip() {
        for byte in 0..=255u8 {
            assert_eq!(encode(DECODE[usize::from(byte)]), byte);
        }
    }

    #[test]
    fn a_threshold_belongs_to_the_upper_byte_and_what_is_below_it_to_the_lower() {
        for k in 0..255u8 {
            let threshold = THRESHOLDS[usize::from(k)];
            assert_eq!(encode(threshold), k + 1);
            assert_eq!(encode(threshold.next_down()), k);
        }
    }

    /// The definition: as many thresholds as are at or below.
    fn count(x: f32) -> u8 {
        THRESHOLDS.partition_point(|&threshold| x >= threshold) as u8
    }

    #[test]
    fn a_byte_is_the_number_of_thresholds_at_or_below() {
        // Every row's first and last float, and every 251st of all there are.
        for row in 0..1 << (32 - LOW) {
            for x in [row << LOW, (row << LOW) + LOW_MASK].map(f32::from_bits) {
                assert_eq!(encode(x), count(x), "{x:?}");
            }
        }
        for x in (0..=u32::MAX).step_by(251).map(f32::from_bits) {
            assert_eq!(encode(x), count(x), "{x:?}");
        }
    }

    #[test]
    fn anything_else_clamps() {
        for (x, want) in [
            (-1.0, 0),
            (-0.0, 0),
            (f32::NAN, 0),
            (f32::NEG_INFINITY, 0),
            (1.0, 255),
            (7.0, 255),
            (f32::INFINITY, 255),
        ] {
            assert_eq!(encode(x), want, "{x}");
        }
    }
}
