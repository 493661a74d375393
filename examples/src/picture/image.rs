//! Pictures of RGB bytes, and colours.

use bytemuck::{Pod, Zeroable};
use std::cell::Cell;
use std::time::{Duration, Instant};

/// A pixel of the lecture's `ppmread`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct packed_pixel_t {
    /// Red.
    pub r: u8,
    /// Green.
    pub g: u8,
    /// Blue.
    pub b: u8,
}

/// Red, green and blue, 0 to 1.
pub type Color = [f64; 3];

/// An RGB picture of 8 bits a component.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// `width * height` pixels, the top row first.
    pub pixels: Vec<packed_pixel_t>,
}

thread_local! {
    /// Time that this thread has spent on procedural pictures.
    static PAINTING: Cell<Duration> = const { Cell::new(Duration::ZERO) };
}

/// Adds the time since `start`.
fn painted(start: Instant) {
    PAINTING.set(PAINTING.get() + start.elapsed());
}

/// Time that this thread has spent on procedural pictures, which is no part of the time of GL.
pub fn painting() -> Duration {
    PAINTING.get()
}

impl Picture {
    /// A procedural picture: `color(x, y)` with `x` from 0 (left) to 1 and `y` from 0 (top) to 1,
    /// the mean of 2×2 samples a pixel.
    pub fn paint(width: usize, height: usize, color: impl Fn(f64, f64) -> Color) -> Self {
        const POINTS: usize = 2;
        let start = Instant::now();
        let at = |pixel: usize, point: usize, size: usize| {
            (pixel as f64 + (point as f64 + 0.5) / POINTS as f64) / size as f64
        };
        let mut pixels = Vec::with_capacity(width * height);
        for y in 0..height {
            for x in 0..width {
                let mut sum = [0.0; 3];
                for point in 0..POINTS * POINTS {
                    let (x, y) = (at(x, point % POINTS, width), at(y, point / POINTS, height));
                    sum = add(sum, color(x, y));
                }
                let [r, g, b] = sum.map(|sum| byte(sum / (POINTS * POINTS) as f64));
                pixels.push(packed_pixel_t { r, g, b });
            }
        }
        painted(start);
        Self { width, height, pixels }
    }

    /// A procedural picture with one sample at the centre of each pixel, for data.
    pub fn paint_centers(width: usize, height: usize, color: impl Fn(f64, f64) -> Color) -> Self {
        let start = Instant::now();
        let middle = |pixel: usize, size: usize| (pixel as f64 + 0.5) / size as f64;
        let pixel = |at: usize| {
            let [r, g, b] = color(middle(at % width, width), middle(at / width, height)).map(byte);
            packed_pixel_t { r, g, b }
        };
        let pixels = (0..width * height).map(pixel).collect();
        painted(start);
        Self { width, height, pixels }
    }

    /// The same picture with its rows from bottom to top, as GL counts them.
    #[must_use]
    pub fn flipped(self) -> Self {
        let rows = self.pixels.chunks_exact(self.width.max(1)).rev();
        Self { pixels: rows.flatten().copied().collect(), ..self }
    }

    /// The largest square in its middle.
    #[must_use]
    pub fn squared(self) -> Self {
        let side = self.width.min(self.height);
        let (left, top) = ((self.width - side) / 2, (self.height - side) / 2);
        let rows = self.pixels.chunks_exact(self.width.max(1)).skip(top).take(side);
        let pixels = rows.flat_map(|row| &row[left..left + side]).copied().collect();
        Self { width: side, height: side, pixels }
    }

    /// A checksum of size and pixels that stays the same between versions: FNV-1a, 64 bits.
    pub fn checksum(&self) -> u64 {
        let size = [self.width as u64, self.height as u64];
        let size = size.iter().flat_map(|side| side.to_le_bytes());
        let bytes = size.chain(bytemuck::cast_slice(&self.pixels).iter().copied());
        bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        })
    }
}

/// The byte nearest to 255 times a component in [0, 1].
pub(super) fn byte(value: f64) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}

/// The sum of two colours.
pub fn add(a: Color, b: Color) -> Color {
    std::array::from_fn(|at| a[at] + b[at])
}

/// A colour times a factor.
pub fn dim(color: Color, by: f64) -> Color {
    color.map(|component| component * by)
}

/// Linear interpolation from `a` (`t` = 0) to `b` (`t` = 1); `t` is clamped.
pub fn mix(a: Color, b: Color, t: f64) -> Color {
    let t = t.clamp(0.0, 1.0);
    std::array::from_fn(|at| a[at] + (b[at] - a[at]) * t)
}

/// 0 below `low`, 1 above `high`, smooth between (GLSL's `smoothstep`).
pub fn smooth(low: f64, high: f64, x: f64) -> f64 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Whether a point is within `radius` of another.
pub fn disc(x: f64, y: f64, center_x: f64, center_y: f64, radius: f64) -> bool {
    let (dx, dy) = (x - center_x, y - center_y);
    dx * dx + dy * dy < radius * radius
}

/// Whether a point is within `radius` of the line between two points.
pub fn stroke([x, y]: [f64; 2], from: [f64; 2], to: [f64; 2], radius: f64) -> bool {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let along = ((x - from[0]) * dx + (y - from[1]) * dy) / (dx * dx + dy * dy);
    let along = along.clamp(0.0, 1.0);
    disc(x, y, from[0] + along * dx, from[1] + along * dy, radius)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checksum_is_fnv_1a() {
        let empty = Picture { width: 0, height: 0, pixels: vec![] };
        // 16 zero bytes.
        assert_eq!(empty.checksum(), 0x8820_1fb9_60ff_6465);
    }

    #[test]
    fn flipping_reverses_rows() {
        let picture = Picture::paint(2, 2, |x, y| [x, y, 0.0]);
        let flipped = picture.clone().flipped();
        assert_eq!(flipped.pixels[0], picture.pixels[2]);
        assert_eq!(flipped.flipped(), picture);
    }
}
