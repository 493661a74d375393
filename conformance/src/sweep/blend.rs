//! Many layers of blending.

use super::definition::Sweep;
use super::drawn::square;
use super::series::{Compared, Point, Series};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::blend::{Colors, Equation, Factor, blend};
use crate::oracle::format::small_float;
use crate::probe::{BlendState, ProbeError, Session};
use gl_api::constants::*;

/// Numbers of layers.
const COUNTS: [usize; 17] =
    [1, 2, 3, 5, 10, 20, 30, 50, 100, 200, 300, 500, 1000, 2000, 3000, 5000, 10_000];

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
    breaks: "after about 1/alpha layers the colour repeats: no error is left of earlier ones",
    kept: 1.0,
    distinct: 0.8,
    before: &[],
    run: layers,
};

/// Ten thousand layers over wider formats.
pub const WIDE_LAYERS: Sweep = Sweep {
    name: "blend-layers-wide",
    what: "as blend-layers over 16 bits, half floats and floats, against the formula with each layer \
           rounded to the format, in its steps",
    parameter: "layers",
    unit: "steps of the format",
    bound: 4.0,
    why: "a layer is two products and a sum in f32 (four roundings of floats), and a rounding to the \
          format; of earlier errors (1 - alpha) is left, so that they sum to 1/alpha of them at most",
    breaks: "as blend-layers; floats have the formula's rounding alone: s·a + d·(1 - a) with each \
             operation rounded to f32, in this order",
    kept: 1.0,
    distinct: 0.7,
    before: &[],
    run: wide_layers,
};

/// Accumulation.
pub const ACCUMULATION: Sweep = Sweep {
    name: "accumulation",
    what: "a picture that is added this many times to the accumulation buffer, each by its share",
    parameter: "times",
    unit: "/255",
    bound: 0.0,
    why: "the accumulation buffer holds floats, and all roundings together are below half a byte",
    breaks: "shares below the buffer's step would be lost: 1/1024 of a byte's 1/255 is not",
    kept: 1.0,
    distinct: 0.0,
    before: &[],
    run: accumulation,
};

/// A number as a format stores it.
type Rounding = fn(f64) -> f64;

fn wide_layers() -> Result<Vec<Series>, ProbeError> {
    let formats: [(&str, u32, f64, Rounding); 3] = [
        ("16 bits", GL_RGBA16, 1.0 / 65535.0, |c| (c.clamp(0.0, 1.0) * 65535.0).round() / 65535.0),
        ("half floats", GL_RGBA16F, 2f64.powi(-11), |c| small_float(c, 10, 5, Variant::CORRECT)),
        ("floats", GL_RGBA32F, 2f64.powi(-24), |c| f64::from(c as f32)),
    ];
    let mut lines = Vec::new();
    for (name, format, step, round) in formats {
        let session = Session::open()?;
        session.frame(format, [4, 4], 0)?;
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
        let mut points: Vec<Point> = Vec::new();
        let (mut state, mut done) = ([0.0f64; 3], 0);
        for count in COUNTS {
            for layer in done..count {
                let hue = (layer * 89 % 256) as f32 / 255.0;
                let source = [hue, 1.0 - hue, 0.3];
                let alpha = 0.1f32;
                glColor4f(source[0], source[1], source[2], alpha);
                square([[0.0; 4]; 4]);
                let alpha = f64::from(alpha);
                state = [0, 1, 2]
                    .map(|c| round(f64::from(source[c]) * alpha + state[c] * (1.0 - alpha)));
            }
            done = count;
            let measured = session.read_floats([4, 4])?[5];
            let mut compared = Compared::new();
            for (exact, measured) in state.iter().zip(measured) {
                compared.add((exact - measured).abs() / step, &[measured]);
            }
            points.push(compared.at(count as f64));
        }
        lines.push(Series { name: name.to_owned(), points });
    }
    Ok(lines)
}

fn accumulation() -> Result<Vec<Series>, ProbeError> {
    let session = Session::open()?;
    let times = (0..=20).map(|step| (2f64.powf(f64::from(step) / 2.0)).round());
    // Only these pixels are added up.
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 4, 4);
    let line = Series::measured("largest error", times, |times| {
        let color = [0.2f32, 0.5, 0.71, 1.0];
        glClearColor(color[0], color[1], color[2], color[3]);
        glClear(GL_COLOR_BUFFER_BIT);
        let share = (1.0 / times) as f32;
        glAccum(GL_LOAD, share);
        for _ in 1..times as usize {
            glAccum(GL_ACCUM, share);
        }
        let shown = session.layers(&[])?;
        glAccum(GL_RETURN, 1.0);
        let measured = session.layers(&[])?;
        let mut compared = Compared::new();
        for (before, after) in shown.iter().zip(measured) {
            compared.add((before - after).abs() * 255.0, &[after]);
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}

fn layers() -> Result<Vec<Series>, ProbeError> {
    let over = BlendState {
        equation: Equation::Add,
        factors: [Factor::SrcAlpha, Factor::OneMinusSrcAlpha],
        constant: [0.0; 4],
    };
    let mut lines = Vec::new();
    for alpha in [0.01f32, 0.1, 0.7] {
        let session = Session::open()?;
        let mut points: Vec<Point> = Vec::new();
        let mut state = [0.0; 4];
        let mut done = 0;
        // Colours that alternate, so that nothing settles.
        let color = |layer: usize| {
            let hue = (layer * 89 % 256) as f32 / 255.0;
            [hue, 1.0 - hue, 0.3, alpha]
        };
        session.begin_layers(&over)?;
        for count in COUNTS {
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
            let mut compared = Compared::new();
            compared.add(error.fold(0.0, f64::max), &measured);
            points.push(compared.at(count as f64));
        }
        lines.push(Series { name: format!("alpha {alpha}"), points });
    }
    Ok(lines)
}
