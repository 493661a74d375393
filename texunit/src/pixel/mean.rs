//! Weighted means of pixels, as a blit with a filter makes them.

use super::Numbers;
use crate::lanes::{Isa, Kernel, LANES, Simd};

/// Which two pixels of a row a mean is made of, and the weight of the second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tap {
    /// Columns.
    pub pixels: [usize; 2],
    /// 0 to 1.
    pub weight: f64,
}

/// Means of four pixels each: along two rows first, then of both; `weight` is the second row's. Of up to 64 taps, in
/// the first lanes.
///
/// # Panics
/// When a column is not in both rows.
pub fn means(isa: Isa, rows: [&[[f64; 4]]; 2], taps: &[Tap], weight: f64, out: &mut Numbers) {
    isa.run(Means { rows, taps, weight, out });
}

struct Means<'a> {
    rows: [&'a [[f64; 4]]; 2],
    taps: &'a [Tap],
    weight: f64,
    out: &'a mut Numbers,
}

/// `a` to `b`, exact where they are equal and where `t` is 0.
#[inline(always)]
fn lerp(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}

impl Kernel for Means<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let [low, high] = self.rows;
        for (lane, tap) in self.taps.iter().take(LANES).enumerate() {
            let [left, right] = tap.pixels;
            let corners = [&low[left], &low[right], &high[left], &high[right]];
            for channel in 0..4 {
                let lower = lerp(corners[0][channel], corners[1][channel], tap.weight);
                let upper = lerp(corners[2][channel], corners[3][channel], tap.weight);
                self.out[channel][lane] = lerp(lower, upper, self.weight);
            }
        }
    }
}
