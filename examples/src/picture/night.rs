//! `reachup.ppm`: somebody on a hill reaches up for the moon.

use super::image::{Color, Picture, add, dim, disc, mix, smooth, stroke};
use super::noise::{hash, turbulence};

const INK: Color = [0.03, 0.03, 0.07];
const MOON: [f64; 2] = [0.60, 0.25];

/// 512×512.
pub fn reach_up() -> Picture {
    Picture::paint(512, 512, |x, y| {
        let hill = 0.80 + 0.55 * (x - 0.45) * (x - 0.45) + 0.012 * turbulence(x * 24.0, 1.0, 64, 3);
        if y > hill {
            return mix([0.10, 0.14, 0.20], INK, (y - hill) * 9.0);
        }
        if figure([x, y]) { INK } else { sky(x, y) }
    })
}

fn sky(x: f64, y: f64) -> Color {
    let dusk = mix([0.06, 0.07, 0.24], [0.36, 0.20, 0.48], y * 1.35);
    let dusk = mix(dusk, [1.0, 0.55, 0.38], (y - 0.42) * 1.9);
    let (dx, dy) = (x - MOON[0], y - MOON[1]);
    let distance = (dx * dx + dy * dy).sqrt();
    let glow = dim([1.0, 0.92, 0.75], 0.55 * smooth(0.42, 0.10, distance));
    if distance < 0.13 {
        let seas = turbulence(x * 16.0, y * 16.0, 64, 11);
        return mix([1.0, 0.97, 0.86], [0.80, 0.76, 0.70], smooth(0.48, 0.62, seas));
    }
    let cloud = smooth(0.56, 0.74, turbulence(x * 4.0, y * 11.0, 64, 21)) * smooth(0.3, 0.7, y);
    add(mix(add(dusk, stars(x, y)), [1.0, 0.78, 0.66], 0.55 * cloud), glow)
}

/// One star in every tenth square of a grid.
fn stars(x: f64, y: f64) -> Color {
    let (column, row) = ((x * 36.0).floor(), (y * 36.0).floor());
    let (ix, iy) = (column as i64, row as i64);
    let light = hash(ix, iy, 31);
    let (star_x, star_y) = (hash(ix, iy, 32) * 0.6 + 0.2, hash(ix, iy, 33) * 0.6 + 0.2);
    let there =
        light < 0.14 && disc(x * 36.0 - column, y * 36.0 - row, star_x, star_y, 0.06 + light * 0.5);
    dim([1.0, 0.96, 0.9], if there { 0.9 * smooth(0.62, 0.3, y) } else { 0.0 })
}

/// Standing on tiptoe, both arms up.
fn figure(point: [f64; 2]) -> bool {
    const LIMBS: [([f64; 2], [f64; 2], f64); 10] = [
        ([0.425, 0.800], [0.437, 0.715], 0.013),
        ([0.437, 0.715], [0.455, 0.640], 0.017),
        ([0.485, 0.795], [0.478, 0.715], 0.013),
        ([0.478, 0.715], [0.465, 0.640], 0.017),
        ([0.460, 0.640], [0.463, 0.550], 0.027),
        ([0.446, 0.545], [0.480, 0.545], 0.016),
        ([0.446, 0.543], [0.455, 0.475], 0.010),
        ([0.455, 0.475], [0.480, 0.415], 0.009),
        ([0.481, 0.543], [0.510, 0.485], 0.010),
        ([0.510, 0.485], [0.535, 0.420], 0.009),
    ];
    disc(point[0], point[1], 0.474, 0.500, 0.026)
        || LIMBS.iter().any(|&(from, to, radius)| stroke(point, from, to, radius))
}
