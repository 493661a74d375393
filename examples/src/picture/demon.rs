//! The demon of the first lecture: a face that fits the triangle it is pasted on.

use super::image::{Color, Picture, add, dim, disc, mix, stroke};
use super::noise::turbulence;

/// 128×128, as `demon_image.h`; the chin points down to the triangle's tip.
pub fn demon() -> Picture {
    Picture::paint(128, 128, |x, y| {
        let (x, y) = (2.0 * x - 1.0, 2.0 * y - 1.0);
        // Both halves are the same.
        face(x.abs(), y).unwrap_or_else(|| flames(x, y))
    })
}

fn flames(x: f64, y: f64) -> Color {
    let heat = turbulence(3.0 * x + 9.0, 2.0 * y + 7.0, 64, 5) + 0.45 * y.abs() - 0.1;
    let glow = mix([0.10, 0.0, 0.04], [0.75, 0.16, 0.02], heat * 1.9 - 0.6);
    mix(glow, [1.0, 0.82, 0.25], heat * 3.0 - 1.9)
}

const SKIN: Color = [0.80, 0.10, 0.07];
const SHADOW: Color = [0.33, 0.01, 0.05];
const BONE: Color = [0.98, 0.91, 0.74];
const INK: Color = [0.06, 0.0, 0.02];

/// The right half of the face (`x >= 0`), or nothing beside it.
fn face(x: f64, y: f64) -> Option<Color> {
    features(x, y).or_else(|| horn(x, y)).or_else(|| skin(x, y))
}

fn features(x: f64, y: f64) -> Option<Color> {
    let pupil = disc(x * 3.0, y, 0.225 * 3.0, -0.145, 0.10);
    // An eye is where two discs overlap, one of them high above: a glare.
    let eye = disc(x, y, 0.22, -0.02, 0.21) && !disc(x, y, 0.0, -0.62, 0.485);
    let eye = eye && disc(x, y, 0.26, -0.26, 0.25);
    let brow =
        disc(x, y, 0.0, -0.64, 0.51) && !disc(x, y, 0.02, -0.70, 0.485) && y > -0.46 && x < 0.42;
    let nostril = disc(x, y * 0.7, 0.075, 0.145, 0.035);
    let grin = disc(x, y, 0.0, 0.02, 0.42) && !disc(x, y, 0.0, -0.17, 0.50);
    let fang =
        stroke([x, y], [0.20, 0.36], [0.20, 0.36], 0.075) && y < 0.50 - (x - 0.20).abs() * 3.2;
    let tooth = (y - 0.335) < 0.03 - ((x * 12.0).fract() - 0.5).abs() * 0.05;
    let goatee = y > 0.50 && x < 0.16 * (1.0 - (y - 0.50) / 0.42);
    Some(match () {
        () if pupil && eye => INK,
        () if eye => mix([1.0, 0.95, 0.30], [1.0, 0.45, 0.0], (x - 0.1) * 3.0),
        () if brow => INK,
        () if nostril => SHADOW,
        () if grin && (fang || tooth) => BONE,
        () if grin => [0.22, 0.0, 0.02],
        () if goatee => INK,
        () => return None,
    })
}

/// A crescent over the temple, with rings.
fn horn(x: f64, y: f64) -> Option<Color> {
    let inside = disc(x, y, 0.50, -0.66, 0.40) && !disc(x, y, 0.36, -0.80, 0.40) && y < -0.20;
    let ring = ((x - 0.36) * 0.6 - (y + 0.80) * 1.1) * 11.0;
    let shade = 0.72 + 0.28 * (ring - ring.floor());
    inside.then(|| dim(mix(BONE, [0.55, 0.40, 0.28], (y + 0.75) * 1.6), shade))
}

/// A drop upside down: round at the forehead, pointed at the chin.
fn skin(x: f64, y: f64) -> Option<Color> {
    let t = (y + 0.58) / 1.50;
    let half = if (0.0..1.0).contains(&t) { 1.72 * t.sqrt() * (1.0 - t) } else { 0.0 };
    let ear = disc(x, y, 0.60, -0.02, 0.20) && !disc(x, y, 0.62, -0.20, 0.22) && y < 0.10;
    let light = add(mix(SKIN, SHADOW, x * 1.3 + (y - 0.2).abs() * 0.35 - 0.15), [0.0; 3]);
    let cheek = if disc(x, y, 0.30, 0.16, 0.13) { 1.18 } else { 1.0 };
    (x < half || ear).then(|| dim(light, if x > half - 0.035 { 0.55 } else { cheek }))
}
