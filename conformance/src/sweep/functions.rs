//! GLSL's functions of numbers (GLSL 1.30, sections 8.1 to 8.3) at their ends.

use super::definition::Sweep;
use super::series::{Series, decades, octaves};
use super::shaded::{of, shaded};
use crate::check::Unit;
use crate::probe::ProbeError;
use crate::rng::Rng;

/// Remainders.
pub const MOD: Sweep = Sweep {
    name: "mod",
    what: "mod(x, y) against the exact remainder of x and y, and whether it leaves [0, y]",
    parameter: "x/y",
    unit: "of x·2^-24",
    bound: 2.1,
    why: "x - y·n rounds the product once, by half a unit of x, and the difference once more",
    breaks: "a quotient beyond 2^22 has no exact integer n in f32: the formula's own rounding, as GLSL writes it, leaves [0, y) by as much as x·2^-24; below, it never does",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: modulo,
};

/// Fractions.
pub const FRACT: Sweep = Sweep {
    name: "fract",
    what: "fract(x) and floor(x) of x this far below an integer",
    parameter: "distance from the integer",
    unit: "ULP",
    bound: 0.5,
    why: "x - floor(x) is rounded once",
    breaks: "just below 0 the exact fraction is nearer to 1 than to the float below 1: the result \
             is 1, as the formula's rounding has it",
    kept: 1.0,
    distinct: 0.2,
    before: &[],
    run: fract,
};

/// Powers.
pub const POW: Sweep = Sweep {
    name: "pow",
    what: "pow(x, y) with exponents of this size and x so near to 1 that the power is neither 0 nor \
           infinite",
    parameter: "y",
    unit: "ULP",
    bound: 1.0,
    why: "log2 and exp2 are evaluated with more than 24 bits between them",
    breaks: "y·log2(x) of f32 would lose a bit with every doubling of y; here none is lost",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: pow,
};

/// Highlights.
pub const HIGHLIGHT: Sweep = Sweep {
    name: "blinn-phong",
    what: "pow(dot(n, h), e) of unit vectors at an angle of 1/√e, as part of e·2^-24",
    parameter: "exponent e",
    unit: "of e·2^-24",
    bound: 4.0,
    why: "the power of x(1 + d) is that of x, times 1 + e·d: the roundings of unit vectors and of \
          their dot product count e times",
    breaks: "from e = 2^24 on a highlight is narrower than the step of dot products at 1: it is drawn \
             as noise of the highlight's height, or not at all; never above 1 + e·2^-22",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: highlight,
};

/// Ends of exp2.
pub const EXP2: Sweep = Sweep {
    name: "exp2-ends",
    what: "exp2(x) from the smallest denormal to beyond the largest float",
    parameter: "x + 160",
    unit: "ULP",
    bound: 1.0,
    why: "of denormals too: a unit is 2^-149",
    breaks: "below -150 the result is 0, from 128 on infinite",
    kept: 1.0,
    distinct: 0.5,
    before: &[],
    run: exp2,
};

/// Ends of log2.
pub const LOG2: Sweep = Sweep {
    name: "log2-ends",
    what: "log2(x) of x this far from 1 on either side, and of x of this size",
    parameter: "distance from 1, or x",
    unit: "ULP",
    bound: 1.0,
    why: "about 1 the result is as small as the distance, and keeps its bits",
    breaks: "the logarithm of a denormal is that of its value; of 0 it is -infinite",
    kept: 0.4,
    distinct: 0.5,
    before: &[],
    run: log2,
};

/// Edges that meet.
pub const SMOOTHSTEP: Sweep = Sweep {
    name: "smoothstep",
    what: "smoothstep(e, e + d, x) with x between the edges, or on either side",
    parameter: "d, distance of the edges",
    unit: "of 2^-24",
    bound: 3.5,
    why: "x - e and the edges' difference are exact nearby; a division, then t²(3 - 2t)",
    breaks: "edges that are equal in f32 make a step, as step(e, x): GLSL leaves it undefined; on \
             the edge itself it may be either",
    kept: 1.0,
    distinct: 0.5,
    before: &[],
    run: smoothstep,
};

/// Mixtures of unlike sizes.
pub const MIX: Sweep = Sweep {
    name: "mix",
    what: "mix(x, y, t) of y that is this many times x, of y = x, and at t = 0 and 1",
    parameter: "y/x",
    unit: "of the larger's 2^-23",
    bound: 1.0,
    why: "x·(1 - t) + y·t: three roundings, each of half a unit of the larger at most",
    breaks: "t = 0 gives x and t = 1 gives y exactly, at any ratio; mix(x, x, t) may be a unit off",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: mix,
};

/// The seam of angles.
pub const ATAN: Sweep = Sweep {
    name: "atan-seams",
    what: "atan(y, x) this far from each axis, in all quadrants",
    parameter: "distance from the axis over distance along it",
    unit: "ULP",
    bound: 0.75,
    why: "all of it in more bits than f32 has, rounded once",
    breaks: "at the negative x axis the sign of y decides between π and -π, also of y = -0 and of \
             denormals",
    kept: 1.0,
    distinct: 0.5,
    before: &[],
    run: atan,
};

/// Large angles.
pub const SIN_COS: Sweep = Sweep {
    name: "sin-cos-large",
    what: "sin(x) and cos(x) of angles of this size, in units in the last place of 1",
    parameter: "x in radians",
    unit: "of 2^-24",
    bound: 1.0,
    why: "x less the nearest multiple of π/2, with as many bits of π as that takes",
    breaks: "neighbouring floats are more than a turn apart from 1e8 on: the value is right for the \
             float that is given, which says little of the angle that was meant",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: sin_cos,
};

/// Ends of the arc cosine.
pub const ACOS: Sweep = Sweep {
    name: "acos-ends",
    what: "acos(x) of x this far from 1 and from -1",
    parameter: "distance from ±1",
    unit: "ULP",
    bound: 0.75,
    why: "all of it in more bits than f32 has, rounded once",
    breaks: "outside of [-1, 1] GLSL leaves the result undefined, and it is no number",
    kept: 1.0,
    distinct: 0.5,
    before: &[],
    run: acos,
};

/// Roots of all sizes.
pub const ROOTS: Sweep = Sweep {
    name: "square-roots",
    what: "sqrt(x) and inversesqrt(x) of x of this size",
    parameter: "x",
    unit: "ULP",
    bound: 1.5,
    why: "a root is rounded correctly; its reciprocal is rounded twice",
    breaks: "denormals have roots like others; inversesqrt(0) is infinite",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: roots,
};

fn modulo() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("mod");
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(mod(a.x, a.y), 0.0, 0.0, 0.0); }";
    let case = |quotient: f64| {
        let y = rng.real(0.5, 8.0);
        let x = f64::from(y) * quotient * f64::from(rng.real(-1.0, 1.0));
        of([x as f32, y, 0.0, 0.0])
    };
    let line = shaded("largest error", octaves(0..=40, 2), body, case, |[a, _], value| {
        let [x, y] = [a[0], a[1]].map(f64::from);
        // The remainder of f64 numbers is exact.
        let exact = x.rem_euclid(y);
        let inside = (0.0..=y).contains(&value[0]);
        if !inside && (x / y).abs() < 4_194_304.0 {
            return Some(f64::INFINITY);
        }
        // Next to 0 and next to y are the same; beyond, whole multiples of y are off by rounding.
        let apart = (value[0] - exact).abs();
        let apart = apart.min((apart - y).abs());
        Some(apart / (x.abs().max(y) * 2f64.powi(-24)))
    })?;
    Ok(vec![line])
}

fn fract() -> Result<Vec<Series>, ProbeError> {
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(fract(a.x), floor(a.x), 0.0, 0.0); }";
    let mut lines = Vec::new();
    for (name, far) in [("below 0", 0), ("below other integers", 1 << 22)] {
        let mut rng = Rng::named(name);
        let case = |distance: f64| {
            let integer = rng.integer(-far, far) as f64;
            of([(integer - distance * f64::from(rng.real(0.5, 1.0))) as f32, 0.0, 0.0, 0.0])
        };
        lines.push(shaded(name, decades(-45..=0), body, case, |[a, _], value| {
            let x = f64::from(a[0]);
            let floor = Unit::Ulp.error(x.floor(), value[1]);
            Some(Unit::Ulp.error(x - x.floor(), value[0]).max(floor))
        })?);
    }
    Ok(lines)
}

fn pow() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("pow");
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(pow(a.x, a.y), 0.0, 0.0, 0.0); }";
    let exponents = (0..=16).map(|step| 10f64.powf(f64::from(step) / 2.0));
    let case = |exponent: f64| {
        let y = exponent as f32;
        of([(f64::from(rng.real(-80.0, 80.0)) / f64::from(y)).exp() as f32, y, 0.0, 0.0])
    };
    let line = shaded("largest error", exponents, body, case, |[a, _], value| {
        let [x, y] = [a[0], a[1]].map(f64::from);
        Some(Unit::Ulp.error(x.powf(y), value[0]))
    })?;
    Ok(vec![line])
}

fn highlight() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("blinn-phong");
    let body = "vec4 value(vec4 a, vec4 b) {
        vec3 n = normalize(a.xyz);
        vec3 h = normalize(b.xyz);
        return vec4(pow(max(dot(n, h), 0.0), a.w), 0.0, 0.0, 0.0);
    }";
    let exponents = (0..=16).map(|step| 10f64.powf(f64::from(step) / 2.0));
    let case = |exponent: f64| {
        let angle = f64::from(rng.real(0.0, 2.0)) / exponent.sqrt().max(1.5);
        let turn = f64::from(rng.real(0.0, 6.0));
        let n = [turn.cos(), turn.sin(), 0.3];
        let h = [(turn + angle).cos(), (turn + angle).sin(), 0.3];
        let single = |v: [f64; 3], w: f64| [v[0] as f32, v[1] as f32, v[2] as f32, w as f32];
        [single(n, exponent), single(h, exponent)]
    };
    let line = shaded("largest error", exponents, body, case, |[a, b], value| {
        let [n, h] = [a, b].map(|v| super::shaded::three(*v));
        let dot = super::shaded::dot;
        // |n × h|² = |n|²|h|² - dot²: the cosine from the sine has no cancellation.
        let cross =
            [n[1] * h[2] - n[2] * h[1], n[2] * h[0] - n[0] * h[2], n[0] * h[1] - n[1] * h[0]];
        let sine2 = dot(cross, cross) / (dot(n, n) * dot(h, h));
        let e = f64::from(a[3]);
        let exact = (0.5 * e * (-sine2).ln_1p()).exp();
        Some((value[0] - exact).abs() / (e * 2f64.powi(-24)))
    })?;
    Ok(vec![line])
}

fn exp2() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("exp2-ends");
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(exp2(a.x), 0.0, 0.0, 0.0); }";
    let places = (2..=145).map(|step| f64::from(step) * 2.0);
    let case = |place| of([(place - 160.0) as f32 + rng.real(-2.0, 0.0), 0.0, 0.0, 0.0]);
    let line = shaded("largest error", places, body, case, |[a, _], value| {
        Some(Unit::Ulp.error(f64::from(a[0]).exp2(), value[0]))
    })?;
    Ok(vec![line])
}

fn log2() -> Result<Vec<Series>, ProbeError> {
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(log2(a.x), 0.0, 0.0, 0.0); }";
    let mut lines = Vec::new();
    for (name, one) in [("about 1", 1.0), ("all sizes", 0.0)] {
        let mut rng = Rng::named(name);
        let case = |size: f64| {
            let sign = if one == 0.0 { 1.0 } else { f64::from(rng.pick(&[-1.0f32, 1.0])) };
            of([(one + sign * size * f64::from(rng.real(0.5, 1.0))) as f32, 0.0, 0.0, 0.0])
        };
        let sizes = if one == 0.0 { -45..=38 } else { -24..=-1 };
        let sizes = sizes
            .map(|exponent| if one == 0.0 { 10f64.powi(exponent) } else { 2f64.powi(exponent) });
        lines.push(shaded(name, sizes, body, case, |[a, _], value| {
            let x = f64::from(a[0]);
            (x > 0.0).then(|| Unit::Ulp.error(x.log2(), value[0]))
        })?);
    }
    Ok(lines)
}

fn smoothstep() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("smoothstep");
    let body = "vec4 value(vec4 a, vec4 b) {
        return vec4(smoothstep(a.x, a.y, a.z), 0.0, 0.0, 0.0);
    }";
    let case = |distance: f64| {
        let edge = rng.real(-1.0, 1.0);
        let other = (f64::from(edge) + distance) as f32;
        let x = f64::from(edge) + distance * f64::from(rng.real(-0.5, 1.5));
        of([edge, other, x as f32, 0.0])
    };
    let line = shaded("largest error", decades(-12..=6), body, case, |[a, _], value| {
        let [e0, e1, x] = [a[0], a[1], a[2]].map(f64::from);
        if e0 == e1 {
            // A step; on the edge either.
            let step = if x < e0 { 0.0 } else { 1.0 };
            let either = x == e0 && (value[0] == 0.0 || value[0] == 1.0);
            return Some(if either || value[0] == step { 0.0 } else { f64::INFINITY });
        }
        let t = ((x - e0) / (e1 - e0)).clamp(0.0, 1.0);
        Some((value[0] - t * t * (3.0 - 2.0 * t)).abs() / 2f64.powi(-24))
    })?;
    Ok(vec![line])
}

fn mix() -> Result<Vec<Series>, ProbeError> {
    let body = "vec4 value(vec4 a, vec4 b) {
        return vec4(mix(a.x, a.y, a.z), mix(a.x, a.x, a.z), mix(a.x, a.y, 0.0), mix(a.x, a.y, 1.0));
    }";
    let mut rng = Rng::named("mix");
    let case = |ratio: f64| {
        let x = rng.real(0.5, 1.0);
        let sign = rng.pick(&[-1.0, 1.0]);
        of([x, (f64::from(x) * ratio * sign) as f32, rng.real(0.0, 1.0), 0.0])
    };
    let line = shaded("largest error", decades(-10..=38), body, case, |[a, _], value| {
        let [x, y, t] = [a[0], a[1], a[2]].map(f64::from);
        let unit = |v: f64| v.abs() * 2f64.powi(-23);
        let mixed = (value[0] - (x * (1.0 - t) + y * t)).abs() / unit(x.abs().max(y.abs()));
        let same = (value[1] - x).abs() / unit(x);
        let ends = if value[2] == x && value[3] == y { 0.0 } else { f64::INFINITY };
        Some(mixed.max(same).max(ends))
    })?;
    Ok(vec![line])
}

fn atan() -> Result<Vec<Series>, ProbeError> {
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(atan(a.x, a.y), 0.0, 0.0, 0.0); }";
    let mut lines = Vec::new();
    for (name, swapped) in [("about the x axis", false), ("about the y axis", true)] {
        let mut rng = Rng::named(name);
        let case = |ratio: f64| {
            let sign = [0; 2].map(|_: i32| rng.pick(&[-1.0f32, 1.0]));
            let along = rng.real(0.5, 1.0) * sign[0];
            let beside = (ratio * f64::from(rng.real(0.5, 1.0))) as f32 * sign[1];
            of(if swapped { [along, beside, 0.0, 0.0] } else { [beside, along, 0.0, 0.0] })
        };
        lines.push(shaded(name, decades(-45..=3), body, case, |[a, _], value| {
            let [y, x] = [a[0], a[1]].map(f64::from);
            Some(Unit::Ulp.error(y.atan2(x), value[0]))
        })?);
    }
    Ok(lines)
}

fn sin_cos() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("sin-cos-large");
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(sin(a.x), cos(a.x), 0.0, 0.0); }";
    let case = |size: f64| of([(size * f64::from(rng.real(-1.0, 1.0))) as f32, 0.0, 0.0, 0.0]);
    let line = shaded("largest error", decades(-3..=38), body, case, |[a, _], value| {
        let x = f64::from(a[0]);
        let error = (value[0] - x.sin()).abs().max((value[1] - x.cos()).abs());
        Some(error / 2f64.powi(-24))
    })?;
    Ok(vec![line])
}

fn acos() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("acos-ends");
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(acos(a.x), asin(a.x), 0.0, 0.0); }";
    let case = |distance: f64| {
        let x = (1.0 - distance * f64::from(rng.real(0.5, 1.0))) as f32;
        of([x * rng.pick(&[-1.0, 1.0]), 0.0, 0.0, 0.0])
    };
    let line = shaded("largest error", octaves(-30..=0, 1), body, case, |[a, _], value| {
        let x = f64::from(a[0]);
        let errors =
            [(x.acos(), value[0]), (x.asin(), value[1])].map(|(e, m)| Unit::Ulp.error(e, m));
        Some(errors[0].max(errors[1]))
    })?;
    Ok(vec![line])
}

fn roots() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("square-roots");
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(sqrt(a.x), inversesqrt(a.x), 0.0, 0.0); }";
    let case = |size: f64| of([(size * f64::from(rng.real(0.5, 1.0))) as f32, 0.0, 0.0, 0.0]);
    let line = shaded("largest error", decades(-44..=38), body, case, |[a, _], value| {
        let x = f64::from(a[0]);
        let errors = [(x.sqrt(), value[0]), (1.0 / x.sqrt(), value[1])];
        let errors = errors.map(|(e, m)| Unit::Ulp.error(e, m));
        Some(errors[0].max(errors[1]))
    })?;
    Ok(vec![line])
}
