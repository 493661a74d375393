//! Normal maps that are minified: what a mean of normals forgets of a highlight, and what LEAN mapping keeps.

use super::super::stage::{Clock, Frame, Stage, one_thread, square, use_program};
use super::{Alternative, Alternatives, Choice, Cost, everywhere, pictured};
use crate::probe::ProbeError;
use gl_api::constants::*;
use gl_api::*;

/// Normal maps.
pub const NORMAL_MAPS: Choice = Choice {
    name: "normal-maps",
    what: "a highlight on a bumpy plane, 8×8 normals a pixel; error against the mean of their highlights",
    cost: Cost::Time,
    alternatives,
};

/// Normals a pixel along each side.
const SCALE: usize = 8;

/// The exponent of the highlight.
const SHININESS: f64 = 60.0;

/// The half vector, which is the same everywhere: light and eye are far away.
const HALF: [f64; 3] = [0.12, 0.08, 1.0];

fn normalized(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / length)
}

/// The slopes of a height field: waves of many lengths, rougher to the right.
fn slopes([u, v]: [f64; 2]) -> [f64; 2] {
    let rough = 0.02 + 0.28 * u;
    let mut sum = [0.0; 2];
    for (k, [fx, fy]) in
        [[61.0, 23.0], [-37.0, 89.0], [131.0, 113.0], [7.0, -3.0]].into_iter().enumerate()
    {
        let phase = std::f64::consts::TAU * (fx * u + fy * v) + k as f64;
        let length = f64::hypot(fx, fy);
        sum[0] += fx / length * phase.cos();
        sum[1] += fy / length * phase.cos();
    }
    sum.map(|c| rough * c)
}

fn highlight(slopes: [f64; 2]) -> f64 {
    let (n, h) = (normalized([-slopes[0], -slopes[1], 1.0]), normalized(HALF));
    let cosine: f64 = n.iter().zip(h).map(|(a, b)| a * b).sum();
    cosine.max(0.0).powf(SHININESS)
}

/// Uniforms and the coordinates of all shaders.
const HEAD: &str = "
    uniform sampler2D normals, moments;
    const float S = SHININESS;
    const vec3 H = vec3(HALF_X, HALF_Y, 1.0);
    vec2 st() { return 0.5 * gl_TexCoord[0].xy + 0.5; }
";

const POINT: &str = "void main() {
    vec3 n = normalize(texture2D(normals, st()).xyz);
    gl_FragColor = vec4(vec3(pow(max(dot(n, normalize(H)), 0.0), S)), 1.0);
}";

/// Toksvig 2005: a short mean is a broad distribution.
const TOKSVIG: &str = "void main() {
    vec3 n = texture2D(normals, st()).xyz;
    float length_of_mean = length(n);
    float t = length_of_mean / (length_of_mean + S * (1.0 - length_of_mean));
    float highlight = pow(max(dot(n / length_of_mean, normalize(H)), 0.0), t * S);
    gl_FragColor = vec4(vec3((1.0 + t * S) / (1.0 + S) * highlight), 1.0);
}";

/// Olano and Baker 2010: a Gaussian of the means of slopes and of their products, broadened by the highlight's own.
const LEAN: &str = "void main() {
    vec2 b = texture2D(normals, st()).xy;
    vec3 m = texture2D(moments, st()).xyz;
    vec3 c = vec3(m.xy - b * b + 1.0 / S, m.z - b.x * b.y);
    float det = c.x * c.y - c.z * c.z;
    vec2 d = H.xy / H.z - b;
    float e = (d.x * d.x * c.y + d.y * d.y * c.x - 2.0 * d.x * d.y * c.z) / det;
    gl_FragColor = vec4(vec3(exp(-0.5 * e) / (S * sqrt(det))), 1.0);
}";

/// What textures hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stored {
    Normals,
    Slopes,
}

fn texture(unit: u32, internal: u32, size: usize, texels: &[f32], min: u32) {
    glActiveTexture(GL_TEXTURE0 + unit);
    let target = GL_TEXTURE_2D;
    glBindTexture(target, 1 + unit);
    glTexImage2D(target, 0, internal, size, size, 0, GL_RGB, GL_FLOAT, texels);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, min);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    if min != GL_NEAREST {
        glGenerateMipmap(target);
    }
    glActiveTexture(GL_TEXTURE0);
}

fn alternatives(side: usize) -> Result<Alternatives, ProbeError> {
    let (device, size) = (one_thread()?, side * SCALE);
    let place = |p: [usize; 2]| p.map(|c| (c as f64 + 0.5) / size as f64);
    let all_slopes: Vec<[f64; 2]> =
        (0..size * size).map(|p| slopes(place([p % size, p / size]))).collect();
    let highlights: Vec<f64> = all_slopes.iter().map(|of| highlight(*of)).collect();
    let reference = pictured(side, |[x, y]| {
        let rows = (0..SCALE).map(|j| (y * SCALE + j) * size + x * SCALE);
        let sum: f64 = rows.map(|at| highlights[at..][..SCALE].iter().sum::<f64>()).sum();
        let mean = sum / (SCALE * SCALE) as f64;
        [mean, mean, mean, 1.0]
    });
    let of = |f: fn([f64; 2]) -> [f64; 3]| -> Vec<f32> {
        all_slopes.iter().flat_map(|of| f(*of).map(|c| c as f32)).collect()
    };
    let normals = of(|[x, y]| normalized([-x, -y, 1.0]));
    let means = of(|[x, y]| [-x, -y, 0.0]);
    let moments = of(|[x, y]| [x * x, y * y, x * y]);
    // Of level 3 a texel is a pixel.
    let ways = [
        ("one normal", POINT, Stored::Normals, GL_NEAREST, 1),
        ("mean of normals", POINT, Stored::Normals, GL_NEAREST_MIPMAP_NEAREST, 1),
        ("mean of normals, Toksvig", TOKSVIG, Stored::Normals, GL_NEAREST_MIPMAP_NEAREST, 1),
        ("LEAN", LEAN, Stored::Slopes, GL_NEAREST_MIPMAP_NEAREST, 1),
        ("one normal, supersampled 4×4", POINT, Stored::Normals, GL_NEAREST, 4),
        ("one normal, supersampled 8×8", POINT, Stored::Normals, GL_NEAREST, 8),
    ];
    let mut all = Vec::new();
    for (name, shader, stored, min, samples) in ways {
        let [x, y, _] = HALF;
        let head = HEAD
            .replace("SHININESS", &format!("{SHININESS:?}"))
            .replace("HALF_X", &format!("{x:?}"))
            .replace("HALF_Y", &format!("{y:?}"));
        let stage = Stage::new(&device, Clock::Processor, side * samples, || {
            match stored {
                Stored::Normals => texture(0, GL_RGB32F, size, &normals, min),
                Stored::Slopes => {
                    texture(0, GL_RGB32F, size, &means, min);
                    texture(1, GL_RGB32F, size, &moments, min);
                }
            }
            let program = use_program(None, &format!("{head}{shader}"));
            glUniform1i(glGetUniformLocation(program, "normals"), 0);
            glUniform1i(glGetUniformLocation(program, "moments"), 1);
            Frame::new(square)
        })?;
        all.push(Alternative { samples, ..Alternative::new(name, stage) });
    }
    Ok(Alternatives { side, reference, counts: everywhere, all })
}
