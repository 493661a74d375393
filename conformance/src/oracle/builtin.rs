//! GLSL's built-in functions in `f64` (GLSL 1.30, chapter 8): the formula, the domain of the
//! cases, and, where terms cancel, the magnitude whose unit in the last place is the unit of errors.
//!
//! GLSL 1.30 gives no bounds. Those here are what rounding takes. A rounding to nearest is off by half a ULP; a relative error
//! of 2^-24 by less than one, as the mantissa is below 2, so that a polynomial within 2^-n of a function adds 2^(24 - n).

use crate::rng::Rng;

/// The vectors `a`, `b` and `c` of a case.
pub type Inputs = [[f64; 4]; 3];

/// A function as a row of the report.
#[derive(Clone, Copy, Debug)]
pub struct Builtin {
    /// Of the check: `ulp-` and the function.
    pub name: &'static str,
    /// The call.
    pub glsl: &'static str,
    /// The domain in words.
    pub what: &'static str,
    /// A random case.
    pub case: fn(&mut Rng) -> [[f32; 4]; 3],
    /// The value.
    pub value: fn(&Inputs) -> f64,
    /// The magnitude of the largest term; 0 if no terms cancel.
    pub size: fn(&Inputs) -> f64,
    /// Largest error that passes, in ULP.
    pub bound: f64,
    /// The reason for it.
    pub why: &'static str,
}

/// `x` as the first number of a case.
fn one(x: f32) -> [[f32; 4]; 3] {
    [[x, 0.0, 0.0, 0.0], [0.0; 4], [0.0; 4]]
}

/// Any float: all exponents, denormals, ±0, ±inf, NaN.
fn any(rng: &mut Rng) -> [[f32; 4]; 3] {
    one(f32::from_bits(rng.integer(0, i64::from(u32::MAX)) as u32))
}

/// Any float but NaN that is not negative.
fn positive(rng: &mut Rng) -> [[f32; 4]; 3] {
    one(f32::from_bits(rng.integer(0, 0x7f80_0000) as u32))
}

/// Any finite float; every second one is between -16 and 16.
fn moderate(rng: &mut Rng) -> [[f32; 4]; 3] {
    if rng.integer(0, 1) == 0 {
        return one(rng.real(-16.0, 16.0));
    }
    loop {
        let [[x, ..], ..] = any(rng);
        if x.is_finite() {
            return one(x);
        }
    }
}

/// [-1, 1], half of it near the ends or 0.
fn unit(rng: &mut Rng) -> [[f32; 4]; 3] {
    let near = (rng.real(-24.0, 0.0)).exp2();
    let sign = rng.pick(&[-1.0f32, 1.0]);
    one(match rng.integer(0, 3) {
        0 => sign * near,
        1 => sign * (1.0 - near),
        _ => rng.real(-1.0, 1.0),
    })
}

/// From 1 up.
fn above_one(rng: &mut Rng) -> [[f32; 4]; 3] {
    one(match rng.integer(0, 1) {
        0 => 1.0 + rng.real(-23.0, 0.0).exp2(),
        _ => f32::from_bits(rng.integer(0x3f80_0000, 0x7f7f_ffff) as u32),
    })
}

/// A base of any size and an exponent whose result is mostly finite, whole below 0.
fn power(rng: &mut Rng) -> [[f32; 4]; 3] {
    let x = match rng.integer(0, 2) {
        0 => rng.real(0.9, 1.1),
        1 => f32::from_bits(rng.integer(1, 0x7f7f_ffff) as u32),
        _ => rng.real(0.0, 16.0).max(1e-30),
    };
    let reach = (150.0 / f64::from(x).log2().abs().max(1e-6)).min(1e30);
    let y = rng.real(-reach, reach);
    let (x, y) = if rng.integer(0, 3) == 0 { (-x, y.round()) } else { (x, y) };
    [[x, y, 0.0, 0.0], [0.0; 4], [0.0; 4]]
}

/// Two numbers of all exponents, no NaN nor infinity.
fn two(rng: &mut Rng) -> [[f32; 4]; 3] {
    let [[x, ..], ..] = moderate(rng);
    let [[y, ..], ..] = moderate(rng);
    [[x, y, 0.0, 0.0], [0.0; 4], [0.0; 4]]
}

/// Vectors of components between -8 and 8.
fn vectors(rng: &mut Rng) -> [[f32; 4]; 3] {
    [0; 3].map(|_: i32| [0; 4].map(|_: i32| rng.real(-8.0, 8.0)))
}

/// A direction, a unit normal and an index of refraction without total reflection.
fn normals(rng: &mut Rng) -> [[f32; 4]; 3] {
    loop {
        let mut vector = || {
            let v = [0; 3].map(|_: i32| f64::from(rng.real(-1.0, 1.0)));
            let length = v.iter().map(|c| c * c).sum::<f64>().sqrt().max(1e-3);
            v.map(|c| (c / length) as f32)
        };
        let ([ix, iy, iz], [nx, ny, nz]) = (vector(), vector());
        let eta = rng.real(0.3, 1.5);
        let cosine = f64::from(ix * nx + iy * ny + iz * nz);
        let k = 1.0 - f64::from(eta * eta) * (1.0 - cosine * cosine);
        if k > 0.05 {
            return [[ix, iy, iz, 0.0], [nx, ny, nz, 0.0], [eta, 0.0, 0.0, 0.0]];
        }
    }
}

/// A number and a positive divisor, the quotient not near an integer.
fn divisible(rng: &mut Rng) -> [[f32; 4]; 3] {
    loop {
        let (x, y) = (rng.real(-100.0, 100.0), rng.real(0.01, 10.0));
        if (0.001..0.999).contains(&(f64::from(x) / f64::from(y)).rem_euclid(1.0)) {
            return [[x, y, 0.0, 0.0], [0.0; 4], [0.0; 4]];
        }
    }
}

/// Two edges in order, and a number about them.
fn edges(rng: &mut Rng) -> [[f32; 4]; 3] {
    let low = rng.real(-4.0, 4.0);
    [[low, low + rng.real(0.5, 4.0), rng.real(-8.0, 8.0), 0.0], [0.0; 4], [0.0; 4]]
}

fn none(_: &Inputs) -> f64 {
    0.0
}

fn dot(a: [f64; 4], b: [f64; 4], n: usize) -> f64 {
    a.iter().zip(b).take(n).map(|(a, b)| a * b).sum()
}

fn dot_size(a: [f64; 4], b: [f64; 4], n: usize) -> f64 {
    a.iter().zip(b).take(n).map(|(a, b)| (a * b).abs()).sum()
}

/// The factor of N in `refract`: `eta·dot(N, I) + √k`.
fn refraction([i, n, c]: &Inputs) -> f64 {
    let (eta, cosine) = (c[0], dot(*i, *n, 3));
    eta * cosine + (1.0 - eta * eta * (1.0 - cosine * cosine)).sqrt()
}

/// A bound in ULP, and the reason for it.
type Bound = (f64, &'static str);

const EXACT: Bound = (0.0, "an integer that f32 has");
const ONCE: Bound = (0.5, "the exact value is rounded once");
const FACTOR: Bound =
    (0.7, "one product, rounded once; its factor as f32 is off by 0.13 or 0.2 of 2^-24");
const INVERSE_ROOT: Bound = (
    1.5,
    "a root that is rounded once, and whose error counts twice where it is next to 1, then a quotient",
);
const CIRCULAR: Bound =
    (0.6, "f64, rounded once; a polynomial of sin within 2^-27.5, which is 0.09");
const PRECISE: Bound = (0.51, "f64, rounded once; polynomials within 2^-33 and less, 0.002 each");
const EXPONENTIAL: Bound =
    (0.54, "f64, rounded once; a polynomial of 2^t within 2^-28.9, which is 0.034");
const HYPERBOLIC: Bound = (
    0.6,
    "f64, rounded once; e^x within 2^-28.9, which the difference to e^-x makes up to three times as much, 0.1",
);

/// The functions of one argument, over their whole domain.
macro_rules! unary {
    ($name:literal, $glsl:literal, $what:literal, $case:ident, $bound:ident, $value:expr) => {
        Builtin {
            name: $name,
            glsl: $glsl,
            what: $what,
            case: $case,
            value: |i| {
                let f: fn(f64) -> f64 = $value;
                f(i[0][0])
            },
            size: none,
            bound: $bound.0,
            why: $bound.1,
        }
    };
}

/// All functions that are computed and not looked up in a table.
pub const BUILTINS: &[Builtin] = &[
    unary!("ulp-radians", "radians(a.x)", "any float", any, FACTOR, |x| x.to_radians()),
    unary!("ulp-degrees", "degrees(a.x)", "any float", any, FACTOR, |x| x.to_degrees()),
    unary!("ulp-sin", "sin(a.x)", "any finite float", moderate, CIRCULAR, |x| x.sin()),
    unary!("ulp-cos", "cos(a.x)", "any finite float", moderate, CIRCULAR, |x| x.cos()),
    unary!("ulp-tan", "tan(a.x)", "any finite float", moderate, PRECISE, |x| x.tan()),
    unary!("ulp-asin", "asin(a.x)", "[-1, 1]", unit, PRECISE, |x| x.asin()),
    unary!("ulp-acos", "acos(a.x)", "[-1, 1]", unit, PRECISE, |x| x.acos()),
    unary!("ulp-atan", "atan(a.x)", "any float", any, PRECISE, |x| x.atan()),
    unary!("ulp-sinh", "sinh(a.x)", "any finite float", moderate, HYPERBOLIC, |x| x.sinh()),
    unary!("ulp-cosh", "cosh(a.x)", "any finite float", moderate, HYPERBOLIC, |x| x.cosh()),
    unary!("ulp-tanh", "tanh(a.x)", "any finite float", moderate, HYPERBOLIC, |x| x.tanh()),
    unary!("ulp-asinh", "asinh(a.x)", "any finite float", moderate, PRECISE, |x| x.asinh()),
    unary!("ulp-acosh", "acosh(a.x)", "from 1 up", above_one, PRECISE, |x| x.acosh()),
    unary!("ulp-atanh", "atanh(a.x)", "[-1, 1]", unit, PRECISE, |x| x.atanh()),
    unary!("ulp-exp", "exp(a.x)", "any float", any, EXPONENTIAL, |x| x.exp()),
    unary!("ulp-exp2", "exp2(a.x)", "any float", any, EXPONENTIAL, |x| x.exp2()),
    unary!("ulp-log", "log(a.x)", "any float from 0 up", positive, PRECISE, |x| x.ln()),
    unary!("ulp-log2", "log2(a.x)", "any float from 0 up", positive, PRECISE, |x| x.log2()),
    unary!("ulp-sqrt", "sqrt(a.x)", "any float from 0 up", positive, ONCE, |x| x.sqrt()),
    unary!(
        "ulp-inversesqrt",
        "inversesqrt(a.x)",
        "any float from 0 up",
        positive,
        INVERSE_ROOT,
        |x| 1.0 / x.sqrt()
    ),
    unary!("ulp-floor", "floor(a.x)", "any float", any, EXACT, |x| x.floor()),
    unary!("ulp-ceil", "ceil(a.x)", "any float", any, EXACT, |x| x.ceil()),
    unary!("ulp-trunc", "trunc(a.x)", "any float", any, EXACT, |x| x.trunc()),
    unary!("ulp-roundEven", "roundEven(a.x)", "any float", any, EXACT, |x| x.round_ties_even()),
    unary!("ulp-fract", "fract(a.x)", "any finite float", moderate, ONCE, |x| x - x.floor()),
    Builtin {
        name: "ulp-atan2",
        glsl: "atan(a.x, a.y)",
        what: "any two finite floats",
        case: two,
        value: |i| i[0][0].atan2(i[0][1]),
        size: none,
        bound: 0.51,
        why: PRECISE.1,
    },
    Builtin {
        name: "ulp-pow",
        glsl: "pow(a.x, a.y)",
        what: "any base, below 0 to whole exponents, up to overflow and underflow",
        case: power,
        value: |i| i[0][0].powf(i[0][1]),
        size: none,
        bound: 0.71,
        why: "f64, rounded once; log2 within 2^-33 of up to 150 is 0.17 in the exponent, 2^t within 2^-28.9 is 0.034",
    },
    Builtin {
        name: "ulp-mod",
        glsl: "mod(a.x, a.y)",
        what: "x - y·floor(x/y), |x| up to 100; ULP of x",
        case: divisible,
        value: |i| i[0][0] - i[0][1] * (i[0][0] / i[0][1]).floor(),
        size: |i| i[0][0].abs(),
        bound: 1.5,
        why: "y·n, rounded by half a ULP of x or, where it is beyond the next power of two, a whole one; the difference by half",
    },
    Builtin {
        name: "ulp-mix",
        glsl: "mix(a.x, a.y, a.z)",
        what: "x·(1-a) + y·a; ULP of the larger term",
        case: vectors,
        value: |i| i[0][0] * (1.0 - i[0][2]) + i[0][1] * i[0][2],
        size: |i| (i[0][0] * (1.0 - i[0][2])).abs().max((i[0][1] * i[0][2]).abs()),
        bound: 3.0,
        why: "1 - a by less than a ULP of its term, both products by half a ULP, their sum, up to twice the larger, by one",
    },
    Builtin {
        name: "ulp-smoothstep",
        glsl: "smoothstep(a.x, a.y, a.z)",
        what: "t²(3-2t) of the place between two edges; ULP of 1",
        case: edges,
        value: |i| {
            let t = ((i[0][2] - i[0][0]) / (i[0][1] - i[0][0])).clamp(0.0, 1.0);
            t * t * (3.0 - 2.0 * t)
        },
        size: |_| 1.0,
        bound: 2.0,
        why: "two differences and a quotient by 2^-24 of t each, of which t² (3 - 2t) makes up to 0.89: 1.33 ULP of 1; square, sum and product by at most 1/4 each, which do not meet at one t",
    },
    Builtin {
        name: "ulp-length",
        glsl: "length(a)",
        what: "vec4",
        case: vectors,
        value: |i| dot(i[0], i[0], 4).sqrt(),
        size: none,
        bound: 2.5,
        why: "a square and three sums by 2^-24 each, half of which is left in the root: 2; the root by half",
    },
    Builtin {
        name: "ulp-distance",
        glsl: "distance(a.xyz, b.xyz)",
        what: "vec3; ULP of the larger component",
        case: vectors,
        value: |i| {
            let d: [f64; 4] = std::array::from_fn(|c| i[0][c] - i[1][c]);
            dot(d, d, 3).sqrt()
        },
        size: |i| i[0].iter().chain(&i[1]).fold(0.0, |m: f64, c| m.max(c.abs())),
        bound: 3.0,
        why: "differences of up to twice a component by a ULP of it, shared by three directions, and the roundings of a length: twice the root of the sum of squares",
    },
    Builtin {
        name: "ulp-dot",
        glsl: "dot(a, b)",
        what: "vec4; ULP of the sum of sizes",
        case: vectors,
        value: |i| dot(i[0], i[1], 4),
        size: |i| dot_size(i[0], i[1], 4),
        bound: 3.0,
        why: "products by 2^-24 of the sum of sizes together, less than a ULP; three sums of a quarter, a half, three quarters and all of it by half a ULP of each: twice the root of the sum of squares",
    },
    Builtin {
        name: "ulp-cross",
        glsl: "cross(a.xyz, b.xyz).x",
        what: "a.y·b.z - a.z·b.y; ULP of the sum of sizes",
        case: vectors,
        value: |i| i[0][1] * i[1][2] - i[0][2] * i[1][1],
        size: |i| (i[0][1] * i[1][2]).abs() + (i[0][2] * i[1][1]).abs(),
        bound: 2.0,
        why: "both products together by 2^-24 of the sum of sizes, less than a ULP, and the difference by as much",
    },
    Builtin {
        name: "ulp-normalize",
        glsl: "normalize(a.xyz).y",
        what: "vec3",
        case: vectors,
        value: |i| i[0][1] / dot(i[0], i[0], 3).sqrt(),
        size: none,
        bound: 4.0,
        why: "three squares and their sums by 2^-24 each, half of which is left in the root: 1.5; root, quotient and product by as much as 2^-24 each: less than 4.5, and the largest do not meet",
    },
    Builtin {
        name: "ulp-reflect",
        glsl: "reflect(a.xyz, b.xyz).z",
        what: "I - 2·dot(N, I)·N; ULP of the sum of sizes",
        case: vectors,
        value: |i| i[0][2] - 2.0 * dot(i[0], i[1], 3) * i[1][2],
        size: |i| i[0][2].abs() + 2.0 * dot_size(i[0], i[1], 3) * i[1][2].abs(),
        bound: 4.0,
        why: "dot by 3, twice of it and of N by 2^-24 of the sum of sizes, and the difference by half a ULP: as many as meet",
    },
    Builtin {
        name: "ulp-refract",
        glsl: "refract(a.xyz, b.xyz, c.x).x",
        what: "eta·I - (eta·dot(N, I) + √k)·N of unit vectors, k > 1/20; ULP of 2",
        case: normals,
        value: |i| i[2][0] * i[0][0] - refraction(i) * i[1][0],
        size: |_| 2.0,
        bound: 4.0,
        why: "k has the roundings of five terms up to 2.25, by 2^-23 each, of which √k above 0.22 leaves twice; then two products and a difference below 2: twice the root of the sum of squares",
    },
];
