//! Code of fog: GL 2.1, section 3.10.

use crate::base::vector::{clamp, words};
use crate::generate::fixed::word;
use crate::state::fog::{FogMode, FogSource};
use rasterizer::ir::{Builder, Op, Value};

/// The state of fog that the code depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct FogKey {
    pub mode: FogMode,
    /// Whether the coordinate is a depth, whose sign does not matter.
    pub source: FogSource,
}

/// The two numbers that turn a distance into the exponent of 2, or into the factor: of exponential
/// fog the first is the density in the base 2 (its root, where it is squared), of linear fog they
/// are `1 / (end - start)` and `end`. (In a product and an offset, those of thin fog would be large
/// and cancel.) If the ends are equal the first is infinite, and fog is a step.
pub(crate) fn constants(mode: FogMode, density: f64, start: f64, end: f64) -> [f64; 2] {
    match mode {
        FogMode::Linear => [1.0 / (end - start), end],
        FogMode::Exp => [-density * std::f64::consts::LOG2_E, 0.0],
        FogMode::Exp2 => [density * std::f64::consts::LOG2_E.sqrt(), 0.0],
    }
}

/// A colour with fog, given the fog coordinate.
pub(crate) fn fog(
    b: &mut Builder,
    key: FogKey,
    base: u32,
    color: [Value; 4],
    distance: Value,
) -> [Value; 4] {
    let [red, green, blue, factor, end] = words(b, base + word::FOG);
    let distance = match key.source {
        FogSource::Depth => b.op(Op::Abs, &[distance]),
        FogSource::Coordinate => distance,
    };
    let distance = match key.mode {
        FogMode::Linear => b.op(Op::Sub, &[end, distance]),
        FogMode::Exp | FogMode::Exp2 => distance,
    };
    let scaled = b.op(Op::Mul, &[distance, factor]);
    let clear = match key.mode {
        FogMode::Linear => scaled,
        FogMode::Exp => b.op(Op::Exp2, &[scaled]),
        FogMode::Exp2 => {
            let square = b.op(Op::Mul, &[scaled, scaled]);
            let exponent = b.op(Op::Neg, &[square]);
            b.op(Op::Exp2, &[exponent])
        }
    };
    let clear = clamp(b, clear);
    let one = b.float(1.0);
    let dense = b.op(Op::Sub, &[one, clear]);
    let mut mix = |from: Value, to: Value| {
        let from = b.op(Op::Mul, &[from, clear]);
        let to = b.op(Op::Mul, &[to, dense]);
        b.op(Op::Add, &[from, to])
    };
    [mix(color[0], red), mix(color[1], green), mix(color[2], blue), color[3]]
}
