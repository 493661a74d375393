//! GLSL: operations on integers, comparisons, functions that select (GLSL 1.30, sections 5.9, 8.3, 8.4 and
//! 8.6).

use crate::mutation::{Mutation, Variant};

/// An operation on two integers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the operators' names")]
pub enum IntegerOp {
    Add,
    Subtract,
    Multiply,
    Divide,
    Remainder,
    Complement,
    ShiftLeft,
    ShiftRight,
    And,
    Or,
    Xor,
    Compare,
    AbsSign,
    MinMax,
}

impl IntegerOp {
    /// Those of arithmetic.
    pub const ARITHMETIC: &[Self] = &[
        Self::Add,
        Self::Subtract,
        Self::Multiply,
        Self::Divide,
        Self::Remainder,
        Self::Complement,
    ];

    /// Those of bits.
    pub const BITS: &[Self] = &[Self::ShiftLeft, Self::ShiftRight, Self::And, Self::Or, Self::Xor];

    /// Those of order.
    pub const ORDER: &[Self] = &[Self::Compare, Self::AbsSign, Self::MinMax];

    /// The expressions of `int` and of `uint` in `a` and `b`.
    pub fn glsl(self) -> [&'static str; 2] {
        const COMPARED: &str = "uint(a < b) | uint(a <= b) << 1 | uint(a > b) << 2 | uint(a >= b) << 3 \
            | uint(a == b) << 4 | uint(a != b) << 5";
        match self {
            Self::Add => ["a + b"; 2],
            Self::Subtract => ["a - b"; 2],
            Self::Multiply => ["a * b"; 2],
            Self::Divide => ["a / b"; 2],
            Self::Remainder => ["a % b"; 2],
            Self::Complement => ["~a"; 2],
            Self::ShiftLeft => ["a << b"; 2],
            Self::ShiftRight => ["a >> b"; 2],
            Self::And => ["a & b"; 2],
            Self::Or => ["a | b"; 2],
            Self::Xor => ["a ^ b"; 2],
            Self::Compare => [COMPARED; 2],
            Self::AbsSign => ["abs(a) + sign(b)", "a"],
            Self::MinMax => [
                "min(a, b) ^ max(a, 7) ^ clamp(a, -5, 5)",
                "min(a, b) ^ max(a, 7u) ^ clamp(a, 3u, 9u)",
            ],
        }
    }

    /// Whether the specification defines the result: no division by 0 or overflow of one, no remainder of negative
    /// numbers, shifts below 32.
    pub fn is_defined(self, a: u32, b: u32) -> bool {
        match self {
            Self::Divide => b != 0 && !(a == 0x8000_0000 && b == u32::MAX),
            Self::Remainder => b != 0 && a < 0x8000_0000 && b < 0x8000_0000,
            Self::ShiftLeft | Self::ShiftRight => b < 32,
            Self::AbsSign => a != 0x8000_0000,
            Self::Add
            | Self::Subtract
            | Self::Multiply
            | Self::Complement
            | Self::And
            | Self::Or
            | Self::Xor
            | Self::Compare
            | Self::MinMax => true,
        }
    }

    /// The words of the results of `int` and of `uint`.
    pub fn apply(self, a: u32, b: u32, variant: Variant) -> [u32; 2] {
        let (s, t) = (a as i32, b as i32);
        let both = |word: u32| [word; 2];
        match self {
            Self::Add if variant.has(Mutation::IntegersSaturate) => {
                [s.saturating_add(t) as u32, a.saturating_add(b)]
            }
            Self::Add => both(a.wrapping_add(b)),
            Self::Subtract => both(a.wrapping_sub(b)),
            Self::Multiply => both(a.wrapping_mul(b)),
            Self::Divide if variant.has(Mutation::QuotientFloored) => {
                [s.wrapping_div_euclid(t) as u32, a / b]
            }
            Self::Divide => [(s / t) as u32, a / b],
            Self::Remainder => [(s % t) as u32, a % b],
            Self::Complement => both(!a),
            Self::ShiftLeft => both(a << b),
            Self::ShiftRight if variant.has(Mutation::ShiftWithoutSign) => both(a >> b),
            Self::ShiftRight => [(s >> b) as u32, a >> b],
            Self::And => both(a & b),
            Self::Or => both(a | b),
            Self::Xor => both(a ^ b),
            Self::Compare => {
                let signs = variant.has(Mutation::ComparedWithoutSign);
                [if signs { compared(a, b) } else { compared(s, t) }, compared(a, b)]
            }
            Self::AbsSign => [s.abs().wrapping_add(t.signum()) as u32, a],
            Self::MinMax => {
                [(s.min(t) ^ s.max(7) ^ s.clamp(-5, 5)) as u32, a.min(b) ^ a.max(7) ^ a.clamp(3, 9)]
            }
        }
    }
}

fn compared<T: Ord>(a: T, b: T) -> u32 {
    let bits = [a < b, a <= b, a > b, a >= b, a == b, a != b];
    (0..).zip(bits).map(|(i, bit)| u32::from(bit) << i).sum()
}

fn bits(of: [bool; 4]) -> u32 {
    (0..).zip(of).map(|(i, bit)| u32::from(bit) << i).sum()
}

/// The words of all comparisons of two vectors.
pub fn relational(a: [f64; 4], b: [f64; 4], variant: Variant) -> [u32; 4] {
    let by = |holds: fn(&f64, &f64) -> bool| [0, 1, 2, 3].map(|i: usize| holds(&a[i], &b[i]));
    let less = by(|a, b| a < b);
    let all =
        if variant.has(Mutation::AllIsAny) { less.contains(&true) } else { less == [true; 4] };
    let equal = by(|a, b| a == b);
    // What is not less may be unordered.
    let not_less =
        if variant.has(Mutation::NanIsLess) { by(|a, b| a >= b) } else { less.map(|l| !l) };
    [
        bits(less)
            | bits(by(|a, b| a <= b)) << 4
            | bits(by(|a, b| a > b)) << 8
            | bits(by(|a, b| a >= b)) << 12,
        bits(equal) | bits(equal.map(|e| !e)) << 4 | bits(not_less) << 8,
        u32::from(less.contains(&true))
            | u32::from(all) << 1
            | u32::from(equal == [true; 4]) << 2
            | u32::from(equal != [true; 4]) << 3,
        bits(a.map(f64::is_nan)) | bits(a.map(f64::is_infinite)) << 4,
    ]
}

/// A function whose result is one of its arguments, or an exact difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the functions' names")]
pub enum Selecting {
    AbsSign,
    MinMax,
    Clamp,
    Step,
    Modf,
    FaceForward,
}

/// All of them.
pub const SELECTING: &[Selecting] = &[
    Selecting::AbsSign,
    Selecting::MinMax,
    Selecting::Clamp,
    Selecting::Step,
    Selecting::Modf,
    Selecting::FaceForward,
];

impl Selecting {
    /// Statements that return a vector of `a` and `b`.
    pub fn glsl(self) -> &'static str {
        match self {
            Self::AbsSign => "return vec4(abs(a.xy), sign(a.zw));",
            Self::MinMax => "return vec4(min(a.xy, b.xy), max(a.zw, b.zw));",
            Self::Clamp => "return clamp(a, -abs(b), abs(b));",
            Self::Step => "return step(a, b);",
            Self::Modf => "vec2 whole; vec2 rest = modf(a.xy, whole); return vec4(rest, whole);",
            Self::FaceForward => "return faceforward(a, b, vec4(1.0, 0.0, 0.0, 0.0));",
        }
    }

    /// The result.
    pub fn apply(self, a: [f64; 4], b: [f64; 4], variant: Variant) -> [f64; 4] {
        let sign = |x: f64| {
            if x > 0.0 {
                1.0
            } else if x < 0.0 {
                -1.0
            } else {
                0.0
            }
        };
        match self {
            Self::AbsSign => [a[0].abs(), a[1].abs(), sign(a[2]), sign(a[3])],
            Self::MinMax => [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])],
            Self::Clamp => [0, 1, 2, 3].map(|i: usize| a[i].max(-b[i].abs()).min(b[i].abs())),
            Self::Step => [0, 1, 2, 3].map(|i: usize| {
                let below =
                    if variant.has(Mutation::StepStrict) { b[i] <= a[i] } else { b[i] < a[i] };
                if below { 0.0 } else { 1.0 }
            }),
            Self::Modf => [a[0].fract(), a[1].fract(), a[0].trunc(), a[1].trunc()],
            Self::FaceForward => {
                let reversed = variant.has(Mutation::ReflectionReversed);
                a.map(|c| if (b[0] < 0.0) != reversed { c } else { -c })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn integers_by_hand() {
        let minus = |n: i32| (-n) as u32;
        assert_eq!(IntegerOp::Divide.apply(minus(7), 2, TRUE)[0], minus(3));
        assert_eq!(IntegerOp::ShiftRight.apply(minus(8), 1, TRUE), [minus(4), 0x7fff_fffc]);
        assert_eq!(IntegerOp::Compare.apply(minus(1), 1, TRUE), [0b10_0011, 0b10_1100]);
        assert_eq!(IntegerOp::AbsSign.apply(minus(5), minus(3), TRUE)[0], 4);
    }

    #[test]
    fn comparisons_by_hand() {
        let words = relational([1.0, 2.0, f64::NAN, 0.0], [2.0, 2.0, 1.0, -1.0], TRUE);
        assert_eq!(words, [0xa831, 0xed2, 9, 4]);
    }
}
