//! The order of instructions: list scheduling that moves dependent instructions away from each other.
//!
//! A step over 64 lanes is a few vector operations, each of which waits for the one before it. A
//! processor fills that time with the next step only if this does not wait for the same. So in each
//! straight run of code the next instruction is the one whose operands are there first, among the few
//! that follow ([`WINDOW`]: what is computed earlier than it is needed takes a register meanwhile, and of more than
//! sixteen some alias in the store buffer, see `compute.rs`).

use super::inst::{Inst, Reg, Role, jump_targets};
use super::lower::{Lowered, RegisterContent};
use crate::ir::Op;
use std::ops::Range;

/// How far ahead of the first instruction that is left one is chosen.
const WINDOW: usize = 16;

/// Orders the code, which is over virtual registers, each temporary written once.
pub(super) fn run(lowered: &mut Lowered) {
    let mut registers = Registers::new(lowered);
    for run in straight_runs(&lowered.code) {
        let code = &mut lowered.code[run.clone()];
        let order = Order::new(code, &mut registers).list_schedule(code);
        let mut moved: Vec<Option<(Inst, u32)>> = lowered
            .code
            .drain(run.clone())
            .zip(lowered.source_order.drain(run.clone()))
            .map(Some)
            .collect();
        let (code, source_order): (Vec<Inst>, Vec<u32>) =
            order.into_iter().filter_map(|at| moved[at].take()).unzip();
        lowered.code.splice(run.start..run.start, code);
        lowered.source_order.splice(run.start..run.start, source_order);
    }
}

/// The straight runs of code whose instructions may be reordered.
fn straight_runs(code: &[Inst]) -> Vec<Range<usize>> {
    let is_target = jump_targets(code);
    let mut runs = Vec::new();
    let mut start = 0;
    for (at, inst) in code.iter().enumerate() {
        let is_fixed = busy_and_latency(inst).is_none();
        if is_target[at] || is_fixed {
            runs.push(start..at);
            start = at + usize::from(is_fixed);
        }
    }
    runs.push(start..code.len());
    runs.retain(|run| run.len() > 2);
    runs
}

/// How long an instruction keeps a processor busy, and how long its result takes, in cycles or so; `None` if it
/// may not be reordered.
fn busy_and_latency(inst: &Inst) -> Option<[u32; 2]> {
    let of = |cost: u32, depth: u32| Some([4 + 2 * cost, 12 + 2 * cost + 4 * depth]);
    match inst {
        Inst::Compute { what, .. } => {
            let [cost, depth] = what.size();
            of(cost, depth)
        }
        Inst::Derivative { .. } => of(Op::Sub.cost(), 1),
        Inst::Tabulated { table, .. } => of(table.cost(), 1),
        Inst::Sample(_) => of(200, 0),
        // Most of these are never made.
        Inst::Move { .. } | Inst::Store { .. } => Some([0, 0]),
        // Arrays are accessed in order.
        Inst::Zero { .. }
        | Inst::LoadAt { .. }
        | Inst::StoreAt { .. }
        | Inst::UniformAt { .. }
        | Inst::Unless { .. }
        | Inst::Jump { .. }
        | Inst::Repeat { .. }
        | Inst::If { .. }
        | Inst::Else { .. }
        | Inst::Join { .. }
        | Inst::Open { .. }
        | Inst::Leave { .. }
        | Inst::LeaveIf { .. }
        | Inst::Discard
        | Inst::EmitVertex(_)
        | Inst::EndPrimitive
        | Inst::SkipEmpty { .. }
        | Inst::EndIteration { .. } => None,
    }
}

/// What is known of the virtual registers.
struct Registers {
    contents: Vec<RegisterContent>,
    /// How often each is read.
    reads: Vec<u32>,
    /// The number of the present run.
    run: u32,
    accesses: Vec<Accesses>,
}

/// The accesses of a register in a run so far.
#[derive(Clone, Default)]
struct Accesses {
    run: u32,
    writer: Option<usize>,
    /// Since then.
    readers: Vec<usize>,
    /// The variable of which this is a copy.
    copy_of: Option<Reg>,
}

impl Registers {
    fn new(lowered: &mut Lowered) -> Self {
        let mut reads = vec![0; lowered.contents.len()];
        for inst in &mut lowered.code {
            inst.operands(&mut |reg, role| reads[reg.0 as usize] += u32::from(role == Role::Read));
        }
        let accesses = vec![Accesses::default(); reads.len()];
        Self { contents: lowered.contents.clone(), reads, run: 0, accesses }
    }

    fn of(&mut self, reg: Reg) -> &mut Accesses {
        let accesses = &mut self.accesses[reg.0 as usize];
        if accesses.run != self.run {
            accesses.run = self.run;
            (accesses.writer, accesses.copy_of) = (None, None);
            accesses.readers.clear();
        }
        accesses
    }

    /// Records an access; returns the instructions that must precede it.
    fn access(&mut self, at: usize, reg: Reg, role: Role, before: &mut Vec<usize>) {
        let accesses = self.of(reg);
        before.extend(accesses.writer);
        match role {
            Role::Read => {
                accesses.readers.push(at);
                // A copy is not made if its variable is not written while it is read.
                if let Some(variable) = accesses.copy_of {
                    self.of(variable).readers.push(at);
                }
            }
            Role::Write => {
                before.append(&mut accesses.readers);
                accesses.writer = Some(at);
            }
        }
    }

    fn holds(&self, reg: Reg, predicate: fn(RegisterContent) -> bool) -> bool {
        predicate(self.contents[reg.0 as usize])
    }
}

/// The dependency graph of a straight run.
struct Order {
    /// By instruction: how many predecessors are not scheduled.
    predecessors: Vec<u32>,
    /// By instruction: those that depend on it.
    successors: Vec<Vec<usize>>,
    /// By instruction: the move of its value into a variable. They stay together: then the value is
    /// computed there at once.
    moves: Vec<Option<usize>>,
}

impl Order {
    fn new(code: &mut [Inst], registers: &mut Registers) -> Self {
        registers.run += 1;
        let count = code.len();
        let mut order = Self {
            predecessors: vec![0; count],
            successors: vec![Vec::new(); count],
            moves: vec![None; count],
        };
        let mut before = Vec::new();
        for (at, inst) in code.iter_mut().enumerate() {
            inst.operands(&mut |reg, role| registers.access(at, *reg, role, &mut before));
            before.sort_unstable();
            before.dedup();
            before.retain(|&earlier| earlier != at);
            if let Inst::Move { out, from } = *inst {
                let is_variable = |content| matches!(content, RegisterContent::Variable { .. });
                if registers.holds(from, is_variable) {
                    registers.of(out).copy_of = Some(from);
                } else if registers.holds(out, is_variable)
                    && registers.reads[from.0 as usize] == 1
                    && let Some(writer) = registers.of(from).writer
                    && before.iter().all(|&earlier| earlier <= writer)
                {
                    order.moves[writer] = Some(at);
                    before.iter().for_each(|&earlier| order.add_dependency(earlier, writer));
                }
            }
            before.drain(..).for_each(|earlier| order.add_dependency(earlier, at));
        }
        order
    }

    fn add_dependency(&mut self, earlier: usize, later: usize) {
        if earlier != later {
            self.successors[earlier].push(later);
            self.predecessors[later] += 1;
        }
    }

    /// The instructions in scheduled order.
    fn list_schedule(mut self, code: &[Inst]) -> Vec<usize> {
        let count = code.len();
        let mut order = Vec::with_capacity(count);
        let mut is_chosen = vec![false; count];
        // The cycle at which the operands are available.
        let mut ready = vec![0_u32; count];
        let (mut now, mut first) = (0_u32, 0);
        while first < count {
            let next_few = first..count.min(first + WINDOW);
            let free = next_few.filter(|&at| !is_chosen[at] && self.predecessors[at] == 0);
            // The first instruction that is left has no predecessor left.
            let next = free.min_by_key(|&at| (ready[at].max(now), at)).unwrap_or(first);
            let mut chosen = Some(next);
            while let Some(at) = chosen {
                let [busy, latency] = busy_and_latency(&code[at]).unwrap_or_default();
                let start = now.max(ready[at]);
                now = start + busy;
                for successor in std::mem::take(&mut self.successors[at]) {
                    self.predecessors[successor] -= 1;
                    ready[successor] = ready[successor].max(start + latency);
                }
                is_chosen[at] = true;
                order.push(at);
                chosen = self.moves[at];
            }
            while first < count && is_chosen[first] {
                first += 1;
            }
        }
        order
    }
}

#[cfg(test)]
mod tests {
    use crate::ir::{Builder, Input, Interpolation, Op, Output, Stage};
    use crate::shader::{Invocation, Machine, Program, Tracer};
    use crate::trace::{Expression, Name, Step};
    use texunit::lanes::{Isa, U32s};

    /// Two chains of square roots, of red and of green.
    fn two_chains() -> Program {
        let mut b = Builder::new(Stage::Fragment);
        b.module_mut().varyings = vec![Interpolation::Smooth; 2];
        for component in 0..2 {
            let mut value = b.input(Input::Varying(u16::from(component)));
            for _ in 0..6 {
                value = b.op(Op::Sqrt, &[value]);
            }
            let out = b.output(Output::Color { target: 0, component });
            b.store(out, value);
        }
        Program::new(&b.finish(), |_| true)
    }

    #[test]
    fn two_chains_alternate() {
        let program = two_chains();
        assert_eq!(program.code.len(), 12, "{:?}", program.code);
        let chains: Vec<bool> = program.source_order.iter().map(|position| *position > 6).collect();
        assert!(
            chains[..10].windows(2).all(|pair| pair[0] != pair[1]),
            "{:?}",
            program.source_order
        );
    }

    #[test]
    fn a_trace_has_them_in_source_order() {
        let program = two_chains();
        let isa = Isa::best();
        let prepared = program.prepare(isa, &[], &[]);
        let mut machine = Machine::default();
        machine.begin(&program);
        for index in 0..2 {
            *machine.input_mut(index) = U32s::splat((256.0 + index as f32).to_bits());
        }
        let mut tracer = Tracer::new(&program, 3);
        let (active, budget) = (!0, 100);
        let invocation = Invocation {
            isa,
            program: &program,
            prepared: &prepared,
            textures: &[],
            active,
            budget,
        };
        assert_eq!(machine.run_traced(invocation, &mut tracer), Ok(!0));
        let of = |step: &Step| match step {
            Step::Value { number, expression: Expression::Apply(Op::Sqrt, args), bits, .. } => {
                let [Expression::Operand(operand)] = args[..] else { panic!("{args:?}") };
                (*number, operand.name, f32::from_bits(*bits))
            }
            other => panic!("{other:?}"),
        };
        let mut value = 0.0_f32;
        for (at, step) in tracer.steps.iter().enumerate() {
            let (number, name, bits) = of(step);
            assert_eq!(number as usize, at + 1);
            let chain = at / 6;
            if at % 6 == 0 {
                assert_eq!(name, Name::Input(program.inputs()[chain]));
                value = 256.0 + chain as f32;
            } else {
                assert_eq!(name, Name::Step(at as u32));
            }
            value = value.sqrt();
            assert_eq!(bits, value);
        }
        assert_eq!(tracer.steps.len(), 12);
        assert_eq!(tracer.output(&machine, 1).name, Name::Step(12));
    }
}
