//! Machine code for the straight runs of a register program.
//!
//! A run is a sequence of instructions that compute in all lanes, or store under the mask, into which nothing jumps. It
//! becomes one [`Block`]: values between its instructions stay in vector registers, and registers that nothing reads
//! afterwards are not stored. What has no machine code (transcendental functions, lookups, control flow) runs in the
//! interpreter, which defines what every instruction computes.

mod liveness;
mod operation;

use super::compute::{Compute, OPERANDS, OperandStorage, Tree};
use super::inst::{Inst, Reg, jump_targets};
use super::program::Program;
use liveness::Liveness;
use operation::operation;
use std::sync::OnceLock;
use texunit::lanes::code::{Block, Code, Step, Target, Value};
use texunit::lanes::{Isa, U32s};

/// Runs shorter than this stay with the interpreter.
const MIN_INSTRUCTIONS: usize = 2;

/// Longer runs are split.
const MAX_INSTRUCTIONS: usize = 1024;

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

/// What the mask is while no lane executes.
pub(super) static NO_LANES: U32s = U32s::ZERO;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{Builder, Input, Interpolation, Op, Output, Stage};

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
