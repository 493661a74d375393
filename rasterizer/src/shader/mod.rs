//! From IR to lanes: optimize, lower to a register program, run it over 64 lanes.

use crate::ir::{Input, Module, Output, Stage};
use std::sync::Arc;
use texunit::lanes::{Isa, U32s};
use texunit::plan::SamplePlan;

/// A compiled stage.
#[derive(Debug)]
pub struct Program {}

/// What of a program is computed once per draw: its uniform words, and every value that depends on
/// nothing else.
#[derive(Debug)]
pub struct Prepared {}

/// The registers of a thread, reused from batch to batch and from program to program.
#[derive(Debug, Default)]
pub struct Machine {}

/// What one run needs besides the registers.
#[derive(Clone, Copy)]
pub struct Run<'a> {
    /// The instruction set.
    pub isa: Isa,
    /// The program that [`Machine::begin`] was given.
    pub program: &'a Program,
    /// Its values of this draw.
    pub prepared: &'a Prepared,
    /// By slot; a slot without a texture samples as (0, 0, 0, 1).
    pub textures: &'a [Option<Arc<SamplePlan>>],
    /// Which lanes run, bit by lane. For fragments: whole quads.
    pub active: u64,
    /// How many instructions may run.
    pub budget: u64,
}

/// A run that would not end within its budget.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OverBudget;

impl Program {
    /// Optimizes and lowers `module`, keeping only the outputs that `keep` says somebody reads.
    /// The module has been validated.
    pub fn new(module: &Module, keep: impl Fn(Output) -> bool) -> Self {
        let _ = (module, &keep, Stage::Vertex);
        Self {}
    }

    /// The inputs that the program reads, each once. Their order is that of [`Machine::input_mut`].
    pub fn inputs(&self) -> &[Input] {
        &[]
    }

    /// The outputs that the program writes, each once. Their order is that of [`Machine::output`].
    pub fn outputs(&self) -> &[Output] {
        &[]
    }

    /// Whether any lane can be thrown away.
    pub fn discards(&self) -> bool {
        false
    }

    /// Computes what depends on uniforms only. Missing words read as zero.
    pub fn prepare(
        &self,
        isa: Isa,
        uniforms: &[u32],
        textures: &[Option<Arc<SamplePlan>>],
    ) -> Prepared {
        let _ = (isa, uniforms, textures);
        Prepared {}
    }
}

impl Machine {
    /// Makes room for a program's registers.
    pub fn begin(&mut self, program: &Program) {
        let _ = program;
    }

    /// The register of the program's input `index`, to be filled before each run.
    pub fn input_mut(&mut self, index: usize) -> &mut U32s {
        let _ = index;
        unimplemented!()
    }

    /// Runs the program once over the active lanes; gives the lanes that were not discarded.
    ///
    /// # Errors
    /// When the budget is used up.
    pub fn run(&mut self, run: Run<'_>) -> Result<u64, OverBudget> {
        let _ = run;
        Ok(0)
    }

    /// The register of the program's output `index`, after a run. Inactive lanes hold any bits.
    pub fn output(&self, index: usize) -> &U32s {
        let _ = index;
        unimplemented!()
    }
}
