//! GLSL's built-in functions: their error in ULP over the whole domain, and their values where it
//! ends.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::{Mutation, Variant};
use crate::oracle::builtin::{BUILTINS, Builtin};
use crate::probe::ProbeError;
use crate::rng::Rng;

const COUNT: usize = BUILTINS.len();

/// A check for each function.
pub const ULP: [Check; COUNT] = {
    let mut checks = [check(0); COUNT];
    let mut row = 1;
    while row < COUNT {
        checks[row] = check(row);
        row += 1;
    }
    checks
};

/// The check of a row of [`BUILTINS`]. `run` is a function pointer, so the row is a constant parameter of it.
const fn check(row: usize) -> Check {
    let Builtin { name, what, bound, why, .. } = BUILTINS[row];
    Check {
        name,
        citation: "GLSL 1.30, chapter 8",
        what,
        unit: Unit::Ulp,
        tolerance: bound,
        why,
        run: RUN[row],
    }
}

type Run = fn(&Harness, &mut Tally) -> Result<(), ProbeError>;

/// `run::<0>`, `run::<1>`, …
macro_rules! runs {
    ($($row:literal)*) => { [$(run::<$row>),*] };
}

const RUN: [Run; COUNT] = runs!(
    0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32 33 34
    35 36
);

fn run<const ROW: usize>(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let Builtin { name, glsl, case, value, size, .. } = BUILTINS[ROW];
    let mut rng = Rng::named(name);
    let cases: Vec<[[f32; 4]; 3]> = (0..harness.cases(1 << 17)).map(|_| case(&mut rng)).collect();
    let exact = |case: &[[f32; 4]; 3]| case.map(|v| v.map(f64::from));
    let expect = |case: &[[f32; 4]; 3], variant: Variant| {
        let value = value(&exact(case));
        let cut = variant.has(Mutation::BuiltinOf18Bits);
        [if cut { cut_to_18_bits(value) } else { value }, 0.0, 0.0, 0.0]
    };
    let error = |case: &[[f32; 4]; 3], expected: [f64; 4], measured: [f64; 4]| {
        let size = size(&exact(case));
        if size > expected[0].abs() {
            // Shifted so that a unit in the last place is that of the largest term.
            Unit::Ulp.error(size, size + (measured[0] - expected[0]))
        } else {
            Unit::Ulp.error(expected[0], measured[0])
        }
    };
    harness.compare_by(tally, &glsl, &cases, expect, error, |session| {
        let body = format!("vec4 value() {{ return vec4({glsl}, 0.0, 0.0, 0.0); }}");
        session.field(&body, 1, &cases)
    })
}

/// Marks a value that the check only looks up in its table.
pub(super) fn cut_to_18_bits(value: f64) -> f64 {
    if value.is_finite() {
        f64::from_bits(value.to_bits() & !0xffff_ffff) * (1.0 + 2f64.powi(-18))
    } else {
        1.0
    }
}

/// Functions at the ends of their domains.
pub const EXTREMES: Check = Check {
    name: "builtin-extremes",
    citation: "GLSL 1.30, chapter 8; IEEE 754",
    what: "pow, exp2, log2, sin, cos, atan of huge, denormal and infinite numbers, ±0 and NaN",
    unit: Unit::Ulp,
    tolerance: 0.5,
    why: "limits are exact or rounded once: half a ULP",
    run: extremes,
};

/// Function and arguments, and the limit that they have.
type Extreme = (&'static str, [f32; 2], f64);

fn extremes_table() -> Vec<Extreme> {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    const INF: f32 = f32::INFINITY;
    const NAN: f32 = f32::NAN;
    const TINY: f32 = f32::from_bits(1);
    let (inf, nan) = (f64::INFINITY, f64::NAN);
    vec![
        ("exp2(a.x)", [INF, 0.0], inf),
        ("exp2(a.x)", [-INF, 0.0], 0.0),
        ("exp2(a.x)", [128.0, 0.0], inf),
        ("exp2(a.x)", [127.0, 0.0], 2f64.powi(127)),
        ("exp2(a.x)", [-149.0, 0.0], 2f64.powi(-149)),
        ("exp2(a.x)", [-151.0, 0.0], 0.0),
        ("exp2(a.x)", [TINY, 0.0], 1.0),
        ("exp2(a.x)", [NAN, 0.0], nan),
        ("log2(a.x)", [0.0, 0.0], -inf),
        ("log2(a.x)", [INF, 0.0], inf),
        ("log2(a.x)", [TINY, 0.0], -149.0),
        ("log2(a.x)", [-1.0, 0.0], nan),
        ("log2(a.x)", [NAN, 0.0], nan),
        ("log2(a.x)", [1.0, 0.0], 0.0),
        ("pow(a.x, a.y)", [0.0, 2.0], 0.0),
        ("pow(a.x, a.y)", [0.0, TINY], 0.0),
        ("pow(a.x, a.y)", [INF, 2.0], inf),
        ("pow(a.x, a.y)", [INF, -2.0], 0.0),
        ("pow(a.x, a.y)", [2.0, INF], inf),
        ("pow(a.x, a.y)", [0.5, INF], 0.0),
        ("pow(a.x, a.y)", [2.0, 200.0], inf),
        ("pow(a.x, a.y)", [2.0, -149.0], 2f64.powi(-149)),
        ("pow(a.x, a.y)", [7.25, 0.0], 1.0),
        ("pow(a.x, a.y)", [TINY, 1.0], 2f64.powi(-149)),
        ("pow(a.x, a.y)", [-3.0, 2.0], 9.0),
        ("pow(a.x, a.y)", [-2.0, 3.0], -8.0),
        ("pow(a.x, a.y)", [-2.0, 0.5], nan),
        ("pow(a.x, a.y)", [-INF, -3.0], -0.0),
        ("pow(a.x, a.y)", [-1.0, INF], 1.0),
        ("sin(a.x)", [0.0, 0.0], 0.0),
        ("sin(a.x)", [INF, 0.0], nan),
        ("sin(a.x)", [NAN, 0.0], nan),
        ("sin(a.x)", [TINY, 0.0], 2f64.powi(-149)),
        ("sin(a.x)", [f32::MAX, 0.0], f64::from(f32::MAX).sin()),
        ("sin(a.x)", [1e22, 0.0], f64::from(1e22f32).sin()),
        ("cos(a.x)", [0.0, 0.0], 1.0),
        ("cos(a.x)", [-INF, 0.0], nan),
        ("cos(a.x)", [f32::MAX, 0.0], f64::from(f32::MAX).cos()),
        ("cos(a.x)", [TINY, 0.0], 1.0),
        ("atan(a.x)", [INF, 0.0], FRAC_PI_2),
        ("atan(a.x)", [-INF, 0.0], -FRAC_PI_2),
        ("atan(a.x)", [TINY, 0.0], 2f64.powi(-149)),
        ("atan(a.x)", [NAN, 0.0], nan),
        ("atan(a.x, a.y)", [0.0, -1.0], PI),
        ("atan(a.x, a.y)", [-0.0, -1.0], -PI),
        ("atan(a.x, a.y)", [1.0, 0.0], FRAC_PI_2),
        ("atan(a.x, a.y)", [-1.0, 0.0], -FRAC_PI_2),
        ("atan(a.x, a.y)", [0.0, 1.0], 0.0),
        ("atan(a.x, a.y)", [TINY, TINY], FRAC_PI_4),
        ("atan(a.x, a.y)", [f32::MAX, f32::MAX], FRAC_PI_4),
        ("atan(a.x, a.y)", [1e-30, f32::MAX], 0.0),
        ("sqrt(a.x)", [INF, 0.0], inf),
        ("sqrt(a.x)", [TINY, 0.0], 2f64.powi(-149).sqrt()),
        ("inversesqrt(a.x)", [INF, 0.0], 0.0),
        ("inversesqrt(a.x)", [TINY, 0.0], 2f64.powi(149).sqrt()),
        ("abs(a.x)", [-INF, 0.0], inf),
        ("floor(a.x)", [-TINY, 0.0], -1.0),
        ("fract(a.x)", [-0.25, 0.0], 0.75),
        ("sign(a.x)", [-TINY, 0.0], -1.0),
    ]
}

fn extremes(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let table = extremes_table();
    let mut functions: Vec<&str> = table.iter().map(|row| row.0).collect();
    functions.dedup();
    for function in functions {
        let cases: Vec<Extreme> = table.iter().filter(|row| row.0 == function).copied().collect();
        let expect = |case: &Extreme, variant: Variant| {
            let flushed = variant.has(Mutation::DenormalsFlushed) && case.2.abs() < 1e-38;
            let finite = variant.has(Mutation::InfinityIsLargest) && case.2.is_infinite();
            let value = if flushed {
                -1.0
            } else if finite {
                f64::from(f32::MAX)
            } else {
                case.2
            };
            [value, 0.0, 0.0, 0.0]
        };
        harness.compare(tally, &function, &cases, expect, |session| {
            let body = format!("vec4 value() {{ return vec4({function}, 0.0, 0.0, 0.0); }}");
            let inputs: Vec<_> = cases
                .iter()
                .map(|&(_, [x, y], _)| [[x, y, 0.0, 0.0], [0.0; 4], [0.0; 4]])
                .collect();
            session.field(&body, 1, &inputs)
        })?;
    }
    Ok(())
}
