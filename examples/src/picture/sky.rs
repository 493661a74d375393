//! The surroundings of the environment map: sun, clouds, mountains and a tiled square.

use super::image::{Color, Picture, add, dim, mix, smooth};
use super::noise::turbulence;

/// Unit vector towards the sun.
const SUN: [f64; 3] = [0.48, 0.36, -0.8];

/// The files of the cube map's faces, in GL's order.
pub const FACES: [&str; 6] =
    ["sky_px.ppm", "sky_nx.ppm", "sky_py.ppm", "sky_ny.ppm", "sky_pz.ppm", "sky_nz.ppm"];

/// Side of a face.
const SIZE: usize = 512;

/// A face of the cube map, by its index in [`FACES`]; its first row is at t = 0, as GL wants it.
pub fn sky_face(face: usize) -> Picture {
    Picture::paint(SIZE, SIZE, |s, t| sky(direction(face, 2.0 * s - 1.0, 2.0 * t - 1.0)))
}

/// The surroundings as a chrome ball shows them to a far eye: what `GL_SPHERE_MAP` looks up.
pub fn sphere_map() -> Picture {
    Picture::paint(SIZE / 2, SIZE / 2, |x, y| {
        let (x, y) = (2.0 * x - 1.0, 1.0 - 2.0 * y);
        let z = (1.0 - x * x - y * y).max(0.0).sqrt();
        // The reflection of (0, 0, 1) at the ball's normal (GL 2.1 section 2.11.4, backward).
        sky([2.0 * z * x, 2.0 * z * y, 2.0 * z * z - 1.0])
    })
}

/// The direction of a point of a face: the inverse of GL 2.1 table 3.19.
fn direction(face: usize, s: f64, t: f64) -> [f64; 3] {
    match face {
        0 => [1.0, -t, -s],
        1 => [-1.0, -t, s],
        2 => [s, 1.0, t],
        3 => [s, -1.0, -t],
        4 => [s, -t, 1.0],
        _ => [-s, -t, -1.0],
    }
}

fn sky(direction: [f64; 3]) -> Color {
    let [x, y, z] = direction;
    let length = (x * x + y * y + z * z).sqrt();
    let [x, y, z] = [x / length, y / length, z / length];
    if y < 0.0 {
        return square(x / -y, z / -y);
    }
    let around = (x * x + z * z).sqrt();
    if y < ridge(x / around, z / around, 2.6, 51) * around {
        return mix([0.22, 0.26, 0.38], [0.42, 0.45, 0.58], y * 5.0);
    }
    if y < (ridge(x / around, z / around, 4.1, 57) + 0.07) * around {
        return mix([0.52, 0.55, 0.70], [0.66, 0.66, 0.78], y * 4.0);
    }
    let toward_sun = (x * SUN[0] + y * SUN[1] + z * SUN[2]).max(0.0);
    let blue = mix([0.98, 0.80, 0.62], [0.42, 0.64, 0.92], y * 3.2);
    let blue = mix(blue, [0.10, 0.26, 0.62], y * 1.5 - 0.45);
    // Clouds are flat and high up.
    let (u, v) = (x / (y + 0.12), z / (y + 0.12));
    let cloud = turbulence(u * 0.8 + 64.0, v * 0.8 + 64.0, 256, 61);
    let clouded = mix(blue, [1.0, 0.97, 0.93], smooth(0.52, 0.74, cloud) * smooth(0.02, 0.2, y));
    let halo = toward_sun * toward_sun;
    let halo = halo * halo * halo * halo;
    let disc = smooth(0.9972, 0.9985, toward_sun);
    mix(add(clouded, dim([0.55, 0.38, 0.16], halo * halo)), [1.0, 0.98, 0.90], disc)
}

/// The height of the mountains over a point of the horizon.
fn ridge(x: f64, z: f64, scale: f64, seed: u32) -> f64 {
    0.30 * turbulence(x * scale + 32.0, z * scale + 32.0, 256, seed) - 0.05
}

/// Tiles to the horizon, one unit below the eye.
fn square(u: f64, v: f64) -> Color {
    let distance = (u * u + v * v).sqrt();
    let tile = ((u * 1.5).floor() + (v * 1.5).floor()) as i64;
    let stone: Color =
        if tile.rem_euclid(2) == 0 { [0.80, 0.72, 0.58] } else { [0.42, 0.22, 0.18] };
    let stone = dim(stone, 0.8 + 0.4 * turbulence(u * 2.0 + 128.0, v * 2.0 + 128.0, 512, 71));
    mix(stone, [0.62, 0.60, 0.64], smooth(2.0, 16.0, distance))
}
