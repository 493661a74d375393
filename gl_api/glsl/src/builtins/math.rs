//! What the built-in functions compute, in the order in which it is computed: that order is the
//! definition of their results.

use crate::emit::Emit;
use crate::types::Type;
use rasterizer::ir::{Axis, Op, Ty, Value};
use texunit::lanes::math::NAN;

/// The arguments of a call.
#[derive(Clone, Copy)]
pub struct Args<'a> {
    /// The scalars of each.
    pub values: &'a [Vec<Value>],
    /// The types of each.
    pub types: &'a [Type],
}

impl Args<'_> {
    /// Component `index` of argument `which`; a scalar goes with every component.
    fn at(&self, which: usize, index: usize) -> Value {
        let values = &self.values[which];
        values[index.min(values.len() - 1)]
    }

    /// The number of components that a result of the widest argument has.
    fn len(&self) -> usize {
        self.values.iter().map(Vec::len).max().unwrap_or(0)
    }
}

/// The smaller.
pub fn min(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    extreme(emit, args, Op::Min)
}

/// The larger.
pub fn max(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    extreme(emit, args, Op::Max)
}

/// A constant goes second, where the operation is a single step. Zero stays where it is: of zeros the second is
/// taken, whatever their signs.
fn extreme(emit: &mut Emit, args: Args<'_>, op: Op) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let [a, b] = [at(0), at(1)];
        let first = emit.known(a).filter(|_| emit.known(b).is_none()).map(f32::from_bits);
        match first {
            Some(0.0) => {
                let order = if op == Op::Min { [b, a] } else { [a, b] };
                let is_second = emit.op(Op::LessEqual, &order);
                emit.op(Op::SelectF, &[is_second, b, a])
            }
            Some(_) => emit.op(op, &[b, a]),
            None => emit.op(op, &[a, b]),
        }
    })
}

/// The operation on each component; a scalar goes with all components.
pub fn map(emit: &mut Emit, args: Args<'_>, op: Op) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let operands: Vec<Value> = (0..args.values.len()).map(at).collect();
        emit.op(op, &operands)
    })
}

/// `f` for each component; its second argument gives an argument's component.
fn each(
    emit: &mut Emit,
    args: Args<'_>,
    f: impl Fn(&mut Emit, &dyn Fn(usize) -> Value) -> Value,
) -> Vec<Value> {
    (0..args.len()).map(|index| f(emit, &|which| args.at(which, index))).collect()
}

/// The bits as a signed integer.
pub fn float_bits_to_int(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let bits = float_bits(emit, at(0));
        emit.op(Op::UintToInt, &[bits])
    })
}

/// The bits as an unsigned integer.
pub fn float_bits_to_uint(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| float_bits(emit, at(0)))
}

/// The bits as [`texunit::lanes::math::bits`] gives them.
fn float_bits(emit: &mut Emit, x: Value) -> Value {
    let bits = emit.op(Op::FloatBits, &[x]);
    let [signed, unsigned] = [NAN | 1 << 31, NAN].map(|bits| emit.uint(bits));
    let is_signed = emit.equal(bits, signed);
    emit.select(is_signed, unsigned, bits)
}

/// The float whose bits a signed integer has.
pub fn int_bits_to_float(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let bits = emit.op(Op::IntToUint, &[at(0)]);
        emit.op(Op::BitsFloat, &[bits])
    })
}

/// `x · π / 180`.
pub fn radians(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let factor = emit.float(std::f32::consts::PI / 180.0);
    each(emit, args, |emit, at| emit.op(Op::Mul, &[at(0), factor]))
}

/// `x · 180 / π`.
pub fn degrees(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let factor = emit.float(180.0 / std::f32::consts::PI);
    each(emit, args, |emit, at| emit.op(Op::Mul, &[at(0), factor]))
}

/// `x - y · floor(x / y)`. `y` is mostly a constant: its inverse is one too.
pub fn modulo(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let one = emit.float(1.0);
    each(emit, args, |emit, at| {
        let inverse = emit.op(Op::Div, &[one, at(1)]);
        let is_finite = emit.known(inverse).is_some_and(|bits| f32::from_bits(bits).is_finite());
        emit.op(if is_finite { Op::ModNear } else { Op::Mod }, &[at(0), at(1), inverse])
    })
}

fn clamp_with(emit: &mut Emit, args: Args<'_>, min: Op, max: Op) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let above = emit.op(max, &[at(0), at(1)]);
        emit.op(min, &[above, at(2)])
    })
}

/// `min(max(x, low), high)`.
pub fn clamp(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    clamp_with(emit, args, Op::Min, Op::Max)
}

/// `min(max(x, low), high)`.
pub fn clamp_int(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    clamp_with(emit, args, Op::IMin, Op::IMax)
}

/// `min(max(x, low), high)`.
pub fn clamp_uint(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    clamp_with(emit, args, Op::UMin, Op::UMax)
}

/// `x · (1 - a) + y · a`.
pub fn mix(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let one = emit.float(1.0);
    each(emit, args, |emit, at| {
        let rest = emit.op(Op::Sub, &[one, at(2)]);
        let left = emit.op(Op::Mul, &[at(0), rest]);
        let right = emit.op(Op::Mul, &[at(1), at(2)]);
        emit.op(Op::Add, &[left, right])
    })
}

/// `y` where `a`, else `x`.
pub fn mix_select(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::SelectF, &[at(2), at(1), at(0)]))
}

/// 0 where `x < edge`, else 1.
pub fn step(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let (zero, one) = (emit.float(0.0), emit.float(1.0));
    each(emit, args, |emit, at| {
        let below = emit.op(Op::Less, &[at(1), at(0)]);
        emit.op(Op::SelectF, &[below, zero, one])
    })
}

/// `t² · (3 - 2t)` of `t = clamp((x - edge0) / (edge1 - edge0), 0, 1)`.
pub fn smoothstep(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let [zero, one, two, three] = [0.0, 1.0, 2.0, 3.0].map(|x| emit.float(x));
    each(emit, args, |emit, at| {
        let above = emit.op(Op::Sub, &[at(2), at(0)]);
        let width = emit.op(Op::Sub, &[at(1), at(0)]);
        let t = emit.op(Op::Div, &[above, width]);
        let t = emit.op(Op::Max, &[t, zero]);
        let t = emit.op(Op::Min, &[t, one]);
        let square = emit.op(Op::Mul, &[t, t]);
        let double = emit.op(Op::Mul, &[two, t]);
        let rest = emit.op(Op::Sub, &[three, double]);
        emit.op(Op::Mul, &[square, rest])
    })
}

/// Whether `x` differs from itself.
pub fn isnan(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::NotEqual, &[at(0), at(0)]))
}

/// Whether `|x|` is infinite.
pub fn isinf(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let infinity = emit.float(f32::INFINITY);
    each(emit, args, |emit, at| {
        let size = emit.op(Op::Abs, &[at(0)]);
        emit.op(Op::Equal, &[size, infinity])
    })
}

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
    match x {
        [x] => emit.op(Op::Abs, &[*x]),
        _ => {
            let square = dot_product(emit, x, x);
            emit.op(Op::Sqrt, &[square])
        }
    }
}

/// `sqrt(dot(x, x))`.
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

/// `x / length(x)`, as a product with the inverse square root.
pub fn normalize(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    if args.len() == 1 {
        return map(emit, args, Op::Sign);
    }
    let square = dot_product(emit, &args.values[0], &args.values[0]);
    let inverse = emit.op(Op::InverseSqrt, &[square]);
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

/// Column vector times row vector.
pub fn outer_product(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let mut all = Vec::new();
    for &row in &args.values[1] {
        for &column in &args.values[0] {
            all.push(emit.op(Op::Mul, &[column, row]));
        }
    }
    all
}

/// Rows as columns.
pub fn transpose(_: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let Type::Matrix(columns, rows) = args.types[0] else { return args.values[0].clone() };
    let (columns, rows) = (usize::from(columns), usize::from(rows));
    let at = |index: usize| args.values[0][(index % columns) * rows + index / columns];
    (0..columns * rows).map(at).collect()
}

/// `a > b`.
pub fn greater(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::Less, &[at(1), at(0)]))
}

/// `a > b`.
pub fn greater_int(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::ILess, &[at(1), at(0)]))
}

/// `a > b`.
pub fn greater_uint(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::ULess, &[at(1), at(0)]))
}

/// `a >= b`.
pub fn greater_equal(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::LessEqual, &[at(1), at(0)]))
}

/// `a >= b`.
pub fn greater_equal_int(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::ILessEqual, &[at(1), at(0)]))
}

/// `a >= b`.
pub fn greater_equal_uint(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::ULessEqual, &[at(1), at(0)]))
}

/// `a == b`, for each component.
pub fn equal(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.equal(at(0), at(1)))
}

/// `a != b`, for each component.
pub fn not_equal(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let equal = emit.equal(at(0), at(1));
        emit.op(Op::Not, &[equal])
    })
}

/// Whether a component is true.
pub fn any(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let none = emit.constant(0, Ty::Bool);
    vec![args.values[0].iter().fold(none, |found, &x| emit.op(Op::Or, &[found, x]))]
}

/// Whether all components are true.
pub fn all(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let first = args.values[0][0];
    vec![args.values[0][1..].iter().fold(first, |found, &x| emit.op(Op::And, &[found, x]))]
}

/// `|dFdx(p)| + |dFdy(p)|`.
pub fn fwidth(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let [x, y] = [Axis::X, Axis::Y].map(|axis| {
            let slope = emit.derivative(axis, at(0));
            emit.op(Op::Abs, &[slope])
        });
        emit.op(Op::Add, &[x, y])
    })
}
