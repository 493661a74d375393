//! Iterations over framebuffers and cube maps, stable and past their limits.

use super::definition::Sweep;
use super::drawn::{UNIT_SQUARE, draw_into, float_texture, painted, square};
use super::series::{Compared, Point, Series};
use crate::gl::*;
use crate::probe::{ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;

/// Diffusion.
pub const DIFFUSION: Sweep = Sweep {
    name: "diffusion",
    what: "60 explicit steps u + r·∇²u over 32 × 32 pixels in ping-pong framebuffers, against f64",
    parameter: "r; the limit of stability is 1/4",
    unit: "of a format's step, summed over the steps as they grow",
    bound: 0.85,
    why: "each step rounds to the format, and earlier errors grow by at most max(1, 8r - 1) a step",
    breaks: "past r = 1/4 the finest wave grows by 8r - 1 a step, rounding with it: the values are \
             lost, but no faster than that; 8 bits hold values to [0, 1] and stall where a step is below \
             half a code",
    kept: 1.0,
    distinct: 0.7,
    before: &[],
    run: diffusion,
};

/// Reaction and diffusion.
pub const REACTION: Sweep = Sweep {
    name: "reaction-diffusion",
    what: "40 steps of the Gray-Scott model over 32 × 32 pixels of floats, against f64; past the \
           limit, values that are not held to [0, 1] count 10^6",
    parameter: "time step; the limit of stability is about 1.3",
    unit: "of 2^-24, over 40 steps",
    bound: 5.0,
    why: "every step rounds a dozen operations; the reaction makes little more of them in 40 steps",
    breaks: "past the limit neighbouring pixels alternate, and errors double with each step: only that values are numbers in [0, 1] is promised",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: reaction,
};

/// Mirrors that see each other.
pub const BOUNCES: Sweep = Sweep {
    name: "cube-bounces",
    what: "a cube map of floats that is drawn from itself this many times, each time lit by 0.3 and \
           reflecting 0.7 of a linear lookup, against 1 - 0.7^n",
    parameter: "bounces n",
    unit: "of 2^-24",
    bound: 1.9,
    why: "weights of a filter sum to 1, so that a constant stays one; earlier roundings fade by 0.7",
    breaks: "it converges: after 50 bounces the picture repeats to the bit",
    kept: 1.0,
    distinct: 0.5,
    before: &[],
    run: bounces,
};

const SIDE: usize = 32;
const STEPS: i32 = 60;

type Field = Vec<[f64; 2]>;

/// The sum of the four neighbours, repeated over the edges, less four times the value.
fn laplacian(field: &Field, at: usize, c: usize) -> f64 {
    let (x, y) = (at % SIDE, at / SIDE);
    let of = |x: usize, y: usize| field[(y % SIDE) * SIDE + x % SIDE][c];
    (of(x + 1, y) + of(x + SIDE - 1, y)) + (of(x, y + 1) + of(x, y + SIDE - 1)) - 4.0 * of(x, y)
}

/// A start with all wave lengths, of bytes.
fn start() -> Field {
    let mut rng = Rng::named("iterated");
    (0..SIDE * SIDE).map(|_| [0; 2].map(|_: i32| f64::from(rng.byte()) / 255.0)).collect()
}

/// What a program makes of a field, from texture to texture.
fn iterate(
    format: u32,
    body: &str,
    parameter: f64,
    field: &Field,
    steps: i32,
) -> Result<Field, ProbeError> {
    let session = Session::open()?;
    let size = [SIDE, SIDE];
    let texels: Vec<[f32; 4]> =
        field.iter().map(|&[u, v]| [u as f32, v as f32, 0.0, 1.0]).collect();
    let mut textures = Vec::new();
    for _ in 0..2 {
        let texture = float_texture(&session, format, size, &texels)?;
        textures.push((texture, draw_into(&session, texture, size)?));
    }
    let fragment = format!(
        "uniform sampler2D field; uniform float step;
        vec2 at(int x, int y) {{
            return texelFetch(field, (ivec2(gl_FragCoord.xy) + ivec2(x, y)) & 31, 0).xy;
        }}
        void main() {{
            vec2 here = at(0, 0);
            vec2 laplacian = (at(1, 0) + at(-1, 0)) + (at(0, 1) + at(0, -1)) - 4.0 * here;
            {body}
        }}"
    );
    let program = painted(&session, &fragment)?;
    glUniform1f(glGetUniformLocation(program, "step"), parameter as f32);
    for step in 0..steps as usize {
        let ((from, _), (_, to)) = (textures[step % 2], textures[(step + 1) % 2]);
        glBindTexture(GL_TEXTURE_2D, from);
        glBindFramebuffer(GL_FRAMEBUFFER, to);
        square(UNIT_SQUARE);
    }
    let values = session.read_floats(size)?;
    Ok(values.into_iter().map(|v| [v[0], v[1]]).collect())
}

fn diffusion() -> Result<Vec<Series>, ProbeError> {
    let mut lines = Vec::new();
    let body = "color = vec4(here + step * laplacian, 0.0, 1.0);";
    for (name, format, unit) in [
        ("floats", GL_RGBA32F, 2f64.powi(-24)),
        ("half floats", GL_RGBA16F, 2f64.powi(-11)),
        ("8 bits", GL_RGBA8, 0.5 / 255.0),
    ] {
        let ratios = (1..=20).map(|step| 0.02 * f64::from(step));
        // Held to [0, 1], no wave can grow: 8 bits go to the limit. Half floats become infinite soon after.
        let part = match format {
            GL_RGBA8 => 0.625,
            GL_RGBA16F => 0.7,
            _ => 1.0,
        };
        let ratios: Vec<f64> = ratios.map(|ratio| part * ratio).collect();
        lines.push(Series::measured(name, ratios, |ratio| {
            let ratio = f64::from(ratio as f32);
            let values = iterate(format, body, ratio, &start(), STEPS)?;
            let mut exact = start();
            for _ in 0..STEPS {
                exact = (0..SIDE * SIDE)
                    .map(|at| [0, 1].map(|c| exact[at][c] + ratio * laplacian(&exact, at, c)))
                    .collect();
            }
            // Rounding of step k grows in the steps after it; that of a value larger than 1 is larger.
            let growth = (8.0 * ratio - 1.0).max(1.0);
            let scale: f64 =
                (0..STEPS).map(|k| growth.powi(k) * growth.powi(STEPS - k)).sum::<f64>() * unit;
            let mut compared = Compared::new();
            for (exact, value) in exact.iter().zip(&values) {
                let error = (exact[0] - value[0]).abs().max((exact[1] - value[1]).abs());
                compared.add(error / scale, value);
            }
            Ok(compared)
        })?);
    }
    Ok(lines)
}

fn reaction() -> Result<Vec<Series>, ProbeError> {
    const STEPS: i32 = 40;
    const LIMIT: f64 = 1.3;
    let body = "float uvv = here.x * here.y * here.y;
        vec2 change = vec2(0.16 * laplacian.x - uvv + 0.035 * (1.0 - here.x),
                           0.08 * laplacian.y + uvv - 0.1 * here.y);
        color = vec4(clamp(here + step * change, 0.0, 1.0), 0.0, 1.0);";
    let times = (1..=24).map(|step| 0.1 * f64::from(step));
    let line = Series::measured("floats", times, |time| {
        let time = f64::from(time as f32);
        let values = iterate(GL_RGBA32F, body, time, &start(), STEPS)?;
        let mut exact = start();
        for _ in 0..STEPS {
            exact = (0..SIDE * SIDE)
                .map(|at| {
                    let [u, v] = exact[at];
                    let uvv = u * v * v;
                    let du = 0.16 * laplacian(&exact, at, 0) - uvv + 0.035 * (1.0 - u);
                    let dv = 0.08 * laplacian(&exact, at, 1) + uvv - 0.1 * v;
                    [(u + time * du).clamp(0.0, 1.0), (v + time * dv).clamp(0.0, 1.0)]
                })
                .collect();
        }
        let mut compared = Compared::new();
        for (exact, value) in exact.iter().zip(&values) {
            let held = value.iter().all(|c| (0.0..=1.0).contains(c));
            let apart = (exact[0] - value[0]).abs().max((exact[1] - value[1]).abs());
            let error = match held {
                false => 1e6,
                true if time < LIMIT => apart / 2f64.powi(-24),
                true => 0.0,
            };
            compared.add(error, value);
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}

fn bounces() -> Result<Vec<Series>, ProbeError> {
    const FACE: usize = 8;
    let counts = [1, 2, 3, 4, 5, 6, 8, 10, 13, 16, 20, 25, 32, 40, 50, 64, 80, 100];
    let session = Session::open()?;
    let target = GL_TEXTURE_CUBE_MAP;
    let texels = vec![0.0f32; FACE * FACE * 4];
    let mut cubes = [0u32; 2];
    glGenTextures(2, &mut cubes);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    let mut framebuffers = [[0u32; 6]; 2];
    for (cube, framebuffers) in cubes.iter().zip(&mut framebuffers) {
        glBindTexture(target, *cube);
        for parameter in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
            glTexParameteri(target, parameter, GL_LINEAR);
        }
        glGenFramebuffers(6, framebuffers.as_mut_slice());
        for (face, framebuffer) in (GL_TEXTURE_CUBE_MAP_POSITIVE_X..).zip(framebuffers) {
            glTexImage2D(face, 0, GL_RGBA32F, FACE, FACE, 0, GL_RGBA, GL_FLOAT, &texels);
            glBindFramebuffer(GL_FRAMEBUFFER, *framebuffer);
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face, *cube, 0);
        }
    }
    painted(
        &session,
        "uniform samplerCube image;
        void main() {
            vec3 direction = vec3(texture_coordinates.xy * 2.0 - 1.0, texture_coordinates.z);
            color = vec4(0.3) + 0.7 * textureLod(image, direction, 0.0);
        }",
    )?;
    session.begin_frame([FACE, FACE])?;
    let mut points: Vec<Point> = Vec::new();
    let mut done = 0;
    for count in counts {
        for bounce in done..count {
            glBindTexture(target, cubes[bounce % 2]);
            for (face, framebuffer) in framebuffers[(bounce + 1) % 2].iter().enumerate() {
                glBindFramebuffer(GL_FRAMEBUFFER, *framebuffer);
                // Mirrors look elsewhere than to where they hang.
                let z = [1.0, 0.4, -0.2, -1.0, 0.1, -0.7][face];
                square(UNIT_SQUARE.map(|[s, t, _, _]| [s, t, z, 1.0]));
            }
        }
        done = count;
        let exact = 1.0 - 0.7f64.powi(count as i32);
        let mut compared = Compared::new();
        for value in session.read_floats([FACE, FACE])? {
            compared.add((value[0] - exact).abs() / 2f64.powi(-24), &value);
        }
        points.push(compared.at(count as f64));
    }
    Ok(vec![Series { name: "largest error".to_owned(), points }])
}
