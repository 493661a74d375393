//! Grass, rock and clouds that repeat without a seam.

use super::image::{Picture, dim, mix, smooth};
use super::noise::{noise, turbulence};

const SIZE: usize = 256;

/// 256×256: a lawn, seen from above.
pub fn grass() -> Picture {
    Picture::paint(SIZE, SIZE, |x, y| {
        // Blades: noise drawn out along y, bent by noise that is not.
        let bent = x * 64.0 + 1.5 * noise(x * 16.0, y * 16.0, 16, 21);
        let blade =
            noise(bent, y * 16.0, 64, 22) * 0.6 + noise(bent * 2.0, y * 32.0, 128, 23) * 0.4;
        let patch = turbulence(x * 4.0, y * 4.0, 4, 24);
        let green = mix([0.06, 0.20, 0.04], [0.52, 0.74, 0.22], 1.7 * blade - 0.35);
        mix(green, [0.62, 0.62, 0.24], 0.9 * patch - 0.35)
    })
}

/// 256×256: grey rock in layers, with cracks.
pub fn rock() -> Picture {
    Picture::paint(SIZE, SIZE, |x, y| {
        let warp = turbulence(x * 4.0, y * 4.0, 4, 31);
        let layer = noise(x * 4.0, y * 16.0 + 2.0 * warp, 16, 32);
        let grain = turbulence(x * 32.0, y * 32.0, 32, 33);
        let crack = smooth(0.0, 0.06, (turbulence(x * 8.0, y * 8.0, 8, 34) - 0.5).abs());
        let stone = mix([0.36, 0.33, 0.31], [0.70, 0.66, 0.60], layer);
        dim(stone, (0.6 + 0.7 * grain) * (0.55 + 0.45 * crack))
    })
}

/// 256×256: a sky with clouds.
pub fn clouds() -> Picture {
    Picture::paint(SIZE, SIZE, |x, y| {
        let cloud = smooth(0.46, 0.72, turbulence(x * 4.0, y * 4.0, 4, 41));
        mix(mix([0.28, 0.50, 0.86], [0.70, 0.83, 0.96], y), [0.99, 0.98, 0.96], cloud)
    })
}
