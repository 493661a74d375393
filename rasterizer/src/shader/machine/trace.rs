//! A run that is recorded for one lane: the same instructions over the same registers, one at a
//! time.

use super::Machine;
use super::interpreter::{Interpreter, repeat_loop};
use super::lookup::lod;
use crate::ir::{Access, FunctionTable, Ty};
use crate::shader::inst::{Inst, Reg, SampleInst};
use crate::shader::invocation::Invocation;
use crate::shader::{OverBudget, Program};
use crate::trace::{Expression, Lookup, MAX_STEPS, Name, Operand, Step};
use texunit::sample::Points;
use texunit::trace::SampleTrace;

/// The steps of a lane, and the origin of the values in its registers.
pub struct Tracer {
    lane: usize,
    /// By register.
    names: Vec<Name>,
    /// In the order of the source.
    pub steps: Vec<Step>,
    /// How many were not recorded.
    pub more: usize,
    next: u32,
    /// Those of the present straight run of code, with their positions in the source, in the order of execution.
    run: Vec<(u32, Step)>,
}

impl Tracer {
    /// The state before the first instruction of `program`.
    pub fn new(program: &Program, lane: usize) -> Self {
        let mut names = vec![Name::Draw; program.layout.registers as usize];
        for (index, input) in program.inputs.iter().enumerate() {
            if let Some(name) = names.get_mut(program.layout.inputs as usize + index) {
                *name = Name::Input(*input);
            }
        }
        Self { lane, names, steps: Vec::new(), more: 0, next: 1, run: Vec::new() }
    }

    fn operand(&self, machine: &Machine, reg: Reg, ty: Ty) -> Operand {
        let (name, bits) = (self.names[reg.0 as usize], machine.reg(reg)[self.lane]);
        Operand { name, ty, bits }
    }

    /// Ends a straight run: sorts its steps by their positions in the source, and numbers them so.
    fn finish_straight_run(&mut self) {
        self.run.sort_by_key(|(position, _)| *position);
        let numbers: Vec<u32> = self.run.iter().filter_map(|(_, step)| step.number()).collect();
        let first = self.next - numbers.len() as u32;
        // By number from `first` on.
        let mut new = vec![0; numbers.len()];
        for (number, old) in (first..).zip(numbers) {
            new[(old - first) as usize] = number;
        }
        let renumbered = |old: u32| match old.checked_sub(first) {
            Some(at) => new[at as usize],
            None => old,
        };
        let renamed = |name: Name| match name {
            Name::Draw | Name::Input(_) => name,
            Name::Texel(number, component) => Name::Texel(renumbered(number), component),
            Name::Step(number) => Name::Step(renumbered(number)),
        };
        let mut next = first;
        for (_, mut step) in self.run.drain(..) {
            step.rename(&mut next, &renamed);
            if self.steps.len() < MAX_STEPS {
                self.steps.push(step);
            } else {
                self.more += 1;
            }
        }
        self.names.iter_mut().for_each(|name| *name = renamed(*name));
    }

    /// The number of the next step.
    fn number(&mut self) -> u32 {
        self.next += 1;
        self.next - 1
    }

    /// The word of an output.
    pub fn output(&self, machine: &Machine, index: usize) -> Operand {
        self.operand(machine, Reg(machine.outputs[index]), Ty::F32)
    }
}

/// What is known of an instruction before it runs.
enum OperandsBefore {
    /// It computes a value.
    Value { out: Reg, ty: Ty, expression: Expression },
    /// It samples.
    Sample { coords: [Operand; 3], texture: String, trace: Option<SampleTrace> },
    /// It moves a value.
    Copy { out: Reg, name: Name },
    /// It writes zeros.
    Zero { out: Reg, len: u32 },
    /// It is a jump.
    Control,
}

impl Machine {
    /// [`Machine::run`], which records what it does in the lane of the tracer.
    ///
    /// # Errors
    /// When the budget is used up.
    pub fn run_traced(
        &mut self,
        invocation: Invocation<'_>,
        tracer: &mut Tracer,
    ) -> Result<u64, OverBudget> {
        let mut left = self.start(&invocation)?;
        let code = &invocation.program.code[..];
        let mut pc = 0;
        while let Some(inst) = code.get(pc) {
            if inst.is_control() {
                tracer.finish_straight_run();
            }
            let position = invocation.program.source_order[pc];
            let executes = !invocation.program.masked
                || !self.exec.is_empty() && self.exec.lanes[tracer.lane] != 0;
            let before = if executes {
                self.read_operands(&invocation, inst, tracer)
            } else {
                OperandsBefore::Control
            };
            pc = match *inst {
                Inst::EndIteration { head, exit } => {
                    self.end_iteration(head, exit, pc + 1, (invocation.prepared, &mut left))?
                }
                Inst::Repeat { head } => repeat_loop(head, pc + 1, invocation.prepared, &mut left)?,
                Inst::Compute { .. }
                | Inst::Move { .. }
                | Inst::Zero { .. }
                | Inst::Store { .. }
                | Inst::LoadAt { .. }
                | Inst::StoreAt { .. }
                | Inst::UniformAt { .. }
                | Inst::Derivative { .. }
                | Inst::Tabulated { .. }
                | Inst::Sample(_)
                | Inst::Unless { .. }
                | Inst::Jump { .. }
                | Inst::If { .. }
                | Inst::Else { .. }
                | Inst::Join { .. }
                | Inst::Open { .. }
                | Inst::Leave { .. }
                | Inst::LeaveIf { .. }
                | Inst::Discard
                | Inst::EmitVertex(_)
                | Inst::EndPrimitive
                | Inst::SkipEmpty { .. } => {
                    let code = &code[..=pc];
                    invocation.isa.run(Interpreter {
                        machine: self,
                        invocation: &invocation,
                        code,
                        native: None,
                        files: 1,
                        pc,
                        left,
                    })?
                }
            };
            if executes {
                self.record(inst, position, before, tracer);
            }
        }
        tracer.finish_straight_run();
        self.left = left;
        Ok(invocation.active & !self.discarded.bits())
    }

    fn read_operands(
        &self,
        invocation: &Invocation<'_>,
        inst: &Inst,
        tracer: &Tracer,
    ) -> OperandsBefore {
        let operand = |reg: Reg, ty: Ty| Expression::Operand(tracer.operand(self, reg, ty));
        let name = |reg: Reg| tracer.names[reg.0 as usize];
        match inst {
            Inst::Compute { what, out, args } => {
                let expression = what.expression(&|at, ty| operand(args[at], ty));
                OperandsBefore::Value { out: *out, ty: what.result(), expression }
            }
            Inst::Derivative { axis, out, from } => {
                let expression =
                    Expression::Derivative(*axis, tracer.operand(self, *from, Ty::F32));
                OperandsBefore::Value { out: *out, ty: Ty::F32, expression }
            }
            Inst::Tabulated { out, from, table } => {
                let from = tracer.operand(self, *from, Ty::F32);
                let expression = match table {
                    FunctionTable::OfByte(_) => Expression::OfByte(from),
                    FunctionTable::Power(power) => Expression::Power(from, power.exponent()),
                };
                OperandsBefore::Value { out: *out, ty: Ty::F32, expression }
            }
            Inst::Move { out, from } | Inst::Store { out, from } => {
                OperandsBefore::Copy { out: *out, name: name(*from) }
            }
            Inst::LoadAt { out, base, len, index } => {
                let at = self.reg(*index)[tracer.lane].min(len - 1);
                OperandsBefore::Copy { out: *out, name: name(Reg(base.0 + at)) }
            }
            Inst::StoreAt { base, len, index, from } => {
                let at = self.reg(*index)[tracer.lane].min(len - 1);
                OperandsBefore::Copy { out: Reg(base.0 + at), name: name(*from) }
            }
            Inst::UniformAt { out, .. } => OperandsBefore::Copy { out: *out, name: Name::Draw },
            Inst::Zero { out, len } => OperandsBefore::Zero { out: *out, len: *len },
            Inst::Sample(sample) => self.read_sample_operands(invocation, sample, tracer),
            Inst::Unless { .. }
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
            | Inst::EndIteration { .. } => OperandsBefore::Control,
        }
    }

    fn read_sample_operands(
        &self,
        invocation: &Invocation<'_>,
        sample: &SampleInst,
        tracer: &Tracer,
    ) -> OperandsBefore {
        let plan = invocation.textures.get(sample.texture as usize).and_then(Option::as_ref);
        let coords = sample.coords.map(|reg| self.reg(reg).as_f32());
        let [layer, reference] =
            [sample.layer, sample.reference].map(|reg| reg.map(|reg| self.reg(reg).as_f32()));
        let points = Points { coords, layer, reference };
        let lod = lod(&self.registers, sample);
        let trace = match sample.access {
            Access::Filter { offset } => plan
                .filter(|plan| plan.incomplete().is_none())
                .map(|plan| plan.trace(tracer.lane, points, offset, lod)),
            Access::Gather { .. } | Access::Fetch { .. } | Access::Size | Access::Lod => None,
        };
        let ty = match sample.access {
            Access::Filter { .. } | Access::Gather { .. } | Access::Lod => Ty::F32,
            Access::Fetch { .. } | Access::Size => Ty::I32,
        };
        let texture = plan.map_or_else(|| "no texture".into(), |plan| plan.describe());
        let coords = sample.coords.map(|reg| tracer.operand(self, reg, ty));
        OperandsBefore::Sample { coords, texture, trace }
    }

    fn record(&self, inst: &Inst, position: u32, before: OperandsBefore, tracer: &mut Tracer) {
        match (before, inst) {
            (OperandsBefore::Value { out, ty, expression }, _) => {
                let (number, bits) = (tracer.number(), self.reg(out)[tracer.lane]);
                tracer.names[out.0 as usize] = Name::Step(number);
                tracer.run.push((position, Step::Value { number, expression, ty, bits }));
            }
            (OperandsBefore::Copy { out, name }, _) => tracer.names[out.0 as usize] = name,
            (OperandsBefore::Zero { out, len }, _) => {
                tracer.names[out.0 as usize..][..len as usize].fill(Name::Draw);
            }
            (OperandsBefore::Sample { coords, texture, trace }, Inst::Sample(sample)) => {
                let number = tracer.number();
                let word = |reg: Reg| self.reg(reg)[tracer.lane];
                let result = sample.out.map(|reg| reg.map(word));
                for (component, reg) in (0..).zip(sample.out) {
                    if let Some(reg) = reg {
                        tracer.names[reg.0 as usize] = Name::Texel(number, component);
                    }
                }
                let lookup = Lookup {
                    number,
                    slot: sample.texture,
                    access: sample.access,
                    texture,
                    coords,
                    trace,
                    result,
                };
                tracer.run.push((position, Step::Lookup(Box::new(lookup))));
            }
            (OperandsBefore::Control, Inst::Discard) => tracer.run.push((position, Step::Discard)),
            (OperandsBefore::Sample { .. } | OperandsBefore::Control, _) => {}
        }
    }
}

impl Step {
    fn number(&self) -> Option<u32> {
        match self {
            Self::Value { number, .. } => Some(*number),
            Self::Lookup(lookup) => Some(lookup.number),
            Self::Discard => None,
        }
    }

    /// Gives it the next number, and what it reads its new names.
    fn rename(&mut self, next: &mut u32, renamed: &impl Fn(Name) -> Name) {
        let number = match self {
            Self::Value { number, expression, .. } => {
                expression.rename(renamed);
                number
            }
            Self::Lookup(lookup) => {
                for coord in &mut lookup.coords {
                    coord.name = renamed(coord.name);
                }
                &mut lookup.number
            }
            Self::Discard => return,
        };
        *number = *next;
        *next += 1;
    }
}

impl Expression {
    fn rename(&mut self, renamed: &impl Fn(Name) -> Name) {
        match self {
            Self::Operand(operand)
            | Self::Derivative(_, operand)
            | Self::OfByte(operand)
            | Self::Power(operand, _) => {
                operand.name = renamed(operand.name);
            }
            Self::Apply(_, args) => args.iter_mut().for_each(|arg| arg.rename(renamed)),
        }
    }
}
