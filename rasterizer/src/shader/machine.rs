//! Running a register program over 64 lanes.
//!
//! One run is one `Kernel`: the loop over the instructions is compiled per instruction set with
//! every operation's loop inlined. An operation computes into a value of its own that is then moved to
//! its register, so that no output ever aliases an input.
//!
//! Batches of straight code run together, each with a register file of its own: what lies between two
//! samples is computed for one after the other, and they do not wait for one another.

mod interpreter;
mod lookup;
mod product;
mod trace;

use crate::shader::machine::interpreter::repeat_loop;
pub use trace::Tracer;

use super::emission::Emission;
use super::inst::{Reg, Slot, Target};
use super::mask::{Extent, Mask, blend};
use super::preamble::uniform_at;
use super::{Invocation, OverBudget, Prepared, Program};
use crate::ir::{Axis, FunctionTable};
use texunit::lanes::{F32s, LANES, QUADS, Simd, U32s};
use texunit::sample::LookupScratch;

/// The registers of a thread, reused from batch to batch and from program to program.
#[derive(Debug, Default)]
pub struct Machine {
    registers: Vec<U32s>,
    /// What the first registers of each register file hold in all their lanes.
    splats: Vec<f32>,
    /// The lanes that execute.
    exec: Mask,
    /// The lanes that the run began with.
    start: Box<U32s>,
    discarded: Mask,
    slots: Vec<Mask>,
    /// The scratch of lookups: one, or one per register file.
    lookup_scratch: Vec<LookupScratch>,
    /// The distance between the scratch of two register files: 0 (shared) unless a lookup reuses the texel addresses
    /// of the one before.
    scratch_stride: usize,
    /// Identity of the program that the registers are laid out for; 0 is none.
    program: u64,
    /// Identity of the draw whose words the registers hold; 0 is none.
    prepared: u64,
    inputs: usize,
    outputs: Vec<u32>,
    /// Registers of a register file.
    file: usize,
    /// What the last run left of its budget.
    left: u64,
    emission: Emission,
}

impl Machine {
    /// Allocates a program's registers. Does nothing when the machine holds it already.
    pub fn begin(&mut self, program: &Program) {
        if self.program == program.id {
            return;
        }
        self.file = program.layout.registers as usize;
        if self.registers.len() < self.file * program.files {
            self.registers.resize(self.file * program.files, U32s::ZERO);
        }
        if self.slots.len() < program.slots as usize {
            self.slots.resize_with(program.slots as usize, Mask::default);
        }
        self.scratch_stride = usize::from(program.keeps_lookup_scratch);
        let count = 1 + self.scratch_stride * (program.files - 1);
        if self.lookup_scratch.len() < count {
            self.lookup_scratch.resize_with(count, LookupScratch::default);
        }
        self.inputs = program.layout.inputs as usize;
        self.outputs.clone_from(&program.layout.outputs);
        if let Some(interface) = &program.geometry {
            self.emission.begin(interface);
        }
        self.program = program.id;
        self.prepared = 0;
    }

    /// The register of the program's input `index`: filled before each run, unless it holds what is wanted. Programs
    /// do not write there.
    pub fn input_mut(&mut self, index: usize) -> &mut U32s {
        &mut self.inputs_of(0)[index]
    }

    /// The inputs of a register file, each as [`Self::input_mut`]; other registers may follow.
    #[inline(always)]
    pub fn inputs_of(&mut self, file: usize) -> &mut [U32s] {
        &mut self.registers[file * self.file + self.inputs..]
    }

    /// The registers of a register file; others may follow.
    #[inline(always)]
    pub(super) fn file(&self, file: usize) -> &[U32s] {
        &self.registers[file * self.file..]
    }

    /// What the input `index` was filled with.
    pub fn input(&self, index: usize) -> &U32s {
        &self.registers[self.inputs + index]
    }

    /// Fills the registers that are the same in all lanes; gives what is left of the budget.
    ///
    /// # Errors
    /// When the program is longer than that.
    pub fn start(&mut self, invocation: &Invocation<'_>) -> Result<u64, OverBudget> {
        self.begin(invocation.program);
        if self.prepared != invocation.prepared.id {
            let splats = invocation.program.layout.splats.iter();
            self.splats.clear();
            self.splats.extend(
                splats.map(|&word| f32::from_bits(invocation.prepared.words[word as usize])),
            );
            for file in 0..invocation.program.files {
                let registers = &mut self.registers[file * self.file..];
                for (reg, word) in registers.iter_mut().zip(&invocation.program.layout.splats) {
                    *reg = U32s::splat(invocation.prepared.words[*word as usize]);
                }
            }
            self.prepared = invocation.prepared.id;
        }
        self.discarded.clear();
        if invocation.program.geometry.is_some() {
            self.emission.clear();
        }
        if invocation.program.masked {
            self.exec.whole(invocation.active);
            self.start.clone_from(&self.exec.lanes);
        }
        let operations = invocation.prepared.operations(0, invocation.program.code.len());
        self.left = 0;
        invocation.budget.checked_sub(operations).ok_or(OverBudget)
    }

    /// What the last run of a geometry program emitted.
    pub fn emission(&self) -> &Emission {
        &self.emission
    }

    /// What the last run left of its budget; 0 if it exceeded it.
    pub fn left(&self) -> u64 {
        self.left
    }

    /// The register of the program's output `index`, after a run. Inactive lanes hold any bits.
    pub fn output(&self, index: usize) -> &U32s {
        self.output_of(0, index)
    }

    /// [`Self::output`] of a register file.
    #[inline(always)]
    pub fn output_of(&self, file: usize, index: usize) -> &U32s {
        &self.registers[file * self.file + self.outputs[index] as usize]
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
            Extent::Partial => {
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
    fn derivative(&mut self, file: usize, axis: Axis, out: Reg, from: Reg) {
        let from = self.registers[file + from.0 as usize].as_f32();
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
        self.registers[file + out.0 as usize] = *difference.as_u32();
    }

    /// A function from a table.
    #[inline(always)]
    fn tabulated<S: Simd>(&mut self, file: usize, table: &FunctionTable, out: Reg, from: Reg) {
        let from = self.registers[file + from.0 as usize].as_f32();
        let mut words = U32s::ZERO;
        match table {
            FunctionTable::OfByte(table) => {
                for lane in 0..LANES {
                    words[lane] = table.word(from[lane]);
                }
            }
            FunctionTable::Power(power) => words = *power.of_lanes::<S>(from).as_u32(),
        }
        self.registers[file + out.0 as usize] = words;
    }

    /// Ends an iteration of a loop whose last instruction is before `pc`. Gives the head of the loop, or `pc` if no lane
    /// is left.
    #[inline(always)]
    fn end_iteration(
        &mut self,
        head: Target,
        exit: Slot,
        pc: usize,
        (prepared, left): (&Prepared, &mut u64),
    ) -> Result<usize, OverBudget> {
        if self.exec.is_empty() {
            self.exec.take(&mut self.slots[exit.0 as usize], &self.start);
            return Ok(pc);
        }
        repeat_loop(head, pc, prepared, left)
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
