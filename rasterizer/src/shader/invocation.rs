//! One invocation of a program over 64 lanes: its arguments and its error.

use super::native::NativeCode;
use super::program::{Prepared, Program};
use std::sync::Arc;
use texunit::lanes::Isa;
use texunit::plan::SamplePlan;

/// The arguments of one invocation of a program, besides the registers.
#[derive(Clone, Copy)]
pub struct Invocation<'a> {
    /// The instruction set.
    pub isa: Isa,
    /// The program that [`crate::shader::Machine::begin`] was given.
    pub program: &'a Program,
    /// Its values of this draw.
    pub prepared: &'a Prepared,
    /// By slot; a slot without a texture samples as (0, 0, 0, 1).
    pub textures: &'a [Option<Arc<SamplePlan>>],
    /// Which lanes run, bit by lane. For fragments: whole quads.
    pub active: u64,
    /// The operations that may run, in additions of 64 lanes: those of the program, and those of each loop again for each
    /// iteration after the first. Only programs with loops count them.
    pub budget: u64,
}

impl Invocation<'_> {
    /// The machine code of the program, if there is any.
    pub(super) fn native(&self) -> Option<&NativeCode> {
        self.program.native.get(self.isa, self.program)
    }
}

/// The error of an invocation that exceeds its budget.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OverBudget;
