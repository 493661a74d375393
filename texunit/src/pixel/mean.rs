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

/// Adds the numbers of the first `count` lanes pixel by pixel, as [`means`] takes them.
pub fn interleave(numbers: &Numbers, count: usize, pixels: &mut Vec<[f64; 4]>) {
    let [a, b, c, d] = numbers;
    pixels.extend((0..count.min(LANES)).map(|lane| [a[lane], b[lane], c[lane], d[lane]]));
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
            let [below, beside] = [&low[left], &low[right]];
            let [above, across] = [&high[left], &high[right]];
            for (channel, out) in self.out.iter_mut().enumerate() {
                let lower = lerp(below[channel], beside[channel], tap.weight);
                let upper = lerp(above[channel], across[channel], tap.weight);
                out[lane] = lerp(lower, upper, self.weight);
            }
        }
    }
}
