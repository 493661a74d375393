//! Real registers for virtual ones.
//!
//! A register file is: splats, inputs, variables, temporaries. The first three keep their
//! place for the whole run; temporaries share theirs, the most recently freed first, so that the
//! working set stays small. A temporary lives from the instruction that writes it to the last that
//! reads it; if that stands in a loop which the write does not, to the end of the loop.

use super::inst::{Inst, Reg, Role, Target};
use super::lower::{Lowered, RegisterContent};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The layout of a register file.
#[derive(Debug, Default)]
pub(super) struct Layout {
    /// By register from 0: which word of the preamble it repeats.
    pub splats: Vec<u32>,
    /// The first input.
    pub inputs: u32,
    /// The first register that the program writes.
    pub first_written: u32,
    /// By output of the program.
    pub outputs: Vec<u32>,
    /// How many registers there are.
    pub registers: u32,
}

/// Replaces the virtual registers of `lowered.code` by real ones.
pub(super) fn allocate(lowered: &mut Lowered) -> Layout {
    let mut allocation = Allocation::new(lowered);
    allocation.compute_live_ranges(lowered);
    allocation.forward_stores(lowered);
    allocation.borrow_variables(lowered);
    let layout = allocation.assign_registers(lowered);
    zero_variables(lowered, &allocation);
    layout
}

/// The live range of a virtual register.
#[derive(Clone, Copy, Debug, Default)]
struct LiveRange {
    start: u32,
    end: u32,
    reads: u32,
}

/// A use of a variable.
#[derive(Clone, Copy, Debug)]
struct Access {
    at: u32,
    role: Role,
}

struct Allocation {
    /// By virtual register; of temporaries only.
    live_ranges: Vec<Option<LiveRange>>,
    /// By variable, in the order of the code.
    accesses: Vec<Vec<Access>>,
    /// By virtual register: the register that replaces it.
    replacement: Vec<Reg>,
    /// By instruction.
    removed: Vec<bool>,
    /// By instruction: whether it writes a variable in all lanes, always. What a jump skips
    /// does not.
    moves: Vec<bool>,
    /// By virtual register.
    real: Vec<Reg>,
}

impl Allocation {
    fn new(lowered: &Lowered) -> Self {
        let variables = lowered.contents.iter().map(|content| match content {
            RegisterContent::Variable { var } => var.0 as usize + 1,
            RegisterContent::Temp
            | RegisterContent::Splat { .. }
            | RegisterContent::Input { .. } => 0,
        });
        let count = lowered.contents.len();
        Self {
            accesses: vec![Vec::new(); variables.max().unwrap_or(0)],
            live_ranges: vec![None; count],
            replacement: (0..count as u32).map(Reg).collect(),
            removed: vec![false; lowered.code.len()],
            moves: moves(&lowered.code),
            real: Vec::new(),
        }
    }

    /// Finds the live range of each temporary and the accesses of each variable.
    fn compute_live_ranges(&mut self, lowered: &mut Lowered) {
        let contents = &lowered.contents;
        let ends = loop_ends(&lowered.code);
        // First and last instruction of the open loops, outermost first.
        let mut open: Vec<(u32, u32)> = Vec::new();
        for (at, inst) in lowered.code.iter_mut().enumerate() {
            let at = at as u32;
            while open.last().is_some_and(|&(_, end)| end < at) {
                open.pop();
            }
            open.extend(ends[at as usize].iter().rev().map(|&end| (at, end)));
            inst.operands(&mut |reg, role| match contents[reg.0 as usize] {
                RegisterContent::Variable { var } => {
                    self.accesses[var.0 as usize].push(Access { at, role })
                }
                RegisterContent::Temp => {
                    let span = self.live_ranges[reg.0 as usize].get_or_insert(LiveRange {
                        start: at,
                        end: at,
                        reads: 0,
                    });
                    if role == Role::Read {
                        span.reads += 1;
                        // The outermost loop that was entered after the value was written.
                        let first = open.partition_point(|&(head, _)| head <= span.start);
                        let end = open.get(first).map_or(at, |&(_, end)| end);
                        span.end = span.end.max(end);
                    }
                }
                RegisterContent::Splat { .. } | RegisterContent::Input { .. } => {}
            });
        }
    }

    fn is_accessed(
        &self,
        content: RegisterContent,
        after: u32,
        until: u32,
        roles: &[Role],
    ) -> bool {
        let RegisterContent::Variable { var } = content else { return true };
        let accesses = &self.accesses[var.0 as usize];
        let first = accesses.partition_point(|access| access.at <= after);
        accesses[first..]
            .iter()
            .take_while(|access| access.at < until)
            .any(|access| roles.contains(&access.role))
    }

    /// A value whose only use is to be stored in all lanes is computed into the variable, unless a
    /// jump between the two skips the store.
    fn forward_stores(&mut self, lowered: &Lowered) {
        let is_uniform_jump = |inst: &Inst| matches!(inst, Inst::Unless { .. } | Inst::Jump { .. });
        let guards = guards(&lowered.code, is_uniform_jump);
        for (at, inst) in lowered.code.iter().enumerate() {
            let Inst::Move { out, from } = inst else { continue };
            let Some(span) = self.live_ranges[from.0 as usize] else { continue };
            let content = lowered.contents[out.0 as usize];
            let copied = matches!(lowered.code[span.start as usize], Inst::Move { .. });
            if !copied
                && span.reads == 1
                && guards[at].is_none_or(|guard| guard < span.start)
                && span.end == at as u32
                && !self.is_accessed(content, span.start, at as u32, &[Role::Read, Role::Write])
            {
                self.replacement[from.0 as usize] = *out;
                self.live_ranges[from.0 as usize] = None;
                self.removed[at] = true;
                self.moves[span.start as usize] = self.moves[at];
                self.write_earlier(content, at as u32, span.start);
            }
        }
    }

    /// Nothing touches the variable between the two instructions, so its accesses stay in order.
    fn write_earlier(&mut self, content: RegisterContent, from: u32, to: u32) {
        let RegisterContent::Variable { var } = content else { return };
        let accesses = &mut self.accesses[var.0 as usize];
        let at = accesses.partition_point(|access| access.at < from);
        accesses[at].at = to;
    }

    /// A load needs no copy when its variable is not written while the value lives.
    fn borrow_variables(&mut self, lowered: &Lowered) {
        for (at, inst) in lowered.code.iter().enumerate() {
            let Inst::Move { out, from } = inst else { continue };
            let Some(span) = self.live_ranges[out.0 as usize] else { continue };
            if !self.is_accessed(
                lowered.contents[from.0 as usize],
                at as u32,
                span.end,
                &[Role::Write],
            ) {
                self.replacement[out.0 as usize] = *from;
                self.live_ranges[out.0 as usize] = None;
                self.removed[at] = true;
            }
        }
    }

    /// Assigns a real register to every virtual one, and writes them into the code.
    fn assign_registers(&mut self, lowered: &mut Lowered) -> Layout {
        let mut layout = Layout::default();
        self.real = vec![Reg(u32::MAX); lowered.contents.len()];
        let used = self.used(lowered);
        for (virt, content) in lowered.contents.iter().enumerate() {
            if let RegisterContent::Splat { word } = content
                && used[virt]
            {
                self.real[virt] = Reg(layout.splats.len() as u32);
                layout.splats.push(*word);
            }
        }
        layout.inputs = layout.splats.len() as u32;
        layout.first_written = layout.inputs + lowered.inputs.len() as u32;
        let mut next = layout.first_written;
        for (virt, content) in lowered.contents.iter().enumerate() {
            match content {
                RegisterContent::Input { index } => self.real[virt] = Reg(layout.inputs + index),
                RegisterContent::Variable { .. } => {
                    self.real[virt] = Reg(next);
                    next += 1;
                }
                RegisterContent::Temp | RegisterContent::Splat { .. } => {}
            }
        }
        let mut free = BinaryHeap::new();
        let mut live: BinaryHeap<Reverse<(u32, u32)>> = BinaryHeap::new();
        for (at, inst) in lowered.code.iter_mut().enumerate() {
            if self.removed[at] {
                continue;
            }
            let at = at as u32;
            if let Inst::Sample(sample) = inst {
                for out in &mut sample.out {
                    *out = out.filter(|reg| {
                        self.replacement[reg.0 as usize] != *reg
                            || self.live_ranges[reg.0 as usize].is_some_and(|span| span.reads > 0)
                    });
                }
            }
            inst.operands(&mut |reg, role| {
                let virt = self.replacement[reg.0 as usize].0 as usize;
                if role == Role::Write
                    && let Some(span) = self.live_ranges[virt]
                    && self.real[virt].0 == u32::MAX
                {
                    // Every instruction reads before it writes.
                    while let Some(&Reverse((end, register))) = live.peek()
                        && end <= at
                    {
                        live.pop();
                        free.push(Reverse(register));
                    }
                    let register = free.pop().map_or_else(
                        || {
                            next += 1;
                            next - 1
                        },
                        |Reverse(register)| register,
                    );
                    // A value that is never read still needs a register for one instruction.
                    live.push(Reverse((span.end.max(at + u32::from(span.reads == 0)), register)));
                    self.real[virt] = Reg(register);
                }
                *reg = self.real[virt];
            });
        }
        layout.registers = next;
        layout.outputs =
            lowered.outputs.iter().map(|(_, reg)| self.real[reg.0 as usize].0).collect();
        compact(lowered, &self.removed);
        layout
    }

    /// By virtual register: whether the code still names it.
    fn used(&self, lowered: &mut Lowered) -> Vec<bool> {
        let mut used = vec![false; lowered.contents.len()];
        for (inst, removed) in lowered.code.iter_mut().zip(&self.removed) {
            if !removed {
                inst.operands(&mut |reg, _| {
                    used[self.replacement[reg.0 as usize].0 as usize] = true;
                });
            }
        }
        used
    }
}

/// By instruction: whether it is a move that is always made.
fn moves(code: &[Inst]) -> Vec<bool> {
    let guards = guards(code, |_| true);
    let moves = code.iter().zip(guards);
    moves.map(|(inst, guard)| matches!(inst, Inst::Move { .. }) && guard.is_none()).collect()
}

/// By instruction: the last relevant jump before it that skips it.
fn guards(code: &[Inst], counts: impl Fn(&Inst) -> bool) -> Vec<Option<u32>> {
    let mut open: Vec<(u32, u32)> = Vec::new();
    let mut guards = Vec::with_capacity(code.len());
    for (at, inst) in code.iter().enumerate() {
        let at = at as u32;
        while open.last().is_some_and(|&(_, to)| to <= at) {
            open.pop();
        }
        guards.push(open.last().map(|&(jump, _)| jump));
        if let Some(Target(to)) = inst.target()
            && to > at
            && counts(inst)
        {
            open.push((at, to));
        }
    }
    guards
}

/// By instruction: the last instructions of the loops that begin there, innermost first.
fn loop_ends(code: &[Inst]) -> Vec<Vec<u32>> {
    let mut ends = vec![Vec::new(); code.len()];
    for (at, inst) in code.iter().enumerate() {
        if let Inst::EndIteration { head, .. } | Inst::Repeat { head } = inst {
            ends[head.0 as usize].push(at as u32);
        }
    }
    ends
}

/// Drops the removed instructions.
pub(super) fn compact(lowered: &mut Lowered, removed: &[bool]) {
    let mut moved = Vec::with_capacity(removed.len() + 1);
    let mut next = 0;
    for removed in removed {
        moved.push(next);
        next += u32::from(!removed);
    }
    moved.push(next);
    retain(&mut lowered.code, removed);
    retain(&mut lowered.source_order, removed);
    for inst in &mut lowered.code {
        if let Some(Target(to)) = inst.target_mut() {
            *to = moved[*to as usize];
        }
    }
}

fn retain<T>(list: &mut Vec<T>, removed: &[bool]) {
    let mut removed = removed.iter();
    list.retain(|_| removed.next() == Some(&false));
}

/// Variables start as zero, unless all lanes are written before anything else happens to them.
fn zero_variables(lowered: &mut Lowered, allocation: &Allocation) {
    let mut zeros = Vec::new();
    for &(first, len) in &lowered.variables {
        let RegisterContent::Variable { var } = lowered.contents[first.0 as usize] else {
            continue;
        };
        let first_access = allocation.accesses[var.0 as usize].first();
        let written = len == 1
            && first_access.is_some_and(|access| {
                access.role == Role::Write && allocation.moves[access.at as usize]
            });
        if !written {
            zeros.push(Inst::Zero { out: allocation.real[first.0 as usize], len });
        }
    }
    let shift = zeros.len() as u32;
    for inst in &mut lowered.code {
        if let Some(Target(to)) = inst.target_mut() {
            *to += shift;
        }
    }
    lowered.source_order.splice(0..0, zeros.iter().map(|_| 0));
    lowered.code.splice(0..0, zeros);
}
