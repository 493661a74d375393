//! Procedural textures at frequencies that f32 cannot hold, and normal maps without a mean.

use super::definition::Sweep;
use super::drawn::float_texture;
use super::series::{Series, decades, octaves};
use super::shaded::{of, shaded, shaded_in};
use crate::gl::*;
use crate::probe::{ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;

/// Noise of high octaves.
pub const NOISE: Sweep = Sweep {
    name: "noise-octaves",
    what: "value noise of the lattice x·f whose corners are hashed by (34n + 1)n mod 289, against f64",
    parameter: "frequency f",
    unit: "of 2^-24",
    bound: 4.0,
    why: "x·f and its fraction are exact for powers of two; hashes are integers below 2^24; a \
          polynomial and a mixture",
    breaks: "from 2^24 on x·f has no fraction: noise is white, and the octave is worth nothing; \
             it is still the hash of its lattice, exactly",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: noise,
};

/// Twenty octaves.
pub const TURBULENCE: Sweep = Sweep {
    name: "turbulence",
    what: "the sum of this many octaves of |2·noise - 1|/f, against f64",
    parameter: "octaves",
    unit: "of 2^-24",
    bound: 16.0,
    why: "each octave's error counts half of the one before: the sum is at most twice the first, and \
          the additions' roundings",
    breaks: "octaves beyond 24 add less than a unit in the last place",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: turbulence,
};

/// Rings of wood.
pub const WOOD: Sweep = Sweep {
    name: "wood-rings",
    what: "fract(r·f) of the distance r from an axis, against f64; over the seam too",
    parameter: "rings a unit, f",
    unit: "of f·2^-24",
    bound: 4.0,
    why: "the distance is rounded a few times, and the frequency multiplies it",
    breaks: "beyond a ring a pixel, 1/2 of which is Nyquist's limit, rings alias; from 1e7 on neighbouring \
             floats are a ring apart, and the fraction says nothing",
    kept: 1.0,
    distinct: 0.8,
    before: &[],
    run: wood,
};

/// Normals that cancel.
pub const NORMAL_MEAN: Sweep = Sweep {
    name: "normal-map-mean",
    what: "normalize() of the mean of two normals (±x, 0, z) from the second level of a map of floats",
    parameter: "z, the length of the mean",
    unit: "of 2^-23",
    bound: 1.0,
    why: "the x cancel exactly; what is left is made a unit vector whatever its length",
    breaks: "8 bits would lose a mean below 1/255; floats keep it to 1e-37",
    kept: 1.0,
    distinct: 0.0,
    before: &[],
    run: normal_mean,
};

const NOISE_CODE: &str = "
    float hash(float n) { n = mod(n, 289.0); return mod((34.0 * n + 1.0) * n, 289.0); }
    float noise(vec2 p) {
        vec2 cell = floor(p), t = p - cell;
        t = t * t * (3.0 - 2.0 * t);
        vec4 corner = vec4(hash(hash(cell.x) + cell.y), hash(hash(cell.x + 1.0) + cell.y),
                           hash(hash(cell.x) + cell.y + 1.0),
                           hash(hash(cell.x + 1.0) + cell.y + 1.0)) / 289.0;
        return mix(mix(corner.x, corner.y, t.x), mix(corner.z, corner.w, t.x), t.y);
    }";

/// The same in `f64`, but for the lattice, whose sums are rounded as those of the shader are.
fn exact_noise([x, y]: [f64; 2]) -> f64 {
    let sum = |a: f64, b: f64| f64::from((a + b) as f32);
    let hash = |n: f64| {
        let n = n.rem_euclid(289.0);
        ((34.0 * n + 1.0) * n).rem_euclid(289.0)
    };
    let (i, j) = (x.floor(), y.floor());
    let ease = |t: f64| t * t * (3.0 - 2.0 * t);
    let (s, t) = (ease(x - i), ease(y - j));
    let corner = |di: f64, dj: f64| hash(sum(sum(hash(sum(i, di)), j), dj)) / 289.0;
    let mix = |a: f64, b: f64, t: f64| a * (1.0 - t) + b * t;
    mix(mix(corner(0.0, 0.0), corner(1.0, 0.0), s), mix(corner(0.0, 1.0), corner(1.0, 1.0), s), t)
}

fn noise() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("noise-octaves");
    let body =
        format!("{NOISE_CODE} vec4 value(vec4 a, vec4 b) {{ return vec4(noise(a.xy * a.z)); }}");
    let case = |f: f64| of([rng.real(0.0, 1.0), rng.real(0.0, 1.0), f as f32, 0.0]);
    let line = shaded("largest error", octaves(0..=21, 1), &body, case, |[a, _], value| {
        let [x, y, f] = [a[0], a[1], a[2]].map(f64::from);
        Some((value[0] - exact_noise([x * f, y * f])).abs() / 2f64.powi(-24))
    })?;
    Ok(vec![line])
}

fn turbulence() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("turbulence");
    let body = format!(
        "{NOISE_CODE}
        vec4 value(vec4 a, vec4 b) {{
            float sum = 0.0, f = 1.0;
            for (int octave = 0; octave < int(a.z); octave++) {{
                sum += abs(2.0 * noise(a.xy * f) - 1.0) / f;
                f *= 2.0;
            }}
            return vec4(sum);
        }}"
    );
    let case = |octaves: f64| of([rng.real(0.0, 1.0), rng.real(0.0, 1.0), octaves as f32, 0.0]);
    let line = shaded("largest error", (1..=20).map(f64::from), &body, case, |[a, _], value| {
        let [x, y, octaves] = [a[0], a[1], a[2]].map(f64::from);
        let of = |octave: i32| {
            let f = 2f64.powi(octave);
            (2.0 * exact_noise([x * f, y * f]) - 1.0).abs() / f
        };
        let exact: f64 = (0..octaves as i32).map(of).sum();
        Some((value[0] - exact).abs() / 2f64.powi(-24))
    })?;
    Ok(vec![line])
}

fn wood() -> Result<Vec<Series>, ProbeError> {
    let mut rng = Rng::named("wood-rings");
    let body = "vec4 value(vec4 a, vec4 b) { return vec4(fract(length(a.xy) * a.z)); }";
    let case = |f: f64| of([rng.real(-1.0, 1.0), rng.real(-1.0, 1.0), f as f32, 0.0]);
    let rings = (0..=18).map(|step| 10f64.powf(f64::from(step) / 2.0));
    let line = shaded("largest error", rings, body, case, |[a, _], value| {
        let [x, y, f] = [a[0], a[1], a[2]].map(f64::from);
        let exact = ((x * x + y * y).sqrt() * f).rem_euclid(1.0);
        let apart = (value[0] - exact).abs();
        Some(apart.min(1.0 - apart) / (f * 2f64.powi(-24)))
    })?;
    Ok(vec![line])
}

fn normal_mean() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    let lengths = decades(-37..=0);
    let body = "uniform sampler2D image;
        vec4 value(vec4 a, vec4 b) { return vec4(normalize(textureLod(image, a.xy, 1.0).xyz), 0.0); }";
    let mut points = Vec::new();
    for z in lengths {
        let x = 1.0f32;
        let map = [[x, 0.0, z as f32, 1.0], [-x, 0.0, z as f32, 1.0]];
        float_texture(&session, GL_RGBA32F, [2, 1], &map)?;
        glGenerateMipmap(GL_TEXTURE_2D);
        session.parameters(&[(GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST)])?;
        let one = std::iter::once(z);
        let line = shaded_in(
            &session,
            "",
            one,
            body,
            |_| of([0.5; 4]),
            |_, value| {
                let error = value[0].abs().max(value[1].abs()).max((value[2] - 1.0).abs());
                Some(error / 2f64.powi(-23))
            },
        )?;
        points.extend(line.points);
    }
    Ok(vec![Series { name: "largest error".to_owned(), points }])
}
