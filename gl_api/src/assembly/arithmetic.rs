//! Code of each instruction (ARB_vertex_program, section 2.14.5; ARB_fragment_program,
//! section 3.11.5).

use super::program::Opcode;
use rasterizer::ir::{Builder, Op, Value};

/// The largest exponent of `LIT`: a little less than 128.
const LIT_EXPONENT: f32 = 127.996_09;

/// A builder of IR values with the operations of instructions.
pub(crate) struct Math {
    pub b: Builder,
}

impl Math {
    fn each(&mut self, op: Op, left: [Value; 4], right: [Value; 4]) -> [Value; 4] {
        std::array::from_fn(|at| self.b.op(op, &[left[at], right[at]]))
    }

    fn map(&mut self, op: Op, of: [Value; 4]) -> [Value; 4] {
        of.map(|value| self.b.op(op, &[value]))
    }

    /// The sum of the products of the first `count` components, from the left.
    fn dot(&mut self, count: usize, left: [Value; 4], right: [Value; 4]) -> Value {
        let products = self.each(Op::Mul, left, right);
        let rest = products[1..count].iter();
        rest.fold(products[0], |sum, product| self.b.op(Op::Add, &[sum, *product]))
    }

    /// `a * b + c`.
    fn multiply_add(&mut self, a: [Value; 4], b: [Value; 4], c: [Value; 4]) -> [Value; 4] {
        let products = self.each(Op::Mul, a, b);
        self.each(Op::Add, products, c)
    }

    /// 1 where a comparison holds, else 0.
    fn compare(&mut self, op: Op, left: [Value; 4], right: [Value; 4]) -> [Value; 4] {
        let holds = self.each(op, left, right);
        self.map(Op::BoolToFloat, holds)
    }

    /// The result of an instruction; operands that it lacks are ignored. Scalars are first components.
    pub fn compute(&mut self, opcode: Opcode, [a, b, c]: [[Value; 4]; 3]) -> [Value; 4] {
        let [x, other] = [a[0], b[0]];
        match opcode {
            Opcode::Abs => self.map(Op::Abs, a),
            Opcode::Add => self.each(Op::Add, a, b),
            Opcode::Arl => {
                let floor = self.b.op(Op::Floor, &[x]);
                [self.b.op(Op::FloatToInt, &[floor]); 4]
            }
            Opcode::Cmp => {
                let zero = self.b.float(0.0);
                std::array::from_fn(|at| {
                    let negative = self.b.op(Op::Less, &[a[at], zero]);
                    self.b.op(Op::SelectF, &[negative, b[at], c[at]])
                })
            }
            Opcode::Cos => [self.b.op(Op::Cos, &[x]); 4],
            Opcode::Dp3 => [self.dot(3, a, b); 4],
            Opcode::Dp4 => [self.dot(4, a, b); 4],
            Opcode::Dph => {
                let dot = self.dot(3, a, b);
                [self.b.op(Op::Add, &[dot, b[3]]); 4]
            }
            Opcode::Dst => {
                let one = self.b.float(1.0);
                [one, self.b.op(Op::Mul, &[a[1], b[1]]), a[2], b[3]]
            }
            Opcode::Ex2 => [self.b.op(Op::Exp2, &[x]); 4],
            Opcode::Exp => self.exp(x),
            Opcode::Flr => self.map(Op::Floor, a),
            Opcode::Frc => self.map(Op::Fract, a),
            Opcode::Lg2 => [self.b.op(Op::Log2, &[x]); 4],
            Opcode::Lit => self.lit(a),
            Opcode::Log => self.log(x),
            Opcode::Lrp => {
                let one = [self.b.float(1.0); 4];
                let rest = self.each(Op::Sub, one, a);
                let from = self.each(Op::Mul, rest, c);
                self.multiply_add(a, b, from)
            }
            Opcode::Mad => self.multiply_add(a, b, c),
            Opcode::Max => self.each(Op::Max, a, b),
            Opcode::Min => self.each(Op::Min, a, b),
            Opcode::Mul => self.each(Op::Mul, a, b),
            Opcode::Pow => [self.b.op(Op::Pow, &[x, other]); 4],
            Opcode::Rcp => {
                let one = self.b.float(1.0);
                [self.b.op(Op::Div, &[one, x]); 4]
            }
            Opcode::Rsq => {
                let magnitude = self.b.op(Op::Abs, &[x]);
                [self.b.op(Op::InverseSqrt, &[magnitude]); 4]
            }
            Opcode::Scs => {
                let [zero, one] = [0.0, 1.0].map(|value| self.b.float(value));
                [self.b.op(Op::Cos, &[x]), self.b.op(Op::Sin, &[x]), zero, one]
            }
            Opcode::Sge => self.compare(Op::LessEqual, b, a),
            Opcode::Sin => [self.b.op(Op::Sin, &[x]); 4],
            Opcode::Slt => self.compare(Op::Less, a, b),
            Opcode::Sub => self.each(Op::Sub, a, b),
            Opcode::Xpd => self.cross(a, b),
            // The swizzle is done; what has no result of its own leaves the operand.
            Opcode::Mov | Opcode::Swz | Opcode::Kil | Opcode::Tex | Opcode::Txb | Opcode::Txp => a,
        }
    }

    /// 2 to the whole part, the fraction, 2 to the whole number.
    fn exp(&mut self, x: Value) -> [Value; 4] {
        let whole = self.b.op(Op::Floor, &[x]);
        let power = self.b.op(Op::Exp2, &[whole]);
        let fraction = self.b.op(Op::Fract, &[x]);
        [power, fraction, self.b.op(Op::Exp2, &[x]), self.b.float(1.0)]
    }

    /// The exponent, the mantissa from 1 to 2, the logarithm; of 0, minus infinity and 1.
    fn log(&mut self, x: Value) -> [Value; 4] {
        let magnitude = self.b.op(Op::Abs, &[x]);
        let logarithm = self.b.op(Op::Log2, &[magnitude]);
        let exponent = self.b.op(Op::Floor, &[logarithm]);
        let power = self.b.op(Op::Exp2, &[exponent]);
        let mantissa = self.b.op(Op::Div, &[magnitude, power]);
        let [zero, one] = [0.0, 1.0].map(|value| self.b.float(value));
        let is_zero = self.b.op(Op::Equal, &[magnitude, zero]);
        let mantissa = self.b.op(Op::SelectF, &[is_zero, one, mantissa]);
        [exponent, mantissa, logarithm, one]
    }

    /// The ambient, diffuse and specular factors of a light; 0 to the power of 0 is 1.
    fn lit(&mut self, [x, y, _, w]: [Value; 4]) -> [Value; 4] {
        let [zero, one, most, least] =
            [0.0, 1.0, LIT_EXPONENT, -LIT_EXPONENT].map(|value| self.b.float(value));
        let diffuse = self.b.op(Op::Max, &[x, zero]);
        let base = self.b.op(Op::Max, &[y, zero]);
        let exponent = self.b.op(Op::Min, &[w, most]);
        let exponent = self.b.op(Op::Max, &[exponent, least]);
        let power = self.b.op(Op::Pow, &[base, exponent]);
        let flat = self.b.op(Op::Equal, &[exponent, zero]);
        let power = self.b.op(Op::SelectF, &[flat, one, power]);
        let faces = self.b.op(Op::Less, &[zero, x]);
        [one, diffuse, self.b.op(Op::SelectF, &[faces, power, zero]), one]
    }

    fn cross(&mut self, a: [Value; 4], b: [Value; 4]) -> [Value; 4] {
        let mut part = |i: usize, j: usize| {
            let left = self.b.op(Op::Mul, &[a[i], b[j]]);
            let right = self.b.op(Op::Mul, &[a[j], b[i]]);
            self.b.op(Op::Sub, &[left, right])
        };
        let [x, y, z] = [part(1, 2), part(2, 0), part(0, 1)];
        [x, y, z, self.b.float(1.0)]
    }
}
