//! Smooth noise that repeats, from a hash of whole numbers.

/// A number in [0, 1) for each pair of integers (Bob Jenkins's and Thomas Wang's integer mixing).
pub fn hash(x: i64, y: i64, seed: u32) -> f64 {
    let mut h = (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca77) ^ seed;
    h = (h ^ (h >> 15)).wrapping_mul(0x2c1b_3c6d);
    h = (h ^ (h >> 12)).wrapping_mul(0x297a_2d39);
    h ^= h >> 15;
    f64::from(h >> 8) / 16_777_216.0
}

/// Value noise in [0, 1], interpolated between integers; it repeats with `period`, a power of two.
pub fn noise(x: f64, y: f64, period: i64, seed: u32) -> f64 {
    let (cell_x, cell_y) = (x.floor(), y.floor());
    let ease = |t: f64| t * t * (3.0 - 2.0 * t);
    let (tx, ty) = (ease(x - cell_x), ease(y - cell_y));
    let (ix, iy) = (cell_x as i64, cell_y as i64);
    let at = |dx: i64, dy: i64| hash((ix + dx) & (period - 1), (iy + dy) & (period - 1), seed);
    let top = at(0, 0) + (at(1, 0) - at(0, 0)) * tx;
    let bottom = at(0, 1) + (at(1, 1) - at(0, 1)) * tx;
    top + (bottom - top) * ty
}

/// Noise of five sizes, each half as large and half as strong as the one before; in [0, 1].
pub fn turbulence(x: f64, y: f64, period: i64, seed: u32) -> f64 {
    let (mut sum, mut scale, mut weight) = (0.0, 1.0, 0.5);
    for octave in 0..5 {
        let period = period << octave;
        sum += weight * noise(x * scale, y * scale, period, seed + octave);
        scale *= 2.0;
        weight *= 0.5;
    }
    sum / 0.968_75
}
