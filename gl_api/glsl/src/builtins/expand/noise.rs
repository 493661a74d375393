//! `noise1` to `noise4` (GLSL 1.30 section 8.9): gradient noise, the same on every machine.
//!
//! At each corner of the unit cell around the point stands a gradient whose components, in
//! [-1, 1], are the bytes of a hash of the corner's integer coordinates. The gradients' dot products
//! with the vectors from the corners to the point are blended by `t³(6t² - 15t + 10)` along each
//! axis. Along an axis the blended distance is at most ½, so the sum over `n` axes, times `2/n`,
//! stays in [-1, 1]; it is 0 at the corners, its mean is 0 and its first two derivatives are
//! continuous. The components of `noise2` to `noise4` differ in the seed of the hash.

use super::Args;
use crate::emit::Emit;
use rasterizer::ir::{Op, Ty, Value};

/// The seeds of the components.
const SEEDS: [u32; 4] = [0x9e37_79b9, 0x7f4a_7c15, 0x94d0_49bb, 0xbf58_476d];
/// What coordinates and hashes are multiplied by: odd, with bits all over the word.
const SPREAD: [u32; 2] = [0x85eb_ca6b, 0xc2b2_ae35];

/// `noise1`.
pub fn noise1(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    noise(emit, args, 1)
}

/// `noise2`.
pub fn noise2(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    noise(emit, args, 2)
}

/// `noise3`.
pub fn noise3(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    noise(emit, args, 3)
}

/// `noise4`.
pub fn noise4(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    noise(emit, args, 4)
}

/// An axis of the cell around the point.
struct Axis {
    /// The integer coordinate of both sides, spread over the word.
    sides: [Value; 2],
    /// The distance from both sides to the point.
    ways: [Value; 2],
    /// The weight of the far side.
    fade: Value,
}

fn noise(emit: &mut Emit, args: Args<'_>, components: usize) -> Vec<Value> {
    let axes: Vec<Axis> = args.values[0].iter().map(|&x| axis(emit, x)).collect();
    SEEDS[..components].iter().map(|&seed| blend(emit, &axes, seed)).collect()
}

fn axis(emit: &mut Emit, x: Value) -> Axis {
    let floor = emit.op(Op::Floor, &[x]);
    let near = emit.convert(floor, Ty::I32);
    let near = emit.convert(near, Ty::U32);
    let one = emit.uint(1);
    let far = emit.op(Op::UAdd, &[near, one]);
    let spread = emit.uint(SPREAD[0]);
    let sides = [near, far].map(|side| emit.op(Op::UMul, &[side, spread]));
    let t = emit.op(Op::Sub, &[x, floor]);
    let one = emit.float(1.0);
    let ways = [t, emit.op(Op::Sub, &[t, one])];
    // ((6t - 15) t + 10) t³
    let [six, fifteen, ten] = [6.0, 15.0, 10.0].map(|x| emit.float(x));
    let fade = emit.op(Op::Mul, &[six, t]);
    let fade = emit.op(Op::Sub, &[fade, fifteen]);
    let fade = emit.op(Op::Mul, &[fade, t]);
    let mut fade = emit.op(Op::Add, &[fade, ten]);
    for _ in 0..3 {
        fade = emit.op(Op::Mul, &[fade, t]);
    }
    Axis { sides, ways, fade }
}

/// A component: the corners' contributions, blended along one axis after the other.
fn blend(emit: &mut Emit, axes: &[Axis], seed: u32) -> Value {
    let mut corners: Vec<Value> =
        (0..1 << axes.len()).map(|corner| contribution(emit, axes, corner, seed)).collect();
    for axis in axes {
        corners = corners
            .chunks(2)
            .map(|pair| {
                let difference = emit.op(Op::Sub, &[pair[1], pair[0]]);
                let part = emit.op(Op::Mul, &[difference, axis.fade]);
                emit.op(Op::Add, &[pair[0], part])
            })
            .collect();
    }
    let scale = emit.float(2.0 / axes.len() as f32);
    emit.op(Op::Mul, &[corners[0], scale])
}

/// The dot product of the gradient of a corner with the vector from there to the point; bit `i` of
/// `corner` is its side on axis `i`.
fn contribution(emit: &mut Emit, axes: &[Axis], corner: usize, seed: u32) -> Value {
    let mut hash = emit.uint(seed);
    let (spread, fifteen) = (emit.uint(SPREAD[1]), emit.uint(15));
    for (i, axis) in axes.iter().enumerate() {
        hash = emit.op(Op::BitXor, &[hash, axis.sides[corner >> i & 1]]);
        hash = emit.op(Op::UMul, &[hash, spread]);
        let high = emit.op(Op::UShiftRight, &[hash, fifteen]);
        hash = emit.op(Op::BitXor, &[hash, high]);
    }
    let (mask, step, one) = (emit.uint(0xff), emit.float(2.0 / 255.0), emit.float(1.0));
    let mut sum = emit.float(0.0);
    for (i, axis) in axes.iter().enumerate() {
        let shift = emit.uint(8 * i as u32);
        let byte = emit.op(Op::UShiftRight, &[hash, shift]);
        let byte = emit.op(Op::BitAnd, &[byte, mask]);
        let byte = emit.convert(byte, Ty::F32);
        let gradient = emit.op(Op::Mul, &[byte, step]);
        let gradient = emit.op(Op::Sub, &[gradient, one]);
        let product = emit.op(Op::Mul, &[gradient, axis.ways[corner >> i & 1]]);
        sum = emit.op(Op::Add, &[sum, product]);
    }
    sum
}
