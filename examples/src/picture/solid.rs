//! Solid textures: noise and marble in three dimensions, in volumes that repeat.

use super::image::{byte, mix};
use super::noise::hash;

/// Value noise in [0, 1] at a point of the unit cube, `period` cells a side, a power of two.
fn noise([x, y, z]: [f64; 3], period: i64, seed: u32) -> f64 {
    let place = [x, y, z].map(|at| at * period as f64);
    let cell = place.map(f64::floor);
    let ease = |t: f64| t * t * (3.0 - 2.0 * t);
    let [tx, ty, tz]: [f64; 3] = std::array::from_fn(|axis| ease(place[axis] - cell[axis]));
    let at = |corner: i64| {
        let wrap = |axis: usize| (cell[axis] as i64 + (corner >> axis & 1)) & (period - 1);
        hash(wrap(0), wrap(1), seed + 101 * wrap(2) as u32)
    };
    let between = |a: f64, b: f64, t: f64| a + (b - a) * t;
    let slice = |z: i64| {
        let row = |y: i64| between(at(4 * z + 2 * y), at(4 * z + 2 * y + 1), tx);
        between(row(0), row(1), ty)
    };
    between(slice(0), slice(1), tz)
}

/// Noise of four sizes, each half as large and half as strong as the one before; in [0, 1].
fn turbulence(place: [f64; 3], period: i64, seed: u32) -> f64 {
    let octave = |n: u32| noise(place, period << n, seed + 7 * n) / f64::from(2 << n);
    (0..4).map(octave).sum::<f64>() / 0.9375
}

/// The centres of a volume's texels, x fastest.
fn texels(side: usize) -> impl Iterator<Item = [f64; 3]> {
    let middle = move |at: usize| ((at % side) as f64 + 0.5) / side as f64;
    (0..side * side * side).map(move |at| [middle(at), middle(at / side), middle(at / side / side)])
}

/// `side`³ luminances of noise, for shaders that have a procedure of their own.
pub fn noise_volume(side: usize) -> Vec<u8> {
    texels(side).map(|place| byte(turbulence(place, 4, 83))).collect()
}

/// `side`³ RGB texels of marble: stripes along y, bent by noise (Perlin 1985).
pub fn marble_volume(side: usize) -> Vec<u8> {
    texels(side)
        .flat_map(|place| {
            let stripes = 3.0 * place[1] + place[0] + 4.2 * turbulence(place, 2, 89);
            let vein = 2.0 * (stripes - stripes.floor() - 0.5).abs();
            let stone = mix([0.93, 0.91, 0.87], [0.55, 0.60, 0.66], 1.4 * vein * vein);
            mix(stone, [0.13, 0.16, 0.24], 9.0 * vein - 8.0).map(byte)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn volumes_repeat_without_a_seam() {
        for place in [[0.0, 0.3, 0.7], [0.4, 0.0, 0.9], [0.2, 0.6, 0.0]] {
            let across = place.map(|at: f64| if at == 0.0 { 1.0 } else { at });
            assert!((turbulence(place, 4, 3) - turbulence(across, 4, 3)).abs() < 1e-12);
        }
    }
}
