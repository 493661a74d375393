//! Draws a scene in a mode and measures the time.

use super::mode::Mode;
use super::scene::{Scene, Surface};
use crate::probe::ProbeError;
use gl_api::constants::*;
use gl_api::context::{Context, ContextDesc};
use gl_api::*;
use std::time::Instant;

/// A picture and its time.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// R, G, B, A in [0, 1], rows from the lowest.
    pub pixels: Vec<[f64; 4]>,
    /// Nanoseconds a pixel: the minimum of several draws.
    pub nanoseconds: f64,
    /// The quartiles of the same over all draws (of the formula there is one).
    pub quartiles: [f64; 3],
}

/// The fewest draws that are timed.
const FEWEST_ROUNDS: usize = 9;

/// Seconds for which a draw is repeated to find its minimum time.
const PATIENCE: f64 = 0.08;

/// The scene as the driver draws it, `side` × `side` pixels.
///
/// # Errors
/// When there is no context, or a call sets the error flag.
pub fn draw(scene: &Scene, mode: Mode, side: usize) -> Result<Drawn, ProbeError> {
    match mode {
        Mode::Filter(_, filter, anisotropy) => gl(scene, filter, anisotropy, side, 1),
        Mode::Supersampled(n) => gl(scene, GL_LINEAR, 1, side, n),
        Mode::ExactArea => Ok(exact(scene, side)),
    }
}

/// The integral, rounded to bytes as a framebuffer would.
fn exact(scene: &Scene, side: usize) -> Drawn {
    let start = Instant::now();
    let pixels: Vec<[f64; 4]> = (0..side * side)
        .map(|p| scene.reference([p % side, p / side], side).map(|c| (c * 255.0).round() / 255.0))
        .collect();
    let nanoseconds = start.elapsed().as_secs_f64() * 1e9 / (side * side) as f64;
    Drawn { pixels, nanoseconds, quartiles: [nanoseconds; 3] }
}

fn gl(
    scene: &Scene,
    filter: u32,
    anisotropy: u32,
    side: usize,
    samples: usize,
) -> Result<Drawn, ProbeError> {
    let large = side * samples;
    let desc = ContextDesc { width: large as u32, height: large as u32, ..ContextDesc::default() };
    let context = Context::new(desc).map_err(|error| ProbeError::Context(error.to_string()))?;
    let _current = context.make_current();
    set_texture(scene, filter, anisotropy);
    match scene.surface {
        Surface::Plane(_) => {
            glEnable(GL_TEXTURE_2D);
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        }
        Surface::Sphere => glUseProgram(sphere_program()),
    }
    let corners = corners(scene);
    let mut rounds: Vec<f64> = Vec::new();
    let start = Instant::now();
    while rounds.len() < FEWEST_ROUNDS || start.elapsed().as_secs_f64() < PATIENCE {
        let start = Instant::now();
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_QUADS);
        for ([x, y, w], [s, t]) in corners {
            glTexCoord2f(s, t);
            glVertex4f(x, y, 0, w);
        }
        glEnd();
        glFinish();
        rounds.push(start.elapsed().as_secs_f64() * 1e9 / (side * side) as f64);
    }
    let mut bytes = vec![0u8; large * large * 4];
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, large, large, GL_RGBA, GL_UNSIGNED_BYTE, &mut bytes);
    match glGetError() {
        GL_NO_ERROR => {}
        code => {
            let message = "while drawing a scene".to_owned();
            return Err(ProbeError::Gl { after: "drawing a scene", code, message });
        }
    }
    rounds.sort_by(f64::total_cmp);
    let part = |part: usize| rounds[(rounds.len() - 1) * part / 4];
    let quartiles = [part(1), part(2), part(3)];
    Ok(Drawn { pixels: resolve(&bytes, side, samples), nanoseconds: rounds[0], quartiles })
}

/// The mean of `samples`² pixels each.
fn resolve(bytes: &[u8], side: usize, samples: usize) -> Vec<[f64; 4]> {
    let large = side * samples;
    let mut pixels = vec![[0.0; 4]; side * side];
    for (p, texel) in bytes.chunks_exact(4).enumerate() {
        let (x, y) = (p % large / samples, p / large / samples);
        for (sum, &c) in pixels[y * side + x].iter_mut().zip(texel) {
            *sum += f64::from(c) / (255.0 * (samples * samples) as f64);
        }
    }
    pixels
}

fn set_texture(scene: &Scene, filter: u32, anisotropy: u32) {
    let (target, image) = (GL_TEXTURE_2D, &scene.image);
    let texels = image.texels.as_flattened();
    let (width, height) = (image.width, image.height);
    glBindTexture(target, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(target, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    let magnified = if filter == GL_NEAREST { GL_NEAREST } else { GL_LINEAR };
    if filter != magnified {
        glGenerateMipmap(target);
    }
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, magnified);
    glTexParameteri(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
}

/// Clip x, y, w and (s, t) of the picture's corners. A plane's w is what its perspective makes it;
/// the sphere's shader takes (s, t) for the place in the picture.
fn corners(scene: &Scene) -> [([f32; 3], [f32; 2]); 4] {
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| match scene.surface {
        Surface::Sphere => ([x as f32, y as f32, 1.0], [x as f32, y as f32]),
        Surface::Plane(map) => {
            let [s, t, q] = map.homogeneous([x, y]);
            let size = [scene.image.width, scene.image.height].map(|n| n as f64);
            let st = [s / q / size[0], t / q / size[1]].map(|c| c as f32);
            ([x / q, y / q, 1.0 / q].map(|c| c as f32), st)
        }
    })
}

/// A sphere in the fragment shader.
fn sphere_program() -> u32 {
    const FRAGMENT: &str = "
        uniform sampler2D image;
        const float PI = 3.14159265358979;
        void main() {
            vec2 p = gl_TexCoord[0].xy;
            float z = sqrt(max(0.0, 1.0 - dot(p, p)));
            float s = 4.0 * atan(p.x, z) / (2.0 * PI);
            float t = 2.0 * asin(clamp(p.y, -1.0, 1.0)) / PI;
            gl_FragColor = texture2D(image, vec2(s, t));
        }";
    let shader = glCreateShader(GL_FRAGMENT_SHADER);
    glShaderSource(shader, 1, FRAGMENT, NULL);
    glCompileShader(shader);
    let program = glCreateProgram();
    glAttachShader(program, shader);
    glLinkProgram(program);
    program
}
