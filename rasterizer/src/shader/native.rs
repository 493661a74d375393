//! Machine code for the straight runs of a register program.
//!
//! A run is a sequence of instructions that compute in all lanes, or store under the mask, into which nothing jumps. It
//! becomes one [`Block`]: values between its instructions stay in vector registers, and registers that nothing reads
//! afterwards are not stored. What has no machine code (transcendental functions, lookups, control flow) runs in the
//! interpreter, which defines what every instruction computes.

use super::compute::{Compute, OPERANDS, OperandStorage, Tree};
use super::inst::{Inst, Reg, Role, jump_targets};
use super::program::Program;
use crate::ir::Op;
use std::sync::OnceLock;
use texunit::lanes::code::{Binary, Block, Code, Compare, Rounding, Step, Target, Unary, Value};
use texunit::lanes::{Isa, U32s};

/// Runs shorter than this stay with the interpreter.
const MIN_INSTRUCTIONS: usize = 2;

/// Longer runs are split.
const MAX_INSTRUCTIONS: usize = 1024;

/// Programs of which more is to be known, instructions times words of registers, stay with the interpreter.
const MAX_LIVENESS: usize = 1 << 20;

/// The machine code of a program.
#[derive(Debug)]
pub(super) struct NativeCode {
    code: Code,
    runs: Vec<Run>,
    /// By instruction: the run that begins there.
    by_start: Vec<Option<u32>>,
}

/// Instructions that have machine code: from `start` to before `end`.
#[derive(Clone, Copy, Debug)]
struct Run {
    start: usize,
    end: usize,
}

/// The machine code of a program by instruction set, made when it is first needed.
#[derive(Debug, Default)]
pub(super) struct NativeCodes {
    by_target: [OnceLock<Option<NativeCode>>; Target::COUNT],
}

impl NativeCodes {
    /// The code for an instruction set; `None` where there is none.
    pub fn get(&self, isa: Isa, program: &Program) -> Option<&NativeCode> {
        let target = Target::of(isa)? as usize;
        self.by_target[target].get_or_init(|| NativeCode::of(isa, program)).as_ref()
    }
}

impl NativeCode {
    fn of(isa: Isa, program: &Program) -> Option<Self> {
        let code = &program.code;
        let splats = program.layout.splats.len() as u32;
        let live = Liveness::of(program)?;
        let is_target = jump_targets(code);
        let (mut runs, mut blocks) = (Vec::new(), Vec::new());
        let mut start = 0;
        while start < code.len() {
            let mut block = Block::new(splats);
            let mut end = start;
            let longest = code.len().min(start + MAX_INSTRUCTIONS);
            while end < longest && (end == start || !is_target[end]) {
                if translate(&mut block, &code[end]).is_none() {
                    break;
                }
                end += 1;
            }
            if end - start >= MIN_INSTRUCTIONS {
                block.retain_live(|register| live.is_live(end, register));
                runs.push(Run { start, end });
                blocks.push(block);
            }
            start = end.max(start + 1);
        }
        if runs.is_empty() {
            return None;
        }
        let mut by_start = vec![None; code.len() + 1];
        for (number, run) in runs.iter().enumerate() {
            by_start[run.start] = Some(number as u32);
        }
        Some(Self { code: Code::compile(isa, &blocks)?, runs, by_start })
    }

    /// Runs what begins at an instruction; gives the instruction after it, `None` if there is no code.
    #[inline(always)]
    pub fn run(
        &self,
        at: usize,
        registers: &mut [U32s],
        splats: &[f32],
        mask: &U32s,
    ) -> Option<usize> {
        let number = (*self.by_start.get(at)?)? as usize;
        self.code.run(number, registers, splats, mask);
        Some(self.runs[number].end)
    }
}

/// Appends an instruction; `None`, and nothing appended that anything reads, if it has no machine code.
fn translate(block: &mut Block, inst: &Inst) -> Option<()> {
    match inst {
        Inst::Compute { what, out, args } => {
            let value = compute(block, *what, args)?;
            block.write(out.0, value);
        }
        Inst::Move { out, from } => {
            let value = block.read(from.0);
            block.write(out.0, value);
        }
        Inst::Store { out, from } => {
            let [old, new] = [out, from].map(|register| block.read(register.0));
            let mask = block.value(Step::Mask);
            let value = block.value(Step::Select(mask, new, old));
            block.write(out.0, value);
        }
        Inst::Zero { .. }
        | Inst::LoadAt { .. }
        | Inst::StoreAt { .. }
        | Inst::UniformAt { .. }
        | Inst::Derivative { .. }
        | Inst::Tabulated { .. }
        | Inst::Sample(_)
        | Inst::Unless { .. }
        | Inst::Jump { .. }
        | Inst::Repeat { .. }
        | Inst::If { .. }
        | Inst::Else { .. }
        | Inst::Join { .. }
        | Inst::Open { .. }
        | Inst::Leave { .. }
        | Inst::LeaveIf { .. }
        | Inst::Discard
        | Inst::EmitVertex(_)
        | Inst::EndPrimitive
        | Inst::SkipEmpty { .. }
        | Inst::EndIteration { .. } => return None,
    }
    Some(())
}

fn compute(block: &mut Block, what: Compute, args: &[Reg; OPERANDS]) -> Option<Value> {
    match what.as_tree() {
        Ok(tree) => of_tree(block, &tree, args),
        Err(op) => {
            let [a, b, c] = [args[0], args[1], args[2]].map(|register| block.read(register.0));
            operation(block, op, [a, b, c])
        }
    }
}

fn of_tree(block: &mut Block, tree: &Tree, args: &[Reg; OPERANDS]) -> Option<Value> {
    match tree {
        Tree::Operand(at, OperandStorage::PerLane | OperandStorage::Uniform) => {
            Some(block.read(args[*at].0))
        }
        Tree::Node(op, trees) => {
            // Operands beyond the arity are not looked at.
            let mut values = [of_tree(block, trees.first()?, args)?; 3];
            for (value, tree) in values.iter_mut().zip(*trees).skip(1) {
                *value = of_tree(block, tree, args)?;
            }
            operation(block, *op, values)
        }
    }
}

const SIGN: u32 = 1 << 31;

fn constant(block: &mut Block, word: u32) -> Value {
    block.value(Step::Constant(word))
}

fn float(block: &mut Block, value: f32) -> Value {
    constant(block, value.to_bits())
}

fn unary(block: &mut Block, op: Unary, a: Value) -> Value {
    block.value(Step::Unary(op, a))
}

fn binary(block: &mut Block, op: Binary, a: Value, b: Value) -> Value {
    block.value(Step::Binary(op, a, b))
}

fn select(block: &mut Block, condition: Value, b: Value, c: Value) -> Value {
    block.value(Step::Select(condition, b, c))
}

fn not(block: &mut Block, a: Value) -> Value {
    let ones = constant(block, !0);
    binary(block, Binary::Xor, a, ones)
}

/// An integer as a float, 0 with the sign +.
fn round(block: &mut Block, rounding: Rounding, a: Value) -> Value {
    let whole = unary(block, Unary::Round(rounding), a);
    let zero = float(block, 0.0);
    binary(block, Binary::Add, whole, zero)
}

fn compare(block: &mut Block, compare: Compare, a: Value, b: Value) -> Value {
    binary(block, Binary::Compare(compare), a, b)
}

/// A shift by the low five bits of the count.
fn shift(block: &mut Block, op: Binary, a: Value, count: Value) -> Value {
    let low = constant(block, 31);
    let count = binary(block, Binary::And, count, low);
    binary(block, op, a, count)
}

/// `a - b` times the integer nearest to `a` times the inverse, see [`texunit::lanes::math::modulo`].
fn modulo_rest(block: &mut Block, a: Value, b: Value, inverse: Value) -> Value {
    let product = binary(block, Binary::Mul, a, inverse);
    let nearest = unary(block, Unary::Round(Rounding::Even), product);
    let whole = binary(block, Binary::Mul, b, nearest);
    binary(block, Binary::Sub, a, whole)
}

/// The steps of an operation, as its row in `ir/ops.rs` has it; `None` for those that have no machine code.
fn operation(block: &mut Block, op: Op, [a, b, c]: [Value; 3]) -> Option<Value> {
    Some(match op {
        Op::Add => binary(block, Binary::Add, a, b),
        Op::Sub => binary(block, Binary::Sub, a, b),
        Op::Mul => binary(block, Binary::Mul, a, b),
        Op::Div => binary(block, Binary::Div, a, b),
        Op::Neg => {
            let sign = constant(block, SIGN);
            binary(block, Binary::Xor, a, sign)
        }
        Op::Abs => {
            let magnitude = constant(block, !SIGN);
            binary(block, Binary::And, a, magnitude)
        }
        Op::Sign => {
            let [zero, one, minus] = [0.0, 1.0, -1.0].map(|value| float(block, value));
            let above = compare(block, Compare::Less, zero, a);
            let below = compare(block, Compare::Less, a, zero);
            let above = binary(block, Binary::And, above, one);
            let below = binary(block, Binary::And, below, minus);
            binary(block, Binary::Or, above, below)
        }
        Op::Min => number(block, Binary::Min, a, b),
        Op::Max => number(block, Binary::Max, a, b),
        Op::AtMost => binary(block, Binary::Min, a, b),
        Op::AtLeast => binary(block, Binary::Max, a, b),
        Op::Floor => round(block, Rounding::Down, a),
        Op::Ceil => round(block, Rounding::Up, a),
        Op::Trunc => round(block, Rounding::Zero, a),
        Op::RoundEven => unary(block, Unary::Round(Rounding::Even), a),
        Op::Fract => {
            let floor = round(block, Rounding::Down, a);
            binary(block, Binary::Sub, a, floor)
        }
        Op::ModNear => {
            let left = modulo_rest(block, a, b, c);
            let sign = constant(block, SIGN);
            let sign = binary(block, Binary::And, c, sign);
            let along = binary(block, Binary::Xor, left, sign);
            let zero = float(block, 0.0);
            let is_below = compare(block, Compare::Less, along, zero);
            let next = binary(block, Binary::Add, left, b);
            select(block, is_below, next, left)
        }
        Op::ModPositive => {
            let left = modulo_rest(block, a, b, c);
            let next = binary(block, Binary::Add, left, b);
            binary(block, Binary::UintMin, left, next)
        }
        Op::Sqrt => unary(block, Unary::Sqrt, a),
        Op::InverseSqrt => {
            let root = unary(block, Unary::Sqrt, a);
            let one = float(block, 1.0);
            binary(block, Binary::Div, one, root)
        }
        Op::Less => compare(block, Compare::Less, a, b),
        Op::LessEqual => compare(block, Compare::LessEqual, a, b),
        Op::Equal => compare(block, Compare::Equal, a, b),
        Op::NotEqual => compare(block, Compare::NotEqual, a, b),
        Op::IAdd | Op::UAdd => binary(block, Binary::IntAdd, a, b),
        Op::ISub | Op::USub => binary(block, Binary::IntSub, a, b),
        Op::IMul | Op::UMul => binary(block, Binary::IntMul, a, b),
        Op::INeg => {
            let zero = constant(block, 0);
            binary(block, Binary::IntSub, zero, a)
        }
        Op::IAbs => {
            let zero = constant(block, 0);
            let opposite = binary(block, Binary::IntSub, zero, a);
            binary(block, Binary::IntMax, a, opposite)
        }
        Op::ISign => {
            // Truth is -1.
            let zero = constant(block, 0);
            let below = binary(block, Binary::IntGreater, zero, a);
            let above = binary(block, Binary::IntGreater, a, zero);
            binary(block, Binary::IntSub, below, above)
        }
        Op::IMin => binary(block, Binary::IntMin, a, b),
        Op::IMax => binary(block, Binary::IntMax, a, b),
        Op::ILess => binary(block, Binary::IntGreater, b, a),
        Op::ILessEqual => {
            let greater = binary(block, Binary::IntGreater, a, b);
            not(block, greater)
        }
        Op::IEqual => binary(block, Binary::IntEqual, a, b),
        Op::INotEqual => {
            let equal = binary(block, Binary::IntEqual, a, b);
            not(block, equal)
        }
        Op::IShiftRight => shift(block, Binary::ShiftRightSigned, a, b),
        Op::UMin => binary(block, Binary::UintMin, a, b),
        Op::UMax => binary(block, Binary::UintMax, a, b),
        Op::ULess => {
            let least = binary(block, Binary::UintMin, b, a);
            let not_above = binary(block, Binary::IntEqual, least, b);
            not(block, not_above)
        }
        Op::ULessEqual => {
            let least = binary(block, Binary::UintMin, a, b);
            binary(block, Binary::IntEqual, least, a)
        }
        Op::FloatBits | Op::BitsFloat | Op::IntToUint | Op::UintToInt => a,
        Op::BitAnd | Op::And => binary(block, Binary::And, a, b),
        Op::BitOr | Op::Or => binary(block, Binary::Or, a, b),
        Op::BitXor | Op::Xor => binary(block, Binary::Xor, a, b),
        Op::BitNot | Op::Not => not(block, a),
        Op::ShiftLeft => shift(block, Binary::ShiftLeft, a, b),
        Op::UShiftRight => shift(block, Binary::ShiftRight, a, b),
        Op::SelectF | Op::SelectI | Op::SelectU | Op::SelectB => select(block, a, b, c),
        Op::FloatToInt => {
            let [low, high] = [-2_147_483_648.0, 2_147_483_520.0].map(|value| float(block, value));
            let a = binary(block, Binary::Max, a, low);
            let a = binary(block, Binary::Min, a, high);
            unary(block, Unary::FloatToInt, a)
        }
        Op::FloatToUint => {
            let [low, high] = [0.0, 4_294_967_040.0].map(|value| float(block, value));
            let a = binary(block, Binary::Max, a, low);
            let a = binary(block, Binary::Min, a, high);
            // Through two halves of 31 bits.
            let half = float(block, 2_147_483_648.0);
            let is_high = compare(block, Compare::LessEqual, half, a);
            let above = binary(block, Binary::Sub, a, half);
            let inside = select(block, is_high, above, a);
            let bits = unary(block, Unary::FloatToInt, inside);
            let sign = constant(block, SIGN);
            let high = binary(block, Binary::And, is_high, sign);
            binary(block, Binary::Or, bits, high)
        }
        Op::IntToFloat => unary(block, Unary::IntToFloat, a),
        Op::UintToFloat => {
            // Both halves and the product are exact, so that the sum rounds once.
            let (low, by) = (constant(block, 0xffff), constant(block, 16));
            let low = binary(block, Binary::And, a, low);
            let high = binary(block, Binary::ShiftRight, a, by);
            let [low, high] = [low, high].map(|half| unary(block, Unary::IntToFloat, half));
            let scale = float(block, 65_536.0);
            let high = binary(block, Binary::Mul, high, scale);
            binary(block, Binary::Add, high, low)
        }
        Op::BoolToFloat => {
            let one = float(block, 1.0);
            binary(block, Binary::And, a, one)
        }
        Op::BoolToInt | Op::BoolToUint => {
            let one = constant(block, 1);
            binary(block, Binary::And, a, one)
        }
        // They have rare operands, or are functions of many steps.
        Op::Mod
        | Op::Norm
        | Op::InverseNorm
        | Op::Sin
        | Op::Cos
        | Op::Tan
        | Op::Asin
        | Op::Acos
        | Op::Atan
        | Op::Atan2
        | Op::Sinh
        | Op::Cosh
        | Op::Tanh
        | Op::Asinh
        | Op::Acosh
        | Op::Atanh
        | Op::Exp
        | Op::Exp2
        | Op::Log
        | Op::Log2
        | Op::Pow
        | Op::IDiv
        | Op::IRem
        | Op::UDiv
        | Op::URem => return None,
    })
}

/// The smaller or larger of two numbers; the other if one is NaN.
fn number(block: &mut Block, op: Binary, a: Value, b: Value) -> Value {
    let of_both = binary(block, op, a, b);
    let is_nan = compare(block, Compare::Unordered, b, b);
    select(block, is_nan, a, of_both)
}

/// Which registers are read after an instruction, before they are written in all lanes.
struct Liveness {
    /// By instruction, and for the end of the code: a bit per register.
    before: Vec<Vec<u64>>,
}

impl Liveness {
    /// `None` where the program is too large.
    fn of(program: &Program) -> Option<Self> {
        let words = (program.layout.registers as usize).div_ceil(64);
        if program.code.len().saturating_mul(words) > MAX_LIVENESS {
            return None;
        }
        let mut code = program.code.clone();
        let mut before = vec![vec![0u64; words]; code.len() + 1];
        for &output in &program.layout.outputs {
            insert(&mut before[code.len()], output);
        }
        // Code whose only jumps go forward is done after one pass.
        loop {
            let mut has_changed = false;
            for at in (0..code.len()).rev() {
                let mut live = before[at + 1].clone();
                if let Some(target) = code[at].target() {
                    let from = &before[target.0 as usize];
                    live.iter_mut().zip(from).for_each(|(live, from)| *live |= from);
                }
                transfer(&mut code[at], &mut live);
                if live != before[at] {
                    before[at] = live;
                    has_changed = true;
                }
            }
            if !has_changed {
                return Some(Self { before });
            }
        }
    }

    fn is_live(&self, before: usize, register: u32) -> bool {
        self.before[before][register as usize / 64] >> (register % 64) & 1 == 1
    }
}

fn insert(live: &mut [u64], register: u32) {
    live[register as usize / 64] |= 1 << (register % 64);
}

fn remove(live: &mut [u64], register: u32) {
    live[register as usize / 64] &= !(1 << (register % 64));
}

/// From what is live after an instruction to what is live before it.
fn transfer(inst: &mut Inst, live: &mut [u64]) {
    match inst {
        Inst::Zero { out, len } => {
            for register in out.0..out.0 + *len {
                remove(live, register);
            }
        }
        // They write some lanes only.
        Inst::Store { from, .. } => insert(live, from.0),
        Inst::StoreAt { base, len, index, from } => {
            // Registers of an array stay live where they are.
            (base.0..base.0 + *len).chain([index.0, from.0]).for_each(|reg| insert(live, reg));
        }
        Inst::LoadAt { out, base, len, index } => {
            remove(live, out.0);
            (base.0..base.0 + *len).chain([index.0]).for_each(|reg| insert(live, reg));
        }
        inst => {
            inst.operands(&mut |register, role| {
                if role == Role::Write {
                    remove(live, register.0);
                }
            });
            inst.operands(&mut |register, role| {
                if role == Role::Read {
                    insert(live, register.0);
                }
            });
        }
    }
}

/// What the mask is while no lane executes.
pub(super) static NO_LANES: U32s = U32s::ZERO;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{Builder, Input, Interpolation, Output, Stage};

    /// `(s + t) * s * sin(t)`, in a chain.
    fn program() -> Program {
        let mut b = Builder::new(Stage::Fragment);
        b.module_mut().varyings = vec![Interpolation::Smooth; 2];
        let [s, t] = [0, 1].map(|slot| b.input(Input::Varying(slot)));
        let mut last = s;
        for _ in 0..10 {
            let sum = b.op(Op::Add, &[last, t]);
            let product = b.op(Op::Mul, &[sum, s]);
            let sine = b.op(Op::Sin, &[product]);
            last = b.op(Op::Mul, &[sine, last]);
        }
        let red = b.output(Output::Color { target: 0, component: 0 });
        b.store(red, last);
        Program::new(&b.finish(), |_| true)
    }

    #[test]
    fn what_lies_between_transcendental_functions_has_machine_code() {
        for isa in Isa::executions() {
            let program = program();
            let native = program.native.get(isa, &program);
            if Target::of(isa).is_none() {
                assert!(native.is_none(), "{}", isa.name());
            }
            let Some(native) = native else { continue };
            let covered: usize = native.runs.iter().map(|run| run.end - run.start).sum();
            let is_sine = |inst: &&Inst| matches!(inst, Inst::Compute { what, .. } if *what == Op::Sin.into());
            let sines = program.code.iter().filter(is_sine).count();
            assert_eq!(sines, 10);
            assert!(
                covered + sines + 2 >= program.code.len(),
                "{covered} of {}",
                program.code.len()
            );
        }
    }

    #[test]
    fn registers_that_nothing_reads_are_dead() {
        let program = program();
        let live = Liveness::of(&program).expect("a small program");
        let end = program.code.len();
        let is_output = |register| program.layout.outputs.contains(&register);
        for register in program.layout.first_written..program.layout.registers {
            assert_eq!(live.is_live(end, register), is_output(register), "register {register}");
        }
    }
}
