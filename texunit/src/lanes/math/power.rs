//! Powers with an exponent that is known beforehand, as gamma curves have them: `(2^e m)^y` is `2^(e y) m^y`. The first
//! factor comes from a table, the second from a polynomial that is fitted to this exponent.

use super::exponential::pow;
use super::polynomial::polynomial;
use crate::lanes::{F32s, LANES, Simd, U32s};
use std::hash::{Hash, Hasher};

/// The powers of 32 exponents of two are in the table: of numbers from √½ · 2^-24 to below √2 · 2^7.
const SCALES: usize = 32;
/// The exponent of the first.
const FIRST: i32 = -24;
/// The bits of √½, where a mantissa begins.
const SQRT_HALF: u32 = std::f32::consts::FRAC_1_SQRT_2.to_bits();
/// The bits of the least number in reach of the table.
const LEAST: u32 = SQRT_HALF - ((-FIRST as u32) << 23);

/// Coefficients of the polynomial, and nodes of its fit.
const TERMS: usize = 8;
/// The zeros of the Chebyshev polynomial of degree 8, `cos((k + ½) π / 8)`.
const NODES: [f64; TERMS] = [
    0.980_785_280_403_230_4,
    0.831_469_612_302_545_2,
    0.555_570_233_019_602_3,
    0.195_090_322_016_128_25,
    -0.195_090_322_016_128_25,
    -0.555_570_233_019_602_3,
    -0.831_469_612_302_545_2,
    -0.980_785_280_403_230_4,
];
/// The mantissa less 1 is from -0.292… to 0.414…: the middle of that and half its length.
const MIDDLE: f64 = 0.060_660_171_779_821_29;
const HALF: f64 = 0.353_553_390_593_273_8;

/// The largest exponent, so that no scale leaves the range of `f32`.
const MAX_EXPONENT: f32 = 5.0;
/// The largest relative error of a fit.
const MAX_ERROR: f64 = 1.0 / 67_108_864.0;

/// `x^y` for one `y`. Within 0.7 ULP, as [`pow`] is; the bits of the two may differ.
#[derive(Clone, Debug)]
pub struct Power {
    exponent: f32,
    /// The power of 0.
    zero: f32,
    /// `2^(e y)` for the exponents of two in the table, as the sum of two.
    scales: [[f32; SCALES]; 2],
    /// `((1 + f)^y - 1) / f`.
    coefficients: [f64; TERMS],
}

impl Power {
    /// About how many additions of 64 lanes it takes as long as.
    pub const COST: u32 = 24;

    /// The powers with this exponent; `None` if no polynomial of this length comes near enough, as it does for those
    /// from about 0.3 to 5.
    #[must_use]
    pub fn new(exponent: f32) -> Option<Self> {
        let y = f64::from(exponent);
        if exponent == 0.0 || exponent.is_nan() || exponent.abs() > MAX_EXPONENT {
            return None;
        }
        let coefficients = fit(&binomials(y));
        if fit_error(&binomials(y), &coefficients) > MAX_ERROR {
            return None;
        }
        let exact: [f64; SCALES] =
            std::array::from_fn(|at| two_to(y * f64::from(at as i32 + FIRST)));
        let high = exact.map(|scale| scale as f32);
        let low = std::array::from_fn(|at| (exact[at] - f64::from(high[at])) as f32);
        let zero = if exponent > 0.0 { 0.0 } else { f32::INFINITY };
        Some(Self { exponent, zero, scales: [high, low], coefficients })
    }

    /// The exponent.
    #[must_use]
    pub fn exponent(&self) -> f32 {
        self.exponent
    }

    /// The power of a number.
    #[must_use]
    pub fn of(&self, x: f32) -> f32 {
        let number = scale_number(x);
        match self.scales.map(|scales| scales.get(number as usize).copied()) {
            [Some(high), Some(low)] => self.near(x, high, low),
            [None, _] | [_, None] if x.to_bits() == 0 => self.zero,
            [None, _] | [_, None] => pow(x, self.exponent),
        }
    }

    /// [`Self::of`] lane by lane.
    #[inline(always)]
    pub fn of_lanes<S: Simd>(&self, x: &F32s) -> F32s {
        let mut numbers = U32s::ZERO;
        let mut is_far = false;
        for lane in 0..LANES {
            let number = scale_number(x[lane]);
            numbers[lane] = number;
            is_far |= number >= SCALES as u32 && x[lane].to_bits() != 0;
        }
        // No closures: they would be compiled without the instructions of `S`.
        let high = select::<S>(&self.scales[0], &numbers);
        let low = select::<S>(&self.scales[1], &numbers);
        let mut out = F32s::ZERO;
        for lane in 0..LANES {
            let near = self.near(x[lane], high[lane], low[lane]);
            out[lane] = if x[lane].to_bits() == 0 { self.zero } else { near };
        }
        if is_far {
            for lane in 0..LANES {
                if numbers[lane] >= SCALES as u32 {
                    out[lane] = self.of(x[lane]);
                }
            }
        }
        out
    }

    /// The power of a number in reach of the table, with its scale.
    #[inline(always)]
    fn near(&self, x: f32, high: f32, low: f32) -> f32 {
        let mantissa = (x.to_bits().wrapping_sub(SQRT_HALF) & 0x007F_FFFF).wrapping_add(SQRT_HALF);
        let f = f64::from(f32::from_bits(mantissa) - 1.0);
        let scale = f64::from(high) + f64::from(low);
        (scale * (1.0 + f * polynomial(f, &self.coefficients))) as f32
    }
}

/// The number of the scale of `x`; no less than [`SCALES`] where there is none.
#[inline(always)]
fn scale_number(x: f32) -> u32 {
    x.to_bits().wrapping_sub(LEAST) >> 23
}

#[inline(always)]
fn select<S: Simd>(table: &[f32; SCALES], numbers: &U32s) -> F32s {
    let (low, high) = table.split_at(SCALES / 2);
    let low = S::select_from_sixteen(low.first_chunk().expect("half of the table"), numbers);
    let high = S::select_from_sixteen(high.first_chunk().expect("half of the table"), numbers);
    let mut selected = U32s::ZERO;
    for lane in 0..LANES {
        // By bits: LLVM makes gathers of a choice between two arrays.
        let is_high = 0_u32.wrapping_sub(numbers[lane] >> 4 & 1);
        selected[lane] = low[lane].to_bits() & !is_high | high[lane].to_bits() & is_high;
    }
    *selected.as_f32()
}

/// How many terms of the binomial series are summed: 0.42 to the power of their number is nothing beside an `f64`.
const SERIES: usize = 64;

/// The coefficients of `((1 + f)^y - 1) / f`, which converges for |f| below 1 (the binomial series).
fn binomials(y: f64) -> [f64; SERIES] {
    let mut coefficient = 1.0;
    std::array::from_fn(|at| {
        coefficient = coefficient * (y - at as f64) / (at as f64 + 1.0);
        coefficient
    })
}

fn horner(f: f64, coefficients: &[f64]) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * f + coefficient)
}

/// The polynomial through the series at the nodes, by Newton's divided differences.
fn fit(series: &[f64; SERIES]) -> [f64; TERMS] {
    let nodes = NODES.map(|node| MIDDLE + HALF * node);
    let mut differences = nodes.map(|node| horner(node, series));
    for order in 1..TERMS {
        for at in (order..TERMS).rev() {
            let over = nodes[at] - nodes[at - order];
            differences[at] = (differences[at] - differences[at - 1]) / over;
        }
    }
    let mut coefficients = [0.0; TERMS];
    for (node, difference) in nodes.iter().zip(differences).rev() {
        // All so far times (f - node), and the next difference.
        for at in (1..TERMS).rev() {
            coefficients[at] = coefficients[at - 1] - node * coefficients[at];
        }
        coefficients[0] = difference - node * coefficients[0];
    }
    coefficients
}

/// The largest relative error of the power itself over 257 mantissas.
fn fit_error(series: &[f64; SERIES], coefficients: &[f64; TERMS]) -> f64 {
    let error = |at: i32| {
        let f = MIDDLE + HALF * (f64::from(at) / 128.0);
        let exact = 1.0 + f * horner(f, series);
        ((1.0 + f * horner(f, coefficients)) / exact - 1.0).abs()
    };
    // A power near 0, whose error is no number, is none that comes near enough.
    let largest = |a: f64, b: f64| if b <= a { a } else { b };
    (-128..=128).map(error).fold(0.0, largest)
}

/// `2^t` to the last bits of an `f64`, by the series of the exponential function.
fn two_to(t: f64) -> f64 {
    let whole = t.round();
    let z = (t - whole) * std::f64::consts::LN_2;
    let mut term = 1.0;
    let mut sum = 1.0;
    for at in 1..24 {
        term = term * z / f64::from(at);
        sum += term;
    }
    sum * f64::from_bits(((whole as i64 + 1023) as u64) << 52)
}

/// By the exponent, of which all else follows.
impl PartialEq for Power {
    fn eq(&self, other: &Self) -> bool {
        self.exponent.to_bits() == other.exponent.to_bits()
    }
}

impl Eq for Power {}

impl Hash for Power {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.exponent.to_bits().hash(state);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{Isa, Kernel};

    const EXPONENTS: [f32; 16] = [
        0.333_333_34,
        0.416_666_66,
        0.45,
        0.454_545_44,
        0.5,
        0.75,
        1.0,
        1.2,
        1.5,
        1.8,
        2.0,
        2.2,
        2.4,
        3.0,
        4.0,
        5.0,
    ];

    fn ulps(got: f32, want: f64) -> f64 {
        let exponent = (want.abs().to_bits() >> 52) as i32 - 1023;
        (f64::from(got) - want).abs() / 2f64.powi(exponent.max(-126) - 23)
    }

    #[test]
    fn the_error_stays_below_the_stated_bound() {
        for exponent in EXPONENTS {
            let power = Power::new(exponent).expect("a power in reach");
            // All mantissas by a stride, at each exponent of the table and beyond.
            for bits in (0x3080_0000..0x4780_0000).step_by(3989) {
                let x = f32::from_bits(bits);
                let error = ulps(power.of(x), f64::from(x).powf(exponent.into()));
                assert!(error <= 0.7, "{x}^{exponent} is {error} ULP off");
            }
        }
    }

    #[test]
    fn whole_powers_of_short_numbers_are_exact() {
        for (exponent, count) in [(1.0, 1), (2.0, 2), (3.0, 3)] {
            let power = Power::new(exponent).expect("a power in reach");
            for x in 0..=100 {
                let x = x as f32;
                assert_eq!(power.of(x), x.powi(count), "{x}^{exponent}");
            }
        }
    }

    #[test]
    fn numbers_out_of_reach_have_the_power_of_any_exponent() {
        let far =
            [1e-30, 1e-45, 1e30, f32::INFINITY, f32::NAN, -0.0, -2.0, -1e-3, f32::NEG_INFINITY];
        for exponent in EXPONENTS {
            let power = Power::new(exponent).expect("a power in reach");
            assert_eq!(power.of(0.0), 0.0);
            for x in far {
                assert_eq!(power.of(x).to_bits(), pow(x, exponent).to_bits(), "{x}^{exponent}");
            }
        }
        for exponent in [0.0, -0.0, 17.0, f32::NAN, f32::INFINITY, 1e-30, -1.0, -5.0] {
            if let Some(power) = Power::new(exponent) {
                assert_eq!(power.of(0.0), pow(0.0, exponent), "0^{exponent}");
            }
        }
        assert!(
            [0.0, 17.0, f32::NAN, f32::INFINITY, -1.0].into_iter().all(|y| Power::new(y).is_none())
        );
    }

    struct Lanes<'a>(&'a Power, &'a F32s);

    impl Kernel for Lanes<'_> {
        type Output = F32s;

        fn run<S: Simd>(self) -> F32s {
            self.0.of_lanes::<S>(self.1)
        }
    }

    #[test]
    fn every_instruction_set_gives_the_bits_of_a_single_number() {
        let far = [0.0, -0.0, 1e-30, -1.5, f32::NAN, f32::INFINITY, 1e9];
        let near =
            F32s::from_fn(|lane| 2f32.powi(lane as i32 % 30 - 23) * (1.0 + lane as f32 / 64.0));
        let mixed =
            F32s::from_fn(|lane| if lane % 5 == 0 { far[lane / 5 % 7] } else { near[lane] });
        let zeros = F32s::from_fn(|lane| if lane % 3 == 0 { 0.0 } else { near[lane] });
        for exponent in EXPONENTS {
            let power = Power::new(exponent).expect("a power in reach");
            for x in [&near, &mixed, &zeros] {
                for isa in Isa::available() {
                    let got = isa.run(Lanes(&power, x));
                    for lane in 0..LANES {
                        let want = power.of(x[lane]);
                        let (got, isa) = (got[lane], isa.name());
                        assert_eq!(
                            got.to_bits(),
                            want.to_bits(),
                            "{}^{exponent} on {isa}",
                            x[lane]
                        );
                    }
                }
            }
        }
    }
}
