//! Geometric functions (GLSL 1.30 section 8.4).

use super::{Args, each, per_component};
use crate::emit::Emit;
use rasterizer::ir::{Op, Value};

/// The sum of products, from the first component on.
pub fn dot_product(emit: &mut Emit, a: &[Value], b: &[Value]) -> Value {
    let mut sum = emit.op(Op::Mul, &[a[0], b[0]]);
    for (&a, &b) in a.iter().zip(b).skip(1) {
        let product = emit.op(Op::Mul, &[a, b]);
        sum = emit.op(Op::Add, &[sum, product]);
    }
    sum
}

fn norm(emit: &mut Emit, x: &[Value]) -> Value {
    if let [x] = x {
        return emit.op(Op::Abs, &[*x]);
    }
    norm_by(emit, x, Op::Norm)
}

/// The length of two to four numbers by [`Op::Norm`], or its inverse by [`Op::InverseNorm`].
fn norm_by(emit: &mut Emit, x: &[Value], op: Op) -> Value {
    match *x {
        [a, b, c] => emit.op(op, &[a, b, c]),
        [a, b, c, d] => {
            // Of four, three are taken together.
            let zero = emit.float(0.0);
            let three = emit.op(Op::Norm, &[a, b, c]);
            emit.op(op, &[three, d, zero])
        }
        _ => {
            let zero = emit.float(0.0);
            emit.op(op, &[x[0], x[1], zero])
        }
    }
}

/// `sqrt(dot(x, x))`, whose squares may leave the range of floats.
pub fn length(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    vec![norm(emit, &args.values[0])]
}

/// `length(a - b)`.
pub fn distance(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let difference = each(emit, args, |emit, at| emit.op(Op::Sub, &[at(0), at(1)]));
    vec![norm(emit, &difference)]
}

/// The sum of products.
pub fn dot(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    vec![dot_product(emit, &args.values[0], &args.values[1])]
}

/// `(a1 b2 - b1 a2, a2 b0 - b2 a0, a0 b1 - b0 a1)`.
pub fn cross(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let (a, b) = (&args.values[0], &args.values[1]);
    let component = |(i, j): (usize, usize)| {
        let left = emit.op(Op::Mul, &[a[i], b[j]]);
        let right = emit.op(Op::Mul, &[b[i], a[j]]);
        emit.op(Op::Sub, &[left, right])
    };
    [(1, 2), (2, 0), (0, 1)].into_iter().map(component).collect()
}

/// `x / length(x)`, as a product with the inverse length.
pub fn normalize(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    if args.len() == 1 {
        return per_component(emit, args, Op::Sign);
    }
    let inverse = norm_by(emit, &args.values[0], Op::InverseNorm);
    each(emit, args, |emit, at| emit.op(Op::Mul, &[at(0), inverse]))
}

/// `N` where `dot(Nref, I) < 0`, else `-N`.
pub fn faceforward(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let cosine = dot_product(emit, &args.values[2], &args.values[1]);
    let zero = emit.float(0.0);
    let front = emit.op(Op::Less, &[cosine, zero]);
    each(emit, args, |emit, at| {
        let minus = emit.op(Op::Neg, &[at(0)]);
        emit.op(Op::SelectF, &[front, at(0), minus])
    })
}

/// `I - 2 · dot(N, I) · N`.
pub fn reflect(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let cosine = dot_product(emit, &args.values[1], &args.values[0]);
    let two = emit.float(2.0);
    let double = emit.op(Op::Mul, &[two, cosine]);
    each(emit, args, |emit, at| {
        let along = emit.op(Op::Mul, &[double, at(1)]);
        emit.op(Op::Sub, &[at(0), along])
    })
}

/// `eta · I - (eta · dot(N, I) + sqrt(k)) · N` of `k = 1 - eta² · (1 - dot(N, I)²)`; 0 where `k < 0`.
pub fn refract(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let (zero, one, eta) = (emit.float(0.0), emit.float(1.0), args.at(2, 0));
    let cosine = dot_product(emit, &args.values[1], &args.values[0]);
    let square = emit.op(Op::Mul, &[cosine, cosine]);
    let sine = emit.op(Op::Sub, &[one, square]);
    let eta_square = emit.op(Op::Mul, &[eta, eta]);
    let bent = emit.op(Op::Mul, &[eta_square, sine]);
    let k = emit.op(Op::Sub, &[one, bent]);
    let total = emit.op(Op::Less, &[k, zero]);
    let root = emit.op(Op::Sqrt, &[k]);
    let along = emit.op(Op::Mul, &[eta, cosine]);
    let factor = emit.op(Op::Add, &[along, root]);
    each(emit, args, |emit, at| {
        let straight = emit.op(Op::Mul, &[eta, at(0)]);
        let normal = emit.op(Op::Mul, &[factor, at(1)]);
        let bent = emit.op(Op::Sub, &[straight, normal]);
        emit.op(Op::SelectF, &[total, zero, bent])
    })
}
