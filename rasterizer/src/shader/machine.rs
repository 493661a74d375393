//! Running a register program over 64 lanes.
//!
//! One run is one [`Kernel`]: the loop over the instructions is compiled per instruction set with
//! every operation's loop inlined. An operation computes into a value of its own that is then moved to
//! its register, so that no output ever aliases an input.
//!
//! Batches of straight code run together, each with a bank of registers of its own: what lies between two
//! samples is computed for one after the other, and they do not wait for one another.

mod trace;

pub use trace::Tracer;

use super::inst::{Inst, Reg, SampleInst, SampleLod, Slot, Target, Test};
use super::mask::{Extent, Mask, blend};
use super::preamble::uniform_at;
use super::{OverBudget, Prepared, Program, Run};
use crate::ir::{Access, Axis};
use texunit::lanes::{F32s, Kernel, LANES, QUADS, Simd, U32s};
use texunit::sample::{Lod, LookupScratch, Points};

/// The registers of a thread, reused from batch to batch and from program to program.
#[derive(Debug, Default)]
pub struct Machine {
    registers: Vec<U32s>,
    /// What the first registers of each bank hold in all their lanes.
    same: Vec<f32>,
    /// The lanes that execute.
    exec: Mask,
    /// The lanes that the run began with.
    start: Box<U32s>,
    discarded: Mask,
    slots: Vec<Mask>,
    /// For lookups.
    rooms: Vec<LookupScratch>,
    /// From the room of a bank to that of the next: none, unless a lookup keeps what the one before found.
    apart: usize,
    /// Identity of the program that the registers are laid out for; 0 is none.
    program: u64,
    /// Identity of the draw whose words the registers hold; 0 is none.
    prepared: u64,
    inputs: usize,
    outputs: Vec<u32>,
    /// Registers of a bank.
    bank: usize,
}

impl Machine {
    /// Makes room for a program's registers. Costs nothing when the machine holds it already.
    pub fn begin(&mut self, program: &Program) {
        if self.program == program.id {
            return;
        }
        self.bank = program.layout.registers as usize;
        if self.registers.len() < self.bank * program.banks {
            self.registers.resize(self.bank * program.banks, U32s::ZERO);
        }
        if self.slots.len() < program.slots as usize {
            self.slots.resize_with(program.slots as usize, Mask::default);
        }
        self.apart = usize::from(!program.repeats.is_empty());
        let rooms = 1 + self.apart * (program.banks - 1);
        if self.rooms.len() < rooms {
            self.rooms.resize_with(rooms, LookupScratch::default);
        }
        self.inputs = program.layout.inputs as usize;
        self.outputs.clone_from(&program.layout.outputs);
        self.program = program.id;
        self.prepared = 0;
    }

    /// The register of the program's input `index`: filled before each run, unless it holds what is wanted. Programs do not write there.
    pub fn input_mut(&mut self, index: usize) -> &mut U32s {
        &mut self.inputs_of(0)[index]
    }

    /// The inputs of a bank, each as [`Self::input_mut`]; other registers may follow.
    #[inline(always)]
    pub fn inputs_of(&mut self, bank: usize) -> &mut [U32s] {
        &mut self.registers[bank * self.bank + self.inputs..]
    }

    /// The registers of a bank; others may follow.
    #[inline(always)]
    pub(super) fn bank(&self, bank: usize) -> &[U32s] {
        &self.registers[bank * self.bank..]
    }

    /// What the input `index` was filled with.
    pub fn input(&self, index: usize) -> &U32s {
        &self.registers[self.inputs + index]
    }

    /// Runs the program once over the active lanes; gives the lanes that were not discarded.
    ///
    /// # Errors
    /// When the budget is used up.
    pub fn run(&mut self, run: Run<'_>) -> Result<u64, OverBudget> {
        let left = self.start(&run)?;
        let code = &run.program.code;
        run.isa.run(Interpreter { machine: self, run: &run, code, banks: 1, pc: 0, left })?;
        Ok(run.active & !self.discarded.bits())
    }

    /// Runs the program once for each of so many banks, at most [`Program::banks`], over all lanes.
    ///
    /// # Errors
    /// When the budget is used up.
    pub fn run_banks(&mut self, run: Run<'_>, banks: usize) -> Result<(), OverBudget> {
        let left = self.start(&run)?;
        let (code, banks) = (&run.program.code, banks.min(run.program.banks));
        run.isa.run(Interpreter { machine: self, run: &run, code, banks, pc: 0, left })?;
        Ok(())
    }

    /// Fills the registers that are the same in all lanes; gives what is left of the budget.
    ///
    /// # Errors
    /// When the program is longer than that.
    pub fn start(&mut self, run: &Run<'_>) -> Result<u64, OverBudget> {
        self.begin(run.program);
        if self.prepared != run.prepared.id {
            let splats = run.program.layout.splats.iter();
            self.same.clear();
            self.same.extend(splats.map(|&word| f32::from_bits(run.prepared.words[word as usize])));
            for bank in 0..run.program.banks {
                let registers = &mut self.registers[bank * self.bank..];
                for (reg, word) in registers.iter_mut().zip(&run.program.layout.splats) {
                    *reg = U32s::splat(run.prepared.words[*word as usize]);
                }
            }
            self.prepared = run.prepared.id;
        }
        self.discarded.clear();
        if run.program.masked {
            self.exec.whole(run.active);
            self.start.clone_from(&self.exec.lanes);
        }
        run.budget.checked_sub(run.program.code.len() as u64).ok_or(OverBudget)
    }

    /// The register of the program's output `index`, after a run. Inactive lanes hold any bits.
    pub fn output(&self, index: usize) -> &U32s {
        self.output_of(0, index)
    }

    /// [`Self::output`] of a bank.
    #[inline(always)]
    pub fn output_of(&self, bank: usize, index: usize) -> &U32s {
        &self.registers[bank * self.bank + self.outputs[index] as usize]
    }

    #[inline(always)]
    fn reg(&self, reg: Reg) -> &U32s {
        &self.registers[reg.0 as usize]
    }

    #[inline(always)]
    fn load_at(&mut self, out: Reg, base: Reg, len: u32, index: Reg) {
        let array = &self.registers[base.0 as usize..][..len as usize];
        let index = &self.registers[index.0 as usize];
        let mut found = U32s::ZERO;
        for lane in 0..LANES {
            found[lane] = array[index[lane].min(len - 1) as usize][lane];
        }
        self.registers[out.0 as usize] = found;
    }

    #[inline(always)]
    fn store(&mut self, out: Reg, from: Reg) {
        match self.exec.extent {
            Extent::Empty => {}
            Extent::Part => {
                let old = &self.registers[out.0 as usize];
                let new = &self.registers[from.0 as usize];
                let mut blended = U32s::ZERO;
                blend(&mut blended, &self.exec.lanes, new, old);
                self.registers[out.0 as usize] = blended;
            }
            Extent::Whole => self.registers[out.0 as usize] = self.registers[from.0 as usize],
        }
    }

    #[inline(always)]
    fn store_at(&mut self, base: Reg, len: u32, index: Reg, from: Reg) {
        if self.exec.is_empty() {
            return;
        }
        let (index, from) = (*self.reg(index), *self.reg(from));
        let array = &mut self.registers[base.0 as usize..][..len as usize];
        let mask = &*self.exec.lanes;
        for lane in 0..LANES {
            if mask[lane] != 0 {
                array[index[lane].min(len - 1) as usize][lane] = from[lane];
            }
        }
    }

    /// Fine derivatives: the difference within each row or column of a quad. Lane order is
    /// quad-planar, see [`texunit::lanes`].
    #[inline(always)]
    fn derivative(&mut self, bank: usize, axis: Axis, out: Reg, from: Reg) {
        let from = self.registers[bank + from.0 as usize].as_f32();
        let mut difference = F32s::ZERO;
        // By pixel of the quad: the planes of the near and the far neighbour.
        let planes = match axis {
            Axis::X => [(0, 1), (0, 1), (2, 3), (2, 3)],
            Axis::Y => [(0, 2), (1, 3), (0, 2), (1, 3)],
        };
        for (pixel, (near, far)) in planes.into_iter().enumerate() {
            for quad in 0..QUADS {
                difference[pixel * QUADS + quad] =
                    from[far * QUADS + quad] - from[near * QUADS + quad];
            }
        }
        self.registers[bank + out.0 as usize] = *difference.as_u32();
    }

    /// Samples for a bank.
    #[inline(always)]
    fn sample(&mut self, bank: usize, run: &Run<'_>, sample: &SampleInst) {
        let plan = run.textures.get(sample.texture as usize).and_then(Option::as_ref);
        let registers = &mut self.registers[bank * self.bank..];
        let room = &mut self.rooms[bank * self.apart];
        match plan.filter(|plan| plan.incomplete().is_none()) {
            Some(plan) => {
                let reg = |reg: Reg| registers[reg.0 as usize].as_f32();
                let lod = lod(registers, sample);
                let coords = sample.coords.map(reg);
                let (layer, reference) = (sample.layer.map(reg), sample.reference.map(reg));
                let out = &mut room.lanes;
                match (sample.access, lod) {
                    (Access::Fetch { offset }, Lod::Explicit(level)) => {
                        let texel = coords.map(|c| c.as_u32().as_i32());
                        plan.fetch(run.isa, texel, level.as_u32().as_i32(), offset, out);
                    }
                    (Access::Size, Lod::Explicit(level)) => {
                        let size = plan.size(level.as_u32().as_i32());
                        out[3] = F32s::ZERO;
                        for (out, size) in out.iter_mut().zip(&size) {
                            let out = out.as_u32_mut();
                            for lane in 0..LANES {
                                out[lane] = size[lane] as u32;
                            }
                        }
                    }
                    (Access::Gather { offset }, _) => {
                        let points = Points { coords, layer, reference };
                        plan.gather(run.isa, points, offset, out);
                    }
                    (Access::Lod, lod) => {
                        let [level, lambda, rest @ ..] = out;
                        let mut found = [F32s::ZERO; 2];
                        plan.query_lod(run.isa, coords, lod, &mut found);
                        [*level, *lambda] = found;
                        *rest = [F32s::ZERO; 2];
                    }
                    (Access::Filter { offset }, lod) => {
                        let points = Points { coords, layer, reference };
                        let places = run.prepared.places(sample);
                        plan.sample_offset(run.isa, points, offset, lod, places, room);
                    }
                    // Validation wants a level for these.
                    (Access::Fetch { .. } | Access::Size, Lod::Implicit { .. })
                    | (Access::Fetch { .. } | Access::Size, Lod::Gradient { .. }) => {
                        *out = [F32s::ZERO; 4];
                    }
                }
            }
            // GL 2.1, section 3.11.2: what is not there or not complete is (0, 0, 0, 1).
            None => {
                let black = [0, 0, 0, sample.one];
                room.lanes = black.map(|c| F32s::splat(f32::from_bits(c)));
            }
        }
        for (out, texel) in sample.out.iter().zip(&room.lanes) {
            if let Some(out) = out {
                registers[out.0 as usize] = *texel.as_u32();
            }
        }
    }

    /// The next turn of a loop that ends at `pc`, or what comes after it.
    #[inline(always)]
    fn again(
        &mut self,
        head: Target,
        exit: Slot,
        pc: usize,
        left: &mut u64,
    ) -> Result<usize, OverBudget> {
        if self.exec.is_empty() {
            self.exec.take(&mut self.slots[exit.0 as usize], &self.start);
            return Ok(pc);
        }
        back(head, pc, left)
    }

    #[inline(always)]
    fn uniform_at(&mut self, prepared: &Prepared, out: Reg, base: u32, len: u32, index: Reg) {
        let index = &self.registers[index.0 as usize];
        let mut found = U32s::ZERO;
        for lane in 0..LANES {
            found[lane] = uniform_at(&prepared.uniforms, base, len, index[lane]);
        }
        self.registers[out.0 as usize] = found;
    }
}

/// Where the level of detail of a sample comes from.
#[inline(always)]
pub(super) fn lod<'a>(registers: &'a [U32s], sample: &SampleInst) -> Lod<'a> {
    let reg = |reg: Reg| registers[reg.0 as usize].as_f32();
    match sample.lod {
        SampleLod::Implicit { bias } => Lod::Implicit { bias: bias.map(reg) },
        SampleLod::Explicit(lod) => Lod::Explicit(reg(lod)),
        SampleLod::Gradient { dx, dy, bias } => {
            Lod::Gradient { dx: dx.map(reg), dy: dy.map(reg), bias: bias.map(reg) }
        }
    }
}

/// Runs from an instruction to the end of the code; gives where the program goes on.
pub(super) struct Interpreter<'a> {
    pub machine: &'a mut Machine,
    pub run: &'a Run<'a>,
    pub code: &'a [Inst],
    /// For how many banks.
    pub banks: usize,
    pub pc: usize,
    /// How many instructions may still run.
    pub left: u64,
}

impl Kernel for Interpreter<'_> {
    type Output = Result<usize, OverBudget>;

    #[inline(always)]
    fn run<S: Simd>(self) -> Result<usize, OverBudget> {
        let Self { machine: m, run, code, banks: count, mut pc, mut left } = self;
        let size = m.bank;
        // The first register of each bank.
        let banks = || (0..count).map(|bank| bank * size);
        loop {
            // Nearly all of a program, with one jump an instruction.
            let first = pc;
            for bank in banks() {
                let registers = &mut m.registers[bank..];
                pc = first;
                while let Some(Inst::Compute { what, out, args }) = code.get(pc) {
                    what.run::<S>(registers, &m.same, *out, args);
                    pc += 1;
                }
            }
            let Some(inst) = code.get(pc) else { return Ok(pc) };
            pc += 1;
            match *inst {
                Inst::Compute { .. } => {}
                Inst::Move { out, from } => {
                    for bank in banks() {
                        m.registers[bank + out.0 as usize] = m.registers[bank + from.0 as usize];
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
                    m.uniform_at(run.prepared, out, base, len, index);
                }
                Inst::Derivative { axis, out, from } => {
                    banks().for_each(|bank| m.derivative(bank, axis, out, from));
                }
                Inst::Sample(ref sample) => {
                    (0..count).for_each(|bank| m.sample(bank, run, sample));
                }
                Inst::Unless { test, to } => {
                    let word = match test {
                        Test::Word(word) => run.prepared.words[word as usize],
                        Test::Lanes(reg) => m.reg(reg)[0],
                    };
                    if word == 0 {
                        pc = to.0 as usize;
                    }
                }
                Inst::Jump { to } => pc = to.0 as usize,
                Inst::Repeat { head } => pc = back(head, pc, &mut left)?,
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
                Inst::Discard => m.discarded.take(&mut m.exec, &m.start),
                Inst::SkipEmpty { to } => {
                    if m.exec.is_empty() {
                        pc = to.0 as usize;
                    }
                }
                Inst::Again { head, exit } => pc = m.again(head, exit, pc, &mut left)?,
            }
        }
    }
}

/// The head of a loop that ends at `pc`, its turn taken off the budget.
#[inline(always)]
fn back(head: Target, pc: usize, left: &mut u64) -> Result<usize, OverBudget> {
    let head = head.0 as usize;
    *left = left.checked_sub((pc - head) as u64).ok_or(OverBudget)?;
    Ok(head)
}
