//! Counts of a program's resources, checked against the limits.

use super::parser::Parser;
use super::program::{Instruction, Opcode, Register, Written};
use super::{Failure, Parsed};
use crate::base::assembly_limits as limits;

impl Parser<'_> {
    /// Counts a lookup or `KIL` that depends on what came before it as an indirection
    /// (ARB_fragment_program, section 3.11.6): its coordinates were computed, or its result was
    /// used, since the last one.
    pub fn count_indirections(&mut self, instruction: &Instruction) {
        let written = match instruction.destination.written {
            Written::Temporary(number) => Some(number),
            Written::Address(_) | Written::Result(_) | Written::Nowhere => None,
        };
        let read = || {
            instruction.sources.iter().filter_map(|source| match source.register {
                Register::Temporary(number) => Some(number),
                Register::Attribute(_) | Register::Parameter(_) | Register::Relative { .. } => None,
            })
        };
        // The first one begins with the first lookup.
        let now = self.counts.indirections.max(1);
        if instruction.lookup.is_some() || instruction.opcode == Opcode::Kil {
            let happened = |number: u16, kind: usize| self.recent[usize::from(number)][kind] == now;
            let depends = read().any(|number| happened(number, 0))
                || written.is_some_and(|number| happened(number, 1));
            self.counts.lookups += 1;
            self.counts.indirections = now + u32::from(depends);
        } else {
            for number in read().chain(written) {
                self.recent[usize::from(number)][1] = now;
            }
        }
        if let Some(number) = written {
            self.recent[usize::from(number)][0] = self.counts.indirections.max(1);
        }
    }

    /// Checks the counts against the limits.
    pub fn check_counts(&mut self, position: usize) -> Parsed<()> {
        self.counts.attributes = self.attributes.len() as u32;
        for (what, has, limit) in [
            ("instructions", self.counts.instructions, limits::MAX_INSTRUCTIONS),
            ("temporaries", self.counts.temporaries, limits::MAX_TEMPORARIES),
            ("parameters", self.counts.parameters, limits::MAX_PARAMETERS),
            ("address registers", self.counts.addresses, limits::MAX_ADDRESS_REGISTERS),
        ] {
            if has > limit {
                return Failure::at(position, format!("there are more than {limit} {what}"));
            }
        }
        Ok(())
    }
}
