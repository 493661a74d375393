//! Many layers of blending.

use super::definition::Sweep;
use crate::mutation::Variant;
use crate::oracle::blend::{Colors, Equation, Factor, blend};
use crate::plot::Line;
use crate::probe::{BlendState, ProbeError, Session};

/// Ten thousand layers.
pub const LAYERS: Sweep = Sweep {
    name: "blend-layers",
    what: "colour after this many layers of `over`, against the formula with each layer rounded \
           to bytes",
    parameter: "layers",
    unit: "/255",
    bound: 1.01,
    why: "f32 may round what is nearly halfway between two bytes the other way; later layers \
          make the difference smaller, so that errors do not add up",
    before: &[],
    run: layers,
};

fn layers() -> Result<Vec<Line>, ProbeError> {
    let over = BlendState {
        equation: Equation::Add,
        factors: [Factor::SrcAlpha, Factor::OneMinusSrcAlpha],
        constant: [0.0; 4],
    };
    let mut lines = Vec::new();
    for alpha in [0.01f32, 0.1, 0.7] {
        let session = Session::open()?;
        let mut points = Vec::new();
        let mut state = [0.0; 4];
        let mut done = 0;
        // Colours that alternate, so that nothing settles.
        let color = |layer: usize| {
            let hue = (layer * 89 % 256) as f32 / 255.0;
            [hue, 1.0 - hue, 0.3, alpha]
        };
        session.begin_layers(&over)?;
        for count in [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000] {
            let more: Vec<[f32; 4]> = (done..count).map(color).collect();
            let measured = session.layers(&more)?;
            for source in more {
                let colors = Colors {
                    source: source.map(f64::from),
                    destination: state,
                    constant: [0.0; 4],
                };
                let exact = blend(over.equation, over.factors, &colors, Variant::CORRECT);
                state = exact.map(|c| (c * 255.0).round() / 255.0);
            }
            done = count;
            let error = state.iter().zip(measured).map(|(a, b)| (a - b).abs() * 255.0);
            points.push((count as f64, error.fold(0.0, f64::max)));
        }
        lines.push(Line { name: format!("alpha {alpha}"), points });
    }
    Ok(lines)
}
