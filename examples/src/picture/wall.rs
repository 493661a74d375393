//! Bricks, flagstones and planks that repeat without a seam.

use super::image::{Color, Picture, dim, mix, smooth};
use super::noise::{hash, turbulence};

const SIZE: usize = 256;

/// A course of blocks: rows of `per_row`, every other row shifted by half a block.
struct Courses {
    rows: i64,
    per_row: i64,
    /// Width of the joint, as a fraction of a row's height.
    joint: f64,
    shift: f64,
}

const BRICKS: Courses = Courses { rows: 8, per_row: 4, joint: 0.085, shift: 0.5 };
const FLAGSTONES: Courses = Courses { rows: 4, per_row: 4, joint: 0.04, shift: 0.35 };
const PLANKS: Courses = Courses { rows: 6, per_row: 1, joint: 0.05, shift: 0.37 };

/// The block of a point of the unit square, and the point's position in it.
struct BlockPosition {
    /// A number in [0, 1) for the block, by seed.
    block: (i64, i64),
    /// 0 in the joint, rising to 1 within the block.
    height: f64,
}

impl Courses {
    fn place(&self, x: f64, y: f64) -> BlockPosition {
        let row = (y * self.rows as f64).floor();
        let shifted = x * self.per_row as f64 + self.shift * (row as i64 % 2) as f64;
        let column = shifted.floor();
        let aspect = self.rows as f64 / self.per_row as f64;
        let (u, v) = (shifted - column, y * self.rows as f64 - row);
        let ragged = 0.5 * self.joint * turbulence(x * 16.0, y * 16.0, 16, 41);
        let edge = (u.min(1.0 - u) * aspect).min(v.min(1.0 - v)) - ragged;
        let block = ((column as i64).rem_euclid(self.per_row), row as i64);
        BlockPosition { block, height: smooth(self.joint * 0.5, self.joint * 1.6, edge) }
    }
}

/// 256×256: red bricks in pale mortar.
pub fn bricks() -> Picture {
    Picture::paint(SIZE, SIZE, |x, y| {
        let place = BRICKS.place(x, y);
        let tone = hash(place.block.0, place.block.1, 1);
        let grain = turbulence(x * 32.0, y * 32.0, 32, 2);
        let brick = mix([0.62, 0.24, 0.16], [0.86, 0.46, 0.30], tone);
        let brick = dim(mix(brick, [0.45, 0.26, 0.24], tone * 7.0 - 6.0), 0.65 + 0.6 * grain);
        mix(dim([0.72, 0.68, 0.62], 0.75 + 0.3 * grain), brick, place.height)
    })
}

/// The height field of [`bricks`], black deep and white high.
pub fn brick_heights() -> Picture {
    Picture::paint(SIZE, SIZE, |x, y| {
        let place = BRICKS.place(x, y);
        let tilt = 0.16 * hash(place.block.0, place.block.1, 4);
        let grain = turbulence(x * 32.0, y * 32.0, 32, 2);
        [0.12 * grain + place.height * (0.55 + tilt + 0.16 * grain); 3]
    })
}

/// 256×256: grey flagstones, some of them mossy.
pub fn flagstones() -> Picture {
    Picture::paint(SIZE, SIZE, |x, y| {
        let place = FLAGSTONES.place(x, y);
        let tone = hash(place.block.0, place.block.1, 5);
        let grain = turbulence(x * 16.0, y * 16.0, 16, 6);
        let stone = mix([0.46, 0.47, 0.50], [0.74, 0.71, 0.66], tone);
        let moss = smooth(0.50, 0.75, turbulence(x * 4.0, y * 4.0, 4, 7));
        let stone = mix(dim(stone, 0.6 + 0.7 * grain), [0.36, 0.44, 0.24], 0.6 * moss);
        mix([0.16, 0.15, 0.14], stone, place.height)
    })
}

/// 256×256: planks along `x`.
pub fn planks() -> Picture {
    Picture::paint(SIZE, SIZE, |x, y| {
        let place = PLANKS.place(x, y);
        let tone = hash(place.block.0, place.block.1, 8);
        // Rings of the tree, cut lengthwise.
        let warp = turbulence(x * 4.0, y * 16.0 + 16.0 * place.block.1 as f64, 256, 9);
        let ring = y * 36.0 + warp * 9.0;
        let ring = (ring - ring.floor() - 0.5).abs() * 2.0;
        let wood: Color = mix([0.40, 0.25, 0.13], [0.70, 0.49, 0.28], 0.45 * tone + 0.55 * ring);
        mix([0.09, 0.06, 0.04], wood, place.height)
    })
}
