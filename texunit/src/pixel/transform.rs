//! What is done to numbers on their way from pixels to pixels.

use crate::lanes::{F64s, Isa, Kernel, LANES, Simd};

/// What is done to a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NumberTransform {
    /// It is taken times a scale, and a bias is added.
    Linear {
        /// The scale.
        scale: f64,
        /// The bias.
        bias: f64,
    },
    /// It is clamped to [0, 1]; NaN stays.
    Clamp,
    /// The lower seven bits of a whole number are taken, of one that is clamped to a byte.
    SevenBits,
    /// It goes to the nearest whole number, halves up, and is held within these, which lie within -2^31 to 2^32.
    /// NaN gives the least.
    Whole {
        /// The least.
        low: f64,
        /// The largest.
        high: f64,
    },
    /// It is rounded to an `f32`.
    Float,
    /// It is divided by one number, and then multiplied with another.
    Ratio {
        /// The divisor.
        over: f64,
        /// The factor.
        times: f64,
    },
}

/// A number whose sum with one below 2^51 is rounded to a whole number, halves to even.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Numbers with something done to them.
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
                    let held = if up > low { up } else { low };
                    let held = if held < high { held } else { high };
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

/// Adds numbers, each times a weight, to as many sums.
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
