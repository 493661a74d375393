//! Arithmetic on the numbers of pixels during a transfer.

use crate::lanes::{F64s, Isa, Kernel, LANES, Simd};

/// A transformation of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NumberTransform {
    /// `x · scale + bias`.
    Linear {
        /// The scale.
        scale: f64,
        /// The bias.
        bias: f64,
    },
    /// Clamps to [0, 1]; NaN stays.
    Clamp,
    /// The lower seven bits of an integer, after a clamp to 0 to 255.
    SevenBits,
    /// Rounds to the nearest integer, halves up, and clamps to `low` to `high`, which lie within -2^31 to 2^32. NaN gives
    /// `low`.
    Whole {
        /// The least.
        low: f64,
        /// The largest.
        high: f64,
    },
    /// Rounds to an `f32`.
    Float,
    /// `x / over · times`.
    Ratio {
        /// The divisor.
        over: f64,
        /// The factor.
        times: f64,
    },
}

/// A number whose sum with one below 2^51 is rounded to a whole number, halves to even.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Transforms 64 numbers.
pub fn transform(isa: Isa, change: NumberTransform, numbers: &F64s, out: &mut F64s) {
    isa.run(Transform { change, numbers, out });
}

struct Transform<'a> {
    change: NumberTransform,
    numbers: &'a F64s,
    out: &'a mut F64s,
}

impl Kernel for Transform<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { change, numbers, out } = self;
        match change {
            NumberTransform::Linear { scale, bias } => {
                for lane in 0..LANES {
                    out[lane] = numbers[lane] * scale + bias;
                }
            }
            NumberTransform::Clamp => {
                for lane in 0..LANES {
                    out[lane] = numbers[lane].clamp(0.0, 1.0);
                }
            }
            NumberTransform::SevenBits => {
                for lane in 0..LANES {
                    let byte = numbers[lane].clamp(0.0, 255.0);
                    out[lane] = if byte < 128.0 { byte } else { byte - 128.0 };
                }
            }
            NumberTransform::Whole { low, high } => {
                for lane in 0..LANES {
                    let up = numbers[lane] + 0.5;
                    let raised = if up > low { up } else { low };
                    let held = if raised < high { raised } else { high };
                    let whole = held + ROUND - ROUND;
                    out[lane] = if whole > held { whole - 1.0 } else { whole };
                }
            }
            NumberTransform::Float => {
                for lane in 0..LANES {
                    out[lane] = f64::from(numbers[lane] as f32);
                }
            }
            NumberTransform::Ratio { over, times } => {
                for lane in 0..LANES {
                    out[lane] = numbers[lane] / over * times;
                }
            }
        }
    }
}

/// Adds `weight · numbers[i]` to `sums[i]`.
pub fn add(isa: Isa, weight: f64, numbers: &[f64], sums: &mut [f64]) {
    isa.run(Add { weight, numbers, sums });
}

struct Add<'a> {
    weight: f64,
    numbers: &'a [f64],
    sums: &'a mut [f64],
}

impl Kernel for Add<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        for (sum, number) in self.sums.iter_mut().zip(self.numbers) {
            *sum += self.weight * number;
        }
    }
}
