//! Which registers of a program are read later.

use crate::shader::inst::{Inst, Role};
use crate::shader::program::Program;

/// Programs of which more is to be known, instructions times words of registers, stay with the interpreter.
const MAX_LIVENESS: usize = 1 << 20;

/// Which registers are read after an instruction, before they are written in all lanes.
pub(super) struct Liveness {
    /// By instruction, and for the end of the code: a bit per register.
    before: Vec<Vec<u64>>,
}

impl Liveness {
    /// `None` where the program is too large.
    pub fn of(program: &Program) -> Option<Self> {
        let words = (program.layout.registers as usize).div_ceil(64);
        if program.code.len().saturating_mul(words) > MAX_LIVENESS {
            return None;
        }
        let mut code = program.code.clone();
        let mut before = vec![vec![0u64; words]; code.len() + 1];
        for &output in &program.layout.outputs {
            insert(&mut before[code.len()], output);
        }
        // Code whose only jumps go forward is done after one pass.
        loop {
            let mut has_changed = false;
            for at in (0..code.len()).rev() {
                let mut live = before[at + 1].clone();
                if let Some(target) = code[at].target() {
                    let from = &before[target.0 as usize];
                    live.iter_mut().zip(from).for_each(|(live, from)| *live |= from);
                }
                transfer(&mut code[at], &mut live);
                if live != before[at] {
                    before[at] = live;
                    has_changed = true;
                }
            }
            if !has_changed {
                return Some(Self { before });
            }
        }
    }

    pub fn is_live(&self, before: usize, register: u32) -> bool {
        self.before[before][register as usize / 64] >> (register % 64) & 1 == 1
    }
}

fn insert(live: &mut [u64], register: u32) {
    live[register as usize / 64] |= 1 << (register % 64);
}

fn remove(live: &mut [u64], register: u32) {
    live[register as usize / 64] &= !(1 << (register % 64));
}

/// From what is live after an instruction to what is live before it.
fn transfer(inst: &mut Inst, live: &mut [u64]) {
    match inst {
        Inst::Zero { out, len } => {
            for register in out.0..out.0 + *len {
                remove(live, register);
            }
        }
        // They write some lanes only.
        Inst::Store { from, .. } => insert(live, from.0),
        Inst::StoreAt { base, len, index, from } => {
            // Registers of an array stay live where they are.
            (base.0..base.0 + *len).chain([index.0, from.0]).for_each(|reg| insert(live, reg));
        }
        Inst::LoadAt { out, base, len, index } => {
            remove(live, out.0);
            (base.0..base.0 + *len).chain([index.0]).for_each(|reg| insert(live, reg));
        }
        inst => {
            inst.operands(&mut |register, role| {
                if role == Role::Write {
                    remove(live, register.0);
                }
            });
            inst.operands(&mut |register, role| {
                if role == Role::Read {
                    insert(live, register.0);
                }
            });
        }
    }
}
