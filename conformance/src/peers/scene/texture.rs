//! The textures of the scenes.

use crate::oracle::texture::Level;
use crate::rng::Rng;

/// Bricks of many colours, with grain: edges and noise at every scale.
pub fn bricks(side: usize) -> Level {
    let mut rng = Rng::named("bricks");
    let tints: Vec<[f64; 3]> = (0..256)
        .map(|_| [rng.real(0.5, 0.95), rng.real(0.25, 0.6), rng.real(0.1, 0.5)].map(f64::from))
        .collect();
    let (across, up) = (side / 8, side / 16);
    Level::from_fn(side, side, |i, j| {
        let row = j / up.max(1);
        let shifted = i + (row % 2) * across / 2;
        let mortar = j % up.max(1) < side / 128 || shifted % across.max(1) < side / 128;
        let tint = tints[(row * 37 + shifted / across.max(1)) % 256];
        let grain = f64::from(rng.byte()) / 255.0 * 0.3 + 0.7;
        let color = if mortar { [0.8, 0.78, 0.72] } else { tint };
        let [r, g, b] = color.map(|c| (c * grain * 255.0).round() as u8);
        [r, g, b, 255]
    })
}

/// A light map: bright in the middle.
pub fn light(side: usize) -> Level {
    Level::from_fn(side, side, |i, j| {
        let [x, y] = [i, j].map(|c| (c as f64 + 0.5) / side as f64 * 2.0 - 1.0);
        let c = (255.0 * (1.0 - 0.45 * (x * x + y * y))).round() as u8;
        [c, c, (f64::from(c) * 0.9).round() as u8, 255]
    })
}

/// Grain whose alpha varies too.
pub fn veil(side: usize) -> Level {
    let mut rng = Rng::named("veil");
    Level::from_fn(side, side, |_, _| {
        [rng.byte(), rng.byte(), rng.byte(), rng.integer(20, 120) as u8]
    })
}

/// A normal map of bumps: `n = 2 c - 1`.
pub fn bumps(side: usize) -> Level {
    let turns = std::f64::consts::TAU * 8.0 / side as f64;
    Level::from_fn(side, side, |i, j| {
        let (x, y) = ((i as f64 * turns).cos() * 0.5, (j as f64 * turns).sin() * 0.5);
        let length = (x * x + y * y + 1.0).sqrt();
        let [r, g, b] = [x, y, 1.0].map(|c| ((c / length + 1.0) * 127.5).round() as u8);
        [r, g, b, 255]
    })
}

/// Sky over ground with a horizon and a sun, as a sphere map.
pub fn surroundings(side: usize) -> Level {
    Level::from_fn(side, side, |i, j| {
        let [x, y] = [i, j].map(|c| (c as f64 + 0.5) / side as f64 * 2.0 - 1.0);
        let sun = (-40.0 * ((x - 0.4).powi(2) + (y - 0.5).powi(2))).exp();
        let stripes = 0.5 + 0.5 * (x * 60.0).sin();
        let color = if y > 0.0 {
            [0.3 + 0.5 * y + sun, 0.5 + 0.3 * y + sun, 0.9]
        } else {
            [0.3 + 0.2 * stripes, 0.25 - 0.2 * y, 0.1 + 0.1 * stripes]
        };
        let [r, g, b] = color.map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8);
        [r, g, b, 255]
    })
}

/// An image whose side is a power of two, and its levels: means of 2×2 texels.
pub fn pyramid(base: Level) -> Vec<Level> {
    let mut levels = vec![base];
    while let Some(last) = levels.last().filter(|level| level.width > 1) {
        let half = Level::from_fn(last.width / 2, last.height / 2, |i, j| {
            let texel = |a: usize, b: usize| last.texels[(2 * j + b) * last.width + 2 * i + a];
            let four = [texel(0, 0), texel(1, 0), texel(0, 1), texel(1, 1)];
            std::array::from_fn(|c| {
                (four.iter().map(|texel| u32::from(texel[c])).sum::<u32>() + 2).div_euclid(4) as u8
            })
        });
        levels.push(half);
    }
    levels
}
