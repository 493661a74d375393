//! The slide for the projector: a rose window.

use super::image::{Color, Picture, dim, disc, mix};
use super::noise::turbulence;
use gl_api::glu::angle::sin_cos_degrees;

const LEAD: Color = [0.05, 0.05, 0.06];
const GLASS: [Color; 6] = [
    [0.95, 0.20, 0.15],
    [0.12, 0.35, 0.95],
    [0.98, 0.78, 0.15],
    [0.15, 0.70, 0.35],
    [0.62, 0.20, 0.80],
    [0.10, 0.72, 0.85],
];

/// A ring of round panes: how many, how far out, how large, and which two colours of glass.
struct Ring {
    panes: usize,
    distance: f64,
    radius: f64,
    glass: [usize; 2],
}

const RINGS: [Ring; 4] = [
    Ring { panes: 1, distance: 0.0, radius: 0.17, glass: [2, 2] },
    Ring { panes: 8, distance: 0.32, radius: 0.112, glass: [0, 1] },
    Ring { panes: 16, distance: 0.535, radius: 0.095, glass: [5, 4] },
    Ring { panes: 16, distance: 0.765, radius: 0.135, glass: [1, 0] },
];

/// 512×512, black outside the round.
pub fn rose() -> Picture {
    let panes: Vec<(f64, f64, f64, Color)> = RINGS.iter().flat_map(panes).collect();
    Picture::paint(512, 512, |x, y| {
        let (x, y) = (2.0 * x - 1.0, 2.0 * y - 1.0);
        let streaks = 0.80 + 0.35 * turbulence(x * 5.0 + 8.0, y * 5.0 + 8.0, 64, 3);
        let pane = panes.iter().find(|pane| disc(x, y, pane.0, pane.1, pane.2));
        match pane {
            Some(&(px, py, radius, color)) => {
                // Paler toward the middle, as blown glass is.
                let (dx, dy) = ((x - px) / radius, (y - py) / radius);
                let pale = mix([1.0; 3], color, 0.60 + 0.7 * (dx * dx + dy * dy).sqrt());
                dim(pale, streaks)
            }
            None if panes.iter().any(|pane| disc(x, y, pane.0, pane.1, pane.2 + 0.024)) => LEAD,
            None if disc(x, y, 0.0, 0.0, 0.93) => dim(ground(x, y), streaks),
            None if disc(x, y, 0.0, 0.0, 0.97) => LEAD,
            None => dim(GLASS[4], 0.45 * streaks),
        }
    })
}

/// Between the panes: amber inside, green around it, and lead where they meet.
fn ground(x: f64, y: f64) -> Color {
    let out = (x * x + y * y).sqrt();
    match out {
        _ if (out - 0.44).abs() < 0.012 || (out - 0.63).abs() < 0.012 => LEAD,
        _ if out < 0.44 => [0.95, 0.60, 0.18],
        _ if out < 0.63 => [0.16, 0.42, 0.30],
        _ => [0.90, 0.72, 0.40],
    }
}

fn panes(ring: &Ring) -> impl Iterator<Item = (f64, f64, f64, Color)> + '_ {
    (0..ring.panes).map(|at| {
        let (sin, cos) = sin_cos_degrees(360.0 * at as f64 / ring.panes as f64);
        let color = GLASS[ring.glass[at % 2]];
        (ring.distance * sin, -ring.distance * cos, ring.radius - 0.012, color)
    })
}
