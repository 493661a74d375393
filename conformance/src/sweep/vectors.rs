//! GLSL's functions of vectors (GLSL 1.30, section 8.4) over all sizes, and about their decisions.

use super::definition::Sweep;
use super::series::{Series, decades};
use super::shaded::{dot, of, shaded, three};
use crate::check::Unit;
use crate::probe::ProbeError;
use crate::rng::Rng;

/// The unit in the last place of 1.
const STEP: f64 = 1.0 / (1 << 23) as f64;

/// Unit vectors.
pub const NORMALIZE: Sweep = Sweep {
    name: "normalize",
    what: "normalize(v) of vectors of this size, in units in the last place of 1",
    parameter: "size of v",
    unit: "of 2^-23",
    // Three products and their sum, a reciprocal root and a product: each half a unit.
    bound: 2.0,
    why: "a handful of roundings, each half a unit; the square of the size is never formed unscaled",
    breaks: "the square of a size beyond 1e±19 leaves f32, and the sum is formed in f64 there; below 1.2e-38 the inverse of a length does: such vectors come out shorter than 1, and that of no length gives no number",
    kept: 0.4,
    distinct: 0.9,
    before: &[],
    run: normalize,
};

/// Lengths.
pub const LENGTH: Sweep = Sweep {
    name: "length",
    what: "length(v) of vectors of this size",
    parameter: "size of v",
    unit: "ULP",
    bound: 2.0,
    why: "three products, two sums, a root, each half a unit",
    breaks: "beyond 1e±19 the square leaves f32 and the length must not; a length above the largest \
             f32 is infinite",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: length,
};

/// Distances.
pub const DISTANCE: Sweep = Sweep {
    name: "distance",
    what: "distance(p, q) of points about 1 that lie this far from each other",
    parameter: "distance",
    unit: "ULP",
    bound: 2.0,
    why: "the difference of two floats is rounded once; then as length",
    breaks: "below 6e-8 the points are the same floats, and the distance is exactly 0",
    kept: 1.0,
    distinct: 0.4,
    before: &[],
    run: distance,
};

/// Reflections.
pub const REFLECT: Sweep = Sweep {
    name: "reflect",
    what: "reflect(i, n) of vectors i of this size, as part of the size",
    parameter: "size of i",
    unit: "of 2^-23",
    bound: 3.0,
    why: "i - 2·dot(n, i)·n: five roundings of terms of at most twice the size",
    breaks: "denormal products are rounded to 2^-149; 2·dot(n, i) overflows from 1.7e38 on, which \
             is not tried",
    kept: 0.9,
    distinct: 0.9,
    before: &[],
    run: reflect,
};

/// Faces that turn.
pub const FACEFORWARD: Sweep = Sweep {
    name: "faceforward",
    what: "the sign of faceforward(n, i, nref) where i is this far from perpendicular to nref",
    parameter: "sine of the angle",
    unit: "wrong signs",
    bound: 0.0,
    why: "the sign of a dot product is right where it exceeds its three roundings",
    breaks: "below about 1e-7 the sign is that of rounding, which is not compared",
    kept: 0.0,
    distinct: 0.9,
    before: &[],
    run: faceforward,
};

/// Total reflection.
pub const REFRACT: Sweep = Sweep {
    name: "refract",
    what: "refract(i, n, 1.5) this far from the critical angle, by k = 1 - η²(1 - dot²)",
    parameter: "size of k",
    unit: "of 2^-24/max(√k, 2^-11)",
    bound: 4.5,
    why: "k has the roundings of terms of size 1; √k makes 1/(2√k) of them",
    breaks: "at |k| < 2^-21 rounding decides between refraction and total reflection, and either is \
             accepted; never a value that is neither",
    kept: 1.0,
    distinct: 0.4,
    before: &[],
    run: refract,
};

fn sized(rng: &mut Rng, size: f64) -> [f32; 4] {
    let mut part = || (f64::from(rng.real(-1.0, 1.0)) * size) as f32;
    [part(), part(), part(), 0.0]
}

fn unit(rng: &mut Rng) -> [f64; 3] {
    let v = [0; 3].map(|_: i32| f64::from(rng.real(-1.0, 1.0)));
    let length = dot(v, v).sqrt().max(1e-3);
    v.map(|c| c / length)
}

/// The largest difference of three components.
fn apart(exact: [f64; 3], measured: [f64; 4]) -> f64 {
    exact.iter().zip(measured).map(|(e, m)| Unit::FullScale.error(*e, m)).fold(0.0, f64::max)
}

fn single([x, y, z]: [f64; 3]) -> [f32; 4] {
    [x as f32, y as f32, z as f32, 0.0]
}

fn normalize() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("normalize");
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(normalize(a.xyz), 0.0); }";
    let case = |size| of(sized(&mut rng, size));
    let line = shaded("largest error", decades(-45..=38), body, case, |[a, _], value| {
        let v = three(*a);
        // Halved first: the squares of the largest floats fit f64 anyway, those of denormals too.
        let length = dot(v, v).sqrt();
        if length > 0.0 && length < f64::from(f32::MIN_POSITIVE) {
            // No promise but a direction that is a number.
            let is_short = value.iter().all(|c| c.abs() <= 1.0);
            return Some(if is_short { 0.0 } else { f64::INFINITY });
        }
        (length > 0.0).then(|| apart(v.map(|c| c / length), value) / STEP)
    })?;
    Ok(vec![line])
}

fn length() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("length");
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(length(a.xyz), 0.0, 0.0, 0.0); }";
    let sizes = decades(-45..=38).chain([3.4e38]);
    let case = |size| of(sized(&mut rng, size));
    let line = shaded("largest error", sizes, body, case, |[a, _], value| {
        let v = three(*a);
        Some(Unit::Ulp.error(dot(v, v).sqrt(), value[0]))
    })?;
    Ok(vec![line])
}

fn distance() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("distance");
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(distance(a.xyz, b.xyz), 0.0, 0.0, 0.0); }";
    let case = |size| {
        let p = sized(&mut rng, 1.0);
        let d = sized(&mut rng, size);
        [p, [p[0] + d[0], p[1] + d[1], p[2] + d[2], 0.0]]
    };
    let line = shaded("largest error", decades(-10..=38), body, case, |[a, b], value| {
        let (p, q) = (three(*a), three(*b));
        let d = [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
        Some(Unit::Ulp.error(dot(d, d).sqrt(), value[0]))
    })?;
    Ok(vec![line])
}

fn reflect() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("reflect");
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(reflect(a.xyz, b.xyz), 0.0); }";
    let case = |size| [sized(&mut rng, size), single(unit(&mut rng))];
    let line = shaded("largest error", decades(-40..=37), body, case, |[a, b], value| {
        let (i, n) = (three(*a), three(*b));
        let twice = 2.0 * dot(n, i);
        let exact = [0, 1, 2].map(|c| i[c] - twice * n[c]);
        let size = dot(i, i).sqrt();
        // A denormal has no relative precision: its step is the unit.
        let unit = (size * STEP).max(2f64.powi(-149));
        (size > 0.0).then(|| apart(exact, value) / unit)
    })?;
    Ok(vec![line])
}

fn faceforward() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("faceforward");
    let body = "vec4 value(vec4 a, vec4 b) {
        return vec4(faceforward(vec3(1.0, 2.0, 3.0), a.xyz, b.xyz), 0.0);
    }";
    let case = |sine: f64| {
        let n = unit(&mut rng);
        let other = unit(&mut rng);
        let along = dot(n, other);
        let side = if rng.integer(0, 1) == 0 { sine } else { -sine };
        let i = [0, 1, 2].map(|c| other[c] - along * n[c] + side * n[c]);
        [single(i), single(n)]
    };
    let line = shaded("wrong signs", decades(-12..=3), body, case, |[a, b], value| {
        let (i, n) = (three(*a), three(*b));
        let exact = dot(i, n);
        let terms: f64 = i.iter().zip(n).map(|(x, y)| (x * y).abs()).sum();
        let sign = if exact < 0.0 { 1.0 } else { -1.0 };
        let expected = [1.0, 2.0, 3.0].map(|c| c * sign);
        let wrong = if apart(expected, value) == 0.0 { 0.0 } else { 1.0 };
        // Where rounding decides, either sign; but nothing else.
        let other = apart(expected.map(|c| -c), value) == 0.0;
        if exact.abs() > terms * STEP { Some(wrong) } else { Some(if other { 0.0 } else { wrong }) }
    })?;
    Ok(vec![line])
}

fn refract() -> Result<Vec<Series>, ProbeError> {
    const ETA: f64 = 1.5;
    let mut lines = Vec::new();
    for (name, sign) in [("refraction", 1.0), ("total reflection", -1.0)] {
        let mut rng = Rng::named(name);
        let body = "vec4 value(vec4 a, vec4 b) { return vec4(refract(a.xyz, b.xyz, 1.5), 0.0); }";
        let case = |k: f64| {
            let k = sign * k * f64::from(rng.real(0.5, 1.0));
            // dot² = 1 - (1 - k)/η².
            let cosine = (1.0 - (1.0 - k) / (ETA * ETA)).max(0.0).sqrt();
            let (n, other) = (unit(&mut rng), unit(&mut rng));
            let along = dot(n, other);
            let side = [0, 1, 2].map(|c| other[c] - along * n[c]);
            let length = dot(side, side).sqrt();
            let sine = (1.0 - cosine * cosine).sqrt();
            let i = [0, 1, 2].map(|c| side[c] / length * sine - n[c] * cosine);
            [single(i), single(n)]
        };
        let sizes = (0..=20).map(|step| 10f64.powf(-f64::from(step) / 2.0));
        lines.push(shaded(name, sizes, body, case, |[a, b], value| {
            let (i, n) = (three(*a), three(*b));
            let along = dot(n, i);
            let k = 1.0 - ETA * ETA * (1.0 - along * along);
            let root = k.max(0.0).sqrt();
            let refracted = [0, 1, 2].map(|c| ETA * i[c] - (ETA * along + root) * n[c]);
            let scale = 2f64.powi(-24) / k.abs().sqrt().max(2f64.powi(-11));
            let (of_refracted, of_none) = (apart(refracted, value), apart([0.0; 3], value));
            let error = match k {
                k if k.abs() < 2f64.powi(-21) => of_refracted.min(of_none),
                k if k < 0.0 => of_none,
                _ => of_refracted,
            };
            Some(error / scale)
        })?);
    }
    Ok(lines)
}
