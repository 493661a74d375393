//! What comes before the lookups of a product, and what they read.

use super::Machine;
use super::interpreter::Interpreter;
use super::lookup::lod;
use crate::shader::product::{Part, Product};
use crate::shader::run::{OverBudget, Run};
use texunit::lanes::F32s;
use texunit::plan::Lod;

impl Machine {
    /// Computes what comes before the lookups of a product, or a part of it, for so many banks whose inputs are there.
    ///
    /// # Errors
    /// When the budget is used up.
    pub fn run_before(
        &mut self,
        run: &Run<'_>,
        product: &Product,
        part: Part,
        banks: usize,
    ) -> Result<(), OverBudget> {
        let left = self.start(run)?;
        let code = match part {
            Part::Factors => &product.before_factors,
            Part::Lookups => &product.before_lookups,
            Part::Whole => &product.before,
        };
        if !code.is_empty() {
            run.isa.run(Interpreter { machine: self, run, code, banks, pc: 0, left })?;
        }
        Ok(())
    }

    /// The factors of a product, as its bank has them.
    #[inline(always)]
    pub fn factors(&self, product: &Product, bank: usize) -> [&F32s; 4] {
        const ONE: &F32s = &F32s::splat(1.0);
        let registers = self.bank(bank);
        product.factors.map(|reg| reg.map_or(ONE, |reg| registers[reg.0 as usize].as_f32()))
    }

    /// s, t and r of a lookup, as its bank has them.
    #[inline(always)]
    pub fn coords(&self, product: &Product, at: usize, bank: usize) -> [&F32s; 3] {
        let registers = self.bank(bank);
        product.lookups[at].coords.map(|reg| registers[reg.0 as usize].as_f32())
    }

    /// Where the level of detail of a lookup comes from, as its bank has it.
    #[inline(always)]
    pub fn lod<'a>(&'a self, product: &'a Product, at: usize, bank: usize) -> Lod<'a> {
        lod(self.bank(bank), &product.lookups[at])
    }
}
