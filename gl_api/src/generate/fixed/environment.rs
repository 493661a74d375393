//! Code of texture environments: GL 2.1, tables 3.21 to 3.23.

use crate::base::clamp::Clamp;
use crate::generate::fixed::combine::{CombineKey, Sources, combine};
use crate::state::texture_units::combine::Combiner;
use crate::state::texture_units::{Mode, Standard};
use rasterizer::ir::{Builder, Op, Value};
use texunit::format::BaseFormat;
use texunit::sampler::DepthMode;

/// The alpha of a texture, by its base format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Alpha {
    /// There is none.
    Absent,
    /// There is one.
    Present,
    /// It is the intensity, which is blended like a colour.
    Intensity,
}

/// Whether a base format has colour, and its alpha, as the tables distinguish them.
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

/// The base format for an environment: depth is treated as `GL_DEPTH_TEXTURE_MODE` says (section 3.8.14).
pub(crate) fn environment_base(base: BaseFormat, mode: DepthMode) -> BaseFormat {
    match (base, mode) {
        (BaseFormat::Depth, DepthMode::Luminance) => BaseFormat::Luminance,
        (BaseFormat::Depth, DepthMode::Intensity) => BaseFormat::Intensity,
        (BaseFormat::Depth, DepthMode::Alpha) => BaseFormat::Alpha,
        (BaseFormat::Depth, DepthMode::Red) => BaseFormat::Red,
        (
            BaseFormat::Alpha
            | BaseFormat::Luminance
            | BaseFormat::LuminanceAlpha
            | BaseFormat::Intensity
            | BaseFormat::Red
            | BaseFormat::Rg
            | BaseFormat::Rgb
            | BaseFormat::Rgba,
            DepthMode::Luminance | DepthMode::Intensity | DepthMode::Alpha | DepthMode::Red,
        ) => base,
    }
}

/// A unit's environment: part of a module's key.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Environment {
    Standard(Standard),
    Combine(CombineKey),
}

impl Environment {
    /// The key of a unit's state.
    pub fn new(mode: Mode, combiners: &[Combiner; 2]) -> Self {
        match mode {
            Mode::Standard(mode) => Self::Standard(mode),
            Mode::Combine(arguments) => Self::Combine(CombineKey::new(arguments, combiners)),
        }
    }
}

/// The colour after a unit; without a texture, the colour before it.
pub(crate) fn apply(
    b: &mut Builder,
    environment: &Environment,
    base: BaseFormat,
    from: &Sources<'_>,
) -> [Value; 4] {
    match (environment, from.texel(from.unit)) {
        (_, None) => from.previous,
        (Environment::Combine(key), Some(_)) => combine(b, key, from),
        (Environment::Standard(mode), Some(texel)) => standard(b, *mode, base, from, texel),
    }
}

/// Tables 3.22 and 3.23: `previous` is `Cp, Ap`, `source` is `Cs, As` as the texture gives it,
/// `constant` is `Cc, Ac`.
fn standard(
    b: &mut Builder,
    mode: Standard,
    base: BaseFormat,
    from: &Sources<'_>,
    source: [Value; 4],
) -> [Value; 4] {
    let Sources { previous, constant, clamp, .. } = *from;
    let (has_color, alpha) = columns(base);
    let color = |b: &mut Builder, i: usize| {
        let (p, s, c) = (previous[i], source[i], constant[i]);
        if !has_color {
            return p;
        }
        match mode {
            Standard::Replace => s,
            Standard::Modulate => b.op(Op::Mul, &[p, s]),
            Standard::Blend => blend(b, p, c, s),
            Standard::Add => add(b, clamp, p, s),
            // The tables define it for RGB, with RED and RG (GL 3.0, table 3.23), and RGBA; other formats leave
            // the colour as it is.
            Standard::Decal => match base {
                BaseFormat::Rgb | BaseFormat::Red | BaseFormat::Rg => s,
                BaseFormat::Rgba => blend(b, p, s, source[3]),
                BaseFormat::Alpha
                | BaseFormat::Luminance
                | BaseFormat::LuminanceAlpha
                | BaseFormat::Intensity
                | BaseFormat::Depth => p,
            },
        }
    };
    let [red, green, blue] = [0, 1, 2].map(|i| color(b, i));
    let (p, s, c) = (previous[3], source[3], constant[3]);
    let alpha = match (mode, alpha) {
        (_, Alpha::Absent) | (Standard::Decal, Alpha::Present | Alpha::Intensity) => p,
        (Standard::Replace, Alpha::Present | Alpha::Intensity) => s,
        (Standard::Blend, Alpha::Intensity) => blend(b, p, c, s),
        (Standard::Add, Alpha::Intensity) => add(b, clamp, p, s),
        (Standard::Modulate, Alpha::Present | Alpha::Intensity)
        | (Standard::Blend | Standard::Add, Alpha::Present) => b.op(Op::Mul, &[p, s]),
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

/// `min(a + b, 1)` if the unit's result is clamped, else `a + b`.
fn add(b: &mut Builder, clamp: Clamp, left: Value, right: Value) -> Value {
    let sum = b.op(Op::Add, &[left, right]);
    match clamp {
        Clamp::On => {
            let one = b.float(1.0);
            b.op(Op::Min, &[sum, one])
        }
        Clamp::Off => sum,
    }
}
