//! What comes before the lookups of a product, and what they read.

use super::Machine;
use super::interpreter::Interpreter;
use super::lookup::lod;
use crate::shader::invocation::{Invocation, OverBudget};
use crate::shader::product::{ProductCode, TexelProduct};
use texunit::lanes::F32s;
use texunit::sample::Lod;

impl Machine {
    /// Runs the code before the lookups of a product, or a part of it, for the first `files` register files, whose
    /// inputs are filled.
    ///
    /// # Errors
    /// When the budget is used up.
    pub fn run_before(
        &mut self,
        invocation: &Invocation<'_>,
        product: &TexelProduct,
        part: ProductCode,
        files: usize,
    ) -> Result<(), OverBudget> {
        let left = self.start(invocation)?;
        let code = match part {
            ProductCode::Factors => &product.before_factors,
            ProductCode::Lookups => &product.before_lookups,
            ProductCode::Whole => &product.before,
        };
        if !code.is_empty() {
            invocation.isa.run(Interpreter {
                machine: self,
                invocation,
                code,
                native: None,
                files,
                pc: 0,
                left,
            })?;
        }
        Ok(())
    }

    /// The factors of a product, as its file has them.
    #[inline(always)]
    pub fn factors(&self, product: &TexelProduct, file: usize) -> [&F32s; 4] {
        const ONE: &F32s = &F32s::splat(1.0);
        let registers = self.file(file);
        product.factors.map(|reg| reg.map_or(ONE, |reg| registers[reg.0 as usize].as_f32()))
    }

    /// s, t and r of a lookup, as its file has them.
    #[inline(always)]
    pub fn coords(&self, product: &TexelProduct, at: usize, file: usize) -> [&F32s; 3] {
        let registers = self.file(file);
        product.lookups[at].coords.map(|reg| registers[reg.0 as usize].as_f32())
    }

    /// The level of detail of a lookup, from the registers of a register file.
    #[inline(always)]
    pub fn lod<'a>(&'a self, product: &'a TexelProduct, at: usize, file: usize) -> Lod<'a> {
        lod(self.file(file), &product.lookups[at])
    }
}
