//! The loop over the instructions, compiled for each instruction set.

use super::super::inst::{Inst, Target, Test};
use super::super::native::{NO_LANES, NativeCode};
use super::super::{Invocation, OverBudget, Prepared};
use super::Machine;
use texunit::lanes::{Kernel, Simd, U32s};

impl Machine {
    /// Runs the program once over the active lanes; gives the lanes that were not discarded.
    ///
    /// # Errors
    /// When the budget is used up.
    pub fn run(&mut self, invocation: Invocation<'_>) -> Result<u64, OverBudget> {
        let left = self.start(&invocation)?;
        let code = &invocation.program.code;
        invocation.isa.run(Interpreter {
            machine: self,
            invocation: &invocation,
            code,
            native: invocation.native(),
            files: 1,
            pc: 0,
            left,
        })?;
        Ok(invocation.active & !self.discarded.bits())
    }

    /// Runs the program once for each of the first `files` register files, at most [`crate::shader::Program::register_files`], over
    /// all lanes.
    ///
    /// # Errors
    /// When the budget is used up.
    pub fn run_files(
        &mut self,
        invocation: Invocation<'_>,
        files: usize,
    ) -> Result<(), OverBudget> {
        let left = self.start(&invocation)?;
        let (code, files) = (&invocation.program.code, files.min(invocation.program.files));
        invocation.isa.run(Interpreter {
            machine: self,
            invocation: &invocation,
            code,
            native: invocation.native(),
            files,
            pc: 0,
            left,
        })?;
        Ok(())
    }
}

/// Runs from an instruction to the end of the code; gives the index of the next instruction.
pub(super) struct Interpreter<'a> {
    pub machine: &'a mut Machine,
    pub invocation: &'a Invocation<'a>,
    pub code: &'a [Inst],
    /// The machine code of straight runs of `code`.
    pub native: Option<&'a NativeCode>,
    /// For how many files.
    pub files: usize,
    pub pc: usize,
    /// The operations that may still run.
    pub left: u64,
}

impl Kernel for Interpreter<'_> {
    type Output = Result<usize, OverBudget>;

    #[inline(always)]
    fn run<S: Simd>(self) -> Result<usize, OverBudget> {
        let Self { machine: m, invocation, code, native, files: count, mut pc, mut left } = self;
        let size = m.file;
        // The first register of each register file.
        let files = || (0..count).map(|file| file * size);
        loop {
            // Nearly all of a program, with one jump an instruction.
            let first = pc;
            for file in files() {
                let registers = &mut m.registers[file..];
                pc = first;
                loop {
                    if let Some(native) = native {
                        let mask = if m.exec.is_empty() { &NO_LANES } else { &*m.exec.lanes };
                        if let Some(next) = native.run(pc, registers, &m.splats, mask) {
                            pc = next;
                            continue;
                        }
                    }
                    let Some(Inst::Compute { what, out, args }) = code.get(pc) else { break };
                    what.run::<S>(registers, &m.splats, *out, args);
                    pc += 1;
                }
            }
            let Some(inst) = code.get(pc) else {
                m.left = left;
                return Ok(pc);
            };
            pc += 1;
            match *inst {
                Inst::Compute { .. } => {}
                Inst::Move { out, from } => {
                    for file in files() {
                        m.registers[file + out.0 as usize] = m.registers[file + from.0 as usize];
                    }
                }
                Inst::Zero { out, len } => {
                    for reg in &mut m.registers[out.0 as usize..][..len as usize] {
                        *reg = U32s::ZERO;
                    }
                }
                Inst::Store { out, from } => m.store(out, from),
                Inst::LoadAt { out, base, len, index } => m.load_at(out, base, len, index),
                Inst::StoreAt { base, len, index, from } => m.store_at(base, len, index, from),
                Inst::UniformAt { out, base, len, index } => {
                    m.uniform_at(invocation.prepared, out, base, len, index);
                }
                // No closures: they would be compiled without the instructions of `S`.
                Inst::Derivative { axis, out, from } => {
                    for file in files() {
                        m.derivative(file, axis, out, from);
                    }
                }
                Inst::Tabulated { out, from, ref table } => {
                    for file in files() {
                        m.tabulated::<S>(file, table, out, from);
                    }
                }
                Inst::Sample(ref sample) => {
                    for file in 0..count {
                        m.sample::<S>(file, invocation, sample);
                    }
                }
                Inst::Unless { test, to } => {
                    let word = match test {
                        Test::Word(word) => invocation.prepared.words[word as usize],
                        Test::Lanes(reg) => m.reg(reg)[0],
                    };
                    if word == 0 {
                        pc = to.0 as usize;
                    }
                }
                Inst::Jump { to } => pc = to.0 as usize,
                Inst::Repeat { head } => {
                    pc = repeat_loop(head, pc, invocation.prepared, &mut left)?
                }
                Inst::If { condition, slot, reject } => {
                    let rest = &mut m.slots[slot.0 as usize];
                    m.exec.split(&m.registers[condition.0 as usize], rest);
                    if m.exec.is_empty() {
                        m.exec.take(rest, &m.start);
                        pc = reject.0 as usize;
                    }
                }
                Inst::Else { slot, end } => {
                    std::mem::swap(&mut m.exec, &mut m.slots[slot.0 as usize]);
                    if m.exec.is_empty() {
                        pc = end.0 as usize;
                    }
                }
                Inst::Join { slot } => m.exec.take(&mut m.slots[slot.0 as usize], &m.start),
                Inst::Open { slot } => m.slots[slot.0 as usize].clear(),
                Inst::Leave { slot } => m.slots[slot.0 as usize].take(&mut m.exec, &m.start),
                Inst::LeaveIf { condition, when, slot } => {
                    let condition = &m.registers[condition.0 as usize];
                    let to = &mut m.slots[slot.0 as usize];
                    m.exec.leave_if(condition, when, to, &m.start);
                }
                Inst::EmitVertex(ref values) => {
                    let registers = &m.registers;
                    m.emission.emit(&m.exec, |at| &registers[values[at].0 as usize]);
                }
                Inst::EndPrimitive => m.emission.end_primitive(&m.exec),
                Inst::Discard => m.discarded.take(&mut m.exec, &m.start),
                Inst::SkipEmpty { to } => {
                    if m.exec.is_empty() {
                        pc = to.0 as usize;
                    }
                }
                Inst::EndIteration { head, exit } => {
                    pc = m.end_iteration(head, exit, pc, (invocation.prepared, &mut left))?
                }
            }
        }
    }
}

/// The head of a loop that ends at `pc`; an iteration is deducted from the budget.
#[inline(always)]
pub(super) fn repeat_loop(
    head: Target,
    pc: usize,
    prepared: &Prepared,
    left: &mut u64,
) -> Result<usize, OverBudget> {
    let head = head.0 as usize;
    *left = left.checked_sub(prepared.operations(head, pc)).ok_or(OverBudget)?;
    Ok(head)
}
