//! Every function against `f64`, over strided bit patterns of the whole domain and the extremes.

use super::*;

/// Zeros, subnormals, ones, quarter turns, limits, infinities, NaN; each with its neighbours.
fn extremes() -> impl Iterator<Item = f32> {
    let corners = [
        0.0,
        f32::MIN_POSITIVE,
        f32::from_bits(1),
        0.125,
        0.5,
        1.0,
        1.5,
        2.0,
        std::f32::consts::FRAC_PI_4,
        std::f32::consts::FRAC_PI_2,
        std::f32::consts::PI,
        88.722_84,
        89.415_985,
        103.972_08,
        126.0,
        127.0,
        128.0,
        149.0,
        150.0,
        16_367_173.0 * 4.0,
        2_147_483_648.0,
        4_294_967_296.0,
        8_388_608.0,
        268_435_456.0,
        4_194_304.0,
        f32::MAX,
        f32::INFINITY,
        f32::NAN,
    ];
    corners.into_iter().flat_map(|x: f32| {
        [x, f32::from_bits(x.to_bits().wrapping_sub(1)), f32::from_bits(x.to_bits() + 1)]
            .into_iter()
            .flat_map(|x| [x, -x])
    })
}

fn domain(stride: usize) -> impl Iterator<Item = f32> {
    (0..=u32::MAX).step_by(stride).map(f32::from_bits).chain(extremes())
}

/// The error in units of the last place of the exact result.
fn ulps(got: f32, want: f64) -> f64 {
    let rounded = want as f32;
    if rounded.is_nan() || got.is_nan() {
        return if rounded.is_nan() && got.is_nan() { 0.0 } else { f64::INFINITY };
    }
    if rounded.is_infinite() || got.is_infinite() || want == 0.0 {
        return if got.to_bits() == rounded.to_bits() { 0.0 } else { f64::INFINITY };
    }
    let exponent = (want.abs().to_bits() >> 52) as i32 - 1023;
    let ulp = 2f64.powi(exponent.max(-126) - 23);
    (f64::from(got) - want).abs() / ulp
}

fn unary(name: &str, bound: f64, got: fn(f32) -> f32, want: fn(f64) -> f64) {
    unary_of(domain(4801), name, bound, got, want);
}

fn unary_of(
    domain: impl Iterator<Item = f32>,
    name: &str,
    bound: f64,
    got: fn(f32) -> f32,
    want: fn(f64) -> f64,
) {
    let mut worst = (0.0, 0.0);
    for x in domain {
        let error = ulps(got(x), want(f64::from(x)));
        if error > worst.0 {
            worst = (error, x);
        }
    }
    assert!(worst.0 <= bound, "{name}({:?}) is {} ULP off", worst.1, worst.0);
}

#[test]
fn functions_of_one_number_keep_their_bounds() {
    unary("exp", 0.54, exp, f64::exp);
    unary("exp2", 0.54, exp2, f64::exp2);
    unary("log", 0.51, log, f64::ln);
    unary("log2", 0.51, log2, f64::log2);
    unary("asin", 0.51, asin, f64::asin);
    unary("acos", 0.51, acos, f64::acos);
    unary("atan", 0.51, atan, f64::atan);
    unary("sinh", 0.6, sinh, f64::sinh);
    unary("cosh", 0.6, cosh, f64::cosh);
    unary("tanh", 0.6, tanh, f64::tanh);
    unary("asinh", 0.51, asinh, |x| x.abs().asinh().copysign(x));
    unary("acosh", 0.51, acosh, f64::acosh);
    unary("atanh", 0.51, atanh, f64::atanh);
}

#[test]
fn circular_functions_keep_their_bounds_however_large_the_angle() {
    // Windows' library, by GNU, knows no more than 64 bits of π.
    let unknown = |x: &f32| cfg!(all(windows, target_env = "gnu")) && is_far(*x);
    let angles = || domain(4801).filter(|x| !unknown(x));
    unary_of(angles(), "sin", 0.6, sin, f64::sin);
    unary_of(angles(), "cos", 0.6, cos, f64::cos);
    unary_of(angles(), "tan", 0.51, tan, f64::tan);
}

/// What is held to `f64` on one machine holds on all.
#[test]
fn large_angles_have_the_same_bits_everywhere() {
    let bits = |f: fn(f32) -> f32| {
        let large = domain(4801).filter(|x| is_far(*x)).map(|x| f(x).to_bits());
        large.fold(0xCBF2_9CE4_8422_2325, |hash: u64, bits| {
            (hash ^ u64::from(bits)).wrapping_mul(0x100_0000_01B3)
        })
    };
    let known = [0xF5AC_7EF0_379B_F24B, 0xFD6F_7A42_998E_5C2B, 0xDBDE_A23F_39AB_E59D];
    assert_eq!([sin, cos, tan].map(bits), known);
}

#[test]
fn functions_of_two_numbers_keep_their_bounds() {
    let values: Vec<f32> = domain(12_345_677).collect();
    for &a in &values {
        for &b in &values {
            let error = ulps(atan2(a, b), f64::from(a).atan2(f64::from(b)));
            assert!(error <= 0.51, "atan2({a:?}, {b:?}) is {error} ULP off");
            let error = ulps(pow(a, b), f64::from(a).powf(b.into()));
            assert!(error <= 0.7, "pow({a:?}, {b:?}) = {} is {error} ULP off", pow(a, b));
        }
    }
    // Where results are ordinary numbers.
    for i in 1..1000u16 {
        for j in 0..200u8 {
            let (a, b) = (f32::from(i) / 97.0, f32::from(j) / 3.0 - 30.0);
            let error = ulps(pow(a, b), f64::from(a).powf(b.into()));
            assert!(error <= 0.7, "pow({a}, {b}) is {error} ULP off");
            let whole = b.round();
            let error = ulps(pow(-a, whole), f64::from(-a).powf(whole.into()));
            assert!(error <= 0.7, "pow({}, {whole}) is {error} ULP off", -a);
        }
    }
}

/// C23, section F.10.4.5, row by row.
#[test]
fn powers_of_what_is_negative() {
    const INF: f32 = f32::INFINITY;
    const NAN: f32 = f32::NAN;
    const ODD: f32 = 16_777_215.0;
    let rows = [
        ([-3.0, 2.0], 9.0),
        ([-2.0, 3.0], -8.0),
        ([-2.0, -1.0], -0.5),
        ([-2.0, 0.5], NAN),
        ([-2.0, 2.000_000_2], NAN),
        ([-2.0, 0.0], 1.0),
        ([-2.0, -0.0], 1.0),
        ([-NAN, 0.0], 1.0),
        ([-NAN, 2.0], NAN),
        ([-2.0, NAN], NAN),
        ([-1.0, NAN], NAN),
        ([-1.0, INF], 1.0),
        ([-1.0, -INF], 1.0),
        ([-2.0, INF], INF),
        ([-2.0, -INF], 0.0),
        ([-0.5, INF], 0.0),
        ([-0.5, -INF], INF),
        ([-1.0, ODD], -1.0),
        ([-1.0, ODD + 1.0], 1.0),
        ([-1.0, 8_388_607.5], NAN),
        ([-1.0, f32::MAX], 1.0),
        ([-0.0, 3.0], -0.0),
        ([-0.0, 2.0], 0.0),
        ([-0.0, 0.5], 0.0),
        ([-0.0, -3.0], -INF),
        ([-0.0, -2.0], INF),
        ([-0.0, -0.5], INF),
        ([-0.0, INF], 0.0),
        ([-INF, 3.0], -INF),
        ([-INF, 2.0], INF),
        ([-INF, 0.5], INF),
        ([-INF, -3.0], -0.0),
        ([-INF, -2.0], 0.0),
        ([-INF, -0.5], 0.0),
        ([-INF, -INF], 0.0),
        ([f32::MIN, 3.0], -INF),
        ([-f32::MIN_POSITIVE, 3.0], -0.0),
    ];
    for ([x, y], want) in rows {
        let got = pow(x, y);
        let same = got.to_bits() == want.to_bits() || got.is_nan() && want.is_nan();
        assert!(same, "pow({x}, {y}) = {got}, not {want}");
    }
}

#[test]
fn rounding_is_exact() {
    for x in domain(40_009) {
        let same = |got: f32, want: f32| got == want || (got.is_nan() && want.is_nan());
        assert!(same(floor(x), x.floor()), "floor({x:?})");
        assert!(same(ceil(x), x.ceil()), "ceil({x:?})");
        assert!(same(trunc(x), x.trunc()), "trunc({x:?})");
        assert!(same(round_even(x), x.round_ties_even()), "round_even({x:?})");
        let int = if x.is_nan() { i32::MIN } else { x as i32 };
        assert!(to_i32(x) == int || x >= 2_147_483_520.0, "to_i32({x:?})");
        assert!(to_u32(x) == x as u32 || x >= 4_294_967_040.0, "to_u32({x:?})");
    }
}

#[test]
fn an_index_is_the_integer_part_held_in_range() {
    for x in domain(40_009) {
        for last in [0.0, 1.0, 511.0, 16_383.0] {
            let want = if x.is_nan() { 0.0 } else { x.clamp(0.0, last) };
            assert_eq!(index(x, last), want as u32, "index({x:?}, {last})");
        }
        // No conversion is of what has no integer, whatever the last may be.
        for last in [-1.0, -3e9, f32::NEG_INFINITY, f32::NAN] {
            assert_eq!(index(x, last), 0, "index({x:?}, {last})");
        }
    }
}

#[test]
fn the_floor_of_small_numbers_is_the_floor() {
    let mut x = -4_000_000.9_f32;
    while x < 4_000_000.0 {
        for x in [x, x.floor(), x.floor().next_down(), x.floor().next_up(), x / 4096.0, x / 1e30] {
            assert_eq!(floor_small(x), (x.floor() as i32, x.floor()), "{x}");
        }
        x += 997.37;
    }
}

/// `mod` as a shader computes it.
fn modulo_of(a: f32, b: f32) -> f32 {
    let inverse = 1.0 / b;
    let nearest = round_even(a * inverse);
    let got = modulo(a, b, inverse, nearest);
    if b > 0.0 {
        let want = modulo_positive(a, b, nearest);
        assert_eq!(got.to_bits(), want.to_bits(), "mod({a:?}, {b:?})");
    }
    got
}

#[test]
fn mod_of_any_number_is_the_same_by_its_sign_and_by_its_word() {
    let corners =
        [0.0, f32::from_bits(1), 1e-30, 0.25, 144.5, 288.99998, 289.0, 1e9, 1e30, f32::MAX];
    let numbers = domain(1_000_003).chain(corners).flat_map(|a| [a, -a]);
    for a in numbers.chain([f32::INFINITY, f32::NEG_INFINITY, f32::NAN]) {
        for b in [1e-37, 0.1, 1.0, 289.0, 1e30, f32::MAX, f32::INFINITY] {
            // It compares them.
            modulo_of(a, b);
        }
    }
}

#[test]
fn mod_of_the_smallest_numbers_is_in_its_range() {
    for b in [289.0_f32, 1.0, 1e-30] {
        for bits in [1_u32, 2, 1000] {
            let a = -f32::from_bits(bits);
            assert_eq!(modulo_of(a, b), b, "mod({a:?}, {b:?})");
            assert_eq!(modulo_of(-a, -b), -b, "mod({:?}, {:?})", -a, -b);
        }
    }
}

#[test]
fn mod_of_whole_numbers_is_exact() {
    for b in 1..700_u16 {
        for a in (-70_000..70_000).step_by(41).chain(-3 * i32::from(b)..=3 * i32::from(b)) {
            let want = a.rem_euclid(b.into()) as f32;
            let (a, b) = (a as f32, f32::from(b));
            assert_eq!(modulo_of(a, b), want, "mod({a}, {b})");
            assert_eq!(modulo_of(-a, -b), -want, "mod({}, {})", -a, -b);
        }
    }
}

#[test]
fn mod_stays_in_its_range_and_loses_no_more_than_the_product() {
    let mut bits = 1_u32;
    let mut roll = || {
        bits = bits.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        bits
    };
    for _ in 0..1_000_000 {
        let quotient = f64::from(roll().max(1000)) / 4_294_967_296.0;
        let b = f32::from_bits(roll() & 0x7F7F_FFFF).clamp(1e-37, 1e30);
        let a = (f64::from(b) * 4_000_000.0 * quotient.powi(5)) as f32;
        let a = if roll() & 1 == 0 { a } else { -a };
        let (got, want) = (modulo_of(a, b), f64::from(a).rem_euclid(b.into()));
        assert!((0.0..=b).contains(&got), "mod({a:?}, {b:?}) = {got:?}");
        // 0 and `b` are neighbours.
        let off = (f64::from(got) - want).abs();
        let off = off.min(f64::from(b) - off);
        let ulp = |x: f32| f64::from(x.abs().next_up()) - f64::from(x.abs());
        assert!(off <= ulp(a) + ulp(b), "mod({a:?}, {b:?}) = {got:?}, not {want:?}");
    }
}

#[test]
fn a_byte_is_the_nearest_and_short_of_the_bounds_needs_none() {
    for c in domain(65_521) {
        let exact = (f64::from(c).clamp(0.0, 1.0) * 255.0 + 0.5).floor();
        let got = f64::from(byte(c));
        let is_tie = (f64::from(c) * 255.0).fract() - 0.5;
        let near = if is_tie.abs() < 1e-4 { 1.0 } else { 0.0 };
        assert!(c.is_nan() && got == 0.0 || (got - exact).abs() <= near, "{c}: {got}, {exact}");
        assert!(unit_byte(c) <= 255, "{c}");
    }
    let (least, most) = ((-0.001_f32).to_bits(), 1.001_f32.to_bits());
    for bits in ((-0.0_f32).to_bits()..least).step_by(65_521).chain((0..most).step_by(61)) {
        let c = f32::from_bits(bits);
        assert_eq!(unit_byte(c), byte(c), "{c}");
    }
    for number in 0..=255 {
        let c = (f64::from(number) / 255.0) as f32;
        assert_eq!([byte(c), unit_byte(c)], [number; 2]);
    }
}
