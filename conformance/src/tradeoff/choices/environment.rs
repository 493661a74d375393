//! Environment maps of a room in which a lamp has moved: sphere map, cube map, a cube map drawn anew, traced rays.

use super::super::stage::{Clock, Frame, Stage, one_thread, square, use_program};
use super::level_of_detail::on_sphere;
use super::{Alternative, Alternatives, Choice, Cost, pictured};
use crate::probe::ProbeError;
use gl_api::constants::*;
use gl_api::*;

/// Environments.
pub const ENVIRONMENT: Choice = Choice {
    name: "environment",
    what: "a mirror ball in a room whose lamp has moved since maps were made once; error against traced rays in f64",
    cost: Cost::Time,
    alternatives,
};

/// Half the side of the room; the ball has a radius of 1.
const ROOM: f64 = 4.0;

/// Where the lamp is, and where it was when maps were made.
const LAMP: [f64; 3] = [1.5, 4.0, 0.5];
const LAMP_BEFORE: [f64; 3] = [-1.0, 4.0, 1.5];

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The colour of a place on the walls.
fn wall(p: [f64; 3], lamp: [f64; 3]) -> [f64; 4] {
    let d = [0, 1, 2].map(|i| p[i] - lamp[i]);
    let light = 0.5 * (-2.0 * dot(d, d)).exp();
    let [x, y, z] = p;
    let waves = [(1.7 * x + 0.6 * y).sin(), (1.3 * y - 0.9 * z).sin(), (1.1 * z + 0.8 * x).sin()];
    let [r, g, b] = waves.map(|wave| (0.4 + 0.3 * wave + light).min(1.0));
    [r, g, b, 1.0]
}

/// Where a ray from a place within the room meets a wall.
fn hit(from: [f64; 3], along: [f64; 3]) -> [f64; 3] {
    let reach = |i: usize| (ROOM * along[i].signum() - from[i]) / along[i];
    let t = (0..3).filter(|i| along[*i] != 0.0).map(reach).fold(f64::INFINITY, f64::min);
    [0, 1, 2].map(|i| from[i] + t * along[i])
}

/// The room in GLSL, as above.
const GLSL: &str = "#version 120
    uniform vec3 lamp;
    vec4 wall(vec3 p) {
        vec3 d = p - lamp;
        vec3 waves = sin(vec3(1.7 * p.x + 0.6 * p.y, 1.3 * p.y - 0.9 * p.z, 1.1 * p.z + 0.8 * p.x));
        return vec4(min(0.4 + 0.3 * waves + 0.5 * exp(-2.0 * dot(d, d)), 1.0), 1.0);
    }
    vec3 hit(vec3 from, vec3 along) {
        vec3 t = (4.0 * sign(along) - from) / along;
        return from + min(t.x, min(t.y, t.z)) * along;
    }
    // The ball: its normal at a place of the picture, and the ray that a far eye sees there.
    vec3 normal() {
        vec2 p = gl_TexCoord[0].xy;
        return vec3(p, sqrt(max(1.0 - dot(p, p), 0.0)));
    }
    vec3 mirrored() { return reflect(vec3(0.0, 0.0, -1.0), normal()); }
";

const TRACED: &str = "void main() { gl_FragColor = wall(hit(normal(), mirrored())); }";

/// The room as the middle of the ball sees it, over a face of a cube.
const FACE: &str = "uniform vec3 centre, across, up;
    void main() {
        vec2 p = gl_TexCoord[0].xy;
        gl_FragColor = wall(hit(vec3(0.0), centre + p.x * across + p.y * up));
    }";

/// The room over a sphere map (GL 2.1, section 2.11.4): s and t of the direction (0, 0, -1) + 2 n_z n.
const OVER_SPHERE_MAP: &str = "void main() {
        vec2 p = gl_TexCoord[0].xy;
        vec3 n = vec3(p, sqrt(max(1.0 - dot(p, p), 0.0)));
        gl_FragColor = wall(hit(vec3(0.0), normalize(2.0 * n.z * n - vec3(0.0, 0.0, 1.0))));
    }";

const SPHERE_MAP: &str = "uniform sampler2D map;
    void main() {
        vec3 r = mirrored();
        float m = 2.0 * sqrt(r.x * r.x + r.y * r.y + (r.z + 1.0) * (r.z + 1.0));
        gl_FragColor = texture2D(map, r.xy / m + 0.5);
    }";

const CUBE_MAP: &str = "uniform samplerCube map;
    void main() { gl_FragColor = textureCube(map, mirrored()); }";

/// The direction from the middle of the room to where the ray meets its wall.
const BOX_CUBE_MAP: &str = "uniform samplerCube map;
    void main() { gl_FragColor = textureCube(map, hit(normal(), mirrored())); }";

/// Directions to the middle of each face, along s and along t (GL 2.1, table 3.19).
const FACES: [[[f32; 3]; 3]; 6] = [
    [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, -1.0, 0.0]],
    [[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]],
    [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
    [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
    [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]],
    [[0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]],
];

fn program(source: &str, lamp: [f64; 3]) -> u32 {
    let program = use_program(None, &format!("{GLSL}{source}"));
    glUniform3fv(glGetUniformLocation(program, "lamp"), 1, &lamp.map(|c| c as f32));
    program
}

/// A texture of this target, linear and clamped.
fn texture(target: u32, faces: std::ops::Range<u32>, size: usize) {
    glBindTexture(target, 1);
    for face in faces {
        glTexImage2D(face, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    }
    for (name, value) in [
        (GL_TEXTURE_MIN_FILTER, GL_LINEAR),
        (GL_TEXTURE_MAG_FILTER, GL_LINEAR),
        (GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE),
        (GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE),
    ] {
        glTexParameteri(target, name, value);
    }
}

fn framebuffer() -> u32 {
    let mut framebuffer = 0u32;
    glGenFramebuffers(1, &mut framebuffer);
    framebuffer
}

/// Draws the faces of the cube map that is bound.
fn draw_faces(framebuffer: u32, program: u32, size: usize) {
    glUseProgram(program);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size, size);
    for (face, axes) in (GL_TEXTURE_CUBE_MAP_POSITIVE_X..).zip(FACES) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face, 1, 0);
        for (name, axis) in ["centre", "across", "up"].into_iter().zip(axes) {
            glUniform3fv(glGetUniformLocation(program, name), 1, &axis);
        }
        square();
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

/// How the ball gets its colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mirror {
    SphereMap(usize),
    CubeMap(usize),
    DynamicCubeMap(usize),
    BoxCubeMap(usize),
    Traced,
}

const MIRRORS: [(Mirror, &str); 7] = [
    (Mirror::SphereMap(256), "sphere map, 256²"),
    (Mirror::CubeMap(128), "cube map, 128²"),
    (Mirror::DynamicCubeMap(32), "dynamic cube map, 32²"),
    (Mirror::DynamicCubeMap(128), "dynamic cube map, 128²"),
    (Mirror::BoxCubeMap(32), "dynamic, box-shaped, 32²"),
    (Mirror::BoxCubeMap(128), "dynamic, box-shaped, 128²"),
    (Mirror::Traced, "traced in the shader"),
];

fn frame(mirror: Mirror, side: usize) -> Frame {
    let cube_faces = GL_TEXTURE_CUBE_MAP_POSITIVE_X..GL_TEXTURE_CUBE_MAP_POSITIVE_X + 6;
    let ball = move |program: u32| {
        glViewport(0, 0, side, side);
        glUseProgram(program);
        square();
    };
    match mirror {
        Mirror::Traced => {
            let program = program(TRACED, LAMP);
            Frame::new(move || ball(program))
        }
        Mirror::SphereMap(size) => {
            let target = GL_TEXTURE_2D;
            texture(target, target..target + 1, size);
            glBindFramebuffer(GL_FRAMEBUFFER, framebuffer());
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, 1, 0);
            glViewport(0, 0, size, size);
            program(OVER_SPHERE_MAP, LAMP_BEFORE);
            square();
            glBindFramebuffer(GL_FRAMEBUFFER, 0);
            let program = program(SPHERE_MAP, LAMP_BEFORE);
            Frame::new(move || ball(program))
        }
        Mirror::CubeMap(size) => {
            texture(GL_TEXTURE_CUBE_MAP, cube_faces, size);
            draw_faces(framebuffer(), program(FACE, LAMP_BEFORE), size);
            let program = program(CUBE_MAP, LAMP_BEFORE);
            Frame::new(move || ball(program))
        }
        Mirror::DynamicCubeMap(size) | Mirror::BoxCubeMap(size) => {
            texture(GL_TEXTURE_CUBE_MAP, cube_faces, size);
            let framebuffer = framebuffer();
            let faces = program(FACE, LAMP);
            let source =
                if matches!(mirror, Mirror::BoxCubeMap(_)) { BOX_CUBE_MAP } else { CUBE_MAP };
            let program = program(source, LAMP);
            Frame::new(move || {
                draw_faces(framebuffer, faces, size);
                ball(program);
            })
        }
    }
}

fn alternatives(side: usize) -> Result<Alternatives, ProbeError> {
    let device = one_thread()?;
    let mut all = Vec::new();
    for (mirror, name) in MIRRORS {
        let stage = Stage::new(&device, Clock::Processor, side, || frame(mirror, side))?;
        all.push(Alternative::new(name, stage));
    }
    let reference = pictured(side, |pixel| {
        if !on_sphere(pixel, side) {
            return [0.0; 4];
        }
        let [x, y] = pixel.map(|c| (2.0 * c as f64 + 1.0) / side as f64 - 1.0);
        let z = (1.0 - x * x - y * y).max(0.0).sqrt();
        wall(hit([x, y, z], [2.0 * z * x, 2.0 * z * y, 2.0 * z * z - 1.0]), LAMP)
    });
    Ok(Alternatives { side, reference, counts: on_sphere, all })
}
