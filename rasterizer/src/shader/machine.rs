//! Running a register program over 64 lanes.
//!
//! One run is one [`Kernel`]: the loop over the instructions is compiled per instruction set with
//! every operation's loop inlined. Registers never move, so that the addresses of an instruction
//! do not wait for the one before it.

use super::inst::{Inst, Reg, SampleInst, SampleLod};
use super::mask::{Extent, Mask};
use super::preamble::uniform_at;
use super::{OverBudget, Program, Run};
use crate::ir::Axis;
use texunit::lanes::{F32s, Kernel, LANES, QUADS, Simd, U32s};
use texunit::plan::Lod;

/// The registers of a thread, reused from batch to batch and from program to program.
#[derive(Debug, Default)]
pub struct Machine {
    registers: Vec<U32s>,
    /// The lanes that execute.
    exec: Mask,
    /// The lanes that the run began with.
    start: Box<U32s>,
    discarded: Mask,
    slots: Vec<Mask>,
    sampled: Box<[F32s; 4]>,
    /// Identity of the program that the registers are laid out for; 0 is none.
    program: u64,
    /// Identity of the draw whose words the registers hold; 0 is none.
    prepared: u64,
    inputs: usize,
    outputs: Vec<u32>,
}

impl Machine {
    /// Makes room for a program's registers. Costs nothing when the machine holds it already.
    pub fn begin(&mut self, program: &Program) {
        if self.program == program.id {
            return;
        }
        let count = program.layout.registers as usize;
        if self.registers.len() < count {
            self.registers.resize(count, U32s::ZERO);
        }
        if self.slots.len() < program.slots as usize {
            self.slots.resize_with(program.slots as usize, Mask::default);
        }
        self.inputs = program.layout.inputs as usize;
        self.outputs.clone_from(&program.layout.outputs);
        self.program = program.id;
        self.prepared = 0;
    }

    /// The register of the program's input `index`, to be filled before each run.
    pub fn input_mut(&mut self, index: usize) -> &mut U32s {
        &mut self.registers[self.inputs + index]
    }

    /// Runs the program once over the active lanes; gives the lanes that were not discarded.
    ///
    /// # Errors
    /// When the budget is used up.
    pub fn run(&mut self, run: Run<'_>) -> Result<u64, OverBudget> {
        self.begin(run.program);
        if self.prepared != run.prepared.id {
            for (reg, word) in self.registers.iter_mut().zip(&run.program.layout.splats) {
                *reg = U32s::splat(run.prepared.words[*word as usize]);
            }
            self.prepared = run.prepared.id;
        }
        self.exec.whole(run.active);
        self.start.clone_from(&self.exec.lanes);
        self.discarded.clear();
        let left = run.budget.checked_sub(run.program.code.len() as u64).ok_or(OverBudget)?;
        run.isa.run(Interpreter { machine: self, run, left })?;
        Ok(run.active & !self.discarded.bits())
    }

    /// The register of the program's output `index`, after a run. Inactive lanes hold any bits.
    pub fn output(&self, index: usize) -> &U32s {
        &self.registers[self.outputs[index] as usize]
    }
}

/// The registers beside the one that an instruction writes.
#[derive(Clone, Copy)]
struct Others<'a> {
    below: &'a [U32s],
    above: &'a [U32s],
}

impl<'a> Others<'a> {
    #[inline(always)]
    fn get(self, reg: Reg) -> &'a U32s {
        let at = reg.0 as usize;
        let (part, at) = if at < self.below.len() {
            (self.below, at)
        } else {
            (self.above, at.wrapping_sub(self.below.len() + 1))
        };
        &part[at]
    }
}

/// A register to write and the others to read: allocation keeps an output apart from the inputs.
#[inline(always)]
fn split(registers: &mut [U32s], out: Reg) -> (&mut U32s, Others<'_>) {
    let (below, rest) = registers.split_at_mut(out.0 as usize);
    let (out, above) = rest.split_at_mut(1);
    (&mut out[0], Others { below, above })
}

#[inline(always)]
fn load_at(registers: &mut [U32s], out: Reg, base: Reg, len: u32, index: Reg) {
    let (out, others) = split(registers, out);
    let index = others.get(index);
    for lane in 0..LANES {
        out[lane] = others.get(Reg(base.0 + index[lane].min(len - 1)))[lane];
    }
}

#[inline(always)]
fn store(registers: &mut [U32s], exec: &Mask, out: Reg, from: Reg) {
    let (out, others) = split(registers, out);
    let from = others.get(from);
    match exec.extent {
        Extent::Empty => {}
        Extent::Part => {
            for lane in 0..LANES {
                let mask = exec.lanes[lane];
                out[lane] = (from[lane] & mask) | (out[lane] & !mask);
            }
        }
        Extent::Whole => *out = *from,
    }
}

#[inline(always)]
fn store_at(registers: &mut [U32s], exec: &Mask, base: Reg, len: u32, index: Reg, from: Reg) {
    if exec.is_empty() {
        return;
    }
    let (index, from) = (registers[index.0 as usize], registers[from.0 as usize]);
    let array = &mut registers[base.0 as usize..][..len as usize];
    for lane in 0..LANES {
        if exec.lanes[lane] != 0 {
            let element = &mut array[index[lane].min(len - 1) as usize];
            element[lane] = from[lane];
        }
    }
}

/// Fine derivatives: the difference within each row or column of a quad. Lane order is
/// quad-planar, see [`texunit::lanes`].
#[inline(always)]
fn derivative(registers: &mut [U32s], axis: Axis, out: Reg, from: Reg) {
    let (out, others) = split(registers, out);
    let (out, from) = (out.as_f32_mut(), others.get(from).as_f32());
    // By pixel of the quad: the planes of the near and the far neighbour.
    let planes = match axis {
        Axis::X => [(0, 1), (0, 1), (2, 3), (2, 3)],
        Axis::Y => [(0, 2), (1, 3), (0, 2), (1, 3)],
    };
    for (pixel, (near, far)) in planes.into_iter().enumerate() {
        for quad in 0..QUADS {
            out[pixel * QUADS + quad] = from[far * QUADS + quad] - from[near * QUADS + quad];
        }
    }
}

#[inline(always)]
fn sample(registers: &mut [U32s], sampled: &mut [F32s; 4], run: &Run<'_>, sample: &SampleInst) {
    match run.textures.get(sample.texture as usize) {
        Some(Some(plan)) => {
            let reg = |reg: Reg| registers[reg.0 as usize].as_f32();
            let lod = match sample.lod {
                SampleLod::Implicit { bias } => Lod::Implicit { bias: bias.map(reg) },
                SampleLod::Explicit(lod) => Lod::Explicit(reg(lod)),
                SampleLod::Gradient { dx, dy } => {
                    Lod::Gradient { dx: dx.map(reg), dy: dy.map(reg) }
                }
            };
            let coords = sample.coords.map(reg);
            plan.sample(run.isa, coords, sample.reference.map(reg), lod, sampled);
        }
        Some(None) | None => *sampled = [0.0, 0.0, 0.0, 1.0].map(F32s::splat),
    }
    for (out, texel) in sample.out.iter().zip(sampled.iter()) {
        if let Some(out) = out {
            registers[out.0 as usize] = *texel.as_u32();
        }
    }
}

struct Interpreter<'a> {
    machine: &'a mut Machine,
    run: Run<'a>,
    /// How many instructions may still run.
    left: u64,
}

impl Kernel for Interpreter<'_> {
    type Output = Result<(), OverBudget>;

    #[inline(always)]
    fn run<S: Simd>(self) -> Result<(), OverBudget> {
        let Self { machine: m, run, mut left } = self;
        let registers = &mut m.registers[..];
        let code = &run.program.code[..];
        let mut pc = 0;
        while let Some(inst) = code.get(pc) {
            pc += 1;
            match *inst {
                Inst::Op { op, out, args } => {
                    let (out, others) = split(registers, out);
                    op.run(out, args.map(|reg| others.get(reg)));
                }
                Inst::Move { out, from } => {
                    let (out, others) = split(registers, out);
                    *out = *others.get(from);
                }
                Inst::Zero { out, len } => {
                    registers[out.0 as usize..][..len as usize].fill(U32s::ZERO);
                }
                Inst::Store { out, from } => store(registers, &m.exec, out, from),
                Inst::LoadAt { out, base, len, index } => {
                    load_at(registers, out, base, len, index);
                }
                Inst::StoreAt { base, len, index, from } => {
                    store_at(registers, &m.exec, base, len, index, from);
                }
                Inst::UniformAt { out, base, len, index } => {
                    let (out, others) = split(registers, out);
                    let index = others.get(index);
                    for lane in 0..LANES {
                        out[lane] = uniform_at(&run.prepared.uniforms, base, len, index[lane]);
                    }
                }
                Inst::Derivative { axis, out, from } => derivative(registers, axis, out, from),
                Inst::Sample(ref inst) => sample(registers, &mut m.sampled, &run, inst),
                Inst::If { condition, slot, reject } => {
                    let rest = &mut m.slots[slot.0 as usize];
                    m.exec.split(&registers[condition.0 as usize], rest);
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
                Inst::Discard => m.discarded.take(&mut m.exec, &m.start),
                Inst::SkipEmpty { to } => {
                    if m.exec.is_empty() {
                        pc = to.0 as usize;
                    }
                }
                Inst::Again { head, exit } => {
                    if m.exec.is_empty() {
                        m.exec.take(&mut m.slots[exit.0 as usize], &m.start);
                    } else {
                        left = left.checked_sub((pc - head.0 as usize) as u64).ok_or(OverBudget)?;
                        pc = head.0 as usize;
                    }
                }
            }
        }
        Ok(())
    }
}
