//! Texture environments: GL 2.1, tables 3.21 to 3.23.

use crate::env::Mode;
use rasterizer::ir::{Builder, Op, Value};
use texunit::format::BaseFormat;
use texunit::sampler::DepthMode;

/// How a texture's alpha takes part, by its base format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Alpha {
    /// There is none.
    Absent,
    /// There is one.
    Present,
    /// It is the intensity, which is blended like a colour.
    Intensity,
}

/// A base format as the tables see it; `None` where the texture has no colour.
fn columns(base: BaseFormat) -> (bool, Alpha) {
    match base {
        BaseFormat::Alpha => (false, Alpha::Present),
        BaseFormat::Luminance | BaseFormat::Rgb | BaseFormat::Red | BaseFormat::Rg => {
            (true, Alpha::Absent)
        }
        BaseFormat::LuminanceAlpha | BaseFormat::Rgba => (true, Alpha::Present),
        BaseFormat::Intensity => (true, Alpha::Intensity),
        // `environment_base` never gives it; as luminance, its default mode.
        BaseFormat::Depth => (true, Alpha::Absent),
    }
}

/// The base format that an environment sees: depth acts as its mode says (section 3.8.14).
pub(crate) fn environment_base(base: BaseFormat, mode: DepthMode) -> BaseFormat {
    match (base, mode) {
        (BaseFormat::Depth, DepthMode::Luminance) => BaseFormat::Luminance,
        (BaseFormat::Depth, DepthMode::Intensity) => BaseFormat::Intensity,
        (BaseFormat::Depth, DepthMode::Alpha) => BaseFormat::Alpha,
        (
            BaseFormat::Alpha
            | BaseFormat::Luminance
            | BaseFormat::LuminanceAlpha
            | BaseFormat::Intensity
            | BaseFormat::Red
            | BaseFormat::Rg
            | BaseFormat::Rgb
            | BaseFormat::Rgba,
            DepthMode::Luminance | DepthMode::Intensity | DepthMode::Alpha,
        ) => base,
    }
}

/// The colour that a unit passes on: `previous` is `Cp, Ap`, `source` is `Cs, As` as the texture
/// gives it, `constant` is `Cc, Ac`.
pub(super) fn apply(
    b: &mut Builder,
    mode: Mode,
    base: BaseFormat,
    previous: [Value; 4],
    source: [Value; 4],
    constant: [Value; 4],
) -> [Value; 4] {
    let (has_color, alpha) = columns(base);
    let color = |b: &mut Builder, i: usize| {
        let (p, s, c) = (previous[i], source[i], constant[i]);
        if !has_color {
            return p;
        }
        match mode {
            Mode::Replace => s,
            Mode::Modulate => b.op(Op::Mul, &[p, s]),
            Mode::Blend => blend(b, p, c, s),
            Mode::Add => add(b, p, s),
            // The tables define it for RGB and RGBA; other formats leave the colour as it is.
            Mode::Decal => match base {
                BaseFormat::Rgb => s,
                BaseFormat::Rgba => blend(b, p, s, source[3]),
                BaseFormat::Alpha
                | BaseFormat::Luminance
                | BaseFormat::LuminanceAlpha
                | BaseFormat::Intensity
                | BaseFormat::Red
                | BaseFormat::Rg
                | BaseFormat::Depth => p,
            },
        }
    };
    let [red, green, blue] = [0, 1, 2].map(|i| color(b, i));
    let (p, s, c) = (previous[3], source[3], constant[3]);
    let alpha = match (mode, alpha) {
        (_, Alpha::Absent) | (Mode::Decal, Alpha::Present | Alpha::Intensity) => p,
        (Mode::Replace, Alpha::Present | Alpha::Intensity) => s,
        (Mode::Blend, Alpha::Intensity) => blend(b, p, c, s),
        (Mode::Add, Alpha::Intensity) => add(b, p, s),
        (Mode::Modulate, Alpha::Present | Alpha::Intensity)
        | (Mode::Blend | Mode::Add, Alpha::Present) => b.op(Op::Mul, &[p, s]),
    };
    [red, green, blue, alpha]
}

/// `from (1 - weight) + to weight`.
fn blend(b: &mut Builder, from: Value, to: Value, weight: Value) -> Value {
    let one = b.float(1.0);
    let rest = b.op(Op::Sub, &[one, weight]);
    let from = b.op(Op::Mul, &[from, rest]);
    let to = b.op(Op::Mul, &[to, weight]);
    b.op(Op::Add, &[from, to])
}

/// `min(a + b, 1)`: what a unit passes on is clamped.
fn add(b: &mut Builder, left: Value, right: Value) -> Value {
    let sum = b.op(Op::Add, &[left, right]);
    let one = b.float(1.0);
    b.op(Op::Min, &[sum, one])
}
