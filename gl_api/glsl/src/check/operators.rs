//! Types of operands and results (GLSL 1.30 section 5.9).

use crate::ast::BinaryOp;
use crate::language::Version;
use crate::types::{BOOL, Scalar, Type, vec};

/// Whether a value of `from` converts to `to` implicitly (GLSL 1.30 section 4.1.10; 1.10 has no
/// implicit conversions).
pub fn converts(from: &Type, to: &Type, version: Version) -> bool {
    let (Type::Vector(from, n), Type::Vector(Scalar::Float, m)) = (from, to) else {
        return false;
    };
    // GLSL ES has none.
    let allowed = !version.is_es()
        && match from {
            Scalar::Int => version >= Version::V120,
            Scalar::Uint => true,
            Scalar::Float | Scalar::Bool => false,
        };
    allowed && n == m
}

/// The types that the operands are converted to, and the type of the result.
pub struct BinaryTypes {
    /// Of the left operand.
    pub left: Type,
    /// Of the right operand.
    pub right: Type,
    /// Of the result.
    pub result: Type,
}

/// The types of a binary operation; `None` if the operands do not go together.
pub fn binary(op: BinaryOp, left: &Type, right: &Type, version: Version) -> Option<BinaryTypes> {
    match op {
        BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul | BinaryOp::Div => {
            arithmetic(op, left, right, version)
        }
        BinaryOp::Rem | BinaryOp::BitAnd | BinaryOp::BitOr | BinaryOp::BitXor => {
            let (Type::Vector(a, n), Type::Vector(b, m)) = (left, right) else { return None };
            let integers = matches!(a, Scalar::Int | Scalar::Uint) && a == b;
            if !integers || !(n == m || *n == 1 || *m == 1) {
                return None;
            }
            let result = Type::Vector(*a, *n.max(m));
            Some(BinaryTypes { left: left.clone(), right: right.clone(), result })
        }
        BinaryOp::ShiftLeft | BinaryOp::ShiftRight => {
            let (Type::Vector(a, n), Type::Vector(b, m)) = (left, right) else { return None };
            let integer = |scalar: &Scalar| matches!(scalar, Scalar::Int | Scalar::Uint);
            if !integer(a) || !integer(b) || !(n == m || *m == 1) {
                return None;
            }
            Some(BinaryTypes { left: left.clone(), right: right.clone(), result: left.clone() })
        }
        BinaryOp::Less | BinaryOp::Greater | BinaryOp::LessEqual | BinaryOp::GreaterEqual => {
            let (Type::Vector(a, 1), Type::Vector(b, 1)) = (left, right) else { return None };
            let scalar = common(*a, *b, version).filter(|scalar| *scalar != Scalar::Bool)?;
            let ty = Type::Vector(scalar, 1);
            Some(BinaryTypes { left: ty.clone(), right: ty, result: BOOL })
        }
        BinaryOp::Equal | BinaryOp::NotEqual => {
            if left.has_sampler() || *left == Type::Void {
                return None;
            }
            if version < Version::V120 && left.has_array() {
                return None;
            }
            let ty = if left == right || converts(right, left, version) {
                left
            } else if converts(left, right, version) {
                right
            } else {
                return None;
            };
            Some(BinaryTypes { left: ty.clone(), right: ty.clone(), result: BOOL })
        }
        BinaryOp::And | BinaryOp::Or | BinaryOp::Xor => {
            let both = *left == BOOL && *right == BOOL;
            both.then_some(BinaryTypes { left: BOOL, right: BOOL, result: BOOL })
        }
    }
}

/// The scalar type that both operands convert to.
fn common(a: Scalar, b: Scalar, version: Version) -> Option<Scalar> {
    let float = Type::Vector(Scalar::Float, 1);
    if a == b {
        Some(a)
    } else if a == Scalar::Float && converts(&Type::Vector(b, 1), &float, version)
        || b == Scalar::Float && converts(&Type::Vector(a, 1), &float, version)
    {
        Some(Scalar::Float)
    } else {
        None
    }
}

fn arithmetic(op: BinaryOp, left: &Type, right: &Type, version: Version) -> Option<BinaryTypes> {
    let scalar = common(left.scalar()?, right.scalar()?, version)?;
    if scalar == Scalar::Bool {
        return None;
    }
    let (left, right) = (left.with_scalar(scalar), right.with_scalar(scalar));
    let result = if right.is_scalar() {
        left.clone()
    } else if left.is_scalar() {
        right.clone()
    } else if op == BinaryOp::Mul && (left.rows().is_some() || right.rows().is_some()) {
        product(&left, &right)?
    } else if left == right {
        left.clone()
    } else {
        return None;
    };
    Some(BinaryTypes { left, right, result })
}

/// The type of a product of a matrix with a matrix or a vector.
fn product(left: &Type, right: &Type) -> Option<Type> {
    if let (Type::Matrix(a, rows), Type::Matrix(columns, b)) = (left, right) {
        (a == b).then_some(Type::Matrix(*columns, *rows))
    } else if let (Type::Matrix(columns, rows), Type::Vector(_, n)) = (left, right) {
        (columns == n).then_some(vec(*rows))
    } else if let (Type::Vector(_, n), Type::Matrix(columns, rows)) = (left, right) {
        (rows == n).then_some(vec(*columns))
    } else {
        None
    }
}
